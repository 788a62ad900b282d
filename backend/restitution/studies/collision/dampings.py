"""Collisions with an η each, sorted by it: what follows them takes one η at a time."""

import numpy as np
import numpy.typing as npt

from restitution.mechanics.hertz import FloatArray


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
