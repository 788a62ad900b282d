"""Real bodies and their impact in the body of a request."""

from dataclasses import dataclass
from typing import Any

from restitution.api.errors import refusal
from restitution.api.objects import (
    NOT_NEGATIVE,
    POSITIVE,
    ObjectReader,
    not_negative,
    positive,
    within,
)
from restitution.methods.answer import Options
from restitution.studies.axis import Axis
from restitution.studies.batch import QUANTITIES
from restitution.studies.bodies import GYRATION, Body, Sphere, Wall
from restitution.studies.impact import AT_REST, Impact
from restitution.studies.scaling import Contact
from restitution.studies.spheres import Velocities

MOST_VELOCITIES = 10_000
"""Along one edge of a map."""

LABELS = ("id", "title", "source", "notes", "measured")
"""What an item of ``/materials`` has beside a collision: such an item is a valid body."""

OF_SPHERES = ("radius_m", "density_kg_m3", "mass_kg", "inertia")
NOT_OF_A_WALL = dict.fromkeys(OF_SPHERES, "left out: a wall has infinite radius and mass")

IN_VELOCITIES = ("normal_velocity_m_s", "tangential_velocity_m_s")
IN_VECTORS = ("velocity_1_m_s", "velocity_2_m_s", "spin_1_rad_s", "spin_2_rad_s", "normal")
FORMS = f"an object with {' and '.join(IN_VELOCITIES)}, or with {', '.join(IN_VECTORS)}"


def read_scaling(body: dict[str, Any]) -> tuple[Contact, Velocities | Impact]:
    """Return the bodies and the impact that a request describes.

    Raises
    ------
    RefusedParametersError
        If anything is wrong: all of it at once.
    """
    reader = ObjectReader(body)
    contact = read_contact(reader)
    impact = _impact(reader.object("impact", FORMS))
    reader.close()
    reader.finish()
    return contact, impact


@dataclass(frozen=True)
class MapRequest:
    """What a map over velocities is to show."""

    contact: Contact
    normal_velocity: Axis
    tangential_velocity: Axis
    quantities: list[str]
    options: Options


def read_map(body: dict[str, Any]) -> MapRequest:
    """Return the bodies, both ranges of velocities and the quantities that a request describes.

    Raises
    ------
    RefusedParametersError
        If anything is wrong: all of it at once.
    """
    reader = ObjectReader(body)
    # an item of /materials has one
    reader.ignore("impact")
    request = MapRequest(
        read_contact(reader),
        _axis(reader, IN_VELOCITIES[0], 200, from_zero=False),
        _axis(reader, IN_VELOCITIES[1], 150, from_zero=True),
        reader.words("quantities", QUANTITIES, ("epsilon_t", "switches")),
        Options(tolerance=reader.number("tolerance", "from 1e-13 to 1", within(1e-13, 1.0), 1e-10)),
    )
    reader.close()
    reader.finish()
    return request


def _axis(parent: ObjectReader, name: str, count: int, *, from_zero: bool) -> Axis:
    reader = parent.object(name, "an object with min, max, count and scale")
    scale = reader.word("scale", ("linear", "log"), "linear")
    zero = from_zero and scale == "linear"
    least = reader.number(
        "min", NOT_NEGATIVE if zero else POSITIVE, not_negative if zero else positive
    )
    most = reader.number("max", POSITIVE, positive)
    if least >= most:
        reader.refuse("max", f"greater than {name}.min = {least!r}")
    number = reader.integer("count", 2, MOST_VELOCITIES, count)
    reader.close()
    return Axis(least, most, number, scale, f"{name}.", ("min", "max"))


def read_contact(reader: ObjectReader) -> Contact:
    """Return the two bodies and the laws of their contact; of no use if something was refused."""
    reader.ignore(*LABELS)
    bodies = _body(reader.object("body_1")), _body(reader.object("body_2"))
    if all(isinstance(body, Wall) for body in bodies):
        requirement = "left out: one of the two bodies has to be a sphere"
        reader.errors.append(refusal("body_2.wall", True, requirement))
    friction = reader.number("friction_coefficient", NOT_NEGATIVE, not_negative)
    stiffness = None
    if reader.members.get("tangential_stiffness_n_per_m") != "mindlin":
        stiffness = reader.number(
            "tangential_stiffness_n_per_m", f"{POSITIVE}, or mindlin", positive
        )
    reader.ignore("tangential_stiffness_n_per_m")
    dissipation = reader.number("dissipative_constant_s", NOT_NEGATIVE, not_negative, 0.0)
    return Contact(*bodies, friction, stiffness, dissipation)


def _body(reader: ObjectReader) -> Body:
    modulus = reader.number("youngs_modulus_pa", POSITIVE, positive)
    poisson = reader.number("poisson_ratio", "> -1 and ≤ 0.5", lambda nu: -1.0 < nu <= 0.5)
    yield_stress = reader.optional_number("yield_stress_pa", POSITIVE, positive)
    wall = reader.members.get("wall", False)
    if not isinstance(wall, bool):
        reader.refuse("wall", "true, or left out for a sphere")
    reader.ignore("wall")
    if wall is True:
        reader.close(NOT_OF_A_WALL)
        return Wall(modulus, poisson, yield_stress)
    radius = reader.number("radius_m", POSITIVE, positive)
    density = reader.optional_number("density_kg_m3", POSITIVE, positive)
    mass = reader.optional_number("mass_kg", POSITIVE, positive)
    if density is None and mass is None:
        reader.refuse("density_kg_m3", f"{POSITIVE}, unless mass_kg is given")
    elif density is not None and mass is not None:
        reader.refuse("mass_kg", "left out, as density_kg_m3 is given")
    inertia = _inertia(reader)
    reader.close()
    return Sphere(radius, modulus, poisson, mass, density, inertia, yield_stress)


def _inertia(reader: ObjectReader) -> Any:
    value = reader.members.get("inertia", "solid")
    reader.ignore("inertia")
    if isinstance(value, str) and value in GYRATION:
        return value
    if not isinstance(value, dict):
        reader.refuse("inertia", 'solid, hollow, or {"moment_kg_m2": …}')
        return "solid"
    moment = reader.object("inertia")
    given = moment.number("moment_kg_m2", POSITIVE, positive)
    moment.close()
    return given


def _impact(reader: ObjectReader) -> Velocities | Impact:
    if any(name in reader.members for name in IN_VECTORS):
        impact = Impact(
            reader.vector("velocity_1_m_s"),
            reader.vector("velocity_2_m_s"),
            reader.vector("normal"),
            reader.vector("spin_1_rad_s", AT_REST),
            reader.vector("spin_2_rad_s", AT_REST),
        )
        if not any(impact.normal):
            reader.refuse("normal", "of a length > 0, from body 2 to body 1")
        reader.close(dict.fromkeys(IN_VELOCITIES, "left out, as velocities are given"))
        return impact
    velocities = Velocities(
        reader.number("normal_velocity_m_s", f"{POSITIVE}: the bodies approach", positive),
        reader.number("tangential_velocity_m_s", NOT_NEGATIVE, not_negative),
    )
    reader.close()
    return velocities
