"""The event-driven solution, right to rounding."""

from typing import Any

import numpy as np
import numpy.typing as npt

from restitution.errors import CostError
from restitution.mechanics.collision import (
    MOST_SWITCHES,
    TOO_STIFF,
    Collision,
    collide,
    expected_switch_counts,
)
from restitution.mechanics.contact import contact_of
from restitution.mechanics.damped.motion import Viscoelastic
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes import block
from restitution.mechanics.lanes.damped import block as damped_block
from restitution.methods.answer import Answer
from restitution.methods.options import Options

MOST_SWITCHES_PER_REQUEST = 20_000_000
"""About four seconds of one core."""

SECONDS_FOR_A_SWITCH = 2e-7

SECONDS_IN_LANES = 5e-8
"""The same of many collisions at a time that lanes take."""

DEARER_BY_DAMPING = 2.0
"""Cost of a switch with damping over one without, in lanes or not, rounded up from 1.9."""


def cost(kappa: FloatArray, psi: FloatArray, damping: float = 0.0) -> float:
    """Return about how many seconds of one core it takes to follow collisions (N,)."""
    expected = expected_switch_counts(kappa, psi, damping)
    switches = np.where(expected <= MOST_SWITCHES, expected, 0.0)
    return float(seconds_to_follow(kappa, psi, damping, switches).sum())


def seconds_to_follow(
    kappa: FloatArray, psi: FloatArray, damping: float, switches: npt.NDArray[Any]
) -> FloatArray:
    """Return about how many seconds of one core each of many collisions (N,) takes.

    `switches` (N,) are those that they have, or are expected to have.
    """
    contact = contact_of(damping)
    softest, stiffest, weakest = block.SOFTEST, block.STIFFEST, block.WEAKEST
    dearer, stiffness = 1.0, kappa
    if isinstance(contact, Viscoelastic):
        softest = damped_block.softest_in_lanes(contact)
        stiffest, weakest = damped_block.STIFFEST, damped_block.WEAKEST
        dearer, stiffness = DEARER_BY_DAMPING, kappa / contact.unit / contact.unit
        if contact.pieces.shape[0] > damped_block.MOST_PIECES:
            softest = np.inf
    in_lanes = (stiffness >= softest) & (stiffness <= stiffest) & (psi >= weakest)
    seconds: FloatArray = np.where(in_lanes, SECONDS_IN_LANES, SECONDS_FOR_A_SWITCH)
    return np.asarray(dearer * seconds * switches)


def budget(looked_at: int, damping: float, share: float = 1.0) -> float:
    """Return how many switches a request may follow beside so many collisions that it looks at.

    To find out that one is not to be followed takes about as long as a switch.
    """
    most = share * MOST_SWITCHES_PER_REQUEST / (DEARER_BY_DAMPING if damping else 1.0)
    return max(0.0, most - looked_at)


def switch_limit(expected: FloatArray, most: float = MOST_SWITCHES_PER_REQUEST) -> float:
    """Return up to how many switches collisions can be followed, no more than `most` together.

    `expected` (N,) are the switches to be expected of each.
    """
    affordable = expected[expected <= MOST_SWITCHES]
    if affordable.sum() <= most:
        return float(MOST_SWITCHES)
    ascending = np.sort(affordable)
    first_beyond = ascending[np.searchsorted(np.cumsum(ascending), most, side="right")]
    # of collisions alike either all are followed or none
    fitting = int(np.searchsorted(ascending, first_beyond))
    return float(ascending[fitting - 1]) if fitting else 0.0


def follow_affordable(
    kappa: FloatArray, psi: FloatArray, damping: float, share: float = 1.0, *, spent: int = 0
) -> Collision:
    """Return the exact results of collisions (N,), 0 within a bound for those beyond the budget.

    Without damping that is the sharp stiff limit, with it `viscoelastic.energy_bound`. `spent` are
    switches of the budget that are followed already.
    """
    most = budget(kappa.size + spent, damping, share)
    affordable = switch_limit(expected_switch_counts(kappa, psi, damping), most)
    return collide(kappa, psi, damping, affordable)


def known(result: Collision) -> FloatArray:
    """Return the exact ε_t, NaN for collisions that were too stiff to follow."""
    return np.where(result.switches == TOO_STIFF, np.nan, result.epsilon_t)


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t and switches of collisions (N,).

    The bound is guaranteed: rounding, with a factor of safety over the largest error seen against
    60-digit arithmetic, with damping 45-digit. Cost: 0.2 µs for a switch, twice that with damping,
    for each η 0.05 ms at first.

    Raises
    ------
    CostError
        If the collisions are too many or too stiff.
    """
    expected = expected_switch_counts(kappa, psi, options.damping)
    affordable = switch_limit(expected, budget(kappa.size, options.damping, options.share))
    if np.any(expected > affordable):
        most = budget(0, options.damping, options.share)
        raise CostError(
            f"the exact method would follow about {expected.sum():.3g} switches here, up to "
            f"{expected.max():.3g} in one collision; the limits are {most:,.0f}, one of which each "
            f"collision takes up besides, and {MOST_SWITCHES:,}. Ask for fewer or softer "
            "collisions, or for method=auto"
        )
    result = collide(kappa, psi, options.damping, affordable)
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
