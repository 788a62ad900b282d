"""JSON in a body: one object, no key in it twice."""

import contextlib
import json
import re
from collections import Counter
from collections.abc import Collection, Iterator
from typing import Any

import orjson

from restitution.errors import CostError
from restitution.wire.refusals import MalformedBodyError, RefusedParametersError, refusal

TOO_DEEP = "the body is nested too deeply"

AGAIN = "several times"
"""Stands for the values of a key that is given more than once: together they may be long."""

MOST_CONTAINERS = 1000
"""Objects and lists in a body; a body of ours has less than ten."""

KEY = re.compile(rb'"(\w{1,32})"\s*:')

STRING_OR_EDGE = re.compile(rb'"((?:[^"\\]|\\.)*)"(\s*:)?|[{}\[\]]', re.DOTALL)


def refuse_costly(body: bytes, most_elements: int) -> None:
    """Refuse a body whose values would take more room than it can have use for.

    An empty list takes two bytes in a body and sixty in memory. Brackets and commas are counted
    wherever they stand, in texts, too: in none of ours there are many.

    Raises
    ------
    MalformedBodyError
        If it has too many lists and objects, side by side or in one another.
    CostError
        If it has too many elements.
    """
    if (count := body.count(b"[") + body.count(b"{")) > MOST_CONTAINERS:
        raise MalformedBodyError(
            f"the body is nested too deeply, or has too many parts: {count:,} lists and objects, "
            f"more than {MOST_CONTAINERS:,}"
        )
    if (count := body.count(b",")) > most_elements:
        raise CostError(f"{count:,} elements in a body are more than {most_elements:,}, the limit")


def parse_named(body: bytes, names: Collection[str]) -> dict[str, Any]:
    """Return a JSON object; `RefusedParametersError` if it gives one of the `names` twice."""
    value = parse_object(body)
    counts = Counter(KEY.findall(body))
    if any(counts[name.encode()] > 1 for name in names):
        # rare: look again, for keys of this object alone
        counts = Counter(_own_keys(body))
        if again := [name for name in names if counts[name.encode()] > 1]:
            raise RefusedParametersError([refusal(name, AGAIN, "given once") for name in again])
    return value


def parse_nested(body: bytes) -> dict[str, Any]:
    """Return a JSON object; `RefusedParametersError` if any object in it gives a key twice."""
    value = parse_object(body)
    try:
        names = dict.fromkeys(repeated_names(_lenient(body, object_pairs_hook=tuple)))
    except RecursionError as error:
        raise MalformedBodyError(TOO_DEEP) from error
    if names:
        raise RefusedParametersError([refusal(name, AGAIN, "given once") for name in names])
    return value


def parse_object(text: bytes) -> dict[str, Any]:
    """Return a JSON object; `MalformedBodyError` for anything else."""
    value, is_read = None, False
    # an error of either reader holds the whole text again: it is let go before anything else
    with contextlib.suppress(orjson.JSONDecodeError):
        value, is_read = orjson.loads(text), True
    if not is_read:
        value = _lenient(text)
    if not isinstance(value, dict):
        raise MalformedBodyError("the body must be a JSON object")
    return value


def _lenient(body: bytes, **hooks: Any) -> object:
    """Return what Python's own reader makes of `body`: it takes NaN, to be refused by name."""
    try:
        # an integer too long for Python is infinite as a double
        # as text, for from bytes Python would read UTF-16 and UTF-32, too
        return json.loads(
            body.decode(), parse_int=lambda t: int(t) if len(t) < 400 else float(t), **hooks
        )
    except RecursionError:
        reason = TOO_DEEP
    except ValueError as error:
        reason = f"the body is not JSON: {error}"
    raise MalformedBodyError(reason)


def _own_keys(body: bytes) -> Iterator[bytes]:
    """Yield the keys of the object that a body is, without making anything of the rest."""
    depth = 0
    for found in STRING_OR_EDGE.finditer(body):
        if found[0] in (b"{", b"["):
            depth += 1
        elif found[0] in (b"}", b"]"):
            depth -= 1
        elif found[2] is not None and depth == 1:
            yield found[1]


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
