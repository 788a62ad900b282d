"""Steps to a root: Newton's and Halley's, and how they are kept in a bracket."""

import math

from restitution.mechanics.compiled import compiled

ROUNDING = 2.220446049250313e-16
"""Distance from 1 to the next double."""

CONVERGED = 1e-9
"""Relative Newton step after which the iteration is over: what is left is its square."""

NEGLIGIBLE = 1e-100
"""A root this near to an end of the contact is the end: x^{3/2} = 1e-300 there."""

MOST_NEWTON_STEPS, MOST_STEPS = 40, 120
"""Halving the exponent from 1 to `NEGLIGIBLE`, and on to the last digit, takes 62 of them."""

SHORT = 3e-6
"""Last step of Halley's, over q and in phase: its third power is left out."""

LITTLE = 1e-17
"""What may be left to the root after it, over q."""


@compiled
def newton_within(
    n: int, q: float, value: float, slope: float, low: float, high: float
) -> tuple[float, bool]:
    """Return the next q of a Newton iteration kept in a bracket, and whether it is the root."""
    step = value / slope
    if abs(step) <= CONVERGED * q:
        return q - step, True
    following = q - step
    # where rounding in a large phase √κ t outweighs `value`, or both underflow, only the bracket
    # still shrinks, over powers of ten first
    if n >= MOST_NEWTON_STEPS and high > 4.0 * low:
        following = math.sqrt(max(low, 0.01 * NEGLIGIBLE) * high)
    elif n >= MOST_NEWTON_STEPS or not low <= following <= high:
        following = 0.5 * (low + high)
    return following, high - low <= ROUNDING * high or high < NEGLIGIBLE


@compiled
def halley(value: float, first: float, second: float) -> tuple[float, float]:
    """Return Halley's step from a function's value and derivatives, to be subtracted.

    Also how much of Newton's step the second derivative changes: beside a double root, where a
    short step does not say that the root is near, it is a large part.
    """
    change = 0.5 * value * second / (first * first)
    return value / (first * (1.0 - change)), change


@compiled
def is_last(q: float, step: float, change: float) -> bool:
    """Return whether a step of Halley's leads to the root: its error is about change² × step."""
    return abs(step) <= SHORT * q and change * change * abs(step) <= LITTLE * q


@compiled
def halley_within(
    n: int, q: float, value: float, first: float, second: float, low: float, high: float
) -> tuple[float, bool]:
    """Return what `newton_within` does, by Halley's step from the first two derivatives."""
    step, change = halley(value, first, second)
    # the third power of such a step is below the last digit
    if is_last(q, step, change):
        return q - step, True
    # a second derivative that turns the step around belongs to another root
    bent = first * (1.0 - change) if abs(change) < 0.5 else first
    return newton_within(n, q, value, bent, low, high)
