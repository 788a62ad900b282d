"""The forms of an answer: JSON, JSON with base64 arrays, CSV, NPZ; and its HTTP headers."""

import base64
import dataclasses
import hashlib
import io
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import orjson
from fastapi import Request, Response

from restitution.api.errors import refuse_unsuited
from restitution.api.schemas import FormQuery, NoQuery, TableQuery
from restitution.mechanics.compiled import fingerprint
from restitution.studies.collision import Energy, Estimates, Sensitivity

PROGRAM_VERSION = fingerprint(Path(__file__).parents[1])
"""Changes with any source of the package, and so with any answer."""

PARTS = {"energy": Energy, "estimates": Estimates, "sensitivity": Sensitivity}
"""Keys whose values have keys of their own, and columns of a table even where they are null."""

Payload = dict[str, Any]
Table = Mapping[str, npt.NDArray[Any] | list[Any]]


@dataclasses.dataclass(frozen=True)
class Result:
    """What a route found.

    Attributes
    ----------
    payload : dict
        As a whole.
    table : callable
        As rows for CSV, computed if asked.
    arrays : callable, optional
        One array per key for NPZ, where the payload has lists of objects.
    texts : dict of str to callable
        Further forms of this answer alone: name → its text.
    """

    payload: Payload
    table: Callable[[], Table]
    arrays: Callable[[], Payload] | None = None
    texts: Mapping[str, Callable[[], str]] = dataclasses.field(default_factory=dict)


def respond(
    request: Request,
    query: FormQuery | NoQuery | TableQuery,
    compute: Callable[[], Result],
    version: str = PROGRAM_VERSION,
) -> Response:
    """Return the answer to `query` in its form, or 304 if the client has it already.

    `version` stands for everything else that the answer depends on.
    """
    refuse_unsuited(request)
    tag = entity_tag(request.url.path, query, version)
    headers = {"ETag": tag, "Cache-Control": "public, max-age=86400"}
    known = [
        t.strip().removeprefix("W/") for t in request.headers.get("if-none-match", "").split(",")
    ]
    if tag in known or "*" in known:
        return Response(None, 304, headers)
    begin = time.perf_counter()
    result = compute()
    elapsed = 1e3 * (time.perf_counter() - begin)
    headers["Server-Timing"] = f"compute;dur={elapsed:.3f}"
    return formed(result, query.format, query.encoding, headers)


def entity_tag(path: str, query: FormQuery | NoQuery | TableQuery, version: str) -> str:
    """Return the strong ETag of `query`, its defaults filled in and its numbers doubles."""
    canonical = orjson.dumps([version, path, query.model_dump()], option=orjson.OPT_SORT_KEYS)
    return f'"{hashlib.sha256(canonical).hexdigest()[:32]}"'


def formed(
    result: Result, form: str, encoding: str, headers: Mapping[str, str] | None = None
) -> Response:
    """Return `result` as a response."""
    if form in result.texts:
        content, kind = result.texts[form]().encode(), "text/plain; charset=utf-8"
        return Response(content, 200, dict(headers or {}), kind)
    match form:
        case "csv":
            content, kind = as_csv(result.table()), "text/csv; charset=utf-8"
        case "npz":
            arrays = result.arrays() if result.arrays else result.payload
            content, kind = as_npz(arrays), "application/x-npz"
        case _:
            content, kind = as_json(result.payload, encoding), "application/json"
    return Response(content, 200, dict(headers or {}), kind)


def as_json(payload: Payload, encoding: str) -> bytes:
    """Return JSON; NaN and infinities are null, or NaN in base64."""
    if encoding == "base64":
        return orjson.dumps(payload, default=_typed)
    return orjson.dumps({n: _counted(n, value) for n, value in payload.items()}, default=_listed)


def _counted(name: str, value: Any) -> Any:
    """Return switches of which some are NaN as integers and None; else `value` as it is."""
    if name != "switches" or not isinstance(value, np.ndarray) or value.dtype.kind != "f":
        return value
    counts = np.where(np.isnan(value), -1.0, value).astype(np.int32).astype(object)
    counts[np.isnan(value)] = None
    return counts.tolist()


def _listed(value: object) -> object:
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{type(value).__name__} has no JSON form")
    if value.dtype.kind == "U":
        return value.tolist()
    array = np.ascontiguousarray(value)
    return orjson.Fragment(orjson.dumps(array, option=orjson.OPT_SERIALIZE_NUMPY))


def _typed(value: object) -> object:
    if isinstance(value, np.ndarray) and value.dtype.kind != "U":
        return typed_array(value)
    return _listed(value)


def typed_array(values: npt.NDArray[Any]) -> dict[str, str]:
    """Return an array as Plotly takes it: dtype, shape, little-endian base64."""
    if values.dtype.kind == "f":
        values = np.where(np.isfinite(values), values, np.nan)
    little = np.ascontiguousarray(values, values.dtype.newbyteorder("<"))
    return {
        "dtype": f"{values.dtype.kind}{values.dtype.itemsize}",
        "shape": ",".join(map(str, values.shape)),
        "bdata": base64.b64encode(little.data).decode(),
    }


def as_csv(table: Table) -> bytes:
    """Return a header row and one row per element of the columns (N,); None and NaN are empty."""
    columns = [_texts(_counted(name, column)) for name, column in table.items()]
    rows = b"\n".join(map(b",".join, zip(*columns, strict=True)))
    return b",".join(name.encode() for name in table) + b"\n" + rows + b"\n"


def _texts(column: npt.NDArray[Any] | list[Any]) -> list[bytes]:
    """Return the shortest texts that read back as the same numbers."""
    if isinstance(column, np.ndarray) and column.dtype.kind != "U":
        text = orjson.dumps(np.ascontiguousarray(column), option=orjson.OPT_SERIALIZE_NUMPY)
        texts = text[1:-1].split(b",") if column.size else []
        return [b"" if t == b"null" else t for t in texts]
    return [_text(value) for value in column]


def _text(value: object) -> bytes:
    text = value if isinstance(value, str) else orjson.dumps(value).decode()
    if text == "null":
        return b""
    quoted = '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\n') else text
    return quoted.encode()


def flattened(payload: Payload, prefix: str = "") -> Payload:
    """Return `payload` with nested keys joined by dots, without the list of episodes."""
    flat: Payload = {}
    for name, value in payload.items():
        if value is None and name in PARTS:
            flat |= {
                f"{prefix}{name}.{part.name}": None for part in dataclasses.fields(PARTS[name])
            }
        elif dataclasses.is_dataclass(value):
            flat |= flattened(vars(value), f"{prefix}{name}.")
        elif isinstance(value, dict):
            flat |= flattened(value, f"{prefix}{name}.")
        elif name != "episodes":
            flat[prefix + name] = value
    return flat


def as_npz(payload: Payload) -> bytes:
    """Return one array per key; what does not exist is NaN."""
    arrays = {
        name: np.asarray(np.nan if value is None else value)
        for name, value in flattened(payload).items()
    }
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)  # type: ignore[arg-type] # its stub takes names for options
    return buffer.getvalue()
