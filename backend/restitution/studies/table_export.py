"""ε_t(κ, ψ) on a grid for other codes, with a certified error of interpolation in it."""

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from restitution.errors import CostError
from restitution.mechanics.collision import MOST_SWITCHES, collide, expected_switch_counts
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import sliding_threshold
from restitution.methods.exact import cost
from restitution.studies.axis import Axis

Sign = Literal["paper", "reversed"]

DIGITS = 9
"""Decimals of the entries, so that every form of a table holds the same numbers."""

SAMPLED = (0.2, 0.5, 0.8)
"""Where in a cell, along either axis, interpolation is judged; never at an entry."""

SAFETY = 1.5
"""Certified over largest sampled error.

A measured factor, not a proof: over 60 random grids, 20 × 20 samples in a cell instead of these
3 × 3 raised the largest error of a table by 20 % at most."""

LEAST_SECONDS = 5e-6
"""For an entry and the samples of its cell."""

FEWEST = 16
GROWTH = math.sqrt(2.0)
"""Of the count along the axis with the larger error, from one try to the next."""


@dataclass(frozen=True)
class RestitutionTable:
    """A table for bilinear interpolation.

    Attributes
    ----------
    kappa, psi : Axis
        The grid, equidistant in κ and ψ or in their logarithms.
    epsilon_t : ndarray, shape (psi.count, kappa.count)
        Entries, rounded to `DIGITS` decimals, in the given sign.
    sign : str
        ``paper``: +1 for smooth spheres; ``reversed``: −1 for smooth spheres.
    largest_error : float
        Certified for bilinear interpolation in the coordinates in which the grid is equidistant:
        `SAFETY` times the largest error at 9 points of every cell, none of them an entry.
    slides_above : float
        ψ from which on 1 − 2/ψ is exact for every κ of the grid; NaN if the grid ends below.
    """

    kappa: Axis
    psi: Axis
    epsilon_t: FloatArray
    sign: Sign
    largest_error: float
    slides_above: float


def study_table(kappa: Axis, psi: Axis, sign: Sign, *, seconds: float) -> RestitutionTable:
    """Return the table on a given grid.

    Parameters
    ----------
    kappa, psi : Axis
        Ranges and counts; ψ may begin at 0 on a linear scale, where the entry is the limit.
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
    entries = _entries(kappa, psi, seconds)
    largest = max(
        _largest_error(entries, kappa, psi, along, across)
        for along in SAMPLED
        for across in SAMPLED
    )
    return _finished(entries, kappa, psi, sign, SAFETY * largest)


def study_table_within(
    error: float, kappa: Axis, psi: Axis, sign: Sign, *, seconds: float
) -> RestitutionTable:
    """Return a table whose certified error is at most `error`; as of `study_table`.

    The counts of the axes are found by trying.
    """
    kappa, psi = replace(kappa, count=FEWEST), replace(psi, count=FEWEST)
    best = math.inf
    while True:
        try:
            entries = _entries(kappa, psi, seconds)
        except CostError as refused:
            reached = f"{best:.2g} at most so far" if math.isfinite(best) else "nothing so far"
            raise CostError(
                f"an error of {error:g} takes more than {kappa.count:,} × {psi.count:,} entries "
                f"here ({reached}): {refused}"
            ) from refused
        # errors of interpolation along either axis alone tell which of them to refine
        along = _largest_error(entries, kappa, psi, 0.5, 0.0)
        across = _largest_error(entries, kappa, psi, 0.0, 0.5)
        best = min(best, SAFETY * max(along, across))
        if SAFETY * max(along, across) <= error:
            table = study_table(kappa, psi, sign, seconds=seconds)
            if table.largest_error <= error:
                return table
        if along >= across:
            kappa = replace(kappa, count=math.ceil(GROWTH * kappa.count))
        else:
            psi = replace(psi, count=math.ceil(GROWTH * psi.count))


def _entries(kappa: Axis, psi: Axis, seconds: float) -> FloatArray:
    """Return ε_t [ψ][κ] in the paper's sign, rounded."""
    expected = LEAST_SECONDS * kappa.count * psi.count
    if expected <= seconds:
        kappas, psis = np.meshgrid(kappa.values(positive=True), psi.values(positive=False))
        flat = kappas.ravel(), psis.ravel()
        expected = (1 + len(SAMPLED) ** 2) * cost(*flat)
        if np.any(expected_switch_counts(*flat) > MOST_SWITCHES):
            raise CostError(
                f"some collisions of this table have more than {MOST_SWITCHES:,} switches, the "
                "limit. Ask for softer ones"
            )
    if expected > seconds:
        raise CostError(
            f"this table of {kappa.count:,} × {psi.count:,} would take about {expected:.2g} s of "
            f"one core; the limit is {seconds:g} s. Ask for a narrower range, softer collisions or "
            "a larger error"
        )
    return np.round(collide(kappas, psis).epsilon_t, DIGITS)


def _positions(axis: Axis, share: float, *, positive: bool) -> FloatArray:
    """Return the values at this share of every cell along an axis; 0 stands for the entries."""
    values = axis.values(positive=positive)
    if share == 0.0:
        return values
    if axis.scale == "log":
        return np.asarray(np.exp(_between(np.log(values), share)))
    return _between(values, share)


def _between(values: FloatArray, share: float) -> FloatArray:
    """Return values linearly between those of neighbours along the first axis."""
    return values if share == 0.0 else (1.0 - share) * values[:-1] + share * values[1:]


def _largest_error(
    entries: FloatArray, kappa: Axis, psi: Axis, along: float, across: float
) -> float:
    """Return the largest error of interpolation at one point of every cell.

    `along` and `across` are its shares of the cell along κ and ψ.
    """
    interpolated = _between(_between(entries, across).T, along).T
    truth = collide(
        _positions(kappa, along, positive=True), _positions(psi, across, positive=False)[:, None]
    )
    return float(np.abs(interpolated - truth.epsilon_t).max() + truth.error_bound.max())


def _finished(
    entries: FloatArray, kappa: Axis, psi: Axis, sign: Sign, largest_error: float
) -> RestitutionTable:
    threshold = float(sliding_threshold(kappa.minimum))
    above = psi.maximum if psi.maximum >= threshold else math.nan
    # adding 0 makes −0 the 0 that it equals
    signed = entries if sign == "paper" else 0.0 - entries
    return RestitutionTable(kappa, psi, signed + 0.0, sign, largest_error, above)
