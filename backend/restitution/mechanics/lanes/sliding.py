"""Sliding in lanes: where the reach R = κ(1 − |ẋ|) + |d(x^{3/2})/dt| is what it must be."""

import math

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import (
    HALF_CONTACT_ROOT,
    LOSS_SERIES,
    ROOT_SERIES,
    FloatArray,
    normal_motion,
    polynomial,
)
from restitution.mechanics.lanes.elementary import fifth_root
from restitution.mechanics.lanes.rows import DOUBT, KAPPA, LOSS, REACH, ROOT, Q
from restitution.mechanics.roots import halley, is_last

ROUGH_ROOT, ROUGH_LOSS = ROOT_SERIES[-4:], LOSS_SERIES[-4:]


@compiled
def slide(count: int, lanes: FloatArray) -> None:
    """Move `count` lanes to where sliding ends, R(q) = `REACH`."""
    for i in range(count):
        lanes[Q + i] = guessed_sliding_end(lanes[KAPPA + i], lanes[REACH + i])
    for i in range(count):
        q = lanes[Q + i]
        root, loss = rough_motion(q)
        step, _ = step_to_reach(lanes[KAPPA + i], lanes[REACH + i], q, root, loss)
        lanes[Q + i] = min(max(q - step, 0.2 * q), HALF_CONTACT_ROOT)
    for i in range(count):
        q = lanes[Q + i]
        root, loss = normal_motion(q)
        step, _ = step_to_reach(lanes[KAPPA + i], lanes[REACH + i], q, root, loss)
        lanes[Q + i] = min(max(q - step, 0.2 * q), HALF_CONTACT_ROOT)
    for i in range(count):
        q = lanes[Q + i]
        root, loss = normal_motion(q)
        step, change = step_to_reach(lanes[KAPPA + i], lanes[REACH + i], q, root, loss)
        square = root * root
        # that of a soft spring falls between two extrema: docs/model.md, "Sliding"
        is_rising = square * square * (lanes[KAPPA + i] - 2.1 * root) + 0.75 > 0.0
        lanes[DOUBT + i] += 0.0 if is_rising and is_last(q, step, change) else 1.0
        arrive(i, lanes, q, root, loss, step)


@compiled
def largest_reach(kappa: float) -> float:
    """Return the largest reach in the compression within 1e-9; κ from 0 to `MONOTONE_STIFFNESS`.

    There κx² + 3/4 − (21/10)x^{5/2} = 0, and by energy ẋ² = 1 − (4/5)x^{5/2}.
    """
    root = 0.8139 + kappa * (0.1 + 0.03 * kappa)
    for _ in range(3):
        cube = root * root * root
        value = cube * root * (2.1 * root - kappa) - 0.75
        root -= value / (cube * (10.5 * root - 4.0 * kappa))
    square = root * root
    rate = math.sqrt(max(1.0 - 0.8 * square * square * root, 0.0))
    return kappa * (1.0 - rate) + 1.5 * root * rate


@compiled
def guessed_sliding_end(kappa: float, reach: float) -> float:
    """Return about the q where R(q) = `reach`.

    R is 1.5 q for small q, (2/5)κq⁵ for large κ, and their sum between, which is no longer either:
    fitted.
    """
    slow = reach / 1.5
    taken = reach / kappa
    fast = fifth_root(2.5 * taken * (1.0 + taken * (0.214 + taken * 0.1)))
    is_slow = slow < fast
    share = slow / fast if is_slow else fast / slow
    power = share * share * math.sqrt(share)
    of_slow = slow * (1.0 + 2.08 * power) / (1.0 + 3.08 * power)
    of_fast = fast * (1.0 - share * (0.2 + share * (0.04 + share * 0.005)))
    return min(of_slow if is_slow else of_fast, 0.9999 * HALF_CONTACT_ROOT)


@compiled
def rough_motion(q: float) -> tuple[float, float]:
    """Return `normal_motion` within 1e-3, by the first terms of its polynomials."""
    square = q * q
    w = square * square * q
    return q * polynomial(ROUGH_ROOT, w), w * polynomial(ROUGH_LOSS, w)


@compiled
def step_to_reach(
    kappa: float, reach: float, q: float, root: float, loss: float
) -> tuple[float, float]:
    """Return `halley` for R(q) = `reach`."""
    rate = 1.0 - loss
    square = root * root
    speed = rate * rate / root
    value = kappa * loss + 1.5 * root * rate - reach
    # Ṙ and R̈, of which dt = 2q dq makes derivatives by q
    growth = kappa * square * root + 0.75 * speed - 1.5 * square * square
    bend = rate * (1.5 * kappa * root - 4.5 * square - 0.375 * speed / square)
    return halley(value, 2.0 * q * growth, 2.0 * growth + 4.0 * q * q * bend)


@compiled
def arrive(i: int, lanes: FloatArray, q: float, root: float, loss: float, step: float) -> None:
    """Put lane i at q − `step`, with √x and 1 − |ẋ| by Taylor's series from those at q."""
    square = root * root
    climb = (1.0 - loss) * q / root
    fall = 2.0 * q * square * root
    bend = (1.0 - loss - q * fall - climb * climb) / root
    lanes[Q + i] = q - step
    lanes[ROOT + i] = root - step * (climb - 0.5 * step * bend)
    lanes[LOSS + i] = loss - step * (fall - step * square * (root + 3.0 * q * climb))
