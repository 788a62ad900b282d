"""What every method takes and gives."""

from dataclasses import dataclass, field, replace
from typing import Annotated, Literal

import numpy as np
import numpy.typing as npt
from annotated_types import Ge, Le
from typing_extensions import TypeAliasType

from restitution.bounds import Meaning, closed
from restitution.errors import ParameterError
from restitution.mechanics.contact import MOST_DAMPING
from restitution.mechanics.hertz import FloatArray
from restitution.quantities import QUANTITIES

# with a name of its own in documents: generators of clients make a class of it
Method = TypeAliasType(
    "Method",
    Literal["auto", "exact", "coulomb", "pragmatic", "stiff", "table", "timestep", "ode"],
)
AnsweringMethod = TypeAliasType(
    "AnsweringMethod",
    Literal["exact", "coulomb", "pragmatic", "stiff", "table", "timestep", "ode"],
)
Integrator = Literal["velocity_verlet", "symplectic_euler", "forward_euler"]
Damping = Annotated[float, Ge(0), Le(MOST_DAMPING), QUANTITIES["damping"]]

EpsilonT = Annotated[
    float, Meaning("ε_t, from -1 to 1 unless `timestep` is unstable with so few steps")
]
ErrorBound = Annotated[float, Ge(0), QUANTITIES["error_bound"]]
ToleranceMet = Annotated[bool, QUANTITIES["tolerance_met"]]
Tolerance = Annotated[float, Ge(1e-13), Le(1), Meaning("largest absolute error wanted in ε_t")]


@closed
class Options:
    """What a caller may say about the way to get ε_t.

    Attributes
    ----------
    damping : float
        η of all the collisions; of lists of collisions and of maps alike.
    tolerance : float
        Largest absolute error wanted in ε_t.
    method : str
        ``auto`` or the name of a method.
    steps, integrator, phase : int, str, float
        Steps per contact of ``timestep``, how it takes them (`mechanics.stepping`), and where in
        a step the contact begins.
    rtol : float
        Relative tolerance of ``ode``.
    floor : float
        ε₀ of ``pragmatic``.

    Raises
    ------
    ParameterError
        If one of them is out of range.

    Examples
    --------
    >>> Options(method="timestep", steps=100).integrator
    'velocity_verlet'
    """

    damping: Damping = 0.0
    tolerance: Tolerance = 1e-10
    method: Method = "auto"
    steps: Annotated[int, Ge(4), Le(1_000_000), Meaning("steps per contact of `timestep`")] = 50
    integrator: Integrator = "velocity_verlet"
    phase: Annotated[
        float, Ge(0), Le(1), Meaning("where in a step of `timestep` the contact begins")
    ] = 0.0
    rtol: Annotated[float, Ge(1e-13), Le(0.1), Meaning("relative tolerance of `ode`")] = 1e-9
    floor: Annotated[float, Ge(-1), Le(1), Meaning("ε₀ of `pragmatic`")] = 0.0
    share: float = field(default=1.0, init=False, repr=False)
    """Of the budget of a request, what these collisions may use; less than 1 beside others."""

    def beside_others(self, damping: float, share: float) -> "Options":
        """Return the options of collisions of one damping among others."""
        theirs = replace(self, damping=damping)
        object.__setattr__(theirs, "share", share)
        return theirs


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


def refuse_damping(options: Options, reason: str) -> None:
    """Raise `ParameterError` if a method that is made for η = 0 is asked for another one."""
    if options.damping > 0.0:
        requirement = f"another one for damping = {options.damping:g}: {reason}"
        raise ParameterError("method", options.method, requirement)
