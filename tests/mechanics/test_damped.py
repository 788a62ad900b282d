"""The damped collision: against high precision, at the extremes, and by its laws."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from restitution.errors import ParameterError
from restitution.mechanics.collision import (
    MOST_SWITCHES,
    TOO_STIFF,
    collide,
    expected_switch_counts,
)
from restitution.mechanics.contact import (
    MOST_DAMPING,
    contact_of,
    energy_bound,
    normal_restitution,
)

SMALLEST, LARGEST = 5e-324, 1.7976931348623157e308
DAMPINGS = (1e-4, 0.02, 0.1, 0.3, 0.5, 0.6, 0.8, 1.0, 2.0, 5.0, 30.0, 300.0)


def by_decades(low: int, high: int) -> st.SearchStrategy[float]:
    return st.builds(lambda m, e: m * 10.0**e, st.floats(1, 9.99), st.integers(low, high))


def scattered(count, psis=(1e-4, 4.0)):
    rng = np.random.default_rng(2011)
    kappa, psi = rng.uniform(np.log(0.02), np.log(1e4), count), rng.uniform(*np.log(psis), count)
    return np.exp(kappa), np.exp(psi)


# printed in the project's brief to nine digits, with ψ to ten
@pytest.mark.parametrize(
    ("kappa", "psi", "damping", "epsilon_t", "switches"),
    [
        (18.0, 0.2142857143, 0.05, -0.319335367, 3),
        (63.0, 1.0, 0.05, 0.006389827, 9),
        (5.0, 0.5, 0.3, 0.028888511, 3),
        (200.0, 0.3, 0.3, 0.014686035, 11),
    ],
)
def test_epsilon_t_has_the_known_values(kappa, psi, damping, epsilon_t, switches):
    result = collide(kappa, psi, damping)
    assert result.epsilon_t == pytest.approx(epsilon_t, abs=1e-9)
    assert result.switches == switches


def test_epsilon_t_and_switches_agree_with_high_precision(damped_reference):
    for row in damped_reference:
        result = collide(row.kappa, row.psi, row.damping)
        error = abs(result.epsilon_t - row.epsilon_t)
        # the error of the phase √κ t_c is all that there should be
        assert error <= 1e-14 * max(1.0, np.sqrt(row.kappa)), row
        assert error <= result.error_bound, row
        assert result.switches == row.switches, row
        assert result.switches_certain, row
        assert normal_restitution(row.damping) == pytest.approx(row.epsilon_n, rel=1e-14)


def test_switches_are_odd():
    # the force rises as √t, the spring's as t; and at the end the force vanishes first
    kappa, psi = scattered(5000)
    for damping in DAMPINGS:
        switches = collide(kappa, psi, damping).switches
        assert np.all(switches % 2 == 1)


def test_vanishing_damping_meets_the_collision_without():
    kappa, psi = scattered(20_000)
    exact = collide(kappa, psi)
    for damping in (1e-300, 1e-60, 1e-18):
        result = collide(kappa, psi, damping)
        rounding = result.error_bound + exact.error_bound
        assert np.all(np.abs(result.epsilon_t - exact.epsilon_t) <= rounding)
        # the first sticking, which is over at once, is one switch more
        certain = exact.switches_certain & result.switches_certain
        np.testing.assert_array_equal(result.switches[certain], exact.switches[certain] + 1)


def test_effect_of_weak_damping_is_of_its_first_order():
    kappa, psi = scattered(2000, (0.05, 4.0))
    exact = collide(kappa, psi).epsilon_t
    change = [np.abs(collide(kappa, psi, n).epsilon_t - exact) for n in (1e-9, 1e-7)]
    assert np.median(change[1] / change[0]) == pytest.approx(100.0, rel=1e-3)


def test_epsilon_t_does_not_jump_between_both_sets_of_units():
    kappa, psi = scattered(5000)
    below = collide(kappa, psi, np.nextafter(1.0, 0.0))
    above = collide(kappa, psi, 1.0)
    allowed = 1e-14 * np.sqrt(1.0 + kappa) / np.minimum(1.0, psi)
    assert np.all(np.abs(below.epsilon_t - above.epsilon_t) <= allowed)


@pytest.mark.parametrize("damping", DAMPINGS)
def test_neighbouring_parameters_have_neighbouring_results(damping):
    # ε_t is continuous across every border between switch counts
    kappa, psi = scattered(20_000)
    here = collide(kappa, psi, damping)
    there = collide(kappa * (1 + 1e-9), psi * (1 - 1e-9), damping)
    assert np.all(np.abs(here.epsilon_t - there.epsilon_t) <= 1e-8 * (1 + np.sqrt(kappa)))


@pytest.mark.parametrize("damping", DAMPINGS)
def test_energy_bounds_hold(damping):
    contact = contact_of(damping)
    kappa, psi = scattered(20_000, (1e-4, contact.impulse))
    result = collide(kappa, psi, damping)
    bound = [energy_bound(contact, k, p) for k, p in zip(kappa, psi, strict=True)]
    assert np.all(np.abs(result.epsilon_t) <= bound + result.error_bound)


@given(by_decades(-3, 3), by_decades(-2, 3), by_decades(-6, 3))
def test_weaker_friction_never_brings_two_collisions_apart(kappa, psi, damping):
    # ε_t ψ is a contraction in ψ, as without damping: only the cap is another one
    first = collide(kappa, psi, damping)
    second = collide(kappa, psi * 1.25, damping)
    gap = abs(first.epsilon_t * psi - second.epsilon_t * 1.25 * psi)
    rounding = psi * (first.error_bound + 2.0 * second.error_bound)
    assert gap <= 0.25 * psi + rounding


def test_strong_slip_loses_the_whole_impulse():
    # ψ ≫ 1: it slides but for the very start
    for damping in DAMPINGS:
        impulse = contact_of(damping).impulse
        result = collide(1e3, 1e6, damping)
        assert (1.0 - result.epsilon_t) * 1e6 == pytest.approx(impulse, abs=1e-8)
        assert result.switches == 1


def test_vanishing_velocity_is_a_free_swing():
    for damping in DAMPINGS:
        contact = contact_of(damping)
        limit = np.cos(np.sqrt(3.0) * contact.duration / contact.unit)
        assert collide(3.0, 0.0, damping).epsilon_t == pytest.approx(limit, abs=1e-12)
        assert collide(3.0, 0.0, damping).switches == 0


@given(
    by_decades(-323, 307) | st.just(SMALLEST),
    by_decades(-323, 307) | st.just(SMALLEST),
    by_decades(-300, 29),
)
@example(LARGEST, LARGEST, 0.1)
@example(LARGEST, SMALLEST, MOST_DAMPING)
@example(SMALLEST, LARGEST, MOST_DAMPING)
@example(LARGEST, 1.8, 1e-300)
@example(LARGEST, 1.9999999999999998, 1e-300)
def test_every_triple_of_doubles_has_an_answer(kappa, psi, damping):
    result = collide(kappa, psi, damping)
    assert -1.0 <= result.epsilon_t <= 1.0
    assert 0.0 <= result.error_bound <= 1.0
    assert result.switches == TOO_STIFF or result.switches % 2 == 1
    assert result.switches <= MOST_SWITCHES


def test_expected_switches_are_no_fewer_than_counted():
    kappa, psi = scattered(5000, (1e-4, 2.0))
    for damping in DAMPINGS:
        counted = collide(kappa, psi, damping).switches
        assert np.all(expected_switch_counts(kappa, psi, damping) >= counted)


def test_collision_that_is_not_followed_has_a_bound_that_holds():
    followed = collide(3e4, [0.3, 1.2], 0.2)
    refused = collide(3e4, [0.3, 1.2], 0.2, most_switches=10.0)
    assert np.all(refused.switches == TOO_STIFF)
    assert np.all(refused.error_bound < 0.1)
    assert np.all(np.abs(followed.epsilon_t) <= refused.error_bound)


@pytest.mark.parametrize("kappa", [0.0, -1.0, np.nan, np.inf])
def test_impossible_stiffness_is_refused_by_name_and_value(kappa):
    with pytest.raises(ParameterError, match=r"kappa\[1\] must be positive and finite"):
        collide([1.0, kappa], 1.0, 0.1)
