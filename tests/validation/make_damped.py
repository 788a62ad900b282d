"""Write ``damped.csv``: ``python tests/validation/make_damped.py`` (five minutes).

κ, ψ and η are doubles. They are printed with `repr` and the collision is that of the double's exact
value, as in ``collisions_more.csv``.
"""

from __future__ import annotations

import csv
import math
import random
import sys
from pathlib import Path

from high_precision_damped import collide
from make_collisions import exact, six_digits
from mpmath import mp

COLUMNS = (
    "kappa",
    "psi",
    "damping",
    "epsilon_t",
    "epsilon_n",
    "contact_duration",
    "switches",
    "nearest_grazing",
    "first_switch_time",
    "last_switch_time",
)
SEED = 20110213

Point = tuple[float, float, float]


def scattered(generator: random.Random, count: int, *ranges: tuple[float, float]) -> list[Point]:
    """Log-uniform points."""
    points = []
    for _ in range(count):
        kappa, psi, damping = (
            six_digits(math.exp(generator.uniform(math.log(low), math.log(high))))
            for low, high in ranges
        )
        points.append((kappa, psi, damping))
    return points


def special() -> list[Point]:
    """The four of the project's brief, and where something changes."""
    points = [
        (18.0, 0.2142857143, 0.05),
        (63.0, 1.0, 0.05),
        (5.0, 0.5, 0.3),
        (200.0, 0.3, 0.3),
    ]
    # soft springs, for which the cap curves away in mid-contact; beside the local extrema of that
    points += [(k, p, n) for k in (0.2, 0.8, 1.5) for p in (0.3, 1.9) for n in (0.02, 0.3)]
    points += [(k, p, 0.5) for k in (1.3, 1.41, 1.6, 1.71, 1.72) for p in (0.4, 1.2)]
    # nearly or hardly sliding throughout: ψ beside 1 + ε_n
    points += [(k, p, 0.1) for k in (0.3, 2.0, 50.0) for p in (1.892, 1.8929, 1.9)]
    # weak and strong damping, the first of which ends its first sticking at once
    points += [(20.0, 0.5, n) for n in (1e-12, 1e-9, 1e-6, 1e-4, 2.0, 5.0, 30.0, 1e3)]
    points += [(3.0, 0.01, 1e-3), (3.0, 1e-4, 0.2), (0.01, 20.0, 0.05), (0.01, 150.0, 0.05)]
    return [*points, (2000.0, 0.7, 0.02), (2000.0, 0.05, 0.6), (400.0, 1e-3, 0.1), (1e-3, 0.1, 0.4)]


def points() -> list[Point]:
    """Every point of the file, in its order."""
    generator = random.Random(SEED)
    wanted = scattered(generator, 80, (0.3, 400.0), (0.05, 3.0), (0.003, 1.2))
    return [*wanted, *special()]


def row(kappa: float, psi: float, damping: float) -> list[object]:
    """One line of the file."""
    found = collide(exact(kappa), exact(psi), exact(damping))
    digits = [mp.nstr(x, 25) for x in (found.epsilon_t, found.epsilon_n, found.duration)]
    ends = [mp.nstr(found.switch_times[k], 20) for k in (0, -1)]
    grazing = float(mp.nstr(found.nearest_grazing, 3))
    return [repr(kappa), repr(psi), repr(damping), *digits, found.switches, grazing, *ends]


def main() -> None:
    """Write the file beside this module."""
    rows = [row(*point) for point in points()]
    path = Path(__file__).with_name("damped.csv")
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerows([COLUMNS, *rows])
    print(f"{len(rows)} collisions", file=sys.stderr)


if __name__ == "__main__":
    main()
