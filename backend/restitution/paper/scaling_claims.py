"""Claims of Sects. 4.1 and 4.2: the steel spheres, damping, scaling."""

import functools

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.hertz import CONTACT_DURATION, FloatArray
from restitution.mechanics.limits import coulomb_restitution
from restitution.methods.exact import known
from restitution.paper.figures import FASTEST, SAME, steel_surface
from restitution.paper.item import Item, judged, number, scene, shown
from restitution.paper.samples import (
    KAPPA,
    MU_OVER_ALPHA,
    PRINTED_KAPPA,
    SEED,
    last,
    maximum,
    motions,
    normal,
    steel,
    stepped,
)
from restitution.paper.scaled_equations import GOOD_ACCURACY, plateau
from restitution.paper.sliding_claims import claim
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Velocities


def resembles_coulomb() -> Item:
    """Return whether Fig. 2 resembles Fig. 1."""
    surface = steel_surface()
    apart = np.abs(surface.epsilon_t - surface.coulomb)
    alike = float(np.mean(apart < SAME))
    return claim(
        "resembles-coulomb",
        "4.1",
        "ε_t(g_n, g_t) of Fig. 2 resembles Coulomb's law in a wide range of velocities",
        f"within {SAME} at {number(100.0 * alike, 3)} % of 3600 velocities; on average "
        f"{number(float(apart.mean()), 1)} apart",
        judged(printed=alike > 0.9),
        f"60 × 60 velocities up to {FASTEST:g} m/s. It is so because κ is at least "
        f"{number(scales(steel(), FASTEST).kappa, 4)} there.",
        scene(scene="spheres", velocity_law="coulomb"),
    )


def deviates_at_small_tangential_velocity() -> Item:
    """Return where Fig. 2 deviates."""
    at = scales(steel(), 100.0)
    psis = np.geomspace(1e-5, 2.0, 4000)

    def apart(psi: FloatArray) -> np.ndarray:
        return np.abs(collide(at.kappa, psi).epsilon_t - coulomb_restitution(psi)) > SAME

    ratio = MU_OVER_ALPHA * last(apart, psis)
    below = MU_OVER_ALPHA * last(lambda psi: collide(at.kappa, psi).epsilon_t < -SAME, psis)
    return claim(
        "deviates-at-small-gt",
        "4.1",
        "significant deviations only in the region of small g_t, where ε_t also is negative",
        f"at g_n = 100 m/s (κ = {number(at.kappa, 4)}) more than {SAME} apart only for g_t < "
        f"{number(100.0 * ratio, 2)} m/s; below −{SAME} for g_t < {number(100.0 * below, 2)} m/s",
        judged(printed=ratio < 0.1 and below <= ratio),
        "4000 collisions down to g_t = 1 mm/s, and more about these places.",
        scene(scene="spheres", normal_velocity_m_s="100", tangential_velocity_m_s="0.5"),
    )


def plateau_without_cut_off() -> Item:
    """Return that the plateau comes from the motion."""
    kappa = scales(steel(), 100.0).kappa
    psis = np.geomspace(0.1, 1.99, 1000)
    highest, _ = maximum(lambda psi: np.abs(collide(kappa, psi).epsilon_t), psis)
    return claim(
        "plateau-without-cut-off",
        "4.1",
        "the plateau ε_t ≈ 0 comes from the dynamics, not from a cut-off",
        f"|ε_t| ≤ {number(highest, 1)} for ψ in 0.1…1.99 at g_n = 100 m/s, where Eq. 15 would "
        f"have {number(1.0 - 2.0 / 0.1, 2)} … −0.005",
        judged(printed=highest < SAME),
        "1000 exact collisions, and more about the largest. What cuts off is the dissipation of "
        "the last swings, see Eq. 27.",
        scene(scene="spheres", normal_velocity_m_s="100", tangential_velocity_m_s="100"),
    )


@functools.cache
def _damped_sample(eta: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    random = np.random.default_rng(SEED)
    kappas = 10.0 ** random.uniform(-0.3, 2.6, 1000)
    psis = 10.0 ** random.uniform(-1.7, 0.34, 1000)
    damped, free = collide(kappas, psis, eta), collide(kappas, psis)
    return damped.switches, known(damped), free.epsilon_t


def damping_only_lengthens() -> Item:
    """Return what damping changes."""
    eta = 0.3
    switches, damped, free = _damped_sample(eta)
    odd = float(np.mean(switches % 2 == 1))
    starts = float(np.mean([course.direction[0] == 0 for course in motions(eta)]))
    apart = float(np.median(np.abs(damped - free)))
    longer = contact_duration(eta) / CONTACT_DURATION
    return claim(
        "damping-only-changes-duration",
        "4.2",
        "A > 0 changes the duration of the contact; otherwise the system behaves as for A = 0",
        f"for η = {eta:g} the contact lasts {number(longer, 3)} times as long, ε_t moves by "
        f"{number(apart, 1)} in the median; but {number(100.0 * starts, 3)} % of the contacts "
        f"then start sticking, and {number(100.0 * odd, 3)} % have an odd number of switches, "
        "where A = 0 has none of either",
        judged(printed=starts == 0.0 and odd == 0.0),
        "1000 random collisions, 60 courses. With damping F_n rises as √t, above the spring, "
        "which rises as t. In doubt: whether “quantitative changes” was meant to cover this.",
        shown(KAPPA, 0.97, damping="0.3"),
    )


def no_interference() -> Item:
    """Return whether the motions interfere."""
    eta = 0.3
    _, damped, free = _damped_sample(eta)
    turned = float(np.mean(damped * free < 0.0))
    apart = float(np.max(np.abs(damped - free)))
    return claim(
        "no-interference",
        "4.2",
        "normal and tangential forces are perpendicular and do not interfere",
        "the tangential motion leaves the normal one alone, but the normal force is the cap of "
        f"the tangential one: with η = {eta:g} ε_t changes by up to {number(apart, 2)} and its "
        f"sign in {number(100.0 * turned, 2)} % of 1000 collisions",
        judged(printed=apart < SAME, corrected=turned < 0.5),
        "Exact collisions with and without damping. One way only: Eq. 2 contains nothing "
        "tangential.",
        shown(KAPPA, 0.17, damping="0.3"),
    )


def three_parameters() -> Item:
    """Return that three scaled parameters suffice."""
    first = steel(stiffness=5e7)
    worst = 0.0
    for velocity, ratio in ((2.0, 0.7), (15.0, 1.6)):
        other = steel(stiffness=5e7 * (3.0 / velocity) ** 0.4)
        assert abs(scales(other, 3.0).kappa / scales(first, velocity).kappa - 1.0) < 1e-9
        pair = _in_si(first, velocity, ratio), _in_si(other, 3.0, ratio)
        worst = max(worst, abs(pair[0] - pair[1]))
    return claim(
        "three-parameters",
        "4.2",
        "five parameters and two velocities reduce to three: μ/α, κ, g_t/g_n",
        f"impacts in SI units with the same three have the same ε_t within {number(worst, 1)}",
        judged(printed=worst < 1e-9),
        "Two pairs of impacts at 2, 15 and 3 m/s with k_t adapted, Eq. 17 in 2000 time steps of "
        "newtons, metres and seconds.",
        scene(scene="spheres"),
    )


def _in_si(contact: Contact, g_n: float, gt_over_gn: float) -> float:
    """Return ε_t of an impact in time steps of Eq. 17, in newtons, metres and seconds."""
    both = contact.pair
    inertia = both.alpha * both.effective_mass_kg
    at = scales(contact, g_n)
    depth, rate, forces = 0.0, g_n, []
    dt = at.contact_duration_s / 2000
    for _ in range(2000):
        rate -= dt * at.beta * max(depth, 0.0) ** 1.5
        depth += dt * rate
        forces.append(both.effective_mass_kg * at.beta * max(depth, 0.0) ** 1.5)
    caps = contact.friction_coefficient / inertia * np.array(forces)
    stiffness = at.tangential_stiffness_n_per_m / inertia
    final, _ = stepped(stiffness, gt_over_gn * g_n, np.full(2000, dt), caps)
    return final / (gt_over_gn * g_n)


def three_independent() -> Item:
    """Return that even two suffice."""
    dts = np.full(2000, CONTACT_DURATION / 2000)
    force = normal(0.0, np.minimum(np.cumsum(dts), CONTACT_DURATION))[2]
    final = []
    for friction in (0.35, 1.4, 3.5):
        velocity, _ = stepped(KAPPA, friction * 0.97, dts, friction * force)
        final.append(velocity / (friction * 0.97))
    worst = max(final) - min(final)
    at = scales(steel(0.1, 5e7), 10.0)
    rough = study_scaling(steel(0.1, 5e7), Velocities(10.0, 3.5)).epsilon_t
    smooth_pair = study_scaling(steel(0.4, 5e7), Velocities(10.0, 14.0)).epsilon_t
    worst = max(worst, abs(rough - smooth_pair))
    return claim(
        "three-independent",
        "4.2",
        "the problem has three independent parameters",
        "two: z and g_t divided by μ/α leave κ and ψ = (α/μ)(g_t/g_n). Steel with μ = 0.1 at 3.5 "
        f"m/s and μ = 0.4 at 14 m/s has ε_t = {number(rough, 6)} and {number(smooth_pair, 6)} (κ "
        f"= {number(at.kappa, 3)})",
        judged(printed=worst > 1e-6, corrected=worst < 1e-9),
        "Eq. 23 in 2000 time steps with all three, μ/α = 0.35, 1.4, 3.5, and the impacts differ "
        f"by {number(worst, 1)} at most. Three suffice, but μ/α only stretches the axis of "
        "g_t/g_n.",
        shown(KAPPA, 0.97, map_y="psi"),
    )


def oscillations() -> Item:
    """Return where ε_t oscillates."""
    kappas = np.linspace(0.1, 400.0, 8000)
    weak = collide(kappas, 0.003).epsilon_t
    strong = collide(kappas, 1.5).epsilon_t
    turns = [int(np.sum(values[1:] * values[:-1] < 0.0)) for values in (weak, strong)]
    size, _ = maximum(
        lambda kappa: np.abs(collide(kappa, 1.5).epsilon_t), kappas[kappas > PRINTED_KAPPA]
    )
    return claim(
        "oscillations",
        "4.2",
        "for small g_t/g_n or large κ the plot reveals the typical oscillations",
        f"along κ = 0.1…400 ε_t changes its sign {turns[0]} times at ψ = 0.003 and {turns[1]} "
        f"times at ψ = 1.5, there within ±{number(size, 1)} from κ = 18 on",
        judged(printed=min(turns) > 3),
        "8000 collisions each. At small ψ it is cos(√κ t_c) in the limit.",
        shown(30.0, 0.01, scale="log"),
    )


def small_at_large_velocities() -> Item:
    """Return where ε_t is small, and for which large velocities it is not."""
    psis = np.array([2.0, 2.5, 5.0, 20.0])
    values = collide(KAPPA, psis).epsilon_t
    listed = ", ".join(
        f"{number(value, 2)} ({number(psi * MU_OVER_ALPHA, 2)})"
        for psi, value in zip(psis, values, strict=True)
    )
    level = plateau(1000.0)
    return claim(
        "small-at-large-velocities",
        "4.2",
        "for sufficiently large g_t or g_n ε_t is very small, ε_t ≈ 0",
        "|ε_t| is small for g_t/g_n from about μ/(α√κ) up to 2μ/α (Eq. 30), below "
        f"{number(level, 2)} at κ = 1000: large g_n lead into that range, large g_t out of it, ε_t "
        f"= {listed} at g_t/g_n in brackets, and 1 for g_t → ∞",
        judged(
            printed=float(np.max(values)) < SAME,
            corrected=level < GOOD_ACCURACY and abs(float(values[0])) < SAME,
        ),
        f"Exact, κ = {number(KAPPA, 2)}; it is Eq. 15 from 2μ/α on.",
        shown(KAPPA, 2.8),
    )


SCALING_CLAIMS = (
    resembles_coulomb,
    deviates_at_small_tangential_velocity,
    plateau_without_cut_off,
    damping_only_lengthens,
    no_interference,
    three_parameters,
    three_independent,
    oscillations,
    small_at_large_velocities,
)
