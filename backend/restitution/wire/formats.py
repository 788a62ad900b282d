"""The forms of an answer: JSON, JSON with base64 arrays, CSV, NPZ, texts for other codes."""

import dataclasses
import io
import unicodedata
import zipfile
from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any, Literal, get_args

import numpy as np
import numpy.typing as npt
import orjson
import pybase64

from restitution.bounds import Meaning, Misfit, choice, closed
from restitution.quantities import unit_of
from restitution.studies.collision.one import Energy, Estimates, Sensitivity
from restitution.studies.collision.parameters import CONVENTION

ROWS = 10_000
"""Of a table that are written at a time, and numbers of an array that are sent by themselves."""

PARTS = {"energy": Energy, "estimates": Estimates, "sensitivity": Sensitivity}
"""Keys whose values have keys of their own, and columns of a table even where they are null."""

Separator = Literal["comma", "semicolon", "tab"]
Decimal = Literal["point", "comma"]
Header = Literal["names", "units"]
MARKS = {"comma": b",", "semicolon": b";", "tab": b"\t", "point": b"."}

FORMULA = "=+-@\t\r\u2212"
"""What a text begins with that a spreadsheet may take for a formula."""

Payload = dict[str, Any]
Table = Mapping[str, npt.NDArray[Any] | list[Any]]


@closed
class CsvOptions:
    """How CSV is written; of other forms it changes nothing."""

    separator: Annotated[Separator, Meaning("between the cells of csv")] = "comma"
    decimal: Annotated[Decimal, Meaning("decimal mark of csv")] = "point"
    header: Annotated[
        Header, Meaning("what csv begins with; before the names, a line of units with # in front")
    ] = "names"

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield that one mark cannot be both."""
        separator, decimal = given.get("separator", "comma"), given.get("decimal", "point")
        if separator == decimal:
            others = tuple(mark for mark in get_args(Separator) if mark != decimal)
            yield "separator", f"{choice(others)} where `decimal` is {decimal}"


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
    convention : str
        Sign and point of reference of its numbers.
    """

    payload: Payload
    table: Callable[[], Table]
    arrays: Callable[[], Payload] | None = None
    texts: Mapping[str, Callable[[], str]] = dataclasses.field(default_factory=dict)
    convention: str = CONVENTION


def formed(
    result: Result, form: str, encoding: str = "plain", options: CsvOptions | None = None
) -> tuple[str, Iterator[bytes]]:
    """Return the media type of `result` in a form, and its bytes block by block."""
    if form in result.texts:
        return "text/plain; charset=utf-8", iter([result.texts[form]().encode()])
    match form:
        case "csv":
            blocks = csv_blocks(result.table(), options or CsvOptions(), result.convention)
            return "text/csv; charset=utf-8", blocks
        case "npz":
            arrays = result.arrays() if result.arrays else result.payload
            return "application/x-npz", npz_blocks(arrays)
    return "application/json", iter([as_json(result.payload, encoding)])


def in_one_piece(result: Result, form: str, options: CsvOptions | None = None) -> bytes:
    """Return the bytes of `result` in a form, as a file holds them."""
    return b"".join(formed(result, form, options=options)[1])


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


def typed_array(values: npt.NDArray[Any]) -> orjson.Fragment:
    """Return an array as Plotly takes it: dtype, shape, little-endian base64."""
    if values.dtype.kind == "f":
        finite = np.isfinite(values)
        # half the work of `all`, which is Python in numpy
        if np.count_nonzero(finite) < values.size:
            values = np.where(finite, values, np.nan)
    little = np.ascontiguousarray(values, values.dtype.newbyteorder("<"))
    shape = ",".join(map(str, values.shape))
    # written by hand, for orjson would look through every character of the base64
    return orjson.Fragment(
        b'{"dtype":"%c%d","shape":"%b","bdata":"%b"}'
        % (
            ord(values.dtype.kind),
            values.dtype.itemsize,
            shape.encode(),
            pybase64.b64encode(little.data),
        )
    )


def csv_blocks(table: Table, options: CsvOptions, convention: str = CONVENTION) -> Iterator[bytes]:
    """Yield a header row and then the rows of the columns (N,), many at a time.

    None and NaN are empty. No cell can be a formula: a text that begins as one gets ' in front.
    """
    separator, mark = MARKS[options.separator], MARKS[options.decimal]
    if options.header == "units":
        units = (_quoted(text, separator) for text in (*map(unit_of, table), convention))
        yield b"# " + separator.join(units) + b"\n"
    yield separator.join(name.encode() for name in table) + b"\n"
    length = len(next(iter(table.values())))
    for begin in range(0, length, ROWS):
        part = slice(begin, begin + ROWS)
        columns = [
            _texts(_counted(name, column[part]), separator, mark) for name, column in table.items()
        ]
        yield b"\n".join(map(separator.join, zip(*columns, strict=True))) + b"\n"


def _texts(column: npt.NDArray[Any] | list[Any], separator: bytes, mark: bytes) -> list[bytes]:
    """Return the shortest texts that read back as the same numbers."""
    if isinstance(column, np.ndarray) and column.dtype.kind != "U":
        text = orjson.dumps(np.ascontiguousarray(column), option=orjson.OPT_SERIALIZE_NUMPY)
        texts = text[1:-1].split(b",") if column.size else []
        if mark != b".":
            texts = [t.replace(b".", mark) for t in texts]
        return [b"" if t == b"null" else t for t in texts]
    return [
        _quoted(value, separator) if isinstance(value, str) else _number(value, mark)
        for value in column
    ]


def _number(value: object, mark: bytes) -> bytes:
    text = orjson.dumps(value)
    return b"" if text == b"null" else text.replace(b".", mark)


def _quoted(text: str, separator: bytes) -> bytes:
    """Return a text as a cell that is read back as it is, and by no program as a formula."""
    # wide signs are taken as narrow ones
    if text and unicodedata.normalize("NFKC", text[0]) in FORMULA:
        text = f"'{text}"
    if any(sign in text for sign in f'{separator.decode()}"\n\r'):
        text = '"' + text.replace('"', '""') + '"'
    return text.encode()


def _fields(value: Any) -> Payload:
    """Return the fields of a dataclass; `vars` may hold cached properties as well."""
    return {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}


def flattened(payload: Payload, prefix: str = "") -> Payload:
    """Return `payload` with nested keys joined by dots, without the list of episodes."""
    flat: Payload = {}
    for name, value in payload.items():
        if value is None and name in PARTS:
            flat |= {
                f"{prefix}{name}.{part.name}": None for part in dataclasses.fields(PARTS[name])
            }
        elif dataclasses.is_dataclass(value):
            flat |= flattened(_fields(value), f"{prefix}{name}.")
        elif isinstance(value, dict):
            flat |= flattened(value, f"{prefix}{name}.")
        elif name != "episodes":
            flat[prefix + name] = value
    return flat


class _Sink(io.RawIOBase):
    """A file that cannot be gone back in; what was written to it is taken away."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        self._parts.append(bytes(data))
        return len(data)

    def take(self) -> bytes:
        taken, self._parts = b"".join(self._parts), []
        return taken


def npz_blocks(payload: Payload) -> Iterator[bytes]:
    """Yield one array per key, as `numpy.savez` would write them; what does not exist is NaN."""
    sink = _Sink()
    with zipfile.ZipFile(sink, "w") as archive:
        for name, value in flattened(payload).items():
            array = np.asarray(np.nan if value is None else value)
            with archive.open(f"{name}.npy", "w", force_zip64=True) as entry:
                np.lib.format.write_array(entry, array, allow_pickle=False)
            if array.size > ROWS:
                yield sink.take()
    yield sink.take()
