"""Collisions of real spheres in SI units, integrated as the paper's Eqs. 1, 10 and 11 stand.

For the tests alone, from the paper and nothing of the package: DOP853 on compression, spring and
velocity in metres and seconds; changes of regime and the end of contact are located as events.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

RTOL = 1e-13
LOOKS = 30
"""Steps for a radian of the spring's swing, at whose ends the events look for a change of sign.

Where the spring only just reaches the cap, both changes may fall between two looks: with 3 of them
that is seen as 1.4e-5 in ε_t once in a thousand."""

PAST_DOUBLE_ZERO = 2e-5
"""Share of the contact for which sticking is followed without looking for its end.

The gap to the cap has a double zero where sticking begins: a look right after it finds rounding.
Sticking that begins in the last such share changes the velocity by 1e-11 of friction's impulse."""


def laws(bodies):
    """Return m_eff, α and the factor K of F = K ξ^{3/2} of two spheres."""
    mass = 1 / sum(1 / body["mass"] for body in bodies)
    radius = 1 / sum(1 / body["radius"] for body in bodies)
    lever = sum(mass * body["radius"] ** 2 / body["moment"] for body in bodies)
    compliance = sum((1 - body["poisson"] ** 2) / body["young"] for body in bodies)
    return mass, 1 / (1 + lever), 4 / 3 * math.sqrt(radius) / compliance


def integrate(  # noqa: C901 - two regimes, three events, one system
    mass, alpha, hertz, friction, stiffness, g_n, g_t
):
    """Return ε_t and the number of changes of regime; everything in SI units."""
    # of the order of the largest compression, of the contact's duration
    depth = (1.25 * mass * g_n**2 / hertz) ** 0.4
    duration = 3.3 * depth / g_n
    swing = math.sqrt(alpha * mass / stiffness)

    def compress(y):
        return y[1], -hertz * max(y[0], 0.0) ** 1.5 / mass

    def cap(y):
        return friction * hertz * max(y[0], 0.0) ** 1.5 / stiffness

    def cap_rate(y):
        return 1.5 * friction * hertz * math.sqrt(max(y[0], 0.0)) * y[1] / stiffness

    def sliding(_, y):
        return [*compress(y), side * cap_rate(y), -side * stiffness * cap(y) / (alpha * mass)]

    def sticking(_, y):
        return [*compress(y), y[3], -stiffness * y[2] / (alpha * mass)]

    def parted(_, y):
        return y[0]

    def stops(_, y):
        return side * y[3] - cap_rate(y)

    def slips(_, y):
        return cap(y) - abs(y[2])

    for event in (parted, stops, slips):
        event.terminal, event.direction = True, -1.0
    tolerances = RTOL * np.array([depth, g_n, cap([depth]) + 1e-3 * g_t * duration, g_t])
    side, time, slides, switches = 1.0, 0.0, True, 0
    state = np.array([0.0, g_n, 0.0, g_t])
    while True:
        solution = solve_ivp(
            sliding if slides else sticking,
            (time, time + 2 * duration),
            state,
            method="DOP853",
            events=[parted, stops if slides else slips],
            rtol=RTOL,
            atol=tolerances,
            max_step=min(duration / 40, swing / LOOKS),
        )
        assert solution.status == 1, "a contact ends"
        time, state = solution.t[-1], solution.y[:, -1].copy()
        late = PAST_DOUBLE_ZERO * duration
        if solution.t_events[0].size or 0.0 < -state[0] / state[1] < 2 * late:
            return float(state[3] / g_t), switches
        slides, switches = not slides, switches + 1
        if slides:
            side = math.copysign(1.0, state[2])
        else:
            past = solve_ivp(
                sticking, (time, time + late), state, method="DOP853", rtol=RTOL, atol=tolerances
            )
            time, state = past.t[-1], past.y[:, -1]
