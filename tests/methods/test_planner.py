"""Choice of the method: what is asked for is delivered, at the tolerance, within the budget."""

import numpy as np
import pytest

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import MOST_SWITCHES, collide
from restitution.methods import exact, planner
from restitution.methods.answer import Options


def solve(kappa, psi, quantities=("epsilon_t", "switches"), **options):
    kappas, psis = np.broadcast_arrays(np.atleast_1d(kappa), np.atleast_1d(psi))
    return planner.solve(kappas.astype(float), psis.astype(float), quantities, Options(**options))


@pytest.mark.parametrize("tolerance", [1e-1, 1e-3, 1e-6, 1e-10])
@pytest.mark.parametrize("quantities", [("epsilon_t",), ("epsilon_t", "switches")])
def test_auto_stays_within_its_bound_and_its_tolerance(reference, tolerance, quantities):
    answer = solve(reference.kappa, reference.psi, quantities, tolerance=tolerance)
    assert np.all(np.abs(answer.epsilon_t - reference.epsilon_t) <= answer.error_bound)
    assert np.all(answer.error_bound <= tolerance)


def test_auto_does_without_the_exact_method_where_the_stiff_limit_will_do():
    answer = solve([1e5, 1e5, 10.0], [1.0, 3.0, 1.0], ("epsilon_t",), tolerance=4e-3)
    assert list(answer.method) == ["stiff", "stiff", "exact"]


def test_auto_counts_switches_where_they_are_asked_for():
    answer = solve(1e5, 1.0, tolerance=1.0)
    assert answer.method[0] == "exact"
    assert answer.switches[0] == collide(1e5, 1.0).switches


def test_auto_gives_the_stiff_limit_where_the_exact_one_is_out_of_reach():
    answer = solve(1e300, 1.0)
    assert answer.method[0] == "stiff"
    assert answer.epsilon_t[0] == 0.0
    assert 0.0 < answer.error_bound[0] < 1e-149


@pytest.mark.parametrize("method", ["exact", "coulomb", "pragmatic", "stiff"])
def test_no_method_leaves_its_own_bound(reference, method):
    answer = solve(reference.kappa, reference.psi, method=method)
    assert np.all(np.abs(answer.epsilon_t - reference.epsilon_t) <= answer.error_bound)


def test_pragmatic_model_uses_its_floor_and_coulomb_does_not():
    assert solve(18.0, 1.0, method="pragmatic", floor=-0.5).epsilon_t[0] == -0.5
    assert solve(18.0, 1.0, method="coulomb", floor=-0.5).epsilon_t[0] == 0.0


def test_exact_by_name_is_refused_beyond_its_budget():
    with pytest.raises(CostError, match="method=auto"):
        solve(1e15, 1.0, method="exact")
    with pytest.raises(CostError, match="does not hold the phase"):
        solve(1e32, 1e-60, method="exact")


def test_budget_is_spent_on_the_softest_collisions(monkeypatch):
    monkeypatch.setattr(exact, "MOST_SWITCHES_PER_REQUEST", 1000)
    kappa = np.array([1.0, 100.0, 1e4, 1e6])
    answer = solve(kappa, 1.0)
    assert list(answer.method) == ["exact", "exact", "exact", "stiff"]
    assert exact.switch_limit(np.full(3, 1.0)) == MOST_SWITCHES


def test_unknown_methods_are_refused_with_the_known_ones():
    with pytest.raises(ParameterError, match="one of auto, exact, coulomb, pragmatic, stiff"):
        solve(1.0, 1.0, method="guess")
