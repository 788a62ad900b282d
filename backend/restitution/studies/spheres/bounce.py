"""The motion of a ball before and after it bounces, off a wall or off an equal ball."""

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Le

from restitution.bounds import Meaning
from restitution.errors import ParameterError
from restitution.mechanics.motion import MASS_SHARES, impulse_shares
from restitution.mechanics.scaled_velocity import after_flight
from restitution.methods.answer import EpsilonT, ErrorBound
from restitution.quantities import QUANTITIES
from restitution.studies.collision.one import study_collision
from restitution.studies.collision.parameters import CONVENTION, CollisionParameters, Convention
from restitution.studies.spheres.bodies import GYRATION
from restitution.studies.spheres.powers import representable

Alpha = Annotated[float, Gt(0), Le(1), QUANTITIES["alpha"]]
Partner = Annotated[
    Literal["wall", "sphere"], Meaning("what it bounces off; the sphere is as the ball itself")
]
SpinShare = Annotated[float, Ge(0), Le(1), QUANTITIES["spin_share"]]

SOLID_ALPHA = 1.0 / (1.0 + 1.0 / GYRATION["solid"])

PSI_OF_MOST_SWITCHES = 0.5
"""Where a collision of any κ has about as many switches as at any ψ."""

CONVENTIONS = (
    f"{CONVENTION}; motions are those of the ball in the frame of the centre of mass, over g_n of "
    "the first collision: normal_velocity positive away from the other body, centre_velocity "
    "along g_t, spin_velocity = R omega positive as of a ball that rolls along g_t, so that "
    "centre_velocity - spin_velocity is mass_share g_t"
)


@dataclass(frozen=True)
class Bounce:
    """One collision of a ball that may bounce more than once."""

    kappa: Annotated[float, QUANTITIES["kappa"]]
    mu_over_alpha: Annotated[float, QUANTITIES["mu_over_alpha"]]
    gt_over_gn: Annotated[float, QUANTITIES["gt_over_gn"]]
    damping: Annotated[float, QUANTITIES["damping"]]
    direction: Annotated[
        Literal[-1, 0, 1], Meaning("of g_t along that of the first collision, 0 if there is none")
    ]
    epsilon_t: EpsilonT
    epsilon_n: Annotated[float, QUANTITIES["epsilon_n"]]
    error_bound: ErrorBound


@dataclass(frozen=True)
class BallMotion:
    """How a ball moves and turns between collisions, over g_n of the first one."""

    normal_velocity: Annotated[float, QUANTITIES["normal_velocity"]]
    centre_velocity: Annotated[float, QUANTITIES["centre_velocity"]]
    spin_velocity: Annotated[float, QUANTITIES["spin_velocity"]]
    angle_deg: Annotated[float, QUANTITIES["angle_deg"]]


@dataclass(frozen=True)
class BounceStudy:
    """A ball before and after it bounces.

    What leaves is linear in ε_t, by two factors of the bodies alone: the velocity of the centre
    along g_t changes by `centre_change` (1 − ε_t) g_t, Rω by `spin_change` (1 − ε_t) g_t.

    Attributes
    ----------
    alpha, spin_share : float
        α of Eq. 12; the share of g_t that the spin has.
    partner : str
        What it bounces off: ``"wall"``, or ``"sphere"`` as itself.
    mass_share, centre_change, spin_change : float
        m_eff/m of the ball, and the two factors; pure numbers.
    first, second : Bounce
        The collision, and that of a ball that falls back onto the wall; None off a sphere, and
        where its parameters are beyond double precision.
    motions : list of BallMotion
        Before, after the first, after the second collision.

    Examples
    --------
    >>> found = study_bounce(CollisionParameters(63.0, 1.4, 0.0), spin_share=0.5)
    >>> found.partner, round(7 * found.spin_change, 12), found.second.direction
    ('wall', 5.0, 0)
    """

    alpha: Alpha
    partner: Partner
    spin_share: SpinShare
    mass_share: Annotated[float, QUANTITIES["mass_share"]]
    centre_change: Annotated[float, QUANTITIES["centre_change"]]
    spin_change: Annotated[float, QUANTITIES["spin_change"]]
    first: Bounce
    second: Annotated[
        Bounce | None,
        Meaning("of a ball that falls back onto the wall; null off a sphere, which is gone"),
    ]
    motions: Annotated[
        list[BallMotion], Meaning("before, after the first, after the second collision")
    ]
    convention: Convention


def study_bounce(
    parameters: CollisionParameters,
    *,
    alpha: float = SOLID_ALPHA,
    partner: Literal["wall", "sphere"] = "wall",
    spin_share: float = 0.0,
) -> BounceStudy:
    """Return the motion of a ball before and after it bounces.

    Parameters
    ----------
    parameters : CollisionParameters
        κ, μ/α, g_t/g_n and η of the first collision.
    alpha : float
        α of Eq. 12, above 0, at most 1: the impulse of Eqs. 13 and 14 is that at the point of
        contact, so that α of a change of g_t is one of the centres and 1 − α one of the spins.
    partner : ``"wall"`` or ``"sphere"``
        A sphere is as the ball itself, and turns as it does.
    spin_share : float
        0 for a ball that comes without spin to 1 for one that comes along the normal.

    Raises
    ------
    ParameterError
        If a velocity is beyond double precision.

    Notes
    -----
    What the second collision is follows from the first one: the flight between them leaves g_t as
    it was, and it comes back with ε_n g_n. Of the digits of a change, 1 − ε_t keeps those above
    1e-16 g_t.

    Examples
    --------
    >>> before, after, _ = study_bounce(CollisionParameters(63.0, 0.0, 2.0)).motions
    >>> before.centre_velocity == after.centre_velocity, after.spin_velocity
    (True, 0.0)
    """
    share = MASS_SHARES[partner]
    centre_change, spin_change = impulse_shares(alpha, share)
    velocity = parameters.gt_over_gn
    first = _bounce(parameters, 1 if velocity > 0.0 else 0)
    second = _next(first) if partner == "wall" else None
    motions = [
        _motion(-share, (1.0 - spin_share) * share * velocity, 0.0 - spin_share * share * velocity)
    ]
    approach = 1.0
    for bounce in filter(None, (first, second)):
        before, lost = motions[-1], 1.0 - bounce.epsilon_t
        approach *= bounce.epsilon_n
        motions.append(
            _motion(
                approach * share,
                before.centre_velocity + centre_change * lost * velocity,
                before.spin_velocity + spin_change * lost * velocity,
            )
        )
        velocity *= bounce.epsilon_t
    return BounceStudy(
        alpha=alpha,
        partner=partner,
        spin_share=spin_share,
        mass_share=share,
        centre_change=centre_change,
        spin_change=spin_change,
        first=first,
        second=second,
        motions=motions,
        convention=CONVENTIONS,
    )


def _motion(normal: float, centre: float, spin: float) -> BallMotion:
    for name, value in (("centre_velocity", centre), ("spin_velocity", spin)):
        if not math.isfinite(value):
            requirement = "within 1.7e308; it follows from gt_over_gn: bring this nearer to 1"
            raise ParameterError(name, value, requirement)
    return BallMotion(normal, centre, spin, math.degrees(math.atan2(centre, abs(normal))))


def _bounce(parameters: CollisionParameters, direction: Literal[-1, 0, 1]) -> Bounce:
    found = study_collision(parameters, quantities=("epsilon_t", "epsilon_n"))
    return Bounce(
        parameters.kappa,
        parameters.mu_over_alpha,
        parameters.gt_over_gn,
        parameters.damping,
        direction,
        found.epsilon_t,
        found.epsilon_n,
        found.error_bound,
    )


def _next(first: Bounce) -> Bounce | None:
    """Return the collision after a flight; None where a parameter is beyond double precision."""
    direction = first.direction if first.epsilon_t > 0.0 else -first.direction
    scaled = after_flight(
        first.kappa, first.gt_over_gn, first.damping, first.epsilon_n, first.epsilon_t
    )
    try:
        kappa, tangential, damping = (
            value if first.epsilon_n == 1.0 or value == 0.0 else representable(name, value, "ε_n")
            for name, value in zip(("kappa", "gt_over_gn", "damping"), scaled, strict=True)
        )
        parameters = CollisionParameters(kappa, first.mu_over_alpha, tangential, damping)
    except ParameterError:
        return None
    return _bounce(parameters, direction if parameters.gt_over_gn > 0.0 else 0)
