"""The paper, statement by statement: what is printed, what comes out, and a computed verdict."""

import functools
from dataclasses import replace

from restitution.paper.conclusion_claims import CONCLUSION_CLAIMS
from restitution.paper.corrections import DEFINITIONS, Correction, distinct_corrections
from restitution.paper.equations import EQUATIONS
from restitution.paper.figures import FIGURES
from restitution.paper.item import Item
from restitution.paper.letter_claims import LETTER_CLAIMS
from restitution.paper.numbers import NUMBERS
from restitution.paper.scaled_equations import SCALED_EQUATIONS
from restitution.paper.scaling_claims import SCALING_CLAIMS
from restitution.paper.sliding_claims import SLIDING_CLAIMS
from restitution.paper.sliding_equations import SLIDING_EQUATIONS
from restitution.paper.stiff_claims import STIFF_CLAIMS
from restitution.paper.switching_claims import SWITCHING_CLAIMS

__all__ = ["DEFINITIONS", "Correction", "Item", "distinct_corrections", "study_paper"]

STATEMENTS = (
    *EQUATIONS,
    *SLIDING_EQUATIONS,
    *SCALED_EQUATIONS,
    *FIGURES,
    *NUMBERS,
    *SLIDING_CLAIMS,
    *SCALING_CLAIMS,
    *SWITCHING_CLAIMS,
    *LETTER_CLAIMS,
    *STIFF_CLAIMS,
    *CONCLUSION_CLAIMS,
)


@functools.cache
def study_paper() -> tuple[Item, ...]:
    """Return every statement of the paper that is checked; about a second of one core, once.

    Returns
    -------
    tuple of Item
        Equations 1–30, Figs. 1–6, numbers of captions and footnotes, claims.

    Examples
    --------
    >>> [item.verdict for item in study_paper() if item.id == "equation-27"]
    ['corrected']
    """
    return tuple(_named(statement()) for statement in STATEMENTS)


def _named(item: Item) -> Item:
    """Return an item whose evidence says so if it is a definition."""
    if item.id not in DEFINITIONS:
        return item
    return replace(
        item, evidence=f"A definition: what is checked is that it is meant here. {item.evidence}"
    )
