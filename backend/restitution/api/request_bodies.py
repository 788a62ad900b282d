"""What the bodies of requests may say, for the description of the service.

They are read by `arrays` and `bodies`, which refuse everything that is wrong at once and by name;
what depends on several keys is said in words here. Fuzzing holds the two against each other.
"""

from typing import Annotated, Any, Literal, NotRequired

from pydantic import ConfigDict, Field, with_config
from typing_extensions import TypedDict

from restitution.api.schemas import Integrator, ManyQuantity, Method, Scale
from restitution.mechanics.viscoelastic import MOST_DAMPING
from restitution.studies.batch import QUANTITIES
from restitution.studies.materials import Measured

closed = with_config(ConfigDict(extra="forbid"))

Positive = Annotated[float, Field(gt=0)]
NotNegative = Annotated[float, Field(ge=0)]
Damping = Annotated[float, Field(ge=0, le=MOST_DAMPING)]
MAP_LENGTH = Field(min_length=1, max_length=len(QUANTITIES))
BatchQuantity = Annotated[str, Field(json_schema_extra={"enum": list(QUANTITIES)})]
Tolerance = Annotated[
    float, Field(ge=1e-13, le=1, description="largest absolute error wanted in ε_t")
]


@closed
class NumbersInBase64(TypedDict):
    """A list of numbers, little-endian."""

    dtype: Literal["f8", "f4", "i4"]
    bdata: Annotated[str, Field(description="base64")]
    shape: NotRequired[Annotated[str | int | None, Field(description="the length, if given")]]


@closed
class CollisionsBody(TypedDict):
    """Many collisions: numbers, which hold for all, and lists of one length, at most 1,000,000."""

    kappa: Positive | list[Positive] | NumbersInBase64
    mu_over_alpha: NotNegative | list[NotNegative] | NumbersInBase64
    gt_over_gn: NotNegative | list[NotNegative] | NumbersInBase64
    damping: NotRequired[Damping | list[Damping] | NumbersInBase64]
    tolerance: NotRequired[Tolerance]
    method: NotRequired[Method]
    steps: NotRequired[Annotated[int, Field(ge=4, le=1_000_000)]]
    integrator: NotRequired[Integrator]
    phase: NotRequired[Annotated[float, Field(ge=0, le=1)]]
    rtol: NotRequired[Annotated[float, Field(ge=1e-13, le=0.1)]]
    floor: NotRequired[Annotated[float, Field(ge=-1, le=1)]]
    quantities: NotRequired[Annotated[list[ManyQuantity], Field(min_length=1, max_length=3)]]


class Elastic(TypedDict):
    """What spheres and walls have in common."""

    youngs_modulus_pa: Positive
    poisson_ratio: Annotated[float, Field(gt=-1, le=0.5)]
    yield_stress_pa: NotRequired[Positive | None]


@closed
class Moment(TypedDict):
    """A moment of inertia of one's own."""

    moment_kg_m2: Positive


@closed
class Sphere(Elastic):
    """A sphere; of density_kg_m3 and mass_kg one is given."""

    wall: NotRequired[Literal[False]]
    radius_m: Positive
    density_kg_m3: NotRequired[Positive | None]
    mass_kg: NotRequired[Positive | None]
    inertia: NotRequired[Literal["solid", "hollow"] | Moment]


@closed
class Wall(Elastic):
    """A body of infinite mass and radius."""

    wall: Literal[True]


@closed
class Velocities(TypedDict):
    """An impact by the velocity at the point of contact."""

    normal_velocity_m_s: Positive
    tangential_velocity_m_s: NotNegative


Vector = Annotated[list[float], Field(min_length=3, max_length=3)]


@closed
class Motion(TypedDict):
    """An impact by the motion of both bodies; the normal points from body 2 to body 1."""

    velocity_1_m_s: Vector
    velocity_2_m_s: Vector
    normal: Annotated[Vector, Field(description="of any length > 0")]
    spin_1_rad_s: NotRequired[Vector]
    spin_2_rad_s: NotRequired[Vector]


class Contact(TypedDict):
    """Two bodies, at most one of them a wall, and the laws of their contact."""

    body_1: Sphere | Wall
    body_2: Sphere | Wall
    friction_coefficient: NotNegative
    tangential_stiffness_n_per_m: Annotated[
        Positive | Literal["mindlin"],
        Field(description="mindlin: 8G*a at the largest undamped compression"),
    ]
    dissipative_constant_s: NotRequired[NotNegative]


class Labelled(Contact):
    """A contact that may bring the other keys of an item of ``/materials``."""

    id: NotRequired[Any]
    title: NotRequired[Any]
    source: NotRequired[Any]
    notes: NotRequired[Any]
    measured: NotRequired[Any]


@closed
class ScalingBody(Labelled):
    """A collision of real bodies."""

    impact: Velocities | Motion


@closed
class VelocityRange(TypedDict):
    """The velocities along an edge of a map; min < max, on a log scale min > 0."""

    min: NotNegative
    max: Positive
    count: NotRequired[Annotated[int, Field(ge=2, le=10_000)]]
    scale: NotRequired[Scale]


@closed
class VelocityMapBody(Labelled):
    """Real bodies over both velocities; `impact` is not looked at."""

    impact: NotRequired[Any]
    normal_velocity_m_s: Annotated[VelocityRange, Field(description="min > 0")]
    tangential_velocity_m_s: VelocityRange
    quantities: NotRequired[Annotated[list[BatchQuantity], MAP_LENGTH]]
    tolerance: NotRequired[Tolerance]


class Material(Contact):
    """A body of ``/scaling`` with a name; `measured` where impacts were."""

    impact: Velocities
    id: str
    title: str
    source: str
    notes: Annotated[str, Field(description="what is not in the source")]
    measured: NotRequired[Measured]
