"""A block of collisions in lanes, from the touch to the end of the contact."""

import math

import numpy as np
import numpy.typing as npt

from restitution.mechanics.compiled import compiled
from restitution.mechanics.elastic import Elastic
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes.first_sticking import CLOSE, stick_from_compression
from restitution.mechanics.lanes.rows import (
    COUNT,
    DOUBT,
    ERROR,
    KAPPA,
    LARGEST,
    LATE,
    LEFT,
    LOSS,
    OMEGA,
    PSI,
    REACH,
    ROOT,
    SIDE,
    TOWARDS,
    Labels,
    repeat_last,
    whole,
)
from restitution.mechanics.lanes.sliding import largest_reach, slide
from restitution.mechanics.lanes.sticking import stick_in_decompression
from restitution.mechanics.switching import MONOTONE_STIFFNESS

SOFTEST, STIFFEST = 0.05, 1e6
"""κ from which on and up to which collisions are in lanes."""

WEAKEST = 1e-6
"""ψ from which on they are."""

MOST_IN_LANES = 4096
"""More switches than a collision in lanes has; it has about √κ at most."""


@compiled
def collide_block(
    _: Elastic,
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

    Parameters
    ----------
    stiffest : float
        κ up to which they are taken, if `STIFFEST` is not less.
    begin, end : int
        At most `BLOCK` apart.
    kappa, psi, error_bound : ndarray, shape (N,)
        κ, ψ and `elastic.rounding_bound`.
    lanes, labels : ndarray
        Work space, of `rows.ROWS` and `rows.LABELS`.
    epsilon_t, switches : ndarray, shape (N,)
        Filled in, as in `collision.Collision`; all of these are certain.

    Returns
    -------
    int
        How many are left for `collision.follow`: `labels` has them from `LEFT` on.
    """
    count, late, leaving = enter(
        stiffest, begin, end, kappa, psi, error_bound, lanes, labels, epsilon_t, switches
    )
    if count > 0:
        fill_lanes(count, lanes)
        slide(whole(count), lanes)
        stick_from_compression(whole(count), lanes)
        count, leaving = leave(count, lanes, labels, leaving, epsilon_t, switches)
    count = join(count, late, kappa, psi, error_bound, lanes, labels)
    while count > 0:
        fill_lanes(count, lanes)
        slide(whole(count), lanes)
        stick_in_decompression(whole(count), lanes)
        count, leaving = leave(count, lanes, labels, leaving, epsilon_t, switches)
    return leaving


@compiled
def enter(
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
) -> tuple[int, int, int]:
    """Return how many stop sliding in the compression, later, and how many are not for lanes.

    The first are in lanes, the second wait; what slides throughout is done (Eq. 15). As
    `switching.first_sliding_end` has it.
    """
    count, late, leaving = 0, 0, 0
    stiffest = min(stiffest, STIFFEST)
    find_largest_reach(begin, end, kappa, lanes)
    for j in range(begin, end):
        k, p, largest = kappa[j], psi[j], lanes[LARGEST + j - begin]
        load, threshold = k * p, max(2.0 * k, largest)
        is_meant = SOFTEST <= k <= stiffest and p >= WEAKEST
        is_clear = (
            abs(load - threshold) > CLOSE * threshold and abs(load - largest) > CLOSE * largest
        )
        if not (is_meant and is_clear):
            labels[LEFT + leaving] = j
            leaving += 1
        elif load > threshold:
            epsilon_t[j], switches[j] = 1.0 - 2.0 / p, 0
        elif load < largest:
            put(count, lanes, labels, j, k, p, error_bound[j])
            lanes[REACH + count] = load
            count += 1
        else:
            labels[LATE + late] = j
            late += 1
    return count, late, leaving


@compiled
def find_largest_reach(begin: int, end: int, kappa: FloatArray, lanes: FloatArray) -> None:
    """Fill `LARGEST`; where R rises throughout the compression, it is κ."""
    soft = 0
    for i in range(end - begin):
        lanes[LARGEST + i] = kappa[begin + i]
        soft += kappa[begin + i] < MONOTONE_STIFFNESS
    if soft > 0:
        for i in range(end - begin):
            k = kappa[begin + i]
            reach = largest_reach(min(k, MONOTONE_STIFFNESS))
            lanes[LARGEST + i] = reach if k < MONOTONE_STIFFNESS else k


@compiled
def put(
    i: int, lanes: FloatArray, labels: Labels, j: int, kappa: float, psi: float, bound: float
) -> None:
    """Put collision j into lane i, on its positive side and without a switch."""
    labels[i], labels[COUNT + i] = j, 0
    lanes[KAPPA + i], lanes[OMEGA + i], lanes[PSI + i] = kappa, math.sqrt(kappa), psi
    lanes[ERROR + i], lanes[SIDE + i], lanes[DOUBT + i] = bound * psi, 1.0, 0.0


@compiled
def join(
    count: int,
    late: int,
    kappa: FloatArray,
    psi: FloatArray,
    error_bound: FloatArray,
    lanes: FloatArray,
    labels: Labels,
) -> int:
    """Return the number of lanes after those that waited have joined."""
    for i in range(late):
        j = labels[LATE + i]
        put(count, lanes, labels, j, kappa[j], psi[j], error_bound[j])
        lanes[REACH + count] = kappa[j] * (2.0 - psi[j])
        count += 1
    return count


@compiled
def fill_lanes(count: int, lanes: FloatArray) -> None:
    """Fill up the rows from which a step computes the others."""
    repeat_last(count, lanes, KAPPA)
    repeat_last(count, lanes, OMEGA)
    repeat_last(count, lanes, PSI)
    repeat_last(count, lanes, SIDE)
    repeat_last(count, lanes, REACH)


@compiled
def move_up(
    i: int, free: int, switched: int, reach: float, lanes: FloatArray, labels: Labels
) -> None:
    """Let the collision of lane i go on in a free one, with its switches and the next `REACH`."""
    labels[free], labels[COUNT + free] = labels[i], switched
    lanes[KAPPA + free], lanes[OMEGA + free] = lanes[KAPPA + i], lanes[OMEGA + i]
    lanes[PSI + free], lanes[ERROR + free] = lanes[PSI + i], lanes[ERROR + i]
    lanes[SIDE + free], lanes[DOUBT + free] = lanes[SIDE + i], 0.0
    lanes[REACH + free] = reach


@compiled
def leave(
    count: int,
    lanes: FloatArray,
    labels: Labels,
    leaving: int,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
) -> tuple[int, int]:
    """Return how many of `count` lanes stop sliding once more, and how many are in doubt so far.

    Who slides to the end of the contact is done; the others close up, with the reach at which
    their sliding ends.
    """
    staying = 0
    for i in range(count):
        kappa, psi, side = lanes[KAPPA + i], lanes[PSI + i], lanes[SIDE + i]
        root, loss = lanes[ROOT + i], lanes[LOSS + i]
        lacking = loss - lanes[TOWARDS + i]
        j, switched = labels[i], labels[COUNT + i] + 2
        is_done = lacking <= 0.0
        # faster than the cap a spring is where only rounding has put it there
        is_faster = kappa * lacking > kappa * loss + 1.5 * root * (1.0 - loss)
        is_clear = abs(lacking) > 2.0 * lanes[ERROR + i]
        doubt = lanes[DOUBT + i] > 0.0 or is_faster or not is_clear or switched > MOST_IN_LANES
        if doubt:
            labels[LEFT + leaving] = j
            leaving += 1
        elif is_done:
            epsilon_t[j] = min(max(-side * lacking / psi, -1.0), 1.0)
            switches[j] = switched
        # overwritten by the next one, unless this lane stays
        move_up(i, staying, switched, kappa * lacking, lanes, labels)
        staying += 0 if doubt or is_done else 1
    return staying, leaving
