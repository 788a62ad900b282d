"""Where sticking ends in a damped contact: bracketed roots.

As in `sliding`. What makes the brackets safe is derived in docs/model.md, "Events with
damping". While the spring κz keeps its sign, g = P/|κz| falls and rises with W = Ṗκz − Pκu, whose
rate is r κz. So g has one minimum where r > 0, and the spring meets the cap if g < 1 there, before.
"""

import math

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import (
    Viscoelastic,
    cap_slopes,
    damped_motion,
    guessed_place,
    rate_at,
)
from restitution.mechanics.damped.sliding import BESIDE, at_time, place, rounding_of
from restitution.mechanics.roots import MOST_STEPS, NEGLIGIBLE, halley_within, newton_within
from restitution.mechanics.switching import Spring


@compiled
def spring_at(elapsed: float, omega: float, force: float, pull: float) -> tuple[float, float]:
    """Return κz and κu/ω after `elapsed`, from their values `force` and `pull`."""
    sine, cosine = math.sin(omega * elapsed), math.cos(omega * elapsed)
    return force * cosine + pull * sine, pull * cosine - force * sine


@compiled
def gap_of(
    contact: Viscoelastic,
    omega: float,
    root: float,
    cap: float,
    rate: float,
    load: float,
    moving: float,
) -> tuple[float, float, float]:
    """Return P − κz and its first two derivatives by τ; `load` is κz and `moving` κu/ω."""
    slope, bend, _ = cap_slopes(contact.a, contact.b, root, rate, cap)
    # dt = 2R dτ
    turning = omega * moving
    second = bend - 2.0 * rate * turning + 4.0 * root * root * omega * omega * load
    return root * cap - load, slope - 2.0 * root * turning, second


@compiled
def lead_of(
    contact: Viscoelastic,
    omega: float,
    root: float,
    cap: float,
    rate: float,
    load: float,
    moving: float,
) -> tuple[float, float]:
    """Return 2RW, W = Ṗκz − Pκu, and its derivative by τ, from κz and κu/ω."""
    slope, bend, _ = cap_slopes(contact.a, contact.b, root, rate, cap)
    force, turning = root * cap, omega * moving
    lead = slope * load - 2.0 * root * force * turning
    growth = load * (bend + 4.0 * root * root * omega * omega * force)
    return lead, growth - 2.0 * rate * force * turning


@compiled
def gap_and_lead(
    contact: Viscoelastic, spring: Spring, t0: float, force: float, pull: float, time: float
) -> tuple[float, float, bool]:
    """Return P − κz, 2R (Ṗκz − Pκu) at a time, and whether rounding leaves the first its sign.

    `force` and `pull` are κz and κu/ω at t₀.
    """
    omega = spring.omega
    falling, q = at_time(contact, time)
    root, cap, loss, _ = damped_motion(contact, falling, q)
    rate = rate_at(contact, falling, loss)
    load, moving = spring_at(time - t0, omega, force, pull)
    gap = root * cap - load
    lead, _ = lead_of(contact, omega, root, cap, rate, load, moving)
    # a spring at rest has the relative error of its phase, one that was followed also an absolute
    phase, followed = omega * time, 0.0
    if t0 > 0.0:
        phase, followed = 1.0 + phase, omega * spring.error
    terms = root * cap + abs(load) + phase * math.hypot(force, pull)
    rounding = rounding_of(contact) * terms
    return gap, lead, abs(gap) > rounding + followed


@compiled
def halved(
    contact: Viscoelastic, begin: float, end: float, later: bool
) -> tuple[bool, float, float]:
    """Return the half, and the times from its end of the contact, of an interval's part in it.

    `later` says in which half, if it lies in both.
    """
    peak = contact.peak_time
    falling = begin >= peak or (end > peak and later)
    if falling:
        return True, contact.duration - end, contact.duration - max(begin, peak)
    return False, begin, min(end, peak)


@compiled
def closest(
    contact: Viscoelastic,
    spring: Spring,
    t0: float,
    force: float,
    pull: float,
    begin: float,
    end: float,
) -> float:
    """Return the time between two at which P/κz has its minimum: W < 0 before and > 0 after it."""
    omega = spring.omega
    later = begin < contact.peak_time < end
    if later:
        later = gap_and_lead(contact, spring, t0, force, pull, contact.peak_time)[1] < 0.0
    falling, near, far = halved(contact, begin, end, later)
    low, high = place(contact, falling, near), place(contact, falling, far)
    sense = -1.0 if falling else 1.0
    origin = contact.duration - t0 if falling else -t0
    q = 0.5 * (low + high)
    if low == 0.0 and not falling and contact.b < contact.a:
        q = min(q, math.sqrt(contact.b))
    for n in range(MOST_STEPS):
        root, cap, loss, passed = damped_motion(contact, falling, q)
        rate = rate_at(contact, falling, loss)
        load, moving = spring_at(origin + sense * passed, omega, force, pull)
        value, growth = lead_of(contact, omega, root, cap, rate, load, moving)
        if (value > 0.0) == falling:
            low = q
        else:
            high = q
        q, found = newton_within(n, q, value, sense * growth, low, high)
        if found:
            _, _, _, passed = damped_motion(contact, falling, min(max(q, low), high))
            return contact.duration - passed if falling else passed
    raise ArithmeticError("the nearest approach of spring and cap was not found")


@compiled
def meeting(
    contact: Viscoelastic,
    omega: float,
    origin: float,
    force: float,
    pull: float,
    falling: bool,
    near: float,
    far: float,
    guess: float,
) -> tuple[float, float]:
    """Return q where the spring meets the cap from below, and κu/ω there.

    The meeting is between the times `near` and `far` from the nearer end. The spring is κz =
    `force` and κu/ω = `pull` at the time `origin` to the end, if `falling`, or −`origin` from the
    start.
    """
    sense, high = -1.0 if falling else 1.0, contact.falling_end if falling else contact.rising_end
    low = 0.0
    q = guess if low < guess < high else 0.5 * high
    slack = BESIDE * (far - near)
    for n in range(MOST_STEPS):
        if high < NEGLIGIBLE:
            break
        root, cap, loss, passed = damped_motion(contact, falling, q)
        rate = rate_at(contact, falling, loss)
        load, moving = spring_at(origin + sense * passed, omega, force, pull)
        if passed < near - slack or passed > far + slack:
            # to the middle of the bracket, known as a time alone
            if passed < near:
                low = q
            else:
                high = q
            middle = passed - 0.5 * (near + far)
            q, found = newton_within(n, q, middle, 2.0 * root, low, high)
            if found:
                break
            continue
        # (P − κz)/R, for both are small where the contact begins
        gap, closing, bend = gap_of(contact, omega, root, cap, rate, load, moving)
        value = gap / root
        first = (closing - value * rate) / root
        second = (bend - 2.0 * first * rate + 2.0 * root * root * cap * value) / root
        if (value > 0.0) == falling:
            high = q
        else:
            low = q
        q, found = halley_within(n, q, value, sense * first, second, low, high)
        if found:
            break
    else:
        raise ArithmeticError("the end of sticking was not found")
    q = min(max(q, low), high)
    _, _, _, passed = damped_motion(contact, falling, q)
    return q, spring_at(origin + sense * passed, omega, force, pull)[1]


@compiled
def cap_fall_time(contact: Viscoelastic, amplitude: float) -> float:
    """Return the time to the end when P has fallen to `amplitude`; at most that of its peak."""
    if not amplitude < contact.peak:
        return contact.duration - contact.peak_time
    low, high = 0.0, contact.falling_end
    q = min(amplitude ** (1.0 / 3.0), 0.5 * high)
    for n in range(MOST_STEPS):
        root, cap, loss, passed = damped_motion(contact, True, q)
        rate = rate_at(contact, True, loss)
        slope, bend, _ = cap_slopes(contact.a, contact.b, root, rate, cap)
        value = root * cap - amplitude
        if value > 0.0:
            high = q
        else:
            low = q
        q, found = halley_within(n, q, value, -slope, bend, low, high)
        if found:
            return passed
    raise ArithmeticError("the fall of the cap was not found")


@compiled
def meeting_before_bend_end(
    contact: Viscoelastic,
    spring: Spring,
    t0: float,
    force: float,
    pull: float,
    begin: float,
    end: float,
    nearing: bool,
) -> tuple[bool, float, float, bool, bool]:
    """Return whether κz > 0 meets the cap between two times and before the spring's `bend_end`.

    Also the times that bracket the meeting or, without one, from where on to look, whether spring
    and cap approach each other there, and certainty; see `meeting_in_swing`.
    """
    bend_begin, bend_end = spring.bend_begin, spring.bend_end
    certain = True
    if begin < bend_begin:
        stop = min(end, bend_begin)
        gap, lead, certain = gap_and_lead(contact, spring, t0, force, pull, stop)
        if gap <= 0.0 and lead <= 0.0:
            return True, begin, stop, True, certain
        if lead > 0.0 and nearing:
            least = closest(contact, spring, t0, force, pull, begin, stop)
            gap, _, sure = gap_and_lead(contact, spring, t0, force, pull, least)
            certain = certain and sure
            if gap <= 0.0:
                return True, begin, least, True, certain
        begin, nearing = stop, lead <= 0.0
    if begin < min(bend_end, end):
        stop = min(end, bend_end)
        gap, lead, sure = gap_and_lead(contact, spring, t0, force, pull, stop)
        certain = certain and sure
        if gap <= 0.0:
            return True, begin, stop, True, certain
        begin, nearing = stop, lead < 0.0
    return False, begin, end, nearing, certain


@compiled
def meeting_in_swing(
    contact: Viscoelastic,
    spring: Spring,
    t0: float,
    force: float,
    pull: float,
    begin: float,
    extremum: float,
    end: float,
    nearing: bool,
) -> tuple[bool, float, float, bool]:
    """Return whether κz > 0 meets the cap in a half-swing where r changes its sign to + at most.

    The swing goes from `begin` over `extremum` to `end`; `nearing` says that spring and cap
    approach each other at first, in proportion. Also the times that bracket the meeting, and
    whether rounding has no say in it.
    """
    certain = True
    if begin < extremum < end:
        gap, lead, certain = gap_and_lead(contact, spring, t0, force, pull, extremum)
        if gap <= 0.0:
            return True, begin, extremum, certain
        if lead < 0.0:
            begin, nearing = extremum, True
        else:
            end = extremum
    if end >= contact.duration:
        # the force of the cap vanishes there, that of the spring does not
        return True, begin, end, certain
    if not nearing or begin >= end:
        return False, begin, end, certain
    least = closest(contact, spring, t0, force, pull, begin, end)
    gap, _, sure = gap_and_lead(contact, spring, t0, force, pull, least)
    return gap <= 0.0, begin, least, certain and sure


@compiled
def sticking_end(
    contact: Viscoelastic, spring: Spring, t0: float, force: float, pull: float
) -> tuple[bool, float, int, float, bool]:
    """Return half, q, side, velocity κu/ω towards that side and certainty of the next sliding.

    At t₀ the spring is κz = `force` ≥ 0, on the cap or, at t₀ = 0, at rest; κu/ω = `pull`.
    """
    omega = spring.omega
    lead = math.atan2(pull, force)
    soft = spring.bend_end >= 0.0
    resting = t0 == 0.0
    swing = 0
    if not soft and not resting:
        # Sticking 1 and 2: what left the cap stays within it in this swing, and while the cap rises
        fallen = contact.duration - cap_fall_time(contact, math.hypot(force, pull))
        swing = max(1, math.floor((omega * (fallen - t0) - lead) / math.pi + 0.5))
    checked = False
    certain = True
    for _ in range(MOST_STEPS):
        sign = 1 - 2 * (swing & 1)
        extremum = t0 + (lead + swing * math.pi) / omega
        # rounding of a large phase can put z = 0 just behind the end of the contact
        begin = min(max(t0, extremum - 0.5 * math.pi / omega), contact.duration)
        end = min(extremum + 0.5 * math.pi / omega, contact.duration)
        y0, w0 = sign * force, sign * pull
        met, begin, end, nearing, sure = meeting_before_bend_end(
            contact, spring, t0, y0, w0, begin, end, resting or swing > 0
        )
        certain = certain and sure
        if not met:
            met, begin, end, sure = meeting_in_swing(
                contact, spring, t0, y0, w0, begin, extremum, end, nearing
            )
            certain = certain and sure
        if met:
            break
        swing += 1
        if not soft and not checked:
            # Sticking 2: the cap is above the amplitude from here on until it has fallen
            checked = True
            fallen = contact.duration - cap_fall_time(contact, math.hypot(force, pull))
            last = math.floor((omega * (fallen - t0) - lead) / math.pi + 0.5)
            swing = max(swing, last)
    else:
        raise ArithmeticError("the swing in which sticking ends was not found")
    peak = contact.peak_time
    later = begin < peak < end
    if later:
        later = gap_and_lead(contact, spring, t0, sign * force, sign * pull, peak)[0] > 0.0
    falling, near, far = halved(contact, begin, end, later)
    origin = contact.duration - t0 if falling else -t0
    guess = guessed_place(contact, falling, 0.5 * (near + far))
    if resting and not falling:
        # P = bτ + aτ³ and κz = κψτ² for short times
        load = omega * pull
        inside = max(0.0, load * load - 4.0 * contact.a * contact.b)
        guess = 2.0 * contact.b / (load + math.sqrt(inside))
    q, towards = meeting(
        contact, omega, origin, sign * force, sign * pull, falling, near, far, guess
    )
    return falling, q, sign, towards, certain


@compiled
def sticking_end_while_falling(
    contact: Viscoelastic, omega: float, left: float, force: float, speed: float
) -> tuple[float, float]:
    """Return q at the next cap, on the other side, and the velocity κu/ω towards it there.

    Sticking began at the time `left` before the end, on the cap with κz = `force` and κu/ω =
    −`speed` towards z = 0, where r > 0 from then on.
    """
    zero = max(0.0, left - math.atan2(force, speed) / omega)
    amplitude = math.hypot(force, speed)
    # at the time `zero` the spring passes 0, moving towards the other side, and later its extremum
    last = max(0.0, zero - 0.5 * math.pi / omega)
    guess = guessed_place(contact, True, guessed_next_cap(omega, left, force, speed, zero))
    return meeting(contact, omega, zero, 0.0, amplitude, True, last, zero, guess)


@compiled
def guessed_next_cap(omega: float, left: float, force: float, speed: float, zero: float) -> float:
    """Return about the time to the end at which the spring meets the falling cap again.

    It left the cap at the time `left` as in `sticking_end_while_falling`, and is 0 at `zero`.
    """
    share = zero / left
    # of the cap, which is bent so that it has its slope at `left` and vanishes at the end
    steepness = max(omega * speed * left / force, 1.0)
    bent = 1.0 + (steepness - 1.0) * (1.0 - share)
    cap = force * share / bent
    fall = force * steepness / (left * bent * bent * omega)
    # from there the cap as a line, and a sine as the parabola that is right at 0 and at its top
    amplitude = math.sqrt(force * force + speed * speed)
    rise = amplitude * (4.0 / math.pi) + fall
    inside = rise * rise - amplitude * cap * (4.0 / math.pi) ** 2
    return max(zero - 2.0 * cap / (rise + math.sqrt(max(inside, 0.0))) / omega, 1e-12 * zero)
