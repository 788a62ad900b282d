"""What a turning normal would change, which the model keeps fixed."""

import math
from typing import NamedTuple

import numpy as np

from restitution.methods import planner
from restitution.methods.options import Options
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.spheres.contact import Scales
from restitution.studies.spheres.impact import Crossing
from restitution.studies.spheres.powers import LEAST, product_of_powers

STRONGEST = 1e9
"""Of an impulse over m_eff g_n; from there on the bodies pass as if they did not touch."""


class Turned(NamedTuple):
    """What a collision would do otherwise if its normal turned with the centres, estimated."""

    angle: float
    """By which the normal turns during the contact, rad."""
    normal: float
    """What the velocity along the first normal after the impact loses, over g_n."""
    tangential: float
    """By which the tangential velocity of the surfaces after it differs, at most, in m/s."""


def turned(
    at: Scales,
    crossing: Crossing,
    parameters: CollisionParameters,
    tangential_velocity: float,
    epsilon_n: float,
    epsilon_t: float,
) -> Turned:
    """Return what a collision would do otherwise with a normal that turns.

    Parameters
    ----------
    at : Scales
        The contact at the normal velocity of the impact.
    crossing : Crossing
        What turns.
    parameters : CollisionParameters
        The same in scaled terms.
    tangential_velocity : float
        g_t in m/s, 0 or more.
    epsilon_n, epsilon_t : float
        Coefficients of restitution with the normal kept fixed.

    Notes
    -----
    The centres pass each other at w₀, at w in the mean over the contact. The normal turns by
    θ = w t_c/(R₁ + R₂), and seen along it w²/(R₁ + R₂) drives the bodies apart. What that takes
    from the velocity along the first normal is θw of g_n, and of the impulse of the normal force,
    for the force of friction turns too, (w₀² + w²)/2 in place of w². With these impulses a, over
    m_eff g_n, the contact is shorter by s and so are they (`_weakened`). ε_t then is that of κs²
    and of ψ over the share of the impulse that is left. To its change is added what is tangential
    of the force along the turned normal, ½(1 + ε_n) g_n θ, and what friction does about the spin
    that tilts, ½(1 − ε_t) θ of it. tests/beyond/test_turning.py says how near all this is to
    bodies that are let turn.
    """
    g_n, whole = at.normal_velocity_m_s, 1.0 + epsilon_n
    duration, distance = at.contact_duration_s, sum(at.pair.radii_m)
    if math.isinf(distance):
        return Turned(0.0, 0.0, 0.0)

    def impulse(velocity: float) -> float:
        factors = (duration, 10), (velocity, 20), (distance, -10), (g_n, -10)
        return product_of_powers(*factors) if velocity > 0.0 else 0.0

    before = math.hypot(crossing.along, crossing.across)
    slowed = 0.5 * at.pair.alpha * (epsilon_t - 1.0) * tangential_velocity
    passing = math.hypot(crossing.along + slowed, crossing.across)
    lost, share = _weakened(impulse(passing), whole)
    # with the impulse at its strongest, and no further than to the other side
    most = min(whole * g_n / max(passing, LEAST), math.pi)
    angle = min(passing / distance * duration * share, most)
    missing, share = _weakened(0.5 * (impulse(before) + impulse(passing)), whole)
    kappa, psi = parameters.kappa, parameters.psi
    # both anew: the one that was answered may be of a coarse method
    kept, weaker = planner.solve(
        np.array([kappa, max(kappa * share * share, LEAST)]),
        np.array([psi, psi / (1.0 - missing / whole)]),
        ("epsilon_t",),
        Options(damping=parameters.damping),
    ).epsilon_t.tolist()
    return Turned(
        angle,
        lost,
        abs(weaker - kept) * tangential_velocity
        + 0.5 * whole * angle * g_n
        + 0.5 * (1.0 - epsilon_t) * angle * crossing.drilling,
    )


def _weakened(impulse: float, whole: float) -> tuple[float, float]:
    """Return what an impulse is in a contact that it shortens, and the share that is left of both.

    Both over m_eff g_n, `whole` being that of the normal force, 1 + ε_n. Under a constant force
    that drives apart a Hertz contact lasts 1 − 0.127a of its time if the force is weak, and
    (1 + ε_n)/a of it if it is strong, when the bodies pass as if they did not touch.
    """
    impulse = min(impulse, STRONGEST)
    share = 1.0 / math.sqrt(1.0 + impulse / 4.0 + (impulse / whole) ** 2)
    return impulse * share, share
