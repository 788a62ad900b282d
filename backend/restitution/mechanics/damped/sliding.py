"""Where sliding ends in a damped contact, and where in it an instant lies.

All quantities are in the units of the contact; z and u are the paper's divided by m = μ/α. An
instant is q in one of the halves, with a word on the half, or a time since the start. With
r = κP + P̈ (docs/model.md, "Events with damping"):

* The sign of r changes where κ = −P̈/P, which falls, rises and falls again, or only falls: three
  times for soft springs (κ between the local extrema), else once, from − to +.
* Sliding ends where the reach κ(1 − V) + Ṗ, whose rate is r, has grown enough.
"""

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import (
    Viscoelastic,
    cap_rate,
    cap_slopes,
    curvature_at,
    damped_motion,
    guessed_place,
    rate_at,
)
from restitution.mechanics.roots import MOST_STEPS, ROUNDING, halley_within, newton_within
from restitution.mechanics.switching import NOWHERE, Spring

BESIDE = 1e-9
"""Relative distance below which κ may be on either side of an extremum of −P̈/P."""


@compiled
def rounding_of(contact: Viscoelastic) -> float:
    """Return the relative error of the normal motion, of which each piece adds a rounding."""
    pieces: int = contact.pieces.shape[0]
    return ROUNDING * max(8.0, pieces)


@compiled
def place(contact: Viscoelastic, falling: bool, time: float) -> float:
    """Return q at a time from the start, or to the end when `falling`."""
    longest = contact.duration - contact.peak_time if falling else contact.peak_time
    end = contact.falling_end if falling else contact.rising_end
    if time <= 0.0:
        return 0.0
    if time >= longest:
        return end
    low, high = 0.0, end
    q = min(max(guessed_place(contact, falling, time), 0.0), end)
    for n in range(MOST_STEPS):
        root, _, loss, passed = damped_motion(contact, falling, q)
        rate = rate_at(contact, falling, loss)
        if passed > time:
            high = q
        else:
            low = q
        bend = -2.0 * rate if falling else 2.0 * rate
        q, found = halley_within(n, q, passed - time, 2.0 * root, bend, low, high)
        if found:
            return min(max(q, 0.0), end)
    raise ArithmeticError("the place of a time in the contact was not found")


@compiled
def at_time(contact: Viscoelastic, time: float) -> tuple[bool, float]:
    """Return the half and q at a time from the start."""
    if time <= contact.peak_time:
        return False, place(contact, False, time)
    return True, place(contact, True, contact.duration - time)


@compiled
def position_time(contact: Viscoelastic, position: float) -> float:
    """Return the time from the start at a distance in τ from the start."""
    if position <= contact.rising_end:
        return damped_motion(contact, False, position)[3]
    left = contact.rising_end + contact.falling_end - position
    return contact.duration - damped_motion(contact, True, left)[3]


@compiled
def _curvature_root(
    contact: Viscoelastic, kappa: float, low: float, high: float, sign: float
) -> float:
    """Return the time at which −P̈/P passes κ between two positions, rising for `sign` 1."""
    position = 0.5 * (low + high)
    for n in range(MOST_STEPS):
        curvature, slope = curvature_at(contact, position)
        value = curvature - kappa
        if sign * value < 0.0:
            low = position
        else:
            high = position
        position, found = newton_within(n, position, value, slope, low, high)
        if found:
            return position_time(contact, min(max(position, low), high))
    raise ArithmeticError("where the cap outruns the spring was not found")


@compiled
def outrun(contact: Viscoelastic, kappa: float) -> tuple[float, float]:
    """Return the times between which the cap curves away from the spring in mid-contact.

    There r < 0, as at the start; `NOWHERE` twice if it is so at the start only.
    """
    # beside both values rounding would hide a dip, and in it a switch: it is looked at, if empty
    low, high = contact.valley_value - BESIDE * kappa, contact.ridge_value + BESIDE * kappa
    if contact.ridge < 0.0 or not low < kappa < high:
        return NOWHERE, NOWHERE
    end = contact.rising_end + contact.falling_end
    begin = _curvature_root(contact, kappa, contact.valley, contact.ridge, 1.0)
    return begin, _curvature_root(contact, kappa, contact.ridge, end, -1.0)


@compiled
def has_ended(
    contact: Viscoelastic, spring: Spring, target: float, lacking: float, falling: bool, q: float
) -> tuple[bool, bool]:
    """Return whether sliding, had it gone on, would have ended before q, and certainty of it.

    It has where 2R(κL + |Ṗ|) has grown to 2Rκ `target` or, when `falling`, fallen to 2Rκ `lacking`:
    L is the velocity spent, or yet to be spent.
    """
    kappa = spring.stiffness
    root, cap, loss, _ = damped_motion(contact, falling, q)
    rate = rate_at(contact, falling, loss)
    slope, _, _ = cap_slopes(contact.a, contact.b, root, rate, cap)
    double = 2.0 * root * kappa
    excess = double * (loss - target) + slope
    if falling:
        excess = double * (lacking - loss) + slope
    terms = cap + 2.0 * root * root * (contact.a + contact.b * root * cap)
    terms += double * (loss + abs(target))
    rounding = double * spring.error + rounding_of(contact) * terms
    return excess >= 0.0, abs(excess) > rounding


@compiled
def excess_of(
    contact: Viscoelastic,
    sense: float,
    kappa: float,
    target: float,
    root: float,
    cap: float,
    loss: float,
    rate: float,
) -> tuple[float, float, float]:
    """Return 2R(κL + |Ṗ| − κ `target`) and its first two derivatives by q.

    `sense` is −1 in the falling half, where q runs back in time, else 1.
    """
    slope, bend, twist = cap_slopes(contact.a, contact.b, root, rate, cap)
    excess = kappa * (loss - target)
    square = root * root
    # 2R²C is what q takes from L
    taking = 2.0 * square * cap
    growing = cap_rate(contact.a, contact.b, root, rate, cap)
    value = 2.0 * root * excess + sense * slope
    first = 2.0 * sense * rate * excess + 2.0 * kappa * root * taking + bend
    second = sense * twist - 2.0 * taking * excess
    second += 4.0 * sense * kappa * root * (4.0 * root * rate * cap + square * growing)
    return value, first, second


@compiled
def sliding_root(
    contact: Viscoelastic, kappa: float, target: float, falling: bool, low: float, high: float
) -> float:
    """Return q in (low, high) where κL + |Ṗ| = κ `target`, below it at `low`."""
    q = 0.5 * (low + high)
    sense = -1.0 if falling else 1.0
    for n in range(MOST_STEPS):
        root, cap, loss, _ = damped_motion(contact, falling, q)
        rate = rate_at(contact, falling, loss)
        value, first, second = excess_of(contact, sense, kappa, target, root, cap, loss, rate)
        if value > 0.0:
            high = q
        else:
            low = q
        q, found = halley_within(n, q, value, first, second, low, high)
        if found:
            return min(max(q, low), high)
    raise ArithmeticError("the end of sliding was not found")


@compiled
def sliding_end(
    contact: Viscoelastic, spring: Spring, falling: bool, q: float, towards: float
) -> tuple[bool, bool, float, float, bool]:
    """Return whether sliding ends, half, q, velocity towards its side there, and certainty.

    Sliding began at q with the velocity `towards`. The velocity is the last of the collision if
    sliding does not end.
    """
    kappa = spring.stiffness
    _, _, loss, time = damped_motion(contact, falling, q)
    target = towards + loss
    lacking = loss - towards if falling else contact.impulse - target
    short = kappa * lacking - contact.last_slope
    rounding = rounding_of(contact) * (kappa * (abs(target) + 2.0) + contact.last_slope)
    certain = abs(short) > kappa * spring.error + rounding
    time = contact.duration - time if falling else time
    high = q if falling else contact.rising_end
    end, rising_ends = 0.0, False
    if time < spring.bend_begin:
        # the reach grows until then and shrinks; if it does not suffice there, it will later
        turn_falling, turn = at_time(contact, spring.bend_begin)
        ended, sure = has_ended(contact, spring, target, lacking, turn_falling, turn)
        certain = certain and sure
        if ended and turn_falling:
            end = turn
        elif ended:
            high, rising_ends = turn, True
    if not falling:
        # in which half sliding ends makes no difference to the count
        if rising_ends or has_ended(contact, spring, target, lacking, False, high)[0]:
            q = sliding_root(contact, kappa, target, False, q, high)
            root, cap, spent, _ = damped_motion(contact, False, q)
            slope, _, _ = cap_slopes(contact.a, contact.b, root, 1.0 - spent, cap)
            velocity = 0.5 * slope / root / kappa if kappa > 1.0 else target - spent
            return True, False, q, velocity, certain
        high = contact.falling_end
    if short <= 0.0 and end == 0.0:
        return False, True, 0.0, -lacking, certain
    q = sliding_root(contact, kappa, lacking, True, end, high)
    root, cap, loss, _ = damped_motion(contact, True, q)
    slope, _, _ = cap_slopes(contact.a, contact.b, root, rate_at(contact, True, loss), cap)
    velocity = 0.5 * slope / root / kappa if kappa > 1.0 else min(loss - lacking, 0.0)
    return True, True, q, velocity, certain
