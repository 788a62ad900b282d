"""How far ε_t can change from one collision to others near it.

The bounds are those of docs/model.md, "How fast ε_t can change". κ is that of Eq. 24, with α in
it; ψ = (α/μ)(g_t/g_n). Every function takes and returns arrays (N,).
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from restitution.mechanics.contact import largest_force
from restitution.mechanics.hertz import CONTACT_DURATION, MAXIMUM_FORCE, FloatArray
from restitution.mechanics.limits import sliding_threshold, stiff_limit, weak_limit
from restitution.mechanics.scaled_velocity import SMALLEST

PHASE_SHARE = 0.6298
"""Largest √(L² − L sin 2L + sin² L)/(2L), rounded up; at L = 2.0428.

What a swing with √κ Δt = L adds to the velocity for a relative change of κ, over L and its
amplitude."""

FIRST_SWING = 1.2338
"""π²/8, rounded up: the same over P_max/√κ, for the first swing with damping."""

HELD_BY_THE_CAP = 2.0
"""κ from which on a spring that has slid swings by P_max at most.

It does so from 1.569 on without damping, and above the local maximum of −P̈/P with it: 1.851 is the
largest, at η = 0.583, from where on there is none."""

CHANGE_OF_FORCE = 4.26
"""t_c times the largest |∂P/∂η| for η → 0, rounded up from 4.249."""

CAPPED_TIME = 1.4717
"""t_c/(2 x_max), rounded up: so long times f^{2/3}, at most, is P below f at either end of a
contact without damping, for the compression is concave."""


class Range(NamedTuple):
    """Least and largest ε_t that is possible."""

    low: FloatArray
    high: FloatArray


def largest_force_between(least: FloatArray, most: FloatArray) -> FloatArray:
    """Return a bound on the normal force, scaled, for any η from `least` to `most`.

    Exact where all are one η; else 1.1433 or, for large η, 0.61 η^{2/3}, which is measured.
    """
    if least[0] == most[0] and np.ptp(least) == np.ptp(most) == 0.0:
        return np.full(least.shape, largest_force(float(least[0])))
    return np.asarray(np.maximum(MAXIMUM_FORCE, 0.61 * np.cbrt(most) ** 2))


def change_by_stiffness(
    low: FloatArray, centre: FloatArray, high: FloatArray, psi: FloatArray, force: FloatArray
) -> FloatArray:
    """Return a bound on |Δε_t| between `centre` and any κ from `low` to `high`.

    `psi` is the same for all, and `force` is the largest normal force. Proven.
    """
    free = 2.0 * PHASE_SHARE * CONTACT_DURATION * _largest_step(np.sqrt, low, centre, high)
    held = force / psi * (PHASE_SHARE * CONTACT_DURATION + FIRST_SWING / np.sqrt(low))
    held *= _largest_step(np.log, low, centre, high)
    return np.where(low >= HELD_BY_THE_CAP, np.minimum(free, held), free)


def change_by_damping(
    least: FloatArray, centre: FloatArray, most: FloatArray, psi: FloatArray
) -> FloatArray:
    """Return a bound on |Δε_t| between `centre` and any η from `least` to `most`.

    Proven but for t_c times the largest |∂P/∂η|, which is measured.
    """
    slope = CHANGE_OF_FORCE / (1.0 + 1.5 * least) ** 0.8
    return slope * np.maximum(most - centre, centre - least) / psi


def change_by_velocity(
    at_centre: Range, low: FloatArray, centre: FloatArray, high: FloatArray
) -> Range:
    """Return which ε_t are possible for ψ from `low` to `high`, given those at `centre`.

    Proven: ε_tψ is a contraction in ψ.
    """
    # |ε_t| ≤ 1 whatever a large number stands for
    below, above = np.minimum(centre / low, 1e100) - 1.0, 1.0 - centre / high
    least, most = np.maximum(at_centre.low, -1.0), np.minimum(at_centre.high, 1.0)
    return Range(
        least - np.maximum((1.0 + least) * above, (1.0 - least) * below),
        most + np.maximum((1.0 - most) * above, (1.0 + most) * below),
    )


def possible_range(
    kappas: tuple[FloatArray, FloatArray, FloatArray],
    psis: tuple[FloatArray, FloatArray],
    force: FloatArray,
    *,
    damped: bool,
) -> Range:
    """Return which ε_t are possible at all for κ between the outer ones of three, ψ between two.

    −1 to 1, and less for stiff springs; without damping also where the contact slides throughout,
    and where ψ is so small that the spring swings all but freely. Proven, `force` being the largest
    normal force.
    """
    least, centre, most = kappas
    low, high = psis
    if damped:
        held = np.where(high <= 1.0, force / np.sqrt(least) / low, 1.0)
    else:
        held = np.where(high < 2.0, stiff_limit(least, np.clip(low, SMALLEST, 1.9))[1], 1.0)
    bound = np.where(least >= HELD_BY_THE_CAP, np.minimum(held, 1.0), 1.0)
    if damped:
        return Range(-bound, bound)
    spring = np.sqrt(most) * high
    phase = np.minimum(1.0, np.sqrt(most) * CAPPED_TIME * np.cbrt(spring) ** 2)
    off = phase * (3.0 + 0.5 * phase) + CONTACT_DURATION * _largest_step(np.sqrt, *kappas)
    off = np.where(spring < MAXIMUM_FORCE, off, 2.0)
    slides = low >= sliding_threshold(least)
    least_slid, most_slid = (1.0 - 2.0 / np.maximum(psi, 1.0) for psi in psis)
    return Range(
        np.where(slides, least_slid, np.maximum(-bound, weak_limit(centre) - off)),
        np.where(slides, most_slid, np.minimum(bound, weak_limit(centre) + off)),
    )


def _largest_step(
    of: Callable[[FloatArray], FloatArray], low: FloatArray, centre: FloatArray, high: FloatArray
) -> FloatArray:
    """Return how far a growing function may be from its value in the middle."""
    return np.maximum(of(high) - of(centre), of(centre) - of(low))
