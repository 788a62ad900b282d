"""Write ``collisions_more.csv``: ``python tests/validation/make_collisions.py`` (four minutes).

κ and ψ are doubles. They are printed with `repr` and the collision is that of the double's exact
value, so whoever reads the file as doubles has no rounding in the data.
"""

from __future__ import annotations

import csv
import math
import random
import sys
from decimal import Decimal
from pathlib import Path

from high_precision import collide
from mpmath import mp

COLUMNS = (
    "kappa",
    "psi",
    "epsilon_t",
    "switches",
    "nearest_grazing",
    "first_switch_time",
    "last_switch_time",
    "reversals",
)
SEED = 20080107

Point = tuple[float, float]


def exact(value: float) -> str:
    """The double's value in full, not its shortest name."""
    return str(Decimal(value))


def six_digits(value: float) -> float:
    """The double nearest to a six-digit decimal: readable, and as good as any other."""
    return float(f"{value:.6g}")


def scattered(
    generator: random.Random, count: int, kappas: tuple[float, float], psis: tuple[float, float]
) -> list[Point]:
    """Log-uniform points."""
    points = []
    for _ in range(count):
        kappa = math.exp(generator.uniform(*map(math.log, kappas)))
        psi = math.exp(generator.uniform(*map(math.log, psis)))
        points.append((six_digits(kappa), six_digits(psi)))
    return points


def pure_sliding_border(kappa: float) -> float:
    """ψ*: the largest 1 - ẋ + (3/2κ)√x ẋ, by the golden section on the grid's best interval."""

    def needed(velocity: float) -> float:
        root: float = (1.25 * (1 - velocity * velocity)) ** 0.2
        return 1 - velocity + 1.5 * root * velocity / kappa

    best = max(range(1, 10_000), key=lambda k: needed(math.cos(math.pi * k / 20_000)))
    low, high = (math.pi * (best + side) / 20_000 for side in (-1, 1))
    for _ in range(100):
        left, right = low + 0.382 * (high - low), low + 0.618 * (high - low)
        if needed(math.cos(left)) > needed(math.cos(right)):
            high = right
        else:
            low = left
    return needed(math.cos(low))


def counting_border(kappa: float, low: float, high: float) -> float:
    """The ψ between two at which the number of switches changes, to 1e-13 of itself."""

    def switches(psi: float) -> int:
        return collide(exact(kappa), exact(psi), digits=20).switches

    at_low = switches(low)
    while high - low > 1e-13 * high:
        middle = (low + high) / 2
        low, high = (middle, high) if switches(middle) == at_low else (low, middle)
    return low


def special() -> list[Point]:
    """Points beside every border known, and the corners of the range."""
    beside_two = (2 - 1e-6, 2 - 1e-12, 2 + 1e-12)
    points = [(kappa, psi) for kappa in (0.1, 0.5, 0.7, 1.6, 10.0, 1e3) for psi in beside_two[:2]]
    points += [(63.0, psi) for psi in (*beside_two, 2.0)]
    points += [(kappa, psi) for kappa in (0.57, 0.5701, 0.5702) for psi in (0.3, *beside_two[:2])]
    points += [(kappa, psi) for kappa in (1.56, 1.568, 1.5686, 1.58) for psi in (0.05, 0.5, 1.8)]
    for kappa in (0.5, 0.2, 0.1, 1e-2, 1e-3, 1e-5):
        border = pure_sliding_border(kappa)
        points += [(kappa, border * (1 - away)) for away in (1e-3, 1e-6, 1e-10, -1e-10)]
    # The letters a to o of figure 5 with the one range between n and o that has no letter.
    letters = (2.2, 1.9, 1.6, 1.25, 0.97, 0.69, 0.585, 0.47, 0.33, 0.25, 0.17, 0.105, 0.07, 0.03)
    points += [(63.0, psi) for psi in (*letters, 0.012, 0.005)]
    for low, high in ((1.6, 1.9), (0.97, 1.25), (0.585, 0.69), (0.17, 0.25), (0.005, 0.012)):
        border = counting_border(63.0, low, high)
        points += [(63.0, border * (1 + away)) for away in (-1e-6, -1e-10, 1e-10)]
    points += [(0.953041, 1e-8), (0.953041, 1e-3), (1e4, 1e-8), (1e5, 1e-6), (1e6, 1e-5)]
    points += [(kappa, psi) for kappa in (1e-6, 2.5e6) for psi in (1e-8, 1e8)]
    return [*points, (2.5e6, 1e-4), (2.5e6, 1.2), (1e5, 1.99), (1e5, 0.5)]


def points() -> list[Point]:
    """Every point of the file, in its order."""
    generator = random.Random(SEED)
    wide = scattered(generator, 70, (1e-6, 2.5e6), (1e-8, 1e8))
    # Stiff contacts with many switches take up to half a minute each: `special` has some.
    wide = [(kappa, psi) for kappa, psi in wide if kappa < 1e4 or not 1e-3 < psi < 2]
    return [*scattered(generator, 110, (0.05, 5e3), (1e-3, 3.0)), *wide, *special()]


def row(kappa: float, psi: float) -> list[object]:
    """One line of the file."""
    found = collide(exact(kappa), exact(psi))
    ends = [mp.nstr(found.switch_times[k], 22) for k in (0, -1)] if found.switches else ["", ""]
    grazing = float(mp.nstr(found.nearest_grazing, 3))
    epsilon_t = mp.nstr(found.epsilon_t, 30)
    return [repr(kappa), repr(psi), epsilon_t, found.switches, grazing, *ends, found.reversals]


def main() -> None:
    """Write the file beside this module."""
    rows = [row(kappa, psi) for kappa, psi in points()]
    path = Path(__file__).with_name("collisions_more.csv")
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerows([COLUMNS, *rows])
    print(f"{len(rows)} collisions", file=sys.stderr)


if __name__ == "__main__":
    main()
