"""Numbers, lists and typed arrays in the body of a request."""

import binascii
import math
from typing import Any

import numpy as np
import pybase64

from restitution.bounds import interval, requirement
from restitution.errors import CostError
from restitution.mechanics.hertz import FloatArray
from restitution.wire.refusals import refusal

MOST_ITEMS = 1_000_000

MOST_REFUSALS = 20
"""Elements of one list that are named in a refusal."""

NUMBERS = {int, float}

SHAPE = "a finite number, a list of them, or {dtype, shape, bdata}"
TYPED = "typed as f8, f4 or i4, with base64 in bdata and a shape that fits"


def refuse_more_points(*counts: int) -> None:
    """Raise `CostError` for a map or table of more than `MOST_ITEMS` points."""
    if math.prod(counts) > MOST_ITEMS:
        points = " × ".join(f"{count:,}" for count in counts)
        raise CostError(f"a map of {points} points has more than {MOST_ITEMS:,}, the limit")


def number_array(
    name: str, value: object, annotation: Any
) -> tuple[FloatArray, list[dict[str, Any]]]:
    """Return the numbers of a parameter and what is wrong with them.

    Parameters
    ----------
    name : str
        Name of the parameter.
    value : object
        As read from JSON.
    annotation : type
        What each number may be.

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
        if not NUMBERS.issuperset(map(type, items)):
            items = [x if type(x) in NUMBERS else math.nan for x in items]
        values = _doubles(items)
        if not isinstance(value, list):
            values = values.reshape(())
    low, high = interval(annotation)
    fits = (values >= low) & (values <= high)
    wrong = [int(i) for i in np.flatnonzero(~fits)[:MOST_REFUSALS]]
    if isinstance(value, dict) and wrong:
        value = values.tolist()
    return values, [_bad(name, value, i, requirement(annotation)) for i in wrong]


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


def _bad(name: str, value: object, i: int, words: str) -> dict[str, Any]:
    if isinstance(value, list):
        return refusal(f"{name}[{i}]", value[i], words)
    return refusal(name, value, words)


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
