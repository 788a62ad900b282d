"""The normal motion of one η as pieces of Taylor series, from the touch to the end of the force.

In τ with dt = 2√x dτ the motion of `viscoelastic` is polynomial, for R = √x and V = ẋ:

    R' = V,   V' = −2R²C,   C = aR² + bV,   t' = 2R;   normal force P = RC

with a = 1 and b = η. From η = 1 on all is counted in other units, lengths and times in η^{-2/3} and
forces in η^{2/3}, where a = η^{-5/3} and b = 1: nothing then leaves the double range. Near both
ends of the contact τ is what √t is without damping; R, C and the velocity spent are analytic in
the distance q from either end, whatever η, and keep all digits there. The contact is halved where
the force is largest, into one half in which it rises and one in which it falls.
"""

import math
from typing import NamedTuple

import numpy as np

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import FloatArray

STEP = 0.125
"""Distance of the points in q about which the motion is expanded."""

TERMS = 14
"""Of a piece, up to `STEP`/2 on either side of its point."""

ORDER = 24
"""Of the series that lead over a whole `STEP`."""

MOST_STEPS = 2000
"""Of a survey; the longest, at `viscoelastic.MOST_DAMPING`, takes 711."""

STRONGEST = 1e150
"""ψ above which ε_t is 1 to double precision: what the cap takes is at most 2."""

NO_VALLEY_VALUE = 1e-20
"""η below which the curvature at its local minimum, −.35/η², is only known to be negative."""


class Viscoelastic(NamedTuple):
    """The contact of one η > 0 in its own units, see the module; what kernels take."""

    pieces: FloatArray
    """Coefficients [piece][power][column], the columns being those of `damped_motion`; first the
    pieces of the rising half."""
    rising: int
    """Number of pieces of the rising half."""
    a: float
    b: float
    unit: float
    """η^{2/3} from η = 1 on, else 1: how many of these units of time make one t_scale."""
    rising_end: float
    """q where the force is largest, from the start."""
    falling_end: float
    """The same from the end."""
    duration: float
    impulse: float
    """1 + ε_n, all that sliding can take from the surface velocity."""
    last_rate: float
    """V at the end, −ε_n."""
    peak_time: float
    """Time of the largest force."""
    peak: float
    """The largest force."""
    last_slope: float
    """|dP/dt| at the end."""
    valley: float
    """Position of the local minimum of −P̈/P, see `damped_sliding`; negative if there is none."""
    valley_value: float
    ridge: float
    """Position of its local maximum."""
    ridge_value: float
    begins_sliding: bool
    """False: the cap rises as √t at first, the spring's force as t."""
    strongest: float
    """ψ above which the collision is followed as one of this ψ."""
    least_load: float
    """κψ above which the number of switches is that of the η which this contact stands for."""


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
def summed(series: FloatArray, distance: float) -> tuple[float, float, float, float]:
    """Return the four columns of a series at a distance from its point."""
    n = series.shape[0] - 1
    root, cap, loss, time = series[n, 0], series[n, 1], series[n, 2], series[n, 3]
    for k in range(n - 1, -1, -1):
        root = root * distance + series[k, 0]
        cap = cap * distance + series[k, 1]
        loss = loss * distance + series[k, 2]
        time = time * distance + series[k, 3]
    return root, cap, loss, time


@compiled
def damped_motion(
    contact: Viscoelastic, falling: bool, q: float
) -> tuple[float, float, float, float]:
    """Return R, C, velocity spent or yet to be spent, time from the start or to the end, at q."""
    piece = int(q / STEP + 0.5)
    distance = q - piece * STEP
    if falling:
        piece += contact.rising
    pieces = contact.pieces
    n = TERMS - 1
    root, cap = pieces[piece, n, 0], pieces[piece, n, 1]
    loss, time = pieces[piece, n, 2], pieces[piece, n, 3]
    for k in range(n - 1, -1, -1):
        root = root * distance + pieces[piece, k, 0]
        cap = cap * distance + pieces[piece, k, 1]
        loss = loss * distance + pieces[piece, k, 2]
        time = time * distance + pieces[piece, k, 3]
    return root, cap, loss, time


@compiled
def rate_at(contact: Viscoelastic, falling: bool, loss: float) -> float:
    """Return V from the velocity spent."""
    return contact.last_rate + loss if falling else 1.0 - loss


@compiled
def cap_slope(a: float, b: float, root: float, rate: float, cap: float) -> float:
    """Return 2R dP/dt = dP/dτ, which is finite at the start, where dP/dt is not."""
    return rate * (cap + 2.0 * a * root * root) - 2.0 * b * root * root * root * cap


@compiled
def cap_bend(a: float, b: float, root: float, rate: float, cap: float) -> float:
    """Return 2R² · 2R d²P/dt², finite at the start as well."""
    square = root * root
    return (
        4.0 * a * rate * rate * square
        - rate * rate * cap
        - 6.0 * b * square * root * rate * cap
        - 2.0 * square * root * cap * cap
        + 4.0 * square * square * root * (b * b * root * cap - a * cap - a * b * rate)
    )


@compiled
def curvature(contact: Viscoelastic, falling: bool, q: float) -> float:
    """Return −P̈/P at q, the stiffness below which the cap would outrun a spring at it."""
    root, cap, loss, _ = damped_motion(contact, falling, q)
    rate = rate_at(contact, falling, loss)
    square = root * root
    return -cap_bend(contact.a, contact.b, root, rate, cap) / (4.0 * square * square * cap)


@compiled
def _ends(
    a: float, b: float, series: FloatArray, rate: float, distance: float
) -> tuple[float, float]:
    """Return what is positive until the end of the contact, and until the largest force."""
    root, cap, gain, _ = summed(series, distance)
    rate += gain
    slope = cap_slope(a, b, root, rate, cap)
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
            root, _, gain, _ = summed(series, distance)
            rate += gain
            if a < 1.0:
                rate = -a * root * root / b
            else:
                root = math.sqrt(-b * rate / a)
            return peak, i * STEP + distance, root, rate
        root, cap, gain, _ = summed(series, STEP)
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
        root, cap, gain, time = summed(series, STEP)
        spent -= sense * gain
        passed += time
        rate = first - sense * spent


@compiled
def _bump(contact: Viscoelastic, low: float, high: float, sign: float) -> float:
    """Return the position between two at which sign times the curvature is largest."""
    share = 0.3819660112501051
    for _ in range(40):
        left, right = low + share * (high - low), high - share * (high - low)
        if sign * curvature_at(contact, left) > sign * curvature_at(contact, right):
            high = right
        else:
            low = left
    return 0.5 * (low + high)


@compiled
def curvature_at(contact: Viscoelastic, position: float) -> float:
    """Return `curvature` at a distance in τ from the start."""
    left = contact.rising_end + contact.falling_end - position
    if position <= contact.rising_end:
        return curvature(contact, False, position)
    return curvature(contact, True, left)


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
        values[i] = curvature_at(contact, points[i]) if points[i] > 0.0 else np.inf
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
        pieces, first, a, b, unit, peak, end - peak, 0.0, 1.0 - rate, rate, 0.0, 0.0,
        -a * root * rate, -1.0, 0.0, -1.0, 0.0, False, STRONGEST, 0.0,
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
        pieces, first, a, b, unit, peak, end - peak, before + after, 1.0 - rate, rate, before,
        high * cap, -a * root * rate,
        valley if found else -1.0,
        curvature_at(contact, valley) if found and b >= NO_VALLEY_VALUE else -1.0,
        ridge if found else -1.0,
        curvature_at(contact, ridge) if found else 0.0,
        False, STRONGEST, 0.0,
    )  # fmt: skip
