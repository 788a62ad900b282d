"""Eqs. 11–16: the contact that slides throughout."""

import numpy as np

from restitution.mechanics.contact import normal_restitution
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.limits import coulomb_restitution, sliding_restitution
from restitution.mechanics.motion import motion
from restitution.paper.equations import (
    ETAS,
    equation,
    integral,
    random_impact,
    surface_velocity,
)
from restitution.paper.item import Item, judged, number, scene, shown
from restitution.paper.samples import (
    FRICTION,
    KAPPA,
    MU_OVER_ALPHA,
    ROUNDING,
    SLOPE,
    STEEL,
    largest,
    many,
    normal,
)
from restitution.studies.collision.presets import SOLID
from restitution.studies.spheres.bodies import Sphere, pair
from restitution.studies.spheres.impact import Impact, after_impact, contact_velocity


def equation_11() -> Item:
    """Return Newton's law of both velocities."""
    tangential = largest(lambda at: np.abs(at.acceleration + at.force))
    rotation = _alpha_of_impulse()
    return equation(
        11,
        "3",
        "dg_n/dt = −F_n/m_{eff}, dg_t/dt = F_t/(α m_{eff})",
        f"dg_t/dt and the force of 60 collisions agree within {number(tangential, 1)}; a "
        "tangential impulse on two unequal bodies changes g_t as 1/α says, within "
        f"{number(rotation, 1)}",
        judged(printed=tangential < SLOPE and rotation < ROUNDING),
        "Difference quotients; the impulse acts on both bodies, with their moments of inertia, "
        "and Eq. 4 gives the new g_t. That e_n does not turn meanwhile is assumed, as printed.",
        shown(KAPPA, 0.97),
    )


def _alpha_of_impulse() -> float:
    """Return how far g_t after an impact of two bodies is from ε_t g_t, relatively."""
    impact, first, second = random_impact()
    both = pair(first, second)
    approach = contact_velocity(impact, both)
    after = after_impact(impact, both, approach, 1.0, -0.3)
    left = Impact(
        after.velocity_1_m_s, after.velocity_2_m_s, impact.normal, after.spin_1_rad_s,
        after.spin_2_rad_s,
    )  # fmt: skip
    direction, points = surface_velocity(left, first, second)
    tangential = points - (points @ direction) * direction
    wanted = -0.3 * np.ldexp(approach.tangential, approach.exponent)
    return float(np.max(np.abs(tangential - wanted)) / approach.tangential_velocity)


def equation_12() -> Item:
    """Return α."""
    _, first, second = random_impact()
    both = pair(first, second)
    moments = [
        share * body.radius_m
        for share, body in zip(both.turning_shares_per_m, (first, second), strict=True)
    ]
    off = abs(1.0 / (1.0 + sum(moments)) - both.alpha)
    other = Sphere(0.7, 1e9, 0.1, density_kg_m3=1200.0)
    solids = [pair(STEEL, body).alpha for body in (STEEL, other)]
    apart = max(abs(alpha - SOLID) for alpha in solids)
    shells = pair(second, second).alpha
    return equation(
        12,
        "3",
        "α = [1 + m_{eff}R_i²/J_i + m_{eff}R_j²/J_j]^{−1}, 2/7 for homogeneous spheres",
        f"α = {number(solids[0], 6)} for two solid spheres, alike or not (2/7 within "
        f"{number(apart, 1)}); {number(shells, 3)} for two thin shells",
        judged(printed=max(off, apart) < ROUNDING and _alpha_of_impulse() < ROUNDING),
        "The change of g_t by an impulse on both bodies, as for Eq. 11, gives the same α.",
        scene(scene="spheres"),
    )


def equation_13() -> Item:
    """Return the impulse of the normal force."""
    etas = (0.0, *ETAS)
    impulses = [integral(eta, lambda curves: curves[2]) for eta in etas]
    off = max(
        abs(impulse - 1.0 - normal_restitution(eta))
        for impulse, eta in zip(impulses, etas, strict=True)
    )
    return equation(
        13,
        "3",
        "g_n′ − g_n = −(1/m_{eff}) ∫F_n dt = −(1 + ε_n) g_n",
        f"∫F_n dt = {', '.join(number(value, 4) for value in impulses)} m_{{eff}}g_n for η = 0, "
        f"0.05, 0.3, 1, which is 1 + ε_n within {number(off, 1)}",
        judged(printed=off < ROUNDING),
        "Gauss quadrature of the force over the contact.",
        shown(KAPPA, 1.0, damping="0.3"),
    )


def equation_14() -> Item:
    """Return the impulse of the tangential force in pure sliding."""
    course = motion(KAPPA, 2.5)
    time = np.linspace(0.0, course.duration, 200)
    curves = tangential_curves(course, time)
    force = float(np.max(np.abs(curves.force - normal(0.0, time)[2])))
    off = abs(course.psi * (course.epsilon_t - 1.0) + 2.0)
    damped = motion(KAPPA, 2.5, damping=0.3)
    first = float(damped.end[0] / damped.duration)
    change = 1.0 + normal_restitution(0.3) + damped.psi * (damped.epsilon_t - 1.0)
    return equation(
        14,
        "3",
        "g_t′ − g_t = −μ(1 + ε_n)g_n/α for a contact that slides throughout",
        f"A = 0, ψ = 2.5, κ = {number(KAPPA, 2)}: F_t = −μF_n within {number(force, 1)}, the "
        f"change within {number(off, 1)}. With damping no contact slides throughout: for η = 0.3 "
        f"it sticks for the first {number(100.0 * first, 2)} %, and Eq. 14 is {number(change, 1)} "
        "off",
        judged(printed=max(force, off) < ROUNDING),
        "The force of the exact motion; for A > 0 F_n starts as √t, above the spring.",
        shown(KAPPA, 2.5),
    )


def equation_15() -> Item:
    """Return Coulomb's coefficient of tangential restitution."""
    sample = many()
    slides = sample.result.switches == 0
    law = sliding_restitution(sample.psi[slides])
    off = float(np.max(np.abs(law - sample.result.epsilon_t[slides])))
    least = float(sample.psi[slides].min())
    return equation(
        15,
        "3",
        "ε_t = 1 − (μ(1 + ε_n)/α) g_n/g_t in pure sliding",
        f"exact for the {int(slides.sum()):,} of 20,000 random collisions that slide throughout "
        f"(within {number(off, 1)}); they all have ψ = (α/μ)g_t/g_n ≥ {number(least, 3)}",
        judged(printed=off < ROUNDING and least >= 2.0),
        "A = 0, so ε_n = 1; that a collision slides throughout is found from its spring.",
        shown(KAPPA, 2.5),
    )


def equation_16() -> Item:
    """Return Coulomb's law with its cut-off."""
    psi = np.linspace(0.01, 6.0, 600)
    off = float(np.max(np.abs(coulomb_restitution(psi) - np.maximum(0.0, 1.0 - 2.0 / psi))))
    positive = min(
        float(np.min(tangential_curves(motion(kappa, psi), np.linspace(0.0, 3.2, 400)).velocity))
        for kappa, psi in ((0.2, 6.0), (18.0, 2.001), (KAPPA, 2.001), (1000.0, 3.0))
    )
    return equation(
        16,
        "3",
        "ε_t = max[0, 1 − (μ(1 + ε_n)/α) g_n/g_t]",
        f"the cut-off lies at g_t/g_n = 2μ/α, for Fig. 1 ({number(MU_OVER_ALPHA, 2)} = "
        f"{number(FRICTION, 1)}/α) at {number(2.0 * MU_OVER_ALPHA, 2)}; sliding throughout, g_t "
        f"stays positive (least g_t/g_t(0) {number(positive, 2)})",
        judged(printed=off < ROUNDING and positive >= 0.0),
        "Four motions down to ψ = 2.001. What the law is worth below the cut-off, where the "
        "contact does stop, is judged with the claims.",
        scene(scene="spheres", velocity_law="coulomb"),
    )


SLIDING_EQUATIONS = (
    equation_11,
    equation_12,
    equation_13,
    equation_14,
    equation_15,
    equation_16,
)
