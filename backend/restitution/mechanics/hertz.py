"""The undamped Hertz contact: one universal curve of compression against time.

Lengths, times and velocities are scaled by ξ_scale = g_n^{4/5} β^{-2/5}, t_scale = β^{-2/5}
g_n^{-1/5} and g_n (Eq. 21), so that ẍ + x^{3/2} = 0 with x(0) = 0, ẋ(0) = 1 (Eqs. 22, 23).

The curve is mirror symmetric about half the contact. Both halves are written in q = √t, t being
the time since the start or the time left: √x/q and (1 − |ẋ|)/q⁵ are analytic in q⁵, and neither
end of the contact loses a digit. 1 − |ẋ| is computed as it stands, never as a difference.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled

FloatArray = npt.NDArray[np.float64]

CONTACT_DURATION = 3.2180654597190430846
"""t_c = (4/5)^{3/5} B(2/5, 1/2), scaled by t_scale; Eq. 20 with its number C."""

HALF_CONTACT = 0.5 * CONTACT_DURATION
HALF_CONTACT_ROOT = 1.2684765389472213421
"""q = √(t_c/2), where the compression is largest."""

MAXIMUM_COMPRESSION = 1.25**0.4
"""x_max = (5/4)^{2/5}, Eq. 19."""

MAXIMUM_FORCE = 1.25**0.6
"""x_max^{3/2} = (5/4)^{3/5}."""

ROOT_SERIES = (
    -1.4416762309797249e-16,
    -1.8313775130300532e-16,
    -3.110569262038695e-14,
    -4.4815179580112504e-13,
    -1.6811404691834909e-11,
    -5.0184635673411853e-11,
    -1.9480936793763718e-8,
    4.5480161360354913e-7,
    -3.5671411430952919e-5,
    1.2244897959200016e-3,
    -0.057142857142857256,
    1.0,
)
LOSS_SERIES = (
    4.7184512079495274e-16,
    -2.8549616602694804e-14,
    1.2708679503167523e-12,
    -5.1678259373177779e-11,
    1.9973472286977422e-9,
    -7.2194652275212761e-8,
    2.4070184413396054e-6,
    -7.1342822833340959e-5,
    1.7959183673448226e-3,
    -0.034285714285714112,
    0.4,
)
"""Of √x/q and (1 − |ẋ|)/q⁵ in powers of q⁵, the highest first."""


class Instant(NamedTuple):
    """The normal motion at one instant, in the units of the contact."""

    falling: bool
    """Whether it is in the half of the contact in which the normal force falls."""
    root: float
    """√x."""
    cap: float
    """The normal force over √x."""
    loss: float
    """What sliding has taken from the surface velocity until then; takes from then on, if
    `falling`."""
    passed: float
    """Time since the start; to the end, if `falling`."""


@compiled
def polynomial(coefficients: tuple[float, ...], x: float) -> float:
    """Return a polynomial by Horner's rule, the coefficient of its highest power first."""
    value = coefficients[0]
    for i in range(1, len(coefficients)):
        value = value * x + coefficients[i]
    return value


@compiled
def normal_motion(q: float) -> tuple[float, float]:
    """Return √x and 1 − |ẋ| at the time q² from the nearer end of the contact.

    Parameters
    ----------
    q : float
        0 … `HALF_CONTACT_ROOT`, the square root of a time scaled by t_scale.

    Returns
    -------
    root_compression : float
        √x, to 2e-16 of its value.
    rate_loss : float
        1 − |ẋ|, to 3e-16 of its value.

    Notes
    -----
    Polynomials in q⁵ that interpolate the inverse of t = (4/5)^{3/5} ∫₀^θ sin^{-1/5}, with
    ẋ = cos θ and (4/5) x^{5/2} = sin²θ; `tests/mechanics/test_hertz.py` holds them against it.
    """
    square = q * q
    w = square * square * q
    return q * polynomial(ROOT_SERIES, w), w * polynomial(LOSS_SERIES, w)
