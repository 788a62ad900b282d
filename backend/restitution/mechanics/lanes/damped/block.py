"""A block of damped collisions in lanes, from the touch to the end of the contact."""

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped.motion import Viscoelastic, damped_motion
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.block import (
    MOST_IN_LANES,
    SOFTEST,
    fill_lanes,
    move_up,
    put,
)
from restitution.mechanics.lanes.damped.first_sticking import (
    stick_from_rise,
    stick_through_rise,
)
from restitution.mechanics.lanes.damped.sliding import SLIP, slide
from restitution.mechanics.lanes.damped.sticking import stick_from_fall
from restitution.mechanics.lanes.damped.touching import stick_from_touch
from restitution.mechanics.lanes.first_sticking import CLOSE
from restitution.mechanics.lanes.rows import (
    COUNT,
    DOUBT,
    ERROR,
    KAPPA,
    LATE,
    LEFT,
    LOSS,
    PSI,
    REACH,
    RESTING,
    SIDE,
    TOWARDS,
    Labels,
    Q,
    whole,
)
from restitution.mechanics.viscoelastic import scaled_stiffness

STIFFEST, WEAKEST = 1e5, 1e-3
"""κ, in the units of the contact, and ψ up to which and from which on collisions are in lanes: of
stiffer and weaker ones more leave than stay."""

MOST_PIECES = 48
"""Of a contact whose collisions are in lanes: up to about η = 40, where ε_n is .0026."""


@compiled
def collide_block(
    contact: Viscoelastic,
    stiffest: float,
    begin: int,
    end: int,
    kappa: FloatArray,
    psi: FloatArray,
    error_bound: FloatArray,
    lanes: FloatArray,
    labels: Labels,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
) -> int:
    """Follow the collisions from `begin` to `end`, but for those in doubt.

    As `block.collide_block` without damping; `contact` is that of one η, and `stiffest` is in its
    units.
    """
    count, leaving = enter(contact, stiffest, begin, end, kappa, psi, error_bound, lanes, labels)
    late = resting = 0
    if count > 0:
        fill_lanes(count, lanes)
        stick_from_touch(contact, whole(count), lanes)
        count, late, resting, leaving = leave_touch(
            contact, count, lanes, labels, leaving, epsilon_t, switches
        )
    if count > 0:
        fill_lanes(count, lanes)
        slide(contact, False, whole(count), lanes)
        stick_from_rise(contact, whole(count), lanes)
        count, leaving = leave(contact, count, lanes, labels, leaving, epsilon_t, switches)
    count = join(contact, count, late, kappa, psi, error_bound, lanes, labels, epsilon_t)
    leaving = follow_to_the_end(contact, count, lanes, labels, leaving, epsilon_t, switches)
    if resting > 0:
        put_again(contact, resting, kappa, psi, error_bound, lanes, labels)
        fill_lanes(resting, lanes)
        stick_through_rise(contact, whole(resting), lanes)
        count, leaving = leave(contact, resting, lanes, labels, leaving, epsilon_t, switches)
        leaving = follow_to_the_end(contact, count, lanes, labels, leaving, epsilon_t, switches)
    return leaving


@compiled
def follow_to_the_end(
    contact: Viscoelastic,
    count: int,
    lanes: FloatArray,
    labels: Labels,
    leaving: int,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
) -> int:
    """Return how many are in doubt after `count` lanes have slid and stuck until the end."""
    while count > 0:
        fill_lanes(count, lanes)
        slide(contact, True, whole(count), lanes)
        stick_from_fall(contact, whole(count), lanes)
        count, leaving = leave(contact, count, lanes, labels, leaving, epsilon_t, switches)
    return leaving


@compiled
def put_again(
    contact: Viscoelastic,
    resting: int,
    kappa: FloatArray,
    psi: FloatArray,
    error_bound: FloatArray,
    lanes: FloatArray,
    labels: Labels,
) -> None:
    """Put those in lanes that do not meet the cap early."""
    for i in range(resting):
        j = labels[RESTING + i]
        put(i, lanes, labels, j, scaled_stiffness(contact, kappa[j]), psi[j], error_bound[j])
        # `leave` counts a sliding before each sticking, which there was not
        labels[COUNT + i] = -1
        lanes[REACH + i] = 0.0


@compiled
def softest_in_lanes(contact: Viscoelastic) -> float:
    """Return κ, in the units of the contact, from which on no cap curves away in mid-contact."""
    least: float = (1.0 + CLOSE) * contact.ridge_value if contact.ridge >= 0.0 else 0.0
    return max(SOFTEST, least)


@compiled
def enter(
    contact: Viscoelastic,
    stiffest: float,
    begin: int,
    end: int,
    kappa: FloatArray,
    psi: FloatArray,
    error_bound: FloatArray,
    lanes: FloatArray,
    labels: Labels,
) -> tuple[int, int]:
    """Return how many are in lanes, and how many are not for lanes."""
    count, leaving = 0, 0
    stiffest = min(stiffest, STIFFEST)
    softest, is_short = softest_in_lanes(contact), contact.pieces.shape[0] <= MOST_PIECES
    for j in range(begin, end):
        k, p = scaled_stiffness(contact, kappa[j]), psi[j]
        is_meant = softest <= k <= stiffest and WEAKEST <= p <= contact.strongest
        if is_meant and is_short and kappa[j] * p > contact.least_load:
            put(count, lanes, labels, j, k, p, error_bound[j])
            lanes[REACH + count] = 0.0
            count += 1
        else:
            labels[LEFT + leaving] = j
            leaving += 1
    return count, leaving


@compiled
def leave_touch(
    contact: Viscoelastic,
    count: int,
    lanes: FloatArray,
    labels: Labels,
    leaving: int,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
) -> tuple[int, int, int, int]:
    """Return how many stop sliding in the rising half, later, have not met the cap, are in doubt.

    The first stay in lanes; what slides to the end of the contact is done.
    """
    _, _, peak_loss, _ = damped_motion(contact, False, contact.rising_end)
    staying, late, resting = 0, 0, 0
    for i in range(count):
        j = labels[i]
        kappa, psi = lanes[KAPPA + i], lanes[PSI + i]
        target = lanes[TOWARDS + i] + lanes[LOSS + i]
        lacking = contact.impulse - target
        # more than 0 if sliding ends
        short = kappa * lacking - contact.last_slope
        margin = CLOSE * (kappa * (target + 2.0) + contact.last_slope)
        is_clear = abs(short) > margin and abs(target - peak_loss) > CLOSE * (1.0 + target)
        if lanes[DOUBT + i] > 0.0:
            # they are looked at once more
            labels[RESTING + resting] = j
            resting += 1
        elif not is_clear:
            labels[LEFT + leaving] = j
            leaving += 1
        elif target < peak_loss:
            move_up(i, staying, 1, target, lanes, labels)
            lanes[Q + staying], lanes[SLIP + staying] = lanes[Q + i], kappa * lanes[TOWARDS + i]
            staying += 1
        elif short > 0.0:
            # what it lacks waits in the place of its answer
            labels[LATE + late], epsilon_t[j] = j, lacking
            late += 1
        else:
            epsilon_t[j] = min(max(-lacking / psi, -1.0), 1.0)
            switches[j] = 1
    return staying, late, resting, leaving


@compiled
def join(
    contact: Viscoelastic,
    count: int,
    late: int,
    kappa: FloatArray,
    psi: FloatArray,
    error_bound: FloatArray,
    lanes: FloatArray,
    labels: Labels,
    epsilon_t: FloatArray,
) -> int:
    """Return the number of lanes after those that waited have joined."""
    for i in range(late):
        j = labels[LATE + i]
        put(count, lanes, labels, j, scaled_stiffness(contact, kappa[j]), psi[j], error_bound[j])
        labels[COUNT + count] = 1
        lanes[REACH + count] = epsilon_t[j]
        count += 1
    return count


@compiled
def leave(
    contact: Viscoelastic,
    count: int,
    lanes: FloatArray,
    labels: Labels,
    leaving: int,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
) -> tuple[int, int]:
    """Return how many of `count` lanes stop sliding once more, and how many are in doubt so far."""
    staying = 0
    for i in range(count):
        kappa, psi, side = lanes[KAPPA + i], lanes[PSI + i], lanes[SIDE + i]
        lacking = lanes[LOSS + i] - lanes[TOWARDS + i]
        j, switched = labels[i], labels[COUNT + i] + 2
        short = kappa * lacking - contact.last_slope
        margin = CLOSE * (kappa * (abs(lacking) + lanes[LOSS + i]) + contact.last_slope)
        is_clear = abs(short) > margin + 2.0 * kappa * lanes[ERROR + i]
        doubt = lanes[DOUBT + i] > 0.0 or not is_clear or switched > MOST_IN_LANES
        is_done = short <= 0.0
        if doubt:
            labels[LEFT + leaving] = j
            leaving += 1
        elif is_done:
            epsilon_t[j] = min(max(-side * lacking / psi, -1.0), 1.0)
            switches[j] = switched
        # overwritten by the next one, unless this lane stays
        move_up(i, staying, switched, lacking, lanes, labels)
        staying += 0 if doubt or is_done else 1
    return staying, leaving
