"""Choice of the method: what is asked for is delivered, at the tolerance, within the budget."""

import numpy as np
import pytest

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import MOST_SWITCHES, collide, expected_switch_counts
from restitution.methods import exact, planner, table
from restitution.methods.options import Options
from work import counted


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


def test_auto_does_without_the_exact_method_where_energy_bounds_a_damped_collision():
    kappa, psi = np.geomspace(1e3, 1e7, 60), np.geomspace(0.05, 3, 60)
    rough = solve(kappa, psi, ("epsilon_t",), tolerance=4e-3, damping=0.05)
    fine = solve(kappa, psi, ("epsilon_t", "switches"), damping=0.05)
    assert {"coulomb", "exact"} == set(rough.method)
    followed = fine.method == "exact"
    assert np.all(rough.error_bound[followed] <= 4e-3)
    off = np.abs(rough.epsilon_t - fine.epsilon_t)
    assert np.all(off <= rough.error_bound + fine.error_bound)


def screen_map(kappas):
    """κ and ψ of a map of 200 × 150 with the page's g_t/g_n at μ/α = 1.4."""
    grid = np.meshgrid(kappas, np.linspace(0.01, 4, 150) / 1.4)
    return tuple(np.ravel(axis) for axis in grid)


@pytest.mark.parametrize(
    "kappas",
    [
        np.geomspace(0.1, 1e6, 200),
        pytest.param(np.linspace(0.1, 1e6, 200), marks=pytest.mark.verify),
    ],
    ids=["log", "linear"],
)
def test_map_to_a_million_costs_a_twentieth_at_the_tolerance_of_a_screen(kappas):
    kappa, psi = screen_map(kappas)
    table.table()
    with counted() as cheap:
        answer = solve(kappa, psi, ("epsilon_t",), tolerance=4e-3)
    with counted() as dear:
        truth = collide(kappa, psi)
    # a read of the table costs less than a switch
    assert dear["switches"] > 20 * (cheap["switches"] + cheap["reads"])
    assert np.all(np.abs(answer.epsilon_t - truth.epsilon_t) <= answer.error_bound)
    assert np.all(answer.error_bound <= 4e-3)


def test_auto_reads_the_table_for_many_and_follows_a_few():
    kappa, psi = screen_map(np.linspace(0.1, 70, 200))
    many = solve(kappa, psi, ("epsilon_t",), tolerance=4e-3)
    assert set(many.method) == {"stiff", "table"}
    few = solve(kappa[:3000], psi[:3000], ("epsilon_t",), tolerance=4e-3)
    assert set(few.method) == {"exact"}
    counted = solve(kappa, psi, tolerance=4e-3)
    assert set(counted.method) == {"exact"}


@pytest.mark.parametrize("tolerance", [10.0**-n for n in range(1, 13)])
def test_auto_keeps_every_tolerance_where_the_table_takes_part(tolerance):
    rng = np.random.default_rng(4)
    kappa, psi = 10 ** rng.uniform(-3, 4, 100_000), 10 ** rng.uniform(-4, 3, 100_000)
    answer = solve(kappa, psi, ("epsilon_t",), tolerance=tolerance)
    truth = collide(kappa, psi)
    distance = np.abs(answer.epsilon_t - truth.epsilon_t)
    assert np.all(distance <= answer.error_bound + truth.error_bound)
    assert np.all(answer.error_bound <= np.maximum(tolerance, truth.error_bound))
    assert ("table" in answer.method) is (tolerance >= table.FINEST)


def test_bound_of_what_cannot_be_followed_is_the_sharp_one():
    answer = solve([1e28, 1e28], [1e-13, 1.0], ("epsilon_t", "switches"))
    np.testing.assert_allclose(answer.error_bound, [4.484842e-22, 4.484842e-35], rtol=1e-6)
    named = solve(1e28, 1e-13, method="stiff")
    assert named.error_bound[0] == pytest.approx(1.25**0.6 * 1e-1)


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


def test_exact_by_name_follows_no_more_switches_than_a_request_may():
    expected = expected_switch_counts(np.array([2e9]), np.array([1.0]))[0]
    too_many = int(exact.MOST_SWITCHES_PER_REQUEST / expected) + 1
    with counted() as work, pytest.raises(CostError, match="20,000,000"):
        solve(np.full(too_many, 2e9), 1.0, method="exact")
    assert work.of_numbers == 0


def test_collisions_alike_are_not_followed_where_they_are_too_many_together(monkeypatch):
    monkeypatch.setattr(exact, "MOST_SWITCHES_PER_REQUEST", 1000)
    with counted() as work:
        answer = solve([1.0] + [1e4] * 50, 1.0)
    assert list(answer.method) == ["exact"] + ["stiff"] * 50
    assert work["switches"] < 1000


def test_budget_is_spent_on_the_softest_collisions(monkeypatch):
    monkeypatch.setattr(exact, "MOST_SWITCHES_PER_REQUEST", 1000)
    kappa = np.array([1.0, 100.0, 1e4, 1e6])
    answer = solve(kappa, 1.0)
    assert list(answer.method) == ["exact", "exact", "exact", "stiff"]
    assert exact.switch_limit(np.full(3, 1.0)) == MOST_SWITCHES


def test_unknown_methods_are_refused_with_the_known_ones():
    with pytest.raises(ParameterError, match="one of auto, exact, coulomb, pragmatic, stiff"):
        solve(1.0, 1.0, method="guess")
