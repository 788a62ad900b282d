"""Elementary functions in lanes: no branches, and no calls that a processor takes one at a time."""

import math

import numpy as np

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import polynomial

SINE = (
    1.58962301576546568060e-10,
    -2.50507477628578072866e-8,
    2.75573136213857245213e-6,
    -1.98412698295895385996e-4,
    8.33333333332211858878e-3,
    -1.66666666666666307295e-1,
)
COSINE = (
    -1.13585365213876817300e-11,
    2.08757008419747316778e-9,
    -2.75573141792967388112e-7,
    2.48015872888517045348e-5,
    -1.38888888888730564116e-3,
    4.16666666666665929218e-2,
)
"""Of fdlibm: sin r = r + r³ … and cos r = 1 − r²/2 + r⁴ …, in powers of r², for |r| up to π/4."""

ARCTANGENT = (
    -1.0 / 23.0,
    1.0 / 21.0,
    -1.0 / 19.0,
    1.0 / 17.0,
    -1.0 / 15.0,
    1.0 / 13.0,
    -1.0 / 11.0,
    1.0 / 9.0,
    -1.0 / 7.0,
    1.0 / 5.0,
    -1.0 / 3.0,
)
"""Of Taylor's series, atan t = t + t³ …, in powers of t²."""


@compiled
def within(x: float, low: float, high: float) -> float:
    """Return x or the end of the interval that it is beyond; `low` for what is no number."""
    # not min and max, which hand on what is no number
    above = x if x > low else low  # noqa: FURB136
    return above if above < high else high  # noqa: FURB136


@compiled
def sine_and_cosine(phase: float) -> tuple[float, float]:
    """Return both of a phase up to 1e5, within 3e-16."""
    quarter = np.rint(phase * 0.6366197723675814)
    # π/2 in two parts, the first so short that its product is exact
    rest = (phase - quarter * 1.5707963267341256) - quarter * 6.077100506506192e-11
    z = rest * rest
    sine = rest + rest * z * polynomial(SINE, z)
    cosine = 1.0 - 0.5 * z + z * z * polynomial(COSINE, z)
    # odd quarters exchange them, those after a half turn both
    half = np.floor(0.5 * quarter)
    odd = quarter - 2.0 * half
    turned = 1.0 - 2.0 * (half - 2.0 * np.floor(0.5 * half))
    is_odd = odd != 0.0
    first = cosine if is_odd else sine
    second = -sine if is_odd else cosine
    return turned * first, turned * second


@compiled
def cube_root(x: float) -> float:
    """Return the cube root within 1e-8 of it, for x from 1e-12 to 10."""
    fourth = math.sqrt(math.sqrt(x))
    sixteenth = math.sqrt(math.sqrt(fourth))
    # x^{1/4 + 1/16 + 1/64}, and two steps of Halley's
    y = fourth * sixteenth * math.sqrt(math.sqrt(sixteenth))
    for _ in range(2):
        cube = y * y * y
        y = y * (cube + 2.0 * x) / (2.0 * cube + x)
    return y


@compiled
def fifth_root(x: float) -> float:
    """Return the fifth root within 6 % of it, for x from 1e-12 to 10; within 1e-3 from 0.1 on."""
    eighth = math.sqrt(math.sqrt(math.sqrt(x)))
    # x^{1/8 + 1/16}, and a step of Halley's
    y = 0.975 * eighth * math.sqrt(eighth)
    square = y * y
    fifth = square * square * y
    return y * (2.0 * fifth + 3.0 * x) / (3.0 * fifth + 2.0 * x)


@compiled
def arctangent(y: float, x: float) -> float:
    """Return atan2(y, x) within 1e-9, for y ≥ 0 and x > 0."""
    large = y > x
    ratio = (x if large else y) / (y if large else x)
    # of half the angle
    t = ratio / (1.0 + math.sqrt(1.0 + ratio * ratio))
    z = t * t
    angle = 2.0 * (t + t * z * polynomial(ARCTANGENT, z))
    return 0.5 * math.pi - angle if large else angle
