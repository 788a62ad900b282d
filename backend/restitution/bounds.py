"""What a value may be, said once: by the annotation of its field.

`Annotated[float, Gt(0)]` is checked when an object is made (`checked`), read by pydantic when it
comes in a request (`wire.reading`), described in documents; the words of a refusal follow from it.
"""

import builtins
import functools
import math
import sys
import typing
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass
from numbers import Real
from types import NoneType, UnionType
from typing import (
    Annotated,
    Any,
    Literal,
    NamedTuple,
    TypeVar,
    Union,
    dataclass_transform,
    get_args,
    get_origin,
    get_type_hints,
)

import annotated_types as at

from restitution.errors import ParameterError
from restitution.neighbours import naming_neighbours

if sys.version_info >= (3, 12):
    from typing import TypeAliasType as TypeAliasType  # noqa: PLC0414 - for other rooms, too
else:
    from typing_extensions import TypeAliasType as TypeAliasType  # noqa: PLC0414 - for other rooms, too

Misfit = tuple[str, str]
"""A member and what holds for it beside the others."""

Kind = TypeVar("Kind")


@dataclass(frozen=True)
class Meaning:
    """What a field is, for documents; its bounds are said beside it."""

    text: str

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        """Let schemas say it."""
        return handler(schema) | {"description": self.text}


class OrNothing:
    """Said of a number that may not exist, as it is NaN or infinite: in JSON it is null."""

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> Any:
        """Let schemas say it."""
        return {"anyOf": [handler(schema), {"type": "null"}]}


@dataclass(frozen=True)
class Words:
    """What a value must be, where bounds do not say it well."""

    text: str


@dataclass(frozen=True)
class Choice:
    """Which class of a union an object of JSON is meant for."""

    of: Callable[[Mapping[str, Any]], type]

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """Let pydantic read that class alone, instead of complaining about all of them."""
        from pydantic_core import core_schema  # noqa: PLC0415 - only pydantic asks

        return core_schema.tagged_union_schema(
            {part.__name__: handler.generate_schema(part) for part in get_args(source)},
            discriminator=lambda value: self.among(source, value).__name__,
        )

    def among(self, union: Any, value: object) -> type:
        """Return the class that a value is meant for."""
        if type(value) in get_args(union):
            return type(value)
        return self.of(value if isinstance(value, Mapping) else {})


def members(annotation: Any) -> tuple[Any, ...]:
    """Return the alternatives of a union but None, any other annotation alone."""
    bare = plain(annotation)
    if get_origin(bare) in (Union, UnionType):
        return tuple(part for part in get_args(bare) if part is not NoneType)
    return (annotation,)


def plain(annotation: Any) -> Any:
    """Return an annotation without its bounds, and what stands behind a name."""
    bare = get_args(annotation)[0] if get_origin(annotation) is Annotated else annotation
    return bare.__value__ if isinstance(bare, TypeAliasType) else bare


def said(annotation: Any, kind: type[Kind]) -> Kind | None:
    """Return what an annotation, or the only alternative to None in it, says of a `kind`."""
    for part in (annotation, *members(annotation)):
        if get_origin(part) is Annotated:
            for item in get_args(part)[1:]:
                if isinstance(item, kind):
                    return item
    return None


def requirement(annotation: Any) -> str:
    """Return what holds for allowed values, to stand after "must be"."""
    if own := said(annotation, Words):
        return own.text
    parts = members(annotation)
    if len(parts) > 1 and not any(map(is_dataclass, parts)):
        return ", or ".join(requirement(part) for part in parts)
    kind = plain(parts[0])
    match get_origin(kind):
        case typing.Literal:
            words = choice(get_args(kind))
        case builtins.list:
            words = f"a list, not empty, of {', '.join(get_args(plain(get_args(kind)[0])))}"
        case builtins.tuple:
            words = "three finite numbers"
        case _:
            words = "an object" if is_dataclass(kind) else _range(kind, _bounds(parts[0]))
    return words


def choice(words: tuple[Any, ...]) -> str:
    """Return some words as a choice."""
    texts = [str(word).lower() if isinstance(word, bool) else str(word) for word in words]
    return " or ".join(texts) if len(texts) <= 2 else f"one of {', '.join(texts)}"


def _bounds(annotation: Any) -> tuple[Any, ...]:
    items = get_args(annotation)[1:] if get_origin(annotation) is Annotated else ()
    return tuple(item for item in items if isinstance(item, at.Gt | at.Ge | at.Le | at.Lt))


def _range(kind: type, bounds: tuple[Any, ...]) -> str:
    match bounds:
        case (at.Ge(ge=low), at.Le(le=high)):
            return (
                f"an integer from {low:,} to {high:,}"
                if kind is int
                else f"from {low:g} to {high:g}"
            )
        case (at.Gt(gt=low), at.Le(le=high)):
            return f"> {low:g} and ≤ {high:g}"
        case (at.Ge(ge=low), at.Lt(lt=high)):
            return f"≥ {low:g} and < {high:g}"
        case (at.Ge(ge=low),):
            return f"an integer ≥ {low}" if kind is int else f"finite and ≥ {low:g}"
        case (at.Gt(gt=low),):
            return f"finite and > {low:g}"
    return "a finite number" if kind is float else "a text"


def interval(annotation: Any) -> tuple[float, float]:
    """Return the least and the largest number that is allowed: finite for a float."""
    most = math.inf if plain(annotation) is int else sys.float_info.max
    low, high = -most, most
    for bound in _bounds(annotation):
        match bound:
            case at.Ge(ge=least):
                low = least  # type: ignore[assignment] # of numbers only
            case at.Gt(gt=below):
                low = math.nextafter(below, math.inf)  # type: ignore[arg-type]
            case at.Le(le=largest):
                high = largest  # type: ignore[assignment]
            case at.Lt(lt=above):
                high = math.nextafter(above, -math.inf)  # type: ignore[arg-type]
    return low, high


def annotations(of: Any) -> dict[str, Any]:
    """Return the members that a dataclass is made of, annotated as they are."""
    return _annotations(of)


def values(made: Any) -> dict[str, Any]:
    """Return the members that an object was made of."""
    return {name: getattr(made, name) for name in annotations(type(made))}


@functools.cache
def _annotations(of: Any) -> dict[str, Any]:
    hints = get_type_hints(of, include_extras=True)
    return {member.name: hints[member.name] for member in fields(of) if member.init}


class _Rule(NamedTuple):
    """What a field may hold: numbers of a kind from `low` to `high`, words, objects, a vector."""

    name: str
    annotation: Any
    kind: type | None
    low: float
    high: float
    words: tuple[Any, ...]
    classes: tuple[type, ...]
    is_vector: bool


@functools.cache
def _rules(of: Any) -> list[_Rule]:
    """Return the rules of the fields that have one."""
    rules = [_rule(name, annotation) for name, annotation in annotations(of).items()]
    return [rule for rule in rules if rule]


@functools.cache
def _rule(name: str, annotation: Any) -> _Rule | None:
    parts = members(annotation)
    kinds = [plain(part) for part in parts]
    words = [word for kind in kinds if get_origin(kind) is Literal for word in get_args(kind)]
    number = next((kind for kind in kinds if kind in (float, int)), None)
    classes: tuple[Any, ...] = tuple(filter(is_dataclass, kinds))
    is_vector = get_origin(kinds[0]) is tuple
    if not (words or number or classes or is_vector):
        return None
    words += [None] if NoneType in get_args(plain(annotation)) else []
    return _Rule(name, annotation, number, *interval(parts[0]), tuple(words), classes, is_vector)


def _settle(made: Any) -> None:
    """Refuse what is out of bounds; make numbers of their kind, −0 the 0 that it equals."""
    cls: Any = type(made)
    for rule in _rules(cls):
        value = getattr(made, rule.name)
        if (settled := _settled(rule, value)) is not value:
            object.__setattr__(made, rule.name, settled)


def _settled(rule: _Rule, value: Any) -> Any:
    """Return what a field holds that is given a value, if it may be given that."""
    name, annotation, kind, low, high, words, classes, is_vector = rule
    is_of_kind = type(value) is kind
    # of −0 the sign is to go
    if is_of_kind and low <= value <= high and (value or math.copysign(1, value) > 0):
        return value
    parts = list(map(as_float, value)) if is_vector and isinstance(value, Iterable) else []
    if len(parts) == 3 and all(map(math.isfinite, parts)):
        return tuple(parts)
    if kind and low <= as_float(value) <= high and kind(value) == value:
        return kind(value) + kind(0)
    if value in words or isinstance(value, classes):
        return value
    raise ParameterError(name, value, requirement(annotation))


def allowed(parameter: str, value: Any, annotation: Any) -> Any:
    """Return a parameter of a function as its annotation has it.

    Raises
    ------
    ParameterError
        If it is none that the annotation allows.

    Examples
    --------
    >>> allowed("steps", 50.0, Annotated[int, at.Ge(4)])
    50
    """
    rule = _rule(parameter, annotation)
    assert rule, annotation
    return _settled(rule, value)


def chosen(parameter: str, words: Collection[str], known: Collection[str]) -> tuple[str, ...]:
    """Return words that are known ones; a text holds several as in a query.

    Raises
    ------
    ParameterError
        If one is not known.

    Examples
    --------
    >>> chosen("quantities", "epsilon_t,switches", ["epsilon_t", "epsilon_n", "switches"])
    ('epsilon_t', 'switches')
    """
    given = words.split(",") if isinstance(words, str) else words
    requirement = f"a choice of {', '.join(known)}"
    if not isinstance(given, Iterable):
        raise ParameterError(parameter, given, requirement)
    found = tuple(given)
    for word in found:
        if word not in known:
            raise ParameterError(parameter, word, requirement)
    return found


def as_float(value: object) -> float:
    """Return a number of any kind as a float, NaN for what is none."""
    if isinstance(value, bool) or not isinstance(value, Real):
        return math.nan
    try:
        return float(value)
    except OverflowError:
        return math.inf


def misfits(of: Any, given: Mapping[str, Any]) -> Iterator[Misfit]:
    """Yield which members of a class do not suit each other, by its rules and those it inherits.

    A class says them as a static method `misfits` of what is given.
    """
    for each in _misfits(of):
        yield from each(given)


@functools.cache
def _misfits(of: Any) -> list[Callable[[Mapping[str, Any]], Iterator[Misfit]]]:
    classes = reversed(getattr(of, "__mro__", ()))
    return [each.misfits for each in classes if "misfits" in vars(each)]


def _settle_and_fit(made: Any) -> None:
    _settle(made)
    given = {name: value for name, value in vars(made).items() if value is not None}
    for name, words in misfits(type(made), given):
        raise ParameterError(name, given.get(name), words)


@dataclass_transform(frozen_default=True, kw_only_default=True, field_specifiers=(field,))
def closed(cls: type[Kind]) -> type[Kind]:
    """Make a frozen dataclass of keywords that checks its numbers; JSON may have no other keys."""
    return _made(cls, _settle, kw_only=True)


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def checked(cls: type[Kind]) -> type[Kind]:
    """Make one whose members may be given in order, and must suit each other by its `misfits`."""
    return _made(cls, _settle_and_fit, kw_only=False)


def _made(cls: type[Kind], check: Callable[[Any], None], *, kw_only: bool) -> type[Kind]:
    cls.__post_init__ = check  # type: ignore[attr-defined] # as dataclasses have it
    cls.__pydantic_config__ = {"extra": "forbid", "allow_inf_nan": False}  # type: ignore[attr-defined]
    made: Any = dataclass(frozen=True, kw_only=kw_only)(cls)
    made.__init__ = naming_neighbours(made.__init__)
    return made  # type: ignore[no-any-return]
