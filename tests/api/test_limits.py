"""What the calls say where ψ is 0 or infinite: μ = 0, g_t = 0, quotients beyond the doubles."""

import math

import pytest

CONTACT_DURATION = 3.2180654597190430845


@pytest.mark.parametrize(
    ("mu_over_alpha", "gt_over_gn"),
    [("0", "0.5"), ("0", "5e-324"), ("-0.0", "1"), ("1e-200", "1e120"), ("5e-324", "1e10")],
)
def test_smooth_spheres_keep_their_velocity(service, mu_over_alpha, gt_over_gn):
    answer = service.answer(
        "/collision", kappa=18, mu_over_alpha=mu_over_alpha, gt_over_gn=gt_over_gn
    )
    assert answer["epsilon_t"] == 1.0
    assert answer["parameters"]["psi"] is None
    assert answer["limit"] is False
    assert answer["switches"] == 0
    assert answer["reversals"] == 0
    assert [e["regime"] for e in answer["episodes"]] == ["sliding"]
    assert answer["estimates"] == {"coulomb": 1.0, "stiff_bound": None, "stiff_asymptote": None}
    assert answer["sensitivity"] == {"kappa": 0.0, "psi": 0.0}


def test_energy_is_kept_when_friction_is_zero(service):
    energy = service.answer("/collision", kappa=18, mu_over_alpha=0, gt_over_gn=3)["energy"]
    assert energy.items() >= {"initial": 4.5, "final": 4.5, "dissipated": 0.0}.items()


@pytest.mark.parametrize(
    ("mu_over_alpha", "gt_over_gn", "method"),
    [(1e200, 3e200, "auto"), (1e200, 1e200, "stiff"), (1e-200, 1e200, "auto"), (0, 1e200, "auto")],
)
def test_energy_is_null_when_it_is_beyond_the_doubles(service, mu_over_alpha, gt_over_gn, method):
    answer = service.answer(
        "/collision", kappa=18, mu_over_alpha=mu_over_alpha, gt_over_gn=gt_over_gn, method=method
    )
    assert answer["energy"]["initial"] is None


@pytest.mark.parametrize("kappa", [1e-6, 0.95304, 18.0, 37204.0])
def test_epsilon_t_is_the_free_swing_when_nothing_moves(service, kappa):
    answer = service.answer("/collision", kappa=kappa, mu_over_alpha=1.4, gt_over_gn=0)
    assert answer["limit"] is True
    assert answer["epsilon_t"] == pytest.approx(
        math.cos(math.sqrt(kappa) * CONTACT_DURATION), abs=1e-15 * max(1, math.sqrt(kappa))
    )
    assert answer["parameters"]["psi"] == 0.0
    assert answer["switches"] == 0
    assert answer["reversals"] == 0
    zero = {"initial": 0.0, "final": 0.0, "dissipated": 0.0}
    assert answer["energy"].items() >= zero.items()
    assert answer["error_bound"] <= 1e-10


def test_zero_friction_wins_over_zero_velocity(service):
    answer = service.answer("/collision", kappa=18, mu_over_alpha=0, gt_over_gn=0)
    assert answer["epsilon_t"] == 1.0
    assert answer["limit"] is False
    assert answer["parameters"]["psi"] is None
    assert answer["switches"] == 0


@pytest.mark.parametrize("gt_over_gn", [1e-300, 5e-324])
def test_limit_is_false_when_the_velocity_is_merely_tiny(service, gt_over_gn):
    answer = service.answer("/collision", kappa=18, mu_over_alpha=1e30, gt_over_gn=gt_over_gn)
    assert answer["limit"] is False
    # it slides at first, if only for an instant, and at the very end
    assert answer["switches"] == 2
    assert answer["epsilon_t"] == pytest.approx(
        math.cos(math.sqrt(18) * CONTACT_DURATION), abs=1e-14
    )


def test_trace_is_zero_when_nothing_moves(service):
    answer = service.answer("/trace", kappa=18, mu_over_alpha=1.4, gt_over_gn=0, samples=50)
    for name in (
        "tangential_force_over_mu",
        "tangential_velocity",
        "spring_elongation",
        "regime",
        "tangential_energy",
    ):
        assert answer[name] == [0] * 50, name
    assert answer["switch_times"] == []
    assert answer["limit"] is True
    assert max(answer["normal_force"]) > 1.1


@pytest.mark.parametrize("gt_over_gn", [0, 0.5])
def test_trace_has_the_full_friction_law_when_friction_is_zero(service, gt_over_gn):
    answer = service.answer("/trace", kappa=18, mu_over_alpha=0, gt_over_gn=gt_over_gn, samples=50)
    assert answer["tangential_force_over_mu"] == [0.0 - f for f in answer["normal_force"]]
    assert answer["tangential_velocity"] == [gt_over_gn] * 50
    assert answer["spring_elongation"] == [0.0] * 50
    assert answer["limit"] is False


def test_many_collisions_have_the_same_limits(service):
    answer = service.collisions(
        {"kappa": 18, "mu_over_alpha": [0, 1.4, 0], "gt_over_gn": [0.5, 0, 0]}
    )
    assert answer["epsilon_t"][0] == answer["epsilon_t"][2] == 1.0
    assert answer["epsilon_t"][1] == pytest.approx(
        math.cos(math.sqrt(18) * CONTACT_DURATION), abs=1e-14
    )
    assert answer["switches"] == [0, 0, 0]


def test_map_reaches_down_to_no_velocity(service):
    answer = service.answer(
        "/map",
        mu_over_alpha=1.4,
        gt_over_gn_min=0,
        gt_over_gn_count=2,
        kappa_count=3,
        quantities="epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote,error",
    )
    free_swing = [math.cos(math.sqrt(k) * CONTACT_DURATION) for k in answer["kappa"]]
    assert answer["epsilon_t"][0] == pytest.approx(free_swing, abs=1e-14)
    assert answer["switches"][0] == [0, 0, 0]
    assert answer["coulomb"][0] == [0.0, 0.0, 0.0]
    assert answer["stiff_bound"][0] == [1.0, 1.0, 1.0]
    assert answer["stiff_asymptote"][0] == [None, None, None]
    assert answer["error"][0] == [0.0, 0.0, 0.0]
