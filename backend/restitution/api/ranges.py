"""Parameters that must suit each other; each by itself is checked in `schemas`."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

Misfit = tuple[str, str]
"""A parameter and what holds for it beside the others."""


@dataclass(frozen=True)
class Range:
    """The names of the parameters of an axis, and what is taken where they are not given."""

    minimum: str
    maximum: str
    scale: str
    default: tuple[float, float]
    positive: bool

    def misfits(self, given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield what is wrong with the ends; nothing if one of them is no number at all."""
        low = _number(given.get(self.minimum), self.default[0])
        high = _number(given.get(self.maximum), self.default[1])
        if low is None or high is None:
            return
        if low <= 0.0 and (self.positive or given.get(self.scale) == "log"):
            yield self.minimum, "> 0, as kappa is" if self.positive else "> 0 on a log scale"
        elif low >= high and self.minimum in given and self.maximum not in given:
            yield self.minimum, f"less than {self.maximum} = {high!r}, its default"
        elif low >= high:
            yield self.maximum, f"greater than {self.minimum} = {low!r}"


CUT = {
    "kappa": Range("minimum", "maximum", "scale", (0.1, 70.0), positive=True),
    "gt_over_gn": Range("minimum", "maximum", "scale", (0.01, 4.0), positive=False),
}
MAP = (
    Range("kappa_min", "kappa_max", "kappa_scale", (0.1, 70.0), positive=True),
    Range("gt_over_gn_min", "gt_over_gn_max", "gt_over_gn_scale", (0.01, 4.0), positive=False),
)


def cut_misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
    """Yield what is wrong with the parameters of ``/cut`` beside each other."""
    along = given.get("along")
    if along not in CUT:
        return
    if along in given:
        yield along, "left out, as `along` names it"
    for other in CUT.keys() - {along} - given.keys():
        yield other, "given, as `along` is the other one"
    yield from CUT[along].misfits(given)


COLLISION = ("kappa", "mu_over_alpha", "gt_over_gn")


def steps_misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
    """Yield what is wrong with the parameters of ``/steps``: a collision, or else a region."""
    for name in (*COLLISION, "damping"):
        if "region" in given and name in given:
            yield name, "left out, as `region` is given"
    for name in COLLISION:
        if "region" not in given and name not in given:
            yield name, "given, or else `region`"


def map_misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
    """Yield what is wrong with the parameters of ``/map`` beside each other."""
    for axis in MAP:
        yield from axis.misfits(given)


TABLE = (
    MAP[0],
    Range("psi_min", "psi_max", "psi_scale", (0.01, 4.0), positive=False),
)

DAMPING = Range("damping_min", "damping_max", "damping_scale", (0.0, math.inf), positive=False)
"""The optional third axis of a table; its maximum asks for it."""


def table_scales(given: Mapping[str, str]) -> dict[str, str]:
    """Return the scales of ``/table`` where they are not given.

    As of ``/map``; logarithmic, which takes fewer entries, where an error decides about the grid.
    """
    scales = {}
    for axis in TABLE:
        low = _number(given.get(axis.minimum), axis.default[0])
        scales[axis.scale] = "log" if "error" in given and low != 0.0 else "linear"
    return scales


def table_misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
    """Yield what is wrong with the parameters of ``/table`` beside each other."""
    for axis in TABLE:
        yield from axis.misfits(given)
    if DAMPING.maximum in given:
        yield from DAMPING.misfits(given)
        if "damping" in given:
            yield "damping", "left out, as `damping_max` makes it an axis"
    else:
        for name in (DAMPING.minimum, DAMPING.scale, "damping_count"):
            if name in given:
                yield name, "left out, or `damping_max` given, which makes damping an axis"
    for count in ("kappa_count", "psi_count", "damping_count"):
        if "error" in given and count in given:
            yield count, "left out, as `error` is given and decides about it"


def _number(text: str | None, default: float) -> float | None:
    if text is None:
        return default
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
