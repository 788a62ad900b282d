"""What the body of a request may say, call by call, and reading those with long lists."""

import functools
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace
from typing import Annotated, Any, Literal, NotRequired, Union

import numpy as np
from annotated_types import Ge, Le, Len
from pydantic import BeforeValidator, Field, ValidationError
from typing_extensions import TypedDict

from restitution.bounds import Misfit, Words, annotations, as_float, closed, plain, said
from restitution.errors import CostError
from restitution.mechanics.hertz import FloatArray
from restitution.methods.options import Damping, NormalRestitution, Options, Tolerance
from restitution.studies.collision.axis import Axis, Scale
from restitution.studies.collision.dampings import dampings_told, no_way_with, told_twice
from restitution.studies.collision.many import LISTED, QUANTITIES, BatchQuantity, ListedQuantity
from restitution.studies.collision.parameters import (
    CollisionParameters,
    GtOverGn,
    Kappa,
    MuOverAlpha,
)
from restitution.studies.spheres.bodies import Body, NotNegative, Positive, two_walls
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import AnyImpact
from restitution.studies.spheres.velocity_map import one_velocity_missing
from restitution.wire.arrays import MOST_ITEMS, number_array
from restitution.wire.damped import Damped
from restitution.wire.parsing import in_utf8, parse_lists
from restitution.wire.reading import adapter, entries
from restitution.wire.refusals import RefusedParametersError, refusal


@closed
class Labels:
    """What an item of ``/materials`` has beside a collision: such an item is a valid body."""

    id: Any = None
    title: Any = None
    source: Any = None
    notes: Any = None
    measured: Any = None


@closed
class ScalingBody(Labels, Contact):
    """A collision of real bodies."""

    # without `field()` the method of this name would be its default
    impact: AnyImpact = field()  # type: ignore[assignment]


Whole = Annotated[
    int,
    Ge(2),
    Le(10_000),
    # some languages write every number with a point
    BeforeValidator(lambda v: int(v) if isinstance(v, float) and v.is_integer() else v),
]


@closed
class VelocityRange:
    """Velocities along an edge of a map, in m/s; min < max, on a log scale min > 0."""

    min: NotNegative
    max: Positive
    count: Whole = 150
    scale: Scale = "linear"

    def axis(self, name: str) -> Axis:
        """Return the values."""
        return Axis(self.min, self.max, self.count, self.scale, f"{name}.")


@closed
class NormalRange(VelocityRange):
    """The same of normal velocities; min > 0."""

    min: Positive
    count: Whole = 200


@closed
class CodesBody(Damped):
    """A scaled collision, and the bodies and the velocity in m/s that are to have it."""

    body_1: Body
    body_2: Body
    normal_velocity_m_s: Positive
    kappa: Kappa
    mu_over_alpha: MuOverAlpha
    gt_over_gn: GtOverGn

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield that both bodies are walls."""
        yield from two_walls(given)

    @property
    def parameters(self) -> CollisionParameters:
        """The collision itself."""
        return CollisionParameters(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.eta)


RANGE = Words("an object with min, max, count and scale")
NORMAL, TANGENTIAL = "normal_velocity_m_s", "tangential_velocity_m_s"


@closed
class VelocityMapBody(Labels, Contact):
    """Real bodies over both velocities; `impact` is not looked at."""

    impact: Any = None
    normal_velocity_m_s: Annotated[NormalRange, RANGE]
    tangential_velocity_m_s: Annotated[VelocityRange, RANGE]
    quantities: Annotated[
        list[BatchQuantity],
        Len(1, len(QUANTITIES)),
        Words(f"a list, not empty, of {', '.join(QUANTITIES)}"),
    ] = field(default_factory=lambda: ["epsilon_t", "switches"])
    tolerance: Tolerance = 1e-10

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield what is wrong with the ends, and with the velocity of a damping."""
        yield from one_velocity_missing(given)
        for name in (NORMAL, TANGENTIAL):
            if isinstance(ends := given.get(name), Mapping):
                low, high = as_float(ends.get("min")), as_float(ends.get("max"))
                if low == 0 and ends.get("scale") == "log":
                    yield f"{name}.min", "finite and > 0"
                if low >= high:
                    yield f"{name}.max", f"greater than {name}.min = {low!r}"

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """The edges: normal and tangential velocity."""
        return (
            self.normal_velocity_m_s.axis(NORMAL),
            self.tangential_velocity_m_s.axis(TANGENTIAL),
        )

    @property
    def options(self) -> Options:
        """What the methods take of it."""
        return Options(tolerance=self.tolerance)


class NumbersInBase64(TypedDict):
    """A list of numbers, little-endian."""

    __pydantic_config__ = {"extra": "forbid"}  # type: ignore[misc] # noqa: RUF012 - as pydantic has it

    dtype: Literal["f8", "f4", "i4"]
    bdata: Annotated[str, Field(description="base64")]
    shape: NotRequired[Annotated[str | int | None, Field(description="the length, if given")]]


class Many:
    """A number for all collisions, or a list of numbers."""

    def __init__(self, each: Any) -> None:
        self.each = each

    def __get_pydantic_core_schema__(self, _: Any, handler: Any) -> Any:
        """Describe it; it is read by `number_array`, as a whole."""
        each = self.each
        return handler.generate_schema(Union[each, list[each], NumbersInBase64])  # type: ignore[valid-type] # noqa: UP007


@closed
class CollisionsBody(Options):
    """Many collisions: numbers, which hold for all, and lists of one length, at most 1,000,000."""

    kappa: Annotated[FloatArray, Many(Kappa)]
    mu_over_alpha: Annotated[FloatArray, Many(MuOverAlpha)]
    gt_over_gn: Annotated[FloatArray, Many(GtOverGn)]
    damping: Annotated[FloatArray, Many(Damping)] = field(  # type: ignore[assignment]
        default_factory=lambda: np.array(0.0)
    )
    normal_restitution: Annotated[FloatArray | None, Many(NormalRestitution)] = None
    quantities: Annotated[list[ListedQuantity], Len(1, len(LISTED))] = field(
        default_factory=lambda: list(LISTED)
    )

    @functools.cached_property
    def dampings(self) -> FloatArray:
        """η as understood."""
        return dampings_told(self.damping, self.normal_restitution)

    @property
    def options(self) -> Options:
        """What the methods take of it beside the damping."""
        names = annotations(Options).keys() - {"damping"}
        return Options(**{name: getattr(self, name) for name in names})


MANY = {
    name: many
    for name, annotation in annotations(CollisionsBody).items()
    if (many := said(annotation, Many))
}
REQUIRED = {"kappa", "mu_over_alpha", "gt_over_gn"}
NUMBERS = {n for n, of in annotations(CollisionsBody).items() if plain(of) in (float, int)}


def read_collisions(text: bytes) -> CollisionsBody:
    """Return many collisions, their numbers as arrays of shape () or (N,).

    Raises
    ------
    RefusedParametersError
        If anything is wrong: all of it at once.
    MalformedBodyError
        If it is no JSON object, or not in UTF-8.
    CostError
        If there are more than `MOST_ITEMS`.
    """
    body = parse_lists(in_utf8(text))
    _refuse_too_many(len(value) for value in body.values() if isinstance(value, list))
    arrays: dict[str, FloatArray] = {}
    errors = [_told_twice(name, body[name], words) for name, words in told_twice(body)]
    # null is no number, wherever it is given
    for name, many in MANY.items():
        if name in body or name in REQUIRED:
            arrays[name], wrong = number_array(name, body.get(name), many.each)
            errors += wrong
    # texts and booleans are no numbers here, as they are in a query
    others = {
        name: None if name in NUMBERS and isinstance(value, str | bool) else value
        for name, value in body.items()
        if name not in MANY
    }
    ways = no_way_with(others, arrays.get("normal_restitution", np.array(1.0)))
    errors += [refusal(name, others[name], words) for name, words in ways]
    read = None
    try:
        read = adapter(CollisionsBody).validate_python(others | dict.fromkeys(arrays, 1.0))
    except ValidationError as error:
        errors += entries(CollisionsBody, body, error)
    lengths = {name: array.size for name, array in arrays.items() if array.ndim}
    if len(set(lengths.values())) > 1:
        errors += [
            refusal(name, f"{length} elements", "of one length with the other lists")
            for name, length in lengths.items()
        ]
    if errors or read is None:
        raise RefusedParametersError(errors)
    _refuse_too_many(lengths.values())
    return replace(read, **arrays)  # type: ignore[no-any-return]


def _told_twice(name: str, value: object, words: str) -> dict[str, Any]:
    return refusal(name, value if isinstance(value, int | float) else "a list", words)


def _refuse_too_many(lengths: Iterable[int]) -> None:
    if (count := max(lengths, default=1)) > MOST_ITEMS:
        raise CostError(
            f"{count:,} collisions in one request are more than {MOST_ITEMS:,}, the limit"
        )
