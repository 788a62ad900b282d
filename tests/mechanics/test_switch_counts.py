"""A number of switches that is said to be certain is that of exact arithmetic.

It is asked where it is hardest: at doubles within a few units in the last place of a border
between two numbers, in each of the three directions, and where certainty begins on both sides.
"""

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from ball_arithmetic import UndecidedError, count

from restitution.mechanics.collision import collide

Collision = tuple[float, float, float]
"""κ, ψ, η."""

# each was certain and wrong once
ONCE_WRONG = [
    (0.704322388472999, 1.666202767586601, 0.0),
    (1.0188819808721186, 1.2466632597184037, 0.0),
    (0.9520103439467763, 1.3098664667757793, 0.0),
    (0.8652591749163965, 1.4090894705133405, 7.945148904274449e-06),
    (0.44486451170461827, 0.0054705723160303225, 1.4806794860453222e-06),
    (0.2856534361363342, 0.5687957816699293, 0.006599828594411581),
    (0.6695642065885811, 0.0018094468452382816, 3.669578025321535e-07),
    (7.607640522213689e-05, 1.948291957307391, 5.492221579755134e-09),
    (753.3228549808123, 0.19394022961241553, 153.9283470627722),
]
DIRECTIONS = {"kappa": 0, "psi": 1, "damping": 2}
MOST_DOUBLINGS = 50


def found(collision: Collision) -> tuple[int, bool]:
    result = collide(*collision)
    return int(result.switches), bool(result.switches_certain)


def is_right(collision: Collision) -> bool:
    """Whether a collision has the number of switches that it has for certain, if it has."""
    switches, certain = found(collision)
    if not certain:
        return True
    try:
        return count(*collision)[0] == switches
    except UndecidedError:
        return False


def drawn(random: np.random.Generator, damped: bool) -> Collision:
    """A collision where there are borders: soft, ordinary or stiff, weak or strong, hardly damped
    or all but overdamped.
    """
    # soft ones have borders of all kinds
    low, high = ((-1.3, 0.5), (-0.3, 2.7), (-6.0, 0.0), (2.7, 4.0))[random.choice(4, p=SHARES)]
    kappa = 10.0 ** random.uniform(low, high)
    psi = random.choice([random.uniform(0.01, 2.2), 10.0 ** random.uniform(-9.0, 0.5)])
    damping = 10.0 ** random.uniform(-10.0, 1.5) if damped else 0.0
    return kappa, psi, damping


SHARES = [0.4, 0.4, 0.15, 0.05]


def along(start: Collision, axis: int, factor: float) -> Callable[[float], Collision]:
    """A line of collisions, from 0 to 1."""

    def at(share: float) -> Collision:
        one, two, three = (
            value * factor**share if i == axis else value for i, value in enumerate(start)
        )
        return one, two, three

    return at


def at_border(low: Collision, high: Collision, axis: int) -> tuple[Collision, Collision]:
    """Neighbouring doubles between which the number of switches changes, by halving."""
    switches = found(low)[0]
    while True:
        middle = moved(low, axis, low[axis] + 0.5 * (high[axis] - low[axis]))
        if middle in (low, high):
            return low, high
        if found(middle)[0] == switches:
            low = middle
        else:
            high = middle


def moved(collision: Collision, axis: int, value: float) -> Collision:
    one, two, three = (value if i == axis else other for i, other in enumerate(collision))
    return one, two, three


def first_certain(start: Collision, axis: int, sense: int) -> Collision:
    """A double beside a border from which on counts are certain, by doubling and halving."""
    here, step = start[axis], abs(start[axis]) * 2.0**-52
    for _ in range(MOST_DOUBLINGS):
        if found(moved(start, axis, here + sense * step))[1]:
            break
        step *= 2.0
    uncertain, certain = here, here + sense * step
    while (middle := uncertain + 0.5 * (certain - uncertain)) not in (uncertain, certain):
        if found(moved(start, axis, middle))[1]:
            certain = middle
        else:
            uncertain = middle
    return moved(start, axis, certain)


def border_doubles(
    random: np.random.Generator, direction: str, damped: bool
) -> Iterator[list[Collision]]:
    """The doubles beside one border after another."""
    axis = DIRECTIONS[direction]
    points = np.linspace(0.0, 1.0, 40 if direction == "damping" else 200)
    while True:
        line = along(drawn(random, damped), axis, random.choice([1.05, 1.5, 5.0]))
        counts = [found(line(share))[0] for share in points]
        changes = np.flatnonzero(np.diff(counts))
        for change in random.permutation(changes)[:2]:
            pair = line(points[change]), line(points[change + 1])
            if found(pair[0])[0] == found(pair[1])[0]:
                continue
            doubles = []
            for start, sense in zip(at_border(*pair, axis), (-1, 1), strict=True):
                edge = first_certain(start, axis, sense)
                for one in (start, edge):
                    beyond = np.nextafter(one[axis], sense * np.inf)
                    doubles += [one, moved(one, axis, float(beyond))]
            yield doubles


def hunt(seed: int, direction: str, damped: bool, borders: int) -> list[Collision]:
    """The border doubles whose number of switches is certain and wrong."""
    search = border_doubles(np.random.default_rng(seed), direction, damped)
    return [one for _ in range(borders) for one in next(search) if not is_right(one)]


@pytest.mark.parametrize("collision", ONCE_WRONG)
def test_counts_that_were_certain_and_wrong_are_not(collision):
    assert is_right(collision)


@pytest.mark.parametrize(
    ("direction", "damped", "borders"),
    [
        ("kappa", False, 8),
        ("psi", False, 8),
        ("kappa", True, 2),
        ("psi", True, 2),
        ("damping", True, 1),
    ],
)
def test_certain_counts_are_right_beside_a_border(direction, damped, borders):
    assert not hunt(1, direction, damped, borders)


@pytest.mark.verify
@pytest.mark.parametrize("seed", range(2, 12))
@pytest.mark.parametrize(
    ("direction", "damped", "borders"),
    [
        ("kappa", False, 350),
        ("psi", False, 350),
        ("kappa", True, 250),
        ("psi", True, 250),
        ("damping", True, 50),
    ],
)
def test_certain_counts_are_right_beside_a_hundred_thousand(seed, direction, damped, borders):
    assert not hunt(seed, direction, damped, borders)


@pytest.mark.parametrize("damping", [0.0, 1e-6, 0.1, 3.0])
def test_counts_are_certain_but_beside_borders(damping):
    random = np.random.default_rng(7)
    kappa, psi = 10.0 ** random.uniform(-3, 4, 20_000), 10.0 ** random.uniform(-6, 1, 20_000)
    result = collide(kappa, psi, damping)
    assert np.all(result.switches_certain)
