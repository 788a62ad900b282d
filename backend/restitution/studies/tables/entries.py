"""The collisions that a table is made from and judged by."""

from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import PART, collide
from restitution.mechanics.hertz import FloatArray
from restitution.methods.exact import DEARER_BY_DAMPING, seconds_to_follow
from restitution.studies.tables.grid import DIGITS, IntegerArray, Nodes

SECONDS_FOR_A_COLLISION = 5e-7
"""At least, without damping."""

SECONDS_FOR_DAMPING, SECONDS_FOR_TENFOLD = 6e-5, 4e-5
"""To prepare the normal motion of one η ≤ 1, and for each power of ten above: 1.2 ms at 1e30."""


class Followed(NamedTuple):
    """Of collisions (N,)."""

    epsilon_t: FloatArray
    """In the paper's sign."""
    error_bound: FloatArray
    seconds: FloatArray
    """Of one core that each took, about, counted in switches and normal motions."""


def seconds_for_motion(eta: float) -> float:
    """Return the seconds of one core that preparing the normal motion of one η takes, about."""
    if not eta > 0.0:
        return 0.0
    return SECONDS_FOR_DAMPING + SECONDS_FOR_TENFOLD * max(0.0, float(np.log10(eta)))


def seconds_for_collisions(
    kappa: FloatArray, psi: FloatArray, damping: float, switches: npt.NDArray[Any]
) -> FloatArray:
    """Return the seconds of one core that each of collisions (N,) takes, about.

    `switches` (N,) as of `exact.seconds_to_follow`.
    """
    least = SECONDS_FOR_A_COLLISION * (DEARER_BY_DAMPING if damping else 1.0)
    return np.maximum(least, seconds_to_follow(kappa, psi, damping, switches))


def follow_all(
    eta: FloatArray, psi: FloatArray, kappa: FloatArray, threads: ThreadPoolExecutor | None
) -> Followed:
    """Return what comes out of collisions (N,).

    It is done in the calling thread unless there are others.
    """
    found = Followed(*np.empty((3, eta.size)))
    # of each η the normal motion is prepared, so that they come together
    order = np.argsort(eta, kind="stable")
    borders = [0, *(np.flatnonzero(np.diff(eta[order])) + 1).tolist(), eta.size]

    def fill(part: IntegerArray) -> None:
        damping = float(eta[part[0]])
        done = collide(kappa[part], psi[part], damping)
        found.epsilon_t[part], found.error_bound[part] = done.epsilon_t, done.error_bound
        seconds = seconds_for_collisions(kappa[part], psi[part], damping, done.switches)
        found.seconds[part] = seconds + seconds_for_motion(damping) / part.size

    # no more at a time than `collide` leaves to the calling thread
    parts = [
        order[i : min(i + PART, end)]
        for begin, end in pairwise(borders)
        for i in range(begin, end, PART)
    ]
    for _ in threads.map(fill, parts) if threads and len(parts) > 1 else map(fill, parts):
        pass
    return found


def tabulate(nodes: Nodes, threads: ThreadPoolExecutor | None) -> tuple[FloatArray, float]:
    """Return ε_t [η][ψ][κ] in the paper's sign, rounded, and the seconds that it took, about."""
    eta, psi, kappa = (each.ravel() for each in np.meshgrid(*nodes.values, indexing="ij"))
    found = follow_all(eta, psi, kappa, threads)
    shape = [values.size for values in nodes.values]
    return np.round(found.epsilon_t, DIGITS).reshape(shape), float(found.seconds.sum())
