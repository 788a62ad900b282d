"""What is said of one statement of the paper, and how a verdict follows from numbers."""

import math
import urllib.parse
from dataclasses import dataclass
from typing import Literal

Kind = Literal["equation", "figure", "number", "claim"]
Verdict = Literal["holds", "corrected", "fails"]


@dataclass(frozen=True)
class Item:
    """A statement of the paper, checked.

    Texts write an index as ε_t or m_{eff}, a power as κ^{−5/4}.

    Attributes
    ----------
    id : str
        ``equation-27``, ``figure-4``, ``number-…``, ``claim-…``.
    kind : str
    section : str
        Of the paper, where it is printed.
    printed : str
        What is printed there, in short.
    computed : str
        What comes out now, with the numbers.
    verdict : str
        ``holds``; ``corrected``: it does with the correction that `computed` states; ``fails``.
    evidence : str
        How that was decided, and what remains in doubt.
    link : str
        Address of the page, from its question mark on, that shows it.
    """

    id: str
    kind: Kind
    section: str
    printed: str
    computed: str
    verdict: Verdict
    evidence: str
    link: str


def judged(*, printed: bool, corrected: bool = False) -> Verdict:
    """Return the verdict on a statement that holds as `printed`, or as `corrected`."""
    if printed:
        return "holds"
    return "corrected" if corrected else "fails"


def shown(kappa: float, psi: float, friction: float = 1.4, /, **options: str) -> str:
    """Return the address at which the page shows a collision, `friction` being its μ/α."""
    gt_over_gn = float(f"{friction * psi:.6g}")
    return scene(
        kappa=f"{kappa:.6g}", mu_over_alpha=f"{friction:g}", gt_over_gn=f"{gt_over_gn:g}", **options
    )


def scene(**options: str) -> str:
    """Return the address at which the page has these options."""
    return "?" + urllib.parse.urlencode(options)


def number(value: float, digits: int = 3) -> str:
    """Return a number to so many digits, as it is set in print."""
    if value == 0.0 or not math.isfinite(value):
        return f"{value:g}".replace("inf", "∞")
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
    if -4 < exponent < 6:
        text = f"{value:.{max(0, digits - 1 - exponent)}f}"
    else:
        mantissa = f"{value / 10.0**exponent:.{digits - 1}f}"
        text = f"{mantissa}·10^{{{exponent}}}"
    return text.replace("-", "−")
