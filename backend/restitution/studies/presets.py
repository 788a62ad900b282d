"""Collisions worth a look."""

from dataclasses import dataclass

PAPER = "Schwager, Becker & Pöschel, Eur. Phys. J. E 27, 107 (2008), doi:10.1140/epje/i2007-10356-3"
SOLID = 2.0 / 7.0
"""α of homogeneous spheres, Eq. 12."""


@dataclass(frozen=True)
class Preset:
    """A collision with a name; `alpha` is the α with which κ and μ/α were formed."""

    id: str
    title: str
    kappa: float
    mu_over_alpha: float
    gt_over_gn: float
    source: str
    alpha: float = SOLID
    damping: float = 0.0


LETTERS = {
    "a": 2.2,
    "b": 1.9,
    "c": 1.6,
    "d": 1.25,
    "e": 0.97,
    "f": 0.69,
    "g": 0.585,
    "h": 0.47,
    "i": 0.33,
    "j": 0.25,
    "k": 0.17,
    "l": 0.105,
    "m": 0.07,
    "n": 0.03,
    "o": 0.005,
}
"""ψ of the panels of Fig. 5. The paper does not list them: ours lie in the ranges of its text."""

_FIGURE_5 = f"{PAPER}: Fig. 5; its κ = 18 is taken as ακ, so κ = 63, with μ = 0.4, α = 2/7; ψ = "

PRESETS = (
    Preset("figure-3", "Fig. 3 · the surface ε_t", 30.0, 1.4, 0.5, f"{PAPER}: Fig. 3; point ours"),
    Preset("figure-4", "Fig. 4 · switch counts", 63.0, 1.4, 1.36, f"{PAPER}: Fig. 4; point ours"),
    *(
        Preset(
            f"figure-5-{letter}",
            f"Fig. 5 {letter}",
            63.0,
            1.4,
            round(1.4 * psi, 4),
            f"{_FIGURE_5}{psi:g}, chosen by us",
        )
        for letter, psi in LETTERS.items()
    ),
    Preset(
        "figure-6",
        "Fig. 6 · a stiff spring",
        100.0,
        1.0,
        0.3,
        f"{PAPER}: Fig. 6; it gives no μ/α, and 1 fits its first minimum shortly after t = 1",
    ),
    Preset(
        "stiff-limit",
        "Stiff limit",
        2000.0,
        1.4,
        1.0,
        f"{PAPER}: Sect. 4.4; many episodes, ε_t near 0",
    ),
    Preset(
        "gear-wheel",
        "Gear wheel",
        0.953,
        1.4,
        0.001,
        "κ = (π/t_c)²: half a swing of the spring during the contact, ε_t near −1 for weak spin",
    ),
    Preset("pure-sliding", "Pure sliding", 18.0, 1.4, 3.5, f"{PAPER}: Sect. 3, Eq. 15; ψ = 2.5"),
    Preset(
        "steel",
        "Steel spheres of Fig. 2",
        37204.0,
        1.4,
        0.5,
        f"{PAPER}: caption of Fig. 2 at g_n = 1 m/s, k_t = 10¹² N/m",
    ),
    Preset(
        "mindlin",
        "Mindlin-like",
        4.521,
        1.4,
        0.8,
        "Mindlin's stiffness at the largest compression, one material with ν = 0.3; "
        "R. D. Mindlin, J. Appl. Mech. 16, 259 (1949)",
    ),
    Preset(
        "alumina-on-glass",
        "Alumina on glass",
        4.72,
        0.322,
        0.58,
        "A. H. Kharaz, D. A. Gorham, A. D. Salman, Powder Technol. 120, 281 (2001): μ = 0.092, "
        "30° from the normal; κ from Mindlin's stiffness with E = 380 and 70 GPa, ν = 0.23, 0.25",
    ),
)
