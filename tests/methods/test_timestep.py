"""Time steps as a method: what it answers, what it refuses, and that its error is the true one."""

import numpy as np
import pytest

from restitution.errors import CostError
from restitution.mechanics.collision import collide
from restitution.mechanics.stepping import stepped_course
from restitution.methods import timestep
from restitution.methods.options import Options


def solve(kappa, psi, **options):
    kappas, psis = np.broadcast_arrays(np.atleast_1d(kappa), np.atleast_1d(psi))
    return timestep.solve(
        kappas.astype(float), psis.astype(float), Options(method="timestep", **options)
    )


@pytest.mark.parametrize("integrator", ["velocity_verlet", "forward_euler"])
@pytest.mark.parametrize("steps", [20, 1000])
def test_error_bound_holds_on_the_reference_collisions(reference, integrator, steps):
    answer = solve(reference.kappa, reference.psi, steps=steps, integrator=integrator)
    error = np.abs(answer.epsilon_t - reference.epsilon_t)
    assert np.all(error <= answer.error_bound)
    # and is no more than the error: both know ε_t to 1e-10
    np.testing.assert_allclose(answer.error_bound, error, rtol=0, atol=1e-9)


def test_switches_are_certain_where_the_exact_ones_are_the_same():
    kappa, psi = np.linspace(1, 70, 200), np.full(200, 0.4)
    answer = solve(kappa, psi, steps=20)
    same = answer.switches == collide(kappa, psi).switches
    np.testing.assert_array_equal(answer.switches_certain, same)
    assert 0 < same.sum() < 200


def test_bound_holds_where_the_exact_value_is_out_of_reach():
    answer = solve([1e20, 1e300], 1.0)
    assert np.all(np.isnan(answer.exact))
    assert np.all(np.abs(answer.epsilon_t) <= answer.error_bound)
    assert np.all(answer.error_bound < 10.0)


def test_more_steps_than_the_budget_are_refused_with_cost_and_limit():
    refusal = r"5,000 collisions of 1,000,000 steps may take 1e\+10.*4e\+09"
    with pytest.raises(CostError, match=refusal):
        solve(np.ones(5000), 1.0, steps=1_000_000)


def test_budget_counts_the_steps_of_a_contact_that_takes_more_than_it_is_meant_to_have():
    steps, damping = 1_000_000, 1e10
    taken = stepped_course(1.0, 1.0, steps, damping=damping).shape[1] - 1
    assert taken > 1.9 * steps
    too_many = np.ones(timestep.MOST_STEPS // taken + 1)
    with pytest.raises(CostError):
        solve(too_many, 1.0, steps=steps, damping=damping)
