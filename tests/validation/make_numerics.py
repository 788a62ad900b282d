"""The tables of docs/numerics.md: ``python tests/validation/make_numerics.py`` (seconds).

The library's side is computed anew, the truth is read from ``numerics.csv``. Rows that lack in that
file are made first, so without the file everything is (half an hour on one core).
"""

from __future__ import annotations

import csv
import math
import sys
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import high_precision
from make_collisions import exact
from mpmath import mp, mpf

from restitution.studies.collision.one import CollisionStudy, study_collision
from restitution.studies.collision.parameters import CollisionParameters

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

KAPPAS = (1e-300, 1e-100, 1e-20, 1e-6, 1e-2, 1.0, 63.0, 1e4, 1e6, 1e8, 1e10, 1e20, 1e28, 1e300)
PSIS = (
    *(1e-300, 1e-100, 1e-20, 1e-6, 1e-2, 0.5, 1.0),
    *(2 - 1e-9, 2.0, 2 + 1e-9, 10.0, 1e6, 1e20, 1e300),
)
COLUMNS = ("kappa", "psi", "made", "epsilon_t", "uncertainty", "switches", "by_kappa", "by_psi")
UNIT = 2.0**-52
"""ε of double precision."""

STEP = mpf(10) ** -25
"""Relative, of the difference quotients, which lack about κ times it of the derivative."""

STIFFEST_WALK, STIFFEST_SLOPE = 1e8, 1e6
"""κ up to which collisions are walked, and walked thrice for the slopes."""

NOTABLE = (
    *((1e-300, 1.0), (1e-6, 1e6), (1.0, 1.0), (63.0, 1e-20), (63.0, 0.5), (63.0, 2 - 1e-9)),
    *((63.0, 2.0), (1e4, 1e-6), (1e6, 1e-20), (1e6, 1e-2), (1e8, 1e-6), (1e8, 1.0)),
    *((1e10, 1.0), (1e20, 1e-300), (1e28, 1e-300), (1e300, 1.0), (1e300, 1e300)),
)
"""Pairs of the grid that the document lists one by one."""

NEIGHBOURS = (
    (0.3, 3.610766742989104, 2, 0),
    (5.0, 0.5873874441897637, 4, 2),
    (10.0, 1.0072699261537246, 4, 2),
    (18.0, 0.2636863128133433, 2, 4),
    (63.0, 0.0068947664854918005, 2, 4),
    (63.0, 0.2762271777113359, 6, 4),
    (63.0, 0.5655635381187597, 6, 8),
    (63.0, 1.0394448349355796, 8, 6),
    (63.0, 1.8167792180385787, 4, 2),
    (1e4, 0.506557875665965, 72, 74),
)
"""κ, ψ, and the true switches there and at the next double of ψ: by bisection with the walk."""

MARKER = "<!-- {} of tests/validation/make_numerics.py -->"

DOCUMENT = Path(__file__).parents[2] / "docs" / "numerics.md"
TRUTHS = Path(__file__).with_name("numerics.csv")


class Slopes(NamedTuple):
    """∂ε_t/∂ln κ and ∂ε_t/∂ln ψ."""

    by_kappa: float
    by_psi: float


@dataclass(frozen=True)
class Truth:
    """One collision as known from elsewhere; None for what is not.

    ``made`` is *walk* (`high_precision`), *sliding* (Eq. 15), *free* (the limit ψ → 0), *soft*
    (what the force can take at most), or *bound* (the stiff limit, or |ε_t| ≤ 1).
    """

    kappa: float
    psi: float
    made: str
    epsilon_t: str
    uncertainty: float
    switches: int | None = None
    slopes: Slopes | None = None

    def error(self, epsilon_t: float) -> float:
        """Distance of a double to this ε_t."""
        with mp.workdps(60):
            return float(abs(mpf(epsilon_t) - mpf(self.epsilon_t)))


class Row(NamedTuple):
    """A truth and what the library says."""

    truth: Truth
    ours: CollisionStudy
    error: float


def walked(kappa: float, psi: float) -> Truth:
    """Walk through the collision, and through two beside it for the slopes."""
    early = max(0.0, -math.log10(psi), -math.log10(kappa * psi))
    resolution = {"digits": 65 + int(early), "octaves": high_precision.END_OCTAVES + int(7 * early)}
    with mp.workdps(resolution["digits"] + high_precision.GUARD_DIGITS):
        k, p = mpf(exact(kappa)), mpf(exact(psi))
        here = high_precision.collide(str(k), str(p), **resolution)
        slopes = None
        if kappa <= STIFFEST_SLOPE:
            stiffer = high_precision.collide(str(k * (1 + STEP)), str(p), **resolution)
            faster = high_precision.collide(str(k), str(p * (1 + STEP)), **resolution)
            quotients = [(other.epsilon_t - here.epsilon_t) / STEP for other in (stiffer, faster)]
            slopes = Slopes(*map(float, quotients))
        epsilon_t = mp.nstr(here.epsilon_t, 30)
    return Truth(kappa, psi, "walk", epsilon_t, 1e-30, here.switches, slopes)


def truth(kappa: float, psi: float) -> Truth:
    """Return the best that is known about a collision without the library."""
    with mp.workdps(400):
        duration = (mpf(4) / 5) ** (mpf(3) / 5) * mp.beta(mpf(2) / 5, mpf(1) / 2)
        k, p = mpf(exact(kappa)), mpf(exact(psi))
        root = mp.sqrt(k)
        # |F| ≤ x^{3/2} and |F| ≤ κψt: the force takes at most 2 and at most κψ t_c²/2
        taken = min(2 / p, k * duration**2 / 2)
        # the cap bends the free swing for about (ψ√κ)^{2/3} at either end, at forces up to ψ√κ
        bent = 6 * root * (p * root) ** (mpf(2) / 3)
        if kappa > 0.6 and psi >= 2:  # ψ* = 2
            slopes = Slopes(0.0, float(2 / p))
            return Truth(kappa, psi, "sliding", mp.nstr(1 - 2 / p, 30), 1e-30, 0, slopes)
        if taken < 1e-30:
            # κψ* → 1.0318…
            switches = 2 if k * p < 1.03 else 0
            return Truth(kappa, psi, "soft", "1.0", 1e-30, switches, Slopes(0.0, 0.0))
        if bent < 1e-30:
            cosine, sine = mp.cos_sin(phase := root * duration)
            # a spring that the surface has left behind is left by the cap, too, before the end
            switches = 2 if cosine * sine > 0 else 4
            slopes = Slopes(float(-phase * sine / 2), 0.0)
            return Truth(kappa, psi, "free", mp.nstr(cosine, 30), 1e-30, switches, slopes)
        if kappa > STIFFEST_WALK:
            bound = min(mpf(1), mpf(1.25) ** (mpf(3) / 5) / (p * root))
            return Truth(kappa, psi, "bound", "0.0", float(bound))
    return walked(kappa, psi)


def write(truths: list[Truth]) -> None:
    """Write ``numerics.csv``."""
    with TRUTHS.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        for one in truths:
            switches = "" if one.switches is None else one.switches
            slopes = map(repr, one.slopes) if one.slopes else ("", "")
            known = one.epsilon_t, repr(one.uncertainty), switches, *slopes
            writer.writerow([repr(one.kappa), repr(one.psi), one.made, *known])


def read() -> dict[tuple[float, float], Truth]:
    """Return the rows of ``numerics.csv`` by κ and ψ."""
    found = {}
    with TRUTHS.open(encoding="utf-8", newline="") as stream:
        for line in csv.DictReader(stream):
            kappa, psi = float(line["kappa"]), float(line["psi"])
            switches = int(line["switches"]) if line["switches"] else None
            slopes = None
            if line["by_kappa"]:
                slopes = Slopes(float(line["by_kappa"]), float(line["by_psi"]))
            uncertainty = float(line["uncertainty"])
            found[kappa, psi] = Truth(
                kappa, psi, line["made"], line["epsilon_t"], uncertainty, switches, slopes
            )
    return found


def studied(kappa: float, psi: float) -> CollisionStudy:
    """Return the library's answer, with everything it can say."""
    return study_collision(CollisionParameters(kappa, 1.0, psi))


def measured(truths: Mapping[tuple[float, float], Truth]) -> dict[tuple[float, float], Row]:
    """Return truth, answer and distance for every pair of the grid."""
    rows = {}
    for pair in product(KAPPAS, PSIS):
        ours = studied(*pair)
        rows[pair] = Row(truths[pair], ours, truths[pair].error(ours.epsilon_t))
    return rows


def powers(value: float) -> str:
    """Return n where the value lies in (10ⁿ⁻¹, 10ⁿ], a dot for n ≤ 0."""
    n = math.ceil(math.log10(value)) if value > 0.0 else 0
    return str(n) if n > 0 else "·"


def lost_digits(row: Row) -> str:
    """Return how many decimal digits an answer lacks of one to ε."""
    if row.ours.switches is None:
        return "–"
    return powers(row.error / UNIT) if row.truth.made != "bound" else "?"


def condition(row: Row) -> str:
    """Return the power of ten of |∂ε_t/∂ln κ| + |∂ε_t/∂ln ψ|."""
    slopes = row.ours.sensitivity
    return powers(abs(slopes.kappa) + abs(slopes.psi)) if slopes else "–"


def count(row: Row) -> str:
    """Return the switches, with a question mark where the answer is not certain."""
    if row.ours.switches is None:
        return "–"
    return str(row.ours.switches) + ("" if row.ours.switches_certain else " ?")


def named(value: float) -> str:
    """Return a parameter as the document writes it."""
    beside_two = {2 - 1e-9: "2−1e-9", 2 + 1e-9: "2+1e-9"}
    return beside_two.get(value, f"{value:g}".replace("e-0", "e-").replace("e+0", "e+"))


def table(head: Iterable[str], lines: Iterable[Iterable[str]]) -> str:
    """Return a table in Markdown."""
    head = list(head)
    rows = [head, ["---"] * len(head), *map(list, lines)]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def grid(rows: Mapping[tuple[float, float], Row], cell: Callable[[Row], str]) -> str:
    """Return one table of the whole grid."""
    lines = ([named(kappa), *(cell(rows[kappa, psi]) for psi in PSIS)] for kappa in KAPPAS)
    return table(["κ \\ ψ", *map(named, PSIS)], lines)


def notable(rows: Mapping[tuple[float, float], Row]) -> str:
    """Return the table of `NOTABLE` pairs."""
    lines = []
    for pair in NOTABLE:
        truth, ours, error = rows[pair]
        slopes = ours.sensitivity
        by = [f"{slopes.kappa:.3g}", f"{slopes.psi:.3g}"] if slopes else ["–", "–"]
        unknown = truth.made == "bound"
        value, off = f"{ours.epsilon_t:.6g}", "?" if unknown else powers(error / UNIT)
        numbers = [value, off, f"{ours.error_bound:.1e}", *by, count(rows[pair]), ours.method]
        lines.append([*map(named, pair), *numbers, truth.made])
    head = "κ|ψ|ε_t|digits lost|error bound|∂ε_t/∂ln κ|∂ε_t/∂ln ψ|switches|method|truth"
    return table(head.split("|"), lines)


def neighbours() -> str:
    """Return the table of `NEIGHBOURS`."""
    lines = []
    for kappa, psi, here, there in NEIGHBOURS:
        found = [studied(kappa, p) for p in (psi, math.nextafter(psi, math.inf))]
        said = [f"{one.switches}{'' if one.switches_certain else ' ?'}" for one in found]
        lines.append([named(kappa), repr(psi), str(here), str(there), *said])
    head = "κ|ψ|true|true at the next double|answer|answer at the next double"
    return table(head.split("|"), lines)


def tables(rows: Mapping[tuple[float, float], Row]) -> dict[str, str]:
    """Return every table of the document by its name there."""
    return {
        "Errors": grid(rows, lost_digits),
        "Condition": grid(rows, condition),
        "Switches": grid(rows, count),
        "Neighbours": neighbours(),
        "Pairs": notable(rows),
    }


def printed(name: str) -> str:
    """Return a table as it stands in the document."""
    return (
        DOCUMENT.read_text(encoding="utf-8").split(MARKER.format(name) + "\n")[1].split("\n\n")[0]
    )


def main() -> None:
    """Make the rows that lack, then write the tables into the document."""
    truths = read() if TRUTHS.exists() else {}
    for pair in product(KAPPAS, PSIS):
        if pair not in truths:
            truths[pair] = truth(*pair)
            print(*pair, truths[pair].made, file=sys.stderr)
            write(list(truths.values()))
    write([truths[pair] for pair in product(KAPPAS, PSIS)])
    text = DOCUMENT.read_text(encoding="utf-8")
    for name, fresh in tables(measured(truths)).items():
        text = text.replace(printed(name), fresh)
    DOCUMENT.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
