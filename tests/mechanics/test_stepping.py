"""Fixed time steps: the errors that codes of discrete elements make, and where they fail."""

import itertools

import numpy as np
import pytest

from restitution.mechanics.collision import collide
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.mechanics.limits import weak_limit
from restitution.mechanics.stepping import (
    INTEGRATORS,
    LOCK_STEP,
    most_steps,
    normal_step,
    step_collisions,
    stepped_course,
)


def grid():
    """The uniform grid of the figures in docs/model.md."""
    kappa, psi = np.meshgrid(np.linspace(1, 70, 40), np.linspace(0.03, 2.8, 40))
    return kappa.ravel(), psi.ravel()


def errors(steps, integrator="velocity_verlet", phase=0.0):
    kappa, psi = grid()
    stepped = step_collisions(kappa, psi, steps, integrator, phase)
    return np.abs(stepped.epsilon_t - collide(kappa, psi).epsilon_t)


# found twice before, with other programs, to the digits given; so within half of the last one
@pytest.mark.parametrize(
    ("steps", "median", "p95", "worst"), [(50, 4e-4, 1.4e-2, 0.15), (1000, 9e-7, 3e-5, 4e-4)]
)
def test_error_of_verlet_is_the_known_one(steps, median, p95, worst):
    error = errors(steps)
    assert np.median(error) == pytest.approx(median, rel=0.15)
    assert np.quantile(error, 0.95) == pytest.approx(p95, rel=0.15)
    assert error.max() == pytest.approx(worst, rel=0.15)


def test_verlet_is_of_second_order_and_forward_euler_of_first():
    for integrator, order in (("velocity_verlet", 2.0), ("forward_euler", 1.0)):
        coarse, fine = (np.median(errors(steps, integrator)) for steps in (500, 4000))
        assert np.log(coarse / fine) / np.log(8) == pytest.approx(order, abs=0.15), integrator


@pytest.mark.parametrize("phase", [0.0, 0.37])
@pytest.mark.parametrize("damping", [0.0, 0.1, 2.0])
def test_symplectic_euler_is_verlet_seen_at_other_instants(phase, damping):
    # no force acts before the contact nor after it, so half a kick more at either end is none
    kappa, psi = grid()
    verlet, euler = (
        step_collisions(kappa, psi, 50, integrator, phase, damping=damping)
        for integrator in ("velocity_verlet", "symplectic_euler")
    )
    np.testing.assert_allclose(verlet.epsilon_t, euler.epsilon_t, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(verlet.switches, euler.switches)


def test_forward_euler_gains_energy():
    kappa, psi = grid()
    for steps, least in ((50, 3.0), (1000, 1.0)):
        assert np.abs(step_collisions(kappa, psi, steps, "forward_euler").epsilon_t).max() > least


@pytest.mark.parametrize("integrator", ["velocity_verlet", "symplectic_euler"])
@pytest.mark.parametrize("kappa", [100.0, 1e4])
def test_swing_is_stable_down_to_the_limit_and_not_below(integrator, kappa):
    limit = np.sqrt(kappa) * CONTACT_DURATION / 2
    weak = np.array([1e-9])
    above = step_collisions(np.array([kappa]), weak, int(limit * 1.05) + 1, integrator)
    below = step_collisions(np.array([kappa]), weak, int(limit * 0.95), integrator)
    # a stable one is out of phase, but swings no further than its modified energy allows
    assert abs(above.epsilon_t[0]) < 5.0
    assert abs(below.epsilon_t[0]) > 1e3


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_phase_of_one_is_that_of_nought_a_step_later(integrator):
    kappa, psi = grid()
    whole, none = (step_collisions(kappa, psi, 50, integrator, phase) for phase in (1.0, 0.0))
    np.testing.assert_array_equal(whole.epsilon_t, none.epsilon_t)
    np.testing.assert_array_equal(whole.switches, none.switches)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_contact_ends_within_the_bound_on_steps(integrator):
    for steps, phase in itertools.product([*range(4, 60), 1000], np.linspace(0, 1, 11)):
        dt = CONTACT_DURATION / steps
        x, rate, force = -phase * dt, 1.0, 0.0
        touched, taken = False, 0
        while not (touched and x <= 0.0):
            touched = x > 0.0
            x, rate, force = normal_step(dt, INTEGRATORS[integrator], 0.0, x, rate, force)
            taken += 1
        assert taken <= most_steps(steps), (steps, phase)


def test_switches_tend_to_the_exact_ones_and_are_even():
    kappa, psi = grid()
    exact = collide(kappa, psi).switches
    wrong = []
    for steps in (20, 200, 20_000):
        switches = step_collisions(kappa, psi, steps).switches
        assert np.all(switches % 2 == 0)
        wrong.append(np.mean(switches != exact))
    assert wrong[0] > 0.1
    assert wrong[0] > wrong[1] > wrong[2]
    assert wrong[2] < 0.005


@pytest.mark.parametrize("psi", [0.0, 5e-324, 1e-100])
def test_weak_collision_swings_freely_but_for_its_last_half_kick(psi):
    # ψ = 0 stands for the limit, of which the spring knows by ψ = 1e-100. The force is still there
    # when the contact ends, and the last half kick is not: an error of first order
    kappa, steps = np.array([0.9, 18.0]), 20_000
    stepped = step_collisions(kappa, np.full(2, psi), steps)
    omega = np.sqrt(kappa)
    not_taken = 0.5 * CONTACT_DURATION / steps * omega * np.sin(omega * CONTACT_DURATION)
    np.testing.assert_allclose(stepped.epsilon_t - weak_limit(kappa), not_taken, rtol=0.01)


def test_smooth_spheres_keep_their_velocity_in_any_steps():
    stepped = step_collisions(np.array([1.0, 1e300]), np.full(2, np.inf), 4)
    np.testing.assert_array_equal(stepped.epsilon_t, 1.0)
    np.testing.assert_array_equal(stepped.switches, 0)


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("steps", [4, 50, 333])
@pytest.mark.parametrize("phase", [0.0, 0.61, 1.0])
def test_result_is_finite_over_all_doubles(integrator, steps, phase):
    rng = np.random.default_rng(7)
    bits = rng.integers(1, 0x7FEFFFFFFFFFFFFF, (2, 4000), dtype=np.uint64)
    kappa, psi = bits.view(np.float64).copy()
    kappa[:4] = psi[:2] = psi[4] = 1.7976931348623157e308
    kappa[4:8] = psi[2] = psi[5] = 5e-324
    psi[10:14] = 0.0, np.inf, 5e-324, 2.0
    stepped = step_collisions(kappa, psi, steps, integrator, phase)
    assert np.all(np.isfinite(stepped.epsilon_t))
    assert np.all(stepped.switches % 2 == 0)
    # what the caps can take or give in all, with a generous 8 for the steps that overshoot
    assert np.all(np.abs(stepped.epsilon_t - 1.0) <= 8.0 / np.maximum(psi, 1e-100))


def test_collisions_do_not_depend_on_their_neighbours():
    rng = np.random.default_rng(3)
    kappa, psi = rng.uniform(0.1, 70, 3 * LOCK_STEP + 5), rng.uniform(0.01, 3, 3 * LOCK_STEP + 5)
    together = step_collisions(kappa, psi, 50)
    alone = step_collisions(kappa, psi, 50, together=1)
    # vector code may fuse other products and sums
    np.testing.assert_allclose(together.epsilon_t, alone.epsilon_t, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(together.switches, alone.switches)


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("phase", [0.0, 0.25])
def test_course_ends_where_the_collision_does(integrator, phase):
    time, force, velocity = stepped_course(18.0, 0.4, 50, integrator, phase)
    stepped = step_collisions(np.array([18.0]), np.array([0.4]), 50, integrator, phase)
    assert velocity[-1] / velocity[0] == pytest.approx(stepped.epsilon_t[0], abs=1e-12)
    assert force[0] == force[-1] == 0.0
    step = CONTACT_DURATION / 50
    np.testing.assert_allclose(np.diff(time[1:]), step, rtol=1e-12)
    assert time[1] == pytest.approx((1 - phase) * step)
