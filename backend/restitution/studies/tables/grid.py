"""Where the entries of a table are, and how much work their error is worth."""

from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from restitution.errors import require
from restitution.mechanics.compiled import MODEL_VERSION
from restitution.mechanics.contact import MOST_DAMPING
from restitution.mechanics.hertz import FloatArray
from restitution.studies.collision.axis import Axis

Sign = Literal["paper", "reversed"]

IntegerArray = npt.NDArray[np.int64]

DIGITS = 9
"""Decimals of the entries, so that every form of a table holds the same numbers."""

SEARCH = 9.0
"""Work of the search for the largest error over that of the entries, at most."""

LEAST_SEARCH = 0.1
"""Seconds of one core that it may take however few the entries."""


@dataclass(frozen=True)
class TableGrid:
    """Where the entries of a table are.

    Attributes
    ----------
    kappa, psi : Axis
        Equidistant in κ and ψ or in their logarithms; ψ may begin at 0 on a linear scale, where
        the entry is the limit.
    damping : Axis or float
        η as a third axis, or of all entries.
    """

    kappa: Axis
    psi: Axis
    damping: Axis | float

    @property
    def axes(self) -> dict[str, Axis]:
        """The axes by name, in the order of the entries: κ runs fastest."""
        third = {"damping": self.damping} if isinstance(self.damping, Axis) else {}
        return third | {"psi": self.psi, "kappa": self.kappa}

    @property
    def shape(self) -> tuple[int, ...]:
        """The counts in that order."""
        return tuple(axis.count for axis in self.axes.values())

    @property
    def damped(self) -> bool:
        """Whether there is any viscous damping."""
        return self.damping != 0.0

    def nodes(self) -> "Nodes":
        """Return the values along η, ψ and κ.

        Raises
        ------
        ParameterError
            If a range is empty, or a value is not allowed.
        """
        third = self.damping
        if isinstance(third, Axis):
            etas, scale = third.values(positive=False), third.scale
        else:
            etas, scale = np.array([third]), "linear"
        psis, kappas = self.psi.values(positive=False), self.kappa.values(positive=True)
        require("kappa", kappas, np.isfinite(kappas), "finite and > 0")
        require("psi", psis, np.isfinite(psis) & (psis >= 0.0), "finite and ≥ 0")
        allowed = (etas >= 0.0) & (etas <= MOST_DAMPING)
        require("damping", etas, allowed, f"from 0 to {MOST_DAMPING:g}")
        return Nodes((etas, psis, kappas), (scale, self.psi.scale, self.kappa.scale))


@dataclass(frozen=True)
class Nodes:
    """Values along η, ψ and κ, of a grid or of a part of one, each with its scale."""

    values: tuple[FloatArray, FloatArray, FloatArray]
    scales: tuple[str, str, str]

    def part(self, *where: slice) -> "Nodes":
        """Return a part of them, one slice along each axis."""
        etas, psis, kappas = self.values
        return replace(self, values=(etas[where[0]], psis[where[1]], kappas[where[2]]))

    def within(self, axis: int, cell: IntegerArray, share: FloatArray) -> FloatArray:
        """Return values (N,) along an axis, at these shares of its cells."""
        values = self.values[axis]
        if values.size == 1:
            return np.full(cell.size, values[0])
        low, high = values[cell], values[cell + 1]
        if self.scales[axis] == "log":
            return np.asarray(np.exp((1.0 - share) * np.log(low) + share * np.log(high)))
        return (1.0 - share) * low + share * high


def provenance(grid: TableGrid, sign: Sign) -> dict[str, Any]:
    """Return as JSON has it all that a table on a grid depends on."""
    return {
        "axes": {
            name: {key: asdict(axis)[key] for key in ("minimum", "maximum", "count", "scale")}
            for name, axis in grid.axes.items()
        },
        "damping": None if isinstance(grid.damping, Axis) else grid.damping,
        "sign": sign,
        "digits": DIGITS,
        "search": SEARCH,
        "model_version": MODEL_VERSION,
    }


def grid_from(provenance: dict[str, Any]) -> TableGrid:
    """Return the grid that `provenance` describes."""
    axes = {name: Axis(**axis) for name, axis in provenance["axes"].items()}
    return TableGrid(axes["kappa"], axes["psi"], axes.get("damping", provenance["damping"]))
