"""`timestep` and `ode` in the calls: signed errors in a map, the trace of the steps, extremes."""

import base64
import itertools

import numpy as np
import pytest

INTEGRATORS = ("velocity_verlet", "symplectic_euler", "forward_euler")
COLLISION = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.5}
EXTREMES = (5e-324, 1e-100, 1e-6, 1.0, 1e6, 1e100, 1.7976931348623157e308)
# a second each at κ = 10⁶, where weak ones are alike and so are those that slide
BY_THE_GENERAL_SOLVER = [
    pytest.param(
        kappa,
        psi,
        marks=[pytest.mark.verify] if kappa == 1e6 and psi not in {0.0, 1e-6, 1.0} else [],
    )
    for kappa in EXTREMES
    for psi in (0.0, *EXTREMES)
]


def test_map_carries_the_signed_error(service):
    grid = {"mu_over_alpha": 1.4, "kappa_count": 30, "gt_over_gn_count": 20}
    exact = service.answer("/map", **grid, method="exact")
    steps = service.answer(
        "/map", **grid, method="timestep", steps=50, quantities="epsilon_t,switches,error"
    )
    error = np.array(steps["epsilon_t"]) - np.array(exact["epsilon_t"])
    np.testing.assert_allclose(steps["error"], error, rtol=0, atol=1e-15)
    assert steps["method"] == "timestep"
    assert steps["error_bound"] == pytest.approx(np.abs(error).max(), abs=1e-12)
    assert steps["tolerance_met"] is False
    assert min(np.ravel(steps["error"])) < -1e-3
    assert max(np.ravel(steps["error"])) > 1e-3


def test_cut_by_the_general_solver_carries_its_error(service):
    cut = {"along": "gt_over_gn", "kappa": 18, "mu_over_alpha": 1.4, "count": 5}
    answer = service.answer("/cut", **cut, method="ode", rtol=1e-9, quantities="epsilon_t,error")
    assert max(map(abs, answer["error"])) < 1e-7
    assert answer["error_bound"] == pytest.approx(max(map(abs, answer["error"])), abs=1e-13)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_options_have_their_effect(service, integrator):
    answers = {
        (steps, phase): service.answer(
            "/collision",
            **COLLISION,
            method="timestep",
            integrator=integrator,
            steps=steps,
            phase=phase,
        )["epsilon_t"]
        for steps, phase in itertools.product((20, 50), (0, 0.5))
    }
    assert len(set(answers.values())) == 4


@pytest.mark.parametrize("phase", [0, 0.3])
def test_trace_shows_the_steps_beside_the_exact_columns(service, phase):
    answer = service.answer(
        "/trace", **COLLISION, method="timestep", steps=50, phase=phase, samples=30
    )
    exact = service.answer("/trace", **COLLISION, samples=30)
    for name in ("time", "tangential_velocity", "tangential_force_over_mu", "regime"):
        assert answer[name] == exact[name]
    time = answer["method_time"]
    force = np.array(answer["method_tangential_force_over_mu"])
    velocity = np.array(answer["method_tangential_velocity"])
    assert 50 <= len(time) <= 53
    assert time[0] == 0.0
    assert velocity[0] == 0.5
    assert velocity[-1] / velocity[0] == pytest.approx(answer["epsilon_t"], abs=1e-12)
    # the paper's sign: a positive velocity is braked at first
    assert force[1] < 0
    # d(tangential_velocity)/dt = m · tangential_force_over_mu, by the trapezoidal rule of Verlet
    impulse = 1.4 * 0.5 * np.diff(time[1:]) * (force[2:] + force[1:-1])
    np.testing.assert_allclose(np.diff(velocity[1:]), impulse, atol=1e-12)


def test_trace_of_other_methods_has_no_steps(service):
    answer = service.answer("/trace", **COLLISION, method="ode", samples=5)
    assert not [name for name in answer if name.startswith("method_")]


def test_trace_of_many_steps_is_thinned_out(service):
    answer = service.answer("/trace", **COLLISION, method="timestep", steps=1_000_000, samples=2)
    assert 10_000 < len(answer["method_time"]) <= 20_000
    assert answer["method_time"][-1] == pytest.approx(answer["contact_duration"], abs=4e-6)
    final = answer["method_tangential_velocity"][-1] / 0.5
    assert final == pytest.approx(answer["epsilon_t"], abs=1e-9)


@pytest.mark.parametrize("form", ["csv", "npz"])
def test_trace_of_steps_has_every_form(service, form):
    response = service.get("/trace", **COLLISION, method="timestep", samples=5, format=form)
    assert response.status_code == 200
    assert (b"method_time" in response.content) is (form == "npz")


@pytest.mark.parametrize("path", ["/collision", "/trace"])
@pytest.mark.parametrize("kappa", EXTREMES)
@pytest.mark.parametrize("psi", [0.0, *EXTREMES])
def test_extremes_are_answered_within_the_bound_or_refused(service, path, kappa, psi):
    collision = {"kappa": kappa, "mu_over_alpha": 1, "gt_over_gn": psi}
    exact = service.answer("/collision", **collision)
    for method in ({"method": "timestep", "integrator": i} for i in INTEGRATORS):
        response = service.affordable(
            lambda method=method: service.get(path, **collision, **method, steps=7, phase=0.4)
        )
        if path == "/trace" and response.status_code == 413:
            service.problem(response, 413)
            continue
        answer = service.read(response)
        distance = abs(answer["epsilon_t"] - exact["epsilon_t"])
        assert distance <= (answer["error_bound"] + exact["error_bound"]) * (1 + 1e-12)
        if path == "/trace":
            assert None not in answer["method_tangential_velocity"]


@pytest.mark.parametrize(("kappa", "psi"), BY_THE_GENERAL_SOLVER)
def test_extremes_by_the_general_solver_are_exact_or_refused(service, kappa, psi):
    collision = {"kappa": kappa, "mu_over_alpha": 1, "gt_over_gn": psi}
    response = service.affordable(lambda: service.get("/collision", **collision, method="ode"))
    if response.status_code == 413:
        assert kappa > 1e5
        service.problem(response, 413)
    else:
        assert service.read(response)["error_bound"] < 1e-3


def test_many_extremes_are_answered_at_once_or_refused(service):
    kappa, psi = zip(*itertools.product(EXTREMES, (0.0, *EXTREMES)), strict=True)
    body = {"kappa": kappa, "mu_over_alpha": 1, "gt_over_gn": psi}
    exact = service.collisions(body)
    for integrator in INTEGRATORS:
        steps = {"method": "timestep", "integrator": integrator, "steps": 33}
        answer = service.collisions(body | steps)
        assert None not in answer["switches"]
        for ours, bound, truth, own in zip(
            *(answer[key] for key in ("epsilon_t", "error_bound")),
            *(exact[key] for key in ("epsilon_t", "error_bound")),
            strict=True,
        ):
            assert abs(ours - truth) <= (bound + own) * (1 + 1e-12)
    service.problem(service.post(body | {"method": "ode"}), 413)


@pytest.mark.verify
def test_a_million_collisions_in_fifty_steps_are_within_the_budget(service):
    million = base64.b64encode(np.full(1_000_000, 18.0).tobytes()).decode()
    body = {"kappa": {"dtype": "f8", "bdata": million}, "mu_over_alpha": 1, "gt_over_gn": 2.5}
    wanted = body | {"method": "timestep", "quantities": ["epsilon_t"]}
    answer = service.collisions(wanted, encoding="base64")
    epsilon_t = np.frombuffer(base64.b64decode(answer["epsilon_t"]["bdata"]), "<f8")
    assert epsilon_t.size == 1_000_000
    assert set(epsilon_t) == {epsilon_t[0]}
    service.problem(service.post(body | {"method": "timestep", "steps": 5000}), 413)
