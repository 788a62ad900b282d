"""Reading a query or a body into a dataclass: everything that is wrong with it, at once.

pydantic reads, by the annotations of the dataclass; the words come from `bounds.requirement`.
"""

import functools
import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import is_dataclass
from typing import Any, TypeVar, get_args

from pydantic import TypeAdapter, ValidationError

from restitution.bounds import (
    Choice,
    Words,
    annotations,
    members,
    misfits,
    plain,
    requirement,
    said,
)
from restitution.errors import ParameterError
from restitution.neighbours import neighbour
from restitution.wire.parsing import TOO_DEEP, in_utf8, parse_nested
from restitution.wire.refusals import (
    UNKNOWN,
    MalformedBodyError,
    RefusedParametersError,
    refusal,
    unknown,
)

Read = TypeVar("Read")
Entry = dict[str, Any]

MOST_NEIGHBOURS = 5
"""Unknown parameters of a request for which it is looked what they were meant for."""


adapter: Callable[[Any], TypeAdapter[Any]] = functools.cache(TypeAdapter)
"""Type → what reads and describes it."""


def read_query(of: type[Read], pairs: Sequence[tuple[str, str]]) -> Read:
    """Return the parameters of a query; `RefusedParametersError` names all that is wrong."""
    given = dict(pairs)
    fill = getattr(of, "fill", None)
    filled = fill(given) | given if fill else given
    read: Read | None = None
    errors: list[Entry] = []
    try:
        read = adapter(of).validate_python(filled)
    except ValidationError as error:
        errors = entries(of, filled, error)
    errors = _with(errors, _misfits(of, given))
    if len(given) < len(pairs):
        errors += _given_again(pairs)
    return _read(read, errors)


def read_object(of: type[Read], text: bytes) -> Read:
    """Return a JSON object as a dataclass.

    Raises
    ------
    RefusedParametersError
        If anything in it is wrong: all of it at once.
    MalformedBodyError
        If it is no JSON object, or not in UTF-8.
    """
    text = in_utf8(text)
    given = parse_nested(text)
    read: Read | None = None
    errors: list[Entry] = []
    try:
        read = adapter(of).validate_json(text, strict=True)
    except ValidationError as error:
        if error.errors()[0]["type"] == "json_invalid":
            # Python's reader goes deeper than pydantic's
            raise MalformedBodyError(TOO_DEEP) from error
        errors = entries(of, given, error)
    return _read(read, _with(errors, _misfits(of, given)))


def _read(read: Read | None, errors: list[Entry]) -> Read:
    """Return what was read, if nothing is wrong with it."""
    if errors:
        raise RefusedParametersError(errors)
    # a class that refuses what neither its bounds nor its rules do would be a defect
    assert read is not None
    return read


def _given_again(pairs: Sequence[tuple[str, str]]) -> list[Entry]:
    values: dict[str, list[str]] = {}
    for name, value in pairs:
        values.setdefault(name, []).append(value)
    return [
        refusal(name, ", ".join(given), "given once")
        for name, given in values.items()
        if len(given) > 1
    ]


def _with(errors: list[Entry], more: Iterator[Entry]) -> list[Entry]:
    """Return errors and more of them; a rule knows better why a member is to be left out."""
    reasons = {entry["parameter"]: entry for entry in more}
    if not errors:
        return [*reasons.values()]
    joined = [
        reasons.pop(error["parameter"], error)
        if error["requirement"].startswith(UNKNOWN)
        else error
        for error in errors
    ]
    named = {error["parameter"].partition("[")[0] for error in joined}
    return joined + [entry for name, entry in reasons.items() if name not in named]


def entries(of: Any, given: Any, error: ValidationError) -> list[Entry]:
    """Return an entry for each member that pydantic refused."""
    found: dict[str, Entry] = {}
    objects = set()
    strangers = itertools.count()
    for each in error.errors(include_url=False):
        if isinstance(each.get("ctx", {}).get("error"), ParameterError):
            # members that do not suit each other: `_misfits` tells them, with the others
            continue
        name, value, words = _located(of, given, each["loc"], each["type"])
        if words == UNKNOWN and next(strangers) < MOST_NEIGHBOURS:
            words = unknown(_neighbour(of, name))
        found.setdefault(name, refusal(name, value, words))
        if len(each["loc"]) > 1:
            objects.add(name.rpartition(".")[0])
    # of a union that is refused as a word and as an object, the object tells more
    return [entry for name, entry in found.items() if name not in objects]


def _neighbour(of: Any, name: str) -> str | None:
    """Return what a member was perhaps meant for: one of the same object, or of the whole."""
    place, _, last = name.rpartition(".")
    names = names_within(of)
    beside = [each for each in names if each.rpartition(".")[0] == place]
    return neighbour(last, beside) or neighbour(last, names)


@functools.cache
def names_within(of: Any) -> tuple[str, ...]:
    """Return the members of a class, and as dotted names those of the objects in it."""
    own = annotations(of)
    inner = [
        f"{name}.{each}"
        for name, annotation in own.items()
        for part in members(annotation)
        if is_dataclass(plain(part))
        for each in names_within(plain(part))
    ]
    return (*own, *inner)


def _located(of: Any, given: Any, path: tuple[int | str, ...], kind: str) -> tuple[str, Any, str]:
    """Return the name of a member, its value, and what holds for it."""
    name, value, words = "", given, requirement(of)
    for part in path:
        bare = plain(of)
        if is_dataclass(bare):
            known = annotations(bare)
            if part not in known:
                # once refused for being there, a member has no members
                return _dotted(name, part), _member(value, part), UNKNOWN
            of, name, value = known[str(part)], _dotted(name, part), _member(value, part)
        elif isinstance(part, int):
            if kind in ("missing", "too_long") or said(of, Words) is not None:
                break
            element = get_args(bare)[0]
            of, name, value = element, f"{name}[{part}]", value[part]
        elif tagged := [each for each in members(of) if getattr(each, "__name__", "") == part]:
            # a step into the class of a union that was chosen
            of = tagged[0]
            continue
        words = requirement(of)
    return name, value, words


def _dotted(name: str, member: object) -> str:
    return f"{name}.{member}" if name else str(member)


def _member(value: Any, name: object) -> Any:
    return value.get(name) if isinstance(value, Mapping) else None


def _misfits(of: Any, given: Any, name: str = "") -> Iterator[Entry]:
    """Yield entries for members that do not suit each other, in objects within objects, too."""
    if not isinstance(given, Mapping):
        return
    there = {key: value for key, value in given.items() if value is not None}
    for member, words in misfits(of, there):
        value: Any = there
        for part in member.split("."):
            value = _member(value, part)
        yield refusal(_dotted(name, member), value, words)
    for member, annotation, choice in _objects(of):
        value = given.get(member)
        inner = choice.among(plain(annotation), value) if choice else plain(annotation)
        yield from _misfits(inner, value, _dotted(name, member))


@functools.cache
def _objects(of: Any) -> list[tuple[str, Any, Choice | None]]:
    """Return the members that are objects, and which kind of object where there are several."""
    return [
        (name, annotation, choice)
        for name, annotation in annotations(of).items()
        if (choice := said(annotation, Choice)) or is_dataclass(plain(annotation))
    ]
