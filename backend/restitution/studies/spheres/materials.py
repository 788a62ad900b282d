"""Contacts of real bodies worth a look, and what was measured of them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated

from restitution.bounds import Meaning
from restitution.studies.collision.presets import PAPER, SOLID
from restitution.studies.spheres.bodies import Sphere, Wall
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Velocities

KHARAZ = (
    "A. H. Kharaz, D. A. Gorham, A. D. Salman, Powder Technol. 120, 281 (2001), "
    "doi:10.1016/S0032-5910(01)00283-2"
)
FOERSTER = (
    "S. F. Foerster, M. Y. Louge, H. Chang, K. Allia, Phys. Fluids 6, 1108 (1994), "
    "doi:10.1063/1.868282"
)

KHARAZ_SPEED = 3.9
"""Of the centre before the impact, m/s."""

KHARAZ_CENTRE_RATIOS = (
    (1.84, 0.79344),
    (3.703, 0.74533),
    (9.496, 0.67257),
    (20.012, 0.59691),
    (30.127, 0.68756),
    (39.382, 0.77148),
    (49.694, 0.84761),
    (60.02, 0.90142),
)
"""Angle from the normal in degrees, and the tangential velocity of the centre after over before
the impact, as digitised from the paper's figures for the examples of Lethe (chaos-polymtl/lethe),
whose spins of other impacts bear out that this is the ratio of the centre: 5(1 − e_c)v_t/2R,
between these angles, agrees with them within 6 % from 11° to 50° (14 % at 60°)."""

MEASURED_CONVENTION = (
    "centre_ratio e_c is the tangential velocity of the centre after over before the impact, "
    "without spin before; epsilon_t = 1 - (1 - e_c)/alpha at the point of contact, alpha = 2/7"
)


@dataclass(frozen=True)
class MeasuredImpact:
    """One measured impact; `epsilon_t` follows from the centre ratio."""

    angle_deg: float
    normal_velocity_m_s: float
    tangential_velocity_m_s: float
    centre_ratio: float
    epsilon_t: float


@dataclass(frozen=True)
class Measured:
    """Measured impacts and the convention of their numbers."""

    convention: str
    points: tuple[MeasuredImpact, ...]


@dataclass(frozen=True)
class Material:
    """A contact of two bodies with a name, an impact to begin with, and what was measured of it.

    Attributes
    ----------
    id, title : str
        Its name in `MATERIALS` and for people.
    contact : Contact
        The two bodies and the laws of their contact.
    impact : Velocities
        That to begin with.
    source, notes : str
        Where the numbers are from, and what is not from there.
    measured : Measured or None
        `points`, the impacts that were measured, and the `convention` of their numbers.

    Examples
    --------
    >>> steel = MATERIALS["steel"]
    >>> found = steel.contact.impact(normal_velocity_m_s=20.0, tangential_velocity_m_s=5.0)
    >>> round(found.mu_over_alpha, 6)
    1.4
    """

    id: str
    title: str
    contact: Contact
    impact: Velocities
    source: str
    notes: Annotated[str, Meaning("what is not in the source")]
    measured: Measured | None = None


def surface_restitution(centre_ratio: float, alpha: float) -> float:
    """Return ε_t = 1 − (1 − e_c)/α of a sphere without spin that met a wall.

    The impulse that takes (1 − e_c) of the centre's tangential velocity takes 1/α times as much of
    the surface's (Eq. 11).
    """
    return 1.0 - (1.0 - centre_ratio) / alpha


def _kharaz_point(angle_deg: float, centre_ratio: float) -> MeasuredImpact:
    angle = math.radians(angle_deg)
    return MeasuredImpact(
        angle_deg,
        KHARAZ_SPEED * math.cos(angle),
        KHARAZ_SPEED * math.sin(angle),
        centre_ratio,
        surface_restitution(centre_ratio, SOLID),
    )


_STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
_GLASS = Sphere(0.0015, 7e10, 0.22, density_kg_m3=2500.0)
_ACETATE = Sphere(0.003, 3e9, 0.3, density_kg_m3=1300.0)

_KHARAZ_POINTS = tuple(_kharaz_point(*point) for point in KHARAZ_CENTRE_RATIOS)

_ALL = (
    Material(
        "steel",
        "Steel spheres of Fig. 2",
        Contact(_STEEL, _STEEL, 0.4, 1e12, 0.0),
        Velocities(20.0, 5.0),
        f"{PAPER}: caption of Fig. 2",
        "the impact is ours, within the range of the figure; k_t is that of the caption, 2,500 to "
        "8,000 times Mindlin's at 20 to 1 m/s",
    ),
    Material(
        "steel-mindlin",
        "The same steel, Mindlin's stiffness",
        Contact(_STEEL, _STEEL, 0.4, "mindlin", 0.0),
        Velocities(1.0, 0.5),
        f"{PAPER}: caption of Fig. 2; R. D. Mindlin, J. Appl. Mech. 16, 259 (1949)",
        "the stiffness is not the paper's, and the impact is ours: at its 20 m/s steel flows",
    ),
    Material(
        "alumina-on-glass",
        "Alumina on glass",
        Contact(
            Sphere(0.0025, 3.8e11, 0.23, density_kg_m3=4000.0),
            Wall(7e10, 0.25),
            0.092,
            "mindlin",
            0.0,
        ),
        Velocities(3.37, 1.96),
        KHARAZ,
        "the impact is that at 30.1° from the normal, rounded; friction, density and the elastic "
        "constants of alumina are those of Chung & Ooi's benchmark (2011) as YADE's examples have "
        "it, those of the glass handbook values; the stiffness is Mindlin's; the measured normal "
        "restitution of 0.98 is taken as 1",
        measured=Measured(MEASURED_CONVENTION, _KHARAZ_POINTS),
    ),
    Material(
        "glass-on-glass",
        "Glass on glass, 3 mm",
        Contact(_GLASS, _GLASS, 0.092, "mindlin", 0.0),
        Velocities(1.0, 0.3),
        FOERSTER,
        "only the friction is from this source, as others quote it; density and elastic constants "
        "are handbook values, the diameter is rounded (3.18 mm in the tables of that laboratory); "
        "Mindlin's stiffness makes kappa independent of size and speed; the normal restitution "
        "of 0.97 is taken as 1",
    ),
    Material(
        "acetate-on-acetate",
        "Cellulose acetate, 6 mm",
        Contact(_ACETATE, _ACETATE, 0.25, "mindlin", 0.0),
        Velocities(1.0, 0.6),
        FOERSTER,
        "only the friction is from this source, as others quote it; density and elastic constants "
        "are rounded typical values, the diameter is rounded (5.99 mm in the tables of that "
        "laboratory); its normal restitution of 0.87 is not modelled here",
    ),
)

MATERIALS: Mapping[str, Material] = MappingProxyType({each.id: each for each in _ALL})
"""By name."""
