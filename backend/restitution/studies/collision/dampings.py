"""Collisions with an η each, sorted by it: what follows them takes one η at a time."""

import numpy as np
import numpy.typing as npt

from restitution.errors import CostError
from restitution.mechanics.hertz import FloatArray

MOST_DAMPINGS = 2000
"""Different η > 0 in one request: at 0.05 ms each, 1.2 ms at worst, two seconds at most."""


def refuse_more_dampings(count: int) -> None:
    """Raise `CostError` for more than `MOST_DAMPINGS` different η."""
    if count > MOST_DAMPINGS:
        raise CostError(
            f"{count:,} different values of damping in one request are more than "
            f"{MOST_DAMPINGS:,}, the limit: each needs a normal motion of its own"
        )


def by_damping(damping: FloatArray) -> list[tuple[float, npt.NDArray[np.intp]]]:
    """Return each different η of `damping` (N,), rising, with the places that have it, rising.

    Examples
    --------
    >>> [(eta, places.tolist()) for eta, places in by_damping(np.array([0.3, 0.0, 0.3]))]
    [(0.0, [1]), (0.3, [0, 2])]
    """
    different, group = np.unique(damping, return_inverse=True)
    order = np.argsort(group, kind="stable")
    parts = np.split(order, np.cumsum(np.bincount(group))[:-1])
    return list(zip(different.tolist(), parts, strict=True))
