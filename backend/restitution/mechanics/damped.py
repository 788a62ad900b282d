"""The damped collision, episode by episode; beside `collision`, which is the one without damping.

It begins sticking, for the force rises as √t and the spring's as t, and ends sliding: the number
of switches is odd. Parameters are κ and ψ as there, and η = (3/2) A β^{2/5} g_n^{1/5}.
"""

import math

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import (
    EPISODE,
    MOST_SWITCHES,
    NO_LESS,
    TOO_STIFF,
    WEAKEST,
    Collision,
    collide_in_parts,
    record,
)
from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped_normal_motion import Contact, damped_motion
from restitution.mechanics.damped_sliding import outrun, sliding_end
from restitution.mechanics.damped_sticking import (
    cap_fall_time,
    sticking_end,
    sticking_end_while_falling,
)
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.switching import ROUNDING
from restitution.mechanics.viscoelastic import normal_contact

STRONGEST = 1e150
"""ψ above which ε_t is 1 to double precision: what the cap takes is at most 2."""

SOFTEST = 1e-290
"""κ below which, in the units of the contact, the spring takes nothing from the velocity."""


FEW = 200.0
"""Switches that are not worth a closer estimate."""


STIFFEST = 1e100
"""κ above which, in the same units, only collisions are followed that slide but for the start."""

ENDLESS = 10_000_000
"""Switches after which a collision goes wrong: far beyond `MOST_SWITCHES` and what is expected."""


@compiled
def scaled_stiffness(contact: Contact, kappa: float) -> float:
    """Return κ in the units of the contact, kept clear of overflow and underflow."""
    return min(max(kappa / contact.unit / contact.unit, SOFTEST), STIFFEST)


@compiled
def expected_damped_switches(contact: Contact, kappa: float, psi: float) -> float:
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
    fallen = cap_fall_time(contact, max(psi, WEAKEST) * omega)
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
def damped_bound(contact: Contact, kappa: float, psi: float) -> float:
    """Return min(1, P_max/(ψ√κ)) ≥ |ε_t|, for ψ < 1 + ε_n.

    Proven where the cap never curves away from the spring but at the start; 1 elsewhere.
    """
    stiffness = scaled_stiffness(contact, kappa)
    if contact.ridge >= 0.0 and stiffness < contact.ridge_value:
        return 1.0
    return max(NO_LESS, min(1.0, contact.peak / math.sqrt(stiffness) / psi))


@compiled
def damped_rounding_bound(contact: Contact, kappa: float, psi: float) -> float:
    """Return a bound on the rounding error of ε_t, for the same reasons as without damping.

    The factor is that of `collision.rounding_bound`, twenty times the largest error seen in
    tests/validation/damped.csv.
    """
    omega = math.sqrt(scaled_stiffness(contact, kappa))
    swing = omega * contact.duration * min(1.0, contact.peak / omega / psi)
    return 4e-15 * (1.0 + swing)


@compiled
def follow_damped(
    contact: Contact, kappa: float, psi: float, episodes: npt.NDArray[np.void]
) -> tuple[float, int, bool]:
    """Follow one collision, κ as in the API and ψ from `WEAKEST` to `STRONGEST`.

    Fills the first episodes as `collision.follow` does, with q and half as in `Contact`; returns
    ε_t, the number of switches, and whether that is certain.
    """
    kappa = scaled_stiffness(contact, kappa)
    omega = math.sqrt(kappa)
    bend_begin, bend_end = outrun(contact, kappa)
    rounding = 8.0 * ROUNDING * (1.0 + omega * contact.duration)
    room = episodes.size
    if room > 0:
        record(episodes, 0, 0.0, psi, False, 1, False)
    falling, q, side, towards, certain = sticking_end(
        contact, kappa, 0.0, 0.0, omega * psi, bend_begin, bend_end
    )
    certain = certain and kappa > SOFTEST
    switches = 1
    while switches < ENDLESS:
        towards /= omega
        if switches < room:
            record(episodes, switches, q, side * towards, falling, side, True)
        ends, falling, q, velocity, sure = sliding_end(
            contact, kappa, falling, q, towards, bend_begin
        )
        certain = certain and sure
        if not ends:
            # rounding can exceed what the energy allows
            return min(max(side * velocity / psi, -1.0), 1.0), switches, certain
        switches += 1
        if switches < room:
            record(episodes, switches, q, side * velocity, falling, side, False)
        root, cap, _, time = damped_motion(contact, falling, q)
        force = root * cap
        if falling and contact.duration - time >= bend_end:
            q, towards = sticking_end_while_falling(
                contact, omega, time, force, omega * abs(velocity)
            )
            side = -side
        else:
            start = contact.duration - time if falling else time
            falling, q, turned, towards, sure = sticking_end(
                contact, kappa, start, force, omega * velocity, bend_begin, bend_end
            )
            side *= turned
            certain = certain and sure
        switches += 1
        # the velocity of a swing is known to the rounding of its phase, times its amplitude
        _, _, loss, _ = damped_motion(contact, falling, q)
        lacking = (loss if falling else contact.impulse - loss) - towards / omega
        swing = math.hypot(force / omega, velocity)
        certain = certain and abs(lacking - contact.last_slope / kappa) > rounding * swing
    raise ArithmeticError("the collision does not end")


@compiled
def _collide_each(
    contact: Contact,
    kappa: FloatArray,
    psi: FloatArray,
    most_switches: float,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
    certain: npt.NDArray[np.bool_],
    bound: FloatArray,
) -> None:
    """Fill the last four arrays (N,) for the parameters before them."""
    nothing = np.empty(0, dtype=EPISODE)
    for i in range(kappa.size):
        k, p = kappa[i], min(max(psi[i], WEAKEST), STRONGEST)
        bound[i] = damped_rounding_bound(contact, k, p)
        below = p < contact.impulse
        if below and (bound[i] >= 1.0 or expected_damped_switches(contact, k, p) > most_switches):
            epsilon_t[i], switches[i], certain[i] = 0.0, TOO_STIFF, False
            bound[i] = damped_bound(contact, k, psi[i])
        else:
            epsilon_t[i], switches[i], certain[i] = follow_damped(contact, k, p, nothing)
        if psi[i] == 0.0 or psi[i] == np.inf:
            switches[i], certain[i] = 0, True


@compiled
def _expect_each(
    contact: Contact, kappa: FloatArray, psi: FloatArray, expected: FloatArray
) -> None:
    for i in range(kappa.size):
        expected[i] = expected_damped_switches(contact, kappa[i], psi[i])


def expected_damped_switch_counts(kappa: FloatArray, psi: FloatArray, damping: float) -> FloatArray:
    """Return `expected_damped_switches` of collisions (N,) of one η."""
    expected = np.empty(kappa.shape)
    _expect_each(normal_contact(damping), kappa, psi, expected)
    return expected


def collide_damped(
    kappa: npt.ArrayLike,
    psi: npt.ArrayLike,
    damping: float,
    most_switches: float = MOST_SWITCHES,
) -> Collision:
    """Return the coefficient of tangential restitution and the number of switches for one η > 0.

    Parameters
    ----------
    kappa, psi : array_like
        As of `collision.collide`.
    damping : float
        η, positive and at most `MOST_DAMPING`.
    most_switches : float, optional
        Collisions with ψ < 1 + ε_n that are expected to switch more often are not followed: they
        have ε_t = 0 with `damped_bound` and `TOO_STIFF` switches.

    Examples
    --------
    >>> epsilon_t, switches, _, _ = collide_damped(63.0, [0.3, 1.0, 4.0], 0.05)
    >>> switches
    array([5, 9, 1], dtype=int32)
    """
    contact = normal_contact(damping)
    most = float(most_switches)  # an integer would be compiled for anew
    return collide_in_parts(
        kappa, psi, lambda kappas, psis, *out: _collide_each(contact, kappas, psis, most, *out)
    )
