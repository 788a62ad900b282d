"""From SI units to the scaled collision (Eqs. 18–24)."""

import functools
import math
from dataclasses import dataclass

from restitution.errors import ParameterError
from restitution.mechanics.hertz import MAXIMUM_COMPRESSION
from restitution.mechanics.viscoelastic import (
    MOST_DAMPING,
    contact_duration,
    largest_compression,
    largest_force,
)
from restitution.studies.bodies import Body, Pair, pair
from restitution.studies.powers import product_of_powers, representable

SMALLEST = math.ulp(0.0)
"""Stands for positive quantities that underflow where any tiny value gives the same collision."""


@dataclass(frozen=True)
class Contact:
    """Two bodies and the laws of their contact.

    Attributes
    ----------
    body_1, body_2 : Sphere or Wall
        At most one of them a wall.
    friction_coefficient : float
        μ, 0 or more.
    tangential_stiffness_n_per_m : float or None
        k_t, positive; None for Mindlin's 8 G* a at the largest undamped compression.
    dissipative_constant_s : float
        A of Eq. 1, 0 or more.
    """

    body_1: Body
    body_2: Body
    friction_coefficient: float
    tangential_stiffness_n_per_m: float | None
    dissipative_constant_s: float = 0.0

    @functools.cached_property
    def pair(self) -> Pair:
        """What the contact inherits from its bodies."""
        return pair(self.body_1, self.body_2)


@dataclass(frozen=True)
class Scales:
    """A contact at one normal velocity, in scaled terms and in SI units.

    Attributes
    ----------
    pair : Pair
        What the contact inherits from its bodies.
    normal_velocity_m_s : float
        g_n.
    beta : float
        β of Eq. 18, (4/3) E* √R_eff / m_eff for unequal materials, in m^{-1/2} s^{-2}.
    time_scale_s, length_scale_m : float
        Eq. 21.
    kappa : float
        Eq. 24, with α in it.
    damping : float
        η = (3/2) A β^{2/5} g_n^{1/5}.
    tangential_stiffness_n_per_m, mindlin_stiffness_n_per_m : float
        k_t as used, and 8 G* a at the largest undamped compression.
    contact_duration_s, maximum_compression_m, maximum_normal_force_n : float
        Eqs. 19 and 20 with their factors, of the damped contact where there is damping.
    """

    pair: Pair
    normal_velocity_m_s: float
    beta: float
    time_scale_s: float
    length_scale_m: float
    kappa: float
    damping: float
    tangential_stiffness_n_per_m: float
    mindlin_stiffness_n_per_m: float
    contact_duration_s: float
    maximum_compression_m: float
    maximum_normal_force_n: float


EVERYTHING = "masses, radii, Young's moduli and the normal velocity"


def friction_over_alpha(friction_coefficient: float, alpha: float) -> float:
    """Return μ/α, 0 or a number that double precision holds.

    Raises
    ------
    ParameterError
        If it overflows.
    """
    ratio = friction_coefficient / alpha
    if ratio == 0.0 or math.isfinite(ratio):
        return ratio
    return representable("mu_over_alpha", ratio, "the friction coefficient and alpha")


def velocity_ratio(tangential_velocity: float, normal_velocity: float) -> float:
    """Return g_t/g_n, 0 for g_t = 0 only.

    Raises
    ------
    ParameterError
        If it overflows.
    """
    ratio = tangential_velocity / normal_velocity
    if not math.isfinite(ratio):
        return representable("gt_over_gn", ratio, "both velocities")
    # a positive quotient that underflows has the ε_t of the smallest double
    return max(ratio, SMALLEST) if tangential_velocity > 0.0 else 0.0


def scales(contact: Contact, normal_velocity: float) -> Scales:
    """Return a contact at a normal velocity in m/s, positive, in scaled terms.

    Raises
    ------
    ParameterError
        If both bodies are walls, or a quantity is beyond double precision.
    """
    both = contact.pair
    mass, radius = both.effective_mass_kg, both.effective_radius_m
    g_n = normal_velocity

    def held(name: str, value: float, change: str = EVERYTHING) -> float:
        return representable(name, value, change)

    beta = held(
        "beta",
        product_of_powers(
            (4.0 / 3.0, 10), (both.effective_modulus_pa, 10), (radius, 5), (mass, -10)
        ),
        "masses, radii and Young's moduli",
    )
    length = held("length_scale_m", product_of_powers((g_n, 8), (beta, -4)))
    time = held("time_scale_s", product_of_powers((g_n, -2), (beta, -4)))
    undamped = held("maximum_compression_m", MAXIMUM_COMPRESSION * length)
    mindlin = product_of_powers(
        (8.0, 10), (both.effective_shear_modulus_pa, 10), (radius, 5), (undamped, 5)
    )
    given = contact.tangential_stiffness_n_per_m
    stiffness = held("tangential_stiffness_n_per_m", mindlin) if given is None else given
    kappa = product_of_powers(
        (stiffness, 10), (both.alpha, -10), (mass, -10), (beta, -8), (g_n, -4)
    )
    damping = 0.0
    if contact.dissipative_constant_s > 0.0:
        product = product_of_powers(
            (1.5, 10), (contact.dissipative_constant_s, 10), (beta, 4), (g_n, 2)
        )
        damping = max(product, SMALLEST)
        if not math.isfinite(damping):
            held("damping", damping, f"the dissipative constant, {EVERYTHING}")
        if damping > MOST_DAMPING:
            requirement = f"smaller: with damping = {damping:.3g} the contact is not followed"
            raise ParameterError(
                "dissipative_constant_s", contact.dissipative_constant_s, requirement
            )
    force = product_of_powers((largest_force(damping), 10), (mass, 10), (beta, 4), (g_n, 12))
    return Scales(
        pair=both,
        normal_velocity_m_s=g_n,
        beta=beta,
        time_scale_s=time,
        length_scale_m=length,
        kappa=held("kappa", kappa, f"the tangential stiffness, {EVERYTHING}"),
        damping=damping,
        tangential_stiffness_n_per_m=stiffness,
        mindlin_stiffness_n_per_m=mindlin,
        contact_duration_s=held("contact_duration_s", contact_duration(damping) * time),
        maximum_compression_m=held("maximum_compression_m", largest_compression(damping) * length),
        maximum_normal_force_n=held("maximum_normal_force_n", force),
    )
