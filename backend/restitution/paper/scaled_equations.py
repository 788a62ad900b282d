"""Eqs. 17–30: the scaled collision and the limit of stiff springs."""

import functools
from typing import NamedTuple

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.contact import normal_curves
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.hertz import (
    CONTACT_DURATION,
    MAXIMUM_COMPRESSION,
    MAXIMUM_FORCE,
)
from restitution.mechanics.limits import stiff_estimate
from restitution.mechanics.motion import motion, reversals
from restitution.mechanics.switching import MONOTONE_STIFFNESS
from restitution.paper.equations import equation
from restitution.paper.item import Item, judged, number, scene, shown
from restitution.paper.samples import (
    FRICTION,
    KAPPA,
    ROUNDING,
    SEED,
    SLOPE,
    SOLVER,
    STEEL,
    largest,
    maximum,
    motions,
    over_psi,
    solved,
    steel,
)
from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Velocities

GOOD_ACCURACY = 0.05
"""What we take "in good accuracy by zero" to allow, for the paper does not say."""


def _capped_spring(which: int, printed: str, **options: str) -> Item:
    """Return what is said of Eqs. 17 and 23: the same equations before and after scaling."""
    force = largest(lambda at: np.abs(at.acceleration + at.force))
    stretch = largest(lambda at: np.abs(at.spring_rate - at.velocity) * (at.sliding == 0.0))
    free, events = solved("free"), solved()
    apart = np.abs(free.solver - free.exact)
    worst = int(np.argmax(apart))
    agrees = float(np.max(np.abs(events.solver - events.exact)))
    return equation(
        which,
        "4.2",
        printed,
        "The force needs the sign of the spring, sgn(z) min(…, κ|z|), and the spring must be "
        f"held at the cap while it slides: then ε_t is ours within {number(agrees, 1)}. Followed "
        "as printed, with a spring that is never reset, the same equations give ε_t = "
        f"{number(float(free.solver[worst]))} instead of {number(float(free.exact[worst]))} at κ "
        f"= {number(float(free.kappa[worst]), 2)}, ψ = {number(float(free.psi[worst]), 2)}",
        judged(
            printed=bool(np.all(apart < SOLVER)),
            corrected=agrees < SOLVER and max(force, stretch) < SLOPE,
        ),
        "An adaptive solver (DOP853) on four collisions, once as printed, once with each switch "
        f"located; and difference quotients in 60 collisions, off by {number(force, 1)}. The text "
        "after the equation states both corrections in words; bars and signs may also have been "
        "lost in the text at hand.",
        shown(float(free.kappa[worst]), float(free.psi[worst]), **options),
    )


def equation_17() -> Item:
    """Return the equations of motion."""
    return _capped_spring(
        17,
        "d²ξ/dt² + βξ^{3/2} = 0, d²ζ/dt² + min(μβξ^{3/2}/α, k_tζ/(αm_{eff})) = 0, from ξ = "
        "ζ = 0, dξ/dt = g_n, dζ/dt = g_t",
    )


def equation_18() -> Item:
    """Return β."""
    at = scales(steel(), 1.0)
    modulus = 2.0 * STEEL.youngs_modulus_pa / (3.0 * (1.0 - STEEL.poisson_ratio**2))
    as_printed = modulus * at.pair.effective_radius_m**0.5 / at.pair.effective_mass_kg
    ratio = as_printed / at.beta
    return equation(
        18,
        "4.2",
        "β = 2Y/(3(1 − ν²)) · √R_{eff}/m_{eff}",
        f"β = {number(as_printed, 6)} m^{{−1/2}}s^{{−2}} for the steel of Fig. 2; Hertz's "
        f"(4/3)E*√R_{{eff}}/m_{{eff}} gives {number(at.beta, 6)}",
        judged(printed=abs(ratio - 1.0) < ROUNDING),
        "E* is that of two equal materials, Y/(2(1 − ν²)). For unequal ones Eq. 18 says nothing; "
        "the page uses Hertz's.",
        scene(scene="spheres", material="steel"),
    )


def equation_19() -> Item:
    """Return the largest compression."""
    half = normal_curves(np.array([0.5 * CONTACT_DURATION]))
    off = abs(float(half[0, 0]) - MAXIMUM_COMPRESSION) + abs(float(half[1, 0]))
    at = scales(steel(), 20.0)
    return equation(
        19,
        "4.2",
        "ξ_{max} = (5/4)^{2/5} g_n^{4/5}/β^{2/5}",
        f"x_{{max}} = {number(float(half[0, 0]), 6)} where the rate vanishes, (5/4)^{{2/5}} "
        f"within {number(off, 1)}; steel at 20 m/s: {number(1e6 * at.maximum_compression_m, 3)} µm",
        judged(printed=off < ROUNDING),
        "The curve of compression at half the contact; it is interpolated from its inverse, not "
        "from the energy.",
        scene(scene="spheres", normal_velocity_m_s="20"),
    )


def equation_20() -> Item:
    """Return the duration of the contact."""
    nodes, weights = np.polynomial.legendre.leggauss(200)
    # t_c = 2 ∫ dx/ẋ over the compression; with x^{5/2} = (5/4) s², s = sin φ no end is singular
    # but x^{-3/2} dx, which φ = y^{5/4} takes away
    upper = (0.5 * np.pi) ** 0.8
    y = 0.5 * upper * (nodes + 1.0)
    phi = y**1.25
    integrand = 0.8**0.6 * np.sin(phi) ** -0.2 * 1.25 * y**0.25
    duration = 2.0 * float(np.sum(0.5 * upper * weights * integrand))
    off = abs(duration - CONTACT_DURATION)
    times = [scales(steel(), v).contact_duration_s for v in (1.0, 32.0)]
    power = np.log2(times[0] / times[1]) / 5.0
    return equation(
        20,
        "4.2",
        "t_c = C/(β^{2/5} g_n^{1/5}), C a pure number",
        f"C = {number(duration, 7)}, (4/5)^{{3/5}} B(2/5, 1/2); t_c falls as g_n to the power "
        f"−{number(float(power), 4)}",
        judged(printed=off < 1e-8 and abs(float(power) - 0.2) < ROUNDING),
        f"Quadrature of dξ/(dξ/dt), within {number(off, 1)} of the constant in use. The paper "
        "does not give C.",
        scene(scene="spheres"),
    )


def _similar() -> tuple[float, Contact]:
    """Return ε_t and the contact of other spheres, at 3 m/s, that have Fig. 2's scaled numbers."""
    glass = Sphere(0.001, 7e10, 0.22, density_kg_m3=2500.0)
    wanted = scales(steel(), 20.0).kappa
    trial = scales(Contact(glass, glass, FRICTION, 1.0), 3.0).kappa
    contact = Contact(glass, glass, FRICTION, wanted / trial)
    return study_scaling(contact, Velocities(3.0, 1.5)).epsilon_t, contact


def equation_21() -> Item:
    """Return the scales."""
    other, _ = _similar()
    same = study_scaling(steel(), Velocities(20.0, 10.0)).epsilon_t
    at = scales(steel(), 20.0)
    off = abs(at.time_scale_s * at.beta**0.4 * 20.0**0.2 - 1.0)
    off = max(off, abs(at.length_scale_m * at.beta**0.4 / 20.0**0.8 - 1.0))
    return equation(
        21,
        "4.2",
        "t_{scale} = β^{−2/5} g_n^{−1/5}, ξ_{scale} = g_n^{4/5} β^{−2/5}",
        "steel of 2 cm at 20 m/s and glass of 1 mm at 3 m/s, with the same κ, μ/α and g_t/g_n, "
        f"have ε_t = {number(same, 5)} and {number(other, 5)}",
        judged(printed=off < ROUNDING and abs(same - other) < 1e-8),
        f"Both through the scales; κ = {number(at.kappa, 3)} amplifies the rounding of the scaled "
        "numbers.",
        scene(scene="spheres", normal_velocity_m_s="20", tangential_velocity_m_s="10"),
    )


def equation_22() -> Item:
    """Return the initial conditions."""
    at = scales(steel(), 20.0)
    normal_rate = 20.0 * at.time_scale_s / at.length_scale_m
    course = motion(KAPPA, 0.97)
    start = float(tangential_curves(course, np.zeros(1)).velocity[0])
    off = max(abs(normal_rate - 1.0), abs(start - 1.0))
    return equation(
        22,
        "4.2",
        "dx/dt(0) = g_n t_{scale}/ξ_{scale} = 1, dz/dt(0) = g_t/g_n",
        f"g_n t_{{scale}}/ξ_{{scale}} = {number(normal_rate, 6)}; the velocity trace starts at "
        f"{number(start, 6)} of g_t/g_n",
        judged(printed=off < ROUNDING),
        "Steel at 20 m/s, and the exact motion at t = 0.",
        shown(KAPPA, 0.97),
    )


def equation_23() -> Item:
    """Return the scaled equations of motion."""
    return _capped_spring(
        23,
        "d²x/dt² + x^{3/2} = 0, d²z/dt² + min((μ/α)x^{3/2}, κz) = 0, from x = z = 0, dx/dt = "
        "1, dz/dt = g_t/g_n",
        scene="accuracy",
    )


def equation_24() -> Item:
    """Return κ."""
    _, glass = _similar()
    off = 0.0
    for contact, velocity in ((steel(), 20.0), (glass, 3.0)):
        at = scales(contact, velocity)
        mass = at.pair.alpha * at.pair.effective_mass_kg
        # k_t ζ/(α m_eff) of Eq. 17 in units of ξ_scale/t_scale²
        from_equation_17 = at.tangential_stiffness_n_per_m / mass * at.time_scale_s**2
        off = max(off, abs(from_equation_17 / at.kappa - 1.0))
    at = scales(steel(), 20.0)
    return equation(
        24,
        "4.2",
        "κ = k_t/(α m_{eff} β^{4/5} g_n^{2/5})",
        f"scaling Eq. 17 gives this κ, with α in it, within {number(off, 1)}: "
        f"{number(at.kappa, 6)} for steel at 20 m/s; without α it would be "
        f"{number(at.kappa * at.pair.alpha, 6)}",
        judged(printed=off < ROUNDING),
        "Two contacts. Figs. 4 and 5 use another κ, see there.",
        scene(scene="spheres", normal_velocity_m_s="20", tangential_velocity_m_s="10"),
    )


class Stiff(NamedTuple):
    """The largest |ε_t| over Eq. 27 of many collisions, and where."""

    excess: float
    kappa: float
    psi: float


@functools.cache
def largest_over_estimate() -> Stiff:
    """Return where |ε_t| is largest over 1/(ψ√κ), for ψ < 2."""
    excess, where = maximum(
        lambda kappas, psis: np.abs(collide(kappas, psis).epsilon_t) / stiff_estimate(kappas, psis),
        np.geomspace(0.3, 300.0, 300),
        np.linspace(0.02, 1.999, 300),
    )
    return Stiff(excess, *where)


@functools.cache
def largest_spring() -> float:
    """Return the largest κ|z| of springs that were at the cap, in units of μ/α."""
    caps = [float(np.max(course.force)) for course in motions() if course.switches]
    random = np.random.default_rng(SEED)
    psis = random.uniform(0.6, 1.2, 300).tolist()
    return max([*caps, *(float(np.max(motion(KAPPA, psi).force)) for psi in psis)])


def equation_25() -> Item:
    """Return the largest energy of the spring."""
    reached = largest_spring()
    return equation(
        25,
        "4.4",
        "E_{max} = κz_{max}²/2 = μ²/(2α²κ), with z_{max} = μ/(ακ)",
        f"the spring is pulled to {number(reached, 5)} μ/(ακ) and holds {number(reached**2, 4)} "
        "times the energy: z_{max} lacks the factor x_{max}^{3/2} = (5/4)^{3/5} = "
        f"{number(MAXIMUM_FORCE, 5)}",
        judged(printed=reached <= 1.0, corrected=reached <= MAXIMUM_FORCE),
        "The springs of 360 collisions at their switches. The paper drops numerical factors when "
        "it scales (Eq. 21) and the cap's largest value with them.",
        shown(KAPPA, 1.0),
    )


def _bound(which: int, printed: str) -> Item:
    """Return what is said of Eqs. 26 and 27, which differ by the factor g_t."""
    excess, kappa, psi = largest_over_estimate()
    return equation(
        which,
        "4.4",
        printed,
        f"exceeded by {number(100.0 * (excess - 1.0), 2)} % at κ = {number(kappa, 3)}, ψ = "
        f"{number(psi, 3)}; with (5/4)^{{3/5}} = {number(MAXIMUM_FORCE, 5)} on the right it is a "
        "bound on |ε_t| for ψ < 2",
        judged(printed=excess <= 1.0, corrected=excess <= MAXIMUM_FORCE),
        "90,000 collisions with κ in 0.3…300 and ψ in 0.02…2, exact each, and more about the "
        "largest. That the corrected "
        f"bound holds everywhere is proven for κ ≥ {number(MONOTONE_STIFFNESS, 4)} and measured "
        "below; for ψ ≥ 2 it says nothing. The text at hand has no bars around ε_t.",
        shown(kappa, psi),
    )


def equation_26() -> Item:
    """Return the bound on the final velocity."""
    return _bound(26, "|g_t′| ≤ g_n μ/(α√κ)")


def equation_27() -> Item:
    """Return the bound on ε_t."""
    return _bound(27, "ε_t ≤ (g_n/g_t) μ/(α√κ)")


def equation_28() -> Item:
    """Return from which velocity on the spring can be loaded."""
    kappas = np.geomspace(20.0, 2000.0, 25)
    fullest = 0.0
    for kappa in kappas.tolist():
        # ψ at which the printed energies are equal
        course = motion(kappa, 1.0 / np.sqrt(kappa))
        curves = tangential_curves(course, np.linspace(0.0, course.duration, 2000))
        load = kappa * course.psi * float(np.max(np.abs(curves.elongation)))
        fullest = max(fullest, load / MAXIMUM_FORCE)
    return equation(
        28,
        "4.4",
        "g_t ≥ g_n μ/(α√κ): otherwise the motion has not the energy to load the spring fully",
        "necessary, but not enough: at g_t = g_nμ/(α√κ) the spring gets to "
        f"{number(100.0 * fullest, 3)} % of its largest load: for a full one the initial energy "
        f"suffices from (5/4)^{{3/5}} = {number(MAXIMUM_FORCE, 5)} times this g_t on, the factor "
        "that Eq. 25 lacks",
        judged(printed=largest_spring() <= 1.0, corrected=fullest < 1.0 and largest_spring() > 1.0),
        "25 springs with κ in 20…2000; energy conservation allows 1/(5/4)^{3/5} = "
        f"{number(100.0 / MAXIMUM_FORCE, 3)} %. As the printed Eqs. 25 and 28 go together, so do "
        "the corrected ones.",
        shown(100.0, 0.1),
    )


def equation_29() -> Item:
    """Return from which velocity on the motion does not stop."""
    random = np.random.default_rng(SEED)
    kappas = 10.0 ** random.uniform(-1.0, 3.0, 200)
    above = [motion(k, p) for k, p in zip(kappas, random.uniform(2.0, 4.0, 200), strict=True)]
    turned = sum(reversals(course) for course in above)
    stuck = sum(course.switches > 0 for course in above)
    just_below = [reversals(motion(kappa, 1.999)) for kappa in (0.6, 3.0, 18.0, KAPPA, 1000.0)]
    return equation(
        29,
        "4.4",
        "no stopping if g_t ≥ 2μg_n/α",
        f"200 collisions with ψ from 2 to 4: {turned} turn round; {stuck} soft ones do stick for "
        f"a while. At ψ = 1.999 all of five from κ = 0.6 to 1000 turn ({min(just_below)} time or "
        "more)",
        judged(printed=turned == 0 and min(just_below) > 0),
        "The cap takes at most 2μg_n/α from g_t, whatever the spring does: that is exact, not a "
        "rough estimate.",
        shown(KAPPA, 2.0),
    )


@functools.cache
def plateau(kappa: float) -> float:
    """Return the largest |ε_t| over the range of Eq. 30, ψ from 1/√κ to 2."""
    psis = np.geomspace(1.0 / np.sqrt(kappa), 2.0, 1000)
    return maximum(lambda psi: np.abs(over_psi(kappa)(psi)), psis)[0]


def equation_30() -> Item:
    """Return the range in which ε_t is zero for practical purposes."""
    kappas = (KAPPA, 100.0, 1000.0, 1e4)
    worst = [plateau(kappa) for kappa in kappas]
    listed = ", ".join(
        f"{number(w, 2)} ({number(kappa, 1 if kappa > 99.0 else 2)})"
        for w, kappa in zip(worst, kappas, strict=True)
    )
    return equation(
        30,
        "4.4",
        "for large κ and g_nμ/(α√κ) ≪ g_t ≤ 2μg_n/α, ε_t is zero in good accuracy",
        f"largest |ε_t| in this range, taken from its lower end on, and (κ): {listed}",
        judged(
            printed=max(worst[2:]) < GOOD_ACCURACY,
            corrected=worst[-1] < GOOD_ACCURACY,
        ),
        "1000 collisions each, and more about the largest; good accuracy is taken as "
        f"{GOOD_ACCURACY} from κ = 1000 on, for the paper names neither number. The lower sign is "
        "read as ≪; even at g_t = g_nμ/(α√κ) itself it holds, while Eq. 27 allows |ε_t| = 1 there.",
        shown(1000.0, 0.5, map="epsilon_t", scale="log"),
    )


SCALED_EQUATIONS = (
    equation_17, equation_18, equation_19, equation_20, equation_21, equation_22, equation_23,
    equation_24, equation_25, equation_26, equation_27, equation_28, equation_29, equation_30,
)  # fmt: skip
