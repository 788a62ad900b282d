"""The normal motion against its defining integral, its energy and its symmetry."""

import mpmath
import numpy as np
import pytest

from restitution.mechanics.contact import normal_curves
from restitution.mechanics.hertz import (
    CONTACT_DURATION,
    HALF_CONTACT,
    HALF_CONTACT_ROOT,
    MAXIMUM_COMPRESSION,
    MAXIMUM_FORCE,
    normal_motion,
)

ROUNDING = 2.0**-52


def time_of_angle(theta: mpmath.mpf) -> mpmath.mpf:
    """t with ẋ = cos θ: (4/5)^{3/5} ∫₀^θ sin^{-1/5}."""
    with mpmath.workdps(40):
        share = mpmath.betainc(mpmath.mpf(2) / 5, 0.5, 0, mpmath.sin(theta) ** 2) / 2
        return (mpmath.mpf(4) / 5) ** (mpmath.mpf(3) / 5) * share


def test_contact_duration_is_a_beta_function():
    with mpmath.workdps(30):
        exact = mpmath.mpf("0.8") ** mpmath.mpf("0.6") * mpmath.beta(mpmath.mpf("0.4"), 0.5)
    assert float(exact) == CONTACT_DURATION
    assert pytest.approx(HALF_CONTACT_ROOT**2, rel=ROUNDING) == HALF_CONTACT


@pytest.mark.parametrize("theta", [1e-60, 1e-8, 1e-3, 0.1, 0.5, 1.0, 1.3, 1.5, 1.57])
def test_normal_motion_is_relatively_exact_from_touch_to_largest_compression(theta):
    # q itself is rounded, which moves √x ∝ q by one rounding and 1 − ẋ ∝ q⁵ by up to five
    with mpmath.workdps(40):
        angle = mpmath.mpf(theta)
        q = float(mpmath.sqrt(time_of_angle(angle)))
        root = ((5 * mpmath.sin(angle) ** 2 / 4) ** (mpmath.mpf(1) / 5)).real
        loss = 2 * mpmath.sin(angle / 2) ** 2
        found_root, found_loss = normal_motion(q)
        assert abs(found_root / root - 1) < 2 * ROUNDING
        assert abs(found_loss / loss - 1) < 6 * ROUNDING


def test_energy_is_conserved():
    x, rate, _ = normal_curves(np.linspace(0, CONTACT_DURATION, 1001))
    # of x within 2 roundings, times 2.5, and of ẋ within 2, twice
    np.testing.assert_allclose(rate**2 + 0.8 * x**2.5, 1.0, rtol=0, atol=5 * ROUNDING)


def test_motion_is_mirror_symmetric_about_half_the_contact():
    # both times are rounded, by up to 2e-16, and near the ends √x has an infinite slope in them
    distance = np.arange(1, 24) / 16
    before = normal_curves(HALF_CONTACT - distance)
    after = normal_curves(HALF_CONTACT + distance)
    np.testing.assert_allclose(before[0], after[0], atol=1e-15)
    np.testing.assert_allclose(before[1], -after[1], rtol=0, atol=1e-15)
    np.testing.assert_allclose(before[2], after[2], atol=1e-15)


def test_halves_meet_at_the_largest_compression():
    x, rate, force = normal_curves(HALF_CONTACT)
    assert x == pytest.approx(MAXIMUM_COMPRESSION, rel=2 * ROUNDING)
    assert force == pytest.approx(MAXIMUM_FORCE, rel=4 * ROUNDING)
    assert abs(rate) < 4 * ROUNDING


def test_newtons_law_holds():
    step = 1e-5
    time = np.linspace(0.1, 3.1, 201)
    rate_before, rate_after = (normal_curves(time + d)[1] for d in (-step, step))
    # a central difference of double precision: truncation and rounding are both near 1e-10
    np.testing.assert_allclose(
        (rate_after - rate_before) / (2 * step), -normal_curves(time)[2], atol=2e-9
    )


def test_times_outside_the_contact_are_a_bug_of_the_caller():
    with pytest.raises(AssertionError):
        normal_curves([0.0, 3.3])
