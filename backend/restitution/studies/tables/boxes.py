"""Parts of the cells of a table, and how large the error of interpolation may be in each.

Interpolation is multilinear, so that its range in a box is that of its corners. ε_t is known in the
middle, and changes from there by no more than `mechanics.variation` says.
"""

from collections.abc import Collection
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.mechanics import variation
from restitution.mechanics.hertz import FloatArray
from restitution.studies.tables.entries import follow_all
from restitution.studies.tables.grid import IntegerArray, Nodes

AT_ONCE = 2**15
"""Boxes that are judged together: some 20 MB."""

SECONDS_FOR_A_BOX = 5e-7
"""Beside those for its collision."""


class Boxes(NamedTuple):
    """Boxes (N,), first those parts of cells that were judged, and what was found."""

    cell: IntegerArray
    """Place of the cell along η, ψ and κ, (3, N)."""
    low: FloatArray
    """Where in its cell a box begins, (3, N) shares."""
    width: FloatArray
    """How much of its cell it is, (3, N) shares; 0 along what is no axis."""
    error: FloatArray
    """In the middle."""
    bound: FloatArray
    """On the error anywhere in the box."""
    along: IntegerArray
    """The axis along which it is to be halved."""
    seconds: FloatArray
    """Of one core that judging it took, about."""

    def part(self, which: IntegerArray | npt.NDArray[np.bool_] | slice) -> "Boxes":
        """Return some of them."""
        columns: tuple[Any, ...] = self
        return Boxes(*(column[..., which] for column in columns))

    def widest(self) -> FloatArray:
        """Return how wide they are along the axis along which they are to be halved."""
        return self.width[self.along, np.arange(self.along.size)]

    @staticmethod
    def joined(lots: "list[Boxes]") -> "Boxes":
        """Return all boxes of several lots."""
        columns: Any = zip(*lots, strict=True)
        return Boxes(*(np.concatenate(column, -1) for column in columns))


class Judge:
    """What is asked about the errors of one table [η][ψ][κ] between its nodes."""

    def __init__(
        self, entries: FloatArray, nodes: Nodes, threads: ThreadPoolExecutor | None
    ) -> None:
        self.entries, self.nodes, self.threads = entries, nodes, threads
        self.axes = [axis for axis, values in enumerate(nodes.values) if values.size > 1]
        self.damped = bool(nodes.values[0].any())

    def cells(self) -> Boxes:
        """Return the cells, judged."""
        cell, middle = self.midway(self.axes)
        return self._judged(cell, np.zeros(middle.shape), 2.0 * middle)

    def midway(self, along: Collection[int]) -> tuple[IntegerArray, FloatArray]:
        """Return the places, cell and share, in the middle between neighbours along some axes.

        Along the others they are at the nodes.
        """
        counts = np.array([values.size for values in self.nodes.values])
        between = np.isin(np.arange(3), list(along))
        node = np.indices(tuple((counts - between).tolist())).reshape(3, -1)
        # the last node is the end of the last cell
        cell = np.minimum(node, np.maximum(counts - 2, 0)[:, None])
        return cell, node - cell + 0.5 * between[:, None]

    def halves(self, boxes: Boxes) -> Boxes:
        """Return the halves of boxes, judged."""
        here = boxes.along, np.arange(boxes.along.size)
        width, upper = boxes.width.copy(), boxes.low.copy()
        width[here] *= 0.5
        upper[here] += width[here]
        return self._judged(
            np.concatenate([boxes.cell] * 2, 1),
            np.concatenate([boxes.low, upper], 1),
            np.concatenate([width] * 2, 1),
        )

    def errors(self, cell: IntegerArray, share: FloatArray) -> FloatArray:
        """Return the errors (N,) at places in cells, both (3, N)."""
        eta, psi, kappa = self._values(cell, share)
        truth = follow_all(eta, psi, kappa, self.threads).epsilon_t
        return np.asarray(np.abs(self._corners(cell, share, share)[0, 0, 0] - truth))

    def _values(self, cell: IntegerArray, share: FloatArray) -> list[FloatArray]:
        """Return η, ψ and κ at places in cells."""
        return [self.nodes.within(axis, cell[axis], share[axis]) for axis in range(3)]

    def _corners(self, cell: IntegerArray, low: FloatArray, high: FloatArray) -> FloatArray:
        """Return what interpolation gives at the corners of boxes, (2, 2, 2, N)."""
        at = [
            np.stack([place, np.minimum(place + 1, count - 1)])
            for place, count in zip(cell, self.entries.shape, strict=True)
        ]
        found: FloatArray = self.entries[at[0][:, None, None], at[1][:, None], at[2]]
        for axis in self.axes:
            first, last = np.moveaxis(found, axis, 0)
            edges = [first + share[axis] * (last - first) for share in (low, high)]
            found = np.stack(edges, axis)
        return found

    def _judged(self, cell: IntegerArray, low: FloatArray, width: FloatArray) -> Boxes:
        parts = [slice(i, i + AT_ONCE) for i in range(0, cell.shape[1], AT_ONCE)]
        return Boxes.joined(
            [self._judged_together(cell[:, p], low[:, p], width[:, p]) for p in parts]
        )

    def _judged_together(self, cell: IntegerArray, low: FloatArray, width: FloatArray) -> Boxes:
        ends = self._values(cell, low), self._values(cell, low + width)
        middle = self._values(cell, low + 0.5 * width)
        found = follow_all(middle[0], middle[1], middle[2], self.threads)
        corners = self._corners(cell, low, low + width)
        with np.errstate(over="ignore", divide="ignore"):
            least, most, changes = self._possible(ends, middle, found.epsilon_t)
        bound = np.maximum(corners.max((0, 1, 2)) - least, most - corners.min((0, 1, 2)))
        # along which axis the bound has most to gain
        for axis in self.axes:
            first, last = np.moveaxis(corners, axis, 0)
            changes[axis] += 0.5 * np.abs(last - first).max((0, 1))
        return Boxes(
            cell,
            low,
            width,
            np.abs(corners.mean((0, 1, 2)) - found.epsilon_t),
            bound + found.error_bound,
            changes.argmax(0),
            found.seconds + SECONDS_FOR_A_BOX,
        )

    def _possible(
        self, ends: tuple[list[FloatArray], ...], middle: list[FloatArray], epsilon_t: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return the range of ε_t in boxes and how much of it is due to η, ψ and κ, (3, N)."""
        (etas, psis, kappas) = zip(ends[0], middle, ends[1], strict=True)
        force = variation.largest_force_between(etas[0], etas[2])
        changes = np.zeros((3, epsilon_t.size))
        if 0 in self.axes:
            changes[0] = variation.change_by_damping(*etas, psis[1])
        changes[2] = variation.change_by_stiffness(*kappas, psis[1], force)
        around = changes[0] + changes[2]
        at_centre = variation.Range(epsilon_t - around, epsilon_t + around)
        low, high = variation.change_by_velocity(at_centre, *psis)
        possible = variation.possible_range(kappas, (psis[0], psis[2]), force, damped=self.damped)
        alone = variation.change_by_velocity(variation.Range(epsilon_t, epsilon_t), *psis)
        changes[1] = 0.5 * (alone.high - alone.low)
        np.minimum(changes, possible.high - possible.low, out=changes)
        return np.maximum(low, possible.low), np.minimum(high, possible.high), changes
