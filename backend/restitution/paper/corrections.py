"""What the corrections come to: distinct points, and the statements that each of them mends."""

from collections.abc import Iterable
from dataclasses import dataclass

from restitution.paper.item import Item


@dataclass(frozen=True)
class Correction:
    """One point on which the paper is corrected.

    Attributes
    ----------
    id : str
    text : str
        What is right, in a sentence.
    statements : tuple of str
        `id` of those that hold with it.
    """

    id: str
    text: str
    statements: tuple[str, ...]


POINTS = (
    Correction(
        "spring-while-sliding",
        "While the contact slides, the spring is held at the cap, and the force has its sign.",
        ("equation-8", "equation-9", "equation-17", "equation-23"),
    ),
    Correction(
        "largest-cap",
        "The largest cap of the spring has the factor x_{max}^{3/2} = (5/4)^{3/5} = 1.1433.",
        ("equation-25", "equation-26", "equation-27", "equation-28", "claim-upper-limit"),
    ),
    Correction(
        "kappa-of-figures-4-and-5",
        "κ of Figs. 4 and 5 is that of Eq. 24 times α.",
        (
            "figure-4",
            "figure-5",
            "number-figure-5-kappa",
            "claim-at-most-eight",
            "claim-letter-e",
            "claim-letter-f",
            "claim-letter-g",
            "claim-letter-j",
        ),
    ),
    Correction(
        "start-of-figure-6",
        "z(0) of Fig. 6 is dz/dt(0).",
        ("figure-6", "number-figure-6-start"),
    ),
    Correction(
        "modulus-of-footnote-2", "Footnote 2 means GPa, not MPa.", ("number-footnote-2-modulus",)
    ),
    Correction(
        "friction-of-footnote-2",
        "Footnote 2 is computed with μ = 0.5, the caption of Fig. 2 has 0.4.",
        ("number-figure-2-friction",),
    ),
    Correction(
        "mass-of-footnote-2",
        "The energy of an impact has m_{eff}, not the mass of one sphere.",
        ("number-footnote-2-formula",),
    ),
    Correction(
        "digits-of-footnote-2",
        "The numbers of footnote 2 are truncated, not rounded.",
        ("number-footnote-2-coefficient", "number-footnote-2-length"),
    ),
    Correction(
        "damped-contacts-first-stick",
        "With damping no contact slides throughout: it first sticks.",
        ("claim-independent-of-force-law",),
    ),
    Correction(
        "grazing-impacts",
        "At grazing impacts ε_t hardly depends on the velocities any more.",
        ("claim-depends-on-both-velocities",),
    ),
    Correction(
        "normal-force-caps-the-tangential",
        "The normal force acts on the tangential motion, as its cap.",
        ("claim-no-interference",),
    ),
    Correction(
        "two-parameters",
        "Two parameters are independent, κ and ψ = (α/μ)(g_t/g_n).",
        ("claim-three-independent",),
    ),
    Correction(
        "long-swings",
        "A spring that swings through half a period turns round without a switch.",
        ("claim-half-as-many-reversals",),
    ),
    Correction(
        "stiff-springs",
        "It is so for stiff springs, not for κ near 4.5, as of solid spheres.",
        (
            "claim-sensible-constant",
            "claim-coulomb-is-good",
            "claim-negative-only-at-small-gt",
        ),
    ),
    Correction(
        "limit-at-fixed-velocity",
        "The stiff limit holds at fixed g_t > 0, not for all g_t at once.",
        ("claim-asymptotically-zero",),
    ),
    Correction(
        "plateau-has-two-ends",
        "|ε_t| is small for g_t from about g_nμ/(α√κ) to 2g_nμ/α, not beyond.",
        ("claim-small-at-large-velocities",),
    ),
)

DEFINITIONS = frozenset(
    {
        "equation-1",
        "equation-5",
        "equation-6",
        "equation-10",
        "equation-16",
        "equation-21",
        "equation-22",
        "figure-1",
        "number-footnote-1",
        "number-figure-2-spheres",
        "claim-elongation-while-sliding",
    }
)
"""Statements that say what a word or a law is. They cannot fail: what is checked is that the same
is meant here."""


def distinct_corrections(items: Iterable[Item]) -> tuple[Correction, ...]:
    """Return the distinct points on which `items` are corrected."""
    corrected = {item.id for item in items if item.verdict == "corrected"}
    found = []
    for point in POINTS:
        mended = tuple(name for name in point.statements if name in corrected)
        if mended:
            found.append(Correction(point.id, point.text, mended))
    return tuple(found)
