"""The damped normal motion: published values, its equation, its limits."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from restitution.errors import ParameterError
from restitution.mechanics.contact import (
    contact_duration,
    contact_of,
    largest_compression,
    largest_force,
    normal_curves,
    normal_restitution,
)
from restitution.mechanics.hertz import CONTACT_DURATION, MAXIMUM_FORCE

DOCUMENT = (Path(__file__).parents[2] / "docs" / "model.md").read_text()

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


@pytest.mark.parametrize("damping", EPSILON_N)
def test_normal_restitution_and_duration_agree_with_forty_digits(damping):
    contact = contact_of(damping)
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


def older_end(damping):
    """Return ε_n and t_c of a contact that ends at x = 0, by a general solver."""

    def rates(_, state):
        root, rate, _ = state
        return rate, -2.0 * root**2 * (root**2 + damping * rate), 2.0 * root

    def touching(_, state):
        return state[0]

    touching.terminal, touching.direction = True, -1
    start = (0.0, 1.0, 0.0)
    solution = solve_ivp(rates, (0, 9), start, "DOP853", events=touching, rtol=1e-12, atol=1e-14)
    return -solution.y[1, -1], solution.y[2, -1]


TABLE = re.findall(r"^\| ([\d.]+) \|(.*)\|$", DOCUMENT, re.MULTILINE)


@pytest.mark.parametrize(("damping", "cells"), TABLE)
def test_older_end_of_contact_is_off_by_what_the_document_says(damping, cells):
    eta = float(damping)
    restitution, older_restitution, duration, older_duration = map(float, cells.split("|"))
    # the digits of the document
    assert normal_restitution(eta) == pytest.approx(restitution, abs=5.1e-7)
    assert contact_duration(eta) == pytest.approx(duration, abs=5.1e-6)
    assert older_end(eta) == pytest.approx((older_restitution, older_duration), abs=5.1e-6)
    assert older_end(eta)[0] == pytest.approx(older_restitution, abs=5.1e-7)


def test_older_end_of_contact_differs_by_five_halves_powers_of_weak_damping():
    eta = 3e-3
    restitution, duration = older_end(eta)
    lost = 4 / 15 * normal_restitution(eta) ** 1.5 * eta**2.5
    # the next terms are η^{5/2} times smaller
    assert normal_restitution(eta) - restitution == pytest.approx(lost, rel=1e-4)
    assert duration - contact_duration(eta) == pytest.approx(eta, rel=1e-5)


def test_weak_damping_goes_over_into_none():
    contact = contact_of(1e-17)
    assert contact.duration == pytest.approx(CONTACT_DURATION, rel=1e-15)
    assert contact.peak == pytest.approx(MAXIMUM_FORCE, rel=1e-15)
    assert contact.impulse == 2.0


@pytest.mark.parametrize("damping", [-0.1, 2e30, float("inf"), float("nan")])
def test_damping_beyond_the_range_is_refused_in_words(damping):
    with pytest.raises(ParameterError, match="damping must be from 0 to 1e\\+30"):
        contact_of(damping)


@pytest.mark.parametrize("damping", [0.0, 1e-12, 0.003, 0.1, 0.7, 1.0, 1.5, 30.0, 1e10])
def test_largest_compression_and_force_are_those_of_the_curves(damping):
    time = np.linspace(0.0, contact_duration(damping), 20_001)
    curves = normal_curves(time, damping)
    assert largest_compression(damping) == pytest.approx(curves[0].max(), rel=1e-7)
    assert largest_force(damping) == pytest.approx(curves[2].max(), rel=1e-6)
    # between samples the curves only rise
    assert largest_compression(damping) >= curves[0].max() * (1 - 1e-15)
