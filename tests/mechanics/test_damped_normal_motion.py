"""The damped normal motion as a curve: its equation, its shape, its energy."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from restitution.mechanics.contact import MOST_DAMPING, contact_of
from restitution.mechanics.damped.motion import curvature_at, damped_motion, rate_at

dampings = st.builds(lambda m, e: m * 10.0**e, st.floats(1, 9.99), st.integers(-300, 29))


def states(contact, falling, positions):
    rows = np.array([damped_motion(contact, falling, float(q)) for q in positions])
    return rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3]


@given(dampings)
@example(1.0)
@example(1e-300)
@example(MOST_DAMPING)
def test_contact_is_continuous_and_its_force_is_that_of_the_equation(damping):
    contact = contact_of(damping)
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
    contact = contact_of(damping)
    for half, end in ((False, contact.rising_end), (True, contact.falling_end)):
        root, cap, _, _ = states(contact, half, np.linspace(0.0, end, 400))
        assert np.all(np.diff(root * cap) > -1e-15 * contact.peak)


# below, its least value, −.35/η², tells nothing but its sign
@given(dampings.filter(lambda damping: damping > 1e-20))
def test_curvature_has_the_extrema_that_the_events_rely_on(damping):
    contact = contact_of(damping)
    end = contact.rising_end + contact.falling_end
    marks = [0.0, contact.valley, contact.ridge, end] if contact.ridge > 0 else [0.0, end]
    for i, (low, high) in enumerate(pairwise(marks)):
        positions = np.linspace(low, high, 200)[1:-1]
        values = np.array([curvature_at(contact, x)[0] for x in positions])
        steps = np.diff(values) * (-1.0 if i % 2 == 0 else 1.0)
        # in the long tail of strong damping it is constant
        assert np.all(steps >= -1e-9 * np.abs(values[1:]))


def test_energy_is_lost_to_damping_alone():
    # d(ẋ²/2 + (2/5) x^{5/2})/dt = −η √x ẋ², whatever way the motion was found
    contact = contact_of(0.3)
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
