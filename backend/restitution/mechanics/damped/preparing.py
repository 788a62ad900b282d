"""What one η makes of the contact: its motion, piece by piece, and the shape of its force."""

import math

import numpy as np

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import (
    ORDER,
    STEP,
    STRONGEST,
    TERMS,
    Viscoelastic,
    cap_slopes,
    curvature_at,
    damped_motion,
    near_end,
    summed,
)
from restitution.mechanics.hertz import FloatArray

MOST_STEPS = 2000
"""Of a survey; the longest, at `viscoelastic.MOST_DAMPING`, takes 711."""

NO_VALLEY_VALUE = 1e-20
"""η below which the curvature at its local minimum, −.35/η², is only known to be negative."""


@compiled
def expand(
    a: float, b: float, sense: float, root: float, rate: float, cap: float, series: FloatArray
) -> None:
    """Fill `series` (terms, 4) with the motion from a state on, `sense` −1 for back in time.

    Its columns are R, C, the velocity minus that of the state, and the time that passes.
    """
    terms = series.shape[0]
    force = np.empty(terms)
    drive = np.empty(terms)
    series[0, 0], series[0, 1], series[0, 2], series[0, 3] = root, cap, 0.0, 0.0
    for k in range(terms - 1):
        product = 0.0
        for i in range(k + 1):
            product += series[i, 0] * series[k - i, 1]
        force[k] = product
        drive[k] = a * (series[k, 2] if k else rate) - b * product
        kick = grow = 0.0
        for i in range(k + 1):
            kick += series[i, 0] * force[k - i]
            grow += series[i, 0] * drive[k - i]
        n = k + 1
        series[n, 0] = sense * (series[k, 2] if k else rate) / n
        series[n, 1] = 2.0 * sense * grow / n
        series[n, 2] = -2.0 * sense * kick / n
        series[n, 3] = 2.0 * series[k, 0] / n


@compiled
def _ends(
    a: float, b: float, series: FloatArray, rate: float, distance: float
) -> tuple[float, float]:
    """Return what is positive until the end of the contact, and until the largest force."""
    root, cap, gain, _ = summed(series, ORDER, distance)
    rate += gain
    slope, _, _ = cap_slopes(a, b, root, rate, cap)
    if a < 1.0:
        return cap, slope
    # without cancellation however small the damping is: the end as a root of R
    return (root - math.sqrt(-b * rate) if rate < 0.0 else 1.0), slope


@compiled
def _within_step(a: float, b: float, series: FloatArray, rate: float, which: int) -> float:
    """Return the distance at which one of `_ends` falls through 0, by halving."""
    low, high = 0.0, STEP
    for _ in range(54):
        middle = 0.5 * (low + high)
        if _ends(a, b, series, rate, middle)[which] > 0.0:
            low = middle
        else:
            high = middle
    return high


@compiled
def _survey(a: float, b: float, limit: int) -> tuple[float, float, float, float]:
    """Return τ at the largest force and at the end, R and V at the end."""
    root, rate, cap = 0.0, 1.0, b
    peak = -1.0
    series = np.empty((ORDER, 4))
    for i in range(limit):
        expand(a, b, 1.0, root, rate, cap, series)
        over, slope = _ends(a, b, series, rate, STEP)
        if peak < 0.0 and slope <= 0.0:
            peak = i * STEP + _within_step(a, b, series, rate, 1)
        if over <= 0.0:
            distance = _within_step(a, b, series, rate, 0)
            root, _, gain, _ = summed(series, ORDER, distance)
            rate += gain
            if a < 1.0:
                rate = -a * root * root / b
            else:
                root = math.sqrt(-b * rate / a)
            return peak, i * STEP + distance, root, rate
        root, cap, gain, _ = summed(series, ORDER, STEP)
        # each from the other where it does not cancel
        if a < 1.0:
            rate = (cap - a * root * root) / b
        else:
            rate += gain
            cap = a * root * root + b * rate
    return peak, -1.0, root, rate


@compiled
def _fill(
    a: float, b: float, sense: float, root: float, rate: float, cap: float, pieces: FloatArray
) -> None:
    """Fill `pieces` from one end of the contact inwards."""
    series = np.empty((ORDER, 4))
    spent = passed = 0.0
    first = rate
    for i in range(pieces.shape[0]):
        expand(a, b, sense, root, rate, cap, series)
        for k in range(TERMS):
            pieces[i, k, 0], pieces[i, k, 1] = series[k, 0], series[k, 1]
            pieces[i, k, 2], pieces[i, k, 3] = -sense * series[k, 2], series[k, 3]
        pieces[i, 0, 2], pieces[i, 0, 3] = spent, passed
        root, cap, gain, time = summed(series, ORDER, STEP)
        spent -= sense * gain
        passed += time
        rate = first - sense * spent


@compiled
def _bump(contact: Viscoelastic, low: float, high: float, sign: float) -> float:
    """Return the position between two at which sign times the curvature is largest."""
    share = 0.3819660112501051
    for _ in range(40):
        left, right = low + share * (high - low), high - share * (high - low)
        if sign * curvature_at(contact, left)[0] > sign * curvature_at(contact, right)[0]:
            high = right
        else:
            low = left
    return 0.5 * (low + high)


@compiled
def _shape(contact: Viscoelastic) -> tuple[float, float]:
    """Return the positions of the local minimum and the local maximum of the curvature.

    It falls from +∞ at the start to −∞ at the end, and between rises once or not at all. Negative
    if it does not.
    """
    if contact.b >= contact.a:
        return -1.0, -1.0
    end = contact.rising_end + contact.falling_end
    least = math.sqrt(contact.b)
    # about the root of the damping, where it leaves the cap to the compression
    near = 3.0 * least if least < 0.1 else 0.0
    points = np.empty(30 + 90)
    for i in range(30):
        points[i] = (i + 1) / 30.0 * near
    for i in range(90):
        points[30 + i] = near + (0.98 * end - near) * (i + 1) / 90.0
    values = np.empty(points.size)
    for i in range(points.size):
        values[i] = curvature_at(contact, points[i])[0] if points[i] > 0.0 else np.inf
    valley = ridge = -1.0
    for i in range(1, points.size - 1):
        if points[i - 1] <= 0.0:
            continue
        if valley < 0.0 and values[i] <= values[i - 1] and values[i] < values[i + 1]:
            valley = _bump(contact, points[i - 1], points[i + 1], -1.0)
        if valley >= 0.0 and values[i] >= values[i - 1] and values[i] > values[i + 1]:
            ridge = _bump(contact, points[i - 1], points[i + 1], 1.0)
    return valley, ridge


@compiled
def _inverse(contact: Viscoelastic, falling: bool) -> tuple[float, float]:
    """Return the coefficients of `guessed_place` that make it and its slope right at the peak."""
    end = contact.falling_end if falling else contact.rising_end
    root, _, _, time = damped_motion(contact, falling, end)
    sigma = near_end(contact, falling, time)
    rate = -contact.last_rate if falling else 1.0
    excess = end / sigma - 1.0
    slope = ((contact.end_root if falling else 0.0) + rate * sigma) / root - 1.0
    seventh = (slope - 4.0 * excess) / 3.0
    cube = sigma * sigma * sigma
    return (excess - seventh) / cube, seventh / (cube * cube)


@compiled
def prepare(damping: float, limit: int) -> Viscoelastic:
    """Return the contact of a positive η; `rising` is 0 where its end was not found."""
    if damping < 1.0:
        a, b, unit = 1.0, damping, 1.0
    else:
        a, b, unit = damping ** (-5.0 / 3.0), 1.0, damping ** (2.0 / 3.0)
    peak, end, root, rate = _survey(a, b, limit)
    first = int(peak / STEP + 0.5) + 1 if end > 0.0 else 0
    last = int((end - peak) / STEP + 0.5) + 1 if end > 0.0 else 0
    pieces = np.empty((first + last, TERMS, 4))
    _fill(a, b, 1.0, 0.0, 1.0, b, pieces[:first])
    _fill(a, b, -1.0, root, rate, 0.0, pieces[first:])
    contact = Viscoelastic(
        pieces, first, a, b, unit, peak, end - peak, root, (0.0, 0.0), (0.0, 0.0), 0.0, 1.0 - rate,
        rate, 0.0, 0.0, -a * root * rate, -1.0, 0.0, -1.0, 0.0, False, STRONGEST, 0.0,
    )  # fmt: skip
    if first == 0:
        return contact
    high, cap, _, before = damped_motion(contact, False, peak)
    _, _, _, after = damped_motion(contact, True, end - peak)
    if b < NO_VALLEY_VALUE:
        # where the compression is t: P = bτ + τ³, whose curvature is least at τ² = b/√3
        valley, ridge = math.sqrt(b) * 3.0**-0.25, -1.0
        _, ridge = _shape(contact)
    else:
        valley, ridge = _shape(contact)
    found = ridge >= 0.0
    return Viscoelastic(
        pieces, first, a, b, unit, peak, end - peak, root, _inverse(contact, False),
        _inverse(contact, True), before + after, 1.0 - rate, rate, before, high * cap,
        -a * root * rate,
        valley if found else -1.0,
        curvature_at(contact, valley)[0] if found and b >= NO_VALLEY_VALUE else -1.0,
        ridge if found else -1.0,
        curvature_at(contact, ridge)[0] if found else 0.0,
        False, STRONGEST, 0.0,
    )  # fmt: skip
