"""Eqs. 1–10: the forces and the coefficients of restitution."""

import math
from collections.abc import Callable

import numpy as np

from restitution.mechanics.contact import contact_duration, normal_restitution
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.hertz import FloatArray
from restitution.paper.item import Item, Verdict, judged, number, scene, shown
from restitution.paper.samples import (
    KAPPA,
    ROUNDING,
    SEED,
    SLOPE,
    SOLVER,
    STEEL,
    Moments,
    largest,
    many,
    motions,
    normal,
    slope,
    solved,
    steel,
)
from restitution.studies.spheres.bodies import Sphere, pair
from restitution.studies.spheres.contact import scales
from restitution.studies.spheres.impact import Impact, contact_velocity

ETAS = (0.05, 0.3, 1.0)
"""η of the damped contacts that are looked at: ε_n from .94 to .39."""

QUADRATURE = np.polynomial.legendre.leggauss(400)


def equation(
    which: int,
    section: str,
    printed: str,
    computed: str,
    verdict: Verdict,
    evidence: str,
    link: str,
) -> Item:
    """Return what is said of a numbered equation."""
    return Item(
        f"equation-{which}", "equation", section, printed, computed, verdict, evidence, link
    )


def integral(damping: float, integrand: Callable[[FloatArray], FloatArray]) -> float:
    """Return the integral over a contact of what `integrand` makes of x, ẋ and the force (3, N).

    In t = t_c(3s² − 2s³), for the force starts as √t or t^{3/2}.
    """
    nodes, weights = QUADRATURE
    s = 0.5 * (nodes + 1.0)
    duration = contact_duration(damping)
    curves = normal(damping, duration * s * s * (3.0 - 2.0 * s))
    return float(np.sum(0.5 * weights * 6.0 * s * (1.0 - s) * duration * integrand(curves)))


def _newton(damping: float) -> float:
    """Return the largest |ẍ + F_n| within a contact, by differences."""
    time = np.linspace(0.02, 0.98, 97) * contact_duration(damping)
    step = np.full(time.size, 1e-3)
    acceleration = slope(lambda at: normal(damping, at)[1], time, step)
    return float(np.max(np.abs(acceleration + normal(damping, time)[2])))


def equation_1() -> Item:
    """Return Hertz's force with viscous damping."""
    off = 0.0
    for eta in ETAS:
        time = np.linspace(0.0, 1.0, 301) * contact_duration(eta)
        x, rate, force = normal(eta, time)
        root = np.sqrt(np.maximum(x, 0.0))
        as_printed = np.maximum(0.0, root**3 + eta * root * rate)
        off = max(off, float(np.max(np.abs(as_printed - force))))
    at = scales(steel(), 20.0)
    modulus = 2.0 * STEEL.youngs_modulus_pa / (3.0 * (1.0 - STEEL.poisson_ratio**2))
    hertz = modulus * math.sqrt(at.pair.effective_radius_m) * at.maximum_compression_m**1.5
    ratio = hertz / at.maximum_normal_force_n
    return equation(
        1,
        "1",
        "F_n = max[0, 2Y√R_{eff}/(3(1 − ν²)) · (ξ^{3/2} + (3/2) A √ξ dξ/dt)]",
        f"the force that drives the damped contact is this one within {number(off, 1)}; undamped, "
        f"Fig. 2's steel at 20 m/s reaches {number(hertz / 1e6)} MN either way (ratio "
        f"{number(ratio, 6)})",
        judged(printed=off < ROUNDING and abs(ratio - 1.0) < ROUNDING),
        "301 instants of three contacts, η = 0.05, 0.3, 1, whose motion is a power series; and "
        "the largest force from the energy. In the text at hand the formula itself is lost: it "
        "is taken from its source, Brilliantov et al. 1996.",
        shown(KAPPA, 1.0, damping="0.3"),
    )


def equation_2() -> Item:
    """Return Newton's law of the normal motion."""
    off = max(map(_newton, (0.0, *ETAS)))
    start = max(abs(normal(eta, np.zeros(1))[1, 0] - 1.0) for eta in (0.0, *ETAS))
    return equation(
        2,
        "1",
        "m_{eff} d²ξ/dt² + F_n = 0, ξ(0) = 0, dξ/dt(0) = g_n",
        f"the left side is at most {number(off, 1)} in scaled units; the rate starts at 1 within "
        f"{number(start, 1)}",
        judged(printed=off < SLOPE and start < ROUNDING),
        "Difference quotients at 97 instants of four contacts, η = 0, 0.05, 0.3, 1. In the text "
        "at hand m_{eff} is printed here without its fraction bar, in Sect. 3 with it.",
        shown(KAPPA, 1.0),
    )


def equation_3() -> Item:
    """Return the coefficient of normal restitution."""
    off, values = 0.0, []
    for eta in ETAS:
        end = normal(eta, np.array([contact_duration(eta)]))
        lost = integral(eta, lambda c: np.sqrt(np.maximum(c[0], 0.0)) * c[1] ** 2)
        kept = 1.0 - 2.0 * eta * lost - 0.8 * max(float(end[0, 0]), 0.0) ** 2.5
        values.append(normal_restitution(eta))
        off = max(off, abs(math.sqrt(kept) - values[-1]))
    etas = np.geomspace(1e-6, 1e6, 60).tolist()
    everything = [normal_restitution(eta) for eta in etas]
    within = min(everything) >= 0.0 and max(everything) <= 1.0
    listed = ", ".join(number(value, 4) for value in values)
    return equation(
        3,
        "1",
        "ε_n = −(dξ/dt)(t_c)/(dξ/dt)(0), with 0 ≤ ε_n ≤ 1 and 1 for the elastic collision",
        f"ε_n = {listed} for η = 0.05, 0.3, 1, and 1 for A = 0; from η = 10^{{−6}} to 10^{{6}} it "
        f"stays in {number(min(everything), 1)} … {number(max(everything), 7)}",
        judged(printed=off < ROUNDING and within and normal_restitution(0.0) == 1.0),
        "The energy that the damping takes, by quadrature, leaves the same ε_n within "
        f"{number(off, 1)}. The contact ends where the force vanishes; ended at ξ = 0, as some "
        "authors do, the spheres would attract each other at last and ε_n be smaller.",
        shown(KAPPA, 1.0, damping="0.3"),
    )


def random_impact() -> tuple[Impact, Sphere, Sphere]:
    """Return two unequal spheres, the second hollow, in random motion towards each other."""
    random = np.random.default_rng(SEED)
    first = Sphere(0.02, 1e10, 0.3, density_kg_m3=7850.0)
    second = Sphere(0.013, 5e9, 0.2, density_kg_m3=2500.0, inertia="hollow")
    vectors = [tuple(random.normal(size=3).tolist()) for _ in range(3)]
    normal_direction = np.array(random.normal(size=3))
    velocity = np.array(vectors[0])
    closing = velocity - 3.0 * normal_direction / np.linalg.norm(normal_direction)
    spins = [tuple((80.0 * np.array(v)).tolist()) for v in vectors[1:]]
    impact = Impact(
        tuple(closing.tolist()),
        vectors[0],
        tuple(normal_direction.tolist()),
        spins[0],
        spins[1],
    )
    return impact, first, second


def surface_velocity(impact: Impact, first: Sphere, second: Sphere) -> tuple[FloatArray, ...]:
    """Return the unit normal and the relative velocity of the material points that touch."""
    direction = np.array(impact.normal) / np.linalg.norm(impact.normal)
    spin_1, spin_2 = np.array(impact.spin_1_rad_s), np.array(impact.spin_2_rad_s)
    point_1 = np.array(impact.velocity_1_m_s) + np.cross(spin_1, -first.radius_m * direction)
    point_2 = np.array(impact.velocity_2_m_s) + np.cross(spin_2, second.radius_m * direction)
    return direction, point_1 - point_2


def equation_4() -> Item:
    """Return the relative velocity of the surfaces."""
    impact, first, second = random_impact()
    direction, points = surface_velocity(impact, first, second)
    turning = first.radius_m * np.array(impact.spin_1_rad_s)
    turning = turning + second.radius_m * np.array(impact.spin_2_rad_s)
    centres = np.array(impact.velocity_1_m_s) - np.array(impact.velocity_2_m_s)
    off = float(np.max(np.abs(centres - np.cross(turning, direction) - points)))
    return equation(
        4,
        "2",
        "g = v_i − v_j − (R_iΩ_i + R_jΩ_j) × e_n",
        "the velocities of the two material points that touch differ by this, within "
        f"{number(off, 1)} m/s",
        judged(printed=off < ROUNDING),
        "Two unequal spheres in random motion as rigid bodies, v + Ω × (∓R e_n), e_n pointing "
        "from j to i.",
        scene(scene="spheres"),
    )


def equation_5() -> Item:
    """Return the normal part of the velocity."""
    impact, first, second = random_impact()
    direction, points = surface_velocity(impact, first, second)
    approach = contact_velocity(impact, pair(first, second))
    off = abs(float(points @ direction) + approach.normal_velocity)
    return equation(
        5,
        "2",
        "vector g_n = (e_n · g) e_n",
        f"e_n · g = −{number(approach.normal_velocity, 4)} m/s for spheres that approach with g_n "
        f"= {number(approach.normal_velocity, 4)} m/s: the same within {number(off, 1)} m/s",
        judged(printed=off < ROUNDING),
        "The same random impact. As a number the paper has g_n = −(v_i − v_j) · e_n, positive; "
        "as a vector the component along e_n, which is negative: two signs for one name.",
        scene(scene="spheres"),
    )


def equation_6() -> Item:
    """Return the tangential part of the velocity."""
    impact, first, second = random_impact()
    direction, points = surface_velocity(impact, first, second)
    approach = contact_velocity(impact, pair(first, second))
    tangential = np.ldexp(approach.tangential, approach.exponent)
    printed = np.cross(np.cross(direction, points), direction)
    off = float(np.max(np.abs(printed - tangential)))
    whole = points - (points @ direction) * direction - printed
    off = max(off, float(np.max(np.abs(whole))), abs(float(printed @ direction)))
    return equation(
        6,
        "2",
        "vector g_t = (e_n × g) × e_n",
        f"perpendicular to e_n and with the normal part the whole g, within {number(off, 1)} m/s; "
        f"g_t = {number(approach.tangential_velocity, 4)} m/s ≥ 0",
        judged(printed=off < ROUNDING),
        "The same random impact.",
        scene(scene="spheres"),
    )


def equation_7() -> Item:
    """Return the coefficient of tangential restitution."""
    off = max(
        abs(
            float(tangential_curves(course, np.array([course.duration])).velocity[0])
            - course.epsilon_t
        )
        for course in motions()
    )
    found = solved()
    apart = float(np.max(np.abs(found.solver - found.exact)))
    epsilon_t = many().result.epsilon_t
    bounded = bool(np.all(np.abs(epsilon_t) <= 1.0))
    return equation(
        7,
        "2",
        "ε_t = g_t(t_c)/g_t(0), with −1 ≤ ε_t ≤ 1",
        f"end over beginning of 60 velocity traces, within {number(off, 1)}; of 20,000 random "
        f"collisions ε_t lies in {number(float(epsilon_t.min()), 4)} … "
        f"{number(float(epsilon_t.max()), 4)}",
        judged(printed=off < ROUNDING and apart < SOLVER and bounded),
        f"An adaptive solver agrees within {number(apart, 1)} on four collisions. The limits "
        "follow from the energy, which never rises.",
        shown(KAPPA, 0.97),
    )


def _turned_share() -> float:
    """Return the share of all sliding time in which the surfaces move against the spring."""
    against = sliding = 0
    for course in motions():
        curves = tangential_curves(course, np.linspace(0.0, course.duration, 1500)[:-1])
        slides = curves.regime != 0
        sliding += int(np.sum(slides))
        against += int(np.sum(slides & (curves.regime * curves.velocity < 0.0)))
    return against / sliding


def equation_8() -> Item:
    """Return Coulomb's law with the sign of the velocity."""
    share = _turned_share()
    off = largest(lambda at: np.abs(np.abs(at.force) - at.normal_force) * np.abs(at.sliding))
    wrong_way = largest(
        lambda at: np.abs(np.sign(at.force) - at.sliding) * np.abs(at.sliding),
    )
    return equation(
        8,
        "2",
        "F_t = −sgn(g_t) μ F_n while the particles slide",
        f"the size is μF_n within {number(off, 1)}, but in {number(100.0 * share, 1)} % of the "
        "sliding time of 60 random collisions the surfaces already move back and the force still "
        "has the sign of the spring: −sgn(ζ), as in Eq. 10",
        judged(printed=off < ROUNDING and share == 0.0, corrected=off + wrong_way < ROUNDING),
        "In decompression the cap falls faster than the spring relaxes, so "
        "that it stays at the cap while g_t turns. In Sect. 3, where g_t keeps its sign, Eq. 8 "
        "holds as printed.",
        shown(KAPPA, 1.25),
    )


def equation_9() -> Item:
    """Return the elongation of the spring."""
    sticking = largest(lambda at: np.abs(at.spring_rate - at.velocity) * (at.sliding == 0.0))
    sliding = largest(lambda at: np.abs(at.spring_rate - at.velocity) * np.abs(at.sliding))
    free, held = solved("free"), solved("held")
    apart = float(np.max(np.abs(free.solver - free.exact)))
    agrees = float(np.max(np.abs(held.solver - held.exact)))
    return equation(
        9,
        "2",
        "ζ(t) = ∫₀^{t} g_t dt′",
        f"dζ/dt = g_t holds within {number(sticking, 1)} while the contact sticks; while it "
        f"slides they are apart, up to {number(sliding, 2)} in 60 collisions, for the spring is "
        "held at the cap. "
        f"Taken throughout, Eq. 9 changes ε_t by up to {number(apart, 2)}",
        judged(printed=apart < SOLVER, corrected=sticking < SLOPE and agrees < 100.0 * SOLVER),
        "Difference quotients in 60 collisions; an adaptive solver with the spring held at the "
        f"cap agrees with ε_t within {number(agrees, 1)}. The text after Eq. 10 says so itself: "
        "|ζ| = μF_n/k_t in the regime of sliding.",
        shown(KAPPA, 0.97),
    )


def equation_10() -> Item:
    """Return the force of the capped spring."""

    def off_by(at: Moments) -> FloatArray:
        capped = np.minimum(at.normal_force, at.kappa * np.abs(at.elongation))
        return np.asarray(np.abs(at.force - np.sign(at.elongation) * capped))

    off = largest(off_by)
    damped = largest(off_by, 0.3)
    return equation(
        10,
        "2",
        "F_t = −sgn(ζ) min(μF_n, k_t|ζ|)",
        f"the force and the elongation of 60 collisions obey it within {number(off, 1)}, with "
        f"damping (η = 0.3) within {number(damped, 1)}",
        judged(printed=max(off, damped) < ROUNDING),
        "Force and elongation are formed separately, from the phase of the swing and from the cap.",
        shown(KAPPA, 0.97),
    )


EQUATIONS = (
    equation_1,
    equation_2,
    equation_3,
    equation_4,
    equation_5,
    equation_6,
    equation_7,
    equation_8,
    equation_9,
    equation_10,
)
