"""What a parameter was perhaps meant for is said, on the service and on the command line."""

import json
from collections import Counter

import pytest
from click.testing import CliRunner

from restitution import neighbours
from restitution.cli import main
from restitution.neighbours import MEANT, neighbour
from restitution.wire import bodies, queries
from restitution.wire.reading import MOST_NEIGHBOURS, names_within
from steel import PAIR as BODY
from steel import SPHERE

COLLISION = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
SAID = [
    (queries.CollisionQuery, "e_n cor restitution epsilon_n", "normal_restitution"),
    (queries.CollisionQuery, "eta damp_ing dampping", "damping"),
    (queries.CollisionQuery, "Kappa KAPPA kapa k_t stiffness stifness", "kappa"),
    (queries.CollisionQuery, "mu friction mu-over-alpha", "mu_over_alpha"),
    (queries.CollisionQuery, "gt psi gt_over_g", "gt_over_gn"),
    (queries.CollisionQuery, "tol", "tolerance"),
    (queries.CollisionQuery, "solver", "method"),
    (queries.CollisionQuery, "sep delimiter", "separator"),
    (queries.CutQuery, "n", "steps"),
    (queries.MapQuery, "kappa_minimum", "kappa_min"),
    (bodies.ScalingBody, "e_n cor", "normal_restitution"),
    (bodies.ScalingBody, "mu friction", "friction_coefficient"),
    (bodies.ScalingBody, "radius radius_mm R", "body_1.radius_m"),
    (bodies.ScalingBody, "mass", "body_1.mass_kg"),
    (bodies.ScalingBody, "poisson nu", "body_1.poisson_ratio"),
    (bodies.ScalingBody, "young youngs_modulus_gpa", "body_1.youngs_modulus_pa"),
    (bodies.ScalingBody, "normal_velocity_m_s normal_velocity", "impact.normal_velocity_m_s"),
    (bodies.ScalingBody, "theta angle", "impact.angle_deg"),
]


@pytest.mark.parametrize(
    ("of", "name", "meant"),
    [(of, name, meant) for of, names, meant in SAID for name in names.split()],
)
def test_neighbour_is_what_was_meant(of, name, meant):
    assert neighbour(name, names_within(of)) == meant


@pytest.mark.parametrize(
    "name", ["colour", "x", "", " ", "κ" * 41, "a" * 5000, "__class__", "\x00"]
)
def test_what_is_near_to_nothing_has_no_neighbour(name):
    for of in (queries.CollisionQuery, bodies.ScalingBody):
        assert neighbour(name, names_within(of)) is None


def test_synonyms_are_of_names_that_there_are():
    classes = [*vars(queries).values(), *vars(bodies).values()]
    known = {
        name.rpartition(".")[2]
        for of in classes
        if hasattr(of, "__dataclass_fields__")
        for name in names_within(of)
    }
    assert MEANT.keys() <= known
    for ours, words in MEANT.items():
        assert max(Counter(words.split()).values()) == 1, ours
        assert ours not in words.split()


def test_service_says_it(service):
    problem = service.refused("/collision", **COLLISION, epsilon_n=0.9, colour="red")
    assert problem["detail"] == (
        "no such parameter: epsilon_n; did you mean normal_restitution?; no such parameter: colour"
    )
    words = {error["parameter"]: error["requirement"] for error in problem["errors"]}
    assert words["epsilon_n"].endswith("; did you mean normal_restitution?")
    assert words["epsilon_n"].startswith("left out: ")
    assert "mean" not in words["colour"]


@pytest.mark.parametrize(
    ("change", "parameter", "meant"),
    [
        ({"mu": 0.4}, "mu", "friction_coefficient"),
        ({"body_1": SPHERE | {"e": 1}}, "body_1.e", "body_1.youngs_modulus_pa"),
        ({"body_1": SPHERE | {"cor": 1}}, "body_1.cor", "normal_restitution"),
        ({"impact": {"speed": 3, "angle_deg": 30}}, "impact.speed", "impact.speed_m_s"),
        ({"radius": 1}, "radius", "body_1.radius_m"),
    ],
)
def test_service_says_it_in_bodies(service, change, parameter, meant):
    errors = service.problem(service.post(BODY | change, path="/scaling"), 422)["errors"]
    words = {error["parameter"]: error["requirement"] for error in errors}
    assert words[parameter].endswith(f"; did you mean {meant}?")


def test_lists_of_collisions_say_it(service):
    words = service.wrong_body(COLLISION | {"e_n": [0.9]})["e_n"]["requirement"]
    assert words.endswith("; did you mean normal_restitution?")


def test_few_neighbours_are_looked_for(service, monkeypatch):
    looked = []
    monkeypatch.setattr(neighbours, "_close", lambda written, _: looked.append(written))
    many = {f"name{i}": 1 for i in range(800)}
    service.refused("/collision", **COLLISION, **many)
    # beside it and in the whole
    assert len(looked) == 2 * MOST_NEIGHBOURS


@pytest.mark.parametrize(
    ("option", "meant"),
    [
        ("--epsilon-n", "--normal-restitution"),
        ("--mu", "--friction"),
        ("--young", "--youngs-modulus"),
        ("--radius-mm", "--radius"),
    ],
)
def test_command_line_says_it(option, meant):
    done = CliRunner().invoke(main, ["collide", "-", option, "1"], input=json.dumps(BODY))
    assert done.exit_code == 2
    assert f"No such option '{option}'. Did you mean '{meant}'?" in done.stderr
