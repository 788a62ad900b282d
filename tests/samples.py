"""Collisions to look at: drawn at random, and where the number of switches changes."""

import math

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import collide

FloatArray = npt.NDArray[np.float64]


def log_uniform(random: np.random.Generator, low: float, high: float, count: int) -> FloatArray:
    return np.exp(random.uniform(math.log(low), math.log(high), count))


def borders(
    kappa: FloatArray, low: FloatArray, high: FloatArray, halvings: int, damping: float = 0.0
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return κ and two ψ (N,) of another number of switches, brought together by halving.

    Of the given ones those that have another number of switches at `low` than at `high`.
    """
    below, above = (collide(kappa, psi, damping).switches for psi in (low, high))
    kappa, low, high, below = (a[below != above] for a in (kappa, low, high, below))
    for _ in range(halvings):
        middle = np.sqrt(low * high)
        same = collide(kappa, middle, damping).switches == below
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return kappa, low, high
