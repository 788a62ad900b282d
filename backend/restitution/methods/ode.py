"""A general solver of differential equations: scipy's DOP853, collision by collision.

Beside the velocity w = u/u(0) it follows the force of the spring y = κz/u(0), so that the cap is
c x^{3/2} with c = 1/ψ and no parameter leaves the double range.
"""

import math
from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.errors import CostError
from restitution.interruption import pause
from restitution.mechanics.collision import expected_switch_counts
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.scaled_velocity import WEAKEST
from restitution.methods.answer import Answer
from restitution.methods.measured import measured
from restitution.methods.options import Options

MOST_STEPS = 60_000
"""Expected steps of one request: two seconds of one core."""

MOST_STEPS_EACH = 10_000
"""Expected steps of one collision: a third of a second."""

STEPS_TO_EVALUATIONS = 60
"""Evaluations of the equations per expected step, after which the solver is stopped. A step takes
twelve; the largest number seen is 7 per expected step."""

LONGEST_STEP = 0.2
"""Of the solver, scaled by t_scale."""

RESOLUTION = 1e-14
"""Compression at which a contact is over: less than the rounding of a time times its rate."""

UNCOUNTED = -1
"""Stands for the number of switches where none are located."""

Spring = Literal["events", "held", "free"]
"""What becomes of the spring at the cap. ``events``: each switch is located, and the solver begins
anew there. Without events, for comparison: ``held`` at the cap by a case in the equations, across
whose kinks the solver has to find its way; or ``free``, ż = u throughout as Eq. 23 is printed: the
force is capped, the spring is not, and the answer is another one."""

State = list[float] | FloatArray


class Integrated(NamedTuple):
    """Result of `integrate`."""

    epsilon_t: float
    """Coefficient of tangential restitution."""
    switches: int
    """Changes of regime that were located; −1 without events."""
    evaluations: int
    """How often the equations were evaluated."""


class _Contact:
    """The equations of one contact, and how often they were evaluated; states x, ẋ, y, w."""

    def __init__(
        self, kappa: float, psi: float, rtol: float, most_evaluations: float, damping: float
    ) -> None:
        self.kappa = kappa
        self.damping = damping
        self.noise = max(1e-3 * rtol, 1e-14)
        self.friction = 1.0 / max(psi, WEAKEST)
        self.most_evaluations = most_evaluations
        self.evaluations = 0
        self.side = 1.0
        self.begin = 0.0

    def cap(self, state: State) -> float:
        """Return the largest force of the spring."""
        return float(self.friction * self.normal_force(state))

    def normal_force(self, state: State) -> float:
        """Return the normal force, which does not attract."""
        x = max(state[0], 0.0)
        return float(max(0.0, x**1.5 + self.damping * math.sqrt(x) * state[1]))

    def cap_rate(self, state: State) -> float:
        """Return the rate of the cap."""
        x, rate = max(state[0], 0.0), state[1]
        undamped = 1.5 * math.sqrt(x) * rate
        if not self.damping or x == 0.0:
            return self.friction * undamped
        grown = 0.5 * rate * rate / math.sqrt(x) - math.sqrt(x) * self.normal_force(state)
        return float(self.friction * (undamped + self.damping * grown))

    def _motion(self, state: State, spring_rate: float, force: float) -> State:
        self.evaluations += 1
        if self.evaluations > self.most_evaluations:
            raise CostError(
                f"the general solver was stopped after {self.evaluations - 1:,} evaluations, the "
                f"limit for kappa = {self.kappa:g}; ask for a larger rtol, or for method=exact"
            )
        return [state[1], -self.normal_force(state), spring_rate, -force]

    def sliding(self, _: float, state: State) -> State:
        """Return the rates while the spring is at the cap; its own is left for the end."""
        return self._motion(state, 0.0, self.side * self.cap(state))

    def sticking(self, _: float, state: State) -> State:
        """Return the rates while the spring is below the cap."""
        return self._motion(state, self.kappa * state[3], state[2])

    def held(self, _: float, state: State) -> State:
        """Return the rates in either regime, as the state has it."""
        cap, rate = self.cap(state), self.cap_rate(state)
        side = math.copysign(1.0, state[2])
        if abs(state[2]) >= cap and side * self.kappa * state[3] >= rate:
            return self._motion(state, side * rate, side * cap)
        return self._motion(state, self.kappa * state[3], min(max(state[2], -cap), cap))

    def free(self, _: float, state: State) -> State:
        """Return the rates of Eq. 23 as printed."""
        cap = self.cap(state)
        return self._motion(state, self.kappa * state[3], min(max(state[2], -cap), cap))

    def change(self, time: float, state: FloatArray, *, slides: bool) -> tuple[bool, bool]:
        """Return whether it slides after an event, and whether that is a switch; mend `state`."""
        if not slides:
            self.side = math.copysign(1.0, state[2])
            # by rounding the spring can reach a cap that falls less fast than it does
            if self.stops(time, state) > 0.0:
                return True, True
        state[2] = self.side * self.cap(state)
        self.begin = time
        return False, slides

    def stops(self, _: float, state: State) -> float:
        """Return what falls through 0 where sliding ends."""
        return self.side * self.kappa * state[3] - self.cap_rate(state)

    def slips(self, time: float, state: State) -> float:
        """Return what falls through 0 where sticking ends."""
        # the gap has a double zero where sticking begins, and noise right after it
        elapsed = time - self.begin
        gap = (1.0 + self.noise) * self.cap(state) - abs(state[2])
        return gap / elapsed**2 if elapsed > 0.0 else 1.0

    def leaves(self, _: float, state: State) -> float:
        """Return what falls through 0 at the end of the contact."""
        return state[0] + self.damping * state[1]


def _terminal(event: Callable[[float, State], float]) -> Callable[[float, State], float]:
    """Return `event` as one at which solve_ivp stops if it falls through 0."""

    def found(time: float, state: State) -> float:
        return event(time, state)

    found.terminal, found.direction = True, -1.0  # type: ignore[attr-defined] # scipy's way
    return found


def integrate(
    kappa: float,
    psi: float,
    rtol: float,
    spring: Spring = "events",
    most_evaluations: float = math.inf,
    damping: float = 0.0,
) -> Integrated:
    """Return ε_t of one collision by DOP853 to a relative tolerance for each step.

    Parameters
    ----------
    kappa, psi : float
        Positive and finite; 0 … ∞.
    rtol : float
        Relative tolerance; the absolute one is a thousandth of it, in the scale of each quantity.
    spring : {"events", "held", "free"}, optional
        What becomes of the spring at the cap, see `Spring`.
    most_evaluations : float, optional
        Of the equations.
    damping : float, optional
        η; the contact then begins sticking.

    Raises
    ------
    CostError
        After `most_evaluations`, or where the solver finds no step that is small enough.
    """
    from scipy.integrate import solve_ivp  # noqa: PLC0415 - a third of a second at each start

    pause()
    contact = _Contact(kappa, psi, rtol, most_evaluations, damping)
    duration = contact_duration(damping)
    leave = _terminal(contact.leaves)
    longest = min(LONGEST_STEP, 0.5 / math.sqrt(kappa))
    state: FloatArray = np.array([0.0, 1.0, 0.0, 1.0])
    time, slides, switches = 0.0, not damping, 0
    while True:
        if spring == "events":
            equations = contact.sliding if slides else contact.sticking
            events = [leave, _terminal(contact.stops if slides else contact.slips)]
        else:
            equations, events = getattr(contact, spring), [leave]
        with np.errstate(all="ignore"):
            solution = solve_ivp(
                equations,
                # a little longer than a contact, which ends where the overlap does
                (time, 1.01 * duration),
                state,
                method="DOP853",
                events=events,
                rtol=rtol,
                atol=1e-3 * rtol * np.array([1.0, 1.0, math.sqrt(kappa), 1.0]),
                # a longer one might step over an event and its opposite
                max_step=LONGEST_STEP if equations == contact.sliding else longest,
            )
        if solution.status < 0:
            raise CostError(f"the general solver stopped: {solution.message.lower()}")
        time, state = float(solution.t[-1]), solution.y[:, -1]
        over = state[1] < 0.0 and contact.leaves(time, state) <= RESOLUTION
        if spring != "events" or solution.status == 0 or solution.t_events[0].size or over:
            break
        slides, switched = contact.change(time, state, slides=slides)
        switches += switched
    count = switches + (switches + (damping > 0.0)) % 2 if spring == "events" else UNCOUNTED
    return Integrated(float(state[3]), count, contact.evaluations)


def expected_steps(
    kappa: FloatArray, psi: FloatArray, rtol: float, damping: float = 0.0
) -> FloatArray:
    """Return about how many steps the solver takes for collisions (N,), rather too many."""
    swings = 2.0 * contact_duration(damping) * np.sqrt(kappa)
    # the order of the method is 8
    finer = max(1.0, 1e-9 / rtol) ** 0.125
    expected: FloatArray = finer * (
        40.0 + 8.0 * expected_switch_counts(kappa, psi, damping) + swings
    )
    return expected


def run(
    kappa: FloatArray,
    psi: FloatArray,
    rtol: float,
    spring: Spring = "events",
    damping: float = 0.0,
    share: float = 1.0,
) -> tuple[FloatArray, npt.NDArray[np.int32]]:
    """Return ε_t and switches of collisions (N,) by `integrate`, within the budget of a request.

    Raises
    ------
    CostError
        If the collisions are too many or too stiff, or the solver does not get on.
    """
    steps = expected_steps(kappa, psi, rtol, damping)
    if steps.sum() > MOST_STEPS * share or steps.max(initial=0.0) > MOST_STEPS_EACH:
        raise CostError(
            f"the general solver would take about {steps.sum():.3g} steps here, up to "
            f"{steps.max():.3g} in one collision; the limits are {MOST_STEPS * share:,.0f} and "
            f"{MOST_STEPS_EACH:,}. Ask for fewer or softer collisions, or for method=exact"
        )
    results = [
        integrate(k, p, rtol, spring, STEPS_TO_EVALUATIONS * n, damping)
        for k, p, n in zip(kappa.tolist(), psi.tolist(), steps.tolist(), strict=True)
    ]
    switches = np.array([result.switches for result in results], np.int32)
    switches[(psi == 0.0) | (psi == np.inf)] = 0
    return np.array([result.epsilon_t for result in results]), switches


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t and switches of collisions (N,) by `run`, to `options.rtol` for each step.

    The error is measured: the distance to the exact ε_t and its own bound. Cost: milliseconds for
    each collision, in proportion to its switches and to √κ.
    """
    epsilon_t, switches = run(
        kappa, psi, options.rtol, damping=options.damping, share=options.share
    )
    return measured(kappa, psi, epsilon_t, options, switches)
