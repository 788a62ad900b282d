"""What a table takes, and which are refused."""

import math

import numpy as np

from restitution.errors import CostError
from restitution.mechanics.collision import MOST_SWITCHES, expected_switch_counts
from restitution.methods.exact import DEARER_BY_DAMPING, cost
from restitution.studies.collision.axis import Axis
from restitution.studies.tables.entries import SECONDS_FOR_A_COLLISION, seconds_for_motion
from restitution.studies.tables.grid import SEARCH, Nodes, TableGrid


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


def least_seconds(grid: TableGrid) -> float:
    """Return what no table on a grid takes less than."""
    dearer = DEARER_BY_DAMPING if grid.damped else 1.0
    least = dearer * SECONDS_FOR_A_COLLISION * math.prod(grid.shape)
    if isinstance(grid.damping, Axis):
        least += seconds_for_motion(grid.damping.maximum) * grid.damping.count
    return (1.0 + SEARCH) * least


def refuse_costly(
    grid: TableGrid, nodes: Nodes | None, seconds: float, spent: float = 0.0
) -> float:
    """Return the seconds of one core that a table takes, about.

    Raises
    ------
    CostError
        If these are, with those already `spent` on smaller ones, more than `seconds`.
    """
    expected = least_seconds(grid)
    if nodes is not None and expected + spent <= seconds:
        refuse_stiff(nodes)
        _, psis, kappas = nodes.values
        columns, rows = (values.ravel() for values in np.meshgrid(kappas, psis))
        few = _few_dampings(nodes)
        plane = sum(cost(columns, rows, eta) for eta in few) / len(few)
        expected = max(expected, (1.0 + SEARCH) * plane * nodes.values[0].size)
    if expected + spent > seconds:
        after = f", after {spent:.2g} s for smaller ones" if spent else ""
        raise CostError(
            f"this table of {counts_of(grid)} would take about {expected:.2g} s of "
            f"one core{after}; the limit is {seconds:g} s. Ask for a narrower range, softer "
            "collisions or a larger error, or have it computed by `restitution table --store`"
        )
    return expected
