"""The contact without damping: its normal motion, its events, and what bounds ε_t.

The events are those of `switching`. Parameters are κ (Eq. 24, with α in it) and
ψ = (α/μ)(g_t/g_n); z and u are the paper's divided by μ/α. Functions of the same names in
`viscoelastic` are those with damping; `contact` has the choice.
"""

import math
from typing import NamedTuple

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import (
    CONTACT_DURATION,
    HALF_CONTACT,
    MAXIMUM_FORCE,
    Instant,
    normal_motion,
)
from restitution.mechanics.switching import (
    COMPRESSING,
    MONOTONE_STIFFNESS,
    NOWHERE,
    SLIDING_TO_THE_END,
    Spring,
    first_sliding_end,
    next_sliding_end,
    slip_reach,
    sticking_end_after_compression,
    sticking_end_in_decompression,
    velocity_to_stop,
)


class Elastic(NamedTuple):
    """The contact without damping, in the units of `hertz`; what kernels take."""

    begins_sliding: bool = True
    """The spring's force rises as t, the cap only as t^{3/2}."""
    strongest: float = math.inf
    """ψ from which on the collision is followed as one of this ψ."""
    least_load: float = 0.0
    unit: float = 1.0
    duration: float = CONTACT_DURATION
    impulse: float = 2.0
    """1 + ε_n, all that sliding can take from the surface velocity."""
    last_rate: float = -1.0
    """ẋ at the end, −ε_n."""
    peak: float = MAXIMUM_FORCE
    """The largest force."""


@compiled
def expected_switches(contact: Elastic, kappa: float, psi: float) -> float:
    """Return about how many switches a collision has, rather too many than too few.

    They crowd into the decompression, from where the cap has fallen to the spring's amplitude, of
    order ψ√κ, or where the first sliding ends; there one takes about half a radian of √κ t.
    """
    if psi >= contact.impulse:
        return 4.0
    omega = math.sqrt(kappa)
    begin: float = min(0.5 * CONTACT_DURATION, 1.2 * (psi * omega) ** (2.0 / 3.0))
    begin = min(begin, 1.2 * (2.5 * (2.0 - psi)) ** 0.4)
    return 4.0 + 2.0 * omega * begin / math.pi


@compiled
def stiffest_within(contact: Elastic, most_switches: float) -> float:
    """Return κ up to which no collision is expected to switch more often."""
    most = max(most_switches - 4.0, 0.0) * math.pi / contact.duration
    return most * most


@compiled
def stiff_bound(kappa: float, psi: float) -> float:
    """Return min(1, (5/4)^{3/5}/(ψ√κ)), a bound on |ε_t| for ψ < 2; see `limits.stiff_bound`."""
    return min(1.0, MAXIMUM_FORCE / math.sqrt(kappa) / psi)


SHARP_STIFF_LIMIT = 4.484842352
"""max over τ of (τ + π/2)^{3/2} − (2/5) τ^{5/2}, rounded up; at τ = 2.0035."""

NO_LESS = 2.3e-308
"""Bounds stay above the smallest normal double: a bound of 0 would promise too much."""


@compiled
def sharp_stiff_bound(kappa: float, psi: float) -> float:
    """Return min(`stiff_bound`, 4.4848 κ^{-5/4}/ψ), a bound on |ε_t| for ψ < 2.

    The second is proven from κ = `MONOTONE_STIFFNESS` on (docs/model.md) and smaller than the
    first from κ = 6.2 on.
    """
    half_power = kappa**-0.625
    # in two halves, between which a small ψ makes up for a large κ
    sharp = SHARP_STIFF_LIMIT * half_power / psi * half_power
    bound = stiff_bound(kappa, psi)
    return max(NO_LESS, min(bound, sharp) if kappa >= MONOTONE_STIFFNESS else bound)


@compiled
def energy_bound(_: Elastic, kappa: float, psi: float) -> float:
    """Return `sharp_stiff_bound`."""
    return sharp_stiff_bound(kappa, psi)


@compiled
def rounding_bound(_: Elastic, kappa: float, psi: float) -> float:
    """Return a bound on the rounding error of ε_t.

    Errors never grow, for two motions under the same cap only approach each other (docs/model.md).
    What remains is the phase √κ t_c of a swing whose amplitude is at most `stiff_bound`, and some
    roundings of ε_t itself. The factor is five times the largest error seen in tests/validation.
    """
    return 4e-15 * (1.0 + math.sqrt(kappa) * stiff_bound(kappa, psi))


@compiled
def spring_in(contact: Elastic, kappa: float, psi: float) -> Spring:
    """Return the spring of a stiffness κ in a collision of one ψ."""
    error = rounding_bound(contact, kappa, psi) * psi
    return Spring(kappa, math.sqrt(kappa), NOWHERE, NOWHERE, error)


@compiled
def sliding_end(
    contact: Elastic,
    spring: Spring,
    falling: bool,
    q: float,
    towards: float,
) -> tuple[bool, bool, float, float, bool]:
    """Return whether sliding ends, half, q, velocity towards its side there, and certainty.

    Sliding began at q with the velocity `towards`. The velocity is the last of the collision if
    sliding does not end.
    """
    kappa = spring.stiffness
    if q == 0.0 and not falling:
        # docs/model.md, "Events without search", Sliding: from the touch on
        phase, q, certain = first_sliding_end(kappa, towards)
        if phase == SLIDING_TO_THE_END:
            return False, True, 0.0, towards - contact.impulse, certain
        root, loss = normal_motion(q)
        if phase == COMPRESSING:
            return True, False, q, towards - loss, certain
        return True, True, q, -1.5 * root * (1.0 - loss) / kappa, certain
    lacking = velocity_to_stop(q, falling) - towards
    certain = abs(lacking) > spring.error
    if lacking <= 0.0:
        return False, True, 0.0, -lacking, certain
    q = next_sliding_end(kappa, q, falling, lacking)
    root, loss = normal_motion(q)
    return True, True, q, -1.5 * root * (1.0 - loss) / kappa, certain


@compiled
def sticking_end(
    _: Elastic,
    spring: Spring,
    falling: bool,
    q: float,
    velocity: float,
) -> tuple[bool, float, int, float, bool]:
    """Return half, q, side, velocity towards that side and certainty of the next sliding.

    Sticking began at q with the given velocity; both sides are 1 where it began.
    """
    kappa, omega = spring.stiffness, spring.omega
    certain = True
    if falling:
        # Sticking 4: on the other side, after z = 0 and before the extremum
        side = -1
        q, towards = sticking_end_in_decompression(omega, q, abs(velocity))
    else:
        # Sticking 1 to 3 and, for soft springs, 5
        falling, q, side, velocity, certain = sticking_end_after_compression(
            kappa, omega, q, velocity
        )
        towards = side * velocity
    if falling and kappa * (velocity_to_stop(q, True) - towards) > slip_reach(kappa, q):
        # Only rounding has put the spring on the cap: it moves away, faster than the cap falls.
        q, towards = sticking_end_in_decompression(omega, q, -towards)
        side, certain = -side, False
    return falling, q, side, towards, certain


@compiled
def at_place(_: Elastic, falling: bool, q: float) -> Instant:
    """Return the normal motion at q in one of the halves."""
    root, loss = normal_motion(q)
    return Instant(falling, root, root * root, loss, q * q)


@compiled
def at_time(_: Elastic, time: float) -> Instant:
    """Return the normal motion at a time scaled by t_scale."""
    falling = time > HALF_CONTACT
    passed = max(0.0, CONTACT_DURATION - time) if falling else time
    root, loss = normal_motion(math.sqrt(passed))
    return Instant(falling, root, root * root, loss, passed)
