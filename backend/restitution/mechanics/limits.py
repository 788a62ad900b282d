"""Closed forms: Coulomb's law, the weak, the soft and the stiff limit, and where they hold.

Every function broadcasts. κ is that of Eq. 24, with α in it; ψ = (α/μ)(g_t/g_n).
"""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled
from restitution.mechanics.elastic import sharp_stiff_bound as _sharp_stiff_bound
from restitution.mechanics.elastic import stiff_bound as _stiff_bound
from restitution.mechanics.hertz import CONTACT_DURATION, FloatArray
from restitution.mechanics.switching import slip_extremum, slip_reach

STIFF_ASYMPTOTE = 4.4848
"""lim max |ε_t| ψ κ^{5/4} for κ → ∞, ψ < 2; measured in docs/model.md."""

FROM_TWO_ON = 0.5701024
"""κ from which on every collision with ψ ≥ 2 slides throughout: ψ* is 2 from 0.57010238 on."""

SLIDING_BOUND = 1e-15
"""Rounding error of 1 − 2/ψ, twice over."""

GEAR_WHEEL_STIFFNESS = (np.pi / CONTACT_DURATION) ** 2
"""Smallest κ with ε_t = −1 for ψ → 0: half a swing of the spring lasts as long as the contact."""


def _broadcast(kernel: Callable[..., None], *arguments: npt.ArrayLike) -> FloatArray:
    """Return what `kernel` fills its last argument (N,) with, in the common shape of the others."""
    arrays = np.broadcast_arrays(*(np.asarray(a, dtype=float) for a in arguments))
    values = np.empty(arrays[0].size)
    # copies, for numba warns of arrays that were broadcast
    kernel(*(np.array(array, order="C").ravel() for array in arrays), values)
    return values.reshape(arrays[0].shape)


@compiled
def _sliding(psi: float, epsilon_n: float) -> float:
    return 1.0 - (1.0 + epsilon_n) / psi


@compiled
def _sliding_each(psi: FloatArray, epsilon_n: FloatArray, epsilon_t: FloatArray) -> None:
    for i in range(psi.size):
        epsilon_t[i] = _sliding(psi[i], epsilon_n[i])


def sliding_restitution(psi: npt.ArrayLike, epsilon_n: npt.ArrayLike = 1.0) -> FloatArray:
    """Return ε_t of a contact that slides throughout, 1 − (1 + ε_n)/ψ (Eq. 15)."""
    return _broadcast(_sliding_each, psi, epsilon_n)


def coulomb_restitution(
    psi: npt.ArrayLike, epsilon_n: npt.ArrayLike = 1.0, floor: float = 0.0
) -> FloatArray:
    """Return Coulomb's law cut off at `floor`.

    0 gives Eq. 16; another ε₀ in [−1, 1] the pragmatic model of event-driven codes, for which the
    paper argues ε₀ = 0.
    """
    return np.asarray(np.maximum(floor, sliding_restitution(psi, epsilon_n)))


@compiled
def threshold_of_sliding(kappa: float) -> float:
    """Return ψ*(κ) of one κ; see `sliding_threshold`."""
    if kappa >= FROM_TWO_ON:
        return 2.0
    return max(2.0, slip_reach(kappa, slip_extremum(kappa)) / kappa)


@compiled
def _sliding_thresholds(kappa: FloatArray, threshold: FloatArray) -> None:
    for i in range(kappa.size):
        threshold[i] = threshold_of_sliding(kappa[i])


def sliding_threshold(kappa: npt.ArrayLike) -> FloatArray:
    """Return ψ*(κ), from which on the contact slides throughout and Eq. 15 is exact.

    2 for κ ≥ 0.570102; below, the largest 1 − ẋ + (3/2κ)√x ẋ of the compression, which tends to
    1.0318/κ for κ → 0 (infinite where that overflows). The paper's vertical line in Fig. 4.
    """
    return _broadcast(_sliding_thresholds, kappa)


def weak_limit(kappa: npt.ArrayLike) -> FloatArray:
    """Return lim ε_t for ψ → 0, cos(√κ t_c): the spring swings freely.

    The correction is of order (ψκ^{5/4})^{2/3}.
    """
    return np.asarray(np.cos(np.sqrt(np.asarray(kappa, dtype=float)) * CONTACT_DURATION))


def soft_limit(kappa: npt.ArrayLike) -> FloatArray:
    """Return ε_t to first order in κ for κ → 0, κψ ≪ 1: 1 − κ t_c²/2."""
    return np.asarray(1.0 - 0.5 * CONTACT_DURATION**2 * np.asarray(kappa, dtype=float))


@compiled
def _bound(kappa: float, psi: float) -> float:
    return _stiff_bound(kappa, psi) if psi < 2.0 else np.nan


@compiled
def _stiff_bounds(kappa: FloatArray, psi: FloatArray, bound: FloatArray) -> None:
    for i in range(kappa.size):
        bound[i] = _bound(kappa[i], psi[i])


def stiff_bound(kappa: npt.ArrayLike, psi: npt.ArrayLike) -> FloatArray:
    """Return min(1, (5/4)^{3/5}/(ψ√κ)) ≥ |ε_t|; NaN for ψ ≥ 2, about which it says nothing.

    Notes
    -----
    Once the surfaces have stopped, the energy is at most that of the spring at the largest cap
    (Eq. 25). The paper's Eq. 27 has 1 for (5/4)^{3/5} = x_max^{3/2} and is exceeded by 12 %.
    """
    return _broadcast(_stiff_bounds, kappa, psi)


@compiled
def _stiff_limits(
    kappa: FloatArray, psi: FloatArray, epsilon_t: FloatArray, bound: FloatArray
) -> None:
    for i in range(kappa.size):
        k, p = kappa[i], psi[i]
        epsilon_t[i] = 0.0
        if p < 2.0:
            bound[i] = _sharp_stiff_bound(k, p)
        elif p >= threshold_of_sliding(k):
            epsilon_t[i], bound[i] = 1.0 - 2.0 / p, SLIDING_BOUND
        else:
            bound[i] = 1.0


def stiff_limit(kappa: FloatArray, psi: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return what is known of ε_t of collisions (N,) without following them, and its error bound.

    1 − 2/ψ where the contact slides throughout. Below ψ = 2, 0 within the smaller of `stiff_bound`
    and, from κ = 1.56846 on, 4.48485 κ^{-5/4}/ψ. Between 2 and ψ*(κ), 0 within 1.
    """
    epsilon_t, bound = np.empty(kappa.shape), np.empty(kappa.shape)
    _stiff_limits(kappa, psi, epsilon_t, bound)
    return epsilon_t, bound


def stiff_estimate(kappa: npt.ArrayLike, psi: npt.ArrayLike) -> FloatArray:
    """Return the paper's estimate of |ε_t|, 1/(ψ√κ) (Eq. 27), made for 1/√κ ≤ ψ ≤ 2."""
    with np.errstate(over="ignore"):
        return np.asarray(1.0 / np.sqrt(np.asarray(kappa, dtype=float)) / np.asarray(psi))


@compiled
def _asymptote(kappa: float, psi: float) -> float:
    half_power = kappa**-0.625
    # in two halves, between which a small ψ makes up for a large κ
    return STIFF_ASYMPTOTE * half_power / psi * half_power if psi < 2.0 else np.nan


@compiled
def _asymptotes(kappa: FloatArray, psi: FloatArray, asymptote: FloatArray) -> None:
    for i in range(kappa.size):
        asymptote[i] = _asymptote(kappa[i], psi[i])


def stiff_asymptote(kappa: npt.ArrayLike, psi: npt.ArrayLike) -> FloatArray:
    """Return the largest |ε_t| for κ → ∞, 4.4848 κ^{-5/4}/ψ; NaN for ψ ≥ 2.

    The last free swing ends about 1/√κ before the contact does.
    """
    return _broadcast(_asymptotes, kappa, psi)


@compiled
def simple_laws(
    kappa: float, psi: float, epsilon_n: float, damped: bool
) -> tuple[float, float, float]:
    """Return `coulomb_restitution`, `stiff_bound` and `stiff_asymptote` of one collision.

    The stiff limits are made for η = 0: NaN for one that is damped.
    """
    coulomb = max(0.0, _sliding(psi, epsilon_n))
    if damped:
        return coulomb, np.nan, np.nan
    return coulomb, _bound(kappa, psi), _asymptote(kappa, psi)


def largest_switch_count(kappa: npt.ArrayLike) -> FloatArray:
    """Return the largest number of switches for κ → ∞, √κ t_c/π."""
    return np.asarray(np.sqrt(np.asarray(kappa, dtype=float)) * CONTACT_DURATION / np.pi)
