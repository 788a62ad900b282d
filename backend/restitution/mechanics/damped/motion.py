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

from restitution.mechanics.compiled import compiled, compiled_in_columns
from restitution.mechanics.hertz import FloatArray

STEP = 0.125
"""Distance of the points in q about which the motion is expanded."""

TERMS = 14
"""Of a piece, up to `STEP`/2 on either side of its point."""

ORDER = 24
"""Of the series that lead over a whole `STEP`."""

STRONGEST = 1e150
"""ψ above which ε_t is 1 to double precision: what the cap takes is at most 2."""


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
    end_root: float
    """R at the end."""
    rising_inverse: tuple[float, float]
    """Of `guessed_place`, in the rising half."""
    falling_inverse: tuple[float, float]
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
    """Position of the local minimum of −P̈/P, see `sliding`; negative if there is none."""
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


@compiled_in_columns
def summed(series: FloatArray, terms: int, distance: float) -> tuple[float, float, float, float]:
    """Return the four columns of a series, with an even number of terms, at a distance."""
    # even and odd powers by themselves: each waits for half as many
    square = distance * distance
    root, odd_root = series[terms - 2, 0], series[terms - 1, 0]
    cap, odd_cap = series[terms - 2, 1], series[terms - 1, 1]
    loss, odd_loss = series[terms - 2, 2], series[terms - 1, 2]
    time, odd_time = series[terms - 2, 3], series[terms - 1, 3]
    for k in range(terms - 4, -1, -2):
        root = root * square + series[k, 0]
        cap = cap * square + series[k, 1]
        loss = loss * square + series[k, 2]
        time = time * square + series[k, 3]
        odd_root = odd_root * square + series[k + 1, 0]
        odd_cap = odd_cap * square + series[k + 1, 1]
        odd_loss = odd_loss * square + series[k + 1, 2]
        odd_time = odd_time * square + series[k + 1, 3]
    return (
        root + distance * odd_root,
        cap + distance * odd_cap,
        loss + distance * odd_loss,
        time + distance * odd_time,
    )


@compiled
def damped_motion(
    contact: Viscoelastic, falling: bool, q: float
) -> tuple[float, float, float, float]:
    """Return R, C, velocity spent or yet to be spent, time from the start or to the end, at q."""
    piece = int(q / STEP + 0.5)
    distance = q - piece * STEP
    if falling:
        piece += contact.rising
    return summed(contact.pieces[piece], TERMS, distance)


@compiled
def guessed_place(contact: Viscoelastic, falling: bool, time: float) -> float:
    """Return about the q at a time > 0 from the start, or to the end when `falling`.

    From η = 0 to 1 within 1e-3, where it is longer within 5 %: near an end of the contact
    t = 2R₀q + |V₀|q², and what is missing grows as q⁵ first.
    """
    sigma = near_end(contact, falling, time)
    cube = sigma * sigma * sigma
    fourth, seventh = contact.falling_inverse if falling else contact.rising_inverse
    return sigma * (1.0 + cube * (fourth + cube * seventh))


@compiled
def near_end(contact: Viscoelastic, falling: bool, time: float) -> float:
    """Return the q > 0 where t = 2R₀q + |V₀|q²."""
    root = contact.end_root if falling else 0.0
    rate = -contact.last_rate if falling else 1.0
    return time / (root + math.sqrt(root * root + rate * time))


@compiled
def rate_at(contact: Viscoelastic, falling: bool, loss: float) -> float:
    """Return V from the velocity spent."""
    return contact.last_rate + loss if falling else 1.0 - loss


@compiled
def cap_rate(a: float, b: float, root: float, rate: float, cap: float) -> float:
    """Return dC/dτ."""
    return 2.0 * root * (a * rate - b * root * cap)


@compiled
def cap_slopes(
    a: float, b: float, root: float, rate: float, cap: float
) -> tuple[float, float, float]:
    """Return dP/dτ = 2R dP/dt, d²P/dτ² and d³P/dτ³, which are finite at the start."""
    square = root * root
    slowing = -2.0 * square * cap
    growing = cap_rate(a, b, root, rate, cap)
    stretch = b * b * root * cap - a * cap - a * b * rate
    stretching = b * b * (rate * cap + root * growing) - a * growing - a * b * slowing
    first = rate * (cap + 2.0 * a * square) - 2.0 * b * square * root * cap
    second = (
        6.0 * a * root * rate * rate
        - 8.0 * b * square * rate * cap
        - 2.0 * square * cap * cap
        + 4.0 * square * square * stretch
    )
    third = (
        6.0 * a * rate * (rate * rate + 2.0 * root * slowing)
        - 8.0 * b * root * (2.0 * rate * rate * cap + root * (slowing * cap + rate * growing))
        - 4.0 * root * cap * (rate * cap + root * growing)
        + 4.0 * square * root * (4.0 * rate * stretch + root * stretching)
    )
    return first, second, third


@compiled
def curvature_at(contact: Viscoelastic, position: float) -> tuple[float, float]:
    """Return −P̈/P and its derivative at a distance in τ from the start.

    It is the stiffness below which the cap would outrun a spring that is at it.
    """
    a, b = contact.a, contact.b
    falling = position > contact.rising_end
    left = contact.rising_end + contact.falling_end - position
    root, cap, loss, _ = damped_motion(contact, falling, left if falling else position)
    rate = rate_at(contact, falling, loss)
    slope, bend, twist = cap_slopes(a, b, root, rate, cap)
    square = root * root
    # 4R³ P̈ with the opposite sign, as dt = 2R dτ
    turned = rate * slope - root * bend
    turning = -2.0 * square * cap * slope - root * twist
    scale = 4.0 * square * square * cap
    growing = 4.0 * rate / root + cap_rate(a, b, root, rate, cap) / cap
    return turned / scale, (turning - turned * growing) / scale
