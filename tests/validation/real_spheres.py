"""Collisions of real spheres in SI units, integrated as the paper's Eqs. 1, 10 and 11 stand.

For the tests alone, from the paper and nothing of the package: DOP853 on compression, spring and
velocity in metres and seconds; changes of regime and the end of contact are located as events.

The independent variable is not the time t but τ with dt = 2√ξ dτ, in √m s/m: with damping the
force begins as √t, at which a solver in time loses digits; in τ everything is a polynomial.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

RTOL = 1e-13
LOOKS = 30
"""Steps for a radian of the spring's swing, at whose ends the events look for a change of sign.

Where the spring only just reaches the cap, both changes may fall between two looks: with 3 of them
that is seen as 1.4e-5 in ε_t once in a thousand."""

PAST_DOUBLE_ZERO = 2e-5, 0.01
"""Shares of the contact, and of what is left of it, for which sticking is followed without looking
for its end: whichever is shorter.

The gap to the cap has a double zero where sticking begins: a look right after it finds rounding."""

OVER = 1e-9
"""Share of the contact that is not followed any more: it changes velocities by its square."""


def laws(bodies):
    """Return m_eff, α and the factor K of F = K ξ^{3/2} of two spheres."""
    mass = 1 / sum(1 / body["mass"] for body in bodies)
    radius = 1 / sum(1 / body["radius"] for body in bodies)
    lever = sum(mass * body["radius"] ** 2 / body["moment"] for body in bodies)
    compliance = sum((1 - body["poisson"] ** 2) / body["young"] for body in bodies)
    return mass, 1 / (1 + lever), 4 / 3 * math.sqrt(radius) / compliance


def integrate(  # noqa: C901 - two regimes, three events, one system
    mass, alpha, hertz, friction, stiffness, g_n, g_t, dissipation=0.0
):
    """Return ε_t, ε_n and the number of changes of regime; everything in SI units.

    `dissipation` is A of Eq. 1 in seconds. The contact ends when the normal force does, so that
    the max(0, …) of that equation is never needed, and without it the last step stays smooth.
    """
    # of the order of the largest compression, of the contact in τ
    depth = (1.25 * mass * g_n**2 / hertz) ** 0.4
    span = 2.4 * math.sqrt(depth) / g_n
    swing = math.sqrt(alpha * mass / stiffness) / (2 * math.sqrt(depth))
    inertia = alpha * mass

    def force_over_root(y):
        # of K (ξ^{3/2} + (3/2) A √ξ ξ̇), with √ξ and ξ̇ in the first two places
        return hertz * (y[0] ** 2 + 1.5 * dissipation * y[1])

    def compress(y):
        return y[1], -2 * y[0] ** 2 * force_over_root(y) / mass

    def cap(y):
        return friction * y[0] * force_over_root(y) / stiffness

    def cap_rate(y):
        rate, slowing = compress(y)
        damped = 1.5 * dissipation * (rate * y[1] + y[0] * slowing)
        return friction * hertz / stiffness * (3 * y[0] ** 2 * rate + damped)

    def sliding(_, y):
        return [*compress(y), side * cap_rate(y), -2 * y[0] * side * stiffness * cap(y) / inertia]

    def sticking(_, y):
        return [*compress(y), 2 * y[0] * y[3], -2 * y[0] * stiffness * y[2] / inertia]

    def parted(_, y):
        # in decompression the force is zero at ξ = (3/2) A |ξ̇|
        return y[0] - math.sqrt(1.5 * dissipation * max(0.0, -y[1]))

    def stops(_, y):
        # divided by √ξ, which is zero at the end of contact without damping
        return side * 2 * y[3] - (cap_rate(y) / y[0] if y[0] else 0.0)

    def slips(_, y):
        # divided by √ξ, which is zero at the beginning of a contact with damping; a step may end
        # after the contact, where there is no cap
        normal = max(0.0, force_over_root(y)) if y[0] >= 0.0 else 0.0
        return friction * normal / stiffness - (abs(y[2] / y[0]) if y[0] else 0.0)

    for event in (parted, stops, slips):
        event.terminal, event.direction = True, -1.0
    elongation = friction * hertz * depth**1.5 / stiffness + 1e-3 * g_t * depth / g_n
    tolerances = RTOL * np.array([math.sqrt(depth), g_n, elongation, g_t])
    # with damping the force begins steeper than the spring's
    side, place, slides, switches = 1.0, 0.0, dissipation == 0.0, 0
    state = np.array([0.0, g_n, 0.0, g_t])
    while True:
        solution = solve_ivp(
            sliding if slides else sticking,
            (place, place + 9 * span),
            state,
            method="DOP853",
            events=[parted, stops if slides else slips],
            rtol=RTOL,
            atol=tolerances,
            max_step=min(span / 40, swing / LOOKS),
        )
        assert solution.status == 1, "a contact ends"
        place, state = solution.t[-1], solution.y[:, -1].copy()
        # negative in compression
        left = -parted(place, state) / state[1]
        if solution.t_events[0].size or 0.0 < left < OVER * span:
            return float(state[3] / g_t), float(-state[1] / g_n), switches
        slides, switches = not slides, switches + 1
        if slides:
            side = math.copysign(1.0, state[2])
        else:
            late = min(PAST_DOUBLE_ZERO[0] * span, PAST_DOUBLE_ZERO[1] * abs(left))
            past = solve_ivp(
                sticking, (place, place + late), state, method="DOP853", rtol=RTOL, atol=tolerances
            )
            place, state = past.t[-1], past.y[:, -1]
