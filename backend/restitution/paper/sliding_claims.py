"""Claims of Sects. 2 and 3: the limits, the spring, and the contact that slides throughout."""

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.limits import GEAR_WHEEL_STIFFNESS, coulomb_restitution
from restitution.mechanics.motion import motion
from restitution.paper.item import Item, Verdict, judged, number, scene, shown
from restitution.paper.samples import (
    KAPPA,
    MU_OVER_ALPHA,
    ROUNDING,
    largest,
    last,
    many,
    motions,
    normal,
)

SIGNIFICANT = 0.05
"""Change of ε_t for a doubled velocity, in units of ln 2, that we still call significant."""


def claim(
    name: str,
    section: str,
    printed: str,
    computed: str,
    verdict: Verdict,
    evidence: str,
    link: str,
) -> Item:
    """Return what is said of a claim."""
    return Item(f"claim-{name}", "claim", section, printed, computed, verdict, evidence, link)


def smooth() -> Item:
    """Return the limit of smooth spheres."""
    kappas = np.geomspace(0.01, 1e4, 50)
    nearly, values = (collide(kappas, psi).epsilon_t for psi in (1e8, np.inf))
    left = float(np.max(np.abs(1.0 - nearly)))
    return claim(
        "smooth",
        "2",
        "ε_t = 1 for perfectly smooth particles",
        f"ψ = 10^{{8}} leaves 1 − ε_t = {number(left, 1)}, μ = 0 ε_t = "
        f"{number(float(values.min()), 2)}, at 50 κ from 0.01 to 10^{{4}}",
        judged(printed=left < 1e-7 and bool(np.all(values == 1.0))),
        "The limit ψ → ∞ of the exact collision.",
        scene(kappa="63", mu_over_alpha="0", gt_over_gn="1"),
    )


def gear_wheel() -> Item:
    """Return the limit of gear wheels."""
    values = collide(GEAR_WHEEL_STIFFNESS, [0.1, 1e-2, 1e-3]).epsilon_t
    listed = ", ".join(f"−1 + {number(1.0 + value, 1)}" for value in values)
    return claim(
        "gear-wheel",
        "2",
        "ε_t = −1 as for very elastic gear wheels is the other limit",
        f"approached, not reached: at κ = (π/t_c)² = {number(GEAR_WHEEL_STIFFNESS, 5)} ε_t = "
        f"{listed} for ψ = 0.1, 0.01, 0.001",
        judged(printed=float(values[-1]) < -0.999 and float(values.min()) >= -1.0),
        "There half a swing of the spring lasts as long as the contact; some energy is lost in "
        "sliding at both ends.",
        shown(GEAR_WHEEL_STIFFNESS, 1e-3),
    )


def negative_from_the_spring() -> Item:
    """Return what makes ε_t negative."""
    sample = many()
    negative = sample.result.epsilon_t < 0.0
    law = float(coulomb_restitution(sample.psi).min())
    stuck = bool(np.all(sample.result.switches[negative] > 0))
    return claim(
        "negative-from-the-spring",
        "2",
        "the spring stores energy and so the model has negative ε_t",
        f"{number(100.0 * float(np.mean(negative)), 2)} % of 20,000 random collisions have ε_t < "
        f"0, all of them with switches; Coulomb's law has {number(law, 1)} at least",
        judged(printed=bool(negative.any()) and stuck and law >= 0.0),
        "A contact that slides throughout has no negative ε_t (Eq. 15 from ψ = 2 on).",
        shown(GEAR_WHEEL_STIFFNESS, 0.05),
    )


def history() -> Item:
    """Return that the force depends on the history."""
    moment = np.array([2.4])
    psis = np.linspace(0.3, 1.9, 1500).tolist()
    curves = [tangential_curves(motion(KAPPA, psi), moment) for psi in psis]
    velocity = np.array([psi * float(c.velocity[0]) for psi, c in zip(psis, curves, strict=True)])
    force = np.array([float(c.force[0]) for c in curves])
    order = np.argsort(velocity)
    alike = np.diff(velocity[order]) < 1e-4
    apart = float(np.max(np.abs(np.diff(force[order]))[alike]))
    return claim(
        "history",
        "2",
        "F_t depends on the full history of the contact, not only on the present motion",
        "two collisions with the same compression and within 10^{−4} the same velocities at t "
        f"= {number(float(moment[0]), 2)} have forces that differ by {number(apart, 2)} (cap "
        f"there: {number(float(normal(0.0, moment)[2, 0]), 2)})",
        judged(printed=apart > 0.1),
        f"1500 collisions at κ = {number(KAPPA, 2)}, neighbours in g_t compared. The history "
        "enters through one number, the spring.",
        shown(KAPPA, 0.6),
    )


def elongation_while_sliding() -> Item:
    """Return the spring while sliding."""
    off = largest(
        lambda at: np.abs(at.kappa * np.abs(at.elongation) - at.normal_force) * np.abs(at.sliding)
    )
    return claim(
        "elongation-while-sliding",
        "2",
        "while sliding |ζ| = μF_n/k_t",
        f"within {number(off, 1)} at all sliding instants of 60 collisions",
        judged(printed=off < ROUNDING),
        "As for Eq. 10.",
        shown(KAPPA, 0.97),
    )


def independent_of_force_law() -> Item:
    """Return whether Eq. 15 needs the force laws."""
    exact = float(collide(1.0, 3.0).epsilon_t)
    etas = (0.05, 0.3, 1.0)
    off = []
    for eta in etas:
        law = float(coulomb_restitution(3.0, float(-normal(eta, _end(eta))[1, 0])))
        off.append(abs(law - float(collide(1.0, 3.0, eta).epsilon_t)))
    return claim(
        "independent-of-force-law",
        "3",
        "Eq. 15 holds whatever the normal and tangential force laws",
        "for a contact that slides throughout; but with Eq. 10's spring and A > 0 none does. At "
        f"κ = 1, ψ = 3 Eq. 15 is {number(max(off), 1)} off for η up to 1, exact for A = 0 "
        f"({number(exact, 4)})",
        judged(printed=max(off) < ROUNDING, corrected=max(off) < 1e-2),
        "Exact motion with damping, η = 0.05, 0.3, 1. F_n begins as √t there, the spring as t, "
        "so the contact first sticks; the stiffer the spring, the shorter.",
        shown(1.0, 3.0, damping="1"),
    )


def _end(eta: float) -> np.ndarray:
    return np.array([contact_duration(eta)])


def depends_on_both_velocities() -> Item:
    """Return how strongly Eq. 15 depends on the velocities."""
    psis = np.geomspace(2.0, 1000.0, 500)
    change = 1.0 - coulomb_restitution(psis)
    upto = MU_OVER_ALPHA * last(lambda p: 1.0 - coulomb_restitution(p) >= SIGNIFICANT, psis)
    return claim(
        "depends-on-both-velocities",
        "3",
        "ε_t of Eq. 15 depends always significantly on both g_n and g_t",
        "it depends on g_t/g_n alone, with slope ∂ε_t/∂ln g_t = 1 − ε_t: 1 at the cut-off, below "
        f"{SIGNIFICANT} from g_t/g_n = {number(upto, 2)} on (μ/α = {number(MU_OVER_ALPHA, 2)})",
        judged(printed=bool(np.all(change >= SIGNIFICANT)), corrected=upto > 2.0 * MU_OVER_ALPHA),
        f"“Significantly” is taken as a slope of {SIGNIFICANT}: always is too much said, up to "
        "grazing impacts it is so.",
        shown(KAPPA, 3.0),
    )


def sliding_keeps_its_sign() -> Item:
    """Return that sliding throughout means g_t ≥ 0."""
    least = np.inf
    for course in motions(0.0, 400):
        if course.switches == 0:
            time = np.linspace(0.0, course.duration, 300)
            least = min(least, float(np.min(tangential_curves(course, time).velocity)))
    return claim(
        "sliding-keeps-its-sign",
        "3",
        "sliding throughout, g_t ≥ 0 and ε_t ≥ 0",
        f"least g_t/g_t(0) in the contacts among 400 that slide throughout: {number(least, 2)}",
        judged(printed=0.0 <= least < np.inf),
        "Exact motions.",
        shown(KAPPA, 2.1),
    )


SLIDING_CLAIMS = (
    smooth,
    gear_wheel,
    negative_from_the_spring,
    history,
    elongation_while_sliding,
    independent_of_force_law,
    depends_on_both_velocities,
    sliding_keeps_its_sign,
)
