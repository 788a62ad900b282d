"""Damping through the service: known values, every form of it, refusals."""

import numpy as np
import pytest

from restitution.mechanics.contact import contact_duration, normal_restitution

KNOWN = [
    (18.0, 0.2142857143, 0.05, -0.319335367, 3),
    (63.0, 1.0, 0.05, 0.006389827, 9),
    (5.0, 0.5, 0.3, 0.028888511, 3),
    (200.0, 0.3, 0.3, 0.014686035, 11),
]


def ask(service, path="/collision", kappa=63, psi=1.0, damping=0.05, **more):
    return service.answer(
        path, kappa=kappa, mu_over_alpha=1.4, gt_over_gn=1.4 * psi, damping=damping, **more
    )


@pytest.mark.parametrize(("kappa", "psi", "damping", "epsilon_t", "switches"), KNOWN)
def test_collision_has_the_known_values(service, kappa, psi, damping, epsilon_t, switches):
    answer = ask(service, kappa=kappa, psi=psi, damping=damping)
    assert answer["epsilon_t"] == pytest.approx(epsilon_t, abs=1e-8)
    assert answer["switches"] == switches
    assert answer["method"] == "exact"
    assert answer["parameters"]["damping"] == damping


def test_normal_motion_is_that_of_the_damping(service):
    answer = ask(service, damping=0.1)
    assert answer["epsilon_n"] == pytest.approx(0.89285888, abs=1e-8)
    assert answer["contact_duration"] == pytest.approx(3.15725565580257, abs=1e-13)


def test_episodes_begin_sticking_and_end_sliding(service):
    answer = ask(service)
    regimes = [episode["regime"] for episode in answer["episodes"]]
    assert regimes == ["sticking", "sliding"] * 5
    assert answer["episodes"][-1]["end"] == answer["contact_duration"]
    assert answer["summary"].startswith("Sticks less than 1 % of the contact, slips and sticks 4")


def test_stiff_estimates_do_not_exist_and_coulomb_has_the_normal_restitution(service):
    estimates = ask(service, psi=3.0)["estimates"]
    assert estimates["stiff_bound"] is estimates["stiff_asymptote"] is None
    assert estimates["coulomb"] == pytest.approx(1 - (1 + normal_restitution(0.05)) / 3)


def test_trace_is_the_motion_of_the_damped_contact(service):
    trace = ask(service, "/trace", samples=4001)
    columns = {name: np.array(trace[name]) for name in ("time", "compression", "normal_force")}
    rate = np.array(trace["compression_rate"])
    x, force = columns["compression"], columns["normal_force"]
    np.testing.assert_allclose(force, x**1.5 + 0.05 * np.sqrt(x) * rate, rtol=0, atol=4e-15)
    # the spheres are still compressed when the force ends
    assert x[-1] == pytest.approx(-0.05 * rate[-1], rel=1e-13)
    assert rate[-1] == pytest.approx(-trace["epsilon_n"], rel=1e-15)
    assert columns["time"][-1] == pytest.approx(contact_duration(0.05), rel=1e-15)
    assert columns["time"].size == 4001 + trace["switches"]
    tangential = np.array(trace["tangential_force_over_mu"])
    assert np.all(np.abs(tangential) <= force + 1e-15)
    # Newton's law, by the trapezoidal rule
    push = 1.4 * 0.5 * (tangential[1:] + tangential[:-1]) * np.diff(columns["time"])
    velocity = np.array(trace["tangential_velocity"])
    np.testing.assert_allclose(velocity[1:], velocity[0] + np.cumsum(push), rtol=0, atol=2e-6)
    assert velocity[-1] / velocity[0] == pytest.approx(trace["epsilon_t"], rel=1e-12)
    assert np.all(np.diff(trace["tangential_energy"]) <= 1e-15)
    assert trace["regime"][0] == 0


def test_sensitivity_is_the_slope(service):
    answer = ask(service, kappa=18, psi=0.3)["sensitivity"]
    h = 1e-5
    by = {
        "kappa": [ask(service, kappa=18 * np.exp(s * h), psi=0.3) for s in (-1, 1)],
        "psi": [ask(service, kappa=18, psi=0.3 * np.exp(s * h)) for s in (-1, 1)],
    }
    for name, (low, high) in by.items():
        slope = (high["epsilon_t"] - low["epsilon_t"]) / (2 * h)
        assert answer[name] == pytest.approx(slope, abs=1e-8), name


@pytest.mark.parametrize("gt_over_gn", [0, 1.0])
def test_limits_without_a_spring_have_the_duration_of_the_damped_contact(service, gt_over_gn):
    friction = 1 - gt_over_gn
    trace = service.answer(
        "/trace", kappa=3, mu_over_alpha=friction, gt_over_gn=gt_over_gn, damping=0.3
    )
    phase = np.sqrt(3) * contact_duration(0.3)
    assert trace["epsilon_t"] == pytest.approx(1.0 if gt_over_gn else np.cos(phase), abs=1e-12)
    assert trace["switches"] == 0
    assert trace["episodes"][0]["end"] == contact_duration(0.3)


def test_cut_and_map_are_made_of_collisions(service):
    cut = service.answer(
        "/cut", along="kappa", mu_over_alpha=1, gt_over_gn=0.5, damping=0.2, count=5,
        quantities="epsilon_t,switches,coulomb,stiff_bound",
    )  # fmt: skip
    for i, kappa in enumerate(cut["values"]):
        one = service.answer(
            "/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=0.5, damping=0.2
        )
        assert cut["epsilon_t"][i] == one["epsilon_t"]
        assert cut["switches"][i] == one["switches"]
    assert cut["stiff_bound"] == [None] * 5
    grid = service.answer(
        "/map", mu_over_alpha=1, kappa_count=3, gt_over_gn_count=2, damping=0.2, tolerance=0.01
    )
    assert grid["method"] == "exact"
    assert np.all(np.array(grid["switches"]) % 2 == 1)


def test_lists_may_have_a_damping_for_each_collision(service):
    dampings = [0.3, 0.0, 0.05, 0.3, 0.0]
    kappas = [5.0, 18.0, 63.0, 200.0, 63.0]
    many = service.collisions(
        {"kappa": kappas, "mu_over_alpha": 1, "gt_over_gn": 0.5, "damping": dampings}
    )
    for i, (kappa, damping) in enumerate(zip(kappas, dampings, strict=True)):
        one = service.collisions(
            {"kappa": kappa, "mu_over_alpha": 1, "gt_over_gn": 0.5, "damping": damping}
        )
        for name in ("epsilon_t", "epsilon_n", "switches", "method", "error_bound"):
            assert many[name][i] == one[name][0], name
    assert many["epsilon_n"][1] == 1.0


def test_too_many_different_dampings_are_refused_with_the_limit(service):
    body = {
        "kappa": 5,
        "mu_over_alpha": 1,
        "gt_over_gn": 1,
        "damping": [1e-4 * n for n in range(2001)],
    }
    detail = service.problem(service.post(body), 413)["detail"]
    assert "2,001" in detail
    assert "2,000" in detail


@pytest.mark.parametrize("method", ["stiff", "table"])
def test_methods_without_damping_refuse_it_by_name_before_any_work(service, method):
    # one that no other test has, whose contact is not kept
    asked = {"kappa": 5, "mu_over_alpha": 1, "gt_over_gn": 1, "damping": 0.10123, "method": method}
    for send in (
        lambda: service.get("/collision", **asked),
        lambda: service.get("/trace", **asked),
        lambda: service.post(asked | {"damping": [0, asked["damping"]]}),
    ):
        [entry] = service.problem(service.affordable(send), 422)["errors"]
        assert entry["parameter"] == "method"
        assert "another one for damping = 0.10123" in entry["requirement"]


@pytest.mark.parametrize("damping", ["-0.1", "NaN", "Infinity", "2e30", "1e300"])
def test_damping_out_of_range_is_refused_in_words(service, damping):
    entry = service.wrong("/trace", kappa=5, mu_over_alpha=1, gt_over_gn=1, damping=damping)
    assert entry["damping"]["requirement"] == "from 0 to 1e+30"


@pytest.mark.parametrize("damping", [5e-324, 1e-300, 1e-12, 1.0, 1e12, 1e30])
@pytest.mark.parametrize(
    ("kappa", "psi"), [(5e-324, 1.0), (1.0, 1e300), (1e300, 1.0), (18.0, 1e-300)]
)
def test_extremes_have_an_answer(service, damping, kappa, psi):
    response = service.affordable(
        lambda: service.get(
            "/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=psi, damping=damping
        )
    )
    answer = service.read(response)
    assert -1 <= answer["epsilon_t"] <= 1
    assert 0 <= answer["error_bound"] <= 1
    assert 0 <= answer["epsilon_n"] <= 1


def test_no_damping_is_the_answer_without_the_parameter(service):
    plain = service.get("/collision", kappa=18, mu_over_alpha=1.4, gt_over_gn=0.4)
    assert (
        plain.content
        == service.get("/collision", kappa=18, mu_over_alpha=1.4, gt_over_gn=0.4, damping=0).content
    )
