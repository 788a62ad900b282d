"""The pragmatic model of Sect. 4.4, and the conclusions of Sect. 5."""

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.limits import (
    coulomb_restitution,
)
from restitution.paper.figures import SAME
from restitution.paper.item import Item, judged, number, scene, shown
from restitution.paper.samples import (
    KAPPA,
    MU_OVER_ALPHA,
    last,
    maximum,
    means,
    mindlin_kappa,
    over_psi,
)
from restitution.paper.scaled_equations import GOOD_ACCURACY
from restitution.paper.sliding_claims import claim


def sensible_constant() -> Item:
    """Return the best constant of the pragmatic model."""
    mindlin = mindlin_kappa()
    spreads = {
        kappa: means(over_psi(kappa), kappa**-0.5, 2.0) for kappa in (mindlin, KAPPA, 1000.0)
    }
    best = {kappa: mean for kappa, (mean, _) in spreads.items()}
    left = spreads[mindlin][1]
    return claim(
        "sensible-constant",
        "4.4",
        "in max[ε_0, 1 − μ(1 + ε_n)g_n/(αg_t)] the only sensible constant is ε_0 = 0",
        f"the mean of ε_t over Eq. 30's range is {number(best[1000.0], 1)} at κ = 1000, "
        f"{number(best[KAPPA], 1)} at {number(KAPPA, 2)}, but {number(best[mindlin], 2)} at κ = "
        f"{number(mindlin, 4)}, Mindlin's for solid spheres; what any constant leaves there is "
        f"±{number(left, 2)}",
        judged(
            printed=all(abs(value) < SAME for value in best.values()),
            corrected=abs(best[KAPPA]) < SAME and abs(best[1000.0]) < SAME,
        ),
        "8000 collisions each; the mean is the constant of least squares. So it is for stiff "
        "springs.",
        shown(mindlin_kappa(), 0.57, method="coulomb", scene="accuracy"),
    )


def coulomb_is_good() -> Item:
    """Return how good Coulomb's law with a cut-off is."""
    kappas = (mindlin_kappa(), 18.0, KAPPA, 1000.0)

    def off_at(kappa: float) -> float:
        apart = lambda psi: np.abs(over_psi(kappa)(psi) - coulomb_restitution(psi))  # noqa: E731
        return means(apart, 0.01 / MU_OVER_ALPHA, 4.0 / MU_OVER_ALPHA)[0]

    off = [off_at(kappa) for kappa in kappas]
    listed = ", ".join(
        f"{number(mean, 3)} ({number(kappa, 3)})" for kappa, mean in zip(kappas, off, strict=True)
    )
    return claim(
        "coulomb-is-good",
        "5",
        "Eq. 16 is a rather good approximation in a wide range of parameters",
        f"mean error over g_t/g_n = 0.01…4 and (κ): {listed}",
        judged(printed=max(off) < GOOD_ACCURACY, corrected=off[-1] < GOOD_ACCURACY),
        f"“Rather good” is taken as {GOOD_ACCURACY} on average. So it is for stiff springs; for "
        f"solid spheres with κ near {number(mindlin_kappa(), 2)} it is not.",
        shown(mindlin_kappa(), 0.57, method="coulomb", scene="accuracy"),
    )


def between_zero_and_one() -> Item:
    """Return where ε_t is negative."""
    kappas = (18.0, KAPPA, 1000.0)
    psis = np.geomspace(1e-4, 4.0 / MU_OVER_ALPHA, 4000)

    def below(border: float, kappa: float) -> float:
        return MU_OVER_ALPHA * last(lambda psi: over_psi(kappa)(psi) < border, psis)

    any_negative = [below(0.0, kappa) for kappa in kappas]
    clearly = [below(-GOOD_ACCURACY, kappa) for kappa in kappas]
    return claim(
        "negative-only-at-small-gt",
        "5",
        "0 ≤ ε_t ≤ 1 in a wide range; negative values only at small g_t/g_n",
        f"somewhat negative up to g_t/g_n = {number(any_negative[1], 3)} at κ = "
        f"{number(KAPPA, 2)}, as in the paper's own Fig. 5b; below −{GOOD_ACCURACY} up to "
        f"{', '.join(number(value, 2) for value in clearly)} at κ = 18, {number(KAPPA, 2)}, 1000",
        judged(printed=max(any_negative) < 1.0, corrected=max(clearly[1:]) < 1.0),
        "4000 collisions each up to g_t/g_n = 4, and more about these places. Clearly negative "
        "values are confined to small g_t/g_n for stiff springs, not for soft ones.",
        shown(KAPPA, 1.9),
    )


def oscillates_between_extremes() -> Item:
    """Return how far ε_t oscillates."""
    kappas = np.linspace(0.1, 100.0, 20_000)
    weak = collide(kappas, 1e-5).epsilon_t
    return claim(
        "oscillates-between-extremes",
        "5",
        "at small g_t/g_n ε_t oscillates between −1 and 1 in dependence on g_t/g_n and κ",
        f"between {number(float(weak.min()), 4)} and {number(float(weak[kappas > 1.0].max()), 4)} "
        "at ψ = 10^{−5} for κ up to 100",
        judged(printed=float(weak.min()) < -0.99 and float(weak[kappas > 1.0].max()) > 0.99),
        "20,000 collisions. The limit is cos(√κ t_c); the amplitude falls with ψκ^{5/4}.",
        shown(30.0, 1e-3, scale="log", map="epsilon_t"),
    )


def asymptotically_zero() -> Item:
    """Return ε_t → 0 at fixed ψ, and that it fails for ψ → 0."""
    # |ε_t| has a maximum with every 195 of κ at 10⁴, with every 62 at 10³
    fixed, _ = maximum(lambda k: np.abs(collide(k, 0.5).epsilon_t), np.linspace(1e4, 1.2e4, 400))
    weak, _ = maximum(lambda k: np.abs(collide(k, 1e-9).epsilon_t), np.linspace(1e3, 1.2e3, 400))
    return claim(
        "asymptotically-zero",
        "5",
        "for stiff tangential springs asymptotically ε_t → 0",
        f"|ε_t| ≤ {number(fixed, 1)} at g_t/g_n = 0.7 from κ = 10^{{4}} on; but at ψ = 10^{{−9}} "
        f"it still swings to {number(weak, 3)}: the limit holds at fixed g_t > 0, not uniformly",
        judged(printed=fixed < SAME and weak < SAME, corrected=fixed < SAME),
        "400 collisions each, and more about the largest; at fixed g_t that falls as κ^{−5/4}. "
        "Sect. 4.4 says “in a certain range of g_t/g_n”, the conclusions do not.",
        scene(kappa="1000", mu_over_alpha="1.4", gt_over_gn="0.001", scale="log"),
    )


CONCLUSION_CLAIMS = (
    sensible_constant,
    coulomb_is_good,
    between_zero_and_one,
    oscillates_between_extremes,
    asymptotically_zero,
)
