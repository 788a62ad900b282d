"""The first guesses of lanes, fitted anew: `python tests/mechanics/fit_guesses.py` prints them.

A guess only has to be good enough for Halley's steps: another fit gives other coefficients and the
same answers.
"""

import numpy as np
import numpy.typing as npt

from restitution.mechanics.hertz import HALF_CONTACT_ROOT, normal_motion
from restitution.mechanics.switching import (
    MONOTONE_STIFFNESS,
    slip_extremum,
    sticking_end_in_decompression,
)

FloatArray = npt.NDArray[np.float64]


def fall_ratio() -> FloatArray:
    """Coefficients of q/√x in powers of |ẋ|, the highest first."""
    q = np.linspace(1e-3, HALF_CONTACT_ROOT, 4000)
    root, loss = np.array([normal_motion(each) for each in q]).T
    fit = np.polynomial.Chebyshev.fit(1.0 - loss, q / root, 8, domain=[0.0, 1.0])
    return fit.convert(kind=np.polynomial.Polynomial).coef[::-1]


def phases() -> FloatArray:
    """Rows: phase until z = 0 would be met at the end, q⁵, and the phase that the spring sticks."""
    rows = []
    omegas = [np.linspace(0.3, 1.25, 40), np.linspace(1.2525, 10, 60), np.geomspace(10, 330, 40)]
    for omega in np.concatenate(omegas):
        kappa = omega**2
        # R rises there: a soft spring begins to stick no nearer to the middle
        soft = kappa < MONOTONE_STIFFNESS
        end = 0.999 * slip_extremum(kappa) if soft else 0.998 * HALF_CONTACT_ROOT
        for q in np.linspace(0.02, end, 80):
            root, loss = normal_motion(q)
            met, _ = sticking_end_in_decompression(omega, q, 1.5 * root * (1.0 - loss) / kappa)
            if met > 0.0:
                rows.append((omega * q**2, q**5, omega * (q**2 - met**2)))
    return np.array(rows).T


def guessed_phase() -> FloatArray:
    """Coefficients [power of q⁵][power of m, the highest first], m = (1 + phase)^{-1/2}."""
    phase, fifth, stuck = phases()
    powers = np.polynomial.polynomial.polyvander2d(1.0 / np.sqrt(1.0 + phase), fifth, [8, 3])
    share = phase / (phase + 3.0)
    weight = share * (1.0 + 0.3 / phase)
    fit, *_ = np.linalg.lstsq(powers * weight[:, None], stuck / share * weight, rcond=None)
    return fit.reshape(9, 4).T[:, ::-1]


if __name__ == "__main__":
    print("first_sticking.fall_ratio", fall_ratio().tolist())
    for name, row in zip(("constant", "linear", "square", "cube"), guessed_phase(), strict=True):
        print("sticking.guessed_phase", name, row.tolist())
