"""Real bodies worth a look, each a valid body of ``POST /scaling``, and what was measured."""

import math
from dataclasses import dataclass, field
from typing import Any

from restitution.studies.collision.presets import PAPER, SOLID

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
    """Two bodies with a name: keys of ``POST /scaling``, the source, notes on what is not in it.

    Examples
    --------
    >>> [each.friction_coefficient for each in MATERIALS if each.id == "steel"]
    [0.4]
    """

    id: str
    title: str
    body_1: dict[str, Any]
    body_2: dict[str, Any]
    friction_coefficient: float
    tangential_stiffness_n_per_m: float | str
    impact: dict[str, Any]
    source: str
    notes: str
    dissipative_constant_s: float = 0.0
    measured: Measured | None = field(default=None)


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


def _impact(normal: float, tangential: float) -> dict[str, float]:
    return {"normal_velocity_m_s": normal, "tangential_velocity_m_s": tangential}


_STEEL = {
    "radius_m": 0.02,
    "density_kg_m3": 7850.0,
    "youngs_modulus_pa": 2.1e11,
    "poisson_ratio": 0.3,
    "inertia": "solid",
}
_GLASS = {
    "radius_m": 0.0015,
    "density_kg_m3": 2500.0,
    "youngs_modulus_pa": 7e10,
    "poisson_ratio": 0.22,
    "inertia": "solid",
}
_ACETATE = {
    "radius_m": 0.003,
    "density_kg_m3": 1300.0,
    "youngs_modulus_pa": 3e9,
    "poisson_ratio": 0.3,
    "inertia": "solid",
}

_KHARAZ_POINTS = tuple(_kharaz_point(*point) for point in KHARAZ_CENTRE_RATIOS)

MATERIALS = (
    Material(
        "steel",
        "Steel spheres of Fig. 2",
        _STEEL,
        _STEEL,
        0.4,
        1e12,
        _impact(20.0, 5.0),
        f"{PAPER}: caption of Fig. 2",
        "the impact is ours, within the range of the figure; k_t is that of the caption, 2,500 to "
        "8,000 times Mindlin's at 20 to 1 m/s",
    ),
    Material(
        "steel-mindlin",
        "The same steel, Mindlin's stiffness",
        _STEEL,
        _STEEL,
        0.4,
        "mindlin",
        _impact(1.0, 0.5),
        f"{PAPER}: caption of Fig. 2; R. D. Mindlin, J. Appl. Mech. 16, 259 (1949)",
        "the stiffness is not the paper's, and the impact is ours: at its 20 m/s steel flows",
    ),
    Material(
        "alumina-on-glass",
        "Alumina on glass",
        {
            "radius_m": 0.0025,
            "density_kg_m3": 4000.0,
            "youngs_modulus_pa": 3.8e11,
            "poisson_ratio": 0.23,
            "inertia": "solid",
        },
        {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25},
        0.092,
        "mindlin",
        _impact(3.37, 1.96),
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
        _GLASS,
        _GLASS,
        0.092,
        "mindlin",
        _impact(1.0, 0.3),
        FOERSTER,
        "only the friction is from this source, as others quote it; density and elastic constants "
        "are handbook values, the diameter is rounded (3.18 mm in the tables of that laboratory); "
        "Mindlin's stiffness makes kappa independent of size and speed; the normal restitution "
        "of 0.97 is taken as 1",
    ),
    Material(
        "acetate-on-acetate",
        "Cellulose acetate, 6 mm",
        _ACETATE,
        _ACETATE,
        0.25,
        "mindlin",
        _impact(1.0, 0.6),
        FOERSTER,
        "only the friction is from this source, as others quote it; density and elastic constants "
        "are rounded typical values, the diameter is rounded (5.99 mm in the tables of that "
        "laboratory); its normal restitution of 0.87 is not modelled here",
    ),
)
