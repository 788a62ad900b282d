"""Real spheres by what is known of them: ε_n, speed and angle; what comes out by other names."""

import csv
import io
import math

import numpy as np
import pytest
from test_scaling import BODY, VECTORS, WALL, changed, scaling, wrong

from restitution.mechanics.contact import damping_of
from steel import PAIR as STEEL


def test_normal_restitution_gives_the_dissipative_constant(service):
    answer = scaling(service, STEEL | {"normal_restitution": 0.9})
    assert answer["dissipative_constant_s"] == pytest.approx(2.31424e-6, abs=5e-12)
    assert answer["epsilon_t"] == pytest.approx(0.42297039, abs=5e-9)
    assert answer["damping"] == damping_of(0.9)
    assert answer["epsilon_n"] == pytest.approx(0.9, rel=0, abs=4e-15)
    constant = {"dissipative_constant_s": answer["dissipative_constant_s"]}
    same = scaling(service, STEEL | constant)
    assert same["epsilon_t"] == pytest.approx(answer["epsilon_t"], abs=1e-13)


def test_it_may_hold_at_another_velocity_than_that_of_the_impact(service):
    known = {"normal_restitution": 0.9, "at_normal_velocity_m_s": 1}
    fast = STEEL | {"impact": {"normal_velocity_m_s": 32, "tangential_velocity_m_s": 0.5}}
    answer = scaling(service, fast | known)
    # A is the material's, η goes with g_n^{1/5}
    assert answer["dissipative_constant_s"] == pytest.approx(2.31424e-6, abs=5e-12)
    assert answer["damping"] == pytest.approx(2 * damping_of(0.9), rel=1e-14)
    assert answer["epsilon_n"] < 0.83


def test_one_is_no_damping(service):
    assert scaling(service, STEEL | {"normal_restitution": 1}) == scaling(service, STEEL)


@pytest.mark.parametrize(
    ("change", "name", "words"),
    [
        ({"normal_restitution": 0.9, "dissipative_constant_s": 0}, "normal_restitution",
         "left out, as dissipative_constant_s is given"),
        ({"normal_restitution": 0}, "normal_restitution", "from 1.5e-50 to 1"),
        ({"normal_restitution": "0.9"}, "normal_restitution", "from 1.5e-50 to 1"),
        ({"normal_restitution": 0.9, "at_normal_velocity_m_s": 0}, "at_normal_velocity_m_s", "> 0"),
        ({"at_normal_velocity_m_s": 1}, "at_normal_velocity_m_s", "normal_restitution"),
        ({"normal_restitution": 2e-50, "at_normal_velocity_m_s": 1e-9}, "normal_restitution",
         "larger: with damping ="),
    ],
)  # fmt: skip
def test_restitution_that_does_not_suit_is_refused_in_words(service, change, name, words):
    assert words in wrong(service, STEEL | change)[name]["requirement"]


def test_map_takes_a_restitution_at_one_velocity(service):
    axis = {"min": 1, "max": 32, "count": 2}
    body = STEEL | {"normal_velocity_m_s": axis, "tangential_velocity_m_s": axis}
    del body["impact"]
    errors = service.problem(
        service.post(body | {"normal_restitution": 0.9}, path="/scaling/map"), 422
    )["errors"]
    assert [error["parameter"] for error in errors] == ["at_normal_velocity_m_s"]
    known = {"normal_restitution": 0.9, "at_normal_velocity_m_s": 1}
    answer = service.read(service.post(body | known, path="/scaling/map"))
    dampings = damping_of(0.9) * np.array([1.0, 2.0])
    assert answer["damping"] == pytest.approx(dampings.tolist(), rel=1e-14)


def test_speed_and_angle_are_both_velocities(service):
    answer = scaling(service, STEEL | {"impact": {"speed_m_s": 3.9, "angle_deg": 30}})
    assert answer["normal_velocity_m_s"] == pytest.approx(3.9 * math.cos(math.pi / 6), rel=1e-15)
    assert answer["tangential_velocity_m_s"] == pytest.approx(1.95, rel=1e-15)
    assert answer["after"] is None
    head_on = scaling(service, STEEL | {"impact": {"speed_m_s": 3.9, "angle_deg": 0}})
    assert (head_on["normal_velocity_m_s"], head_on["gt_over_gn"]) == (3.9, 0)
    # what is left to 90° keeps its digits
    grazing = scaling(service, STEEL | {"impact": {"speed_m_s": 1, "angle_deg": 89.999999}})
    left = math.radians(90 - 89.999999)
    assert grazing["normal_velocity_m_s"] == pytest.approx(left, rel=1e-13)


@pytest.mark.parametrize(
    ("impact", "name", "words"),
    [
        ({"speed_m_s": 1, "angle_deg": 90}, "angle_deg", "< 90"),
        ({"speed_m_s": 1, "angle_deg": -30}, "angle_deg", "does not depend on the sign"),
        ({"speed_m_s": 0, "angle_deg": 30}, "speed_m_s", "approach"),
        ({"speed_m_s": 1}, "angle_deg", "from the normal"),
        ({"speed_m_s": 1, "angle_deg": 30, "normal_velocity_m_s": 1}, "normal_velocity_m_s",
         "left out, as speed_m_s"),
        (VECTORS | {"speed_m_s": 1}, "speed_m_s", "left out, as velocities are given"),
    ],
)  # fmt: skip
def test_impact_is_told_in_one_way(service, impact, name, words):
    entry = wrong(service, STEEL | {"impact": impact})[f"impact.{name}"]
    assert words in entry["requirement"]


def test_centre_restitution_is_that_of_the_velocities_after(service):
    impact = {"velocity_1_m_s": [0.7, 0, -1], "velocity_2_m_s": [0, 0, 0], "normal": [0, 0, 1]}
    for body in (STEEL, BODY):
        answer = scaling(service, body | {"impact": impact})
        first, second = (answer["after"][f"velocity_{i}_m_s"] for i in (1, 2))
        ratio = (first[0] - second[0]) / 0.7
        assert answer["centre_restitution"] == pytest.approx(ratio, abs=1e-14)


def test_impulse_ratio_is_that_of_the_momentum_which_is_exchanged(service):
    impact = {"velocity_1_m_s": [0.7, 0, -1], "velocity_2_m_s": [0, 0, 0], "normal": [0, 0, 1]}
    answer = scaling(service, STEEL | {"impact": impact, "normal_restitution": 0.8})
    x, _, z = answer["after"]["velocity_1_m_s"]
    assert answer["impulse_ratio"] == pytest.approx((0.7 - x) / (z + 1), abs=1e-14)
    assert 0 < answer["impulse_ratio"] < 0.4


@pytest.mark.parametrize("tangential", [3, 1e8, 1e300])
def test_impulse_ratio_of_sliding_is_the_friction(service, tangential):
    impact = {"normal_velocity_m_s": 1, "tangential_velocity_m_s": tangential}
    assert scaling(service, STEEL | {"impact": impact})["impulse_ratio"] == 0.4


@pytest.mark.parametrize("known", [{}, {"normal_restitution": 0.7}])
def test_walton_beta_0_is_the_limit_of_weak_slip(service, known):
    weak = {"normal_velocity_m_s": 1, "tangential_velocity_m_s": 1e-12}
    answer = scaling(service, STEEL | known | {"impact": weak})
    # the way to the limit goes with ψ^{2/3}, or with damping faster
    assert answer["walton_beta_0"] == pytest.approx(-answer["epsilon_t"], abs=1e-6)
    assert answer["walton_beta_0"] == scaling(service, STEEL | known)["walton_beta_0"]


def test_beta_0_of_a_phase_that_double_precision_does_not_hold_is_null(service):
    stiff = STEEL | {"tangential_stiffness_n_per_m": 1e50}
    assert scaling(service, stiff)["walton_beta_0"] is None


def test_convention_says_what_each_is(service):
    words = scaling(service, STEEL)["convention"]
    for name in ("epsilon_t", "centre_restitution", "impulse_ratio", "walton_beta_0"):
        assert f"{name} = " in words


@pytest.mark.parametrize("beta_0", [-1, -0.5, 0, 0.4, 0.999999, 1])
def test_kappa_of_walton_has_its_beta_0_and_so_have_the_others(service, beta_0):
    answer = service.answer("/walton", beta_0=beta_0)
    assert 0 <= answer["kappa"] <= 0.95304
    assert answer["others"] == sorted(answer["others"])
    assert len(answer["others"]) == 3
    assert "others have it as well" in answer["convention"]
    for kappa in (answer["kappa"], *answer["others"]):
        if kappa:
            weak = service.answer("/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=0)
            assert weak["epsilon_t"] == pytest.approx(-beta_0, abs=1e-14)
    rows = csv.DictReader(io.StringIO(service.get("/walton", beta_0=beta_0, format="csv").text))
    assert [float(row["kappa"]) for row in rows] == [answer["kappa"], *answer["others"]]


@pytest.mark.parametrize("beta_0", ["1.01", "-2", "NaN", "rough"])
def test_beta_0_out_of_range_is_refused_in_words(service, beta_0):
    assert service.wrong("/walton", beta_0=beta_0)["beta_0"]["requirement"] == "from -1 to 1"


@pytest.mark.parametrize(
    ("path", "value", "parameter", "words"),
    [
        ("spin_2_rad_s", [0, 0, 1], "impact.spin_2_rad_s", "put ω × r into its velocity"),
    ],
)
def test_neighbours_are_named(service, path, value, parameter, words):
    body = changed(f"impact.{path}", value, changed("impact", VECTORS))
    assert body["body_2"] == WALL
    assert words in wrong(service, body)[parameter]["requirement"]
