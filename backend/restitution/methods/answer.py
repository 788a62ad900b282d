"""What every method gives."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
import numpy.typing as npt
from annotated_types import Ge

from restitution.bounds import Meaning, TypeAliasType
from restitution.mechanics.hertz import FloatArray
from restitution.methods.options import OneMethod
from restitution.quantities import QUANTITIES

AnsweringMethod = TypeAliasType("AnsweringMethod", OneMethod)

EpsilonT = Annotated[
    float, Meaning("ε_t, from -1 to 1 unless `timestep` is unstable with so few steps")
]
ErrorBound = Annotated[float, Ge(0), QUANTITIES["error_bound"]]
ToleranceMet = Annotated[bool, QUANTITIES["tolerance_met"]]


@dataclass(frozen=True)
class Answer:
    """ε_t of many collisions; arrays of shape (N,).

    Attributes
    ----------
    epsilon_t : ndarray of float
        Coefficient of tangential restitution.
    error_bound : ndarray of float
        Bound on its absolute error; the method says whether proven or measured.
    method : ndarray of str
        Names of the methods that gave it.
    switches : ndarray of int, or None
        Changes of regime; −1 where the method that answered cannot count them.
    switches_certain : ndarray of bool, or None
        False where rounding decides about a switch.
    exact : ndarray of float, or None
        The exact ε_t where it was computed on the way, NaN where it cannot be.
    """

    epsilon_t: FloatArray
    error_bound: FloatArray
    method: npt.NDArray[np.str_]
    switches: npt.NDArray[np.int32] | None = None
    switches_certain: npt.NDArray[np.bool_] | None = None
    exact: FloatArray | None = None
