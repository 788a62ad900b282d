"""ε_t from bicubic patches over the plane of κ and ψ: where the patches lie, and their look-up.

The plane is cut into octaves, an octave into equal patches, a patch into four where that is not
fine enough. Both coordinates are logarithms as a float has them, the exponent and then the
mantissa: a patch is found by shifting bits, without a logarithm.

There are three bands of ψ. Below 1 the coordinate is ψ. From 1 to 2 the ends of the free swings
crowd towards ψ = 2, where the first sliding lasts until the end of the contact: the coordinate is
the distance to 2, shifted by `FLOOR`. From 2 on only κ < 0.570102 has switches, and only for
κψ < `LARGEST_SLIP`: the coordinate is ψ again. Everything else slides throughout.
"""

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import FROM_TWO_ON, SLIDING_BOUND

IntegerArray = npt.NDArray[np.int32]
SingleArray = npt.NDArray[np.float32]

DEGREE = 3
COEFFICIENTS = (DEGREE + 1) ** 2
"""Of one patch: 64 bytes in single precision, a line of the processor's cache."""

KAPPA_OCTAVES = (-7, 10)
"""2^-7 ≤ κ < 2^10."""

BAND_OCTAVES = ((-10, 0), (-12, 0), (1, 7))
"""Of the coordinate of ψ in each band."""

FLOOR = 2.0 ** BAND_OCTAVES[1][0]
"""Smallest coordinate in the band 1 … 2, that of ψ = 2."""

SPAN = (1.0 - FLOOR) * (1.0 - 2.0**-40)
"""Largest coordinate there, that of ψ = 1, less `FLOOR`: it stays below 1."""

PSI_BITS = 2
"""An octave of ψ has 2^2 patches."""

KAPPA_BITS = np.array(
    [
        [2] * 9 + [3] * 2 + [4] * 2 + [5] * 2 + [6] * 2,
        [2] * 9 + [3] * 2 + [4] * 6,
        [2] * 7 + [0] * 10,
    ]
)
"""[band][octave of κ]: an octave has 2^bits patches, for the phase √κ t_c grows with κ. The band
from 2 on ends at κ = 1."""

LARGEST_SLIP = 1.1403
"""κψ from which on collisions with ψ ≥ 2 slide throughout: the largest κψ*, at κ = 0.570102."""

FIRST_COLUMN = np.cumsum(2**KAPPA_BITS, axis=1) - 2**KAPPA_BITS
COLUMNS = np.array([FIRST_COLUMN[0, -1] + 64, FIRST_COLUMN[1, -1] + 16, FIRST_COLUMN[2, 7]])
"""Patches of a band beside each other along κ, before any is divided."""

ROWS = np.array([(high - low) << PSI_BITS for low, high in BAND_OCTAVES])
FIRST_PATCH = np.cumsum(COLUMNS * ROWS) - COLUMNS * ROWS
UNDIVIDED = int(np.sum(COLUMNS * ROWS))

_BIAS = 1023
_FIRST_ROW = np.array([(_BIAS + low) << PSI_BITS for low, _ in BAND_OCTAVES])
_FIRST_OCTAVE = _BIAS + KAPPA_OCTAVES[0]
_MANTISSA = (1 << 52) - 1
_ROW_SHIFT = 52 - PSI_BITS
_FRACTION_SHIFT = 12 + PSI_BITS
_TOP = -(2**63)
_UNIT = 2.0**-63


@compiled
def look_up(
    kappa: FloatArray,
    psi: FloatArray,
    division: IntegerArray,
    patches: SingleArray,
    bounds: SingleArray,
    epsilon_t: FloatArray,
    error_bound: FloatArray,
) -> None:
    """Fill the last two arrays (N,) for the parameters in the first two.

    Parameters
    ----------
    kappa, psi : ndarray, shape (N,)
        2^-7 … 2^10; 2^-10 … ∞.
    division : ndarray of int, shape (M,)
        First the `UNDIVIDED` patches, row by row, band by band. The number of a patch, or −i if it
        is divided into the four at i, i + 1 (larger ψ coordinate), i + 2 (larger κ), i + 3.
    patches : ndarray, shape (P, 16)
        Coefficients [a 4 + b] of Y^a X^b, X and Y from −1 to 1 across the patch.
    bounds : ndarray, shape (P,)
        Bounds on the error.
    """
    for i in range(kappa.size):
        k, p = np.float64(kappa[i]), np.float64(psi[i])
        if p >= 2.0 and (k >= FROM_TWO_ON or k * p >= LARGEST_SLIP):
            epsilon_t[i], error_bound[i] = 1.0 - 2.0 / p, SLIDING_BOUND
            continue
        band = 0 if p < 1.0 else (1 if p < 2.0 else 2)
        coordinate = np.float64(FLOOR + (2.0 - p) * SPAN if band == 1 else p)
        along, across = k.view(np.int64), coordinate.view(np.int64)
        octave = (along >> 52) - _FIRST_OCTAVE
        bits = KAPPA_BITS[band, octave]
        column = FIRST_COLUMN[band, octave] + ((along & _MANTISSA) >> (52 - bits))
        row = (across >> _ROW_SHIFT) - _FIRST_ROW[band]
        patch = np.int64(division[FIRST_PATCH[band] + row * COLUMNS[band] + column])
        # what is left of the mantissas, as fractions of the patch: the next bit is the sign
        along <<= 12 + bits
        across <<= _FRACTION_SHIFT
        while patch < 0:
            patch = np.int64(division[-patch + 2 * (along < 0) + (across < 0)])
            along <<= 1
            across <<= 1
        x, y = (along ^ _TOP) * _UNIT, (across ^ _TOP) * _UNIT
        c = patches[patch]
        value = 0.0
        for a in range(DEGREE, -1, -1):
            j = 4 * a
            value = value * y + (((c[j + 3] * x + c[j + 2]) * x + c[j + 1]) * x + c[j])
        epsilon_t[i], error_bound[i] = min(1.0, max(-1.0, value)), bounds[patch]


def undivided() -> tuple[npt.NDArray[np.int64], FloatArray]:
    """Return bands (M,) and edges (M, 4) of the patches before any is divided.

    The edges are the smallest κ, its width, the smallest coordinate of ψ, its width.
    """
    bands, edges = [], []
    for band in range(len(BAND_OCTAVES)):
        octaves = range(*KAPPA_OCTAVES)[: 17 if band < 2 else 7]
        kappa = [
            (2.0**o * (1.0 + i / n), 2.0**o / n)
            for o, bits in zip(octaves, KAPPA_BITS[band], strict=False)
            for i, n in ((i, 2**bits) for i in range(2**bits))
        ]
        n = 2**PSI_BITS
        psi = [
            (2.0**o * (1.0 + j / n), 2.0**o / n)
            for o in range(*BAND_OCTAVES[band])
            for j in range(n)
        ]
        edges += [(*k, *p) for p in psi for k in kappa]
        bands += [band] * (len(psi) * len(kappa))
    return np.array(bands), np.array(edges)


def psi_at(band: npt.NDArray[np.int64], coordinate: FloatArray) -> FloatArray:
    """Return ψ at a coordinate of a band; of the bands' and coordinates' common shape."""
    return np.where(band == 1, 2.0 - (coordinate - FLOOR) / SPAN, coordinate)
