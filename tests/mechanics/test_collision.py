"""The exact collision: against 60-digit arithmetic, at the extremes, and by its laws."""

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
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.mechanics.limits import (
    GEAR_WHEEL_STIFFNESS,
    sliding_threshold,
    stiff_bound,
    weak_limit,
)
from restitution.mechanics.motion import motion

SMALLEST, LARGEST = 5e-324, 1.7976931348623157e308

positive = st.floats(SMALLEST, LARGEST, allow_subnormal=True)


def by_decades(low: int, high: int) -> st.SearchStrategy[float]:
    """Doubles spread evenly over powers of ten, as hypothesis' own are not."""
    return st.builds(lambda m, e: m * 10.0**e, st.floats(1, 9.99), st.integers(low, high))


def test_epsilon_t_agrees_with_sixty_digits(reference):
    result = collide(reference.kappa, reference.psi)
    allowed = 1e-13 * np.maximum(1.0, np.sqrt(reference.kappa))
    error = np.abs(result.epsilon_t - reference.epsilon_t)
    assert np.all(error <= allowed)
    assert np.all(error <= result.error_bound)


def test_switches_agree_with_sixty_digits_away_from_grazing(reference):
    counted = reference.nearest_grazing > 1e-10
    result = collide(reference.kappa[counted], reference.psi[counted])
    np.testing.assert_array_equal(result.switches, reference.switches[counted])
    assert np.all(result.switches_certain)


def test_switches_are_uncertain_at_the_border_of_pure_sliding():
    assert not collide(63.0, 2.0).switches_certain
    assert collide(63.0, 2.0).switches == 0
    assert collide(63.0, np.nextafter(2.0, 0.0) - 1e-12).switches_certain


@given(positive | by_decades(-323, 307), positive | by_decades(-323, 307))
@example(SMALLEST, SMALLEST)
@example(SMALLEST, LARGEST)
@example(LARGEST, SMALLEST)
@example(LARGEST, LARGEST)
@example(LARGEST, 1.9999999999999998)
@example(1e-308, 1.03e308)
def test_every_pair_of_doubles_has_an_answer(kappa, psi):
    result = collide(kappa, psi)
    assert result.switches == TOO_STIFF or result.switches <= MOST_SWITCHES
    assert -1.0 <= result.epsilon_t <= 1.0
    assert 0.0 <= result.error_bound <= 1.0


@given(by_decades(-8, 6), by_decades(-8, 1))
def test_answer_holds_where_it_is_too_stiff_to_follow(kappa, psi):
    followed = collide(kappa, psi)
    refused = collide(kappa, psi, most_switches=1.0)
    assert refused.switches == TOO_STIFF or psi >= 2.0
    assert abs(refused.epsilon_t - followed.epsilon_t) <= refused.error_bound + followed.error_bound


@given(by_decades(-6, 6), by_decades(-6, 0))
def test_number_of_switches_is_even_and_no_more_than_expected(kappa, psi):
    result = collide(kappa, psi)
    assert result.switches % 2 == 0
    assert result.switches <= expected_switch_counts(np.array([kappa]), np.array([psi]))[0]


def test_largest_followed_collision_stays_within_its_switches():
    kappa = 2e9
    assert expected_switch_counts(np.array([kappa]), np.array([1.0]))[0] > 0.5 * MOST_SWITCHES
    assert 10_000 < collide(kappa, 1.0).switches <= MOST_SWITCHES


@given(by_decades(-4, 5), by_decades(-5, 1), st.floats(1e-6, 1e3))
def test_final_velocities_never_differ_by_more_than_initial_ones(kappa, psi, factor):
    """The spring with its cap is a monotone operator: two motions only approach each other."""
    other = psi * (1.0 + factor)
    first, second = collide(kappa, psi), collide(kappa, other)
    gap = abs(first.epsilon_t * psi - second.epsilon_t * other)
    rounding = first.error_bound * psi + second.error_bound * other
    assert gap <= abs(other - psi) + rounding


@given(by_decades(-2, 5), by_decades(-6, 1))
def test_neighbouring_parameters_have_neighbouring_results(kappa, psi):
    # ε_t is continuous across every border between switch counts
    here, there = collide(kappa, psi), collide(kappa * (1 + 1e-9), psi * (1 - 1e-9))
    assert abs(here.epsilon_t - there.epsilon_t) <= 1e-8 * (1 + np.sqrt(kappa))


def test_pure_sliding_begins_at_its_threshold():
    kappa = np.geomspace(1e-3, 1e4, 57)
    border = sliding_threshold(kappa)
    assert np.all(collide(kappa, border * (1 + 1e-12)).switches == 0)
    assert np.all(collide(kappa, border * (1 - 1e-9)).switches == 2)


def test_stiff_bound_holds():
    kappa, psi = np.meshgrid(np.geomspace(0.05, 3e4, 300), np.geomspace(1e-3, 1.999, 300))
    result = collide(kappa, psi)
    assert np.all(np.abs(result.epsilon_t) <= stiff_bound(kappa, psi) + result.error_bound)


def test_epsilon_t_stays_within_its_bounds_at_the_gear_wheel():
    # the free swing is back exactly when the contact ends; rounding had it faster than it began
    assert np.all(np.abs(collide(GEAR_WHEEL_STIFFNESS, 10.0 ** np.arange(-100, 0)).epsilon_t) <= 1)


def test_infinite_psi_is_the_frictionless_limit():
    for kappa in (18.0, LARGEST):
        result = collide(kappa, np.inf)
        assert result.epsilon_t == 1.0
        assert result.switches == 0
        assert result.switches_certain


def test_vanishing_psi_is_a_limit_without_switches():
    result = collide(18.0, [0.0, 1e-300])
    assert result.epsilon_t[0] == result.epsilon_t[1]
    np.testing.assert_array_equal(result.switches, [0, 2])


def test_weakest_collisions_are_free_swings_at_every_stiffness():
    # all of 100,000: the root of an underflowing bracket was lost at one κ in 300
    kappa = np.geomspace(1e-3, 1e10, 100_000)
    result = collide(kappa, 1e-100)
    assert np.all(np.abs(result.epsilon_t - weak_limit(kappa)) <= 2 * result.error_bound)


def test_soft_collisions_switch_where_the_forces_meet_to_the_last_digits():
    # κψt = (3/2)√t at the first switch, κψt_c = x^{3/2} with x = t_c − t at the last
    kappa, psi = np.meshgrid(10.0 ** np.arange(-290, -17), [1e-9, 1.0, 1e3])
    for k, p in zip(kappa.ravel(), psi.ravel(), strict=True):
        path = motion(k, p)
        ends = path.episodes["q"][1:]
        np.testing.assert_allclose(ends[0], k * p / 1.5, rtol=1e-10)
        np.testing.assert_allclose(ends[1], (k * p * CONTACT_DURATION) ** (1 / 3), rtol=1e-10)
        assert path.switches_certain, (k, p)


def test_parameters_broadcast():
    assert collide(np.ones((3, 1)), np.ones(4)).epsilon_t.shape == (3, 4)
    assert collide(1.0, 1.0).epsilon_t.shape == ()


def test_large_arrays_are_the_same_as_small_ones():
    rng = np.random.default_rng(8)
    kappa, psi = rng.uniform(0.1, 70, 20_000), rng.uniform(0.01, 3, 20_000)
    whole = collide(kappa, psi).epsilon_t
    np.testing.assert_array_equal(
        whole[11_111:11_211], collide(kappa, psi[None])[0][0, 11_111:11_211]
    )


@pytest.mark.parametrize("kappa", [0.0, -1.0, np.nan, np.inf])
def test_impossible_stiffness_is_refused_by_name_and_value(kappa):
    with pytest.raises(ParameterError, match=r"kappa\[1\] must be positive and finite"):
        collide([1.0, kappa], 1.0)
