"""η of a contact whose ε_n is known: the inverse of ε_n(η), over all that there is."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from restitution.mechanics.contact import LEAST_RESTITUTION, damping_of, normal_restitution

KNOWN = {
    0.97: 0.02651239,
    0.9: 0.09283811,
    0.8: 0.20113666,
    0.5: 0.69804094,
    0.2: 2.10960479,
}
"""Eq. 1 integrated in 30-digit arithmetic, and inverted."""


@pytest.mark.parametrize(("restitution", "damping"), KNOWN.items())
def test_damping_of_a_restitution_has_the_known_values(restitution, damping):
    assert damping_of(restitution) == pytest.approx(damping, abs=5e-9)


def test_damping_is_that_of_restitutions_to_45_digits(damped_reference):
    for row in damped_reference:
        # of ε_n as a double there is half a unit of rounding, over dε_n/dη
        slope = max(1.0, 1.0 / row.epsilon_n)
        assert damping_of(row.epsilon_n) == pytest.approx(row.damping, rel=1e-13, abs=1e-14 * slope)


def test_restitution_comes_back_within_1e_9_and_so_does_damping():
    for restitution in np.linspace(0.01, 1.0, 400).tolist():
        damping = damping_of(restitution)
        assert normal_restitution(damping) == pytest.approx(restitution, rel=0, abs=4e-15)
        assert damping_of(normal_restitution(damping)) == pytest.approx(damping, rel=0, abs=1e-9)


@given(
    st.one_of(
        st.floats(-49.8, 0.0).map(lambda power: 10.0**power),
        st.floats(-16.0, 0.0).map(lambda power: 1.0 - 0.99 * 10.0**power),
    )
)
@example(LEAST_RESTITUTION)
@example(math.nextafter(1.0, 0.0))
def test_restitution_comes_back_as_it_is_said(restitution):
    back = normal_restitution(damping_of(restitution))
    assert abs(back - restitution) <= min(4e-15, 5e-14 * restitution)


def test_damping_rises_from_nothing_as_restitution_falls_from_one():
    assert damping_of(1.0) == 0.0
    restitutions = np.geomspace(LEAST_RESTITUTION, 1.0, 300)[::-1]
    assert np.all(np.diff([damping_of(each) for each in restitutions.tolist()]) > 0.0)
    # the limits of Eq. 1: 1 − 1.1534η, and 1.3104 η^{-5/3}
    assert 1.15344 * damping_of(1.0 - 1e-6) == pytest.approx(1e-6, abs=1e-11)
    assert damping_of(1e-30) == pytest.approx((1.3103707 / 1e-30) ** 0.6, rel=1e-7)
