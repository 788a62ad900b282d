"""JSON in a body: one object, no key in it twice."""

import json
import re
from collections import Counter
from collections.abc import Collection, Iterator
from typing import Any

import orjson

from restitution.wire.refusals import MalformedBodyError, RefusedParametersError, refusal

TOO_DEEP = "the body is nested too deeply"

KEY = re.compile(rb'"(\w{1,32})"\s*:')


def parse_named(body: bytes, names: Collection[str]) -> dict[str, Any]:
    """Return a JSON object; `RefusedParametersError` if it gives one of the `names` twice."""
    value = parse_object(body)
    if errors := _repeated(body, names):
        raise RefusedParametersError(errors)
    return value


def parse_nested(body: bytes) -> dict[str, Any]:
    """Return a JSON object; `RefusedParametersError` if any object in it gives a key twice."""
    value = parse_object(body)
    try:
        names = dict.fromkeys(repeated_names(_lenient(body, object_pairs_hook=tuple)))
    except RecursionError as error:
        raise MalformedBodyError(TOO_DEEP) from error
    if names:
        raise RefusedParametersError([refusal(name, None, "given once") for name in names])
    return value


def parse_object(text: bytes) -> dict[str, Any]:
    """Return a JSON object; `MalformedBodyError` for anything else."""
    try:
        value = orjson.loads(text)
    except orjson.JSONDecodeError:
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
    except RecursionError as error:
        raise MalformedBodyError(TOO_DEEP) from error
    except ValueError as error:
        raise MalformedBodyError(f"the body is not JSON: {error}") from error


def _repeated(body: bytes, names: Collection[str]) -> list[dict[str, Any]]:
    """Return the entries for `names` that the object in `body` gives more than once."""
    counts = Counter(KEY.findall(body))
    if not any(counts[name.encode()] > 1 for name in names):
        return []
    # rare: look again, with a reader that tells keys of this object from others
    pairs: Any = _lenient(body, object_pairs_hook=list)
    counts = Counter(name for name, _ in pairs)
    return [
        refusal(name, [value for key, value in pairs if key == name], "given once")
        for name in names
        if counts[name] > 1
    ]


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
