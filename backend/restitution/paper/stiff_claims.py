"""Claims of Sect. 4.4: stiff springs, Fig. 6, the end of damped contacts."""

import functools
from typing import NamedTuple

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.contact import contact_duration, largest_force
from restitution.mechanics.hertz import CONTACT_DURATION, HALF_CONTACT, MAXIMUM_FORCE, FloatArray
from restitution.mechanics.limits import (
    FROM_TWO_ON,
    STIFF_ASYMPTOTE,
    sliding_threshold,
    stiff_estimate,
)
from restitution.mechanics.motion import motion, reversals
from restitution.paper.figures import FIGURE_6, first_stop
from restitution.paper.item import Item, judged, number, shown
from restitution.paper.samples import (
    KAPPA,
    many,
    maximum,
    motions,
    normal,
    stepped,
)
from restitution.paper.scaled_equations import (
    largest_over_estimate,
    plateau,
)
from restitution.paper.sliding_claims import claim

STIFF = (100.0, 1000.0, 1e4, 1e5)


@functools.cache
def largest_scaled(kappa: float) -> float:
    """Return the largest |ε_t|ψκ^{5/4} of a κ, over ψ from 1/√κ to 2."""
    psis = np.geomspace(1.0 / np.sqrt(kappa), 1.999, 1000)
    return float(maximum(lambda p: np.abs(collide(kappa, p).epsilon_t) * p, psis)[0] * kappa**1.25)


def limit_is_zero() -> Item:
    """Return the limit of stiff springs."""
    worst = [plateau(kappa) for kappa in STIFF]
    scaled = [largest_scaled(kappa) for kappa in STIFF]
    return claim(
        "limit-is-zero",
        "4.4",
        "|ε_t| → 0 for κ → ∞, in the range of Eq. 30",
        f"largest |ε_t| {', '.join(number(value, 2) for value in worst)} at κ = 10², 10³, 10⁴, "
        "10⁵. It falls as κ^{−5/4}, faster than Eq. 27 says: |ε_t|ψκ^{5/4} ≤ "
        f"{', '.join(number(value, 4) for value in scaled)}, towards {STIFF_ASYMPTOTE}",
        judged(printed=bool(np.all(np.diff(worst) < 0.0)) and worst[-1] < 1e-3),
        "1000 collisions each, and more about the largest. The constant is the largest (τ + "
        "π/2)^{3/2} − (2/5)τ^{5/2}: the last free swing ends about 2/√κ before the contact.",
        shown(1000.0, 0.5, scale="log"),
    )


def upper_limit() -> Item:
    """Return whether Eq. 25 is an upper limit."""
    excess, kappa, psi = largest_over_estimate()
    damped = max(
        maximum(
            lambda kappas, psis, eta=eta: (
                np.abs(collide(kappas, psis, eta).epsilon_t)
                * (psis * np.sqrt(kappas) / largest_force(eta))
            ),
            np.geomspace(2.0, 400.0, 100),
            np.linspace(0.02, 1.3, 100),
        )[0]
        for eta in (0.05, 0.3)
    )
    return claim(
        "upper-limit",
        "4.4",
        "the estimate by Eq. 25, being an upper limit, stays correct, with damping too",
        f"without damping exceeded {number(excess, 4)}-fold; with the largest cap in it, "
        f"{number(MAXIMUM_FORCE, 5)} for A = 0 and the damped force's own for A > 0, it is kept: "
        f"at most {number(damped, 3)} of it for η = 0.05 and 0.3",
        judged(printed=excess <= 1.0, corrected=excess <= MAXIMUM_FORCE and damped <= 1.0),
        "The collisions of Eq. 27, and 20,000 damped ones with κ in 2…400 and ψ < 1.3.",
        shown(kappa, psi),
    )


class Ends(NamedTuple):
    """How damped contacts end, for three conventions of the end."""

    sticking_at_no_force: float
    """Share that ends sticking where the force vanishes."""
    sticking_under_attraction: float
    """Share that does at ξ = 0, with the cap μ|F_n| of a force that attracts at last."""
    without_force: float
    """Share of the contact up to ξ = 0 in which Eq. 1 has no force."""
    courses: int


def _attracting(eta: float) -> tuple[FloatArray, FloatArray]:
    """Return steps and |F_n| of a contact that ends at ξ = 0, Eq. 1 taken without max[0, …].

    The steps become as (time left)², for the force ends there as √(time left).
    """
    # the scaled equation of motion in R = √x: with dt = 2R dτ it has no singularity at ξ = 0
    rate = float(normal(eta, np.array([contact_duration(eta)]))[1, 0])
    x = -eta * rate
    root, dtau, elapsed = np.sqrt(x), 1e-4, 0.0
    times, forces = [], []
    while root > 0.0:
        force = root**3 + eta * root * rate
        root, rate = root + dtau * rate, rate - 2.0 * dtau * root * force
        elapsed += 2.0 * max(root, 0.0) * dtau
        times.append(elapsed)
        forces.append(abs(force))
    duration = contact_duration(eta)
    early = np.linspace(0.0, duration, 1500)[1:]
    chosen = slice(None, None, max(1, len(times) // 1500))
    time = np.concatenate([[0.0], early, duration + np.array(times)[chosen]])
    caps = np.concatenate([normal(eta, early)[2], np.array(forces)[chosen]])
    return np.diff(time), caps


@functools.cache
def ends(eta: float = 0.3) -> Ends:
    """Return how contacts with damping end; random κ in .5…400, ψ in .02…2.2."""
    courses = motions(eta)
    sticking = float(np.mean([course.direction[-1] == 0 for course in courses]))
    dts, caps = _attracting(eta)
    last = []
    for course in courses[:20]:
        _, capped = stepped(course.kappa, course.psi, dts, caps)
        # the last but one: at the very end the cap is nothing
        last.append(not capped[-2])
    return Ends(sticking, float(np.mean(last)), eta / (eta + contact_duration(eta)), len(courses))


def damped_end() -> Item:
    """Return whether a damped collision may end sticking."""
    found = ends()
    share = (found.sticking_at_no_force, found.sticking_under_attraction)
    return claim(
        "footnote-3-ends-sticking",
        "4.4",
        "footnote 3: with normal damping there is a range of initial conditions for which the "
        "collision ends in the Cundall-Strack regime",
        f"ended where F_n vanishes, {number(100.0 * share[0], 2)} % of {found.courses} end "
        "sticking. Ended at ξ = 0, Eq. 1 has no force in the last "
        f"{number(100.0 * found.without_force, 2)} % of the contact: the cap is zero, the spring "
        "empty, neither regime. With a force that attracts there (Eq. 1 without its max) "
        f"{number(100.0 * share[1], 2)} % end sticking",
        judged(printed=max(share) > 0.0),
        "η = 0.3; exact motion, and 3000 time steps for 20 attracting contacts. In each "
        "convention the cap falls to zero at last, and a spring with any load meets it before. "
        "In doubt: what the authors integrated. It is the beginning that damping makes sticking.",
        shown(KAPPA, 1.0, damping="0.3"),
    )


def actual_limit_is_smaller() -> Item:
    """Return the actual limit of pure sliding."""
    kappas = np.geomspace(0.05, 1e4, 2000)
    limit = sliding_threshold(kappas)
    soft = float(limit[0])
    stops = [reversals(motion(kappa, 1.999)) > 0 for kappa in (FROM_TWO_ON, 5.0, 1000.0)]
    return claim(
        "actual-limit-is-smaller",
        "4.4",
        "the actual limit of pure Coulomb friction is even smaller than g_t = 2μg_n/α (Eq. 29)",
        f"it is ψ* = {number(float(limit.min()), 6)} for every κ ≥ {number(FROM_TWO_ON, 4)}, and "
        f"larger below ({number(soft, 3)} at κ = 0.05): never smaller",
        judged(printed=float(limit.max()) < 2.0),
        f"2000 thresholds; just below, at ψ = 1.999, {sum(stops)} of 3 contacts stop. The last "
        "bit of the fall of the cap suffices to stop what is slow enough.",
        shown(KAPPA, 1.999, map="switches"),
    )


def much_smaller() -> Item:
    """Return the final velocity against Eq. 27."""
    ratios = []
    for kappa in STIFF[:3]:
        psis = np.linspace(1.0 / np.sqrt(kappa), 1.999, 2000)
        estimate = stiff_estimate(kappa, psis)
        ratios.append(float(np.median(np.abs(collide(kappa, psis).epsilon_t) / estimate)))
    return claim(
        "much-smaller-than-estimate",
        "4.4",
        "by the many episodes of sliding the final velocity is actually much smaller than Eq. 27",
        f"in the median {', '.join(number(ratio, 2) for ratio in ratios)} of it at κ = 100, 1000, "
        f"10^{{4}}; at its largest {STIFF_ASYMPTOTE} κ^{{−3/4}}",
        judged(printed=max(ratios) < 0.5),
        "2000 collisions each over the range of Eq. 30.",
        shown(1000.0, 0.5, scale="log"),
    )


def overestimates() -> Item:
    """Return Fig. 6's minimum against the final velocity."""
    stop = first_stop(*FIGURE_6, 1.0)
    estimate = 1.0 / np.sqrt(FIGURE_6[0])
    ratio = abs(stop.velocity / stop.final)
    return claim(
        "figure-6-overestimates",
        "4.4",
        "Eq. 26 (the first minimum of Fig. 6) grossly overestimates the final velocity",
        f"Eq. 26 gives {number(estimate, 2)} g_n, the minimum is {number(stop.velocity, 2)}, the "
        f"final velocity {number(stop.final, 2)}: {number(ratio, 2)} times less",
        judged(printed=ratio > 3.0 and abs(stop.velocity) <= estimate * MAXIMUM_FORCE),
        "κ = 100, g_t/g_n = 0.3, and μ/α = 1, which the caption does not give.",
        shown(*FIGURE_6, 1.0),
    )


def stops_near_the_maximum() -> Item:
    """Return when Fig. 6's motion stops."""
    stop = first_stop(*FIGURE_6, 1.0)
    frictions = np.linspace(0.2, 2.0, 91).tolist()
    both = [
        friction
        for friction in frictions
        for found in [first_stop(FIGURE_6[0], FIGURE_6[1], friction)]
        if abs(found.stop / HALF_CONTACT - 1.0) < 0.1 and 1.0 < found.minimum < 1.2
    ]
    return claim(
        "figure-6-stops-near-the-maximum",
        "4.4",
        "Fig. 6: the tangential motion is stopped near the point of largest compression",
        f"with μ/α = 1 at t = {number(stop.stop, 3)}, "
        f"{number(100.0 * stop.stop / HALF_CONTACT, 2)} % of the way to the largest compression "
        f"at {number(HALF_CONTACT, 4)}. Of 91 μ/α from 0.2 to 2 {len(both)} have both a stop "
        "within 10 % of it and a first minimum shortly after t = 1",
        judged(printed=bool(both)),
        "The velocity has its first minimum after it stopped, so both statements of the paper "
        f"contradict each other for κ = 100: 1 comes long before {number(HALF_CONTACT, 4)}.",
        shown(*FIGURE_6, 1.0),
    )


def many_subsequent_episodes() -> Item:
    """Return how often Fig. 6's contact slides after the stop."""
    course = first_stop(*FIGURE_6, 1.0).course
    sliding = int(np.sum(course.direction[1:] != 0))
    stiffer = first_stop(350.0, FIGURE_6[1], 0.9).course
    return claim(
        "figure-6-many-episodes",
        "4.4",
        "Fig. 6: after the stop there are many subsequent episodes of Coulomb sliding",
        f"{sliding} with μ/α = 1, {course.switches} switches in all",
        judged(printed=sliding >= 3),
        "We take three for many. With κ = 350 and μ/α = 0.9, which also fits the figure's text, "
        f"there are {int(np.sum(stiffer.direction[1:] != 0))}.",
        shown(*FIGURE_6, 1.0),
    )


def no_contradiction() -> Item:
    """Return that the velocity never grows."""
    sample = many()
    most = float(np.max(np.abs(sample.result.epsilon_t)))
    return claim(
        "no-contradiction",
        "4.4",
        "Eqs. 26 and 28 together lead to |g_t′| ≤ g_t, trivial but correct",
        f"largest |ε_t| of 20,000 random collisions: {number(most, 6)}",
        judged(printed=most <= 1.0),
        "From the energy as well. The step through Eq. 26 has its missing factor.",
        shown(KAPPA, 0.01),
    )


def switch_count() -> Item:
    """Return the rate at which episodes of sliding multiply."""
    kappas = np.array([100.0, 1000.0, 1e4])
    psis = np.linspace(0.02, 1.999, 1500)
    most = np.array([float(collide(kappa, psis).switches.max()) for kappa in kappas])
    law = np.sqrt(kappas) * CONTACT_DURATION / np.pi
    return claim(
        "many-episodes-when-stiff",
        "4.4",
        "for high tangential stiffness there are many episodes of Coulomb sliding",
        f"up to {', '.join(f'{m:g}' for m in most)} switches at κ = 100, 1000, 10^{{4}}, beside "
        f"√κ t_c/π = {', '.join(number(value, 3) for value in law)}",
        judged(printed=bool(np.all(np.diff(most) > 0.0)) and most[-1] > 50.0),
        "1500 collisions each.",
        shown(1000.0, 1.2, map="switches"),
    )


STIFF_CLAIMS = (
    limit_is_zero,
    upper_limit,
    damped_end,
    actual_limit_is_smaller,
    much_smaller,
    overestimates,
    stops_near_the_maximum,
    many_subsequent_episodes,
    no_contradiction,
    switch_count,
)
