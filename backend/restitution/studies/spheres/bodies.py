"""Two bodies of given material: what their contact inherits from them (Eqs. 12 and 18).

SI units throughout. A wall has infinite mass and radius.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal

from annotated_types import Ge, Gt, Le

from restitution.bounds import Choice, Misfit, Words, checked
from restitution.errors import ParameterError
from restitution.studies.spheres.powers import joined, product_of_powers, representable

GYRATION = {"solid": 2.0 / 5.0, "hollow": 2.0 / 3.0}
"""J/(mR²) of a homogeneous sphere and of a thin shell."""


Positive = Annotated[float, Gt(0)]
NotNegative = Annotated[float, Ge(0)]
PoissonRatio = Annotated[float, Gt(-1), Le(0.5)]


@checked
class Moment:
    """A moment of inertia of one's own.

    Attributes
    ----------
    moment_kg_m2 : float
        J in kg m².

    Examples
    --------
    >>> Sphere(0.02, 2.1e11, 0.3, mass_kg=0.2, inertia=Moment(3e-5)).inertia.moment_kg_m2
    3e-05
    """

    moment_kg_m2: Positive


@checked
class Sphere:
    """A sphere; of mass and density one is given.

    Attributes
    ----------
    radius_m, youngs_modulus_pa : float
        R and Y.
    poisson_ratio : float
        ν.
    mass_kg, density_kg_m3 : float or None
        The density of a hollow sphere is its mass over the whole volume.
    inertia : ``"solid"``, ``"hollow"`` or Moment
        J/(mR²) is 2/5 and 2/3.
    yield_stress_pa : float or None
        Tensile yield stress, if plastic flow is to be looked for.

    Raises
    ------
    ParameterError
        If one of them is out of range, or not one of mass and density is given.

    Examples
    --------
    >>> Sphere(radius_m=0.02, youngs_modulus_pa=2.1e11, poisson_ratio=0.3, mass_kg=0.2).inertia
    'solid'
    """

    radius_m: Positive
    youngs_modulus_pa: Positive
    poisson_ratio: PoissonRatio
    mass_kg: Positive | None = None
    density_kg_m3: Positive | None = None
    inertia: Annotated[
        Literal["solid", "hollow"] | Moment, Words('solid, hollow, or {"moment_kg_m2": …}')
    ] = "solid"
    yield_stress_pa: Positive | None = None
    wall: Annotated[Literal[False], Words("true, or left out for a sphere")] = False

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield what is wrong with mass and density beside each other, and with `wall`."""
        if given.get("wall", False) is not False:
            yield "wall", "true, or left out for a sphere"
        if "density_kg_m3" not in given and "mass_kg" not in given:
            yield "density_kg_m3", "finite and > 0, unless mass_kg is given"
        if "density_kg_m3" in given and "mass_kg" in given:
            yield "mass_kg", "left out, as density_kg_m3 is given"


@checked
class Wall:
    """A flat body that neither yields way nor turns.

    Attributes
    ----------
    youngs_modulus_pa, poisson_ratio, yield_stress_pa
        As of `Sphere`.

    Examples
    --------
    >>> Wall(youngs_modulus_pa=7e10, poisson_ratio=0.25).yield_stress_pa is None
    True
    """

    youngs_modulus_pa: Positive
    poisson_ratio: PoissonRatio
    yield_stress_pa: Positive | None = None
    wall: Literal[True] = True

    @staticmethod
    def misfits(given: Mapping[str, Any]) -> Iterator[Misfit]:
        """Yield what only a sphere has."""
        for name in ("radius_m", "density_kg_m3", "mass_kg", "inertia"):
            if name in given:
                yield name, "left out: a wall has infinite radius and mass"


def _is_wall(body: object) -> bool:
    return isinstance(body, Wall) or (isinstance(body, Mapping) and body.get("wall") is True)


Body = Annotated[Sphere | Wall, Choice(lambda body: Wall if _is_wall(body) else Sphere)]


@dataclass(frozen=True)
class Pair:
    """What a contact inherits from its two bodies.

    Attributes
    ----------
    effective_mass_kg, effective_radius_m : float
        m₁m₂/(m₁+m₂) and R₁R₂/(R₁+R₂).
    effective_modulus_pa : float
        E*, with 1/E* = (1−ν₁²)/Y₁ + (1−ν₂²)/Y₂.
    effective_shear_modulus_pa : float
        G*, with 1/G* = (2−ν₁)/G₁ + (2−ν₂)/G₂ and G = Y/(2(1+ν)); M1949.
    alpha : float
        Eq. 12.
    radii_m : tuple of float
        R of either body, infinite for a wall.
    mass_shares : tuple of float
        m_eff/m of either body, 0 for a wall.
    turning_shares_per_m : tuple of float
        m_eff R/J of either body in 1/m, 0 for a wall.
    """

    effective_mass_kg: float
    effective_radius_m: float
    effective_modulus_pa: float
    effective_shear_modulus_pa: float
    alpha: float
    radii_m: tuple[float, float]
    mass_shares: tuple[float, float]
    turning_shares_per_m: tuple[float, float]


def two_walls(given: Mapping[str, Any]) -> Iterator[Misfit]:
    """Yield that two walls do not collide."""
    if _is_wall(given.get("body_1")) and _is_wall(given.get("body_2")):
        yield "body_2.wall", "left out: one of the two bodies has to be a sphere"


def pair(body_1: Body, body_2: Body) -> Pair:
    """Return what the contact of two bodies inherits from them.

    Raises
    ------
    ParameterError
        If both are walls, or a quantity is beyond double precision.

    Examples
    --------
    >>> glass = Sphere(0.001, 7e10, 0.22, density_kg_m3=2500)
    >>> round(7 * pair(glass, Wall(2.1e11, 0.3)).alpha, 12)
    2.0
    """
    for name, words in two_walls({"body_1": body_1, "body_2": body_2}):
        raise ParameterError(name, True, words)
    bodies = body_1, body_2
    radii = _radius(body_1), _radius(body_2)
    masses = _mass("body_1", body_1), _mass("body_2", body_2)
    mass = representable("effective_mass_kg", joined(*masses), "the masses")
    shares = 1.0 / (1.0 + masses[0] / masses[1]), 1.0 / (1.0 + masses[1] / masses[0])
    levers = [_over_inertia(b, m, mass, 2) for b, m in zip(bodies, masses, strict=True)]
    return Pair(
        effective_mass_kg=mass,
        effective_radius_m=representable("effective_radius_m", joined(*radii), "the radii"),
        effective_modulus_pa=representable(
            "effective_modulus_pa",
            _joined_modulus(body_1, body_2, lambda nu: (1.0 - nu) * (1.0 + nu)),
            "Young's moduli and Poisson's ratios",
        ),
        effective_shear_modulus_pa=representable(
            "effective_shear_modulus_pa",
            _joined_modulus(body_1, body_2, lambda nu: 2.0 * (2.0 - nu) * (1.0 + nu)),
            "Young's moduli and Poisson's ratios",
        ),
        alpha=representable(
            "alpha", 1.0 / (1.0 + sum(levers)), "masses, radii and moments of inertia"
        ),
        radii_m=radii,
        mass_shares=_shares("mass", bodies, shares),
        turning_shares_per_m=_shares(
            "turning",
            bodies,
            [_over_inertia(b, m, mass, 1) for b, m in zip(bodies, masses, strict=True)],
        ),
    )


def _shares(name: str, bodies: Sequence[Body], shares: Sequence[float]) -> tuple[float, float]:
    """Return m_eff/m or m_eff R/J of both bodies, positive for spheres."""
    first, second = (
        0.0
        if isinstance(body, Wall)
        else representable(f"{name} share", share, "masses, radii and moments of inertia")
        for body, share in zip(bodies, shares, strict=True)
    )
    return first, second


def _radius(body: Body) -> float:
    return math.inf if isinstance(body, Wall) else body.radius_m


def _mass(name: str, body: Body) -> float:
    """Return m in kg, infinite for a wall."""
    if isinstance(body, Wall):
        return math.inf
    if body.mass_kg is not None:
        return body.mass_kg
    assert body.density_kg_m3 is not None
    mass = product_of_powers(
        (4.0 / 3.0 * math.pi, 10), (body.density_kg_m3, 10), (body.radius_m, 30)
    )
    return representable(f"{name}.mass_kg", mass, f"{name}'s density and radius")


def _over_inertia(body: Body, mass: float, effective_mass: float, power: int) -> float:
    """Return m_eff R^power/J, 0 for a wall."""
    if isinstance(body, Wall):
        return 0.0
    factors = (effective_mass, 10), (body.radius_m, 10 * power)
    if isinstance(body.inertia, str):
        moment = (GYRATION[body.inertia], -10), (mass, -10), (body.radius_m, -20)
        return product_of_powers(*factors, *moment)
    return product_of_powers(*factors, (body.inertia.moment_kg_m2, -10))


def _joined_modulus(first: Body, second: Body, compliance: Callable[[float], float]) -> float:
    """Return 1/Σ compliance(ν)/Y."""
    moduli = first.youngs_modulus_pa, second.youngs_modulus_pa
    softer = min(moduli)
    return softer / sum(
        compliance(body.poisson_ratio) * (softer / modulus)
        for body, modulus in zip((first, second), moduli, strict=True)
    )
