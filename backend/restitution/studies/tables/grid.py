"""Where the entries of a table are, and where interpolation between them is judged."""

from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

import numpy as np

from restitution.errors import require
from restitution.mechanics.compiled import MODEL_VERSION
from restitution.mechanics.contact import MOST_DAMPING
from restitution.mechanics.hertz import FloatArray
from restitution.studies.collision.axis import Axis

Sign = Literal["paper", "reversed"]

DIGITS = 9
"""Decimals of the entries, so that every form of a table holds the same numbers."""

SHARES = (0.2, 0.5, 0.8)
SAMPLED = tuple(
    (SHARES[(i + j) % 3], across, along)
    for j, across in enumerate(SHARES)
    for i, along in enumerate(SHARES)
)
"""Where in a cell interpolation is judged, along η, ψ and κ; never at an entry.

A Latin square: all nine pairs of shares along any two of the axes."""

SAFETY = 1.5
"""Stated over largest sampled error, in two parameters.

A measured factor, not a proof: over 60 random grids, 20 × 20 samples in a cell instead of these
3 × 3 raised the largest error of a table by 20 % at most; with damping, over 40 grids, by 28 %."""

SAFETY_IN_THREE = 2.0
"""The same in three: over 300 random grids, 6 × 6 × 6 samples raised it by 37 % at most."""


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

    @property
    def safety(self) -> float:
        """The largest error that is stated, over the largest among the samples."""
        return SAFETY_IN_THREE if isinstance(self.damping, Axis) else SAFETY

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

    def within_cells(self, shares: tuple[float, float, float]) -> "Nodes":
        """Return the values at these shares of every cell; 0 stands for the nodes themselves."""
        etas, psis, kappas = (
            _at_share(*along) for along in zip(self.values, self.scales, shares, strict=True)
        )
        return replace(self, values=(etas, psis, kappas))


def _at_share(values: FloatArray, scale: str, share: float) -> FloatArray:
    """Return the values at this share of every cell along an axis."""
    if scale == "log" and share:
        return np.asarray(np.exp(between(np.log(values), share)))
    return between(values, share)


def between(values: FloatArray, share: float) -> FloatArray:
    """Return values linearly between those of neighbours along the first axis; 0 for themselves."""
    return values if share == 0.0 else (1.0 - share) * values[:-1] + share * values[1:]


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
        "sampled": [list(shares) for shares in SAMPLED],
        "safety": grid.safety,
        "model_version": MODEL_VERSION,
    }


def grid_from(provenance: dict[str, Any]) -> TableGrid:
    """Return the grid that `provenance` describes."""
    axes = {name: Axis(**axis) for name, axis in provenance["axes"].items()}
    return TableGrid(axes["kappa"], axes["psi"], axes.get("damping", provenance["damping"]))
