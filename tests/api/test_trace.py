"""GET /trace: instants, signs of force and velocity, regimes, energy, all against each other."""

import numpy as np
import pytest

COLUMNS = (
    "time",
    "compression",
    "compression_rate",
    "normal_force",
    "tangential_force_over_mu",
    "tangential_velocity",
    "spring_elongation",
    "regime",
    "tangential_energy",
)
# κ, μ/α, g_t/g_n: 0, 6, 8 and 2 switches at the κ of Fig. 5, soft, stiff, beside ψ*(κ), ψ → 2
TRACES = [
    (63.0, 1.4, 3.08),
    (63.0, 1.4, 1.75),
    (63.0, 1.4, 1.358),
    (63.0, 1.4, 0.007),
    (0.3, 0.5, 0.1),
    (2000.0, 1.4, 1.0),
    (0.2, 1.0, 5.3),
    (18.0, 3.0, 5.999),
]


@pytest.fixture(scope="module", params=TRACES, ids=str)
def trace(request, service):
    kappa, friction, tangential = request.param
    answer = service.answer(
        "/trace", kappa=kappa, mu_over_alpha=friction, gt_over_gn=tangential, samples=5000
    )
    columns = {name: np.array(answer[name]) for name in (*COLUMNS, "switch_times")}
    return answer | columns | {"kappa": kappa, "m": friction}


def test_length_is_samples_plus_switches(trace):
    assert {trace[name].size for name in COLUMNS} == {5000 + trace["switches"]}
    assert trace["switch_times"].size == trace["switches"]


def test_time_is_uniform_from_begin_to_end_merged_with_the_switches(trace):
    uniform = np.linspace(0.0, trace["contact_duration"], 5000)
    assert trace["time"][0] == 0.0
    assert trace["time"][-1] == trace["contact_duration"]
    assert np.all(np.diff(trace["time"]) >= 0)
    assert np.array_equal(trace["time"], np.sort(np.append(uniform, trace["switch_times"])))


def test_switch_times_are_where_episodes_begin(trace):
    assert trace["switch_times"].tolist() == [e["start"] for e in trace["episodes"][1:]]


def test_regime_of_a_switch_is_the_one_that_begins_there(trace):
    at_switches = np.isin(trace["time"], trace["switch_times"])
    directions = [e["direction"] for e in trace["episodes"][1:]]
    assert trace["regime"][at_switches].tolist() == directions


def test_regime_is_that_of_the_episode(trace):
    starts = [e["start"] for e in trace["episodes"]]
    which = np.searchsorted(starts, trace["time"], side="right") - 1
    directions = np.array([e["direction"] for e in trace["episodes"]])
    assert np.array_equal(trace["regime"], directions[which])


def test_normal_motion_keeps_its_energy(trace):
    # Eq. 20 integrated once; x and ẋ are right to rounding
    energy = trace["compression_rate"] ** 2 + 0.8 * trace["compression"] ** 2.5
    assert np.abs(energy - 1).max() < 1e-14
    assert trace["normal_force"] == pytest.approx(
        trace["compression"] ** 1.5, rel=1e-14, abs=1e-300
    )
    assert trace["compression"][0] == 0.0
    assert trace["compression_rate"][[0, -1]].tolist() == [1.0, -1.0]


def test_tangential_force_has_the_papers_sign_and_cap(trace):
    pull = trace["kappa"] * np.abs(trace["spring_elongation"]) / trace["m"]
    force = -np.sign(trace["spring_elongation"]) * np.minimum(trace["normal_force"], pull)
    assert trace["tangential_force_over_mu"] == pytest.approx(force, abs=1e-13)


def test_tangential_force_brakes_at_first(trace):
    assert trace["tangential_velocity"][1] > 0
    assert trace["tangential_force_over_mu"][1] < 0


def test_tangential_velocity_changes_by_the_force(trace):
    step = np.diff(trace["time"])
    force = trace["tangential_force_over_mu"]
    gained = np.append(0.0, np.cumsum(step * (force[1:] + force[:-1]) / 2)) * trace["m"]
    change = trace["tangential_velocity"] - trace["tangential_velocity"][0]
    # trapezium: t_c h²/12 times F'' ~ κ, but for the kinks
    assert change == pytest.approx(gained, abs=trace["m"] * max(1, trace["kappa"]) * 2e-7)


def test_tangential_velocity_ends_at_epsilon_t_times_its_beginning(trace):
    velocity = trace["tangential_velocity"]
    assert velocity[0] == trace["parameters"]["gt_over_gn"]
    assert velocity[-1] == pytest.approx(trace["epsilon_t"] * velocity[0], rel=1e-11, abs=1e-13)


def test_spring_follows_the_surfaces_while_sticking(trace):
    step = np.diff(trace["time"])
    both = (trace["regime"][1:] == 0) & (trace["regime"][:-1] == 0)
    velocity = trace["tangential_velocity"]
    stretched = step * (velocity[1:] + velocity[:-1]) / 2
    error = np.abs(np.diff(trace["spring_elongation"]) - stretched)[both]
    # trapezium on one step: h³/12 times ü ~ κ^{1/2}…κ
    assert error.max(initial=0.0) <= 3e-11 * max(1, trace["kappa"]) * trace["m"]


def test_spring_is_held_at_the_cap_while_sliding(trace):
    sliding = trace["regime"] != 0
    held = trace["regime"] * trace["m"] * trace["normal_force"] / trace["kappa"]
    assert trace["spring_elongation"][sliding] == pytest.approx(held[sliding], rel=1e-14, abs=0)


def test_spring_stays_under_the_cap_while_sticking(trace):
    sticking = trace["regime"] == 0
    pull = trace["kappa"] * np.abs(trace["spring_elongation"][sticking]) / trace["m"]
    assert np.all(pull <= trace["normal_force"][sticking] + 1e-13)


def test_spring_has_the_sign_of_its_regime(trace):
    sliding = (trace["regime"] != 0) & (trace["normal_force"] > 0)
    signs = np.sign(trace["spring_elongation"][sliding])
    assert np.array_equal(signs, trace["regime"][sliding])


def test_tangential_energy_is_that_of_velocity_and_spring(trace):
    energy = (
        trace["tangential_velocity"] ** 2 + trace["kappa"] * trace["spring_elongation"] ** 2
    ) / 2
    assert trace["tangential_energy"] == pytest.approx(energy, rel=1e-13, abs=0)
    assert trace["tangential_energy"][0] == pytest.approx(
        trace["energy"]["initial"], rel=1e-14, abs=0
    )
    assert trace["tangential_energy"][-1] == pytest.approx(
        trace["energy"]["final"], rel=1e-11, abs=1e-26
    )


def test_tangential_energy_falls_only_while_sliding_and_never_rises(trace):
    change = np.diff(trace["tangential_energy"])
    rounding = 1e-13 * trace["tangential_energy"][0]
    assert change.max() <= rounding
    both = (trace["regime"][1:] == 0) & (trace["regime"][:-1] == 0)
    assert np.abs(change[both]).max(initial=0.0) <= rounding


def test_trace_has_every_key_of_collision(service):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4, "episode_limit": 3}
    single = service.answer("/collision", **collision)
    traced = service.answer("/trace", **collision)
    assert traced["parameters"].items() >= single.pop("parameters").items()
    assert {name: traced[name] for name in single} == single


@pytest.mark.parametrize("samples", [2, 3, 400, 20_000])
def test_length_follows_samples(service, samples):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
    answer = service.answer("/trace", **collision, samples=samples)
    assert len(answer["time"]) == samples + answer["switches"]


def test_samples_are_400_unless_asked_otherwise(service):
    answer = service.answer("/trace", kappa=18, mu_over_alpha=1.4, gt_over_gn=4)
    assert len(answer["time"]) == 400
    assert answer["switch_times"] == []


@pytest.mark.parametrize("column", COLUMNS)
def test_columns_asked_for_are_the_same_as_without_asking(service, column):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4, "samples": 20}
    everything = service.answer("/trace", **collision)
    alone = service.answer("/trace", **collision, quantities=column)
    assert alone[column] == everything[column]
    assert not (set(COLUMNS) - {column}) & alone.keys()


def test_episodes_are_cut_off_but_switch_times_are_not(service):
    answer = service.answer(
        "/trace", kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358, episode_limit=2
    )
    assert len(answer["episodes"]) == 2
    assert len(answer["switch_times"]) == 8


def test_more_than_20000_switches_are_refused_with_both_numbers(service):
    collision = {"mu_over_alpha": 1, "gt_over_gn": 0.5}
    allowed = service.get("/trace", kappa=1e8, **collision, samples=2, quantities="time")
    assert allowed.status_code == 200
    beyond = 2e9
    counted = service.answer("/collision", kappa=beyond, **collision, quantities="switches")
    assert counted["switches"] > 20_000
    problem = service.refused("/trace", 413, kappa=beyond, **collision)
    assert "20,000" in problem["detail"]
    assert f"{counted['switches']:,}" in problem["detail"]


def test_far_more_than_20000_switches_are_refused_with_the_limit_of_a_trace(service):
    problem = service.refused("/trace", 413, kappa=1e20, mu_over_alpha=1, gt_over_gn=0.5)
    assert "20,000" in problem["detail"]


@pytest.mark.parametrize("method", ["coulomb", "pragmatic", "stiff", "exact"])
def test_trace_is_the_exact_motion_by_every_method(service, method):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4, "samples": 20}
    exact = service.answer("/trace", **collision)
    other = service.answer("/trace", **collision, method=method)
    assert other["method"] == method
    assert [other[name] for name in COLUMNS] == [exact[name] for name in COLUMNS]


def test_velocity_at_an_instant_is_the_same_whatever_the_samples(service):
    collision = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
    coarse, fine = (service.answer("/trace", **collision, samples=n) for n in (11, 21))
    velocities = dict(zip(fine["time"], fine["tangential_velocity"], strict=True))
    shared = [i for i, t in enumerate(coarse["time"]) if t in velocities]
    assert len(shared) >= 8
    assert [velocities[coarse["time"][i]] for i in shared] == [
        coarse["tangential_velocity"][i] for i in shared
    ]
