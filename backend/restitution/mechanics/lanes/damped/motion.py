"""The damped normal motion in lanes, see `damped.motion`."""

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import Viscoelastic, cap_rate, damped_motion
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.rows import CAP, LOSS, PASSED, ROOT, Q


@compiled
def find_motion(contact: Viscoelastic, falling: bool, count: int, lanes: FloatArray) -> None:
    """Fill the rows of the motion of `count` lanes at their q, all in one half."""
    # here it is the four columns that a processor takes at once
    for i in range(count):
        root, cap, loss, passed = damped_motion(contact, falling, lanes[Q + i])
        lanes[ROOT + i], lanes[CAP + i] = root, cap
        lanes[LOSS + i], lanes[PASSED + i] = loss, passed


@compiled
def arrive(
    i: int, lanes: FloatArray, contact: Viscoelastic, falling: bool, rate: float, step: float
) -> None:
    """Put lane i at q − `step`, with its motion by Taylor's series from that at q."""
    a, b = contact.a, contact.b
    root, cap = lanes[ROOT + i], lanes[CAP + i]
    square = root * root
    growing = cap_rate(a, b, root, rate, cap)
    # growing once more
    bend = 2.0 * a * (rate * rate - 2.0 * square * root * cap)
    bend -= 2.0 * b * root * (2.0 * rate * cap + root * growing)
    taking = 2.0 * square * cap
    # in τ, which runs backwards from the end of the contact
    back = -step if falling else step
    lanes[Q + i] -= step
    lanes[ROOT + i] = root - back * (rate + 0.5 * back * taking)
    lanes[CAP + i] = cap - back * (growing - 0.5 * back * bend)
    lanes[LOSS + i] -= step * (taking - back * root * (2.0 * rate * cap + root * growing))
    lanes[PASSED + i] -= step * (2.0 * root - back * rate)
