"""From SI units to the scaled collision (Eqs. 18–24)."""

import functools
import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal

from restitution.bounds import Meaning, Misfit, Words, checked
from restitution.errors import ParameterError
from restitution.mechanics.contact import (
    MOST_DAMPING,
    contact_duration,
    damping_of,
    largest_compression,
    largest_force,
)
from restitution.mechanics.hertz import MAXIMUM_COMPRESSION
from restitution.methods.options import NormalRestitution, Options
from restitution.neighbours import naming_neighbours
from restitution.studies.collision.axis import Axis, an_axis
from restitution.studies.collision.dampings import told_twice
from restitution.studies.spheres.bodies import Body, NotNegative, Pair, Positive, pair, two_walls
from restitution.studies.spheres.impact import made_impact
from restitution.studies.spheres.powers import product_of_powers, representable

if TYPE_CHECKING:
    from restitution.studies.spheres.collision import ScalingStudy
    from restitution.studies.spheres.velocity_map import VelocityMap

DISSIPATION = Meaning("A of Eq. 1; 0 if left out")
AT_VELOCITY = Meaning("where normal_restitution holds; the velocity of the impact if left out")

SMALLEST = math.ulp(0.0)
"""Stands for positive quantities that underflow where any tiny value gives the same collision."""


@checked
class Contact:
    """Two bodies, at most one of them a wall, and the laws of their contact.

    Attributes
    ----------
    body_1, body_2 : Sphere or Wall
    friction_coefficient : float
        μ.
    tangential_stiffness_n_per_m : float or ``"mindlin"``
        k_t, or Mindlin's 8 G* a at the largest undamped compression.
    dissipative_constant_s : float or None
        A of Eq. 1; 0 if nothing is said of it.
    normal_restitution : float or None
        ε_n in its place, 0 < ε_n ≤ 1.
    at_normal_velocity_m_s : float or None
        g_n at which that holds; that of the impact if nothing is said of it.

    Raises
    ------
    ParameterError
        If a number is out of range, or both bodies are walls.

    Examples
    --------
    >>> import restitution as rs
    >>> steel, glass = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850), rs.Wall(7e10, 0.25)
    >>> round(Contact(steel, glass, 0.4, "mindlin").pair.alpha, 6)
    0.285714
    """

    body_1: Body
    body_2: Body
    friction_coefficient: NotNegative
    tangential_stiffness_n_per_m: Annotated[
        Positive | Literal["mindlin"],
        Words("finite and > 0, or mindlin"),
        Meaning("mindlin: 8G*a at the largest undamped compression"),
    ]
    dissipative_constant_s: Annotated[NotNegative, DISSIPATION] | None = None
    normal_restitution: NormalRestitution | None = None
    at_normal_velocity_m_s: Annotated[Positive, AT_VELOCITY] | None = None

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield what is wrong with the bodies beside each other, and with the damping."""
        yield from two_walls(given)
        yield from told_twice(given, "dissipative_constant_s")
        if "at_normal_velocity_m_s" in given and "normal_restitution" not in given:
            yield "at_normal_velocity_m_s", "left out: it is said of normal_restitution"

    @property
    def is_damped(self) -> bool:
        """Whether the normal motion loses energy."""
        return bool(self.dissipative_constant_s) or self.normal_restitution not in (None, 1.0)

    @functools.cached_property
    def pair(self) -> Pair:
        """What the contact inherits from its bodies."""
        return pair(self.body_1, self.body_2)

    def impact(self, *, tolerance: float = 1e-10, **how: Any) -> "ScalingStudy":
        """Return what comes out of an impact, in SI units and scaled, as ``POST /scaling``.

        Parameters
        ----------
        tolerance : float, optional
            Largest absolute error wanted in ε_t.
        **how
            Members of `Velocities`, of `SpeedAndAngle`, or of `Impact`: then there are velocities
            and spins after it.

        Returns
        -------
        ScalingStudy
            Scaled parameters, scales, durations and forces, ε_n and ε_t, warnings.

        Raises
        ------
        ParameterError
            If the bodies do not approach or a quantity is beyond double precision.

        Examples
        --------
        >>> from restitution.studies.spheres.bodies import Sphere, Wall
        >>> ball = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
        >>> floor = Contact(ball, Wall(7e10, 0.25), 0.4, "mindlin")
        >>> round(floor.impact(normal_velocity_m_s=1.0, tangential_velocity_m_s=0.5).epsilon_t, 4)
        0.5059
        """
        # it is made of contacts itself
        from restitution.studies.spheres.collision import study_scaling  # noqa: PLC0415

        return study_scaling(self, made_impact(how), Options(tolerance=tolerance))

    @naming_neighbours
    def map(
        self,
        normal_velocity_m_s: Axis,
        tangential_velocity_m_s: Axis,
        *,
        quantities: Collection[str] = ("epsilon_t", "switches"),
        tolerance: float = 1e-10,
    ) -> "VelocityMap":
        """Return collisions over both velocities in m/s, as ``POST /scaling/map``.

        Parameters
        ----------
        normal_velocity_m_s, tangential_velocity_m_s : Axis
            g_n > 0, n values, and g_t ≥ 0, k values, in m/s.
        quantities : collection of str, optional
            As of `cut`.
        tolerance : float, optional
            Largest absolute error wanted in ε_t.

        Returns
        -------
        VelocityMap
            The columns of its `batch` have shape (k n,), the normal velocity fastest.

        Raises
        ------
        ParameterError
            If a range is empty or a quantity is beyond double precision.

        Examples
        --------
        >>> from restitution.studies.spheres.bodies import Sphere
        >>> steel = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
        >>> found = Contact(steel, steel, 0.4, "mindlin").map(Axis(1, 20, 6), Axis(0, 10, 5))
        >>> found.batch.columns["epsilon_t"].shape
        (30,)
        """
        from restitution.studies.spheres.velocity_map import study_velocity_map  # noqa: PLC0415

        edges = (
            an_axis("normal_velocity_m_s", normal_velocity_m_s),
            an_axis("tangential_velocity_m_s", tangential_velocity_m_s),
        )
        return study_velocity_map(self, *edges, quantities, Options(tolerance=tolerance))


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
    damping, dissipative_constant_s : float
        η = (3/2) A β^{2/5} g_n^{1/5}, and A.
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
    dissipative_constant_s: float
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
    stiffness = held("tangential_stiffness_n_per_m", mindlin) if given == "mindlin" else given
    kappa = product_of_powers(
        (stiffness, 10), (both.alpha, -10), (mass, -10), (beta, -8), (g_n, -4)
    )
    damping, dissipation = _damped(contact, beta, g_n) if contact.is_damped else (0.0, 0.0)
    force = product_of_powers((largest_force(damping), 10), (mass, 10), (beta, 4), (g_n, 12))
    return Scales(
        pair=both,
        normal_velocity_m_s=g_n,
        beta=beta,
        time_scale_s=time,
        length_scale_m=length,
        kappa=held("kappa", kappa, f"the tangential stiffness, {EVERYTHING}"),
        damping=damping,
        dissipative_constant_s=dissipation,
        tangential_stiffness_n_per_m=stiffness,
        mindlin_stiffness_n_per_m=mindlin,
        contact_duration_s=held("contact_duration_s", contact_duration(damping) * time),
        maximum_compression_m=held("maximum_compression_m", largest_compression(damping) * length),
        maximum_normal_force_n=held("maximum_normal_force_n", force),
    )


def _damped(contact: Contact, beta: float, g_n: float) -> tuple[float, float]:
    """Return η at a normal velocity and A, which is told by ε_n or itself.

    Raises
    ------
    ParameterError
        If one of them is beyond double precision, or η beyond what is followed.
    """
    told = "dissipative_constant_s"
    dissipation = contact.dissipative_constant_s
    if contact.normal_restitution is not None:
        told = "normal_restitution"
        there = contact.at_normal_velocity_m_s or g_n
        at_velocity = damping_of(contact.normal_restitution)
        damping = product_of_powers((at_velocity, 10), (g_n, 2), (there, -2))
        dissipation = representable(
            "dissipative_constant_s",
            product_of_powers((1.5, -10), (at_velocity, 10), (beta, -4), (there, -2)),
            f"the normal restitution, {EVERYTHING}",
        )
        if there == g_n:
            damping = at_velocity
    else:
        assert dissipation is not None
        damping = product_of_powers((1.5, 10), (dissipation, 10), (beta, 4), (g_n, 2))
    damping = max(damping, SMALLEST)
    if not math.isfinite(damping):
        representable("damping", damping, f"the dissipative constant, {EVERYTHING}")
    if damping > MOST_DAMPING:
        change = "smaller" if told == "dissipative_constant_s" else "larger"
        requirement = f"{change}: with damping = {damping:.3g} the contact is not followed"
        raise ParameterError(told, getattr(contact, told), requirement)
    return damping, dissipation
