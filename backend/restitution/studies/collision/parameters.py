"""The three parameters of a collision, and the two that it depends on."""

import functools
import math
from collections.abc import Mapping
from typing import Annotated, Any

import numpy as np
import numpy.typing as npt
from annotated_types import Ge, Gt

from restitution.bounds import (
    Meaning,
    Words,
    annotations,
    as_float,
    checked,
    interval,
    requirement,
)
from restitution.errors import ParameterError, element, require
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.scaled_velocity import psi_of
from restitution.methods.options import Damping
from restitution.quantities import QUANTITIES

Kappa = Annotated[float, Gt(0), QUANTITIES["kappa"]]
MuOverAlpha = Annotated[float, Ge(0), QUANTITIES["mu_over_alpha"]]
SIGN_IS_NOTHING = Words("finite and ≥ 0: ε_t does not depend on the sign")
GtOverGn = Annotated[float, Ge(0), QUANTITIES["gt_over_gn"], SIGN_IS_NOTHING]

CONVENTION = (
    "epsilon_t = g_t(t_c)/g_t(0) at the contact point: +1 smooth spheres, -1 gear wheels "
    "(some authors use the opposite sign); kappa is that of Eq. 24, divided by alpha"
)

Convention = Annotated[str, Meaning("sign and point of reference of every number")]


@checked
class CollisionParameters:
    """κ of Eq. 24, μ/α, g_t/g_n at the point of contact before, and η of one collision."""

    kappa: Kappa
    mu_over_alpha: MuOverAlpha
    gt_over_gn: GtOverGn
    damping: Damping = 0.0

    @functools.cached_property
    def psi(self) -> float:
        """ψ = (α/μ)(g_t/g_n)."""
        return psi_of(self.mu_over_alpha, self.gt_over_gn)


def numbers(parameter: str, given: npt.ArrayLike, annotation: Any) -> FloatArray:
    """Return a number, or an array of them, as an array of its own.

    Raises
    ------
    ParameterError
        For the first that is no number; their bounds are not looked at.
    """
    words = requirement(annotation)
    try:
        array = np.array(given)
    except ValueError as error:
        several = "lists of several lengths"
        raise ParameterError(parameter, several, f"an array of one length, {words}") from error
    if array.dtype.kind not in "iuf":
        each = array.ravel().tolist()
        found = [as_float(value) for value in each]
        for place in (i for i, value in enumerate(found) if math.isnan(value)):
            raise ParameterError(element(parameter, array.shape, place), each[place], words)
        array = np.array(found).reshape(array.shape)
    return array.astype(np.float64, copy=False)


def numbers_of(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike,
) -> dict[str, FloatArray]:
    """Return the parameters by their names, each as an array of its own."""
    given = (kappa, mu_over_alpha, gt_over_gn, damping)
    return {
        name: numbers(name, value, annotation)
        for (name, annotation), value in zip(
            annotations(CollisionParameters).items(), given, strict=True
        )
    }


def common_shape(given: Mapping[str, npt.NDArray[Any]]) -> tuple[int, ...]:
    """Return the shape to which parameters are broadcast; `ParameterError` if there is none."""
    try:
        return np.broadcast_shapes(*(each.shape for each in given.values()))
    except ValueError as error:
        name, shape = next((name, each.shape) for name, each in given.items() if each.ndim)
        shapes = ", ".join(f"{name} {each.shape}" for name, each in given.items())
        raise ParameterError(
            name, shape, f"of a shape that goes with the others: {shapes}"
        ) from error


def check(
    kappa: float | FloatArray,
    mu_over_alpha: float | FloatArray,
    gt_over_gn: float | FloatArray,
    damping: float | FloatArray = 0.0,
) -> None:
    """Raise `ParameterError` for the first of the parameters (any shape) that is out of bounds."""
    given = (kappa, mu_over_alpha, gt_over_gn, damping)
    for (name, annotation), value in zip(
        annotations(CollisionParameters).items(), given, strict=True
    ):
        low, high = interval(annotation)
        require(name, value, (value >= low) & (value <= high), requirement(annotation))
