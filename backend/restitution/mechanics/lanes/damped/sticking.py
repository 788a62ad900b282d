"""Sticking in damped lanes, from the falling cap to the next one on the other side."""

import math

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import (
    Viscoelastic,
    cap_slopes,
    guessed_place,
    rate_at,
)
from restitution.mechanics.damped.sticking import gap_of, guessed_next_cap
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.damped.motion import arrive, find_motion
from restitution.mechanics.lanes.elementary import arctangent, within
from restitution.mechanics.lanes.first_sticking import CLOSE
from restitution.mechanics.lanes.rows import (
    BEGIN,
    CAP,
    DOUBT,
    FORCE,
    HIGH,
    KAPPA,
    LOSS,
    LOW,
    OMEGA,
    PASSED,
    PULL,
    REACH,
    ROOT,
    SIDE,
    TOWARDS,
    Q,
)
from restitution.mechanics.lanes.sticking import spring_after
from restitution.mechanics.roots import SHORT, halley, is_last


@compiled
def stick_from_fall(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from the falling cap to the next one, on the other side, after z = 0."""
    a, b, end = contact.a, contact.b, contact.falling_end
    for i in range(count):
        omega, kappa = lanes[OMEGA + i], lanes[KAPPA + i]
        root, cap, loss = lanes[ROOT + i], lanes[CAP + i], lanes[LOSS + i]
        slope, _, _ = cap_slopes(a, b, root, rate_at(contact, True, loss), cap)
        force = root * cap
        speed = -0.5 * slope / root / kappa if kappa > 1.0 else max(lanes[REACH + i] - loss, 0.0)
        # seen from the side to which the spring goes
        lanes[FORCE + i] = -force
        lanes[PULL + i] = omega * speed
        lanes[BEGIN + i] = lanes[PASSED + i]
        lanes[SIDE + i] = -lanes[SIDE + i]
        lanes[HIGH + i] = lanes[PASSED + i] - arctangent(force, omega * speed) / omega
        lanes[LOW + i] = lanes[HIGH + i] - 0.5 * math.pi / omega
    for i in range(count):
        begin, zero = lanes[BEGIN + i], lanes[HIGH + i]
        left = guessed_next_cap(lanes[OMEGA + i], begin, -lanes[FORCE + i], lanes[PULL + i], zero)
        lanes[Q + i] = within(guessed_place(contact, True, left), 0.0, end)
    meet_in_bracket(contact, count, lanes)


@compiled
def meet_in_bracket(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from a guess to where the spring meets the falling cap."""
    end = contact.falling_end
    for _ in range(3):
        find_motion(contact, True, count, lanes)
        for i in range(count):
            rate = rate_at(contact, True, lanes[LOSS + i])
            spring, moving = spring_after(i, lanes, lanes[BEGIN + i] - lanes[PASSED + i])
            gap, first, second = gap_in_lane(contact, i, lanes, rate, spring, moving)
            # q runs back in time
            step, _ = halley(gap, -first, second)
            lanes[Q + i] = within(lanes[Q + i] - step, 0.5 * lanes[Q + i], end)
    find_motion(contact, True, count, lanes)
    for i in range(count):
        rate = rate_at(contact, True, lanes[LOSS + i])
        spring, moving = spring_after(i, lanes, lanes[BEGIN + i] - lanes[PASSED + i])
        gap, first, second = gap_in_lane(contact, i, lanes, rate, spring, moving)
        step, change = halley(gap, -first, second)
        passed = lanes[PASSED + i]
        is_within = passed > lanes[LOW + i] + CLOSE and passed < lanes[HIGH + i] - CLOSE
        is_meeting = is_within and is_overtaking(first, second, spring)
        lanes[DOUBT + i] += 0.0 if is_meeting else 1.0
        meet_cap(i, lanes, -1.0, rate, step, change, spring, moving)
        arrive(i, lanes, contact, True, rate, step)


@compiled
def is_overtaking(first: float, second: float, spring: float) -> bool:
    """Return whether the spring overtakes the cap, from the derivatives of P − κz by τ.

    Not if it all but touches it: there both differ by rounding alone, and a step of 0 says nothing.
    """
    return first < 0.0 and first * first > 2.0 * CLOSE * abs(second * spring)


@compiled
def gap_in_lane(
    contact: Viscoelastic, i: int, lanes: FloatArray, rate: float, spring: float, moving: float
) -> tuple[float, float, float]:
    """Return `gap_of` for lane i."""
    root, cap = lanes[ROOT + i], lanes[CAP + i]
    return gap_of(contact, lanes[OMEGA + i], root, cap, rate, spring, moving)


@compiled
def meet_cap(
    i: int,
    lanes: FloatArray,
    sense: float,
    rate: float,
    step: float,
    change: float,
    spring: float,
    moving: float,
) -> None:
    """Give lane i the velocity at q − `step`, by Taylor's series from κz and κu/ω at q."""
    omega = lanes[OMEGA + i]
    phase = sense * omega * (2.0 * lanes[ROOT + i] - sense * rate * step) * step
    lanes[TOWARDS + i] = (moving + phase * (spring - 0.5 * phase * moving)) / omega
    is_there = is_last(lanes[Q + i], step, change) and abs(phase) <= SHORT
    lanes[DOUBT + i] += 0.0 if is_there else 1.0
