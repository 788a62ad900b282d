"""Numbers, lists and typed arrays in the body of a request."""

import base64
import binascii
import json
from typing import Any

import numpy as np
import orjson
from fastapi import Request
from starlette.exceptions import HTTPException

from restitution.api.errors import refusal
from restitution.mechanics.hertz import FloatArray

MOST_ITEMS = 1_000_000
LARGEST_BODY = 40 * 2**20
MOST_REFUSALS = 20
"""Elements of one list that are named in a refusal."""

SHAPE = "a finite number, a list of them, or {dtype, shape, bdata}"


async def read_json(request: Request) -> dict[str, Any]:
    """Return the JSON object in the body.

    Raises
    ------
    HTTPException
        415 for another content type, 413 for too much, 400 for what is not a JSON object.
    """
    kind = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if kind != "application/json":
        raise HTTPException(415, "the body must be application/json")
    body = bytearray()
    async for chunk in request.stream():
        body += chunk
        if len(body) > LARGEST_BODY:
            raise HTTPException(413, f"the body is larger than {LARGEST_BODY:,} bytes")
    try:
        value = orjson.loads(body)
    except orjson.JSONDecodeError:
        value = _lenient(bytes(body))
    if not isinstance(value, dict):
        raise HTTPException(400, "the body must be a JSON object")
    return value


def _lenient(body: bytes) -> object:
    """Return what Python's own reader makes of `body`: it takes NaN, to be refused by name."""
    try:
        return json.loads(body)
    except (ValueError, RecursionError) as error:
        raise HTTPException(400, f"the body is not JSON: {error}") from error


def number_array(
    name: str, value: object, requirement: str, *, positive: bool
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
    positive : bool
        Whether 0 is refused.

    Returns
    -------
    values : ndarray, shape () or (N,)
        Empty if there are errors.
    errors : list
        Entries of a refusal.
    """
    nothing = np.empty(0)
    if value is None:
        return nothing, [refusal(name, None, SHAPE)]
    if isinstance(value, dict):
        decoded = _decoded(value)
        if decoded is None:
            return nothing, [refusal(name, value, "typed as f8, f4 or i4, with fitting shape")]
        values: FloatArray = decoded
    else:
        items = value if isinstance(value, list) else [value]
        wrong = [i for i, item in enumerate(items) if type(item) not in (int, float)]
        if wrong:
            return nothing, [_bad(name, value, i, requirement) for i in wrong[:MOST_REFUSALS]]
        values = _doubles(items)
        if not isinstance(value, list):
            values = values.reshape(())
    allowed = np.isfinite(values) & ((values > 0.0) if positive else (values >= 0.0))
    wrong = [int(i) for i in np.flatnonzero(~allowed)]
    if isinstance(value, dict):
        value = values.tolist()
    return values, [_bad(name, value, i, requirement) for i in wrong[:MOST_REFUSALS]]


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
    try:
        raw = base64.b64decode(data or "", validate=True)
        array = np.frombuffer(raw, f"<{dtype}").astype(np.float64)
    except (binascii.Error, ValueError, TypeError):
        return None
    fits = shape is None or str(shape) == str(array.size)
    return array if fits else None
