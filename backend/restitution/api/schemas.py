"""What a request may say, call by call."""

import functools
from typing import Annotated, Any, ClassVar, Literal, get_args

from pydantic import Field, field_validator, model_validator
from pydantic_core import PydanticCustomError

from restitution.api.fields import (
    REQUIREMENTS,
    Closed,
    Damping,
    Finite,
    GtOverGn,
    Kappa,
    MuOverAlpha,
    choice,
    one_of,
    stated,
    words,
)
from restitution.api.ranges import CUT, table_scales
from restitution.mechanics.viscoelastic import MOST_DAMPING
from restitution.methods.answer import Options
from restitution.methods.planner import METHODS, is_quick
from restitution.studies import batch, collision, trace
from restitution.studies.axis import Axis
from restitution.studies.parameters import CollisionParameters

Method = Literal["auto", "exact", "coulomb", "pragmatic", "stiff", "table", "timestep", "ode"]
Integrator = Literal["velocity_verlet", "symplectic_euler", "forward_euler"]
Scale = Literal["linear", "log"]

TABLE_FORMATS = ("csv", "npz", "c", "python")


class Request(Closed):
    """What every computing request takes."""

    damping: Damping = 0.0
    tolerance: Annotated[
        Finite,
        stated("tolerance", "from 1e-13 to 1", "largest absolute error wanted in ε_t"),
        Field(ge=1e-13, le=1),
    ] = 1e-10
    method: Annotated[Method, stated("method", f"one of auto, {', '.join(METHODS)}")] = "auto"
    steps: Annotated[
        int,
        stated("steps", "an integer from 4 to 1,000,000", "steps per contact of `timestep`"),
        Field(ge=4, le=1_000_000),
    ] = 50
    integrator: Annotated[
        Integrator,
        stated("integrator", "one of velocity_verlet, symplectic_euler, forward_euler"),
    ] = "velocity_verlet"
    phase: Annotated[
        Finite,
        stated("phase", "from 0 to 1", "where in a step of `timestep` the contact begins"),
        Field(ge=0, le=1),
    ] = 0.0
    rtol: Annotated[
        Finite,
        stated("rtol", "from 1e-13 to 0.1", "relative tolerance of `ode`"),
        Field(ge=1e-13, le=0.1),
    ] = 1e-9
    floor: Annotated[
        Finite, stated("floor", "from -1 to 1", "ε₀ of `pragmatic`"), Field(ge=-1, le=1)
    ] = 0.0

    @functools.cached_property
    def options(self) -> Options:
        """What the methods take of it."""
        return Options(
            method=self.method,
            tolerance=self.tolerance,
            damping=self.damping,
            floor=self.floor,
            steps=self.steps,
            integrator=self.integrator,
            phase=self.phase,
            rtol=self.rtol,
        )


class FormQuery(Closed):
    """The form of an answer."""

    format: Annotated[Literal["json", "csv", "npz"], stated("format", "one of json, csv, npz")] = (
        "json"
    )
    encoding: Annotated[
        Literal["plain", "base64"],
        stated("encoding", "base64, or plain for lists", "form of arrays in JSON"),
    ] = "plain"


class Formed(Request, FormQuery):
    """A request by query, whose answer has a form."""

    quantities: str = ""

    @property
    def wanted(self) -> tuple[str, ...]:
        """The quantities asked for."""
        return tuple(self.quantities.split(","))


class CollisionQuery(Formed):
    """``GET /collision``."""

    kappa: Kappa
    mu_over_alpha: MuOverAlpha
    gt_over_gn: GtOverGn
    episode_limit: Annotated[
        int, stated("episode_limit", "an integer from 0 to 10,000"), Field(ge=0, le=10_000)
    ] = 200
    quantities: Annotated[str, words(collision.QUANTITIES), choice(collision.QUANTITIES)] = (
        ",".join(collision.QUANTITIES)
    )

    @functools.cached_property
    def parameters(self) -> CollisionParameters:
        """The collision itself."""
        return CollisionParameters(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.damping)

    @property
    def is_quick(self) -> bool:
        """Whether it is computed in some milliseconds."""
        return is_quick(self.kappa, self.parameters.psi, self.options)


class TraceQuery(CollisionQuery):
    """``GET /trace``."""

    samples: Annotated[
        int, stated("samples", "an integer from 2 to 20,000"), Field(ge=2, le=20_000)
    ] = 400
    quantities: Annotated[str, words(trace.COLUMNS), choice(trace.COLUMNS)] = ",".join(
        trace.COLUMNS
    )


BatchQuantities = Annotated[str, words(batch.QUANTITIES), choice(batch.QUANTITIES)]


class CutQuery(Formed):
    """``GET /cut``."""

    along: Annotated[Literal["gt_over_gn", "kappa"], stated("along", "gt_over_gn or kappa")]
    mu_over_alpha: MuOverAlpha
    kappa: Kappa | None = None
    gt_over_gn: GtOverGn | None = None
    minimum: Annotated[Finite, stated("minimum", "finite and ≥ 0"), Field(ge=0)] | None = None
    maximum: Annotated[Finite, stated("maximum", "finite and > 0"), Field(gt=0)] | None = None
    count: Annotated[
        int, stated("count", "an integer from 2 to 100,000"), Field(ge=2, le=100_000)
    ] = 400
    scale: Annotated[Scale, stated("scale", "linear or log")] = "linear"
    quantities: BatchQuantities = "epsilon_t,switches"

    @model_validator(mode="before")
    @classmethod
    def _fill_range(cls, given: dict[str, Any]) -> dict[str, Any]:
        """Give the ends their defaults, which depend on `along`."""
        if (along := given.get("along")) not in CUT:
            return given
        low, high = CUT[along].default
        return {"minimum": low, "maximum": high} | given

    @property
    def axis(self) -> Axis:
        """The values along the cut."""
        assert self.minimum is not None
        assert self.maximum is not None
        return Axis(self.minimum, self.maximum, self.count, self.scale)


def _edge(name: str, requirement: str) -> Any:
    return stated(name, requirement, f"{name.rsplit('_', 1)[0]} at an edge of the map")


class MapQuery(Formed):
    """``GET /map``."""

    mu_over_alpha: MuOverAlpha
    kappa_min: Annotated[Finite, _edge("kappa_min", "finite and > 0"), Field(gt=0)] = 0.1
    kappa_max: Annotated[Finite, _edge("kappa_max", "finite and > 0"), Field(gt=0)] = 70.0
    kappa_count: Annotated[int, stated("kappa_count", "an integer ≥ 2"), Field(ge=2)] = 200
    kappa_scale: Annotated[Scale, stated("kappa_scale", "linear or log")] = "linear"
    gt_over_gn_min: Annotated[Finite, _edge("gt_over_gn_min", "finite and ≥ 0"), Field(ge=0)] = 0.01
    gt_over_gn_max: Annotated[Finite, _edge("gt_over_gn_max", "finite and > 0"), Field(gt=0)] = 4.0
    gt_over_gn_count: Annotated[int, stated("gt_over_gn_count", "an integer ≥ 2"), Field(ge=2)] = (
        150
    )
    gt_over_gn_scale: Annotated[Scale, stated("gt_over_gn_scale", "linear or log")] = "linear"
    quantities: BatchQuantities = "epsilon_t,switches"

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """The edges: κ and g_t/g_n."""
        ends = ("min", "max")
        return (
            Axis(
                self.kappa_min, self.kappa_max, self.kappa_count, self.kappa_scale, "kappa_", ends
            ),
            Axis(
                self.gt_over_gn_min,
                self.gt_over_gn_max,
                self.gt_over_gn_count,
                self.gt_over_gn_scale,
                "gt_over_gn_",
                ends,
            ),
        )


class TableQuery(Closed):
    """``GET /table``; the error wanted, or else counts."""

    encoding: ClassVar = "plain"

    kappa_min: Annotated[Finite, _edge("kappa_min", "finite and > 0"), Field(gt=0)] = 0.1
    kappa_max: Annotated[Finite, _edge("kappa_max", "finite and > 0"), Field(gt=0)] = 70.0
    kappa_count: Annotated[int, stated("kappa_count", "an integer ≥ 2"), Field(ge=2)] = 200
    kappa_scale: Annotated[Scale, stated("kappa_scale", "linear or log")] = "linear"
    psi_min: Annotated[Finite, _edge("psi_min", "finite and ≥ 0"), Field(ge=0)] = 0.01
    psi_max: Annotated[Finite, _edge("psi_max", "finite and > 0"), Field(gt=0)] = 4.0
    psi_count: Annotated[int, stated("psi_count", "an integer ≥ 2"), Field(ge=2)] = 150
    psi_scale: Annotated[Scale, stated("psi_scale", "linear or log")] = "linear"
    damping: Damping = 0.0
    damping_min: Annotated[
        Finite, _edge("damping_min", f"from 0 to {MOST_DAMPING:g}"), Field(ge=0, le=MOST_DAMPING)
    ] = 0.0
    damping_max: (
        Annotated[
            Finite,
            _edge("damping_max", f"> 0, at most {MOST_DAMPING:g}"),
            Field(gt=0, le=MOST_DAMPING),
        ]
        | None
    ) = None
    damping_count: Annotated[int, stated("damping_count", "an integer ≥ 2"), Field(ge=2)] = 10
    damping_scale: Annotated[Scale, stated("damping_scale", "linear or log")] = "linear"
    error: (
        Annotated[
            Finite,
            stated("error", "from 1e-12 to 1", "largest error wanted"),
            Field(ge=1e-12, le=1),
        ]
        | None
    ) = None
    sign: Annotated[Literal["paper", "reversed"], stated("sign", "paper or reversed")] = "paper"
    format: Annotated[
        str,
        one_of(TABLE_FORMATS),
        Field(
            description=f"one of {', '.join(TABLE_FORMATS)}",
            json_schema_extra={"enum": list(TABLE_FORMATS)},
        ),
    ] = "csv"

    @model_validator(mode="before")
    @classmethod
    def _fill_scales(cls, given: dict[str, Any]) -> dict[str, Any]:
        """Give the scales their defaults, which depend on the error."""
        return table_scales(given) | given

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """The edges: κ and ψ."""
        ends = ("min", "max")
        return (
            Axis(
                self.kappa_min, self.kappa_max, self.kappa_count, self.kappa_scale, "kappa_", ends
            ),
            Axis(self.psi_min, self.psi_max, self.psi_count, self.psi_scale, "psi_", ends),
        )

    @property
    def third(self) -> Axis | float:
        """The axis of η where there is one, else the η of all entries."""
        if self.damping_max is None:
            return self.damping
        return Axis(
            self.damping_min,
            self.damping_max,
            self.damping_count,
            self.damping_scale,
            "damping_",
            ("min", "max"),
        )


SceneName = Literal["figure4", "stiff", "solids", "damped", "extremes"]
SCENE_NAMES: tuple[SceneName, ...] = get_args(SceneName)
SceneChoice = Annotated[SceneName, stated("scene", f"one of {', '.join(SCENE_NAMES)}")]


class TradeoffQuery(FormQuery):
    """``GET /tradeoff``."""

    scene: SceneChoice = "figure4"


class StepsQuery(FormQuery):
    """``GET /steps``: a collision, or else a region."""

    error: Annotated[
        Finite, stated("error", "from 1e-12 to 1", "largest error wanted"), Field(ge=1e-12, le=1)
    ] = 1e-3
    region: Annotated[SceneName, stated("region", f"one of {', '.join(SCENE_NAMES)}")] | None = None
    kappa: Kappa | None = None
    mu_over_alpha: MuOverAlpha | None = None
    gt_over_gn: GtOverGn | None = None
    damping: Damping = 0.0

    @property
    def parameters(self) -> CollisionParameters | None:
        """The collision, None for a region."""
        if self.kappa is None or self.mu_over_alpha is None or self.gt_over_gn is None:
            return None
        return CollisionParameters(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.damping)


class RunQuery(Closed):
    """``POST /tradeoff/runs``."""

    scene: SceneChoice = "figure4"


class NoQuery(Closed):
    """A call without parameters."""

    format: ClassVar = "json"
    encoding: ClassVar = "plain"


ManyQuantity = Literal["epsilon_t", "epsilon_n", "switches"]
_MANY: list[ManyQuantity] = list(get_args(ManyQuantity))
REQUIREMENTS["quantities[]"] = f"one of {', '.join(_MANY)}"


class CollisionsBody(Request):
    """``POST /collisions``, the scalar part; the parameters are arrays, see `arrays`."""

    quantities: Annotated[
        list[ManyQuantity],
        stated("quantities", f"a list, not empty, of {', '.join(_MANY)}"),
        # also keeps a list of a million words from being read to its end
        Field(min_length=1, max_length=len(_MANY)),
    ] = _MANY

    @field_validator("tolerance", "steps", "phase", "rtol", "floor", mode="before")
    @classmethod
    def _is_number(cls, value: object) -> object:
        """Refuse texts and booleans, which a query cannot tell from numbers but JSON can."""
        if isinstance(value, str | bool):
            raise PydanticCustomError("number", "not a number")
        return value
