"""Claims of Sect. 4.3: the switches."""

import itertools

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.hertz import HALF_CONTACT
from restitution.mechanics.limits import FROM_TWO_ON, sliding_threshold
from restitution.mechanics.motion import motion
from restitution.paper.figures import SAME, counts_at
from restitution.paper.item import Item, judged, number, shown
from restitution.paper.letter_claims import LOOK, before_eight, ranges
from restitution.paper.samples import (
    KAPPA,
    MU_OVER_ALPHA,
    PRINTED_KAPPA,
    ROUNDING,
    many,
    motions,
    soft_border,
)
from restitution.paper.sliding_claims import claim

EARLY = 1e-8
"""Scaled time at which a contact has only begun."""


def slides_above_three() -> Item:
    """Return from where on every collision slides throughout."""
    kappas = np.linspace(0.02, 63.0, 4000)
    border = sliding_threshold(kappas) * MU_OVER_ALPHA
    return claim(
        "slides-above-three",
        "4.3",
        "for g_t/g_n ≳ 3 the collision takes place entirely in the Coulomb regime, but for very "
        "small κ",
        f"from g_t/g_n = {number(float(border.min()), 3)} on at every κ ≥ "
        f"{number(FROM_TWO_ON, 2)}; at 3 for κ ≥ {number(soft_border(3.0 / MU_OVER_ALPHA), 3)}, at "
        f"4 for κ ≥ {number(soft_border(4.0 / MU_OVER_ALPHA), 3)}",
        judged(printed=bool(np.all(border[kappas > 0.6] <= 3.0))),
        "Threshold ψ* of pure sliding for 4000 κ.",
        shown(1.0, 2.1, **LOOK),
    )


def upper_region_is_zero() -> Item:
    """Return ε_t above g_t/g_n = 3."""
    ratios = np.array([3.0, 3.5, 4.0])
    values = collide(KAPPA, ratios / MU_OVER_ALPHA).epsilon_t
    return claim(
        "upper-region-is-zero",
        "4.3",
        "this region, g_t/g_n ≳ 3, is the upper one of Fig. 3, where ε_t is almost zero",
        f"ε_t = {', '.join(number(value, 2) for value in values)} at g_t/g_n = 3, 3.5, 4 (Eq. "
        f"15); almost zero is the region below {number(2.0 * MU_OVER_ALPHA, 2)}",
        judged(printed=float(np.max(values)) < SAME),
        "The contact that slides throughout keeps the more of its velocity the faster it is. "
        "Perhaps Fig. 3's axis ends near 3.",
        shown(KAPPA, 4.0 / MU_OVER_ALPHA),
    )


def starts_sliding() -> Item:
    """Return how contacts start."""
    courses = motions(0.0, 400)
    share = float(np.mean(np.array([course.direction[0] for course in courses]) == 1))
    # a spring that sticks from the start has κψt, under a cap of t^{3/2}
    least = min(course.kappa * course.psi for course in courses) / np.sqrt(EARLY)
    return claim(
        "starts-sliding",
        "4.3",
        "the motion always starts in the Coulomb regime, for F_n rises as t^{3/2}, the spring as t",
        f"{number(100.0 * share, 3)} % of 400 random collisions do; at t = 10^{{−8}} a spring that "
        f"sticks would pull with at least {number(least, 1)} times the cap",
        judged(printed=share == 1.0 and least > 1.0),
        "For A = 0; with A > 0 it is the other way round, see damping.",
        shown(KAPPA, 0.005),
    )


def ends_sliding() -> Item:
    """Return how contacts end."""
    last = [course.direction[-1] for course in motions(0.0, 400)]
    share = float(np.mean(np.array(last) != 0))
    still = int(collide(KAPPA, 0.0).switches)
    return claim(
        "ends-sliding",
        "4.3",
        "the collision must end in the Coulomb regime, but for the trivial case g_t = 0",
        f"{number(100.0 * share, 3)} % of 400 random collisions do; g_t = 0 has {still} switches",
        judged(printed=share == 1.0 and still == 0),
        "Exact motions, A = 0.",
        shown(KAPPA, 0.005),
    )


def even_number() -> Item:
    """Return the parity of the number of switches."""
    sample = many().result
    odd = int(np.sum(sample.switches[sample.switches_certain] % 2))
    return claim(
        "even-number-of-switches",
        "4.3",
        "the number of switches is always even",
        f"{odd} odd ones among 20,000 random collisions, up to {int(sample.switches.max())} "
        "switches",
        judged(printed=odd == 0),
        "Counted switch by switch, not assumed; A = 0.",
        shown(400.0, 1.0),
    )


def soft_springs_always_stick() -> Item:
    """Return what small κ do."""
    kappas = np.geomspace(0.001, FROM_TWO_ON, 300)
    thresholds = sliding_threshold(kappas)
    rises = bool(np.all(np.diff(thresholds) < 0.0)) and float(thresholds[0]) > 100.0
    just_below = collide(kappas, 0.999 * thresholds).switches
    low, high = (soft_border(border / MU_OVER_ALPHA) for border in (4.0, 2.9))
    width = (high - low) * 2.0 / 7.0 / 20.0
    return claim(
        "soft-springs-always-stick",
        "4.3",
        "for sufficiently small κ a switch always occurs: the vertical line at the left of Fig. 4",
        f"each g_t/g_n has its κ below which the contact sticks: {number(low, 3)} at g_t/g_n = 4, "
        f"{number(high, 3)} at 2.9. The line leans over {number(100.0 * width, 1)} % of the axis "
        "of Fig. 4; for κ → 0 ψκ tends to a constant, "
        f"{number(float(thresholds[0] * kappas[0]), 4)} at κ = 0.001",
        judged(printed=rises and bool(np.all(just_below >= 2)) and width < 0.01),
        "Threshold of pure sliding and the collisions just below it, 300 κ.",
        shown(0.3, 3.0 / MU_OVER_ALPHA, map="switches", map_x="alpha_kappa"),
    )


def elongation_increases() -> Item:
    """Return the spring at the first switch."""
    low = before_eight()[-1].high
    psis = np.linspace(1.999, low, 300).tolist()
    courses = [motion(KAPPA, psi) for psi in psis]
    loads = np.array([float(course.force[1]) for course in courses])
    late = bool(np.all(np.array([course.start[1] for course in courses]) >= HALF_CONTACT))
    return claim(
        "elongation-increases",
        "4.3",
        "the elongation at the first switch increases with decreasing g_t, as all switches lie "
        "in the decompression",
        f"from {number(float(loads[0]), 2)} to {number(float(loads[-1]), 4)} μ/(ακ) for g_t/g_n "
        f"from 2.8 down to {number(low * MU_OVER_ALPHA, 3)}, where eight switches begin",
        judged(printed=bool(np.all(np.diff(loads) > 0.0)) and late),
        f"300 collisions at κ = {number(KAPPA, 2)}, each with its first switch after the largest "
        "compression.",
        shown(KAPPA, 1.6),
    )


def half_as_many_reversals() -> Item:
    """Return how reversals and switches go together."""
    until = before_eight()
    there = all(2 * r.turns == r.switches for r in until)
    everywhere = [2 * r.turns == r.switches for r in ranges(KAPPA)]
    return claim(
        "half-as-many-reversals",
        "4.3",
        "the number of motion reversals is half the number of switches",
        f"so in the first {len(until)} ranges of g_t/g_n at κ = {number(KAPPA, 2)}, down to "
        f"{number(until[-1].low * MU_OVER_ALPHA, 3)}; of all {len(everywhere)} ranges down to "
        f"0.007 in {sum(everywhere)}",
        judged(printed=all(everywhere), corrected=there),
        "Reversals counted in the exact motion. The text says it of the ranges where the spring "
        "cannot complete half a period; its own (f), six switches and four reversals, is outside.",
        shown(KAPPA, 0.69, **LOOK),
    )


def at_most_eight() -> Item:
    """Return the largest number of switches."""
    printed, ours = max(counts_at(PRINTED_KAPPA)), max(counts_at(KAPPA))
    return claim(
        "at-most-eight",
        "4.3",
        "for the chosen κ = 18 the maximum is eight switches",
        f"{printed} at κ = 18, {ours} at κ = {number(KAPPA, 2)}",
        judged(printed=printed == 8, corrected=ours == 8),
        "8000 collisions from ψ = 2.2 to 0.005 each.",
        shown(KAPPA, 0.97, **LOOK),
    )


def decrease_not_monotonic() -> Item:
    """Return how the number decreases."""
    counts = counts_at(KAPPA)
    after = counts[counts.index(max(counts)) :]
    rises = sum(b > a for a, b in itertools.pairwise(after))
    return claim(
        "decrease-not-monotonic",
        "4.3",
        "with decreasing g_t the number of switches decreases, but not monotonically",
        f"after the first eight: {' '.join(map(str, after))}, {rises} rises",
        judged(printed=rises > 0 and after[-1] < after[0]),
        f"κ = {number(KAPPA, 2)}, ψ down to 0.005. The rises never end: towards ψ = 0 twos and "
        "fours alternate.",
        shown(KAPPA, 0.25, **LOOK),
    )


def many_switches() -> Item:
    """Return how often the force switches."""
    kappas = np.array([18.0, 63.0, 400.0, 2500.0, 1e4])
    psis = np.linspace(0.05, 1.999, 1200)
    most = [int(collide(kappa, psis).switches.max()) for kappa in kappas]
    return claim(
        "many-switches",
        "4.3",
        "for sufficiently high κ the force may switch many times between the regimes",
        f"up to {', '.join(map(str, most))} times at κ = 18, 63, 400, 2500, 10^{{4}}; that tends "
        "to √κ t_c/π",
        judged(printed=most[-1] > most[0] >= 2),
        "1200 collisions each, ψ in 0.05…2.",
        shown(2500.0, 1.0),
    )


def dissipates_only_sliding() -> Item:
    """Return where energy is lost."""
    sticking, gained, losing = 0.0, 0.0, True
    for course in motions():
        time = np.unique(np.concatenate([np.linspace(0.0, course.duration, 800), course.start]))
        curves = tangential_curves(course, time)
        energy = curves.velocity**2 + course.kappa * curves.elongation**2
        steps, stuck = np.diff(energy), curves.regime[:-1] == 0
        sticking = max(sticking, float(np.max(np.abs(steps[stuck]), initial=0.0)))
        losing = losing and float(np.sum(steps[~stuck])) < 0.0
        gained = max(gained, float(np.max(steps)))
    return claim(
        "dissipates-only-sliding",
        "4.3",
        "energy is dissipated during the Coulomb regime only",
        f"sticking, g_t² + κz² changes by {number(sticking, 1)} of its first value at most; "
        "sliding, it falls in each of 60 collisions, and never rises between two of 800 instants "
        f"({number(gained, 1)})",
        judged(printed=max(sticking, gained) < ROUNDING and losing),
        "60 exact motions.",
        shown(KAPPA, 0.97, energy="shown"),
    )


SWITCHING_CLAIMS = (
    slides_above_three,
    upper_region_is_zero,
    starts_sliding,
    ends_sliding,
    even_number,
    soft_springs_always_stick,
    elongation_increases,
    half_as_many_reversals,
    at_most_eight,
    decrease_not_monotonic,
    many_switches,
    dissipates_only_sliding,
)
