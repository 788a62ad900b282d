"""ε_t(κ, ψ) or ε_t(κ, ψ, η) on a grid for other codes, and how far interpolation in it is off."""

import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

from restitution.errors import CostError
from restitution.mechanics.collision import workers
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import sliding_threshold
from restitution.studies.collision.axis import Axis
from restitution.studies.tables.boxes import Judge
from restitution.studies.tables.cost import counts_of, least_seconds, refuse_costly
from restitution.studies.tables.entries import tabulate
from restitution.studies.tables.grid import LEAST_SEARCH, SEARCH, Nodes, Sign, TableGrid
from restitution.studies.tables.largest_error import (
    ErrorBasis,
    LargestError,
    largest_error,
    safety,
)
from restitution.studies.tabular import Table, Tabular

FEWEST = 16
FEWEST_DAMPINGS = 4
GROWTH = math.sqrt(2.0)
"""Of the count along the axis with the largest error, from one try to the next."""

LIKELY = 1.1
"""Largest error found in a table over the largest in the middle of an edge of a cell, at first."""

HOPELESS = 10.0
"""Times the limit; an estimate of more than that is believed before all of the limit is spent."""


@dataclass(frozen=True)
class RestitutionTable(TableGrid, Tabular):
    """A table for linear interpolation along every axis.

    Attributes
    ----------
    epsilon_t : ndarray, shape (psi.count, kappa.count) or (damping.count, psi.count, kappa.count)
        Entries, rounded as its files have them, in the given sign.
    sign : str
        ``paper``: +1 for smooth spheres; ``reversed``: −1 for smooth spheres.
    largest_error : float
        Of interpolation in the coordinates in which the grid is equidistant.
    error_basis : str
        What that rests on: ``proven``, ``measured slope`` or ``sampled``.
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
    error_basis: ErrorBasis
    slides_above: float

    def table(self) -> Table:
        """Return the entries over η, where it is an axis, ψ and κ."""
        nodes = dict(zip(("damping", "psi", "kappa"), self.nodes().values, strict=True))
        axes = {name: nodes[name] for name in self.axes}
        return Table(
            axes,
            {"epsilon_t": self.epsilon_t},
            {name: values[0] for name, values in nodes.items() if name not in axes},
            {
                "sign": self.sign,
                "largest_error": self.largest_error,
                "error_basis": self.error_basis,
            },
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
    return _study(TableGrid(kappa, psi, damping), sign, seconds, math.inf)


def _study(grid: TableGrid, sign: Sign, seconds: float, wanted: float) -> RestitutionTable:
    """Return a table, whose error is sought as far as to tell whether it is the one `wanted`."""
    nodes = grid.nodes() if least_seconds(grid).table <= seconds else None
    refuse_costly(grid, nodes, seconds)
    assert nodes is not None
    entries, largest = tabulated(nodes, sign, workers(), wanted)
    threshold = float(sliding_threshold(grid.kappa.minimum))
    above = math.nan if grid.damped or grid.psi.maximum < threshold else grid.psi.maximum
    return RestitutionTable(
        grid.kappa,
        grid.psi,
        grid.damping,
        entries.reshape(grid.shape),
        sign,
        largest.stated,
        largest.basis,
        above,
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
    likely = LIKELY * safety(in_three="damping" in grid.axes)
    best, spent, failed = math.inf, 0.0, 0.0
    while True:
        nodes = grid.nodes()
        try:
            expected = refuse_costly(grid, nodes, seconds, spent)
        except CostError as refused:
            reached = f"{best:.2g} at most so far" if math.isfinite(best) else "nothing so far"
            raise CostError(
                f"an error of {error:g} takes more than {counts_of(grid)} entries "
                f"here ({reached}): {refused}"
            ) from refused
        errors = _errors_along(grid, nodes)
        spent += expected.entries * (1 + len(errors))
        worst = max(errors, key=errors.__getitem__)
        best = min(best, likely * errors[worst])
        # the error of linear interpolation falls with the square of the distance at best
        more = math.prod(math.sqrt(max(1.0, likely * e / error)) for e in errors.values())
        if more * least_seconds(grid).table > HOPELESS * seconds:
            raise CostError(
                f"an error of {error:g} takes about {more * math.prod(grid.shape):.1g} entries or "
                f"more here ({best:.2g} at most so far); the limit of {seconds:g} s of one core is "
                "far below. Ask for a larger error, or for a narrower range"
            )
        if likely * errors[worst] <= error and failed * sum(errors.values()) <= error:
            table = _study(grid, sign, seconds, error)
            spent += expected.table
            if table.largest_error <= error:
                return table
            failed = table.largest_error / sum(errors.values())
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
    nodes: Nodes, sign: Sign, threads: ThreadPoolExecutor | None = None, wanted: float = math.inf
) -> tuple[FloatArray, LargestError]:
    """Return the entries [η][ψ][κ] and what is known of the largest error of interpolation.

    It is done in the calling thread unless there are others. The error is sought until it is known
    well, or whether it is at most the one `wanted`.
    """
    entries, seconds = tabulate(nodes, threads)
    search = max(LEAST_SEARCH, SEARCH * seconds)
    largest = largest_error(entries, nodes, search, threads, wanted)
    # adding 0 makes −0 the 0 that it equals
    return (entries if sign == "paper" else 0.0 - entries) + 0.0, largest


def _errors_along(grid: TableGrid, nodes: Nodes) -> dict[str, float]:
    """Return for each axis the largest error in the middle of an edge of a cell along it.

    They tell which axis to refine.
    """
    entries, _ = tabulate(nodes, workers())
    judge = Judge(entries, nodes, workers())
    return {
        name: float(judge.errors(*judge.midway([axis])).max())
        for name, axis in zip(reversed(grid.axes), (2, 1, 0), strict=False)
    }
