"""Each line of the laws: closed forms and limits against the exact collision."""

import numpy as np
import pytest

from cases import every_day
from restitution.mechanics.collision import collide
from restitution.mechanics.elastic import SHARP_STIFF_LIMIT
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.mechanics.limits import (
    GEAR_WHEEL_STIFFNESS,
    STIFF_ASYMPTOTE,
    coulomb_restitution,
    largest_switch_count,
    sliding_restitution,
    sliding_threshold,
    soft_limit,
    stiff_asymptote,
    stiff_bound,
    stiff_estimate,
    stiff_limit,
    weak_limit,
)
from restitution.mechanics.motion import motion, reversals


def test_two_parameters_suffice():
    """The collapse: κ, ψ decide, whatever μ/α stretches g_t/g_n by."""
    from restitution import epsilon_t  # noqa: PLC0415 - the public function takes all three

    kappa = np.geomspace(0.1, 1e3, 40)
    same = [epsilon_t(kappa, m, 0.7 * m) for m in (1e-200, 0.25, 1.0, 4.0, 1e200)]
    for other in same[1:]:
        np.testing.assert_allclose(other, same[0], rtol=0, atol=1e-13)


def test_pure_sliding_is_equation_15():
    kappa = np.geomspace(1e-2, 1e6, 30)
    psi = sliding_threshold(kappa) * 1.001
    result = collide(kappa, psi)
    np.testing.assert_array_equal(result.epsilon_t, sliding_restitution(psi))
    np.testing.assert_array_equal(result.switches, 0)


@pytest.mark.parametrize(
    ("kappa", "threshold", "last_digit"),
    [(0.5, 2.24847, 1e-5), (0.2, 5.32449, 1e-5), (0.1, 10.478, 1e-3)],
)
def test_sliding_threshold_has_its_known_values(kappa, threshold, last_digit):
    assert sliding_threshold(kappa) == pytest.approx(threshold, abs=last_digit / 2)


def test_sliding_threshold_is_two_from_its_border_on_and_tends_to_its_soft_limit():
    assert sliding_threshold(0.570103) == 2.0
    assert sliding_threshold(0.5701) > 2.0
    assert sliding_threshold(1e-9) * 1e-9 == pytest.approx(1.0318, abs=1e-4)


def test_weak_collisions_swing_freely():
    kappa = np.array([0.3, 2.0, 17.0, 200.0])
    psi = 1e-14
    correction = (psi * kappa**1.25) ** (2 / 3)
    difference = np.abs(collide(kappa, psi).epsilon_t - weak_limit(kappa))
    assert np.all(difference <= 3 * correction + 1e-13)


def test_correction_of_weak_collisions_grows_with_the_power_two_thirds():
    kappa = np.linspace(50, 70, 400)
    sizes = [
        np.abs(collide(kappa, psi).epsilon_t - weak_limit(kappa)).max() for psi in (1e-9, 1e-6)
    ]
    assert np.log10(sizes[1] / sizes[0]) == pytest.approx(2.0, abs=0.1)
    known = np.abs(collide(1e4, 1e-8).epsilon_t - weak_limit(1e4))
    assert known == pytest.approx(6e-3, rel=0.5)


def test_soft_springs_hardly_act():
    kappa = 1e-6
    assert collide(kappa, 1.0).epsilon_t == pytest.approx(soft_limit(kappa), abs=10 * kappa**1.6)


def test_first_gear_wheel_lies_at_half_a_swing():
    assert pytest.approx(0.95304, abs=1e-5) == GEAR_WHEEL_STIFFNESS
    assert collide(GEAR_WHEEL_STIFFNESS, 1e-12).epsilon_t == pytest.approx(-1.0, abs=1e-7)


def test_no_friction_changes_nothing():
    assert collide(7.0, np.inf).epsilon_t == 1.0


def test_coulomb_law_is_cut_off():
    np.testing.assert_array_equal(coulomb_restitution([1.0, 2.0, 4.0]), [0.0, 0.0, 0.5])
    assert coulomb_restitution(1.0, floor=-0.3) == -0.3
    assert sliding_restitution(4.0, epsilon_n=0.6) == pytest.approx(0.6)


def test_papers_stiff_estimate_is_not_a_bound_and_ours_is():
    kappa, psi = np.meshgrid(np.linspace(0.5, 4, 400), np.linspace(0.5, 1.99, 400))
    size = np.abs(collide(kappa, psi).epsilon_t)
    excess = size / stiff_estimate(kappa, psi)
    worst = np.unravel_index(np.argmax(excess), excess.shape)
    assert excess[worst] == pytest.approx(1.118, abs=0.002)
    assert kappa[worst] == pytest.approx(1.5, abs=0.1)
    assert psi[worst] == pytest.approx(1.0, abs=0.1)
    assert np.all(size <= stiff_bound(kappa, psi))


def test_sharp_stiff_limit_is_its_closed_form():
    tau = np.linspace(0.0, 10.0, 1_000_001)
    largest = ((tau + np.pi / 2) ** 1.5 - 0.4 * tau**2.5).max()
    assert largest <= SHARP_STIFF_LIMIT < largest * (1 + 1e-9)
    assert pytest.approx(largest, abs=5e-5) == STIFF_ASYMPTOTE


def psi_below_two(rng, count):
    """Spread over ψ, over its logarithm, and over that of the distance to 2."""
    parts = rng.uniform(0, 2, count), 10 ** rng.uniform(-9, 0.3, count)
    return np.concatenate([*parts, 2 - 10 ** rng.uniform(-12, 0, count)])


FEW = [(1.5685, 10.0, 30_000), (10.0, 1e3, 10_000), (1e3, 1e5, 1_000), (1e5, 2e8, 300)]


@pytest.mark.parametrize(
    ("low", "high", "count"),
    every_day(FEW, of=[*FEW, (1.5685, 10.0, 300_000), (10.0, 1e3, 100_000), (1e3, 1e5, 6_000)]),
)
def test_no_rebound_is_beyond_the_sharp_stiff_limit(low, high, count):
    rng = np.random.default_rng(27)
    psi = psi_below_two(rng, count)
    kappa = np.exp(rng.uniform(np.log(low), np.log(high), psi.size))
    result = collide(kappa, psi)
    epsilon_t, bound = stiff_limit(kappa, psi)
    assert np.all(result.switches >= 0)
    np.testing.assert_array_equal(epsilon_t, 0.0)
    excess = np.abs(result.epsilon_t) - result.error_bound - bound
    assert np.all(excess <= 0.0)
    # and it is worth its name: some collision comes near
    assert np.max(np.abs(result.epsilon_t[bound < 1]) / bound[bound < 1]) > 0.5


@pytest.mark.verify
def test_stiff_limit_is_reached_next_to_its_bound():
    """The swing that ends 2.0035/√κ before the contact, found by scanning: 0.99999 of the bound."""
    psi = np.linspace(0.2, 1.99, 40_000)
    share = np.abs(collide(1e5, psi).epsilon_t) / stiff_limit(np.full(psi.shape, 1e5), psi)[1]
    assert 0.999 < share.max() <= 1.0


def test_stiff_limit_is_exact_from_pure_sliding_on_and_never_zero():
    kappa, psi = np.array([18.0, 0.2, 0.2, 1e308]), np.array([2.5, 5.33, 5.32, 1.0])
    epsilon_t, bound = stiff_limit(kappa, psi)
    np.testing.assert_array_equal(epsilon_t, [1 - 2 / 2.5, 1 - 2 / 5.33, 0.0, 0.0])
    np.testing.assert_array_equal(bound[1:3], [1e-15, 1.0])
    assert 0.0 < bound[3] < 1e-300


def test_stiff_limit_says_nothing_beyond_two():
    assert np.isnan(stiff_bound(10.0, 2.0))
    assert np.isnan(stiff_asymptote(10.0, 2.0))
    assert stiff_bound(0.1, 0.1) == 1.0


@pytest.mark.parametrize(
    ("kappa", "largest"),
    every_day([(63.0, 4.342)], of=[(63.0, 4.342), (1e3, 4.480), (1e4, 4.4846)]),
)
def test_sharp_stiff_limit_is_reached_from_below(kappa, largest):
    psi = np.linspace(0.003, 1.999, 20_000)
    stiffness = kappa * np.linspace(0.97, 1.03, 21)[:, None]
    scaled = np.abs(collide(stiffness, psi).epsilon_t) * psi * stiffness**1.25
    assert scaled.max() < STIFF_ASYMPTOTE
    assert scaled.max() == pytest.approx(largest, rel=3e-3)


def test_root_mean_square_follows_the_same_power():
    psi = np.linspace(0.2, 1.9, 2_000)
    kappa = np.linspace(900, 1100, 50)[:, None]
    scaled = collide(kappa, psi).epsilon_t * psi * kappa**1.25
    assert np.sqrt(np.mean(scaled**2)) == pytest.approx(3.31, rel=0.02)


def test_largest_switch_count_tends_to_its_limit():
    kappa = 1e6
    most = collide(kappa, np.linspace(0.5, 1.5, 400)).switches.max()
    assert most == pytest.approx(largest_switch_count(kappa), rel=0.01)


def test_stiffness_kills_the_rebound():
    psi = np.linspace(0.1, 1.9, 200)
    sizes = [np.abs(collide(kappa, psi).epsilon_t).max() for kappa in (1e2, 1e4, 1e6)]
    assert sizes[0] > sizes[1] > sizes[2]


LETTERS = "abcdefghijklmo"


def test_schwager2008_figure5_sequence_of_switches_at_kappa_63():
    """Eq. 24's κ = 63 is the figure's 18/α; the borders in ψ separate sixteen ranges."""
    borders = (2, 1.8168, 1.4745, 1.0394, 0.7761, 0.6058, 0.5656, 0.3804, 0.2762, 0.2294, 0.1175)
    borders += (0.0936, 0.0452, 0.0189, 0.0069)
    edges = np.array([2.4, *borders, 1e-5])
    middles = 0.5 * (edges[1:] + edges[:-1])
    expected = [0, 2, 4, 6, 8, 6, 8, 6, 4, 6, 4, 2, 4, 2, 4, 2]
    np.testing.assert_array_equal(collide(63.0, middles).switches, expected)
    above, below = (collide(63.0, np.array(borders[1:]) + d).switches for d in (2e-4, -2e-4))
    np.testing.assert_array_equal(above, expected[1:-1])
    np.testing.assert_array_equal(below, expected[2:])


def test_schwager2008_figure4_at_its_printed_kappa_never_has_more_than_four_switches():
    assert collide(18.0, np.linspace(1e-3, 3, 20_000)).switches.max() == 4


def test_schwager2008_section43_walk_through_the_letters():
    e, f, g = (motion(63.0, psi) for psi in (0.97, 0.69, 0.585))
    assert (e.switches, f.switches, g.switches) == (8, 6, 8)
    assert e.epsilon_t > 0
    assert f.epsilon_t > 0
    assert g.epsilon_t < 0
    assert reversals(e) == 4
    assert reversals(f) == 4
    # the first switch of e is just before the largest compression
    assert 0.45 * CONTACT_DURATION < e.start[1] < 0.5 * CONTACT_DURATION


def test_schwager2008_figure6_first_minimum():
    path = motion(100.0, 0.3)
    # sticking begins at once; the velocity is smallest a quarter swing after z = 0
    assert path.switches == 6
    from restitution.mechanics.curves import tangential_curves  # noqa: PLC0415 - only here

    time = np.linspace(0, 1.3, 2001)
    velocity = tangential_curves(path, time).velocity
    first = np.flatnonzero((velocity[1:-1] < velocity[:-2]) & (velocity[1:-1] < velocity[2:]))[0]
    assert time[first + 1] == pytest.approx(1.07, abs=0.01)
