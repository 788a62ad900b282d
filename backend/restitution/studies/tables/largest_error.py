"""The largest error of interpolation in a table, by branch and bound.

Boxes that may hold a larger error than the largest that was found are halved, those with the
largest bound first, until none can hold a much larger one, or the work is done that it may take.
"""

import math
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import combinations
from typing import Literal, NamedTuple

import numpy as np

from restitution.mechanics.hertz import FloatArray
from restitution.studies.tables.boxes import Boxes, Judge
from restitution.studies.tables.grid import IntegerArray, Nodes

ErrorBasis = Literal["proven", "measured slope", "sampled"]

BASES: dict[ErrorBasis, str] = {
    "proven": "no point of the table has a larger one",
    "measured slope": "proven, but for how fast the normal force changes with eta",
    "sampled": "a multiple of the largest that was found, not proven",
}
"""What the largest error of a table rests on."""

TIGHT = 1.3
"""Bound over largest error found at which no box is halved any more."""

CLOSE = 3.0
"""The same up to which the bound is stated, and not a multiple of the largest error found."""

SAFETY, SAFETY_IN_THREE = 1.5, 1.8
"""Stated over largest error found where the bound is not close, in two and three parameters.

Measured: over 500 random grids in two parameters the search found 0.97 of the largest error or more
where the bound was not close, over 300 in three 0.72 (tests/hostile/test_tables.py)."""

NARROWEST = 2.0**-20
"""Of its cell that a box is wide and still halved: one that reaches ψ = 0 may go on for ever."""

LEAST_LOT = 1024
"""Boxes that are halved together, at least: fewer are hardly quicker."""

SHARPENED, SHARPENINGS = 24, 12
"""Cells in which the largest error is sought from the largest found on, and steps of that."""

ROUNDING = 1e-12
"""Of interpolation, in whatever language."""


class Errors(NamedTuple):
    """Errors (N,) at places in cells, (3, N) along η, ψ and κ."""

    cell: IntegerArray
    share: FloatArray
    error: FloatArray


def safety(*, in_three: bool) -> float:
    """Return the stated over the largest error found, where the bound is not close."""
    return SAFETY_IN_THREE if in_three else SAFETY


@dataclass(frozen=True)
class LargestError:
    """What is known of the largest error of interpolation in a table or a part of it.

    Attributes
    ----------
    found : float
        The largest of those that were computed.
    bound : float
        No error is larger.
    in_three : bool
        Whether η is an axis, so that the bound rests on a measured slope.
    wanted : float, optional
        Error that was asked for: a bound above it is not stated.
    """

    found: float
    bound: float
    in_three: bool
    wanted: float = math.inf

    @property
    def basis(self) -> ErrorBasis:
        """What `stated` rests on."""
        if self.bound > min(CLOSE * self.found, self.wanted):
            return "sampled"
        return "measured slope" if self.in_three else "proven"

    @property
    def stated(self) -> float:
        """The largest error that the table states."""
        if self.basis == "sampled":
            return safety(in_three=self.in_three) * self.found
        return self.bound


def largest_error(
    entries: FloatArray,
    nodes: Nodes,
    seconds: float,
    threads: ThreadPoolExecutor | None,
    wanted: float = math.inf,
) -> LargestError:
    """Return what is found in about so many `seconds` of one core, which are counted as work.

    Parameters
    ----------
    entries : ndarray
        ε_t [η][ψ][κ] at the nodes, in the paper's sign.
    wanted : float, optional
        Error that the table is to have at most: it is sought until it is known whether it has.
    """
    judge = Judge(entries, nodes, threads)
    boxes = judge.cells()
    best = _one_a_cell(_middles(boxes))
    closed = 0.0
    seconds -= float(boxes.seconds.sum())
    while True:
        found = float(best.error[0])
        aim = max(TIGHT * found, wanted if wanted < CLOSE * found else 0.0)
        is_open = (boxes.bound > aim) & (boxes.widest() > NARROWEST)
        closed = max(closed, float(boxes.bound[~is_open].max(initial=0.0)))
        where = np.flatnonzero(is_open)
        where = where[np.argsort(-boxes.bound[where], kind="stable")]
        lot = _first_lot(boxes.bound[where], boxes.seconds[where], aim, seconds)
        if not lot or wanted < found:
            break
        halves = judge.halves(boxes.part(where[:lot]))
        seconds -= float(halves.seconds.sum())
        best = _one_a_cell(best, _middles(halves))
        boxes = Boxes.joined([boxes.part(where[lot:]), halves])
    bound = max(closed, float(boxes.bound[where].max(initial=0.0)))
    if bound > aim and found <= wanted:
        found = _sharpened(judge, _one_a_cell(best, *_lines(judge)))
    return LargestError(found + ROUNDING, bound + ROUNDING, 0 in judge.axes, wanted)


def _first_lot(bounds: FloatArray, seconds: FloatArray, aim: float, left: float) -> int:
    """Return how many boxes, of falling bounds, to halve next in the seconds that are left."""
    # the upper half of what is between the aim and the largest bound
    high = int(np.count_nonzero(bounds**2 > aim * bounds.max(initial=0.0)))
    # halves are about as dear as the whole each
    affordable = int(np.searchsorted(2.0 * np.cumsum(seconds), left, side="right"))
    return min(max(high, LEAST_LOT), affordable, bounds.size)


def _middles(boxes: Boxes) -> Errors:
    return Errors(boxes.cell, boxes.low + 0.5 * boxes.width, boxes.error)


def _lines(judge: Judge) -> Iterator[Errors]:
    """Yield the errors in the middles of the edges and faces of all cells.

    They are the largest where the errors along two axes have opposite signs.
    """
    for count in range(1, len(judge.axes)):
        for along in combinations(judge.axes, count):
            cell, share = judge.midway(along)
            yield Errors(cell, share, judge.errors(cell, share))


def _one_a_cell(*several: Errors) -> Errors:
    """Return the largest errors found, no two of one cell."""
    largest = []
    for cell, share, error in several:
        top = np.argsort(-error, kind="stable")[: 8 * SHARPENED]
        largest.append((cell[:, top], share[:, top], error[top]))
    cell, share, error = (np.concatenate(columns, -1) for columns in zip(*largest, strict=True))
    order = np.argsort(-error, kind="stable")
    _, first = np.unique(cell[:, order], axis=1, return_index=True)
    top = order[np.sort(first)[:SHARPENED]]
    return Errors(cell[:, top], share[:, top], error[top])


def _sharpened(judge: Judge, best: Errors) -> float:
    """Return the largest error found by steps within cells, ever smaller ones."""
    share, error = best.share, best.error
    step = np.full(share.shape, 0.25)
    moves = np.zeros((3, 2 * len(judge.axes), 1))
    for i, axis in enumerate(judge.axes):
        moves[axis, 2 * i : 2 * i + 2, 0] = -1.0, 1.0
    cell = np.repeat(best.cell[:, None], moves.shape[1], 1).reshape(3, -1)
    each = np.arange(error.size)
    for _ in range(SHARPENINGS):
        tried = np.clip(share[:, None] + moves * step[:, None], 0.0, 1.0)
        errors = judge.errors(cell, tried.reshape(3, -1)).reshape(moves.shape[1], -1)
        move = errors.argmax(0)
        better = errors[move, each] > error
        share = np.where(better, tried[:, move, each], share)
        step = np.where(better, step, 0.5 * step)
        error = np.maximum(error, errors.max(0))
    return float(error.max())
