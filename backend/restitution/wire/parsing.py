"""JSON in a body: one object, no key in it twice."""

import codecs
import contextlib
import json
import secrets
from collections.abc import Iterator
from typing import Any

import orjson

from restitution.errors import CostError
from restitution.wire.refusals import MalformedBodyError, RefusedParametersError, refusal

TOO_DEEP = "the body is nested too deeply"

AGAIN = "several times"
"""Stands for the values of a key that is given more than once: together they may be long."""

MOST_CONTAINERS = 1000
"""Objects and lists in a body; a body of ours has less than ten."""

PIECE = 2**17
"""Bytes of a list that are read in one go, in which no other thread gets a turn: half a ms."""


def in_utf8(text: bytes) -> bytes:
    """Return JSON without the mark that some editors begin it with.

    Raises
    ------
    MalformedBodyError
        If it is in another encoding, which is named.
    """
    encoding = json.detect_encoding(text)
    if encoding == "utf-8-sig":
        return text[len(codecs.BOM_UTF8) :]
    if encoding != "utf-8":
        raise MalformedBodyError(f"the body must be JSON in UTF-8, this is {encoding.upper()}")
    return text


class Parts:
    """The parts of a body as it arrives, of which it may have no more than it can have use for.

    An empty list takes two bytes in a body and sixty in memory. Brackets and commas are counted
    wherever they stand, in texts, too: in none of ours there are many.
    """

    def __init__(self, most_elements: int) -> None:
        self._most_elements = most_elements
        self._containers = self._elements = 0

    def count(self, chunk: bytes) -> None:
        """Count those of a chunk.

        Raises
        ------
        MalformedBodyError
            If there are too many lists and objects, side by side or in one another.
        CostError
            If there are too many elements.
        """
        self._containers += chunk.count(b"[") + chunk.count(b"{")
        if self._containers > MOST_CONTAINERS:
            raise MalformedBodyError(
                "the body is nested too deeply, or has too many parts: more than "
                f"{MOST_CONTAINERS:,} lists and objects"
            )
        self._elements += chunk.count(b",")
        if self._elements > self._most_elements:
            raise CostError(f"a body of more than {self._most_elements:,} elements, the limit")


def parse_lists(body: bytes) -> dict[str, Any]:
    """Return a JSON object as `parse_nested` does, its long lists of numbers piece by piece.

    Where a long list holds anything else, or is none of a member, keys may be there twice.
    """
    with contextlib.suppress(MalformedBodyError):
        outline, lists = _without_long_lists(body)
        value = parse_nested(outline)
        texts = {name: text for name, text in value.items() if isinstance(text, str)}
        found = {name: lists.pop(text, text) for name, text in texts.items()}
        if not lists:
            return value | found
    # what is wrong, and where, only the whole can tell; to look for keys again would take too long
    return parse_object(body)


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
    value = _parsed(text)
    if not isinstance(value, dict):
        raise MalformedBodyError("the body must be a JSON object")
    return value


def _parsed(text: bytes) -> object:
    """Return what is in a text of JSON."""
    # an error of either reader holds the whole text again: it is let go before anything else
    with contextlib.suppress(orjson.JSONDecodeError):
        return orjson.loads(text)
    return _lenient(text)


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
        reason = f"the body is not JSON: {error}" if body.strip() else "the body is empty"
    raise MalformedBodyError(reason)


def _without_long_lists(body: bytes) -> tuple[bytes, dict[str, list[object]]]:
    """Return a body with texts in place of its long lists of numbers, and these by their texts.

    A bracket within a text would be taken for a list's; the text in its place ends that text, and
    what is returned is no JSON.
    """
    mark, begin = secrets.token_hex(), 0
    outline: list[bytes] = []
    lists: dict[str, list[object]] = {}
    while (end := body.find(b"]", begin)) >= 0:
        start = body.rfind(b"[", begin, end)
        numbers = body[start + 1 : end] if start >= 0 and end - start > PIECE else b""
        if numbers and b'"' not in numbers and b"{" not in numbers:
            text = f"{mark}{len(lists)}"
            lists[text] = _items(numbers)
            outline.append(b'%b"%b"' % (body[begin:start], text.encode()))
        else:
            outline.append(body[begin : end + 1])
        begin = end + 1
    return b"".join([*outline, body[begin:]]), lists


def _items(numbers: bytes) -> list[object]:
    """Return the elements of a list of numbers, which is given without its brackets."""
    items: list[object] = []
    begin = 0
    while begin <= len(numbers):
        end = numbers.find(b",", begin + PIECE)
        end = len(numbers) if end < 0 else end
        piece = _parsed(b"[%b]" % numbers[begin:end])
        if not isinstance(piece, list) or not piece:
            # nothing is before a comma, or after one
            raise MalformedBodyError("an element is missing")
        items += piece
        begin = end + 1
    return items


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
