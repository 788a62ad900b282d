"""From the touch to the cap in damped lanes: a damped cap rises as √t, the spring's force as t.

So the first episode is sticking, and it mostly ends early in the rising half. The springs that do
not meet the cap there are looked at once more (`first_sticking`).
"""

import math

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import Viscoelastic, rate_at
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.damped.motion import arrive, find_motion
from restitution.mechanics.lanes.damped.sticking import gap_in_lane, is_overtaking, meet_cap
from restitution.mechanics.lanes.elementary import within
from restitution.mechanics.lanes.first_sticking import CLOSE
from restitution.mechanics.lanes.rows import (
    BEGIN,
    DOUBT,
    FORCE,
    KAPPA,
    LOSS,
    OMEGA,
    PASSED,
    PSI,
    PULL,
    SIDE,
    Q,
)
from restitution.mechanics.lanes.sticking import spring_after
from restitution.mechanics.roots import halley


@compiled
def stick_from_touch(contact: Viscoelastic, count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from the touch to where the spring first meets the cap."""
    end = contact.rising_end
    for i in range(count):
        lanes[FORCE + i] = 0.0
        lanes[PULL + i] = lanes[OMEGA + i] * lanes[PSI + i]
        lanes[BEGIN + i] = 0.0
        lanes[SIDE + i] = 1.0
        guess = guessed_meeting(contact, lanes[KAPPA + i], lanes[KAPPA + i] * lanes[PSI + i])
        lanes[Q + i] = within(guess, 0.0, end)
    for _ in range(2):
        find_motion(contact, False, count, lanes)
        for i in range(count):
            rate = rate_at(contact, False, lanes[LOSS + i])
            spring, moving = spring_after(i, lanes, lanes[PASSED + i])
            gap, first, second = gap_in_lane(contact, i, lanes, rate, spring, moving)
            step, _ = halley(gap, first, second)
            lanes[Q + i] = within(lanes[Q + i] - step, 0.5 * lanes[Q + i], end)
    find_motion(contact, False, count, lanes)
    for i in range(count):
        rate = rate_at(contact, False, lanes[LOSS + i])
        spring, moving = spring_after(i, lanes, lanes[PASSED + i])
        gap, first, second = gap_in_lane(contact, i, lanes, rate, spring, moving)
        step, change = halley(gap, first, second)
        # docs/model.md, "Events with damping", Sticking 4: once in the first half-swing, if at all
        phase = lanes[OMEGA + i] * lanes[PASSED + i]
        is_first = is_overtaking(first, second, spring) and phase < (1.0 - CLOSE) * math.pi
        # at its extremum `follow` looks, and is not sure of what is there
        is_clear = abs(phase - 0.5 * math.pi) > CLOSE and lanes[Q + i] < (1.0 - CLOSE) * end
        lanes[DOUBT + i] += 0.0 if is_first and is_clear else 1.0
        meet_cap(i, lanes, 1.0, rate, step, change, spring, moving)
        arrive(i, lanes, contact, False, rate, step)


@compiled
def guessed_meeting(contact: Viscoelastic, kappa: float, load: float) -> float:
    """Return about the q where P = κz for short times; `load` is κψ."""
    a, b = contact.a, contact.b
    # P = bq + aq³ and κz = κψq²
    q = 2.0 * b / (load + math.sqrt(max(0.0, load * load - 4.0 * a * b)))
    q = min(q, contact.rising_end)
    bent = 2.0 / 3.0 * b * b
    for _ in range(2):
        square = q * q
        turn = kappa * square * square / 6.0
        value = b + square * (a - bent * q) - load * q * (1.0 - turn)
        slope = q * (2.0 * a - 3.0 * bent * q) - load * (1.0 - 5.0 * turn)
        q -= value / slope
    return q
