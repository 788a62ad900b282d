"""The event-driven solution, right to rounding."""

import numpy as np

from restitution.errors import CostError
from restitution.mechanics.collision import (
    MOST_SWITCHES,
    TOO_STIFF,
    Collision,
    collide,
    expected_switch_counts,
)
from restitution.mechanics.hertz import FloatArray
from restitution.methods.answer import Answer, Options

MOST_SWITCHES_PER_REQUEST = 20_000_000
"""About four seconds of one core, at 0.2 µs for a switch."""


def cost(kappa: FloatArray, psi: FloatArray) -> float:
    """Return about how many seconds of one core it takes to follow collisions (N,)."""
    expected = expected_switch_counts(kappa, psi)
    return 2e-7 * float(np.sum(expected[expected <= MOST_SWITCHES]))


def switch_limit(expected: FloatArray) -> float:
    """Return up to how many switches collisions can be followed within the budget of a request.

    `expected` (N,) are the switches to be expected of each.
    """
    affordable = expected[expected <= MOST_SWITCHES]
    if affordable.sum() <= MOST_SWITCHES_PER_REQUEST:
        return float(MOST_SWITCHES)
    ascending = np.sort(affordable)
    return float(ascending[np.searchsorted(np.cumsum(ascending), MOST_SWITCHES_PER_REQUEST) - 1])


def follow_affordable(kappa: FloatArray, psi: FloatArray) -> Collision:
    """Return the exact results of collisions (N,), the stiff limit for those beyond the budget."""
    return collide(kappa, psi, switch_limit(expected_switch_counts(kappa, psi)))


def known(result: Collision) -> FloatArray:
    """Return the exact ε_t, NaN for collisions that were too stiff to follow."""
    return np.where(result.switches == TOO_STIFF, np.nan, result.epsilon_t)


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t and switches of collisions (N,).

    The bound is guaranteed: rounding, with a factor of safety over the largest error seen against
    60-digit arithmetic. Cost: 0.2 µs for a switch.

    Raises
    ------
    CostError
        If the collisions are too many or too stiff.
    """
    expected = expected_switch_counts(kappa, psi)
    affordable = switch_limit(expected)
    if np.any(expected > affordable):
        raise CostError(
            f"the exact method would follow about {expected.sum():.3g} switches here, up to "
            f"{expected.max():.3g} in one collision; the limits are "
            f"{MOST_SWITCHES_PER_REQUEST:,} and {MOST_SWITCHES:,}. Ask for fewer or softer "
            "collisions, or for method=auto"
        )
    result = collide(kappa, psi, affordable)
    lost = result.switches == TOO_STIFF
    if np.any(lost):
        raise CostError(
            f"kappa = {kappa[lost][0]:g} is too stiff for the exact method: double precision does "
            "not hold the phase of its spring. Ask for method=auto"
        )
    return Answer(
        result.epsilon_t,
        result.error_bound,
        np.full(kappa.shape, "exact"),
        result.switches,
        result.switches_certain,
        result.epsilon_t,
    )
