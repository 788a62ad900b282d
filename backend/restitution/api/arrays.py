"""Numbers, lists and typed arrays in the body of a request."""

import asyncio
import binascii
import json
import math
import re
from collections import Counter
from collections.abc import Callable, Collection
from typing import Any

import numpy as np
import numpy.typing as npt
import orjson
import pybase64
from fastapi import Request
from starlette.exceptions import HTTPException

from restitution.api.errors import RefusedParametersError, refusal
from restitution.api.objects import repeated_names
from restitution.errors import CostError
from restitution.mechanics.hertz import FloatArray

MOST_ITEMS = 1_000_000
LARGEST_BODY = 40 * 2**20
LARGEST_SMALL_BODY = 2 * 2**20

LONGEST_UPLOAD = 60.0
"""Seconds until a body must be there: 40 MiB at 6 Mbit/s."""

TOO_DEEP = "the body is nested too deeply"

MOST_REFUSALS = 20
"""Elements of one list that are named in a refusal."""

SHAPE = "a finite number, a list of them, or {dtype, shape, bdata}"
TYPED = "typed as f8, f4 or i4, with base64 in bdata and a shape that fits"


KEY = re.compile(rb'"(\w{1,32})"\s*:')

Allowed = Callable[[FloatArray], npt.NDArray[np.bool_]]


async def read_body(request: Request, largest: int) -> bytes:
    """Return the body of a request.

    Raises
    ------
    HTTPException
        415 for another content type, 413 for too much, 408 for one that does not come.
    """
    kind = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if kind != "application/json":
        raise HTTPException(415, "the body must be application/json")
    body = bytearray()
    try:
        async with asyncio.timeout(LONGEST_UPLOAD):
            async for chunk in request.stream():
                body += chunk
                if len(body) > largest:
                    raise HTTPException(413, f"the body is larger than {largest:,} bytes")
    except TimeoutError as error:
        raise HTTPException(408, f"the body took longer than {LONGEST_UPLOAD:g} s") from error
    return bytes(body)


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
        raise HTTPException(400, TOO_DEEP) from error
    if names:
        raise RefusedParametersError([refusal(name, None, "given once") for name in names])
    return value


def parse_object(text: bytes) -> dict[str, Any]:
    """Return a JSON object; `HTTPException` 400 for anything else."""
    try:
        value = orjson.loads(text)
    except orjson.JSONDecodeError:
        value = _lenient(text)
    if not isinstance(value, dict):
        raise HTTPException(400, "the body must be a JSON object")
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
        raise HTTPException(400, TOO_DEEP) from error
    except ValueError as error:
        raise HTTPException(400, f"the body is not JSON: {error}") from error


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


def refuse_more_points(*counts: int) -> None:
    """Raise `CostError` for a map or table of more than `MOST_ITEMS` points."""
    if math.prod(counts) > MOST_ITEMS:
        points = " × ".join(f"{count:,}" for count in counts)
        raise CostError(f"a map of {points} points has more than {MOST_ITEMS:,}, the limit")


def number_array(
    name: str, value: object, requirement: str, allowed: Allowed
) -> tuple[FloatArray, list[dict[str, Any]]]:
    """Return the numbers of a parameter and what is wrong with them.

    Parameters
    ----------
    name : str
        Name of the parameter.
    value : object
        As read from JSON.
    requirement : str
        What holds for each number.
    allowed : callable
        Tells for finite numbers (N,) for which of them it does.

    Returns
    -------
    values : ndarray, shape () or (N,)
        Of no use if there are errors.
    errors : list
        Entries of a refusal.
    """
    nothing = np.array(np.nan)
    if value is None:
        return nothing, [refusal(name, None, SHAPE)]
    if isinstance(value, dict):
        decoded = _decoded(value)
        if decoded is None:
            return nothing, [refusal(name, value, TYPED)]
        values: FloatArray = decoded
    else:
        items = value if isinstance(value, list) else [value]
        values = _doubles([x if type(x) in (int, float) else math.nan for x in items])
        if not isinstance(value, list):
            values = values.reshape(())
    fits = np.isfinite(values) & allowed(values)
    wrong = [int(i) for i in np.flatnonzero(~fits)[:MOST_REFUSALS]]
    if isinstance(value, dict) and wrong:
        value = values.tolist()
    return values, [_bad(name, value, i, requirement) for i in wrong]


def _doubles(items: list[Any]) -> FloatArray:
    try:
        return np.array(items, dtype=np.float64)
    except OverflowError:
        return np.array([_double(item) for item in items])


def _double(item: float) -> float:
    try:
        return float(item)
    except OverflowError:
        return float("inf")


def _bad(name: str, value: object, i: int, requirement: str) -> dict[str, Any]:
    if isinstance(value, list):
        return refusal(f"{name}[{i}]", value[i], requirement)
    return refusal(name, value, requirement)


def _decoded(value: dict[str, Any]) -> FloatArray | None:
    """Return a typed array (N,) as doubles, None if it is none."""
    dtype, shape, data = (value.get(key) for key in ("dtype", "shape", "bdata"))
    if value.keys() - {"dtype", "shape", "bdata"} or dtype not in ("f8", "f4", "i4"):
        return None
    if not isinstance(data, str) or not isinstance(shape, str | int | None):
        return None
    try:
        raw = pybase64.b64decode(data, validate=True)
        array = np.frombuffer(raw, f"<{dtype}").astype(np.float64)
    except (binascii.Error, ValueError):
        return None
    fits = shape is None or str(shape) == str(array.size)
    return array if fits else None
