"""Sliding in damped lanes: where κL + |dP/dt| is κ times what is to be spent.

L is the velocity spent or, in the falling half, yet to be spent. As in `damped.sliding` both
sides are multiplied by 2R, so that the equation stays finite at the touch.
"""

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import (
    STEP,
    Viscoelastic,
    cap_slopes,
    damped_motion,
    rate_at,
)
from restitution.mechanics.damped.sliding import excess_of
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.damped.motion import arrive, find_motion
from restitution.mechanics.lanes.elementary import within
from restitution.mechanics.lanes.rows import (
    AMPLITUDE,
    CAP,
    DOUBT,
    GAP,
    HIGH,
    KAPPA,
    LEAD,
    LOSS,
    LOW,
    REACH,
    ROOT,
    Q,
)
from restitution.mechanics.roots import halley, is_last

SLIP = AMPLITUDE
"""κ times the velocity with which sliding begins in the rising half."""

VALUE_LOW, VALUE_HIGH = GAP, LEAD
"""κL + |dP/dt| less what it must be, at the q in `LOW` and `HIGH`."""


@compiled
def slide(contact: Viscoelastic, falling: bool, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes to where sliding ends in one half: `REACH` is what is spent there.

    In the rising half it began at `Q`, in the falling one anywhere.
    """
    sense, end = -1.0 if falling else 1.0, contact.falling_end if falling else contact.rising_end
    guess_end(contact, falling, count, lanes)
    for _ in range(2):
        find_motion(contact, falling, count, lanes)
        for i in range(count):
            rate = rate_at(contact, falling, lanes[LOSS + i])
            value, first, second = excess_in_lane(contact, sense, i, lanes, rate)
            step, _ = halley(value, first, second)
            lanes[Q + i] = within(lanes[Q + i] - step, 0.5 * lanes[Q + i], end)
    find_motion(contact, falling, count, lanes)
    for i in range(count):
        rate = rate_at(contact, falling, lanes[LOSS + i])
        value, first, second = excess_in_lane(contact, sense, i, lanes, rate)
        step, change = halley(value, first, second)
        # in the rising half the other root, before sliding began, is one where it falls
        is_there = first > 0.0 and is_last(lanes[Q + i], step, change)
        lanes[DOUBT + i] += 0.0 if is_there else 1.0
        arrive(i, lanes, contact, falling, rate, step)


@compiled
def guess_end(contact: Viscoelastic, falling: bool, count: int, lanes: FloatArray) -> None:
    """Put `count` lanes about where sliding ends.

    On a line between two places, the last where too little is spent and the next one: the middles
    of the pieces, and what is known at both ends.
    """
    sense = -1.0 if falling else 1.0
    end = contact.falling_end if falling else contact.rising_end
    for i in range(count):
        reach = lanes[KAPPA + i] * lanes[REACH + i]
        lanes[LOW + i] = 0.0 if falling else lanes[Q + i]
        lanes[VALUE_LOW + i] = contact.last_slope - reach if falling else -lanes[SLIP + i]
        lanes[HIGH + i], lanes[VALUE_HIGH + i] = 0.0, 1.0
    q = 0.125 * STEP
    while True:
        root, cap, loss, _ = damped_motion(contact, falling, q)
        slope, _, _ = cap_slopes(contact.a, contact.b, root, rate_at(contact, falling, loss), cap)
        rest = 0.5 * sense * slope / root if q < end else 0.0
        for i in range(count):
            value = lanes[KAPPA + i] * (loss - lanes[REACH + i]) + rest
            is_below = value < 0.0 and q > lanes[LOW + i]
            is_next = value >= 0.0 and q > lanes[LOW + i] and lanes[HIGH + i] == 0.0
            lanes[LOW + i] = q if is_below else lanes[LOW + i]
            lanes[VALUE_LOW + i] = value if is_below else lanes[VALUE_LOW + i]
            lanes[HIGH + i] = q if is_next else (0.0 if is_below else lanes[HIGH + i])
            lanes[VALUE_HIGH + i] = value if is_next else lanes[VALUE_HIGH + i]
        if q >= end:
            break
        q = min(q + min(0.5 * q, STEP), end)
    for i in range(count):
        share = within(
            lanes[VALUE_LOW + i] / (lanes[VALUE_LOW + i] - lanes[VALUE_HIGH + i]), 0.0, 1.0
        )
        guess = lanes[LOW + i] + share * (lanes[HIGH + i] - lanes[LOW + i])
        lanes[Q + i] = within(guess, 0.0, end)


@compiled
def excess_in_lane(
    contact: Viscoelastic, sense: float, i: int, lanes: FloatArray, rate: float
) -> tuple[float, float, float]:
    """Return `excess_of` for lane i."""
    kappa, reach = lanes[KAPPA + i], lanes[REACH + i]
    root, cap, loss = lanes[ROOT + i], lanes[CAP + i], lanes[LOSS + i]
    return excess_of(contact, sense, kappa, reach, root, cap, loss, rate)
