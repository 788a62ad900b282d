"""The first sticking in lanes, if it begins in the compression: the cap rises, then falls on it.

docs/model.md, "Events without search", Sticking 1 to 3: spring and cap meet in the swing in which
the cap falls below the amplitude, before its extremum or after it.
"""

import math

import numpy as np

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import (
    CONTACT_DURATION,
    HALF_CONTACT,
    HALF_CONTACT_ROOT,
    MAXIMUM_FORCE,
    FloatArray,
    normal_motion,
    polynomial,
)
from restitution.mechanics.lanes.elementary import arctangent, cube_root, sine_and_cosine
from restitution.mechanics.lanes.rows import (
    AMPLITUDE,
    BEGIN,
    DOUBT,
    EXTREMUM,
    FALL_RATE,
    FALL_ROOT,
    FALL_TIME,
    FORCE,
    HIGH,
    KAPPA,
    LEAD,
    LOSS,
    LOW,
    OMEGA,
    PSI,
    PULL,
    ROOT,
    SIDE,
    Q,
)
from restitution.mechanics.lanes.sliding import arrive
from restitution.mechanics.lanes.sticking import meet_cap, spring_after, step_to_cap
from restitution.mechanics.roots import ROUNDING
from restitution.mechanics.switching import MONOTONE_STIFFNESS

FALL_ERROR = 3e-6
"""Of the time at which the cap has fallen to the amplitude: a swing is certain that ends farther
from it."""

FALL_RATIO = (
    0.002687881563974586,
    -0.015620259429567082,
    0.04260996246064673,
    -0.07619735963344404,
    0.10831673592058222,
    -0.14286740462289785,
    0.1976849470382798,
    -0.32972514719203583,
    1.213110646007697,
)
"""Of `fall_ratio`, in powers of |ẋ|, the highest first: `tests/mechanics/fit_guesses.py`."""

CLOSE = 1e-8
"""A comparison is in doubt below it: far beyond what `arctangent` leaves out."""


@compiled
def stick_from_compression(count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from where sliding ended in the compression to the cap that falls."""
    for i in range(count):
        begin_sticking(i, lanes)
    for i in range(count):
        find_fall(i, lanes)
    for i in range(count):
        choose_swing(i, lanes)
    for i in range(count):
        lanes[Q + i] = guessed_meeting(i, lanes)
    for _ in range(3):
        for i in range(count):
            side, q = lanes[SIDE + i], lanes[Q + i]
            root, loss = normal_motion(q)
            spring, moving = spring_after(i, lanes, lanes[BEGIN + i] - q * q)
            step, _ = step_to_cap(lanes[OMEGA + i], q, root, loss, side * spring, side * moving)
            lanes[Q + i] = min(max(q - step, lanes[LOW + i]), lanes[HIGH + i])
    for i in range(count):
        side, q = lanes[SIDE + i], lanes[Q + i]
        root, loss = normal_motion(q)
        spring, moving = spring_after(i, lanes, lanes[BEGIN + i] - q * q)
        step, change = step_to_cap(lanes[OMEGA + i], q, root, loss, side * spring, side * moving)
        meet_cap(i, lanes, q, step, change, side * spring, side * moving)
        arrive(i, lanes, q, root, loss, step)
        doubt_meeting(i, lanes)


@compiled
def begin_sticking(i: int, lanes: FloatArray) -> None:
    """Give lane i its harmonic: κz = `AMPLITUDE` cos(phase − `LEAD`)."""
    q, root = lanes[Q + i], lanes[ROOT + i]
    force = root * root * root
    pull = lanes[OMEGA + i] * (lanes[PSI + i] - lanes[LOSS + i])
    lanes[FORCE + i] = force
    lanes[PULL + i] = pull
    lanes[BEGIN + i] = CONTACT_DURATION - q * q
    lanes[AMPLITUDE + i] = math.sqrt(force * force + pull * pull)
    lanes[LEAD + i] = arctangent(pull, force)


@compiled
def find_fall(i: int, lanes: FloatArray) -> None:
    """Find where the cap has fallen to the amplitude: by energy, ẋ² = 1 − (4/5)x^{5/2}."""
    root = cube_root(lanes[AMPLITUDE + i])
    square = root * root
    energy = 1.0 - 0.8 * square * square * root
    rate = math.sqrt(max(energy, 0.0))
    q = root * fall_ratio(rate) if energy > 0.0 else HALF_CONTACT_ROOT
    lanes[FALL_ROOT + i] = root
    lanes[FALL_RATE + i] = rate
    lanes[FALL_TIME + i] = q * q


@compiled
def fall_ratio(rate: float) -> float:
    """Return q/√x where |ẋ| is `rate`, within 1e-6: a fit to `normal_motion`."""
    return polynomial(FALL_RATIO, rate)


@compiled
def choose_swing(i: int, lanes: FloatArray) -> None:
    """Find the swing of lane i in which spring and cap meet, and a bracket of q.

    The decisions are those of `switching.decompression_bracket`; where one is close, in doubt.
    """
    omega, begin, lead = lanes[OMEGA + i], lanes[BEGIN + i], lanes[LEAD + i]
    force, amplitude = lanes[FORCE + i], lanes[AMPLITUDE + i]
    swings = (omega * (begin - lanes[FALL_TIME + i]) - lead) * (1.0 / math.pi)
    number = np.rint(swings)
    is_close = 0.5 - abs(swings - number) < FALL_ERROR * omega
    # Sticking 1: a stiff one not in the swing in which it begins to stick
    is_stiff = lanes[KAPPA + i] >= MONOTONE_STIFFNESS
    number = max(number, 1.0) if is_stiff else number
    # Sticking 5: a soft one, too, if the cap is below its amplitude throughout
    is_other = amplitude > (1.0 - CLOSE) * MAXIMUM_FORCE and not is_stiff
    extremum = begin - (lead + number * math.pi) / omega
    quarter = 0.5 * math.pi / omega
    # Sticking 2: after the extremum, if the cap is above the amplitude there, and if z = 0 comes
    # too late or the spring is beyond the cap at the mirror time of the beginning
    top = min(max(extremum, 0.0), HALF_CONTACT)
    root, _ = normal_motion(math.sqrt(top))
    is_below = extremum > 0.0 and root * root * root > amplitude
    is_last = extremum <= quarter
    mirror = omega * (2.0 * begin - CONTACT_DURATION) - lead - number * math.pi
    _, cosine = sine_and_cosine(mirror)
    excess = amplitude * cosine - force
    is_beyond = mirror < 0.5 * math.pi and excess >= 0.0
    is_after = is_below and (is_last or is_beyond)
    is_undecided = (
        abs(excess) <= CLOSE * (1.0 + omega) * amplitude or abs(extremum - quarter) <= CLOSE
    )
    # else before the next extremum, Sticking 3
    is_next = is_below and not is_after
    number = number + 1.0 if is_next else number
    extremum = extremum - 2.0 * quarter if is_next else extremum
    lanes[SIDE + i] = 1.0 - 2.0 * (number - 2.0 * np.floor(0.5 * number))
    lanes[EXTREMUM + i] = extremum
    least = 0.0 if is_last else CONTACT_DURATION - begin
    low = least if is_after else max(0.0, extremum)
    high = top if is_after else max(0.0, min(extremum + quarter, HALF_CONTACT))
    lanes[LOW + i] = math.sqrt(low)
    lanes[HIGH + i] = math.sqrt(high)
    doubt = is_close or is_other or (is_below and is_undecided)
    lanes[DOUBT + i] += 1.0 if doubt else 0.0


@compiled
def after_extremum(
    omega: float, amplitude: float, slope: float, bend: float, apart: float, above: float
) -> float:
    """Return about the time from the spring's extremum to where it meets the cap.

    Both as parabolas: the cap with `slope` and `bend` about where it has fallen to the amplitude,
    or is `above` short of it, at the time `apart` before the extremum.
    """
    a = bend + amplitude * omega * omega
    b = bend * apart - slope
    c = (0.5 * bend * apart - slope) * apart - above
    after = (-b - math.sqrt(max(0.0, b * b - 2.0 * a * c))) / a
    # a cosine is flatter than its parabola
    return after * (1.0 + min(omega * omega * after * after, 2.0) / 24.0)


@compiled
def guessed_meeting(i: int, lanes: FloatArray) -> float:
    """Return about the q at which spring and cap meet in lane i.

    Both as parabolas: the cap about where it has fallen to the amplitude, the spring about its
    extremum.
    """
    omega, amplitude = lanes[OMEGA + i], lanes[AMPLITUDE + i]
    root, rate, extremum = lanes[FALL_ROOT + i], lanes[FALL_RATE + i], lanes[EXTREMUM + i]
    square = root * root
    slope = 1.5 * root * rate
    bend = 0.75 * rate * rate / root - 1.5 * square * square
    apart = lanes[FALL_TIME + i] - extremum
    above = max(amplitude - MAXIMUM_FORCE, 0.0)
    after = after_extremum(omega, amplitude, slope, bend, apart, above)
    q = math.sqrt(max(extremum - after, 1e-12))
    inside: float = min(max(q, lanes[LOW + i]), lanes[HIGH + i])
    return inside


@compiled
def doubt_meeting(i: int, lanes: FloatArray) -> None:
    """Put lane i in doubt if it met the cap out of its bracket, or next to z = 0."""
    q, root = lanes[Q + i], lanes[ROOT + i]
    is_within = q >= (1.0 - CLOSE) * lanes[LOW + i] and q <= (1.0 + CLOSE) * lanes[HIGH + i]
    # on which side of z = 0, rounding of the phase would say
    is_clear = (
        root * root * root > 16.0 * ROUNDING * (1.0 + lanes[OMEGA + i]) * lanes[AMPLITUDE + i]
    )
    lanes[DOUBT + i] += 0.0 if is_within and is_clear else 1.0
