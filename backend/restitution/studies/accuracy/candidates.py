"""Every way to get ε_t with every setting that it has, for comparison."""

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.stepping import INTEGRATORS, step_collisions
from restitution.methods import coulomb, ode, planner
from restitution.methods.options import UNDAMPED, Options

if TYPE_CHECKING:
    from restitution.methods.answer import Answer

COLLISIONS = 16_000
"""Of a scene, where a method takes microseconds: a map's, for which `auto` reads the table."""

SLOW_COLLISIONS = 40
"""Of a scene, where a method takes milliseconds."""

TIMED_ALONE = 400
"""Collisions that are stepped through one by one, to time them as codes with many contacts do."""

PHASES = 8
"""Instants within a step at which contacts begin, in equal shares."""

STEPS = (20, 50, 100, 200, 500, 1000, 5000, 20_000)
TOLERANCES = (1e-1, 4e-3, 1e-3, 1e-6, 1e-10)
RTOL = (1e-3, 1e-6, 1e-9, 1e-12)

Knobs = dict[str, Any]
Counts = npt.NDArray[np.int32] | None
Outcome = tuple[FloatArray, Counts]
Run = Callable[[FloatArray, FloatArray, float], Outcome]
"""From κ and ψ (N,) and one η."""


@dataclass(frozen=True)
class Candidate:
    """A method with its knobs, bare: without the measurement of its own error.

    Attributes
    ----------
    method, options : str, dict
        Names as in the API.
    run : callable
        From κ, ψ (N,) and η to ε_t and switches.
    timed : callable, optional
        What is timed, if not `run`.
    collisions, timed_collisions : int
        How many of a scene it takes, and of how many the time is taken.
    slow : bool
        True if each collision is one request, run and timed once.
    """

    method: str
    options: Knobs
    run: Run
    timed: Run | None = None
    collisions: int = COLLISIONS
    timed_collisions: int = COLLISIONS
    slow: bool = False


def candidates(*, damped: bool = False) -> list[Candidate]:
    """Return every method with every knob; methods that the planner learns join by themselves.

    Those of `UNDAMPED` stay away where collisions are `damped`.
    """
    left_out = UNDAMPED.keys() if damped else ()
    knobs: dict[str, list[Knobs]] = {name: [{}] for name in planner.METHODS if name not in left_out}
    knobs["pragmatic"] = [{"floor": -1.0}]
    found = [_planned(tolerance) for tolerance in TOLERANCES]
    for method, settings in knobs.items():
        if method == "timestep":
            found += [_stepping(i, n) for i, n in itertools.product(INTEGRATORS, STEPS)]
        elif method == "ode":
            found += [_solver(r, "events") for r in RTOL]
            found += [_solver(r, s) for s in ("held", "free") for r in RTOL[:2]]
        else:
            found += [
                Candidate(method, options, _bare(Options(**{"method": method, **options})))
                for options in settings
            ]
    return found


def _planned(tolerance: float) -> Candidate:
    """Return `auto`, asked for nothing but ε_t; what it counts on the way is no promise."""
    options = Options(tolerance=tolerance)

    def run(kappa: FloatArray, psi: FloatArray, damping: float) -> Outcome:
        asked = replace(options, damping=damping)
        return planner.solve(kappa, psi, ("epsilon_t",), asked).epsilon_t, None

    return Candidate("auto", {"tolerance": tolerance}, run)


def _bare(options: Options) -> Run:
    """Return a method by its name, those of Coulomb without the exact one for their error."""
    if options.method in {"coulomb", "pragmatic"}:
        return lambda _, psi, damping: (coulomb.law(psi, replace(options, damping=damping)), None)

    def run(kappa: FloatArray, psi: FloatArray, damping: float) -> Outcome:
        asked = replace(options, damping=damping)
        answer: Answer = planner.METHODS[options.method](kappa, psi, asked)
        return answer.epsilon_t, answer.switches

    return run


def _stepping(integrator: str, steps: int) -> Candidate:
    """Return time steps, from contacts that begin at several instants within a step."""

    def run(kappa: FloatArray, psi: FloatArray, damping: float) -> Outcome:
        epsilon_t, switches = np.empty(kappa.size), np.empty(kappa.size, np.int32)
        for i in range(PHASES):
            part = slice(i, None, PHASES)
            epsilon_t[part], switches[part] = step_collisions(
                kappa[part], psi[part], steps, integrator, i / PHASES, damping=damping
            )
        return epsilon_t, switches

    def alone(kappa: FloatArray, psi: FloatArray, damping: float) -> Outcome:
        stepped = step_collisions(kappa, psi, steps, integrator, 0.5, together=1, damping=damping)
        return stepped.epsilon_t, stepped.switches

    options = {"integrator": integrator, "steps": steps}
    return Candidate("timestep", options, run, alone, timed_collisions=TIMED_ALONE)


def _solver(rtol: float, spring: ode.Spring) -> Candidate:
    def run(kappa: FloatArray, psi: FloatArray, damping: float) -> Outcome:
        epsilon_t, switches = ode.run(kappa, psi, rtol, spring, damping)
        return epsilon_t, switches if spring == "events" else None

    options = {"rtol": rtol, **({} if spring == "events" else {"spring": spring})}
    return Candidate("ode", options, run, collisions=SLOW_COLLISIONS, slow=True)
