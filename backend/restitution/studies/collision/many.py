"""Many collisions at once, with the quantities asked for."""

from collections.abc import Collection
from dataclasses import dataclass, field, replace
from typing import Any, Literal, get_args

import numpy as np
import numpy.typing as npt

from restitution.bounds import chosen
from restitution.errors import ParameterError
from restitution.mechanics import limits
from restitution.mechanics.collision import TOO_STIFF
from restitution.mechanics.contact import normal_restitution
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.scaled_velocity import scaled_velocity
from restitution.methods import planner
from restitution.methods.answer import Answer
from restitution.methods.exact import follow_affordable, known
from restitution.methods.options import Options, refuse_damping
from restitution.studies.collision.dampings import by_damping, refuse_more_dampings
from restitution.studies.collision.parameters import (
    CONVENTION,
    check,
    common_shape,
    numbers_of,
)
from restitution.studies.tabular import Table, Tabular

BatchQuantity = Literal[
    "epsilon_t",
    "switches",
    "coulomb",
    "stiff_bound",
    "stiff_asymptote",
    "largest_switches",
    "error",
]
"""Of cuts and maps."""

ListedQuantity = Literal["epsilon_t", "epsilon_n", "switches"]
"""Of lists of collisions."""

QUANTITIES: tuple[BatchQuantity, ...] = get_args(BatchQuantity)
LISTED: tuple[ListedQuantity, ...] = get_args(ListedQuantity)

Column = FloatArray | npt.NDArray[np.int32]


@dataclass(frozen=True)
class BatchStudy(Tabular):
    """Many collisions in scaled units; arrays of shape (N,).

    Attributes
    ----------
    columns : dict of str to ndarray
        The quantities asked for. `switches` are integers, or floats with NaN where the method
        that answered cannot count them.
    method : ndarray of str
        Method that answered.
    error_bound : ndarray of float
        Bound on the absolute error of ε_t.
    tolerance_met : ndarray of bool
        Whether that is within the tolerance.
    given : dict of str to ndarray, shape () or (N,)
        The parameters: `kappa`, `mu_over_alpha`, `gt_over_gn`, `damping`.

    Examples
    --------
    >>> found = study_batch([18, 63], 1.4, 5.6)
    >>> found.columns["epsilon_t"], found.one_method
    (array([0.5, 0.5]), 'exact')
    >>> list(found.to_pandas())[:5]
    ['kappa', 'mu_over_alpha', 'gt_over_gn', 'damping', 'epsilon_t']
    """

    columns: dict[str, Column]
    method: npt.NDArray[np.str_]
    error_bound: FloatArray
    tolerance_met: npt.NDArray[np.bool_]
    given: dict[str, FloatArray] = field(default_factory=dict)

    @property
    def one_method(self) -> str:
        """Name of the method, or ``mixed``."""
        names = np.unique(self.method)
        return str(names[0]) if names.size == 1 else "mixed"

    def table(self) -> Table:
        """Return the collisions in their order."""
        return Table(
            {"collision": np.arange(self.method.size)},
            self.found(self.method.shape),
            {n: np.broadcast_to(values, self.method.shape) for n, values in self.given.items()},
            {"convention": CONVENTION},
        )

    def found(self, shape: tuple[int, ...]) -> dict[str, npt.NDArray[Any]]:
        """Return everything that was found, as arrays of `shape`."""
        answered = ("method", "error_bound", "tolerance_met")
        return {
            **{name: column.reshape(shape) for name, column in self.columns.items()},
            **{name: getattr(self, name).reshape(shape) for name in answered},
        }

    def held(self, *names: str) -> dict[str, npt.NDArray[Any]]:
        """Return parameters that are the same in all collisions, each as one number."""
        return {name: self.given[name].ravel()[0] for name in names}


def study_batch(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    options: Options | None = None,
    damping: npt.ArrayLike | None = None,
) -> BatchStudy:
    """Return `quantities` of collisions whose parameters are broadcast to (N,).

    η is `damping`, if given, else that of `options`; both are broadcast as the others are.

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If a method asked for by name would cost too much, or for too many different η.
    """
    options = options or Options()
    quantities = chosen("quantities", quantities, tuple(dict.fromkeys((*QUANTITIES, *LISTED))))
    told = options.damping if damping is None else damping
    given = numbers_of(kappa, mu_over_alpha, gt_over_gn, told)
    kappas, frictions, tangentials, etas = given.values()
    check(kappas, frictions, tangentials, etas)
    if len(common_shape(given)) > 1:
        name = max(given, key=lambda each: given[each].ndim)
        raise ParameterError(name, given[name].shape, "of shape () or (N,)")
    kappas, psis, many = np.broadcast_arrays(
        np.atleast_1d(kappas), scaled_velocity(frictions, tangentials), etas
    )
    # copies, for numba warns of arrays that were broadcast
    kappas, psis = np.array(kappas, order="C"), np.array(psis, order="C")
    if etas.size <= 1:
        found = _study(kappas, psis, quantities, replace(options, damping=float(etas.sum())))
        return replace(found, given=given)
    # before those of η = 0 are answered
    refuse_damping(options.method, float(etas.max()))
    groups = by_damping(many)
    refuse_more_dampings(len(groups))
    studies = [
        _study(
            kappas[part],
            psis[part],
            quantities,
            # each its part of the budget, so that all together stay within it
            options.beside_others(eta, part.size / kappas.size),
        )
        for eta, part in groups
    ]
    found = _joined(studies, np.argsort(np.concatenate([part for _, part in groups])))
    return replace(found, given=given)


def _joined(studies: list[BatchStudy], places: npt.NDArray[np.intp]) -> BatchStudy:
    """Return several studies as one, whose k-th collision is number `places[k]` of them all."""

    def join(arrays: list[Any]) -> Any:
        return np.concatenate(arrays)[places]

    return BatchStudy(
        {name: join([study.columns[name] for study in studies]) for name in studies[0].columns},
        join([study.method for study in studies]),
        join([study.error_bound for study in studies]),
        join([study.tolerance_met for study in studies]),
    )


def _study(
    kappas: FloatArray, psis: FloatArray, quantities: Collection[str], options: Options
) -> BatchStudy:
    """Return the study of collisions (N,) of one η."""
    answer = planner.solve(kappas, psis, quantities, options)
    return BatchStudy(
        {
            name: _column(name, kappas, psis, answer, options)
            for name in dict.fromkeys((*QUANTITIES, *LISTED))
            if name in quantities
        },
        answer.method,
        answer.error_bound,
        answer.error_bound <= options.tolerance,
    )


def _column(
    name: str, kappa: FloatArray, psi: FloatArray, answer: Answer, options: Options
) -> Column:
    damping, share = options.damping, options.share
    match name:
        case "epsilon_t":
            return answer.epsilon_t
        case "epsilon_n":
            return np.full(kappa.shape, normal_restitution(damping))
        case "switches":
            return counted_switches(answer)
        case "error":
            exact = answer.exact
            if exact is None:
                exact = known(follow_affordable(kappa, psi, damping, share))
            return answer.epsilon_t - exact
    return _law(name, kappa, psi, damping)


@np.errstate(divide="ignore", over="ignore")
def _law(name: str, kappa: FloatArray, psi: FloatArray, damping: float) -> FloatArray:
    """Return one of the simple laws; those of the stiff limit are made for η = 0."""
    if name == "coulomb":
        return limits.coulomb_restitution(psi, normal_restitution(damping))
    if damping:
        return np.full(kappa.shape, np.nan)
    if name == "largest_switches":
        return limits.largest_switch_count(kappa)
    law = limits.stiff_bound if name == "stiff_bound" else limits.stiff_asymptote
    return law(kappa, psi)


def counted_switches(answer: Answer) -> Column:
    """Return the switches; as floats with NaN where the method could not count them."""
    if answer.switches is None:
        return np.full(answer.epsilon_t.shape, np.nan)
    if np.any(answer.switches == TOO_STIFF):
        return np.where(answer.switches == TOO_STIFF, np.nan, answer.switches)
    return answer.switches
