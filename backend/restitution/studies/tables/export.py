"""ε_t(κ, ψ) or ε_t(κ, ψ, η) on a grid for other codes, and how far interpolation in it is off."""

import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from restitution.errors import CostError
from restitution.mechanics.collision import (
    MOST_SWITCHES,
    PART,
    collide,
    expected_switch_counts,
    workers,
)
from restitution.mechanics.contact import contact_of
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import sliding_threshold
from restitution.methods.exact import DEARER_BY_DAMPING, cost
from restitution.studies.collision.axis import Axis
from restitution.studies.tables.grid import DIGITS, SAMPLED, Nodes, Sign, TableGrid, between
from restitution.studies.tabular import Table, Tabular

LEAST_SECONDS = 5e-6
"""For an entry and the samples of its cell, without damping."""

SECONDS_FOR_DAMPING, SECONDS_FOR_TENFOLD = 6e-5, 4e-5
"""To prepare the normal motion of one η ≤ 1, and for each power of ten above: 1.2 ms at 1e30."""

FEWEST = 16
FEWEST_DAMPINGS = 4
GROWTH = math.sqrt(2.0)
"""Of the count along the axis with the largest error, from one try to the next."""

HOPELESS = 100.0
"""Times the limit; an estimate of more than that is believed before all of the limit is spent."""

MIDDLES = {"kappa": (0.0, 0.0, 0.5), "psi": (0.0, 0.5, 0.0), "damping": (0.5, 0.0, 0.0)}
"""The middle of an edge of every cell, along each axis, as shares along η, ψ and κ."""


@dataclass(frozen=True)
class RestitutionTable(TableGrid, Tabular):
    """A table for linear interpolation along every axis.

    Attributes
    ----------
    epsilon_t : ndarray, shape (psi.count, kappa.count) or (damping.count, psi.count, kappa.count)
        Entries, rounded to `DIGITS` decimals, in the given sign.
    sign : str
        ``paper``: +1 for smooth spheres; ``reversed``: −1 for smooth spheres.
    largest_error : float
        Of interpolation in the coordinates in which the grid is equidistant: `safety` times the
        largest error at 9 points of every cell, none of them an entry. Measured, not proven.
    slides_above : float
        ψ from which on 1 − 2/ψ is exact for every κ of the grid; NaN if the grid ends below, and
        with damping, where every collision sticks at first.

    Examples
    --------
    >>> study_table(Axis(3, 6, 5), Axis(0.1, 2, 4), "paper", seconds=1.0).to_xarray().epsilon_t.dims
    ('psi', 'kappa')
    """

    epsilon_t: FloatArray
    sign: Sign
    largest_error: float
    slides_above: float

    def table(self) -> Table:
        """Return the entries over η, where it is an axis, ψ and κ."""
        nodes = dict(zip(("damping", "psi", "kappa"), self.nodes().values, strict=True))
        axes = {name: nodes[name] for name in self.axes}
        return Table(
            axes,
            {"epsilon_t": self.epsilon_t},
            {name: values[0] for name, values in nodes.items() if name not in axes},
            {"sign": self.sign, "largest_error": self.largest_error},
        )


def study_table(
    kappa: Axis, psi: Axis, sign: Sign, damping: Axis | float = 0.0, *, seconds: float
) -> RestitutionTable:
    """Return the table on a given grid.

    Parameters
    ----------
    kappa, psi, damping
        As of `TableGrid`.
    sign : ``"paper"`` or ``"reversed"``
        Convention of the entries.
    seconds : float
        Time of one core that it may take, about.

    Raises
    ------
    ParameterError
        If a range is empty or not positive where it has to be.
    CostError
        If it would take more than that.
    """
    grid = TableGrid(kappa, psi, damping)
    nodes = grid.nodes() if _least_seconds(grid) <= seconds else None
    _refuse_costly(grid, nodes, seconds)
    assert nodes is not None
    entries, sampled = tabulated(nodes, sign, workers())
    threshold = float(sliding_threshold(kappa.minimum))
    above = math.nan if grid.damped or psi.maximum < threshold else psi.maximum
    return RestitutionTable(
        kappa, psi, damping, entries.reshape(grid.shape), sign, grid.safety * sampled, above
    )


def study_table_within(
    error: float,
    kappa: Axis,
    psi: Axis,
    sign: Sign,
    damping: Axis | float = 0.0,
    *,
    seconds: float,
) -> RestitutionTable:
    """Return a table whose largest error is at most `error`; as of `study_table`.

    The counts of the axes are found by trying; what is out of reach is refused at once.
    """
    third = replace(damping, count=FEWEST_DAMPINGS) if isinstance(damping, Axis) else damping
    grid = TableGrid(replace(kappa, count=FEWEST), replace(psi, count=FEWEST), third)
    best, spent = math.inf, 0.0
    while True:
        nodes = grid.nodes()
        try:
            expected = _refuse_costly(grid, nodes, seconds, spent)
        except CostError as refused:
            reached = f"{best:.2g} at most so far" if math.isfinite(best) else "nothing so far"
            raise CostError(
                f"an error of {error:g} takes more than {_counts(grid)} entries "
                f"here ({reached}): {refused}"
            ) from refused
        # errors of interpolation along every axis alone tell which of them to refine
        entries = _entries(nodes, workers())
        errors = {
            name: _error_at(entries, nodes, shares, workers())
            for name, shares in MIDDLES.items()
            if name in grid.axes
        }
        spent += expected * (1 + len(errors)) / (1 + len(SAMPLED))
        worst = max(errors, key=errors.__getitem__)
        best = min(best, grid.safety * errors[worst])
        # the error of linear interpolation falls with the square of the distance at best
        more = math.prod(math.sqrt(max(1.0, grid.safety * e / error)) for e in errors.values())
        if more * _least_seconds(grid) > HOPELESS * seconds:
            raise CostError(
                f"an error of {error:g} takes about {more * math.prod(grid.shape):.1g} entries or "
                f"more here ({best:.2g} at most so far); the limit of {seconds:g} s of one core is "
                "far below. Ask for a larger error, or for a narrower range"
            )
        if grid.safety * errors[worst] <= error:
            table = study_table(grid.kappa, grid.psi, sign, grid.damping, seconds=seconds)
            spent += expected
            if table.largest_error <= error:
                return table
        count = math.ceil(GROWTH * grid.axes[worst].count)
        grid = replace(grid, **{worst: replace(grid.axes[worst], count=count)})


def study_table_as_wanted(
    error: float | None,
    kappa: Axis,
    psi: Axis,
    sign: Sign,
    damping: Axis | float = 0.0,
    *,
    seconds: float,
) -> RestitutionTable:
    """Return a table with the counts of its axes or, where an error is wanted, those for it."""
    if error is None:
        return study_table(kappa, psi, sign, damping, seconds=seconds)
    return study_table_within(error, kappa, psi, sign, damping, seconds=seconds)


def tabulated(
    nodes: Nodes, sign: Sign, threads: ThreadPoolExecutor | None = None
) -> tuple[FloatArray, float]:
    """Return the entries [η][ψ][κ] and the largest error at `SAMPLED` points of every cell.

    It is done in the calling thread unless there are others.
    """
    entries = _entries(nodes, threads)
    largest = max(_error_at(entries, nodes, shares, threads) for shares in SAMPLED)
    # adding 0 makes −0 the 0 that it equals
    signed = entries if sign == "paper" else 0.0 - entries
    return signed + 0.0, largest


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


def _counts(grid: TableGrid) -> str:
    """Return the counts of a grid in words, κ first."""
    return " × ".join(f"{count:,}" for count in reversed(grid.shape))


def _least_seconds(grid: TableGrid) -> float:
    """Return what no table on a grid takes less than."""
    entries = math.prod(grid.shape)
    if not grid.damped:
        return LEAST_SECONDS * entries
    least = DEARER_BY_DAMPING * LEAST_SECONDS * entries
    if isinstance(grid.damping, Axis):
        tenfold = max(0.0, math.log10(grid.damping.maximum))
        each = SECONDS_FOR_DAMPING + SECONDS_FOR_TENFOLD * tenfold
        least += (1 + len(SAMPLED)) * each * grid.damping.count
    return least


def _refuse_costly(
    grid: TableGrid, nodes: Nodes | None, seconds: float, spent: float = 0.0
) -> float:
    """Return the seconds of one core that a table takes, about.

    Raises
    ------
    CostError
        If these are, with those already `spent` on smaller ones, more than `seconds`.
    """
    expected = _least_seconds(grid)
    if nodes is not None and expected + spent <= seconds:
        refuse_stiff(nodes)
        _, psis, kappas = nodes.values
        columns, rows = (values.ravel() for values in np.meshgrid(kappas, psis))
        few = _few_dampings(nodes)
        plane = sum(cost(columns, rows, eta) for eta in few) / len(few)
        expected = max(expected, (1 + len(SAMPLED)) * plane * nodes.values[0].size)
    if expected + spent > seconds:
        after = f", after {spent:.2g} s for smaller ones" if spent else ""
        raise CostError(
            f"this table of {_counts(grid)} would take about {expected:.2g} s of "
            f"one core{after}; the limit is {seconds:g} s. Ask for a narrower range, softer "
            "collisions or a larger error, or have it computed by `restitution table --store`"
        )
    return expected


def _entries(nodes: Nodes, threads: ThreadPoolExecutor | None) -> FloatArray:
    """Return ε_t [η][ψ][κ] in the paper's sign, rounded."""
    return np.round(_exact(nodes, threads)[0], DIGITS)


def _error_at(
    entries: FloatArray,
    nodes: Nodes,
    shares: tuple[float, float, float],
    threads: ThreadPoolExecutor | None,
) -> float:
    """Return the largest error of interpolation at one point of every cell."""
    # of an axis with one value there are no cells
    inside = [
        share if values.size > 1 else 0.0
        for share, values in zip(shares, nodes.values, strict=True)
    ]
    interpolated = entries
    for axis, share in enumerate(inside):
        interpolated = np.moveaxis(between(np.moveaxis(interpolated, axis, 0), share), 0, axis)
    truth, bound = _exact(nodes.within_cells((inside[0], inside[1], inside[2])), threads)
    return float(np.abs(interpolated - truth).max() + bound)


def _exact(nodes: Nodes, threads: ThreadPoolExecutor | None) -> tuple[FloatArray, float]:
    """Return ε_t [η][ψ][κ] in the paper's sign and the largest bound on its error."""
    etas, psis, kappas = nodes.values
    entries = np.empty((etas.size, psis.size, kappas.size))
    bound = 0.0
    for plane, eta in zip(entries, etas.tolist(), strict=True):
        flat = plane.reshape(-1)

        # no more at a time than `collide` leaves to the calling thread
        def fill(part: slice, flat: FloatArray = flat, eta: float = eta) -> float:
            row, column = np.divmod(np.arange(part.start, part.stop), kappas.size)
            found = collide(kappas[column], psis[row], eta)
            flat[part] = found.epsilon_t
            return float(found.error_bound.max())

        # kept, or else every thread would prepare it
        contact_of(eta)
        parts = [slice(i, min(i + PART, flat.size)) for i in range(0, flat.size, PART)]
        bounds = threads.map(fill, parts) if threads else map(fill, parts)
        bound = max(bound, *bounds)
    return entries, bound
