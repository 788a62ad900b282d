"""Many collisions at once, with the quantities asked for."""

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from restitution.mechanics import limits
from restitution.mechanics.collision import TOO_STIFF
from restitution.mechanics.hertz import FloatArray
from restitution.methods import planner
from restitution.methods.answer import Answer, Options
from restitution.methods.exact import follow_affordable, known
from restitution.studies.parameters import check, scaled_velocity

QUANTITIES = ("epsilon_t", "switches", "coulomb", "stiff_bound", "stiff_asymptote", "error")

Column = FloatArray | npt.NDArray[np.int32]


@dataclass(frozen=True)
class BatchStudy:
    """Many collisions; arrays of shape (N,).

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
    """

    columns: dict[str, Column]
    method: npt.NDArray[np.str_]
    error_bound: FloatArray
    tolerance_met: npt.NDArray[np.bool_]

    @property
    def one_method(self) -> str:
        """Name of the method, or ``mixed``."""
        names = np.unique(self.method)
        return str(names[0]) if names.size == 1 else "mixed"


def study_batch(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    options: Options | None = None,
) -> BatchStudy:
    """Return `quantities` of collisions whose parameters are broadcast to (N,).

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If a method asked for by name would cost too much.
    """
    options = options or Options()
    check(kappa, mu_over_alpha, gt_over_gn)
    kappas, psis = np.broadcast_arrays(
        np.atleast_1d(np.asarray(kappa, dtype=np.float64)),
        scaled_velocity(mu_over_alpha, gt_over_gn),
    )
    # copies, for numba warns of arrays that were broadcast
    kappas, psis = np.array(kappas, order="C"), np.array(psis, order="C")
    answer = planner.solve(kappas, psis, quantities, options)
    return BatchStudy(
        {name: _column(name, kappas, psis, answer) for name in QUANTITIES if name in quantities},
        answer.method,
        answer.error_bound,
        answer.error_bound <= options.tolerance,
    )


def _column(name: str, kappa: FloatArray, psi: FloatArray, answer: Answer) -> Column:
    with np.errstate(divide="ignore", over="ignore"):
        match name:
            case "epsilon_t":
                return answer.epsilon_t
            case "switches":
                return counted_switches(answer)
            case "coulomb":
                return limits.coulomb_restitution(psi)
            case "stiff_bound":
                return limits.stiff_bound(kappa, psi)
            case "stiff_asymptote":
                return limits.stiff_asymptote(kappa, psi)
            case _:
                exact = answer.exact
                if exact is None:
                    exact = known(follow_affordable(kappa, psi))
                return answer.epsilon_t - exact


def counted_switches(answer: Answer) -> Column:
    """Return the switches; as floats with NaN where the method could not count them."""
    if answer.switches is None:
        return np.full(answer.epsilon_t.shape, np.nan)
    if np.any(answer.switches == TOO_STIFF):
        return np.where(answer.switches == TOO_STIFF, np.nan, answer.switches)
    return answer.switches
