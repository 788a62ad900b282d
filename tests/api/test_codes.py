"""Inputs of DEM codes for a scaled collision of real bodies."""

import csv
import io
import json
import re
from pathlib import Path

import pytest
from test_scaling import SPHERE, WALL, scaling

GUIDE = Path(__file__).parents[2] / "docs" / "for-dem-codes.md"
COLLISION = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
ASKED = {"body_1": SPHERE, "body_2": SPHERE, "normal_velocity_m_s": 0.3, **COLLISION}
HOLLOW = {**SPHERE, "radius_m": 0.003, "inertia": "hollow"}


def codes(service, body):
    return service.read(service.post(body, path="/codes"))


@pytest.mark.parametrize("other", [SPHERE, WALL, HOLLOW])
@pytest.mark.parametrize("damping", [0, 0.2])
def test_bodies_with_these_inputs_have_the_collision(service, other, damping):
    answer = codes(service, ASKED | {"body_2": other, "damping": damping})
    stiffness = answer["normal_stiffness_pa"]
    mass = scaling(service, same_bodies(other, answer, 0))["effective_mass_kg"]
    # as LAMMPS' γ is told in the guide
    dissipation = 2 / 3 * answer["viscous_damping_per_metre_second"] * mass / stiffness
    found = scaling(service, same_bodies(other, answer, dissipation))
    for name, value in (COLLISION | {"damping": damping}).items():
        assert found[name] == pytest.approx(value, rel=1e-13)
    for name in ("epsilon_t", "epsilon_n", "contact_duration_s", "alpha"):
        assert answer[name] == pytest.approx(found[name], rel=1e-11)


def same_bodies(other, answer, dissipation):
    return {
        "body_1": SPHERE,
        "body_2": other,
        "friction_coefficient": answer["friction_coefficient"],
        "tangential_stiffness_n_per_m": answer["tangential_stiffness_n_per_m"],
        "dissipative_constant_s": dissipation,
        "impact": {name: answer[name] for name in (NORMAL, TANGENTIAL)},
    }


NORMAL, TANGENTIAL = "normal_velocity_m_s", "tangential_velocity_m_s"


def test_the_lines_are_those_of_the_guide(service):
    """Beads of glass: by its formulas there, and back by the service."""
    text = GUIDE.read_text()
    printed = re.search(r"^pair_coeff \* \* hertz .*$", text, re.MULTILINE)
    body = json.loads(re.search(r"^    curl .* -d '(\{.*?\})'$", text, re.MULTILINE | re.DOTALL)[1])
    assert f"κ = {body['kappa']}, η = {body['damping']}, ψ" in text
    answer = codes(service, body)
    _, line = answer["codes"][0]["lines"]
    assert_alike(line, printed[0])
    assert answer["contact_duration_s"] == pytest.approx(9.37e-6, rel=5e-4)
    assert answer["epsilon_t"] == pytest.approx(-0.2208, abs=5e-5)


def assert_alike(line, printed):
    """Words are the same, numbers to the three digits that the guide has of Young's modulus."""
    for ours, theirs in zip(line.split(), printed.split(), strict=True):
        try:
            assert float(ours) == pytest.approx(float(theirs), rel=5e-4)
        except ValueError:
            assert ours == theirs


def test_a_stiffness_that_grows_has_the_same_kappa_at_the_largest_compression(service):
    answer = codes(service, ASKED)
    ratio = answer["growing_stiffness_pa"] / (answer["alpha"] * answer["normal_stiffness_pa"])
    assert 1.25**0.2 * ratio == pytest.approx(63, rel=1e-14)
    _, growing, *_ = answer["codes"]
    _, normal, tangential, damping, *rest = growing["lines"][0].removeprefix("pair_style").split()
    assert float(normal) == pytest.approx(answer["normal_stiffness_pa"], rel=1e-8)
    assert float(tangential) == pytest.approx(answer["growing_stiffness_pa"], rel=1e-8)
    assert [damping, *rest] == ["0", "0", f"{answer['friction_coefficient']:.9g}", "0"]


@pytest.mark.parametrize("velocity", [1e-3, 30])
def test_where_the_stiffness_follows_from_the_materials_so_does_kappa(service, velocity):
    answer = codes(service, ASKED | {NORMAL: velocity})
    kappas = {each["code"]: each["kappa"] for each in answer["codes"]}
    # of ν = 0.3, as the guide has it
    assert kappas["LIGGGHTS"] == kappas["MFIX"] == pytest.approx(4.52, abs=5e-3)
    assert kappas["YADE"] == kappas["MercuryDPM"] == 63


def test_a_linear_contact_lasts_as_long(service):
    answer = codes(service, ASKED)
    kappa = answer["tangential_stiffness_n_per_m"] / (
        answer["alpha"] * answer["linear_stiffness_n_per_m"]
    )
    assert 0.953 * kappa == pytest.approx(63, rel=5e-4)


def test_only_the_same_law_with_the_same_damping_has_our_epsilon_t(service):
    def alike(**change):
        answer = codes(service, ASKED | change)
        told = {each["epsilon_t"] for each in answer["codes"]} - {None}
        assert told == {answer["epsilon_t"]}
        return [each["code"] for each in answer["codes"] if each["epsilon_t"] is not None]

    assert alike() == ["LAMMPS", "YADE", "MercuryDPM"]
    assert alike(damping=0.1) == alike(normal_restitution=0.9) == ["LAMMPS"]


def test_the_guide_tells_of_every_law(service):
    text = GUIDE.read_text()
    for each in codes(service, ASKED)["codes"]:
        assert each["code"] in text
        assert each["style"] in text


def test_csv_has_a_row_for_each_law(service):
    text = service.post(ASKED, path="/codes", format="csv").text
    rows = list(csv.DictReader(io.StringIO(text)))
    assert [row["code"] for row in rows].count("LAMMPS") == 3
    assert {row["law"] for row in rows} == {"this", "growing", "linear"}


@pytest.mark.parametrize(
    ("change", "name", "words"),
    [
        ({"kappa": 0}, "kappa", "finite and > 0"),
        ({"damping": 0.1, "normal_restitution": 0.9}, "normal_restitution", "left out"),
        ({"body_1": WALL, "body_2": WALL}, "body_2.wall", "left out"),
        ({NORMAL: 1e300}, "maximum_normal_force_n", "bring these nearer"),
        ({"kappa": 1e300}, "growing_stiffness_pa", "bring these nearer to 1"),
    ],
)
def test_what_cannot_be_is_refused_in_words(service, change, name, words):
    problem = service.problem(service.post(ASKED | change, path="/codes"), 422)
    requirements = {each["parameter"]: each["requirement"] for each in problem["errors"]}
    assert words in requirements[name]
