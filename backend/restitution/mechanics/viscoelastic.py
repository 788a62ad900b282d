"""The contact with damping: its normal motion, its events, and what bounds ε_t.

The events are those of `damped.sliding` and `damped.sticking`. Parameters are κ and ψ as in
`elastic`, the contact without damping, and η = (3/2) A β^{2/5} g_n^{1/5}.
"""

import math

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped import sliding, sticking
from restitution.mechanics.damped.motion import Viscoelastic, damped_motion
from restitution.mechanics.elastic import NO_LESS
from restitution.mechanics.hertz import Instant
from restitution.mechanics.scaled_velocity import WEAKEST
from restitution.mechanics.switching import Spring

SOFTEST = 1e-290
"""κ below which, in the units of the contact, the spring takes nothing from the velocity."""

FEW = 200.0
"""Switches that are not worth a closer estimate."""

STIFFEST = 1e100
"""κ above which, in the same units, only collisions are followed that slide but for the start."""


@compiled
def scaled_stiffness(contact: Viscoelastic, kappa: float) -> float:
    """Return κ in the units of the contact, kept clear of overflow and underflow."""
    return min(max(kappa / contact.unit / contact.unit, SOFTEST), STIFFEST)


@compiled
def expected_switches(contact: Viscoelastic, kappa: float, psi: float) -> float:
    """Return about how many switches a collision has, rather too many than too few.

    They crowd between the end of the contact and the earlier of two instants: when the cap has
    fallen to the spring's amplitude, and when the first sliding can have ended.
    """
    if psi >= contact.impulse or psi == 0.0:
        return 5.0
    omega = math.sqrt(scaled_stiffness(contact, kappa))
    most: float = 5.0 + 2.0 * omega * contact.duration / math.pi
    if most < FEW:
        return most
    fallen = sticking.cap_fall_time(contact, max(psi, WEAKEST) * omega)
    lacking = contact.impulse - psi
    low, high = 0.0, contact.falling_end
    for _ in range(30):
        middle = 0.5 * (low + high)
        if damped_motion(contact, True, middle)[2] < lacking:
            low = middle
        else:
            high = middle
    slowed = damped_motion(contact, True, high)[3]
    return 5.0 + 2.0 * omega * min(fallen, slowed) / math.pi


@compiled
def stiffest_within(contact: Viscoelastic, most_switches: float) -> float:
    """Return κ, in the units of the contact, up to which none is expected to switch more often."""
    most = max(most_switches - 5.0, 0.0) * 0.5 * math.pi / contact.duration
    return most * most


@compiled
def energy_bound(contact: Viscoelastic, kappa: float, psi: float) -> float:
    """Return min(1, P_max/(ψ√κ)) ≥ |ε_t|, for ψ < 1 + ε_n.

    Proven where the cap never curves away from the spring but at the start; 1 elsewhere.
    """
    stiffness = scaled_stiffness(contact, kappa)
    if contact.ridge >= 0.0 and stiffness < contact.ridge_value:
        return 1.0
    return max(NO_LESS, min(1.0, contact.peak / math.sqrt(stiffness) / psi))


@compiled
def rounding_bound(contact: Viscoelastic, kappa: float, psi: float) -> float:
    """Return a bound on the rounding error of ε_t, for the same reasons as without damping.

    The factor is that of `elastic.rounding_bound`, twenty times the largest error seen in
    tests/validation/damped.csv.
    """
    omega = math.sqrt(scaled_stiffness(contact, kappa))
    swing = omega * contact.duration * min(1.0, contact.peak / omega / psi)
    return 4e-15 * (1.0 + swing)


@compiled
def spring_in(contact: Viscoelastic, kappa: float, psi: float) -> Spring:
    """Return the spring of a stiffness κ as in the API in a collision of one ψ."""
    stiffness = scaled_stiffness(contact, kappa)
    begin, end = sliding.outrun(contact, stiffness)
    error = rounding_bound(contact, kappa, psi) * psi
    return Spring(stiffness, math.sqrt(stiffness), begin, end, error)


@compiled
def sticking_end(
    contact: Viscoelastic, spring: Spring, falling: bool, q: float, velocity: float
) -> tuple[bool, float, int, float, bool]:
    """Return half, q, side, velocity towards that side and certainty of the next sliding.

    Sticking began at q with the given velocity; both sides are 1 where it began.
    """
    omega = spring.omega
    if q == 0.0 and not falling:
        # docs/model.md, "Events with damping", Sticking 4: from the touch on
        falling, q, side, pull, certain = sticking.sticking_end(
            contact, spring, 0.0, 0.0, omega * velocity
        )
        return falling, q, side, pull / omega, certain and spring.stiffness > SOFTEST
    root, cap, _, time = damped_motion(contact, falling, q)
    force = root * cap
    if falling and contact.duration - time >= spring.bend_end:
        # Sticking 3: on the other side
        side, certain = -1, True
        q, pull = sticking.sticking_end_while_falling(
            contact, omega, time, force, omega * abs(velocity)
        )
    else:
        # Sticking 1 and 2, or as long as r changes its sign each stretch by itself
        start = contact.duration - time if falling else time
        falling, q, side, pull, certain = sticking.sticking_end(
            contact, spring, start, force, omega * velocity
        )
    return falling, q, side, pull / omega, certain


@compiled
def at_place(contact: Viscoelastic, falling: bool, q: float) -> Instant:
    """Return the normal motion at q in one of the halves."""
    root, cap, loss, passed = damped_motion(contact, falling, q)
    return Instant(falling, root, cap, loss, passed)


@compiled
def at_time(contact: Viscoelastic, time: float) -> Instant:
    """Return the normal motion at a time scaled by t_scale."""
    falling, q = sliding.at_time(contact, time * contact.unit)
    root, cap, loss, passed = damped_motion(contact, falling, q)
    return Instant(falling, root, cap, loss, passed)
