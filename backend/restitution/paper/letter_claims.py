"""Claims of Sect. 4.3: the walk through the letters of Figs. 4 and 5."""

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from restitution.mechanics.hertz import HALF_CONTACT
from restitution.mechanics.motion import motion, reversals
from restitution.paper.figures import walk
from restitution.paper.item import Item, judged, number, shown
from restitution.paper.samples import (
    KAPPA,
    MU_OVER_ALPHA,
    PRINTED_KAPPA,
)
from restitution.paper.sliding_claims import claim

LOOK = {"map": "switches", "map_x": "alpha_kappa"}
"""The map of Fig. 4 beside the forces of Fig. 5."""


class Range(NamedTuple):
    """A range of ψ with one number of switches, told by the collision in its middle."""

    switches: int
    high: float
    low: float
    psi: float
    epsilon_t: float
    turns: int


@functools.cache
def ranges(kappa: float) -> tuple[Range, ...]:
    """Return the ranges met as ψ falls from 2.2 to .005."""
    found = []
    for switches, high, low in walk(kappa):
        course = motion(kappa, 0.5 * (high + low))
        turns = reversals(course)
        found.append(Range(switches, high, low, course.psi, course.epsilon_t, turns))
    return tuple(found)


def before_eight() -> tuple[Range, ...]:
    """Return the ranges at our κ down to the first with the most switches, that one included."""
    everything = ranges(KAPPA)
    most = max(each.switches for each in everything)
    return everything[: [each.switches for each in everything].index(most) + 1]


def _letter(
    letter: str, printed: str, fits: Callable[[Range, tuple[Range, ...]], bool], evidence: str
) -> Item:
    """Return what is said of a letter: the first range that fits, at the printed κ and at ours."""
    first = [
        next((r for r in ranges(k) if fits(r, ranges(k))), None) for k in (PRINTED_KAPPA, KAPPA)
    ]
    there, here = first
    if here is None:
        told = "no range of g_t/g_n has it, with either κ"
    else:
        told = (
            f"at κ = {number(KAPPA, 2)}, g_t/g_n = "
            f"{number(here.low * MU_OVER_ALPHA, 3)}…{number(here.high * MU_OVER_ALPHA, 3)}: "
            f"{here.switches} switches, reversals: {here.turns}, ε_t = "
            f"{number(here.epsilon_t, 2)} in the middle; at κ = {number(PRINTED_KAPPA, 2)} "
            f"{'so as well' if there else 'there is no such range'}"
        )
    return claim(
        f"letter-{letter}",
        "4.3",
        printed,
        told,
        judged(printed=there is not None, corrected=here is not None),
        evidence,
        shown(KAPPA, here.psi if here else 1.0, **LOOK),
    )


def letter_a() -> Item:
    """Return pure sliding."""
    return _letter(
        "a",
        "(a) at large g_t/g_n the contact slides throughout: no switch",
        lambda r, _: r.switches == 0,
        "The ranges of ψ from 2.2 down.",
    )


def letter_b() -> Item:
    """Return the first stop."""
    return _letter(
        "b",
        "(b) slightly below, it stops: two switches, one reversal, ε_t < 0",
        lambda r, every: r is every[1] and (r.switches, r.turns) == (2, 1) and r.epsilon_t < 0.0,
        "The range next to pure sliding.",
    )


def letter_c() -> Item:
    """Return the second stop."""
    return _letter(
        "c",
        "(c) still smaller: stopped a second time, four switches, two reversals, ε_t > 0",
        lambda r, every: r is every[2] and (r.switches, r.turns) == (4, 2) and r.epsilon_t > 0.0,
        "The next range.",
    )


def letter_e() -> Item:
    """Return the largest number of switches."""
    return _letter(
        "e",
        "(e) eight switches, four reversals, ε_t > 0, the first switch just before the largest "
        "compression",
        lambda r, _: (
            (r.switches, r.turns) == (8, 4)
            and r.epsilon_t > 0.0
            and bool(np.any(_first_stops(r) < HALF_CONTACT))
        ),
        f"The first switch crosses the largest compression, t = {number(HALF_CONTACT, 4)}, within "
        "this range.",
    )


def _first_stops(r: Range) -> np.ndarray:
    return np.array([motion(KAPPA, p).start[1] for p in np.linspace(r.low, r.high, 9).tolist()])


def letter_f() -> Item:
    """Return the first half swing."""
    return _letter(
        "f",
        "(f) the spring swings through half a cycle: six switches, four reversals, ε_t > 0",
        lambda r, _: (r.switches, r.turns) == (6, 4) and r.epsilon_t > 0.0,
        "The first range with these numbers.",
    )


def letter_g() -> Item:
    """Return the additional switch."""
    return _letter(
        "g",
        "(g) again eight switches by an additional one near the end, with a reversal: ε_t < 0",
        lambda r, _: (r.switches, r.turns) == (8, 5) and r.epsilon_t < 0.0,
        "The first range with these numbers.",
    )


def letter_j() -> Item:
    """Return a short rise."""

    def rises(r: Range, every: tuple[Range, ...]) -> bool:
        at = every.index(r)
        neighbours = [every[i].switches for i in (at - 1, at + 1) if 0 <= i < len(every)]
        after_g = any(q.switches == 8 for q in every[: max(at - 1, 0)])
        return after_g and neighbours == [r.switches - 2] * 2 and r.switches < 8

    return _letter(
        "j",
        "(j) there are velocities where the number of switches briefly rises by two",
        rises,
        "The first range after the eights that has two switches more than both its neighbours.",
    )


def letter_o() -> Item:
    """Return the undamped swings."""
    return _letter(
        "o",
        "(o) for small g_t two switches: undamped swings between two episodes of sliding",
        lambda r, every: r.switches == 2 and r is every[-1] and r.turns > 2,
        "The last range down to ψ = 0.005; below it others with four follow, ever shorter.",
    )


LETTER_CLAIMS = (letter_a, letter_b, letter_c, letter_e, letter_f, letter_g, letter_j, letter_o)
