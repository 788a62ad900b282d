"""ε_t changes no faster from one collision to another than `variation` says."""

import numpy as np
import pytest

from cases import every_day
from restitution.mechanics.collision import collide
from restitution.mechanics.contact import contact_duration, largest_force, normal_curves
from restitution.mechanics.variation import (
    FIRST_SWING,
    HELD_BY_THE_CAP,
    PHASE_SHARE,
    Range,
    change_by_damping,
    change_by_stiffness,
    change_by_velocity,
    largest_force_between,
    possible_range,
)
from samples import log_uniform

DAMPINGS = pytest.mark.parametrize(
    "damping", every_day([0.0, 0.1, 100.0], of=[0.0, 1e-3, 0.1, 0.58, 3.0, 100.0])
)
N = 40_000


def epsilon_t(kappa, psi, damping=0.0):
    return collide(kappa, psi, damping).epsilon_t


def around(rng, centre):
    """Return ends about values, near and far, and values between them."""
    spread = log_uniform(rng, 1e-6, 1.0, centre.size)
    low, high = centre * np.exp(-spread), centre * np.exp(spread)
    return low, high, centre * np.exp(rng.uniform(-1.0, 1.0, centre.size) * spread)


@DAMPINGS
def test_change_by_stiffness_is_never_exceeded_and_nearly_reached(damping):
    rng = np.random.default_rng(1)
    kappa, psi = log_uniform(rng, 1e-3, 1e5, N), log_uniform(rng, 1e-4, 20.0, N)
    low, high, other = around(rng, kappa)
    force = np.full(N, largest_force(damping))
    bound = change_by_stiffness(low, kappa, high, psi, force)
    change = np.abs(epsilon_t(other, psi, damping) - epsilon_t(kappa, psi, damping))
    assert np.all(change <= bound + 1e-11)
    # strong damping makes the contact shorter than the bound has it
    assert np.max(change / bound) > (0.5 if damping < 10.0 else 0.1)


@DAMPINGS
def test_change_by_velocity_is_never_exceeded_and_reached(damping):
    rng = np.random.default_rng(2)
    kappa, psi = log_uniform(rng, 1e-3, 1e4, N), log_uniform(rng, 1e-3, 20.0, N)
    low, high, other = around(rng, psi)
    known = epsilon_t(kappa, psi, damping)
    least, most = change_by_velocity(Range(known, known), low, psi, high)
    found = epsilon_t(kappa, other, damping)
    assert np.all((found >= least - 1e-11) & (found <= most + 1e-11))
    # where it slides throughout u falls by as much whatever it is
    assert np.max((found - known) / (most - known)) > 0.85


@pytest.mark.parametrize("count", every_day([25], of=[25, 60]))
def test_change_by_damping_is_never_exceeded_and_reached_within_a_factor_of_three(count):
    rng = np.random.default_rng(3)
    etas = np.concatenate([[0.0], log_uniform(rng, 1e-5, 100.0, count)])
    nearest = 0.0
    for eta in etas.tolist():
        kappa, psi = log_uniform(rng, 1e-3, 1e5, 1000), log_uniform(rng, 1e-3, 20.0, 1000)
        known = epsilon_t(kappa, psi, eta)
        for step in (1e-3, 0.3):
            other = eta * (1.0 + step) if eta else step
            bound = change_by_damping(*np.full((3, 1000), [[eta], [eta], [other]]), psi)
            change = np.abs(epsilon_t(kappa, psi, other) - known)
            assert np.all(change <= bound + 1e-11)
            nearest = max(nearest, np.max(change / bound))
    assert nearest > 1 / 3


@pytest.mark.parametrize("eta", np.geomspace(1e-6, 1e6, 25))
def test_force_changes_with_damping_no_faster_than_said(eta):
    step, longest = 1e-4 * eta, contact_duration(0.0)
    shares = np.linspace(0.0, 1.0, 20_001) ** 2
    duration = contact_duration(eta - step)
    time = np.concatenate([longest * shares, duration * (1.0 - shares), duration * shares])

    def force(damping):
        during = np.minimum(time, contact_duration(damping))
        return np.where(time == during, normal_curves(during, damping)[2], 0.0)

    slope = np.max(np.abs(force(eta + step) - force(eta - step))) / (2.0 * step)
    said = change_by_damping(*np.array([[eta], [eta], [eta + 1e-3 * eta]]), np.ones(1))
    said /= 1e-3 * eta
    assert 0.4 * said[0] < duration * slope < said[0] or eta > 100.0


@pytest.mark.parametrize("damping", [0.0, 0.3])
def test_possible_range_holds_what_is_possible(damping):
    rng = np.random.default_rng(4)
    kappa, psi = log_uniform(rng, 1e-4, 1e6, N), log_uniform(rng, 1e-9, 20.0, N)
    least, most, inside = around(rng, kappa)
    low, high, between = around(rng, psi)
    force = np.full(N, largest_force(damping))
    possible = possible_range((least, kappa, most), (low, high), force, damped=damping > 0.0)
    found = epsilon_t(inside, between, damping)
    assert np.all((found >= possible.low - 1e-11) & (found <= possible.high + 1e-11))
    narrow = possible.high - possible.low < 0.5
    # stiff ones, and without damping weak and strong ones
    assert narrow.mean() > (0.05 if damping else 0.15)


def test_largest_force_between_is_that_of_one_damping_or_more():
    rng = np.random.default_rng(5)
    etas = log_uniform(rng, 1e-6, 1e8, 500)
    forces = np.array([largest_force(float(eta)) for eta in etas])
    one = largest_force_between(etas[:1], etas[:1])
    assert one[0] == forces[0]
    bound = largest_force_between(0.9 * etas, etas)
    assert np.all(forces <= bound)
    assert np.all(bound <= 1.4 * forces)


def test_constants_are_their_maxima_rounded_up():
    phase = np.linspace(1e-3, 60.0, 600_001)
    share = np.sqrt(phase**2 - phase * np.sin(2 * phase) + np.sin(phase) ** 2) / (2 * phase)
    assert share.max() < PHASE_SHARE < 1.0001 * share.max()
    assert np.pi**2 / 8 < FIRST_SWING < 1.0001 * np.pi**2 / 8
    assert HELD_BY_THE_CAP > 1.851
