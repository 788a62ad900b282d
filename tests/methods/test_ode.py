"""The general solver: as good as its tolerance with events, and what becomes of it without."""

import numpy as np
import pytest

from restitution.errors import CostError
from restitution.mechanics.collision import collide
from restitution.mechanics.limits import weak_limit
from restitution.methods import ode
from restitution.methods.options import Options


def solve(kappa, psi, **options):
    kappas, psis = np.broadcast_arrays(np.atleast_1d(kappa), np.atleast_1d(psi))
    return ode.solve(kappas.astype(float), psis.astype(float), Options(method="ode", **options))


def sample(count=30):
    rng = np.random.default_rng(2008)
    return rng.uniform(0.1, 70, count), rng.uniform(0.01, 2.8, count)


# an error of a step is passed on but never grows; some hundred steps
@pytest.mark.parametrize(("rtol", "error"), [(1e-6, 1e-4), (1e-9, 1e-7), (1e-12, 1e-10)])
def test_error_follows_the_tolerance_and_switches_are_exact(rtol, error):
    kappa, psi = sample()
    answer = solve(kappa, psi, rtol=rtol)
    truth = collide(kappa, psi)
    assert np.abs(answer.epsilon_t - truth.epsilon_t).max() < error
    assert np.all(answer.error_bound < error)
    if rtol < 1e-6:
        np.testing.assert_array_equal(answer.switches, truth.switches)
        assert np.all(answer.switches_certain)


def test_error_bound_holds_on_the_reference_collisions(reference):
    soft = np.flatnonzero(reference.kappa < 1e3)[::8]
    answer = solve(reference.kappa[soft], reference.psi[soft])
    assert soft.size > 20
    assert np.all(np.abs(answer.epsilon_t - reference.epsilon_t[soft]) <= answer.error_bound)


def test_limits_are_met():
    assert solve(18.0, 0.0).epsilon_t[0] == pytest.approx(weak_limit(18.0), abs=1e-8)
    assert solve(18.0, 0.0).switches[0] == 0
    assert solve(18.0, np.inf).epsilon_t[0] == 1.0
    assert solve(18.0, 4.0).epsilon_t[0] == pytest.approx(0.5, abs=1e-8)
    assert solve(5e-324, 1.0).epsilon_t[0] == 1.0


@pytest.mark.parametrize("rtol", [0.1, 1e-13])
def test_extremes_are_answered_within_the_bound_or_refused(rtol):
    rng = np.random.default_rng(11)
    bits = rng.integers(1, 0x7FEFFFFFFFFFFFFF, (2, 40), dtype=np.uint64)
    kappa, psi = bits.view(np.float64).copy()
    psi[:4] = 0.0, np.inf, 5e-324, 1.7976931348623157e308
    refused = []
    for k, p in zip(kappa, psi, strict=True):
        try:
            answer = solve(k, p, rtol=rtol)
        except CostError:
            refused.append(k)
            continue
        truth = collide([k], [p])
        distance = abs(answer.epsilon_t[0] - truth.epsilon_t[0])
        assert distance <= answer.error_bound[0] < 1e-2
    assert 0 < len(refused) < 40
    assert min(refused) > 1e4


# sticking that begins where the time to its end, or to that of the contact, is lost in rounding
@pytest.mark.parametrize(
    ("kappa", "psi", "rtol"),
    [(4e5, 1e-8, 1e-9), (15018.804310118541, 2.2487220480325925e-11, 4.437670133506e-06)],
)
def test_solver_does_not_chatter_where_times_are_lost_in_rounding(kappa, psi, rtol):
    result = ode.integrate(kappa, psi, rtol, most_evaluations=60_000)
    # some thousand steps; the last switches are beyond the resolution of time
    assert result.epsilon_t == pytest.approx(collide(kappa, psi).epsilon_t, abs=1e3 * rtol)


def test_cost_is_refused_before_any_work_with_cost_and_limit():
    with pytest.raises(CostError, match=r"about .* steps here.*limits are 60,000 and 10,000"):
        solve(1e9, 1.0)
    with pytest.raises(CostError, match="the limits are"):
        solve(np.full(10_000, 1.0), 1.0)


def test_solver_is_stopped_when_it_does_not_get_on():
    with pytest.raises(CostError, match="stopped after 100 evaluations"):
        ode.integrate(63.0, 0.97, 1e-9, most_evaluations=100)


def test_without_events_the_solver_pays_at_each_kink():
    kappa, psi = 63.0, 0.97
    located = ode.integrate(kappa, psi, 1e-9)
    held = ode.integrate(kappa, psi, 1e-9, "held")
    assert held.epsilon_t == pytest.approx(collide(kappa, psi).epsilon_t, abs=1e-6)
    assert held.evaluations > 5 * located.evaluations
    assert held.switches == ode.UNCOUNTED


def test_a_spring_that_is_never_reset_converges_to_another_answer():
    kappa, psi = 63.0, 0.97
    coarse, fine = (ode.integrate(kappa, psi, rtol, "free").epsilon_t for rtol in (1e-8, 1e-11))
    assert coarse == pytest.approx(fine, abs=1e-6)
    assert abs(fine - collide(kappa, psi).epsilon_t) > 0.02
