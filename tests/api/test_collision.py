"""GET /collision: the shape of the answer, its null rules, and its quantities' consequences."""

import itertools
import math

import pytest

KEYS = {
    "parameters",
    "epsilon_t",
    "epsilon_n",
    "switches",
    "switches_certain",
    "reversals",
    "contact_duration",
    "episodes",
    "episodes_truncated",
    "first_episode_share",
    "energy",
    "estimates",
    "sensitivity",
    "summary",
    "limit",
    "method",
    "error_bound",
    "tolerance_met",
    "convention",
}
DEFAULTS = {
    "damping": 0.0,
    "tolerance": 1e-10,
    "method": "auto",
    "steps": 50,
    "integrator": "velocity_verlet",
    "phase": 0.0,
    "rtol": 1e-9,
    "floor": 0.0,
}
CONTACT_DURATION = 3.2180654597190430845
HIGHEST_CAP = 1.25**0.6

# κ, μ/α, g_t/g_n with 0, 2, 4, 6 and 8 switches (model.md §5), soft, stiff, and beside ψ*(κ)
COLLISIONS = [
    (63.0, 1.4, 3.08),
    (63.0, 1.4, 2.66),
    (63.0, 1.4, 2.24),
    (63.0, 1.4, 1.75),
    (63.0, 1.4, 1.358),
    (0.2, 1.0, 4.0),
    (2000.0, 1.4, 1.0),
    (5.0, 0.35, 0.2),
]


def sign(value):
    return (value > 0) - (value < 0)


@pytest.mark.parametrize(("kappa", "mu_over_alpha", "gt_over_gn"), COLLISIONS)
def test_answer_has_the_contracts_keys(service, kappa, mu_over_alpha, gt_over_gn):
    answer = service.answer(
        "/collision", kappa=kappa, mu_over_alpha=mu_over_alpha, gt_over_gn=gt_over_gn
    )
    assert answer.keys() >= KEYS
    assert answer["energy"].keys() >= {"initial", "final", "dissipated"}
    assert answer["estimates"].keys() >= {"coulomb", "stiff_bound", "stiff_asymptote"}
    assert answer["sensitivity"].keys() >= {"kappa", "psi"}
    assert type(answer["switches"]) is int
    assert type(answer["reversals"]) is int
    assert answer["switches_certain"] is True
    assert answer["limit"] is False
    assert answer["episodes_truncated"] is False
    assert answer["contact_duration"] == pytest.approx(CONTACT_DURATION, rel=1e-15, abs=0)
    assert answer["epsilon_n"] == 1.0
    assert answer["summary"].endswith(".")
    assert answer["convention"]


def test_parameters_are_returned_as_understood_with_defaults_and_psi(service):
    answer = service.answer("/collision", kappa="1.8e1", mu_over_alpha="1.4", gt_over_gn=".7")
    given = {"kappa": 18.0, "mu_over_alpha": 1.4, "gt_over_gn": 0.7}
    assert answer["parameters"].items() >= (DEFAULTS | given).items()
    assert answer["parameters"]["psi"] == pytest.approx(0.5, rel=1e-15, abs=0)


@pytest.mark.parametrize(("kappa", "mu_over_alpha", "gt_over_gn"), COLLISIONS)
def test_episodes_alternate_and_fill_the_contact(service, kappa, mu_over_alpha, gt_over_gn):
    answer = service.answer(
        "/collision", kappa=kappa, mu_over_alpha=mu_over_alpha, gt_over_gn=gt_over_gn
    )
    episodes = answer["episodes"]
    assert len(episodes) == answer["switches"] + 1
    assert [e["regime"] for e in episodes] == [
        "sticking" if i % 2 else "sliding" for i in range(len(episodes))
    ]
    assert episodes[0]["start"] == 0.0
    assert episodes[-1]["end"] == answer["contact_duration"]
    assert all(a["end"] == b["start"] for a, b in itertools.pairwise(episodes))
    assert all(e["start"] < e["end"] for e in episodes)
    assert episodes[0]["direction"] == 1
    assert all(e["direction"] in {1, -1} for e in episodes[::2])
    assert all(e["direction"] == 0 for e in episodes[1::2])


@pytest.mark.parametrize(("limit", "listed"), [(0, 0), (1, 1), (8, 8), (9, 9), (10_000, 9)])
def test_episodes_are_the_first_ones_up_to_the_limit(service, limit, listed):
    collision = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
    answer = service.answer("/collision", **collision, episode_limit=limit)
    everything = service.answer("/collision", **collision)
    assert answer["episodes"] == everything["episodes"][:listed]
    assert answer["episodes_truncated"] is (listed < 9)
    assert answer["switches"] == 8


def test_episodes_are_at_most_200_unless_asked_otherwise(service):
    answer = service.answer("/collision", kappa=1e6, mu_over_alpha=1, gt_over_gn=0.5)
    assert len(answer["episodes"]) == 200
    assert answer["episodes_truncated"] is True
    assert answer["switches"] > 200


@pytest.mark.parametrize(("kappa", "mu_over_alpha", "gt_over_gn"), COLLISIONS)
def test_reversals_are_the_sign_changes_of_the_trace(service, kappa, mu_over_alpha, gt_over_gn):
    trace = service.answer(
        "/trace",
        kappa=kappa,
        mu_over_alpha=mu_over_alpha,
        gt_over_gn=gt_over_gn,
        samples=20_000,
        quantities="tangential_velocity",
    )
    signs = [sign(u) for u in trace["tangential_velocity"] if u != 0.0]
    changes = sum(a != b for a, b in itertools.pairwise(signs))
    assert trace["reversals"] == changes


@pytest.mark.parametrize(("kappa", "mu_over_alpha", "gt_over_gn"), COLLISIONS)
def test_energy_is_that_of_the_velocities_at_the_ends(service, kappa, mu_over_alpha, gt_over_gn):
    answer = service.answer(
        "/collision", kappa=kappa, mu_over_alpha=mu_over_alpha, gt_over_gn=gt_over_gn
    )
    initial = gt_over_gn**2 / 2
    energy = answer["energy"]
    assert energy["initial"] == pytest.approx(initial, rel=1e-14, abs=0)
    assert energy["final"] == pytest.approx(answer["epsilon_t"] ** 2 * initial, rel=1e-13, abs=0)
    assert energy["dissipated"] == pytest.approx(initial - energy["final"], rel=1e-13, abs=0)


@pytest.mark.parametrize(("kappa", "psi"), [(0.05, 0.3), (1.5, 1.0), (63.0, 1.999), (2000.0, 0.7)])
def test_estimates_are_the_closed_forms(service, kappa, psi):
    estimates = service.answer("/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=psi)[
        "estimates"
    ]
    assert estimates["coulomb"] == 0.0
    assert estimates["stiff_bound"] == pytest.approx(
        min(1.0, HIGHEST_CAP / (psi * math.sqrt(kappa))), rel=1e-14
    )
    assert estimates["stiff_asymptote"] == pytest.approx(
        4.4848 * kappa**-1.25 / psi, rel=1e-14, abs=0
    )


@pytest.mark.parametrize("psi", [2.0, 2.5, 1e6])
def test_stiff_estimates_are_null_when_psi_is_two_or_more(service, psi):
    estimates = service.answer("/collision", kappa=18, mu_over_alpha=1, gt_over_gn=psi)["estimates"]
    assert estimates["coulomb"] == pytest.approx(1 - 2 / psi, abs=1e-15)
    assert estimates["stiff_bound"] is None
    assert estimates["stiff_asymptote"] is None


@pytest.mark.parametrize(("kappa", "mu_over_alpha", "gt_over_gn"), COLLISIONS)
def test_sensitivity_is_the_slope_of_epsilon_t(service, kappa, mu_over_alpha, gt_over_gn):
    def epsilon_t(log_kappa, log_psi):
        return service.answer(
            "/collision",
            kappa=repr(kappa * math.exp(log_kappa)),
            mu_over_alpha=mu_over_alpha,
            gt_over_gn=repr(gt_over_gn * math.exp(log_psi)),
            quantities="epsilon_t",
        )["epsilon_t"]

    sensitivity = service.answer(
        "/collision", kappa=kappa, mu_over_alpha=mu_over_alpha, gt_over_gn=gt_over_gn
    )["sensitivity"]
    step = 1e-6
    by_kappa = (epsilon_t(step, 0) - epsilon_t(-step, 0)) / (2 * step)
    by_psi = (epsilon_t(0, step) - epsilon_t(0, -step)) / (2 * step)
    # central differences: rounding 1e-15/step, and a third derivative of order κ^{3/2} step²
    assert sensitivity["kappa"] == pytest.approx(by_kappa, abs=1e-7)
    assert sensitivity["psi"] == pytest.approx(by_psi, abs=1e-7)


def test_epsilon_t_depends_on_kappa_and_psi_alone(service):
    ratios = [
        service.answer("/collision", kappa=63, mu_over_alpha=m, gt_over_gn=m * 0.5)["epsilon_t"]
        for m in (0.25, 1.0, 1024.0)
    ]
    assert ratios[0] == ratios[1] == ratios[2]


QUANTITIES = {
    "epsilon_t",
    "epsilon_n",
    "switches",
    "reversals",
    "episodes",
    "energy",
    "estimates",
    "sensitivity",
    "summary",
}


@pytest.mark.parametrize("quantity", sorted(QUANTITIES))
def test_quantities_asked_for_are_the_same_as_without_asking(service, quantity):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
    everything = service.answer("/collision", **collision)
    answer = service.answer("/collision", **collision, quantities=quantity)
    assert answer[quantity] == everything[quantity]
    assert answer["epsilon_t"] == everything["epsilon_t"]
