"""What an answer says, for the description of the service: nothing is checked by it at run time.

Answers are bytes made from arrays (`formats`); tests hold them against these descriptions. A key
that an answer may lack is `NotRequired`, a number that may not exist is null.
"""

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Literal, NotRequired, get_type_hints

from pydantic import Field
from typing_extensions import TypedDict

from restitution.bounds import TypeAliasType, annotations
from restitution.methods.answer import AnsweringMethod
from restitution.methods.options import NormalRestitution, OneMethod, Options
from restitution.paper import Correction, Item
from restitution.quantities import QUANTITIES
from restitution.studies.accuracy.scenes import SceneName
from restitution.studies.accuracy.steps import Needed, Spread
from restitution.studies.accuracy.tradeoff import Measurement, Row, WantedError
from restitution.studies.collision.one import CollisionStudy
from restitution.studies.collision.parameters import CollisionParameters, Convention
from restitution.studies.collision.presets import Preset
from restitution.studies.spheres import materials
from restitution.studies.spheres.bodies import NotNegative, Positive
from restitution.studies.spheres.collision import ScalingStudy
from restitution.studies.spheres.contact import DISSIPATION, Contact

MixedMethod = TypeAliasType("MixedMethod", Literal[OneMethod, "mixed"])


class TypedArray(TypedDict):
    """An array as Plotly takes it, with `encoding=base64`; NaN where a list has null."""

    dtype: Literal["f8", "i4", "i1"]
    shape: Annotated[str, Field(pattern=r"^\d+(,\d+)*$")]
    bdata: Annotated[str, Field(description="little-endian, base64")]


Numbers = list[float] | TypedArray
SomeNumbers = list[float | None] | TypedArray
Counts = list[int | None] | TypedArray
Grid = list[list[float]] | TypedArray
SomeGrid = list[list[float | None]] | TypedArray
CountGrid = list[list[int | None]] | TypedArray


def _described(name: str, text: str, *members: Mapping[str, Any]) -> Any:
    """Return the description of an answer whose members are those of several classes."""
    joined = dict(itertools.chain(*(each.items() for each in members)))
    # no class statement joins members of dataclasses and dictionaries
    described = TypedDict(name, joined)  # type: ignore[misc]
    described.__doc__ = text
    return described


class Understood(TypedDict):
    """What is not given, but follows."""

    psi: Annotated[float | None, Field(description="(α/μ)(g_t/g_n), null where it is infinite")]
    samples: NotRequired[int]


Parameters = _described(
    "Parameters",
    """The parameters as understood, defaults filled in.""",
    annotations(CollisionParameters),
    annotations(Options),
    get_type_hints(Understood, include_extras=True),
)


@dataclass(frozen=True)
class Collision(CollisionStudy):
    """One collision; null where the method that answered cannot give a quantity."""

    parameters: Parameters  # type: ignore[valid-type] # with the options of the request


class Columns(TypedDict):
    """What a trace has besides: the columns asked for and the instants of its switches."""

    time: NotRequired[Numbers]
    compression: NotRequired[Numbers]
    compression_rate: NotRequired[Numbers]
    normal_force: NotRequired[Numbers]
    tangential_force_over_mu: NotRequired[Numbers]
    tangential_velocity: NotRequired[SomeNumbers]
    spring_elongation: NotRequired[SomeNumbers]
    regime: NotRequired[list[Literal[-1, 0, 1]] | TypedArray]
    tangential_energy: NotRequired[SomeNumbers]
    switch_times: Numbers
    method_time: NotRequired[Numbers]
    method_tangential_force_over_mu: NotRequired[SomeNumbers]
    method_tangential_velocity: NotRequired[SomeNumbers]


Trace = _described(
    "Trace",
    """A collision over time: `samples` + `switches` instants, in the columns asked for.

    Scaled units. `method_…` only with `method=timestep`: its own course, at its own instants.
    """,
    annotations(Collision),
    get_type_hints(Columns, include_extras=True),
)


class ManyCollisions(TypedDict):
    """What holds for all collisions of a cut or map."""

    method: Annotated[MixedMethod, Field(description="the one that answered, or mixed")]
    error_bound: Annotated[float, Field(ge=0, description="the largest, on ε_t")]
    tolerance_met: Annotated[bool, Field(description="by all of them")]


class FoundDamping(TypedDict):
    """What all collisions have in common where `normal_restitution` was given."""

    damping: NotRequired[Annotated[float, QUANTITIES["damping"]]]
    epsilon_n: NotRequired[Annotated[float, QUANTITIES["epsilon_n"]]]


class Cut(ManyCollisions, FoundDamping):
    """Quantities asked for along one parameter."""

    along: Literal["gt_over_gn", "kappa"]
    values: Numbers
    epsilon_t: NotRequired[Numbers]
    switches: NotRequired[Counts]
    coulomb: NotRequired[Numbers]
    stiff_bound: NotRequired[SomeNumbers]
    stiff_asymptote: NotRequired[SomeNumbers]
    largest_switches: NotRequired[SomeNumbers]
    error: NotRequired[SomeNumbers]


class MapColumns(ManyCollisions):
    """Quantities asked for over two parameters, the first index that of the second one."""

    epsilon_t: NotRequired[Grid]
    switches: NotRequired[CountGrid]
    coulomb: NotRequired[Grid]
    stiff_bound: NotRequired[SomeGrid]
    stiff_asymptote: NotRequired[SomeGrid]
    largest_switches: NotRequired[SomeGrid]
    error: NotRequired[SomeGrid]


class Map(MapColumns, FoundDamping):
    """Quantities asked for over κ and g_t/g_n, indexed [gt_over_gn][kappa]."""

    kappa: Numbers
    gt_over_gn: Numbers


class VelocityMap(MapColumns):
    """Quantities asked for over both velocities, indexed [tangential][normal]."""

    normal_velocity_m_s: Numbers
    tangential_velocity_m_s: Numbers
    mu_over_alpha: float
    kappa: Numbers
    damping: Numbers
    time_scale_s: Numbers
    length_scale_m: Numbers
    contact_duration_s: Numbers
    maximum_compression_m: Numbers
    convention: Convention


class Collisions(TypedDict):
    """Many collisions in the order of the request."""

    epsilon_t: NotRequired[Numbers]
    epsilon_n: NotRequired[Numbers]
    switches: NotRequired[Counts]
    damping: NotRequired[
        Annotated[Numbers, Field(description="as found, where normal_restitution was given")]
    ]
    method: list[AnsweringMethod]
    error_bound: Numbers
    tolerance_met: list[bool]


Vector = Annotated[list[float], Field(min_length=3, max_length=3)]


class After(TypedDict):
    """Motion of both bodies after the collision."""

    velocity_1_m_s: Vector
    velocity_2_m_s: Vector
    spin_1_rad_s: Vector
    spin_2_rad_s: Vector


@dataclass(frozen=True)
class Scaling(ScalingStudy):
    """A collision of real bodies."""

    after: Annotated[  # type: ignore[assignment] # a tuple in Python
        After | None, Field(description="null if the impact was given by g_n and g_t")
    ]


class Presets(TypedDict):
    """Collisions worth a look."""

    items: list[Preset]


class Paper(TypedDict):
    """The paper, statement by statement."""

    items: list[Item]
    corrections: Annotated[
        list[Correction], Field(description="distinct points on which statements are corrected")
    ]
    definitions: Annotated[
        list[str], Field(description="`id` of statements that define, so that they cannot fail")
    ]


Material = _described(
    "Material",
    "A body of ``/scaling`` with a name; `measured` where impacts were.",
    {name: kind for name, kind in annotations(materials.Material).items() if name != "contact"},
    annotations(Contact),
    {
        "dissipative_constant_s": Annotated[NotNegative, DISSIPATION],
        "normal_restitution": NotRequired[NormalRestitution],
        "at_normal_velocity_m_s": NotRequired[Positive],
        "measured": NotRequired[materials.Measured],
    },
)


class Materials(TypedDict):
    """Real bodies worth a look."""

    items: list[Material]  # type: ignore[valid-type]


class Tradeoff(TypedDict):
    """What was measured on a scene, when and on which machine."""

    scene: SceneName
    measured_at: str
    machine: str
    model_version: str
    steps: list[WantedError]
    rows: list[Row]
    can_be_measured_anew: bool


class StepsParameters(TypedDict):
    """The parameters as understood."""

    error: float
    region: SceneName | None
    kappa: float | None
    mu_over_alpha: float | None
    gt_over_gn: float | None
    damping: float | None
    psi: float | None


class Rule(TypedDict):
    """Errors by the rule N = factor √κ; null, with a reason, where it asks for too many steps."""

    factor: float
    steps_min: float
    steps_max: float
    reason: str | None
    velocity_verlet: Spread
    symplectic_euler: Spread
    forward_euler: Spread


class Steps(TypedDict):
    """The steps per contact that an error takes, and the ladder by which they were found."""

    parameters: StepsParameters
    collisions: int
    phases: int
    stability_limit: float
    needed: dict[str, Needed]
    rule: Rule
    integrator: list[str]
    steps: list[int] | TypedArray
    error_median: Numbers
    error_p95: Numbers
    error_max: Numbers


class Run(TypedDict):
    """A measurement under way or over."""

    id: str
    scene: SceneName
    state: Literal["running", "done", "cancelled", "failed"]
    progress: Annotated[float, Field(ge=0, le=1)]
    result: Measurement | None


class Health(TypedDict):
    """The process answers."""

    status: Literal["ok"]


class Readiness(TypedDict):
    """The kernels are compiled."""

    status: Literal["ready"]


class Refusal(TypedDict):
    """A wrong parameter."""

    parameter: Annotated[str, Field(description="`kappa[17]` for an element of a list")]
    value: Annotated[
        Any, Field(description="as received; NaN and Infinity as text, null if missing")
    ]
    requirement: Annotated[str, Field(description="what holds for allowed values")]


class Problem(TypedDict):
    """A refusal, RFC 9457."""

    type: str
    title: str
    status: Annotated[int, Field(ge=400, le=599)]
    detail: Annotated[str, Field(description="one or more sentences, to be shown as they are")]
    errors: NotRequired[
        Annotated[list[Refusal], Field(description="everything that is wrong, at once")]
    ]
