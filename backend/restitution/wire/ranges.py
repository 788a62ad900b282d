"""The ends of an axis in a query, and what they must be beside each other."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from restitution.bounds import Misfit


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
        low = as_number(given.get(self.minimum), self.default[0])
        high = as_number(given.get(self.maximum), self.default[1])
        if low is None or high is None:
            return
        if low <= 0.0 and (self.positive or given.get(self.scale) == "log"):
            yield self.minimum, "> 0, as kappa is" if self.positive else "> 0 on a log scale"
        elif low >= high and self.minimum in given and self.maximum not in given:
            yield self.minimum, f"less than {self.maximum} = {high!r}, its default"
        elif low >= high:
            yield self.maximum, f"greater than {self.minimum} = {low!r}"


def as_number(text: str | None, default: float | None) -> float | None:
    """Return the number that a text is, None if it is none; without a text the default."""
    if text is None:
        return default
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
