"""``POST /scaling`` and ``GET /materials``: real spheres in SI units, and what is refused."""

import copy
import csv
import io
import math

import numpy as np
import pytest
from hypothesis import example, given, seed
from hypothesis import strategies as st

LARGEST = 1.7976931348623157e308
SMALLEST = 5e-324

SPHERE = {"radius_m": 0.02, "density_kg_m3": 7850, "youngs_modulus_pa": 2.1e11,
          "poisson_ratio": 0.3, "inertia": "solid"}  # fmt: skip
WALL = {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25}
BODY = {
    "body_1": SPHERE,
    "body_2": WALL,
    "friction_coefficient": 0.4,
    "tangential_stiffness_n_per_m": 1e12,
    "dissipative_constant_s": 0,
    "impact": {"normal_velocity_m_s": 20, "tangential_velocity_m_s": 5},
}
VECTORS = {
    "velocity_1_m_s": [1, 0, -2],
    "velocity_2_m_s": [0, 0.5, 0],
    "spin_1_rad_s": [3, 2, 1],
    "spin_2_rad_s": [0, 0, 0],
    "normal": [0, 0, 2],
}
KEYS = {
    "kappa", "mu_over_alpha", "gt_over_gn", "damping", "psi", "alpha", "beta", "effective_mass_kg",
    "effective_radius_m", "effective_modulus_pa", "tangential_stiffness_n_per_m",
    "normal_velocity_m_s", "tangential_velocity_m_s", "time_scale_s", "length_scale_m",
    "contact_duration_s", "maximum_compression_m", "maximum_normal_force_n", "epsilon_n",
    "epsilon_t", "switches", "after", "warnings", "convention",
}  # fmt: skip


def changed(path, value, body=BODY):
    """Return a copy of `body` with the member at a dotted path replaced, or left out if None."""
    copied = copy.deepcopy(body)
    *parents, last = path.split(".")
    inner = copied
    for parent in parents:
        inner = inner[parent]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return copied


def scaling(service, body, **query):
    return service.read(service.post(body, path="/scaling", **query))


def wrong(service, body):
    errors = service.problem(service.post(body, path="/scaling"), 422)["errors"]
    return {entry["parameter"]: entry for entry in errors}


def test_example_of_the_contract_has_every_key(service):
    answer = scaling(service, BODY)
    assert answer.keys() >= KEYS
    assert answer["after"] is None
    assert answer["epsilon_n"] == 1.0
    assert answer["psi"] == pytest.approx(0.25 / 0.4 * 2 / 7)
    assert [set(w) for w in answer["warnings"]] == [{"code", "text", "values"}] * len(
        answer["warnings"]
    )


def test_epsilon_t_is_that_of_the_scaled_collision(service):
    answer = scaling(service, BODY)
    names = ("kappa", "mu_over_alpha", "gt_over_gn")
    scaled = service.answer("/collision", **{name: answer[name] for name in names})
    assert scaled["epsilon_t"] == answer["epsilon_t"]
    assert scaled["switches"] == answer["switches"]


def test_velocities_and_spins_come_back(service):
    answer = scaling(service, changed("impact", VECTORS))
    after = answer["after"]
    assert after.keys() == {"velocity_1_m_s", "velocity_2_m_s", "spin_1_rad_s", "spin_2_rad_s"}
    assert after["velocity_1_m_s"][2] == pytest.approx(2.0, rel=1e-15)
    assert after["velocity_2_m_s"] == [0, 0.5, 0]


def test_spins_may_be_left_out(service):
    impact = {name: VECTORS[name] for name in ("velocity_1_m_s", "velocity_2_m_s", "normal")}
    resting = VECTORS | {"spin_1_rad_s": [0, 0, 0]}
    assert scaling(service, changed("impact", impact)) == scaling(
        service, changed("impact", resting)
    )


def test_mass_stands_for_density_and_moment_for_shape(service):
    answer = scaling(service, BODY)
    mass = 4 / 3 * math.pi * 0.02**3 * 7850
    sphere = {key: SPHERE[key] for key in ("radius_m", "youngs_modulus_pa", "poisson_ratio")}
    moment = {"moment_kg_m2": 0.4 * mass * 0.02**2}
    other = scaling(service, changed("body_1", sphere | {"mass_kg": mass, "inertia": moment}))
    assert other["kappa"] == pytest.approx(answer["kappa"], rel=1e-14)
    assert other["alpha"] == pytest.approx(answer["alpha"], rel=1e-14)


def test_mindlin_stands_for_the_stiffness(service):
    equal = changed("body_2", SPHERE, changed("tangential_stiffness_n_per_m", "mindlin"))
    assert scaling(service, equal)["kappa"] == pytest.approx(4.521, abs=5e-4)


def test_no_friction_has_no_psi(service):
    answer = scaling(service, changed("friction_coefficient", 0))
    assert answer["psi"] is None
    assert answer["epsilon_t"] == 1.0


def test_every_material_is_a_valid_body(service):
    items = service.answer("/materials")["items"]
    assert len({item["id"] for item in items}) == len(items) >= 4
    for item in items:
        assert {"id", "title", "body_1", "body_2", "friction_coefficient", "source"} <= item.keys()
        assert -1 <= scaling(service, item)["epsilon_t"] <= 1


def test_measured_points_name_their_convention(service):
    items = {item["id"]: item for item in service.answer("/materials")["items"]}
    measured = items["alumina-on-glass"]["measured"]
    assert "1 - (1 - e_c)/alpha" in measured["convention"]
    for point in measured["points"]:
        assert point["epsilon_t"] == pytest.approx(1 - 3.5 * (1 - point["centre_ratio"]), abs=1e-14)
        speed = math.hypot(point["normal_velocity_m_s"], point["tangential_velocity_m_s"])
        assert speed == pytest.approx(3.9, rel=1e-14)


def test_forms_hold_the_same_numbers(service):
    body = changed("impact", VECTORS)
    answer = scaling(service, body)
    (row,) = csv.DictReader(io.StringIO(service.post(body, path="/scaling", format="csv").text))
    packed = service.post(body, path="/scaling", format="npz")
    with np.load(io.BytesIO(packed.content)) as arrays:
        assert arrays.keys() == row.keys()
        for name, text in row.items():
            if name not in {"warnings", "method", "convention"}:
                assert arrays[name] == (float(text) if text not in {"true", "false"} else True)
    assert float(row["kappa"]) == answer["kappa"]
    assert float(row["after.spin_1_rad_s.y"]) == answer["after"]["spin_1_rad_s"][1]
    assert row["warnings"].split() == [w["code"] for w in answer["warnings"]]


def test_form_without_after_keeps_its_columns(service):
    (row,) = csv.DictReader(io.StringIO(service.post(BODY, path="/scaling", format="csv").text))
    assert row["after.velocity_2_m_s.z"] == ""


# refusals


@pytest.mark.parametrize(
    ("path", "value", "parameter", "words"),
    [
        ("body_1.radius_m", 0, "body_1.radius_m", "> 0"),
        ("body_1.radius_m", "2 cm", "body_1.radius_m", "> 0"),
        ("body_1.radius_m", True, "body_1.radius_m", "> 0"),
        ("body_1.radius_m", None, "body_1.radius_m", "> 0"),
        ("body_1.youngs_modulus_pa", -1, "body_1.youngs_modulus_pa", "> 0"),
        ("body_1.poisson_ratio", -1, "body_1.poisson_ratio", "> -1"),
        ("body_1.poisson_ratio", 0.51, "body_1.poisson_ratio", "0.5"),
        ("body_1.density_kg_m3", None, "body_1.density_kg_m3", "mass_kg"),
        ("body_1.mass_kg", 1.0, "body_1.mass_kg", "density_kg_m3"),
        ("body_1.inertia", "round", "body_1.inertia", "solid, hollow"),
        ("body_1.inertia", {"moment_kg_m2": 0}, "body_1.inertia.moment_kg_m2", "> 0"),
        ("body_1.inertia", {"moment_kg_m2": 1, "x": 1}, "body_1.inertia.x", "left out"),
        ("body_1.colour", "red", "body_1.colour", "left out"),
        ("body_1", WALL, "body_2.wall", "sphere"),
        ("body_1", [], "body_1", "object"),
        ("body_1", None, "body_1", "object"),
        ("body_2.radius_m", 1.0, "body_2.radius_m", "a wall has infinite radius"),
        ("body_2.wall", 1, "body_2.wall", "true"),
        ("body_2.yield_stress_pa", 0, "body_2.yield_stress_pa", "> 0"),
        ("friction_coefficient", -0.1, "friction_coefficient", "≥ 0"),
        ("friction_coefficient", None, "friction_coefficient", "≥ 0"),
        ("tangential_stiffness_n_per_m", 0, "tangential_stiffness_n_per_m", "mindlin"),
        ("tangential_stiffness_n_per_m", "Mindlin", "tangential_stiffness_n_per_m", "mindlin"),
        ("tangential_stiffness_n_per_m", None, "tangential_stiffness_n_per_m", "mindlin"),
        ("dissipative_constant_s", 1e30, "dissipative_constant_s", "smaller"),
        ("dissipative_constant_s", -1e-6, "dissipative_constant_s", "≥ 0"),
        ("impact", None, "impact", "normal"),
        ("impact", {}, "impact.normal_velocity_m_s", "> 0"),
        ("impact.normal_velocity_m_s", 0, "impact.normal_velocity_m_s", "approach"),
        ("impact.normal_velocity_m_s", -3, "impact.normal_velocity_m_s", "approach"),
        ("impact.tangential_velocity_m_s", -3, "impact.tangential_velocity_m_s", "≥ 0"),
        ("impact.normal", [0, 0, 1], "impact.velocity_1_m_s", "three"),
        ("impact.normal", [0, 0, 1], "impact.normal_velocity_m_s", "left out"),
        ("kappa", 18, "kappa", "left out"),
        ("", 1, "", "left out"),
    ],
)
def test_wrong_members_are_named_with_what_to_change(service, path, value, parameter, words):
    entry = wrong(service, changed(path, value))[parameter]
    assert words in entry["requirement"]


@pytest.mark.parametrize(
    ("path", "value", "parameter", "words"),
    [
        ("normal", [0, 0, 0], "impact.normal", "length > 0"),
        ("normal", [0, 1], "impact.normal", "three"),
        ("normal", [0, 1, "x"], "impact.normal[2]", "finite"),
        ("velocity_1_m_s", [0, 0, 5], "impact.velocity_1_m_s", "approach"),
        ("velocity_2_m_s", None, "impact.velocity_2_m_s", "three"),
        ("spin_1_rad_s", 3, "impact.spin_1_rad_s", "three"),
        ("spin_2_rad_s", [0, 0, 1], "impact.spin_2_rad_s", "wall"),
        ("spin_3_rad_s", [0, 0, 1], "impact.spin_3_rad_s", "left out"),
    ],
)
def test_wrong_vectors_are_named_with_what_to_change(service, path, value, parameter, words):
    entry = wrong(service, changed(f"impact.{path}", value, changed("impact", VECTORS)))[parameter]
    assert words in entry["requirement"]


def test_everything_wrong_is_named_at_once(service):
    body = {
        "body_1": {"radius_m": 0, "poisson_ratio": 0.6, "inertia": "x", "shape": 1},
        "body_2": {"wall": True, "radius_m": 1},
        "friction_coefficient": -1,
        "tangential_stiffness_n_per_m": [1],
        "impact": {"velocity_1_m_s": [0, "x", 1e999], "normal": [0, 0, 0]},
        "mass": 1,
    }
    assert wrong(service, body).keys() == {
        "body_1.radius_m", "body_1.poisson_ratio", "body_1.inertia", "body_1.shape",
        "body_1.youngs_modulus_pa", "body_1.density_kg_m3", "body_2.radius_m",
        "body_2.youngs_modulus_pa", "body_2.poisson_ratio", "friction_coefficient",
        "tangential_stiffness_n_per_m", "impact.velocity_1_m_s[1]", "impact.velocity_1_m_s[2]",
        "impact.velocity_2_m_s", "impact.normal", "mass",
    }  # fmt: skip


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999", "1" + "0" * 500])
def test_numbers_beyond_doubles_are_refused_by_name(service, number):
    text = b'{"body_1": {"radius_m": %s}}' % number.encode()
    assert "> 0" in wrong(service, text)["body_1.radius_m"]["requirement"]


def test_keys_given_twice_are_refused_by_name(service):
    text = b'{"body_1": {"radius_m": 1, "radius_m": 2}, "impact": {}, "impact": {}}'
    assert {"body_1.radius_m", "impact"} == wrong(service, text).keys()


def test_body_beyond_two_mebibytes_is_413(service):
    body = b'{"body_1": "' + b"x" * 2 * 2**20 + b'"}'
    assert "2,097,152" in service.problem(service.post(body, path="/scaling"), 413)["detail"]


def test_unknown_queries_are_refused(service):
    problem = service.problem(service.post(BODY, path="/scaling", colour="red"), 422)
    assert [e["parameter"] for e in problem["errors"]] == ["colour"]


# every finite positive double

ANY = st.integers(1, 0x7FEFFFFFFFFFFFFF).map(
    lambda bits: float(np.array(bits, np.uint64).view(np.float64))
)
NUMBER = st.one_of(ANY, st.floats(1e-3, 1e3), st.sampled_from([SMALLEST, 2.3e-308, 1.0, LARGEST]))
OR_ZERO = st.one_of(NUMBER, st.just(0.0))
SIGNED = st.tuples(OR_ZERO, st.sampled_from([1.0, -1.0])).map(lambda pair: pair[0] * pair[1])
INERTIA = st.one_of(
    st.sampled_from(["solid", "hollow"]), st.builds(lambda j: {"moment_kg_m2": j}, NUMBER)
)
BODIES = st.one_of(
    st.fixed_dictionaries(
        {"radius_m": NUMBER, "mass_kg": NUMBER, "youngs_modulus_pa": NUMBER,
         "poisson_ratio": st.floats(-1, 0.5, exclude_min=True), "inertia": INERTIA},
        optional={"yield_stress_pa": NUMBER},
    ),
    st.fixed_dictionaries(
        {"radius_m": NUMBER, "density_kg_m3": NUMBER, "youngs_modulus_pa": NUMBER,
         "poisson_ratio": st.just(0.3)}
    ),
    st.fixed_dictionaries(
        {"wall": st.just(True), "youngs_modulus_pa": NUMBER, "poisson_ratio": st.just(0.3)}
    ),
)  # fmt: skip
TRIPLE = st.lists(SIGNED, min_size=3, max_size=3)
IMPACTS = st.one_of(
    st.fixed_dictionaries({"normal_velocity_m_s": NUMBER, "tangential_velocity_m_s": OR_ZERO}),
    st.fixed_dictionaries(
        {"velocity_1_m_s": TRIPLE, "velocity_2_m_s": TRIPLE, "normal": TRIPLE},
        optional={"spin_1_rad_s": TRIPLE, "spin_2_rad_s": TRIPLE},
    ),
)
REQUESTS = st.fixed_dictionaries(
    {
        "body_1": BODIES,
        "body_2": BODIES,
        "friction_coefficient": OR_ZERO,
        "tangential_stiffness_n_per_m": st.one_of(NUMBER, st.just("mindlin")),
        "impact": IMPACTS,
    }
)


def honest_or_refused(service, body):
    response = service.affordable(lambda: service.post(body, path="/scaling"))
    if response.status_code == 422:
        for error in service.problem(response, 422)["errors"]:
            assert error["parameter"]
            assert len(error["requirement"]) > 10
        return False
    answer = service.read(response)
    for name in KEYS - {"psi", "switches", "after", "warnings", "convention"}:
        assert math.isfinite(answer[name]), name
    assert -1 <= answer["epsilon_t"] <= 1
    assert min(answer[name] for name in ("kappa", "alpha", "beta", "time_scale_s")) > 0
    return True


@seed(7)
@given(body=REQUESTS)
@example(changed("impact.normal_velocity_m_s", SMALLEST))
@example(changed("impact.tangential_velocity_m_s", LARGEST))
def test_any_double_anywhere_is_answered_or_refused_in_words(service, body):
    honest_or_refused(service, body)


PATHS = [
    "body_1.radius_m", "body_1.density_kg_m3", "body_1.youngs_modulus_pa",
    "body_2.youngs_modulus_pa", "friction_coefficient", "tangential_stiffness_n_per_m",
    "impact.normal_velocity_m_s", "impact.tangential_velocity_m_s", "dissipative_constant_s",
    "body_1.yield_stress_pa",
]  # fmt: skip


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("value", [SMALLEST, 1e-300, 1e-150, 1e150, 1e300, LARGEST])
def test_one_extreme_quantity_is_answered_or_refused_in_words(service, path, value):
    honest_or_refused(service, changed(path, value))


@pytest.mark.parametrize("path", PATHS[:-2])
@pytest.mark.parametrize("value", [1e-60, 1e60])
def test_one_extreme_quantity_that_doubles_can_follow_is_answered(service, path, value):
    assert honest_or_refused(service, changed(path, value))


def test_extremes_that_cancel_are_answered_as_the_same_collision(service):
    # lengths, masses, times in units 1e60, 1e-70 and 1e40 times as large
    answer = scaling(service, changed("impact", VECTORS))
    length, mass, time = 1e60, 1e-70, 1e40
    sphere = SPHERE | {
        "radius_m": 0.02 * length,
        "density_kg_m3": 7850 * mass / length / length / length,
        "youngs_modulus_pa": 2.1e11 * mass / length / time / time,
    }
    wall = WALL | {"youngs_modulus_pa": 7e10 * mass / length / time / time}
    body = BODY | {"body_1": sphere, "body_2": wall}
    body["tangential_stiffness_n_per_m"] = 1e12 * mass / time / time
    body["impact"] = {
        name: [part * (length / time if "velocity" in name else 1 / time) for part in vector]
        for name, vector in VECTORS.items()
    }
    other = scaling(service, body)
    for name in ("kappa", "psi", "alpha", "epsilon_t"):
        assert other[name] == pytest.approx(answer[name], rel=1e-12), name
    assert other["contact_duration_s"] == pytest.approx(answer["contact_duration_s"] * time)
