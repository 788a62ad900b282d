"""What a table takes, and which are refused."""

from typing import NamedTuple

import numpy as np

from restitution.errors import CostError
from restitution.mechanics.collision import MOST_SWITCHES, expected_switch_counts
from restitution.methods.exact import DEARER_BY_DAMPING
from restitution.studies.collision.axis import Axis
from restitution.studies.tables.entries import (
    SECONDS_FOR_A_COLLISION,
    seconds_for_collisions,
    seconds_for_motion,
)
from restitution.studies.tables.grid import LEAST_SEARCH, SEARCH, Nodes, TableGrid
from restitution.studies.tables.largest_error import SHARPENED, SHARPENINGS


def refuse_stiff(nodes: Nodes) -> None:
    """Raise `CostError` if a collision at the nodes has too many switches to be followed."""
    _, psis, kappas = nodes.values
    # they are most for the largest κ
    kappa = np.full(psis.shape, kappas[-1])
    counts = [expected_switch_counts(kappa, psis, eta) for eta in _few_dampings(nodes)]
    if any(np.any(count > MOST_SWITCHES) for count in counts):
        raise CostError(
            f"some collisions of this table have more than {MOST_SWITCHES:,} switches, the "
            "limit. Ask for softer ones"
        )


def _few_dampings(nodes: Nodes) -> list[float]:
    """Return values of η that stand for all, of which each would take a normal motion."""
    etas = nodes.values[0]
    return sorted({float(etas[0]), float(etas[etas.size // 2]), float(etas[-1])})


def counts_of(grid: TableGrid) -> str:
    """Return the counts of a grid in words, κ first."""
    return " × ".join(f"{count:,}" for count in reversed(grid.shape))


class Seconds(NamedTuple):
    """Of one core, about."""

    entries: float
    """For the entries, or for the errors at as many places."""
    table: float
    """For these and all that may be done to know their largest error."""


def _seconds(grid: TableGrid, plane: float, dearest: float) -> Seconds:
    """Return what a table takes by what the collisions of one η and the dearest of them take."""
    third = grid.damping
    largest, count = (third.maximum, third.count) if isinstance(third, Axis) else (third, 1)
    motion, axes = seconds_for_motion(largest), len(grid.axes)
    entries = (plane + motion) * count
    # edges and faces of cells
    lines = 2**axes - 2
    step = 2 * axes * dearest
    if isinstance(third, Axis):
        # the η of a place, and one on either side
        step += 3.0 * motion
    sharpened = SHARPENINGS * SHARPENED * step
    search = max(LEAST_SEARCH, SEARCH * entries)
    return Seconds(entries, (1 + lines) * entries + search + sharpened)


def least_seconds(grid: TableGrid) -> Seconds:
    """Return what is expected of a table on a grid if its collisions have few switches."""
    least = SECONDS_FOR_A_COLLISION * (DEARER_BY_DAMPING if grid.damped else 1.0)
    return _seconds(grid, least * grid.kappa.count * grid.psi.count, least)


def refuse_costly(
    grid: TableGrid, nodes: Nodes | None, seconds: float, spent: float = 0.0
) -> Seconds:
    """Return the seconds of one core that a table takes, about, rather too many than too few.

    Raises
    ------
    CostError
        If these are, with those already `spent` on smaller ones, more than `seconds`.
    """
    expected = least_seconds(grid)
    if nodes is not None and expected.table + spent <= seconds:
        refuse_stiff(nodes)
        _, psis, kappas = nodes.values
        columns, rows = (values.ravel() for values in np.meshgrid(kappas, psis))
        planes = [
            seconds_for_collisions(columns, rows, eta, expected_switch_counts(columns, rows, eta))
            for eta in _few_dampings(nodes)
        ]
        plane = max(float(each.sum()) for each in planes)
        expected = _seconds(grid, plane, max(float(each.max()) for each in planes))
    if expected.table + spent > seconds:
        after = f", after {spent:.2g} s for smaller ones" if spent else ""
        raise CostError(
            f"this table of {counts_of(grid)} would take about {expected.table:.2g} s of "
            f"one core{after}; the limit is {seconds:g} s. Ask for a narrower range, softer "
            "collisions or a larger error, or have it computed by `restitution table --store`"
        )
    return expected
