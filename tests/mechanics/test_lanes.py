"""Collisions in lanes are those of `follow`, wherever one looks, and never depend on each other."""

import numpy as np
import pytest
from fit_guesses import phases

from one_by_one import collide_each
from restitution.mechanics import collision
from restitution.mechanics.collision import (
    MOST_SWITCHES,
    TOO_STIFF,
    Collision,
    collide,
    expected_switch_counts,
)
from restitution.mechanics.compiled import compiled
from restitution.mechanics.contact import contact_of, rounding_bound
from restitution.mechanics.hertz import HALF_CONTACT_ROOT, normal_motion
from restitution.mechanics.lanes import elementary
from restitution.mechanics.lanes.block import SOFTEST, STIFFEST, WEAKEST
from restitution.mechanics.lanes.damped.block import MOST_PIECES, softest_in_lanes
from restitution.mechanics.lanes.first_sticking import fall_ratio
from restitution.mechanics.lanes.rows import BLOCK, work_space
from restitution.mechanics.lanes.sliding import largest_reach
from restitution.mechanics.lanes.sticking import guessed_phase
from restitution.mechanics.switching import MONOTONE_STIFFNESS, slip_extremum, slip_reach
from samples import borders, log_uniform

PARTS = 200_000

DAMPINGS = [1e-9, 1e-3, 0.1, 0.6, 1.0]


def followed(kappa, psi, damping=0.0):
    """One after the other."""
    found = Collision(
        np.empty(kappa.size),
        np.empty(kappa.size, np.int32),
        np.empty(kappa.size, np.bool_),
        np.empty(kappa.size),
    )
    collide_each(contact_of(damping), float(MOST_SWITCHES), kappa, psi, *found)
    return found


def figure_4(random):
    return random.uniform(0.1, 70.0, PARTS), random.uniform(0.01, 4.0, PARTS) / 1.4


def ordinary(random):
    return log_uniform(random, 0.01, 1e5, PARTS), random.uniform(0.0, 2.5, PARTS)


def soft(random):
    return log_uniform(random, SOFTEST, 2.0, PARTS), random.uniform(0.0, 3.0, PARTS)


def weak(random):
    return log_uniform(random, 1.0, 1e4, PARTS), log_uniform(random, 1e-8, 2.0, PARTS)


def stiff(random):
    count = PARTS // 5
    return log_uniform(random, 1e4, 2e6, count), log_uniform(random, 1e-7, 2.0, count)


def at_the_edges(random):
    """A few units in the last place beside the ends of what lanes take, and of the regimes."""
    kappa = random.choice([SOFTEST, MONOTONE_STIFFNESS, 2.0, 63.0, STIFFEST], PARTS)
    psi = random.choice([WEAKEST, 1.0, 2.0, 0.3, 1.7], PARTS)
    return tuple(a * (1.0 + 2.3e-16 * random.integers(-4, 5, PARTS)) for a in (kappa, psi))


def next_to_borders(random, farthest=-2.0):
    """At 1e-17 … 10^farthest of ψ from a change of the number of switches, found by halving."""
    kappa = log_uniform(random, SOFTEST, 1e4, PARTS)
    low = log_uniform(random, 1e-3, 1.9, PARTS)
    high = np.minimum(1.999, low * 1.1)
    kappa, low, _ = borders(kappa, low, high, 53)
    away = 10 ** random.uniform(-17.0, farthest, low.size) * random.choice([-1, 1], low.size)
    return kappa, low * (1.0 + away)


def assert_as_followed(kappa, psi, damping=0.0):
    found, true = collide(kappa, psi, damping), followed(kappa, psi, damping)
    assert np.array_equal(found.error_bound, true.error_bound)
    assert np.all(np.abs(found.epsilon_t - true.epsilon_t) <= true.error_bound)
    # certain in lanes, certain for whoever looks twice
    assert not np.any(found.switches_certain & ~true.switches_certain)
    assert np.array_equal(
        found.switches[found.switches_certain], true.switches[found.switches_certain]
    )


SAMPLES = [figure_4, ordinary, soft, weak, stiff, at_the_edges, next_to_borders]


@pytest.mark.parametrize("sample", SAMPLES)
def test_lanes_are_as_followed(sample):
    assert_as_followed(*sample(np.random.default_rng(11)))


@pytest.mark.verify
@pytest.mark.parametrize("sample", SAMPLES)
def test_millions_in_lanes_are_as_followed(sample):
    for seed in range(10):
        assert_as_followed(*sample(np.random.default_rng(seed)))


DAMPED_PARTS = 20_000


def damped(sample, seed, damping):
    """The same collisions as without damping, with κ in the units of the contact."""
    random = np.random.default_rng(seed)
    kappa, psi = (a[:DAMPED_PARTS] for a in sample(random))
    return kappa * contact_of(damping).unit ** 2, psi


def next_to_damped_borders(random, damping, farthest=-2.0):
    """As `next_to_borders`, of the counts with damping."""
    contact = contact_of(damping)
    softest = softest_in_lanes(contact)
    kappa = log_uniform(random, softest, 1e4, DAMPED_PARTS) * contact.unit**2
    low = log_uniform(random, 1e-3, 0.95 * contact.impulse, DAMPED_PARTS)
    high = np.minimum(0.9995 * contact.impulse, low * 1.1)
    kappa, low, _ = borders(kappa, low, high, 53, damping)
    away = 10 ** random.uniform(-17.0, farthest, low.size) * random.choice([-1, 1], low.size)
    return kappa, low * (1.0 + away)


def assert_damped_as_followed(seed, damping):
    for sample in (figure_4, ordinary, weak, at_the_edges):
        assert_as_followed(*damped(sample, seed, damping), damping)
    assert_as_followed(*next_to_damped_borders(np.random.default_rng(seed), damping), damping)


@pytest.mark.parametrize("damping", DAMPINGS)
def test_damped_lanes_are_as_followed(damping):
    assert_damped_as_followed(11, damping)


@pytest.mark.verify
def test_millions_in_damped_lanes_are_as_followed():
    random = np.random.default_rng(12)
    for seed in range(25):
        assert_damped_as_followed(seed, float(log_uniform(random, 1e-6, 30.0, 1)[0]))


@pytest.mark.parametrize("damping", [0.0, 0.1, 3.0])
def test_what_becomes_of_a_lane_does_not_depend_on_the_others(damping):
    kappa, psi = (a[:20_000] for a in ordinary(np.random.default_rng(3)))
    together = collide(kappa, psi, damping)
    order = np.random.default_rng(4).permutation(kappa.size)
    shuffled = collide(kappa[order], psi[order], damping)
    for column, other in zip(together, shuffled, strict=True):
        assert np.array_equal(column[order], other)
    for i in range(0, kappa.size, 500):
        alone = collide(kappa[i], psi[i], damping)
        assert [column[i] for column in together] == list(alone)


@pytest.mark.parametrize("damping", [0.0, 0.1])
def test_a_limit_of_switches_holds_in_lanes(damping):
    kappa, psi = (a[:5_000] for a in ordinary(np.random.default_rng(6)))
    expected = expected_switch_counts(kappa, psi, damping)
    for most in (0.0, 6.0, 30.0, 300.0):
        lost = collide(kappa, psi, damping, most).switches == TOO_STIFF
        assert np.array_equal(lost, (psi < contact_of(damping).impulse) & (expected > most))


@pytest.mark.parametrize(
    ("damping", "share"), [(0.0, 0.005), (1e-3, 0.02), (0.1, 0.01), (1.0, 0.05)]
)
def test_few_leave_where_lanes_are_meant(damping, share):
    random = np.random.default_rng(5)
    contact, left, blocks = contact_of(damping), 0, 50
    for _ in range(blocks):
        kappa = log_uniform(random, MONOTONE_STIFFNESS, 1e4, BLOCK)
        psi = random.uniform(1e-3, 2.0, BLOCK)
        bound = np.array([rounding_bound(contact, *one) for one in zip(kappa, psi, strict=True)])
        given = np.inf, 0, BLOCK, kappa, psi, bound, *work_space()
        left += collision.collide_block(contact, *given, np.empty(BLOCK), np.empty(BLOCK, np.int32))
    assert left <= share * blocks * BLOCK


def test_a_spring_that_all_but_touches_the_cap_is_not_for_lanes():
    for damping, kappa, psi in (
        (0.004169944740691943, 1.6832464888920187, 0.07672715604043862),
        (0.005113074932400925, 1.8687833865283972, 0.07652703791795834),
        (0.010020119743392904, 2.6609233866734026, 0.07524011031543387),
        (0.5671509319461566, 285.47140430676296, 0.01062725015309026),
    ):
        # P = bτ + aτ³ and κz = κψτ² have two meetings or none as κψ is more or less than 2√η
        psis = psi * (1.0 + 1e-15 * np.arange(-2000, 2001))
        assert_as_followed(np.full(psis.size, kappa), psis, damping)


def test_contacts_that_last_too_long_are_not_for_lanes():
    pieces = [contact_of(damping).pieces.shape[0] for damping in (30.0, 60.0)]
    assert pieces[0] <= MOST_PIECES < pieces[1]


@compiled
def evaluated(arguments, values):
    for i in range(arguments.size):
        x = arguments[i]
        values[0, i], values[1, i] = elementary.sine_and_cosine(x)
        values[2, i] = elementary.cube_root(x)
        values[3, i] = elementary.fifth_root(x)
        values[4, i] = elementary.arctangent(x, 1.0)


def test_elementary_functions():
    x = np.concatenate([np.geomspace(1e-12, 10.0, 100_001), np.linspace(0.0, 1e5, 100_001)[1:]])
    values = np.empty((5, x.size))
    evaluated(x, values)
    small = x <= 10.0
    assert np.max(np.abs(values[0] - np.sin(x))) <= 3e-16
    assert np.max(np.abs(values[1] - np.cos(x))) <= 3e-16
    assert np.max(np.abs(values[2] / np.cbrt(x) - 1.0)[small]) <= 1e-8
    assert np.max(np.abs(values[3] / x**0.2 - 1.0)[small]) <= 6e-2
    assert np.max(np.abs(values[3] / x**0.2 - 1.0)[small & (x >= 0.1)]) <= 1e-3
    assert np.max(np.abs(values[4] - np.arctan(x))) <= 1e-9


def test_guesses_are_as_good_as_they_say():
    q = np.linspace(1e-3, HALF_CONTACT_ROOT, 1001)
    root, loss = np.array([normal_motion(each) for each in q]).T
    ratio = np.array([fall_ratio(rate) for rate in 1.0 - loss])
    assert np.max(np.abs(ratio * root / q - 1.0)) <= 1.3e-6
    phase, fifth, stuck = phases()
    guess = np.array([guessed_phase(*each) for each in zip(phase, fifth, strict=True)])
    there, guessed = (np.sqrt(1.0 - each / phase) for each in (stuck, guess))
    assert np.max(np.abs(guessed / there - 1.0)) <= 1.5e-3


@pytest.mark.parametrize("kappa", [1e-3, 0.3, 0.570102, 1.0, 1.5, MONOTONE_STIFFNESS - 1e-12])
def test_largest_reach_of_a_soft_spring(kappa):
    assert largest_reach(kappa) == pytest.approx(slip_reach(kappa, slip_extremum(kappa)), rel=1e-9)
