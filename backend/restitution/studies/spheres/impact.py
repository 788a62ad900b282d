"""Velocities and spins of two bodies before and after they collide (Eqs. 4–7)."""

import math
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, NamedTuple

import numpy as np
from annotated_types import Ge, Gt, Lt

from restitution.bounds import Choice, Meaning, Misfit, Words, annotations, checked, misfits
from restitution.errors import ParameterError, UnknownParameterError
from restitution.mechanics.hertz import FloatArray
from restitution.studies.collision.parameters import SIGN_IS_NOTHING
from restitution.studies.spheres.bodies import NotNegative, Pair, Positive
from restitution.studies.spheres.powers import representable

Vector = tuple[float, float, float]

AT_REST: Vector = (0.0, 0.0, 0.0)


@checked
class Velocities:
    """An impact by the velocity at the point of contact: g_n and g_t in m/s.

    Examples
    --------
    >>> Velocities(1.0, 0.5).tangential_velocity_m_s
    0.5
    """

    normal_velocity_m_s: Annotated[float, Gt(0), Words("finite and > 0: the bodies approach")]
    tangential_velocity_m_s: Annotated[NotNegative, SIGN_IS_NOTHING]


@checked
class SpeedAndAngle:
    """An impact by speed and angle at the point of contact, without spin those of the centre.

    Attributes
    ----------
    speed_m_s : float
        √(g_n² + g_t²) in m/s.
    angle_deg : float
        That of the velocity to the normal, so that tan of it is g_t/g_n.

    Examples
    --------
    >>> round(SpeedAndAngle(speed_m_s=3.9, angle_deg=30.0).velocities.tangential_velocity_m_s, 12)
    1.95
    """

    speed_m_s: Annotated[Positive, Words("finite and > 0: the bodies approach")]
    angle_deg: Annotated[
        float,
        Ge(0),
        Lt(90),
        Words("≥ 0 and < 90, from the normal: ε_t does not depend on the sign"),
    ]

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield what tells the velocity a second time."""
        for name in annotations(Velocities):
            if name in given:
                yield name, "left out, as speed_m_s and angle_deg tell it"

    @property
    def velocities(self) -> Velocities:
        """The same by g_n and g_t.

        Raises
        ------
        ParameterError
            If g_n is beyond double precision.
        """
        # near 90° by what is left to it, so that g_n keeps its digits
        normal = self.speed_m_s * math.sin(math.radians(90.0 - self.angle_deg))
        tangential = self.speed_m_s * math.sin(math.radians(self.angle_deg))
        return Velocities(
            representable("normal_velocity_m_s", normal, "speed and angle"), tangential
        )


@checked
class Impact:
    """Motion of both bodies before a collision: velocities of the centres, and spins.

    `normal` points from body 2 to body 1 (Eq. 1).

    Examples
    --------
    >>> Impact((0.5, 0, -1), (0, 0, 0), normal=(0, 0, 1)).spin_1_rad_s
    (0.0, 0.0, 0.0)
    """

    velocity_1_m_s: Vector
    velocity_2_m_s: Vector
    normal: Annotated[Vector, Meaning("of any length > 0")]
    spin_1_rad_s: Vector = AT_REST
    spin_2_rad_s: Vector = AT_REST

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield that there is no normal, or two impacts in one."""
        if given.get("normal") in ([0, 0, 0], (0, 0, 0)):
            yield "normal", "of a length > 0, from body 2 to body 1"
        for name in (*annotations(Velocities), *annotations(SpeedAndAngle)):
            if name in given:
                yield name, "left out, as velocities are given"


TOLD_BY = Impact, SpeedAndAngle, Velocities


def kind_of_impact(given: Mapping[str, Any]) -> type:
    """Return the class that an impact is told by."""
    return next((kind for kind in TOLD_BY if annotations(kind).keys() & given.keys()), Velocities)


def made_impact(members: Mapping[str, Any]) -> "Velocities | SpeedAndAngle | Impact":
    """Return the impact that some members tell."""
    kind = kind_of_impact(members)
    others = {name: value for name, value in members.items() if name not in annotations(kind)}
    for name, words in misfits(kind, others):
        raise ParameterError(name, others[name], words)
    try:
        made: Velocities | SpeedAndAngle | Impact = kind(**members)
    except UnknownParameterError:
        raise
    except TypeError as error:
        names = ", ".join(annotations(kind))
        raise ParameterError("impact", sorted(members), f"told by {names}") from error
    return made


AnyImpact = Annotated[
    Velocities | SpeedAndAngle | Impact,
    Choice(kind_of_impact),
    Words(
        "an object with normal_velocity_m_s and tangential_velocity_m_s, with speed_m_s and "
        "angle_deg, or with velocity_1_m_s, velocity_2_m_s, spin_1_rad_s, spin_2_rad_s, normal"
    ),
]


class Crossing(NamedTuple):
    """Motion before an impact that turns the normal, or that a turned normal changes; in m/s."""

    along: float
    """Tangential velocity of the centres along e_t."""
    across: float
    """The same across e_t, 0 or more."""
    drilling: float
    """|(R₁Ω₁ + R₂Ω₂)·n|, which a turned normal makes tangential."""


class Approach(NamedTuple):
    """The velocity of the surfaces at the point of contact before the collision.

    Vectors are in units of 2^`exponent` m/s, in which the largest component is about 1.
    """

    exponent: int
    unit_normal: FloatArray
    normal_velocity: float
    """g_n in m/s, positive."""
    tangential: FloatArray
    """g_t e_t (Eq. 6)."""
    tangential_velocity: float
    """g_t in m/s, 0 or more."""
    crossing: Crossing
    """What turns the normal."""


class After(NamedTuple):
    """Motion after a collision, in m/s and rad/s."""

    velocity_1_m_s: Vector
    velocity_2_m_s: Vector
    spin_1_rad_s: Vector
    spin_2_rad_s: Vector


def _length(vector: FloatArray) -> float:
    return math.hypot(*vector.tolist())


def _scaled_to_one(vector: FloatArray) -> FloatArray:
    """Return `vector` over the power of two that brings its largest component to ½ … 1."""
    _, exponent = math.frexp(float(np.abs(vector).max()))
    return np.ldexp(vector, -exponent)


def _surface_velocities(impact: Impact, both: Pair) -> tuple[FloatArray, FloatArray]:
    """Return R ω of either body in m/s; 0 for a wall."""
    found = []
    for i, spin in enumerate((impact.spin_1_rad_s, impact.spin_2_rad_s), 1):
        turning = np.array(spin)
        if math.isinf(both.radii_m[i - 1]):
            if np.any(turning):
                raise ParameterError(
                    f"impact.spin_{i}_rad_s",
                    list(spin),
                    "0 or left out: a wall does not turn; put ω × r into its velocity",
                )
            found.append(turning)
            continue
        speeds = both.radii_m[i - 1] * turning
        if not np.all(np.isfinite(speeds)):
            name = f"impact.spin_{i}_rad_s"
            raise ParameterError(name, list(spin), "smaller: the surface moves beyond 1.8e308 m/s")
        found.append(speeds)
    return found[0], found[1]


def contact_velocity(impact: Impact, both: Pair) -> Approach:
    """Return the velocity of the surfaces at the point of contact.

    g = v₁ − v₂ − (R₁Ω₁ + R₂Ω₂) × n, g_n = −g·n, g_t e_t = (n × g) × n (Eqs. 4–6).

    Raises
    ------
    ParameterError
        If the bodies do not approach, or a velocity is beyond double precision.
    """
    with np.errstate(all="ignore"):
        normal = _scaled_to_one(np.array(impact.normal))
        normal /= _length(normal)
        turning = _surface_velocities(impact, both)
        vectors = np.array([impact.velocity_1_m_s, impact.velocity_2_m_s, *turning])
        # in a unit in which the largest is 1/8: no sum of them overflows, no small one is lost
        exponent = math.frexp(float(np.abs(vectors).max()))[1] + 3
        velocity_1, velocity_2, turning_1, turning_2 = np.ldexp(vectors, -exponent)
        centres = velocity_1 - velocity_2
        approach = -float(centres @ normal)
        if not approach > 0.0:
            raise ParameterError(
                "impact.velocity_1_m_s",
                list(impact.velocity_1_m_s),
                "such that the bodies approach, (velocity_1 − velocity_2)·normal < 0, "
                "with the normal from body 2 to body 1",
            )
        surfaces = centres - np.cross(turning_1 + turning_2, normal)
        tangential = np.cross(np.cross(normal, surfaces), normal)
        length = _length(tangential)
        direction = tangential / length if length > 0.0 else tangential
        passing = np.cross(np.cross(normal, centres), normal)
        along = float(passing @ direction)
        across = _length(passing - along * direction)
        drilling = abs(float((turning_1 + turning_2) @ normal))
        g_n, g_t, *turning_it = (
            float(np.ldexp(v, exponent)) for v in (approach, length, along, across, drilling)
        )
    change = "the velocities and spins"
    if g_t > 0.0:
        representable("tangential_velocity_m_s", g_t, change)
    return Approach(
        exponent,
        normal,
        representable("normal_velocity_m_s", g_n, change),
        tangential,
        g_t,
        Crossing(*turning_it),
    )


def after_impact(
    impact: Impact, both: Pair, approach: Approach, epsilon_n: float, epsilon_t: float
) -> After:
    """Return the motion after a collision with these coefficients of restitution.

    The bodies exchange the impulse m_eff[(1 + ε_n) g_n n − α(1 − ε_t) g_t e_t] (Eqs. 13, 14) at
    the point of contact, so that momentum and angular momentum are conserved.

    Raises
    ------
    ParameterError
        If a spin is beyond double precision.
    """
    with np.errstate(all="ignore"):
        g_n = np.ldexp(approach.normal_velocity, -approach.exponent)
        braking = -both.alpha * (1.0 - epsilon_t) * approach.tangential
        impulse = (1.0 + epsilon_n) * g_n * approach.unit_normal + braking
        twist = np.cross(approach.unit_normal, braking)
        first, second = both.mass_shares
        turn_1, turn_2 = both.turning_shares_per_m
        motion = (
            _changed(impact.velocity_1_m_s, first * impulse, approach.exponent),
            _changed(impact.velocity_2_m_s, -second * impulse, approach.exponent),
            _changed(impact.spin_1_rad_s, -turn_1 * twist, approach.exponent),
            _changed(impact.spin_2_rad_s, -turn_2 * twist, approach.exponent),
        )
    for name, vector in zip(After._fields, motion, strict=True):
        if not all(map(math.isfinite, vector)):
            requirement = "within 1.7e308; it follows from velocities, radii and moments of inertia"
            raise ParameterError(f"after.{name}", list(vector), requirement)
    return After(*motion)


def _changed(before: Vector, change: FloatArray, exponent: int) -> Vector:
    x, y, z = (np.array(before) + np.ldexp(change, exponent)).tolist()
    return x, y, z
