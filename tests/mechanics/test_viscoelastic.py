"""The damped normal motion: published values, its equation, its limits."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from restitution.errors import ParameterError
from restitution.mechanics.damped_curves import damped_normal_curves
from restitution.mechanics.hertz import CONTACT_DURATION, MAXIMUM_FORCE, normal_curves
from restitution.mechanics.viscoelastic import (
    MOST_DAMPING,
    contact_duration,
    curvature_at,
    damped_motion,
    largest_compression,
    largest_force,
    normal_contact,
    normal_restitution,
    rate_at,
)

# 22 digits by Taylor series of order 40 in 40-digit arithmetic, ended where x + ηẋ = 0
EPSILON_N = {
    0.01: 0.98854743964272943376,
    0.1: 0.89285887550655333376,
    0.3: 0.7220854396535049095,
    1.0: 0.39393060322987319305,
    10.0: 0.025095704431518392412,
}
DURATION = {
    0.01: 3.2117983001539445604,
    0.1: 3.1572556558025706993,
    0.3: 3.047215355833710377,
    1.0: 2.7520265740390496633,
    10.0: 1.6307154446562342098,
}

dampings = st.builds(lambda m, e: m * 10.0**e, st.floats(1, 9.99), st.integers(-300, 29))


@pytest.mark.parametrize("damping", EPSILON_N)
def test_normal_restitution_and_duration_agree_with_forty_digits(damping):
    contact = normal_contact(damping)
    assert normal_restitution(damping) == pytest.approx(EPSILON_N[damping], rel=1e-14, abs=0)
    duration = contact.duration / contact.unit
    assert duration == pytest.approx(DURATION[damping], rel=1e-14, abs=0)


def test_normal_restitution_mueller2011_pade():
    # Müller & Pöschel, PRE 84, 021302: a fit in √η, off by what docs/model.md states
    above = np.polynomial.Polynomial([1, 1.07232, 0.574198, 0.141552])
    below = np.polynomial.Polynomial([1, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585])
    for damping, off in ((0.15, 3e-7), (0.75, 6e-5), (1.5, 3e-4)):
        root = np.sqrt(damping)
        assert abs(above(root) / below(root) - normal_restitution(damping)) < off


def test_normal_restitution_falls_by_its_first_coefficient_for_weak_damping():
    # 1.15344 as printed in docs/model.md; the next term is of order η^{6/5} at most
    for damping in (1e-9, 1e-7):
        assert (1.0 - normal_restitution(damping)) / damping == pytest.approx(1.15345, abs=2e-5)


def test_normal_restitution_tends_to_its_power_law_for_strong_damping():
    # all the velocity goes into x^{3/2} = 3/(2η), from which the spheres creep back at x/η
    for damping in (1e8, 1e20):
        limit = 1.5 ** (2 / 3) * damping ** (-5 / 3)
        assert normal_restitution(damping) == pytest.approx(limit, rel=1e-11, abs=0)


def test_normal_restitution_falls_monotonically_without_a_jump_between_units():
    values = [normal_restitution(float(n)) for n in np.geomspace(1e-4, 1e4, 200)]
    assert np.all(np.diff(values) < 0)
    below = normal_restitution(np.nextafter(1.0, 0.0))
    assert below == pytest.approx(normal_restitution(1.0), rel=1e-14)


def test_older_end_of_contact_gives_a_smaller_normal_restitution():
    # at x = 0, by a general solver in the variables of the module
    def rates(_, state):
        root, rate = state
        return rate, -2.0 * root**2 * (root**2 + 0.1 * rate)

    def touching(_, state):
        return state[0]

    touching.terminal, touching.direction = True, -1
    solution = solve_ivp(rates, (0, 5), (0, 1), "DOP853", events=touching, rtol=1e-11, atol=1e-13)
    assert -solution.y[1, -1] == pytest.approx(0.89214759, abs=1e-8)
    assert normal_restitution(0.1) == pytest.approx(0.89285888, abs=1e-8)


def test_weak_damping_goes_over_into_none():
    contact = normal_contact(1e-17)
    assert contact.duration == pytest.approx(CONTACT_DURATION, rel=1e-15)
    assert contact.peak == pytest.approx(MAXIMUM_FORCE, rel=1e-15)
    assert contact.impulse == 2.0


def states(contact, falling, positions):
    rows = np.array([damped_motion(contact, falling, float(q)) for q in positions])
    return rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3]


@given(dampings)
@example(1.0)
@example(1e-300)
@example(MOST_DAMPING)
def test_contact_is_continuous_and_its_force_is_that_of_the_equation(damping):
    contact = normal_contact(damping)
    # both halves at the largest force; the last bits of a long tail add up
    rising = damped_motion(contact, False, contact.rising_end)
    falling = damped_motion(contact, True, contact.falling_end)
    assert rising[0] == pytest.approx(falling[0], rel=1e-13)
    assert rising[1] == pytest.approx(falling[1], rel=1e-13)
    assert rising[2] + falling[2] == pytest.approx(contact.impulse, rel=1e-13)
    for half, end in ((False, contact.rising_end), (True, contact.falling_end)):
        positions = np.linspace(0.0, end, 200)[1:]
        root, cap, loss, time = states(contact, half, positions)
        rate = np.array([rate_at(contact, half, x) for x in loss])
        force = contact.a * root**2 + contact.b * rate
        # where it cancels, towards the end, only to the rounding of its terms
        terms = contact.a * root**2 + contact.b * np.abs(rate)
        np.testing.assert_array_less(np.abs(cap - force), 3e-14 * terms)
        assert np.all(cap > 0)
        assert np.all(np.diff(loss) > 0)
        assert np.all(np.diff(time) > 0)


@given(dampings)
def test_force_rises_once_and_falls_once(damping):
    contact = normal_contact(damping)
    for half, end in ((False, contact.rising_end), (True, contact.falling_end)):
        root, cap, _, _ = states(contact, half, np.linspace(0.0, end, 400))
        assert np.all(np.diff(root * cap) > -1e-15 * contact.peak)


# below, its least value, −.35/η², tells nothing but its sign
@given(dampings.filter(lambda damping: damping > 1e-20))
def test_curvature_has_the_extrema_that_the_events_rely_on(damping):
    contact = normal_contact(damping)
    end = contact.rising_end + contact.falling_end
    marks = [0.0, contact.valley, contact.ridge, end] if contact.ridge > 0 else [0.0, end]
    for i, (low, high) in enumerate(pairwise(marks)):
        positions = np.linspace(low, high, 200)[1:-1]
        values = np.array([curvature_at(contact, x) for x in positions])
        steps = np.diff(values) * (-1.0 if i % 2 == 0 else 1.0)
        # in the long tail of strong damping it is constant
        assert np.all(steps >= -1e-9 * np.abs(values[1:]))


def test_energy_is_lost_to_damping_alone():
    # d(ẋ²/2 + (2/5) x^{5/2})/dt = −η √x ẋ², whatever way the motion was found
    contact = normal_contact(0.3)
    root, cap, loss, time = states(contact, False, np.linspace(0.0, contact.rising_end, 4001))
    rate = 1.0 - loss
    energy = 0.5 * rate**2 + 0.4 * root**5
    # by Simpson's rule in q, dt = 2√x dq
    power = 0.3 * root * rate**2 * 2.0 * root
    step = contact.rising_end / 4000
    lost = step / 3 * (power[0] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum() + power[-1])
    assert energy[0] - energy[-1] == pytest.approx(lost, rel=1e-12)
    assert np.all(cap[1:] * root[1:] > 0)
    assert time[-1] == contact.peak_time


@pytest.mark.parametrize("damping", [-0.1, 0.0, 2e30, float("inf"), float("nan")])
def test_damping_beyond_the_range_is_refused_in_words(damping):
    with pytest.raises(ParameterError, match="damping must be > 0 and at most 1e\\+30"):
        normal_contact(damping)


@pytest.mark.parametrize("damping", [0.0, 1e-12, 0.003, 0.1, 0.7, 1.0, 1.5, 30.0, 1e10])
def test_largest_compression_and_force_are_those_of_the_curves(damping):
    time = np.linspace(0.0, contact_duration(damping), 20_001)
    curves = normal_curves(time) if damping == 0.0 else damped_normal_curves(damping, time)
    assert largest_compression(damping) == pytest.approx(curves[0].max(), rel=1e-7)
    assert largest_force(damping) == pytest.approx(curves[2].max(), rel=1e-6)
    # between samples the curves only rise
    assert largest_compression(damping) >= curves[0].max() * (1 - 1e-15)
