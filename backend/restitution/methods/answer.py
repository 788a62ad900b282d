"""What every method takes and gives."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from restitution.errors import ParameterError
from restitution.mechanics.hertz import FloatArray


@dataclass(frozen=True)
class Options:
    """What a caller may say about the way to get ε_t.

    Attributes
    ----------
    method : str
        ``auto`` or the name of a method.
    tolerance : float
        Largest absolute error wanted in ε_t.
    damping : float
        η = (3/2) A β^{2/5} g_n^{1/5} of all the collisions, 0 … `viscoelastic.MOST_DAMPING`.
    share : float
        Of the budget of a request, what these collisions may use; less than 1 beside others.
    floor : float
        ε₀ of the pragmatic model.
    steps : int
        Steps per contact of ``timestep``.
    integrator : str
        Of ``timestep``, one of `mechanics.stepping.INTEGRATORS`.
    phase : float
        Where in a step of ``timestep`` the contact begins, 0 … 1.
    rtol : float
        Relative tolerance of ``ode``.
    """

    method: str = "auto"
    tolerance: float = 1e-10
    damping: float = 0.0
    share: float = 1.0
    floor: float = 0.0
    steps: int = 50
    integrator: str = "velocity_verlet"
    phase: float = 0.0
    rtol: float = 1e-9


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
