"""The numbers in captions and footnotes."""

import math

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.contact import normal_restitution
from restitution.mechanics.limits import sliding_threshold
from restitution.paper.figures import FASTEST, FIGURE_6, counts_at, first_stop
from restitution.paper.item import Item, Verdict, judged, number, scene, shown
from restitution.paper.samples import (
    FRICTION,
    KAPPA,
    MU_OVER_ALPHA,
    PRINTED_KAPPA,
    ROUNDING,
    STEEL,
    STIFFNESS,
    mindlin_kappa,
    soft_border,
    steel,
)
from restitution.studies.collision.presets import SOLID
from restitution.studies.spheres.bodies import pair
from restitution.studies.spheres.contact import scales

FOOTNOTE_FRICTION = 0.5
FOOTNOTE_MODULUS = 210e6
"""μ and Y in Pa of footnote 2 as printed."""

FOOTNOTE_SPEED = 20.0

PRINTED_COEFFICIENT = 1.109e5
"""ζ k_t of footnote 2, in kg m/s² as the page has it for k_t in kg/s²."""


def _item(
    name: str,
    section: str,
    printed: str,
    computed: str,
    verdict: Verdict,
    evidence: str,
    link: str,
) -> Item:
    return Item(f"number-{name}", "number", section, printed, computed, verdict, evidence, link)


def largest_force_of_footnote(modulus: float, friction: float) -> float:
    """Return the right side of footnote 2's formula in N, for the steel of Fig. 2."""
    square = 1.0 - STEEL.poisson_ratio**2
    density = STEEL.density_kg_m3
    assert density is not None
    root = (250.0 * modulus**2 * math.pi**3 * density**3 / square**2) ** 0.2
    return float(friction / 3.0 * root * STEEL.radius_m**2 * FOOTNOTE_SPEED**1.2)


def figure_1_friction() -> Item:
    """Return μ and α of Fig. 1."""
    threshold = float(sliding_threshold(KAPPA)) * MU_OVER_ALPHA
    return _item(
        "figure-1-friction",
        "3",
        "Fig. 1: μ = 0.4, α = 2/7",
        f"μ/α = {number(MU_OVER_ALPHA, 3)}; the law leaves zero at g_t/g_n = "
        f"{number(threshold, 3)}",
        judged(printed=abs(threshold - 2.0 * FRICTION / SOLID) < ROUNDING),
        "The threshold of pure sliding, found from the spring.",
        scene(scene="spheres", velocity_law="coulomb"),
    )


def figure_2_masses() -> Item:
    """Return radius and density of Fig. 2."""
    both = pair(STEEL, STEEL)
    return _item(
        "figure-2-spheres",
        "4.1",
        "Fig. 2: identical spheres, R = 2 cm, ρ = 7850 kg/m³, α = 2/7",
        f"m_{{eff}} = {number(both.effective_mass_kg, 6)} kg, R_{{eff}} = "
        f"{number(1e3 * both.effective_radius_m, 3)} mm, α = {number(both.alpha, 6)}",
        judged(printed=abs(both.alpha - SOLID) < ROUNDING),
        "Homogeneous spheres by Eq. 12.",
        scene(scene="spheres", material="steel"),
    )


def figure_2_elasticity() -> Item:
    """Return the elastic constants of Fig. 2."""
    at = scales(steel(), FOOTNOTE_SPEED)
    return _item(
        "figure-2-elasticity",
        "4.1",
        "Fig. 2: Y = 210 GPa, ν = 0.3",
        f"β = {number(at.beta, 6)} m^{{−1/2}}s^{{−2}}; at 20 m/s the contact lasts "
        f"{number(1e6 * at.contact_duration_s, 3)} µs, the compression reaches "
        f"{number(1e6 * at.maximum_compression_m, 3)} µm",
        judged(printed=at.maximum_compression_m < 0.05 * STEEL.radius_m),
        "Eqs. 18–20. Hertz's law wants a compression small against R: that is what is checked "
        "here; that steel stays elastic is not so, see Fig. 2.",
        scene(scene="spheres", normal_velocity_m_s="20"),
    )


def figure_2_stiffness() -> Item:
    """Return k_t of Fig. 2."""
    slow, twenty, fast = (scales(steel(), v) for v in (1.0, FOOTNOTE_SPEED, FASTEST))
    mindlin = twenty.mindlin_stiffness_n_per_m
    return _item(
        "figure-2-stiffness",
        "4.1",
        "Fig. 2: k_t = 10^{12} kg/s², called the right order of magnitude",
        f"κ = {number(slow.kappa, 5)} at 1 m/s, {number(twenty.kappa, 5)} at 20, "
        f"{number(fast.kappa, 4)} at 200; Mindlin's stiffness at 20 m/s is {number(mindlin, 2)} "
        f"N/m, {number(STIFFNESS / mindlin, 3)} times less",
        judged(printed=0.1 < STIFFNESS / mindlin < 10.0),
        "The paper takes the stiffness of asperities from the roughness of the surface. "
        "Mindlin's is that of the bulk behind them, in series with it, so that it cannot be "
        f"exceeded; κ is near {number(mindlin_kappa(), 2)} with it. In doubt is only whether the "
        "paper's spring is meant to contain the bulk.",
        scene(scene="spheres", material="steel-mindlin"),
    )


def figure_2_friction() -> Item:
    """Return μ of Fig. 2 against that of footnote 2."""
    theirs, ours = (
        largest_force_of_footnote(STEEL.youngs_modulus_pa, friction)
        for friction in (FOOTNOTE_FRICTION, FRICTION)
    )
    return _item(
        "figure-2-friction",
        "4.1",
        "Fig. 2: μ = 0.4; footnote 2 calls its μ = 0.5 and Y = 210 MPa those of this caption",
        f"μ {FOOTNOTE_FRICTION:g} against {FRICTION:g}, Y {FOOTNOTE_MODULUS / 1e6:g} MPa against "
        f"{STEEL.youngs_modulus_pa / 1e9:g} GPa. The footnote's own number, "
        f"{number(PRINTED_COEFFICIENT, 4)}, comes out with 0.5 and GPa ({number(theirs, 4)}), not "
        f"with 0.4 ({number(ours, 4)})",
        judged(
            printed=FOOTNOTE_FRICTION == FRICTION and STEEL.youngs_modulus_pa == FOOTNOTE_MODULUS,
            corrected=abs(theirs - PRINTED_COEFFICIENT) < 100.0 < abs(ours - PRINTED_COEFFICIENT),
        ),
        "Y is a slip of the unit. Footnote 2 was computed with another μ than the caption has; "
        "which of them Fig. 2 was drawn with is undecided, and the caption's is used on this page.",
        scene(scene="spheres", friction_coefficient="0.5"),
    )


def footnote_1() -> Item:
    """Return the signs of both coefficients."""
    smooth = float(collide(KAPPA, np.inf).epsilon_t)
    bouncing = normal_restitution(0.0)
    return _item(
        "footnote-1",
        "2",
        "footnote 1: ε_t and ε_n differ in the sign of their definitions",
        f"a collision that changes nothing tangentially has ε_t = {number(smooth, 2)}, one that "
        f"reverses the normal velocity fully ε_n = {number(bouncing, 2)}",
        judged(printed=smooth == 1.0 and bouncing == 1.0),
        "Eqs. 3 and 7. Some authors use −ε_t: what is read here says which it is.",
        shown(KAPPA, 2.5),
    )


def footnote_2_modulus() -> Item:
    """Return the unit of Young's modulus in footnote 2."""
    mega, giga = (
        largest_force_of_footnote(modulus, FOOTNOTE_FRICTION)
        for modulus in (FOOTNOTE_MODULUS, 1e3 * FOOTNOTE_MODULUS)
    )
    near = [abs(value / PRINTED_COEFFICIENT - 1.0) < 1e-2 for value in (mega, giga)]
    return _item(
        "footnote-2-modulus",
        "2",
        "footnote 2: Y = 210 MPa gives ζk_t = 1.109·10^{5}",
        f"210 MPa gives {number(mega, 4)}, 210 GPa {number(giga, 6)}: GPa is meant",
        judged(printed=near[0], corrected=near[1]),
        "Footnote 2's own formula; the caption of Fig. 2 has GPa.",
        scene(scene="spheres", youngs_modulus_pa="2.1e8"),
    )


def footnote_2_coefficient() -> Item:
    """Return ζ k_t of footnote 2."""
    value = largest_force_of_footnote(1e3 * FOOTNOTE_MODULUS, FOOTNOTE_FRICTION)
    off = abs(value - PRINTED_COEFFICIENT)
    return _item(
        "footnote-2-coefficient",
        "2",
        "footnote 2: ζ = 1.109·10^{5} m s²/kg / k_t, with μ = 0.5, g_n = 20 m/s",
        f"{value / 1e5:.5f}·10^{{5}}: printed truncated, rounded it would be {value / 1e5:.3f}. "
        "It is a force: its unit is kg m/s², and k_t stands in the denominator",
        judged(printed=off <= 50.0, corrected=off < 100.0),
        "Footnote 2's formula with Y = 210 GPa and the square of (1 − ν²), of which the text at "
        "hand shows none; without it the value would be "
        f"{number(value * (1.0 - STEEL.poisson_ratio**2) ** 0.2, 5)}.",
        scene(scene="spheres", normal_velocity_m_s="20", friction_coefficient="0.5"),
    )


def footnote_2_length() -> Item:
    """Return ζ of footnote 2."""
    value = largest_force_of_footnote(1e3 * FOOTNOTE_MODULUS, FOOTNOTE_FRICTION) / STIFFNESS
    off = abs(1e6 * value - 0.1109)
    return _item(
        "footnote-2-length",
        "2",
        "footnote 2: ζ = 1.109·10^{−7} m = 0.1109 µm for k_t = 10^{12} kg/s²",
        f"{number(1e6 * value, 5)} µm by its formula, printed truncated",
        judged(printed=off <= 5e-5, corrected=off < 1e-4),
        "As above. What follows from the right energy balance is said of the formula.",
        scene(scene="spheres", normal_velocity_m_s="20", friction_coefficient="0.5"),
    )


def footnote_2_formula() -> Item:
    """Return the largest normal force of footnote 2."""
    by_formula = largest_force_of_footnote(1e3 * FOOTNOTE_MODULUS, 1.0)
    force = scales(steel(), FOOTNOTE_SPEED).maximum_normal_force_n
    ratio = by_formula / force
    return _item(
        "footnote-2-formula",
        "2",
        "footnote 2: F_n^{max} = (μ/3)[250 Y²π³ρ³/(1 − ν²)²]^{1/5} R² g_n^{6/5} from the energy",
        f"the formula has μ in it already, and without μ it gives {number(by_formula / 1e6, 4)} "
        f"MN where the energy gives {number(force / 1e6, 4)}: {number(ratio, 5)} = 2^{{3/5}} too "
        "much, for it takes the mass m of one sphere for m_{eff} = m/2",
        judged(
            printed=abs(ratio * FOOTNOTE_FRICTION - 1.0) < 1e-3,
            corrected=abs(ratio - 2.0**0.6) < 1e-9,
        ),
        "Energy of the Hertz contact, as for Eq. 19. With m_{eff} and μ = 0.5 the spring is "
        f"stretched by {number(1e6 * FOOTNOTE_FRICTION * force / STIFFNESS, 3)} µm, not 0.1109.",
        scene(scene="spheres", normal_velocity_m_s="20", friction_coefficient="0.5"),
    )


def figure_4_constants() -> Item:
    """Return α and μ of Fig. 4 and its border."""
    psi = float(sliding_threshold(KAPPA))
    return _item(
        "figure-4-border",
        "4.3",
        "Fig. 4: α = 2/7, μ = 0.4; the collision slides throughout for g_t/g_n ≳ 3, but for very "
        "small κ",
        f"the border lies at g_t/g_n = {number(psi * MU_OVER_ALPHA, 3)} for κ ≥ 0.5701; at "
        "g_t/g_n = 3 it slides throughout from κ = "
        f"{number(soft_border(3.0 / MU_OVER_ALPHA), 3)} on",
        judged(printed=2.5 < psi * MU_OVER_ALPHA <= 3.0),
        "The threshold ψ* of pure sliding, exact; ≳ 3 is a reading off the figure.",
        shown(KAPPA, 2.0, map="switches", map_x="alpha_kappa"),
    )


def figure_5_kappa() -> Item:
    """Return κ = 18."""
    printed, ours = max(counts_at(PRINTED_KAPPA)), max(counts_at(KAPPA))
    needed = next(k for k in range(18, 100) if max(counts_at(float(k))) >= 8)
    return _item(
        "figure-5-kappa",
        "4.3",
        "Figs. 4 and 5: κ = 18, with up to eight switches",
        f"κ = 18 has at most {printed}, 18/α = {number(KAPPA, 2)} has {ours}; eight need κ ≥ "
        f"{needed}",
        judged(printed=printed == 8, corrected=ours == 8),
        "8000 collisions at each integer κ up to there. What is printed is ακ.",
        shown(KAPPA, 0.97, map="switches", map_x="alpha_kappa"),
    )


def figure_6_kappa() -> Item:
    """Return κ = 100 of Fig. 6."""
    kappa, ratio = FIGURE_6
    fits = [
        f"{number(k, 3)} with μ/α = {friction:.1f}"
        for k in (kappa, kappa / SOLID)
        for friction in (0.8, 0.9, 1.0, 1.1, 1.2, 1.3, MU_OVER_ALPHA)
        if 1.0 < first_stop(k, ratio, friction).minimum < 1.1
    ]
    return _item(
        "figure-6-kappa",
        "4.4",
        "Fig. 6: κ = 100, the case of very stiff springs",
        f"κ and μ/α whose first minimum lies between t = 1 and 1.1: {'; '.join(fits)}",
        judged(printed=any(fit.startswith("100") for fit in fits), corrected=bool(fits)),
        "A search over μ/α from 0.8 to 1.4, for κ with and without 1/α: both fit, so which κ is "
        "meant stays undecided.",
        shown(kappa, ratio, 1.0),
    )


def figure_6_velocity() -> Item:
    """Return z(0) = 0.3 of Fig. 6."""
    _, ratio = FIGURE_6
    course = first_stop(*FIGURE_6, 1.0).course
    start = float(course.force[0])
    return _item(
        "figure-6-start",
        "4.4",
        "Fig. 6: initial value z(0) = g_t/g_n = 0.3",
        f"the spring starts unstretched, κ|z(0)| = {number(start, 1)}, as Eq. 23 has it; dz/dt(0) "
        f"= {ratio} is meant, which is Eq. 22",
        judged(printed=start == ratio, corrected=start == 0.0),
        "A dot lost in print.",
        shown(*FIGURE_6, 1.0),
    )


NUMBERS = (
    footnote_1, footnote_2_formula, footnote_2_modulus, footnote_2_coefficient, footnote_2_length,
    figure_1_friction, figure_2_masses, figure_2_elasticity, figure_2_stiffness,
    figure_2_friction, figure_4_constants, figure_5_kappa, figure_6_kappa, figure_6_velocity,
)  # fmt: skip
