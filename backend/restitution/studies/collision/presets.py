"""Collisions worth a look, the figures of the paper among them."""

import urllib.parse
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

PAPER = "Schwager, Becker & Pöschel, Eur. Phys. J. E 27, 107 (2008), doi:10.1140/epje/i2007-10356-3"
SOLID = 2.0 / 7.0
"""α of homogeneous spheres, Eq. 12."""


@dataclass(frozen=True)
class Preset:
    """A collision with a name.

    Attributes
    ----------
    id, title : str
        Its name in `PRESETS` and for people.
    alpha : float
        The α with which κ and μ/α were formed.
    source : str
        Where the numbers are from.
    link : str
        Address of the page, from its question mark on, that shows it.
    caption : str
        For a figure of the paper: what it shows, and what of it is our choice; else empty.

    Examples
    --------
    >>> PRESETS["figure-2"].link.startswith("?kappa=")
    True
    """

    id: str
    title: str
    kappa: float
    mu_over_alpha: float
    gt_over_gn: float
    source: str
    alpha: float = SOLID
    damping: float = 0.0
    link: str = ""
    caption: str = ""


def _preset(
    name: str,
    title: str,
    collision: tuple[float, float, float],
    source: str,
    caption: str = "",
    view: Mapping[str, str] | None = None,
) -> Preset:
    """Return a collision κ, μ/α, g_t/g_n with its address; `view` are options of the page."""
    names = ("kappa", "mu_over_alpha", "gt_over_gn")
    parameters = {key: f"{value:g}" for key, value in zip(names, collision, strict=True)}
    link = "?" + urllib.parse.urlencode(parameters | dict(view or {}))
    return Preset(name, title, *collision, source, link=link, caption=caption)


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

_MAP_4 = {"map": "switches", "map_x": "alpha_kappa", "map_y": "gt_over_gn", "scale": "linear"}
"""Of Figs. 4 and 5: switches over ακ 0…20 and g_t/g_n 0…4."""

_STEEL = {"scene": "spheres", "material": "steel", "normal_velocity_m_s": "100"}

_LETTER_CAPTION = (
    "the tangential force over μ between plus and minus the normal one, over time. The paper's κ "
    "= 18 is read as ακ; the paper does not give its g_t/g_n, ours has ψ = "
)

_ALL = (
    _preset(
        "figure-1",
        "Fig. 1 · Coulomb's law",
        (5896.51, 1.4, 1.0),
        f"{PAPER}: Fig. 1; velocities ours",
        "ε_t by Coulomb's law with a cut-off (Eq. 16) over both velocities, μ = 0.4, α = 2/7: "
        "zero up to g_t = 2.8 g_n, then rising towards 1; so is the ε_t above; what else is told "
        "of the impact is the spring's. The axes, to 200 m/s as in Fig. 2, and the point are ours.",
        _STEEL
        | {
            "tangential_velocity_m_s": "100",
            "velocity_law": "coulomb",
            "velocity_scale": "linear",
        },
    ),
    _preset(
        "figure-2",
        "Fig. 2 · steel spheres",
        (5896.51, 1.4, 0.0005),
        f"{PAPER}: Fig. 2; point ours",
        "ε_t of equal steel spheres, R = 2 cm, k_t = 10¹² N/m, μ = 0.4, over both velocities up "
        "to 200 m/s: as Fig. 1 but at the smallest g_t, where it swings and is negative, as at "
        "our point. The axes are logarithmic, for on the paper's linear ones that is a line at "
        "the edge. No damping; the steel is taken to stay elastic, which it does not.",
        _STEEL
        | {
            "tangential_velocity_m_s": "0.05",
            "velocity_law": "epsilon_t",
            "velocity_scale": "log",
        },
    ),
    _preset(
        "figure-3",
        "Fig. 3 · the surface ε_t",
        (30.0, 1.4, 0.5),
        f"{PAPER}: Fig. 3; point ours",
        "ε_t of the scaled collision over κ and g_t/g_n: a plateau near zero below g_t/g_n = "
        "2.8, swings at small g_t/g_n. Axes and μ/α are ours, for the paper gives none; 3-D lifts "
        "the map to its surface.",
        {"map": "epsilon_t", "map_x": "kappa", "map_y": "gt_over_gn", "scale": "linear"},
    ),
    _preset(
        "figure-4",
        "Fig. 4 · switch counts",
        (63.0, 1.4, 1.36),
        f"{PAPER}: Fig. 4; point ours",
        "How often the contact changes between sliding and sticking, over ακ 0…20 and g_t/g_n "
        "0…4, μ = 0.4, α = 2/7. The paper labels the axis κ; only as ακ does it have its "
        "switches. Its letters stand at ακ = 18.",
        _MAP_4,
    ),
    *(
        _preset(
            f"figure-5-{letter}",
            f"Fig. 5 {letter}",
            (63.0, 1.4, round(1.4 * psi, 4)),
            f"{_FIGURE_5}{psi:g}, chosen by us",
            f"{_LETTER_CAPTION}{psi:g}.",
        )
        for letter, psi in LETTERS.items()
    ),
    _preset(
        "figure-6",
        "Fig. 6 · a stiff spring",
        (100.0, 1.0, 0.3),
        f"{PAPER}: Fig. 6; it gives no μ/α, and 1 fits its first minimum shortly after t = 1",
        "Force and tangential velocity of a stiff spring, κ = 100, g_t/g_n = 0.3: it stops, and "
        "in three more slides, which the paper calls many, nearly all of the velocity is lost. κ "
        "is not read as ακ here, as in Figs. 4 and 5: no letters tell which is meant, and with "
        "μ/α = 1, our choice, the first minimum comes shortly after t = 1, as the paper has it. "
        "So it does at ακ = 100, κ = 350, with μ/α = 0.9. Where the paper has z(0) = 0.3, the "
        "velocity dz/dt is meant.",
    ),
    _preset(
        "stiff-limit",
        "Stiff limit",
        (2000.0, 1.4, 1.0),
        f"{PAPER}: Sect. 4.4; many episodes, ε_t near 0",
    ),
    _preset(
        "gear-wheel",
        "Gear wheel",
        (0.953, 1.4, 0.001),
        "κ = (π/t_c)²: half a swing of the spring during the contact, ε_t near −1 for weak spin, "
        "whose force is a thousandth of the normal one and drawn enlarged",
    ),
    _preset("pure-sliding", "Pure sliding", (18.0, 1.4, 3.5), f"{PAPER}: Sect. 3, Eq. 15; ψ = 2.5"),
    _preset(
        "steel",
        "Steel spheres of Fig. 2",
        (37204.0, 1.4, 0.5),
        f"{PAPER}: caption of Fig. 2 at g_n = 1 m/s, k_t = 10¹² N/m",
    ),
    _preset(
        "mindlin",
        "Mindlin-like",
        (4.521, 1.4, 0.8),
        "Mindlin's stiffness at the largest compression, one material with ν = 0.3; R. D. "
        "Mindlin, J. Appl. Mech. 16, 259 (1949)",
    ),
    _preset(
        "alumina-on-glass",
        "Alumina on glass",
        (4.72, 0.322, 0.58),
        "A. H. Kharaz, D. A. Gorham, A. D. Salman, Powder Technol. 120, 281 (2001): μ = 0.092, "
        "30° from the normal; κ from Mindlin's stiffness with E = 380 and 70 GPa, ν = 0.23, 0.25",
    ),
)

PRESETS: Mapping[str, Preset] = MappingProxyType({each.id: each for each in _ALL})
"""By name."""
