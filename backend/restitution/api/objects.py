"""Read JSON objects within objects, with every refusal at once and dotted names."""

import math
from collections.abc import Callable, Iterator
from itertools import islice
from typing import Any

from restitution.api.errors import MOST_ERRORS, UNKNOWN, RefusedParametersError, refusal

Test = Callable[[float], bool]

POSITIVE = "finite and > 0"
NOT_NEGATIVE = "finite and ≥ 0"


def positive(value: float) -> bool:
    """Return whether a finite number suits `POSITIVE`."""
    return value > 0.0


def not_negative(value: float) -> bool:
    """Return whether a finite number suits `NOT_NEGATIVE`."""
    return value >= 0.0


def within(least: float, most: float) -> Test:
    """Return a test of numbers from `least` to `most`."""
    return lambda value: least <= value <= most


def double(value: object) -> float:
    """Return a JSON number as a double, NaN for what is no number, infinity beyond the range."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return math.nan
    try:
        return float(value)
    except OverflowError:
        return math.inf


class ObjectReader:
    """The members of a JSON object, read one by one; what is wrong is collected.

    Parameters
    ----------
    value : object
        As read from JSON; anything but an object is refused.
    name : str
        Name of the object as the client knows it, empty for the body of the request.
    errors : list, optional
        Where refusals are collected, shared by all objects of a request.
    requirement : str
        What the object is, to stand after "must be".
    """

    def __init__(
        self,
        value: object,
        name: str = "",
        errors: list[dict[str, Any]] | None = None,
        requirement: str = "an object",
    ) -> None:
        self.name = name
        self.errors: list[dict[str, Any]] = [] if errors is None else errors
        self.members: dict[str, Any] = value if isinstance(value, dict) else {}
        self.is_object = isinstance(value, dict)
        self._read: set[str] = set()
        if not self.is_object:
            self.errors.append(refusal(name, value, requirement))

    def refuse(self, member: str, requirement: str) -> None:
        """Refuse the value of a member; once for each, and only if there is an object at all."""
        self._read.add(member)
        full = f"{self.name}.{member}" if self.name else member
        plain = full.partition("[")[0]
        if self.is_object and all(error["parameter"] != full for error in self.errors):
            value: Any = self.members.get(plain.rpartition(".")[2])
            if plain != full and isinstance(value, list):
                value = value[int(full[len(plain) + 1 : -1])]
            self.errors.append(refusal(full, value, requirement))

    def number(
        self, member: str, requirement: str, allowed: Test, default: float | None = None
    ) -> float:
        """Return a finite number that is `allowed`; required without a default."""
        self._read.add(member)
        if default is not None and member not in self.members:
            return default
        value = double(self.members.get(member))
        if not (math.isfinite(value) and allowed(value)):
            self.refuse(member, requirement)
            return math.nan
        # adding 0 makes −0 the 0 that it equals
        return value + 0.0

    def optional_number(self, member: str, requirement: str, allowed: Test) -> float | None:
        """Return a finite number that is `allowed`, None if it is null or not there."""
        self._read.add(member)
        if self.members.get(member) is None:
            return None
        return self.number(member, requirement, allowed)

    def integer(self, member: str, least: int, most: int, default: int) -> int:
        """Return an integer from `least` to `most`."""
        requirement = f"an integer from {least:,} to {most:,}"
        value = self.number(
            member, requirement, lambda x: least <= x <= most and x.is_integer(), default
        )
        return int(value) if math.isfinite(value) else default

    def vector(
        self, member: str, default: tuple[float, float, float] | None = None
    ) -> tuple[float, float, float]:
        """Return three finite numbers."""
        self._read.add(member)
        if default is not None and member not in self.members:
            return default
        value = self.members.get(member)
        if not isinstance(value, list) or len(value) != 3:
            self.refuse(member, "three finite numbers")
            return (math.nan, math.nan, math.nan)
        x, y, z = map(double, value)
        for i, part in enumerate((x, y, z)):
            if not math.isfinite(part):
                self.refuse(f"{member}[{i}]", "a finite number")
        return x, y, z

    def word(self, member: str, allowed: tuple[str, ...], default: str) -> str:
        """Return one of some words."""
        self._read.add(member)
        value = self.members.get(member, default)
        if value not in allowed:
            self.refuse(member, f"one of {', '.join(allowed)}")
            return default
        return str(value)

    def words(self, member: str, allowed: tuple[str, ...], default: tuple[str, ...]) -> list[str]:
        """Return a list of some of the `allowed` words, not empty."""
        self._read.add(member)
        value = self.members.get(member, list(default))
        listed = isinstance(value, list) and 0 < len(value) <= len(allowed)
        if not listed or not all(isinstance(w, str) and w in allowed for w in value):
            self.refuse(member, f"a list, not empty, of {', '.join(allowed)}")
            return list(default)
        return list(value)

    def object(self, member: str, requirement: str = "an object") -> "ObjectReader":
        """Return a reader of an object within this one."""
        self._read.add(member)
        full = f"{self.name}.{member}" if self.name else member
        errors = self.errors if self.is_object else []
        return ObjectReader(self.members.get(member), full, errors, requirement)

    def ignore(self, *members: str) -> None:
        """Count members as read."""
        self._read.update(members)

    def close(self, reasons: dict[str, str] | None = None) -> None:
        """Refuse every member that was not read, with its reason or as unknown."""
        unread = (key for key in self.members if key not in self._read)
        for key in islice(unread, MOST_ERRORS + 1):
            self.refuse(key, (reasons or {}).get(key, UNKNOWN))

    def finish(self) -> None:
        """Raise if anything was refused."""
        if self.errors:
            raise RefusedParametersError(self.errors)


def repeated_names(pairs: object, name: str = "") -> Iterator[str]:
    """Yield the dotted names that objects give more than once.

    `pairs` is what a JSON reader makes with `tuple` as its ``object_pairs_hook``: objects are
    tuples of pairs, arrays lists.
    """
    if isinstance(pairs, list):
        for i, item in enumerate(pairs):
            yield from repeated_names(item, f"{name}[{i}]")
    if not isinstance(pairs, tuple):
        return
    seen: set[str] = set()
    for key, value in pairs:
        full = f"{name}.{key}" if name else key
        if key in seen:
            yield full
        seen.add(key)
        yield from repeated_names(value, full)
