"""Every method with damping: what they give, what they refuse, what they may cost."""

import numpy as np
import pytest

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import collide
from restitution.mechanics.contact import contact_duration, normal_restitution
from restitution.methods import exact, planner
from restitution.methods.options import Options

KAPPA = np.array([18.0, 63.0, 5.0, 200.0, 0.8, 1.4])
PSI = np.array([0.2142857143, 1.0, 0.5, 0.3, 0.5, 1.7])
DAMPINGS = (1e-6, 0.05, 0.3, 2.0, 30.0)


def solve(method, damping, quantities=("epsilon_t",), **options):
    return planner.solve(KAPPA, PSI, quantities, Options(method=method, damping=damping, **options))


@pytest.mark.parametrize("damping", DAMPINGS)
def test_general_solver_converges_to_the_exact_result(damping):
    # another way: DOP853 in time, with events, the contact's end being one of them
    truth = solve("exact", damping)
    answer = solve("ode", damping, rtol=1e-11)
    # it locates an event only as well as its steps allow: 1.3e-8 is the largest error seen
    np.testing.assert_allclose(answer.epsilon_t, truth.epsilon_t, rtol=0, atol=2e-8)
    np.testing.assert_array_equal(answer.switches, truth.switches)


@pytest.mark.parametrize("integrator", ["velocity_verlet", "symplectic_euler", "forward_euler"])
@pytest.mark.parametrize("damping", DAMPINGS)
def test_time_steps_converge_to_the_exact_result(damping, integrator):
    # of first order: the force takes the rate that is known before the last kick
    truth = solve("exact", damping).epsilon_t
    coarse, fine = (
        np.abs(solve("timestep", damping, steps=n, integrator=integrator).epsilon_t - truth)
        for n in (4000, 64_000)
    )
    # forward Euler is as far off without damping
    assert fine.max() < 6e-4
    assert np.median(fine) < 0.2 * np.median(coarse)


def test_time_steps_without_damping_are_those_of_damping_that_vanishes():
    none, vanishing = (solve("timestep", damping, steps=200) for damping in (0.0, 1e-200))
    np.testing.assert_allclose(none.epsilon_t, vanishing.epsilon_t, rtol=0, atol=1e-13)


def test_coulomb_takes_the_normal_restitution():
    answer = planner.solve(
        np.array([20.0]), np.array([3.0]), ("epsilon_t",), Options(method="coulomb", damping=0.3)
    )
    assert answer.epsilon_t[0] == 1.0 - (1.0 + normal_restitution(0.3)) / 3.0
    assert answer.error_bound[0] < 0.01


@pytest.mark.parametrize("method", ["stiff", "table"])
def test_methods_made_without_damping_refuse_it_by_name(method):
    with pytest.raises(ParameterError, match=r"another one for damping = 0\.05") as refused:
        solve(method, 0.05)
    assert refused.value.parameter == "method"


def test_auto_takes_neither_stiff_limit_nor_table():
    rng = np.random.default_rng(1)
    kappa, psi = rng.uniform(1, 900, 20_000), rng.uniform(0.01, 3, 20_000)
    answer = planner.solve(kappa, psi, ("epsilon_t",), Options(tolerance=0.1, damping=0.1))
    assert set(answer.method) == {"exact", "coulomb"}


def test_auto_answers_what_is_too_stiff_with_a_bound_that_says_so():
    kappa, psi = np.array([1e12, 1e40]), np.array([0.5, 1.0])
    answer = planner.solve(kappa, psi, ("epsilon_t",), Options(damping=0.1))
    assert set(answer.method) == {"coulomb"}
    np.testing.assert_array_equal(answer.epsilon_t, 0.0)
    # P_max/(ψ√κ)
    assert np.all(answer.error_bound * psi * np.sqrt(kappa) == pytest.approx(1.10, abs=0.05))
    with pytest.raises(CostError):
        planner.solve(kappa, psi, ("epsilon_t",), Options(method="exact", damping=0.1))


def test_no_damping_is_the_undamped_collision_bit_for_bit():
    plain = solve("exact", 0.0)
    np.testing.assert_array_equal(plain.epsilon_t, collide(KAPPA, PSI).epsilon_t)
    assert contact_duration(0.0) == 3.2180654597190430846
    assert normal_restitution(0.0) == 1.0


def test_share_of_the_budget_is_kept():
    # 100 collisions of some 8,000 switches, with five million allowed and with five thousand
    kappa, psi = np.full(100, 1e8), np.full(100, 0.5)
    allowed = exact.follow_affordable(kappa, psi, 0.1)
    assert np.all(allowed.switches > 0)
    held = exact.follow_affordable(kappa, psi, 0.1, share=1e-3)
    assert np.all(held.switches == -1)
