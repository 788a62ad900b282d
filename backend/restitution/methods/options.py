"""What a caller may say about the way to ε_t: methods, their options, and the bounds of both."""

from dataclasses import field, replace
from typing import Annotated, Literal

from annotated_types import Ge, Le

from restitution.bounds import Meaning, TypeAliasType, closed
from restitution.errors import ParameterError
from restitution.mechanics.contact import LEAST_RESTITUTION, MOST_DAMPING
from restitution.quantities import QUANTITIES

# with a name of its own in documents: generators of clients make a class of it
OneMethod = Literal["exact", "coulomb", "pragmatic", "stiff", "table", "timestep", "ode"]
"""Methods that answer by themselves; `planner.METHODS` has their functions."""

Method = TypeAliasType("Method", Literal["auto", OneMethod])
Integrator = Literal["velocity_verlet", "symplectic_euler", "forward_euler"]
Damping = Annotated[float, Ge(0), Le(MOST_DAMPING), QUANTITIES["damping"]]
NormalRestitution = Annotated[float, Ge(LEAST_RESTITUTION), Le(1), QUANTITIES["normal_restitution"]]

Tolerance = Annotated[float, Ge(1e-13), Le(1), Meaning("largest absolute error wanted in ε_t")]


WantedError = Annotated[float, Ge(1e-12), Le(1), Meaning("largest error wanted")]


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
        Steps per contact of ``timestep``, how it takes them, and where in a step the contact
        begins.
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


UNDAMPED = {
    "stiff": "the stiff limit is proven without damping only",
    "table": "the table holds collisions without damping",
}
"""Methods that are made for η = 0, and why."""


def refuse_damping(method: str, damping: float) -> None:
    """Raise `ParameterError` if one of `UNDAMPED` is asked for another η."""
    if method in UNDAMPED and damping > 0.0:
        requirement = f"another one for damping = {damping:g}: {UNDAMPED[method]}"
        raise ParameterError("method", method, requirement)
