"""Sticking in damped lanes that begins before the cap falls, and ends where it has fallen on it.

As without damping, spring and cap meet in the swing in which the cap falls below the amplitude, or
in the next one. There is no mirror time that would tell which; so it is looked where both come
closest, Ṗκz = Pκu: docs/model.md, "Events with damping".
"""

import math

import numpy as np

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import (
    STEP,
    Viscoelastic,
    cap_slopes,
    damped_motion,
    guessed_place,
    rate_at,
)
from restitution.mechanics.damped.sticking import lead_of
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.damped.motion import find_motion
from restitution.mechanics.lanes.damped.sticking import meet_in_bracket
from restitution.mechanics.lanes.elementary import arctangent, cube_root, within
from restitution.mechanics.lanes.first_sticking import CLOSE, FALL_ERROR, after_extremum
from restitution.mechanics.lanes.rows import (
    AMPLITUDE,
    BEGIN,
    CAP,
    DOUBT,
    EXTREMUM,
    FALL_RATE,
    FALL_ROOT,
    FALL_TIME,
    FORCE,
    GAP,
    HIGH,
    KAPPA,
    LEAD,
    LOSS,
    LOW,
    NODE,
    OMEGA,
    PASSED,
    PAST,
    PSI,
    PULL,
    REACH,
    ROOT,
    SIDE,
    Q,
)
from restitution.mechanics.lanes.sticking import spring_after
from restitution.mechanics.roots import halley

FALL_SLOPE, FALL_BEND = FALL_ROOT, FALL_RATE
"""|dP/dt| and d²P/dt² where the cap has fallen to the amplitude."""

STEP_TO_CLOSEST, BEND = LOW, HIGH
"""Newton's step to where spring and cap are closest, and the second derivative of the gap there."""

GUESS = LEAD
"""q at which they meet if they do after the extremum, else 0."""


@compiled
def stick_from_rise(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from where sliding ended in the rising half to the cap that falls."""
    for i in range(count):
        begin_sticking(contact, i, lanes)
    meet_falling_cap(contact, count, lanes)


@compiled
def stick_through_rise(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from the touch to the cap that falls, if the spring stays below it."""
    a, b, end = contact.a, contact.b, contact.rising_end
    for i in range(count):
        lanes[FORCE + i], lanes[BEGIN + i] = 0.0, 0.0
        lanes[AMPLITUDE + i] = lanes[OMEGA + i] * lanes[PSI + i]
        lanes[PULL + i] = lanes[AMPLITUDE + i]
        lanes[LEAD + i] = 0.5 * math.pi
        # P = bτ + aτ³ and κz = κψτ² for short times
        lanes[Q + i] = min(math.sqrt(b / a), 0.9 * end)
    find_closest(contact, False, count, lanes)
    for i in range(count):
        is_in_swing = lanes[OMEGA + i] * lanes[PASSED + i] < math.pi
        lanes[PAST + i] = 1.0 if is_in_swing and is_missed(i, lanes) else 0.0
        lanes[BEGIN + i] = contact.duration
    meet_falling_cap(contact, count, lanes)


@compiled
def is_missed(i: int, lanes: FloatArray) -> bool:
    """Return whether the spring of lane i stays below the cap where it comes closest."""
    step, bend = lanes[STEP_TO_CLOSEST + i], lanes[BEND + i]
    # it still shrinks by about half of bend × step², the less exactly the more the spring turns
    least = lanes[GAP + i] - bend * step * step
    turn = 2.0 * lanes[OMEGA + i] * lanes[ROOT + i] * step
    is_near: bool = bend > 0.0 and abs(step) < 1e-2 and abs(turn) < 0.1
    return is_near and least > CLOSE * lanes[AMPLITUDE + i]


@compiled
def meet_falling_cap(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes, whose harmonic is known, to where it meets the cap that falls."""
    find_fall(contact, count, lanes)
    for i in range(count):
        choose_swing(contact, i, lanes)
    for i in range(count):
        guess_closest(contact, i, lanes)
    find_closest(contact, True, count, lanes)
    for i in range(count):
        choose_side(i, lanes)
    for i in range(count):
        guess = guessed_meeting(contact, i, lanes)
        guess = lanes[GUESS + i] if lanes[GUESS + i] > 0.0 else guess
        lanes[Q + i] = within(guess, 0.0, contact.falling_end)
    meet_in_bracket(contact, count, lanes)


@compiled
def begin_sticking(contact: Viscoelastic, i: int, lanes: FloatArray) -> None:
    """Give lane i its harmonic: κz = `AMPLITUDE` cos(phase − `LEAD`)."""
    root, cap, loss, kappa = lanes[ROOT + i], lanes[CAP + i], lanes[LOSS + i], lanes[KAPPA + i]
    slope, _, _ = cap_slopes(contact.a, contact.b, root, 1.0 - loss, cap)
    force = root * cap
    velocity = 0.5 * slope / root / kappa if kappa > 1.0 else lanes[REACH + i] - loss
    pull = lanes[OMEGA + i] * velocity
    lanes[FORCE + i] = force
    lanes[PULL + i] = pull
    lanes[BEGIN + i] = contact.duration - lanes[PASSED + i]
    lanes[AMPLITUDE + i] = math.sqrt(force * force + pull * pull)
    lanes[LEAD + i] = arctangent(pull, force)
    # what left the cap stays within it until it has swung back
    lanes[PAST + i] = 1.0


@compiled
def find_fall(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Find when the cap has fallen to the amplitude: `FALL_TIME`, `FALL_SLOPE`, `FALL_BEND`."""
    a, b, end = contact.a, contact.b, contact.falling_end
    # the middle of the last piece may lie beyond the largest force
    last = contact.pieces.shape[0] - contact.rising - 2
    for i in range(count):
        lanes[NODE + i] = 0.0
    for node in range(1, last + 1):
        middle = contact.pieces[contact.rising + node, 0]
        # R and C, of which P is the product
        force = middle[0] * middle[1]
        for i in range(count):
            is_below = force < lanes[AMPLITUDE + i]
            lanes[NODE + i] = float(node) if is_below else lanes[NODE + i]
    root, cap, loss, _ = damped_motion(contact, True, end)
    _, bend, _ = cap_slopes(a, b, root, rate_at(contact, True, loss), cap)
    for i in range(count):
        # within the piece that was found, whatever the guess
        node, amplitude = lanes[NODE + i], lanes[AMPLITUDE + i]
        # a parabola about its top, nearer to the end about the cube of q
        top = end - math.sqrt(max(2.0 * (amplitude - contact.peak) / bend, 0.0))
        guess = top if amplitude > 0.8 * contact.peak else cube_root(amplitude)
        lanes[Q + i] = within(within(guess, node * STEP, (node + 1.0) * STEP), 0.0, end)
    for _ in range(2):
        find_motion(contact, True, count, lanes)
        for i in range(count):
            root, cap = lanes[ROOT + i], lanes[CAP + i]
            slope, bend, _ = cap_slopes(a, b, root, rate_at(contact, True, lanes[LOSS + i]), cap)
            step, _ = halley(root * cap - lanes[AMPLITUDE + i], -slope, bend)
            lanes[Q + i] = within(lanes[Q + i] - step, 0.5 * lanes[Q + i], end)
    find_motion(contact, True, count, lanes)
    for i in range(count):
        root, cap, rate = lanes[ROOT + i], lanes[CAP + i], rate_at(contact, True, lanes[LOSS + i])
        slope, bend, _ = cap_slopes(a, b, root, rate, cap)
        # dτ/dt
        per_tau = 0.5 / root
        is_over = lanes[AMPLITUDE + i] >= contact.peak
        # Newton's step in τ, and twice the part of it by which it is wrong
        step = (root * cap - lanes[AMPLITUDE + i]) / slope
        change = bend * step / slope
        is_found = abs(change) < 0.1 and abs(root * step * change) < 0.1 * FALL_ERROR
        lanes[DOUBT + i] += 0.0 if is_over or is_found else 1.0
        fallen = lanes[PASSED + i] + 2.0 * root * step
        lanes[FALL_TIME + i] = contact.duration - contact.peak_time if is_over else fallen
        # |dP/dt| and d²P/dt² there
        lanes[FALL_SLOPE + i] = 0.0 if is_over else -slope * per_tau
        lanes[FALL_BEND + i] = (bend - rate * slope / root) * per_tau * per_tau


@compiled
def choose_swing(contact: Viscoelastic, i: int, lanes: FloatArray) -> None:
    """Find the swing of lane i in which the cap falls below the amplitude."""
    omega, begin, lead = lanes[OMEGA + i], lanes[BEGIN + i], lanes[LEAD + i]
    amplitude, fallen = lanes[AMPLITUDE + i], lanes[FALL_TIME + i]
    swings = (omega * (begin - fallen) - lead) * (1.0 / math.pi)
    number = np.rint(swings)
    is_close = 0.5 - abs(swings - number) < FALL_ERROR * omega
    # in its first half-swing it may have met the cap
    is_unknown = lanes[PAST + i] < 1.0 and number > 0.0
    number = max(number, lanes[PAST + i])
    extremum = begin - (lead + number * math.pi) / omega
    side = 1.0 - 2.0 * (number - 2.0 * np.floor(0.5 * number))
    lanes[SIDE + i] = side
    # seen from the side of that swing
    lanes[FORCE + i] *= side
    lanes[PULL + i] *= side
    lanes[EXTREMUM + i] = extremum
    is_close = is_close or abs(amplitude - contact.peak) < CLOSE * contact.peak
    is_close = is_close or abs(extremum - fallen) < FALL_ERROR
    # while the cap rises what the amplitude says does not hold
    is_early = extremum > fallen and extremum > contact.duration - contact.peak_time
    lanes[DOUBT + i] += 1.0 if is_close or is_early or is_unknown else 0.0


@compiled
def guess_closest(contact: Viscoelastic, i: int, lanes: FloatArray) -> None:
    """Put lane i about where spring and cap are closest after the extremum.

    The cap as a parabola about its fall, the spring as one about its extremum.
    """
    omega, extremum = lanes[OMEGA + i], lanes[EXTREMUM + i]
    slope, bend = lanes[FALL_SLOPE + i], lanes[FALL_BEND + i]
    after = (slope - bend * (lanes[FALL_TIME + i] - extremum)) / (
        bend + lanes[AMPLITUDE + i] * omega * omega
    )
    low = max(extremum - 0.5 * math.pi / omega, 0.0)
    time = within(extremum - after, low, max(extremum, 1e-12))
    lanes[Q + i] = within(guessed_place(contact, True, time), 0.0, contact.falling_end)


@compiled
def find_closest(contact: Viscoelastic, falling: bool, count: int, lanes: FloatArray) -> None:
    """Find for `count` lanes where P/κz is least in one half: where Ṗκz − Pκu is 0."""
    end = contact.falling_end if falling else contact.rising_end
    sense = -1.0 if falling else 1.0
    for _ in range(2):
        find_motion(contact, falling, count, lanes)
        for i in range(count):
            rate = rate_at(contact, falling, lanes[LOSS + i])
            spring, moving = spring_after(i, lanes, lanes[BEGIN + i] + sense * lanes[PASSED + i])
            lead, growth = lead_in_lane(contact, i, lanes, rate, spring, moving)
            q = lanes[Q + i] - sense * lead / growth
            lanes[Q + i] = within(q, 0.5 * lanes[Q + i], end)
    find_motion(contact, falling, count, lanes)
    for i in range(count):
        rate = rate_at(contact, falling, lanes[LOSS + i])
        spring, moving = spring_after(i, lanes, lanes[BEGIN + i] + sense * lanes[PASSED + i])
        lead, growth = lead_in_lane(contact, i, lanes, rate, spring, moving)
        lanes[GAP + i] = lanes[ROOT + i] * lanes[CAP + i] - spring
        lanes[STEP_TO_CLOSEST + i] = sense * lead / growth
        lanes[BEND + i] = growth / spring


@compiled
def lead_in_lane(
    contact: Viscoelastic, i: int, lanes: FloatArray, rate: float, spring: float, moving: float
) -> tuple[float, float]:
    """Return `lead_of` for lane i."""
    root, cap = lanes[ROOT + i], lanes[CAP + i]
    return lead_of(contact, lanes[OMEGA + i], root, cap, rate, spring, moving)


@compiled
def choose_side(i: int, lanes: FloatArray) -> None:
    """Decide whether the meeting of lane i is before or after the extremum, or in the next swing.

    With a bracket of its time, and a guess where spring and cap were close.
    """
    omega, extremum, fallen = lanes[OMEGA + i], lanes[EXTREMUM + i], lanes[FALL_TIME + i]
    gap, step, bend = lanes[GAP + i], lanes[STEP_TO_CLOSEST + i], lanes[BEND + i]
    is_after = extremum > fallen
    is_met = gap < -CLOSE * lanes[AMPLITUDE + i]
    quarter = 0.5 * math.pi / omega
    is_in_swing = lanes[PASSED + i] < extremum and lanes[PASSED + i] > extremum - quarter
    is_clear = is_in_swing and (is_met or is_missed(i, lanes))
    is_next = is_after and not is_met
    lanes[DOUBT + i] += 1.0 if is_after and not is_clear else 0.0
    turned = -1.0 if is_next else 1.0
    lanes[SIDE + i] *= turned
    lanes[FORCE + i] *= turned
    lanes[PULL + i] *= turned
    extremum -= math.pi / omega if is_next else 0.0
    is_after = is_after and is_met
    lanes[EXTREMUM + i] = extremum
    lanes[LOW + i] = lanes[PASSED + i] if is_after else extremum
    lanes[HIGH + i] = extremum if is_after else extremum + quarter
    # before they are closest, or rather would be: at a larger q, for it runs back in time
    guess = lanes[Q + i] - step + math.sqrt(max(step * step - 2.0 * gap / bend, 0.0))
    lanes[GUESS + i] = guess if is_after else 0.0


@compiled
def guessed_meeting(contact: Viscoelastic, i: int, lanes: FloatArray) -> float:
    """Return about the q at which spring and cap meet in lane i.

    Both as parabolas: the cap about where it has fallen to the amplitude, the spring about its
    extremum.
    """
    omega, amplitude = lanes[OMEGA + i], lanes[AMPLITUDE + i]
    slope, bend = lanes[FALL_SLOPE + i], lanes[FALL_BEND + i]
    extremum = lanes[EXTREMUM + i]
    apart = lanes[FALL_TIME + i] - extremum
    above = max(amplitude - contact.peak, 0.0)
    after = after_extremum(omega, amplitude, slope, bend, apart, above)
    time = within(extremum - after, max(lanes[LOW + i], 1e-12), lanes[HIGH + i])
    return guessed_place(contact, True, time)
