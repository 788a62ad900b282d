"""``GET /bounce``: a ball before and after it bounces, as JSON and as rows, and what is refused."""

import csv
import io

import pytest

COLLISION = {"kappa": 4.5, "mu_over_alpha": 1.4, "gt_over_gn": 1.1}


def test_bounce_has_the_collision_of_the_service_and_that_of_a_ball_that_falls_back(service):
    answer = service.answer("/bounce", **COLLISION, damping=0.1)
    first, second = answer["first"], answer["second"]
    assert first.items() >= COLLISION.items()
    for each in (first, second):
        names = ("kappa", "mu_over_alpha", "gt_over_gn", "damping")
        same = service.answer("/collision", **{name: each[name] for name in names})
        for name in ("epsilon_t", "epsilon_n"):
            assert each[name] == same[name]
    assert second["kappa"] == pytest.approx(4.5 * first["epsilon_n"] ** -0.4, rel=1e-14)
    assert second["damping"] == pytest.approx(0.1 * first["epsilon_n"] ** 0.2, rel=1e-14)
    left = first["epsilon_t"] * 1.1
    assert second["direction"] * second["gt_over_gn"] == pytest.approx(
        left / first["epsilon_n"], rel=1e-14
    )


def test_factors_depend_on_the_bodies_alone(service):
    factors = ("mass_share", "centre_change", "spin_change")
    body = {"alpha": 0.4, "partner": "sphere"}
    here = service.answer("/bounce", **COLLISION, **body)
    there = service.answer("/bounce", kappa=63, mu_over_alpha=1, gt_over_gn=0.1, **body)
    assert [here[name] for name in factors] == [there[name] for name in factors]
    assert [here[name] for name in factors] == pytest.approx([0.5, -0.2, 0.3], rel=1e-15)
    assert here["second"] is None
    assert service.answer("/bounce", **COLLISION)["alpha"] == 2 / 7


def test_rows_are_the_motions(service):
    answer = service.answer("/bounce", **COLLISION, spin_share=0.5)
    text = service.get("/bounce", **COLLISION, spin_share=0.5, format="csv").text
    rows = [*csv.DictReader(io.StringIO(text))]
    assert [row.pop("bounces") for row in rows] == ["0", "1", "2"]
    assert [{name: float(row[name]) for name in row} for row in rows] == answer["motions"]


def test_restitution_may_stand_for_the_damping(service):
    answer = service.answer("/bounce", **COLLISION, normal_restitution=0.9)
    assert answer["motions"][1]["normal_velocity"] == pytest.approx(0.9, rel=1e-14)
    assert answer["motions"][2]["normal_velocity"] < 0.9


@pytest.mark.parametrize(
    ("given", "name", "words"),
    [
        ({"alpha": 0}, "alpha", "> 0 and ≤ 1"),
        ({"alpha": 1.01}, "alpha", "> 0 and ≤ 1"),
        ({"spin_share": -0.1}, "spin_share", "from 0 to 1"),
        ({"partner": "floor"}, "partner", "wall or sphere"),
        ({"gt_over_gn": -1}, "gt_over_gn", "finite and ≥ 0: ε_t does not depend on the sign"),
    ],
)
def test_what_no_ball_does_is_refused_in_words(service, given, name, words):
    assert service.wrong("/bounce", **COLLISION | given)[name]["requirement"] == words
