"""What collisions depend on of their velocities: ψ, and κ and η of the same bodies."""

import math

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import FloatArray

SMALLEST = 5e-324
"""The smallest positive double."""

WEAKEST = 1e-100
"""ψ below which ε_t, the switches and u/ψ no longer depend on it, to double precision.

The difference to the limit ψ → 0 is of order (ψκ^{5/4})^{2/3}: below 1e-16 for κ < 1e60. Raising
a smaller ψ to this one keeps every intermediate quantity clear of underflow."""


@compiled
def psi_of(mu_over_alpha: float, gt_over_gn: float) -> float:
    """Return ψ of one collision; see `scaled_velocity`."""
    psi = gt_over_gn / mu_over_alpha if mu_over_alpha > 0.0 else math.inf
    return SMALLEST if psi == 0.0 and gt_over_gn > 0.0 else psi


@compiled
def _scaled_velocities(mu_over_alpha: FloatArray, gt_over_gn: FloatArray, psi: FloatArray) -> None:
    for i in range(psi.size):
        psi[i] = psi_of(mu_over_alpha[i], gt_over_gn[i])


def scaled_velocity(mu_over_alpha: npt.ArrayLike, gt_over_gn: npt.ArrayLike) -> FloatArray:
    """Return ψ = (g_t/g_n)/(μ/α), broadcast.

    Infinite for μ = 0 and where it overflows, 0 for g_t = 0 only: a positive quotient that
    underflows is the smallest positive double, which has the same ε_t.
    """
    frictions, tangentials = np.broadcast_arrays(
        np.asarray(mu_over_alpha, dtype=np.float64), np.asarray(gt_over_gn, dtype=np.float64)
    )
    psi = np.empty(frictions.size)
    # copies, for numba warns of arrays that were broadcast
    frictions, tangentials = np.array(frictions, order="C"), np.array(tangentials, order="C")
    _scaled_velocities(frictions.ravel(), tangentials.ravel(), psi)
    return psi.reshape(frictions.shape)


@compiled
def after_flight(
    kappa: float, gt_over_gn: float, damping: float, epsilon_n: float, epsilon_t: float
) -> tuple[float, float, float]:
    """Return κ, g_t/g_n and η of a ball that falls back onto a wall, from those of its collision.

    It comes back with ε_n g_n and ε_t g_t, for gravity acts along the normal alone. κ ∝ g_n^{-2/5}
    (Eq. 24), η ∝ g_n^{1/5}; exactly as they were where ε_n is 1.
    """
    slower = epsilon_n**0.2
    tangential = abs(epsilon_t) * gt_over_gn
    return kappa / (slower * slower), tangential / epsilon_n, damping * slower
