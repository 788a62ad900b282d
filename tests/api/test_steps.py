"""`GET /steps`: the calculator in its forms, its refusals, its extremes."""

import csv
import io

import numpy as np
import pytest

from cases import every_day

COLLISION = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.5}
INTEGRATORS = ("velocity_verlet", "symplectic_euler", "forward_euler")


def test_answer_holds_together(service):
    answer = service.answer("/steps", **COLLISION, error=1e-3)
    assert answer["parameters"]["psi"] == pytest.approx(0.5 / 1.4)
    assert answer["needed"].keys() == set(INTEGRATORS)
    rows = list(zip(answer["integrator"], answer["steps"], answer["error_max"], strict=True))
    for integrator in INTEGRATORS:
        needed = answer["needed"][integrator]
        assert needed.keys() == {"p95", "worst", "reason", "p95_tried", "worst_tried"}
        tried = needed["worst_tried"]
        assert tried["first"] <= needed["worst"] <= tried["last"]
        later = [e for i, n, e in rows if i == integrator and n >= needed["worst"]]
        assert max(later) <= 1e-3
        assert answer["rule"][integrator].keys() == {"error_median", "error_p95", "error_max"}
    assert answer["rule"]["factor"] == 50
    assert answer["rule"]["steps_min"] == answer["rule"]["steps_max"] == 213


@pytest.mark.verify
def test_region_is_answered_within_the_budget(service):
    for region in ("figure4", "stiff", "solids", "damped", "extremes"):
        response = service.affordable(lambda region=region: service.get("/steps", region=region))
        answer = service.read(response)
        assert answer["collisions"] == 128
        assert answer["parameters"]["kappa"] is answer["parameters"]["damping"] is None
    assert answer["needed"]["velocity_verlet"]["p95"] is None
    assert "65,536" in answer["needed"]["velocity_verlet"]["reason"]
    assert "1,000,000" in answer["rule"]["reason"]


def test_damping_is_that_of_the_time_steps_themselves(service):
    answer = service.answer("/steps", **COLLISION, damping=0.3)
    assert answer["parameters"]["damping"] == 0.3
    rows = zip(answer["integrator"], answer["steps"], answer["error_max"], strict=True)
    worst = {(name, steps): error for name, steps, error in rows}
    for integrator in INTEGRATORS:
        # one of the 32 phases that were tried
        error = service.answer(
            "/collision", **COLLISION, damping=0.3, method="timestep", steps=64,
            integrator=integrator, phase=0.25,
        )["error_bound"]  # fmt: skip
        assert 0.0 < error <= worst[integrator, 64]
    assert service.answer("/steps", **COLLISION, damping=0)["needed"] != answer["needed"]
    assert service.answer("/steps", **COLLISION)["parameters"]["damping"] == 0.0


def test_damping_of_a_region_is_its_own(service):
    for region in ("solids", "damped"):
        wrong = service.wrong("/steps", region=region, damping=0.1)
        assert wrong["damping"]["requirement"] == "left out, as `region` is given"
    wrong = service.wrong("/steps", **COLLISION, damping=-1)
    assert wrong["damping"]["requirement"] == "from 0 to 1e+30"


LARGEST = 1.7976931348623157e308


@pytest.mark.parametrize(
    ("damping", "kappa"),
    every_day(
        [(5e-324, 18), (1.0, LARGEST)], of=[(5e-324, 18), (1e30, 18), (1.0, 5e-324), (1.0, LARGEST)]
    ),
)
def test_extremes_of_damping_are_answered_within_the_budget(service, damping, kappa):
    collision = COLLISION | {"kappa": kappa, "damping": damping}
    response = service.affordable(lambda: service.get("/steps", **collision))
    for needed in service.read(response)["needed"].values():
        assert (needed["worst"] is None) is (needed["reason"] is not None)


def test_table_of_the_ladder_has_every_form(service):
    answer = service.answer("/steps", **COLLISION)
    text = service.get("/steps", **COLLISION, format="csv").text
    table = list(csv.DictReader(io.StringIO(text)))
    assert [row["integrator"] for row in table] == answer["integrator"]
    assert [float(row["error_p95"]) for row in table] == answer["error_p95"]
    with np.load(io.BytesIO(service.get("/steps", **COLLISION, format="npz").content)) as arrays:
        assert arrays["steps"].tolist() == answer["steps"]
        assert arrays["needed.forward_euler.p95"] == answer["needed"]["forward_euler"]["p95"]
        assert arrays["needed.forward_euler.p95_tried.last"] > answer["stability_limit"]
    typed = service.answer("/steps", **COLLISION, encoding="base64")
    assert typed["steps"]["dtype"] == "i4"
    assert typed["integrator"] == answer["integrator"]


def test_answer_is_cached(service):
    tag = service.get("/steps", **COLLISION).headers["etag"]
    again = service.get("/steps", headers={"If-None-Match": tag}, **COLLISION, error=1e-3)
    assert again.status_code == 304


def test_neither_collision_nor_region_is_refused(service):
    assert service.wrong("/steps").keys() == set(COLLISION)
    assert service.wrong("/steps", kappa=18).keys() == {"mu_over_alpha", "gt_over_gn"}


def test_both_collision_and_region_are_refused(service):
    wrong = service.wrong("/steps", region="solids", kappa=18)
    assert wrong.keys() == {"kappa"}
    assert "region" in wrong["kappa"]["requirement"]


@pytest.mark.parametrize(
    ("name", "value"),
    [("error", 0), ("error", 1.1), ("error", "nan"), ("region", "moon"), ("region", "")],
)
def test_wrong_values_are_refused(service, name, value):
    given = {"region": "solids", name: value}
    wrong = service.wrong("/steps", **given)
    assert wrong.keys() == {name}


EXTREMES = (5e-324, 1e-6, 1.0, 1e6, LARGEST)


@pytest.mark.parametrize("kappa", every_day([LARGEST], of=EXTREMES))
def test_extremes_are_answered_or_said_to_be_out_of_reach(service, kappa):
    # those between are in the region of extremes
    for friction, tangential in [(0.0, 1.0), (1.0, 0.0), (1.0, 5e-324), (1.0, 1.0), (1.0, LARGEST)]:
        collision = {"kappa": kappa, "mu_over_alpha": friction, "gt_over_gn": tangential}
        response = service.affordable(lambda given=collision: service.get("/steps", **given))
        for needed in service.read(response)["needed"].values():
            assert (needed["worst"] is None) is (needed["reason"] is not None)
