"""What a query may say, call by call."""

import functools
import math
from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from typing import Annotated, Any, Literal

from annotated_types import Ge, Gt, Le

from restitution.bounds import Meaning, Misfit, Words, annotations, closed
from restitution.mechanics.contact import MOST_DAMPING
from restitution.mechanics.scaled_velocity import psi_of
from restitution.mechanics.stepping import most_steps
from restitution.methods.options import Options, WantedError
from restitution.methods.planner import is_quick, switches_to_follow
from restitution.studies.accuracy.scenes import SceneName
from restitution.studies.collision import many, one, trace
from restitution.studies.collision.axis import Axis, Scale
from restitution.studies.collision.dampings import no_way_with, told_twice
from restitution.studies.collision.parameters import (
    CollisionParameters,
    GtOverGn,
    Kappa,
    MuOverAlpha,
)
from restitution.studies.spheres import bounce
from restitution.studies.spheres.walton import Beta0
from restitution.studies.tables.grid import Sign
from restitution.wire.damped import Damped
from restitution.wire.formats import CsvOptions
from restitution.wire.ranges import Range, as_number
from restitution.wire.several import Several

QUICK_ROWS = 2500
"""Of an answer: with all columns of a trace four milliseconds, most of them for writing them."""


@closed
class NoQuery:
    """A call without parameters."""


@closed
class FormQuery(CsvOptions):
    """The form of an answer."""

    format: Literal["json", "csv", "npz"] = "json"
    encoding: Annotated[
        Literal["plain", "base64"],
        Words("base64, or plain for lists"),
        Meaning("form of arrays in JSON"),
    ] = "plain"


@closed
class ComputedQuery(Damped, Options, FormQuery):
    """A request for quantities, the way to them and their form."""

    quantities: str = ""

    @staticmethod
    def misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield what is wrong with the way beside the damping."""
        restitution = as_number(given.get("normal_restitution"), None)
        yield from no_way_with(given, 1.0 if restitution is None else restitution)

    @functools.cached_property
    def options(self) -> Options:
        """What the methods take: the query itself, unless η is to be found."""
        return self if self.normal_restitution is None else replace(self, damping=self.eta)

    @property
    def wanted(self) -> tuple[str, ...]:
        """The quantities asked for."""
        return tuple(self.quantities.split(","))


@closed
class CollisionQuery(ComputedQuery):
    """``GET /collision``."""

    quantities: Annotated[str, Several(*one.QUANTITIES)] = ",".join(one.QUANTITIES)
    kappa: Kappa
    mu_over_alpha: MuOverAlpha
    gt_over_gn: GtOverGn
    episode_limit: one.EpisodeLimit = 200

    @functools.cached_property
    def parameters(self) -> CollisionParameters:
        """The collision itself."""
        return CollisionParameters(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.eta)

    @property
    def is_quick(self) -> bool:
        """Whether it is computed and written in some milliseconds."""
        switches = switches_to_follow(self.kappa, psi_of(self.mu_over_alpha, self.gt_over_gn))
        quick = is_quick(switches, self, damped=self.is_damped)
        return quick and self.rows(switches) <= QUICK_ROWS

    def rows(self, switches: float) -> float:
        """Return how many rows are written of a collision of so many switches: its episodes."""
        return min(self.episode_limit, switches)


@closed
class TraceQuery(CollisionQuery):
    """``GET /trace``."""

    quantities: Annotated[str, Several(*trace.COLUMNS)] = ",".join(trace.COLUMNS)
    samples: trace.Samples = 400

    def rows(self, switches: float) -> float:
        """Return how many rows are written: episodes, samples with switches, steps of its own."""
        steps = most_steps(self.steps) if self.method == "timestep" else 0
        return super().rows(switches) + self.samples + switches + steps


BatchQuantities = Annotated[str, Several(*many.QUANTITIES)]

CUTS = {
    "kappa": Range("minimum", "maximum", "scale", (0.1, 70.0), positive=True),
    "gt_over_gn": Range("minimum", "maximum", "scale", (0.01, 4.0), positive=False),
}


@closed
class CutQuery(ComputedQuery):
    """``GET /cut``; the ends have defaults that depend on `along`."""

    quantities: BatchQuantities = "epsilon_t,switches"
    along: Literal["gt_over_gn", "kappa"]
    mu_over_alpha: MuOverAlpha
    kappa: Kappa | None = None
    gt_over_gn: GtOverGn | None = None
    minimum: Annotated[float, Ge(0)] | None = None
    maximum: Annotated[float, Gt(0)] | None = None
    count: Annotated[int, Ge(2), Le(100_000)] = 400
    scale: Scale = "linear"

    @staticmethod
    def fill(given: Mapping[str, str]) -> dict[str, Any]:
        """Return the ends where they are not given."""
        if (along := given.get("along")) not in CUTS:
            return {}
        low, high = CUTS[along].default
        return {"minimum": low, "maximum": high}

    @staticmethod
    def misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield what is wrong with the parameters beside each other."""
        along = given.get("along")
        if along not in CUTS:
            return
        if along in given:
            yield along, "left out, as `along` names it"
        for other in CUTS.keys() - {along} - given.keys():
            yield other, "given, as `along` is the other one"
        yield from CUTS[along].misfits(given)

    @property
    def axis(self) -> Axis:
        """The values along the cut."""
        assert self.minimum is not None
        assert self.maximum is not None
        return Axis(self.minimum, self.maximum, self.count, self.scale)


KAPPAS = Range("kappa_min", "kappa_max", "kappa_scale", (0.1, 70.0), positive=True)
TANGENTIAL = Range(
    "gt_over_gn_min", "gt_over_gn_max", "gt_over_gn_scale", (0.01, 4.0), positive=False
)
PSIS = Range("psi_min", "psi_max", "psi_scale", (0.01, 4.0), positive=False)
DAMPINGS = Range("damping_min", "damping_max", "damping_scale", (0.0, math.inf), positive=False)
"""The optional third axis of a table; its maximum asks for it."""

Count = Annotated[int, Ge(2)]


@closed
class KappaEdge:
    """κ along the edge of a map or table."""

    kappa_min: Annotated[float, Gt(0), Meaning("kappa at an edge of the map")] = KAPPAS.default[0]
    kappa_max: Annotated[float, Gt(0), Meaning("kappa at an edge of the map")] = KAPPAS.default[1]
    kappa_count: Count = 200
    kappa_scale: Scale = "linear"

    @property
    def kappa_axis(self) -> Axis:
        """The values of κ."""
        return _edge(self, "kappa_")


def _edge(query: Any, prefix: str) -> Axis:
    """Return the axis that four parameters describe."""
    low, high, count, scale = (
        getattr(query, prefix + name) for name in ("min", "max", "count", "scale")
    )
    return Axis(low, high, count, scale, prefix)


TangentialEdge = Meaning("gt_over_gn at an edge of the map")


@closed
class MapQuery(KappaEdge, ComputedQuery):
    """``GET /map``."""

    quantities: BatchQuantities = "epsilon_t,switches"
    mu_over_alpha: MuOverAlpha
    gt_over_gn_min: Annotated[float, Ge(0), TangentialEdge] = TANGENTIAL.default[0]
    gt_over_gn_max: Annotated[float, Gt(0), TangentialEdge] = TANGENTIAL.default[1]
    gt_over_gn_count: Count = 150
    gt_over_gn_scale: Scale = "linear"

    @staticmethod
    def misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield what is wrong with the edges."""
        yield from KAPPAS.misfits(given)
        yield from TANGENTIAL.misfits(given)

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """The edges: κ and g_t/g_n."""
        return self.kappa_axis, _edge(self, "gt_over_gn_")


TableFormat = Literal["csv", "npz", "c", "python"]

PsiEdge = Meaning("psi at an edge of the map")
DampingEdge = Meaning("damping at an edge of the map")


@closed
class TableQuery(Damped, KappaEdge, CsvOptions):
    """``GET /table``; the error wanted, or else counts."""

    psi_min: Annotated[float, Ge(0), PsiEdge] = PSIS.default[0]
    psi_max: Annotated[float, Gt(0), PsiEdge] = PSIS.default[1]
    psi_count: Count = 150
    psi_scale: Scale = "linear"
    damping_min: Annotated[float, Ge(0), Le(MOST_DAMPING), DampingEdge] = 0.0
    damping_max: Annotated[float, Gt(0), Le(MOST_DAMPING), DampingEdge] | None = None
    damping_count: Count = 10
    damping_scale: Scale = "linear"
    error: WantedError | None = None
    sign: Sign = "paper"
    format: TableFormat = "csv"

    @staticmethod
    def fill(given: Mapping[str, str]) -> dict[str, Any]:
        """Return the scales where they are not given.

        As of ``/map``; logarithmic, which takes fewer entries, where an error decides about the
        grid.
        """
        wants_few = "error" in given
        return {
            axis.scale: "log"
            if wants_few and as_number(given.get(axis.minimum), axis.default[0]) != 0.0
            else "linear"
            for axis in (KAPPAS, PSIS)
        }

    @staticmethod
    def misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield what is wrong with the parameters beside each other."""
        yield from KAPPAS.misfits(given)
        yield from PSIS.misfits(given)
        if DAMPINGS.maximum in given:
            yield from DAMPINGS.misfits(given)
            yield from told_twice(given, DAMPINGS.maximum)
            if as_number(given.get("damping"), 0.0) != 0.0:
                yield "damping", "left out, as `damping_max` makes it an axis"
        else:
            for name in (DAMPINGS.minimum, DAMPINGS.scale, "damping_count"):
                if name in given and not _is_default(TableQuery, name, given[name]):
                    yield name, "left out, or `damping_max` given, which makes damping an axis"
        for count in ("kappa_count", "psi_count", "damping_count"):
            if "error" in given and count in given:
                yield count, "left out, as `error` is given and decides about it"

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """The edges: κ and ψ."""
        return self.kappa_axis, _edge(self, "psi_")

    @property
    def counts(self) -> tuple[int, ...]:
        """Entries along κ, ψ, and η where it is an axis."""
        third = () if self.damping_max is None else (self.damping_count,)
        return self.kappa_count, self.psi_count, *third

    @property
    def third(self) -> Axis | float:
        """The axis of η where there is one, else the η of all entries."""
        return self.eta if self.damping_max is None else _edge(self, "damping_")


def _is_default(query: type, name: str, text: str) -> bool:
    """Return whether a parameter is given as what it is without."""
    [default] = (each.default for each in fields(query) if each.name == name)
    return text == default or as_number(text, None) == default


@closed
class SceneQuery(NoQuery):
    """A scene of the measurement of speed and accuracy."""

    scene: SceneName = "figure4"


@closed
class TradeoffQuery(SceneQuery, FormQuery):
    """``GET /tradeoff``."""


@closed
class WaltonQuery(FormQuery):
    """``GET /walton``."""

    beta_0: Beta0


@closed
class BounceQuery(Damped, FormQuery):
    """``GET /bounce``."""

    kappa: Kappa
    mu_over_alpha: MuOverAlpha
    gt_over_gn: GtOverGn
    alpha: bounce.Alpha = bounce.SOLID_ALPHA
    partner: bounce.Partner = "wall"
    spin_share: bounce.SpinShare = 0.0

    @property
    def parameters(self) -> CollisionParameters:
        """The first collision."""
        return CollisionParameters(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.eta)

    @property
    def is_quick(self) -> bool:
        """Whether both collisions are computed in some milliseconds.

        With damping the second spring is stiffer, and how much so takes work to find.
        """
        psis = psi_of(self.mu_over_alpha, self.gt_over_gn), bounce.PSI_OF_MOST_SWITCHES
        switches = sum(switches_to_follow(self.kappa, psi) for psi in psis)
        return not self.is_damped and is_quick(switches, Options(), damped=False)


@closed
class StepsQuery(Damped, FormQuery):
    """``GET /steps``: a collision, or else a region."""

    error: WantedError = 1e-3
    region: SceneName | None = None
    kappa: Kappa | None = None
    mu_over_alpha: MuOverAlpha | None = None
    gt_over_gn: GtOverGn | None = None

    @staticmethod
    def misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield what is wrong with the parameters beside each other."""
        names = ("kappa", "mu_over_alpha", "gt_over_gn")
        if "region" not in given:
            yield from ((name, "given, or else `region`") for name in names if name not in given)
            return
        for name in (*names, "damping", "normal_restitution"):
            if name in given and not _is_default(StepsQuery, name, given[name]):
                yield name, "left out, as `region` is given"

    @property
    def parameters(self) -> CollisionParameters | None:
        """The collision, None for a region."""
        if self.kappa is None or self.mu_over_alpha is None or self.gt_over_gn is None:
            return None
        return CollisionParameters(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.eta)


FORM = {"format", "encoding", "quantities", "episode_limit", *annotations(CsvOptions)}
"""Parameters of a query that are not the collision's."""


def as_understood(query: Damped, **more: Any) -> dict[str, Any]:
    """Return the parameters of a query without those of its form, defaults filled in.

    Of ε_n in place of the damping there is left what was found.
    """
    of: Any = type(query)
    understood = {name: getattr(query, name) for name in _understood(of)}
    return understood | {"damping": query.eta} | more


@functools.cache
def _understood(query: Any) -> list[str]:
    return [n for n in annotations(query) if n not in FORM and n != "normal_restitution"]
