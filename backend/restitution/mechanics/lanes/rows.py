"""The rows of the lanes: one flat array, of which `lanes[KAPPA + i]` is κ of lane i.

In one array with fixed rows a compiler knows that no two of them overlap; of arrays of their own
it would have to make sure before each loop.
"""

import threading

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import FloatArray

Labels = npt.NDArray[np.int64]

BLOCK = 1024
"""Lanes: enough to fill a processor's pipes, and their rows stay in its second cache."""

WIDTH = 8
"""Lanes that a processor takes at once, at most; loops go over a multiple of them."""

ROOM = BLOCK + WIDTH

# For the whole of a collision.
KAPPA = 0 * ROOM
OMEGA = 1 * ROOM
"""√κ."""
PSI = 2 * ROOM
ERROR = 3 * ROOM
"""Bound on the rounding error of the surface velocity."""

# The beginning of an episode.
Q = 4 * ROOM
"""Root of the time to the nearer end of the contact."""
ROOT = 5 * ROOM
"""√x."""
LOSS = 6 * ROOM
"""1 − |ẋ|; with damping the velocity spent or, in the falling half, yet to be spent."""
TOWARDS = 7 * ROOM
"""Surface velocity towards the side of the spring."""
SIDE = 8 * ROOM
"""Sign of the spring, 1 or −1."""
REACH = 9 * ROOM
"""What R must be for sliding to end; with damping, what `LOSS` + |Ṗ|/κ must be."""
DOUBT = 10 * ROOM
"""More than 0 in lanes that leave or, after the touch, have not met the cap."""

# Within an episode of sticking.
FORCE = 11 * ROOM
"""κz where it begins."""
PULL = 12 * ROOM
"""κu/ω there."""
BEGIN = 13 * ROOM
"""Time from there to the end of the contact; 0 in the rising half, where it is the touch."""

# Within the first one, if it begins in the compression.
AMPLITUDE = 14 * ROOM
LEAD = 15 * ROOM
"""Phase from the beginning to the first extremum of κz."""
FALL_ROOT = 16 * ROOM
"""√x where the cap has fallen to the amplitude."""
FALL_RATE = 17 * ROOM
"""|ẋ| there."""
FALL_TIME = 18 * ROOM
"""Time from there to the end of the contact."""
EXTREMUM = 19 * ROOM
"""Time from the extremum next to the meeting to the end of the contact."""
LOW = 20 * ROOM
HIGH = 21 * ROOM
"""Bracket of q at the meeting."""

LARGEST = 11 * ROOM
"""The largest reach of sliding in the compression; of collisions that are not in lanes yet."""

# With damping.
CAP = 22 * ROOM
"""Normal force over √x."""
PASSED = 23 * ROOM
"""Time to the nearer end of the contact."""
NODE = 24 * ROOM
"""Last piece, counted from the end of the contact, in whose middle P is less than the amplitude."""
GAP = 25 * ROOM
"""P − κz where spring and cap are closest."""
PAST = 26 * ROOM
"""Swings of the spring in which it is known not to meet the cap."""

ROWS = 27 * ROOM
"""Size of the array."""

# Rows of whole numbers; the first says which collision is in a lane.
COUNT = 1 * ROOM
"""Switches so far."""
LATE = 2 * ROOM
"""Which collisions wait: their first sliding ends in the decompression."""
LEFT = 3 * ROOM
"""Which have left."""
RESTING = 4 * ROOM
"""Which, with damping, do not meet the cap early."""
LABELS = 5 * ROOM
"""Size of the array."""

_own = threading.local()


def work_space() -> tuple[FloatArray, Labels]:
    """Return the lanes and the labels of this thread, as they were left."""
    if not hasattr(_own, "space"):
        _own.space = np.ones(ROWS), np.zeros(LABELS, np.int64)
    space: tuple[FloatArray, Labels] = _own.space
    return space


@compiled
def whole(count: int) -> int:
    """Return the multiple of `WIDTH` that holds `count` lanes."""
    return (count + WIDTH - 1) // WIDTH * WIDTH


@compiled
def repeat_last(count: int, lanes: FloatArray, row: int) -> None:
    """Fill a row of `count` lanes up with its last one, so that no loop has a rest."""
    for i in range(count, whole(count)):
        lanes[row + i] = lanes[row + count - 1]
