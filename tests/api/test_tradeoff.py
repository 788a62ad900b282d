"""The stored measurement in its forms, and measuring anew in the background."""

import csv
import io
import threading

import numpy as np
import pytest
from starlette.testclient import TestClient

from restitution.api.app import create_app
from restitution.api.settings import Settings
from restitution.studies.accuracy import candidates as every
from restitution.studies.accuracy import steps, tradeoff
from waiting import LIMIT_SECONDS, eventually

SCENES = ("figure4", "stiff", "solids", "damped", "extremes")


@pytest.mark.parametrize("scene", SCENES)
def test_stored_measurement_is_served(service, scene):
    answer = service.answer("/tradeoff", scene=scene)
    assert answer == tradeoff.load_tradeoff()[scene] | {"can_be_measured_anew": False}
    methods = {row["method"] for row in answer["rows"]}
    assert methods >= {"exact", "coulomb", "pragmatic", "timestep", "ode"}
    assert methods.isdisjoint({"stiff", "table"}) is (scene == "damped")


def test_stored_measurement_has_every_form(service):
    rows = service.answer("/tradeoff")["rows"]
    table = list(csv.DictReader(io.StringIO(service.get("/tradeoff", format="csv").text)))
    assert len(table) == len(rows)
    for text, row in zip(table, rows, strict=True):
        assert text["method"] == row["method"]
        assert float(text["error_max"]) == row["error_max"]
        assert (text["wrong_switches"] == "") is (row["wrong_switches"] is None)
        assert all(f"{k}={v}" in text["options"] for k, v in row["options"].items())
    with np.load(io.BytesIO(service.get("/tradeoff", format="npz").content)) as arrays:
        np.testing.assert_array_equal(arrays["error_max"], [row["error_max"] for row in rows])
        assert arrays["method"].tolist() == [row["method"] for row in rows]


def test_stored_measurement_is_cached_until_the_next_one(service, monkeypatch):
    tag = service.get("/tradeoff").headers["etag"]
    assert service.get("/tradeoff", headers={"If-None-Match": tag}).status_code == 304
    newer = {s: m | {"measured_at": "later"} for s, m in tradeoff.load_tradeoff().items()}
    monkeypatch.setattr("restitution.api.routes.tradeoff.load_tradeoff", lambda: newer)
    assert service.get("/tradeoff", headers={"If-None-Match": tag}).status_code == 200


def test_unknown_scenes_are_refused_with_the_known_ones(service):
    entry = service.wrong("/tradeoff", scene="figure5")["scene"]
    assert all(name in entry["requirement"] for name in SCENES)


@pytest.mark.parametrize(
    ("method", "path"),
    [("POST", "/tradeoff/runs"), ("GET", "/tradeoff/runs/1"), ("DELETE", "/tradeoff/runs/1")],
)
def test_measuring_anew_is_off_unless_enabled(service, method, path):
    response = service.client.request(method, f"/api/v1{path}")
    assert "RESTITUTION_TRADEOFF_RUNS" in service.problem(response, 403)["detail"]


@pytest.fixture
def measuring(service, monkeypatch):
    """A service that may measure, with few and small candidates and a short ladder of steps."""
    few = [c for c in every.candidates() if c.method in {"exact", "stiff"}]
    monkeypatch.setattr(tradeoff, "candidates", lambda **_: few)
    monkeypatch.setattr(steps, "LADDER", steps.LADDER[:4])
    monkeypatch.setattr(steps, "MOST_STEPS", 100)
    return type(service)(TestClient(create_app(Settings(tradeoff_runs=True))))


def ask(service, method, path, status):
    response = service.client.request(method, f"/api/v1{path}")
    assert response.status_code == status, response.text
    assert response.headers["cache-control"] == "no-store"
    return response.json()


def finished(service, run):
    seen = [0.0]

    def over():
        now = ask(service, "GET", f"/tradeoff/runs/{run['id']}", 200)
        seen.append(now["progress"])
        assert now["state"] != "running"
        return now

    found = eventually(over)
    assert seen == sorted(seen)
    assert seen[-1] <= 1.0
    return found


def test_a_run_measures_and_reports_its_progress(measuring):
    response = measuring.post({}, path="/tradeoff/runs", scene="solids")
    assert response.status_code == 202
    run = response.json()
    assert response.headers["location"] == f"runs/{run['id']}"
    assert run["result"] is None
    done = finished(measuring, run)
    assert done["state"] == "done"
    assert done["progress"] == 1.0
    assert done["result"]["scene"] == "solids"
    assert [row["method"] for row in done["result"]["rows"]] == ["exact", "stiff"]


def test_one_run_at_a_time_which_can_be_cancelled(measuring, monkeypatch):
    go, measure = threading.Event(), tradeoff.measure

    def held(*given):
        assert go.wait(LIMIT_SECONDS)
        return measure(*given)

    monkeypatch.setattr(tradeoff, "measure", held)
    run = ask(measuring, "POST", "/tradeoff/runs?scene=stiff", 202)
    problem = measuring.problem(measuring.post({}, path="/tradeoff/runs"), 409)
    assert "under way" in problem["detail"]
    ask(measuring, "DELETE", f"/tradeoff/runs/{run['id']}", 200)
    go.set()
    over = finished(measuring, run)
    assert over["state"] == "cancelled"
    assert over["result"] is None
    assert finished(measuring, ask(measuring, "POST", "/tradeoff/runs?scene=solids", 202))["result"]


def test_unknown_runs_are_404(measuring):
    for method in ("GET", "DELETE"):
        ask(measuring, method, "/tradeoff/runs/none", 404)


def test_run_of_an_unknown_scene_is_refused(measuring):
    problem = measuring.problem(measuring.post({}, path="/tradeoff/runs", scene="moon"), 422)
    assert problem["errors"][0]["parameter"] == "scene"


def test_a_run_that_fails_says_so(measuring, monkeypatch):
    def fail(**_):
        raise ValueError("for the test")

    monkeypatch.setattr(tradeoff, "candidates", fail)
    assert finished(measuring, ask(measuring, "POST", "/tradeoff/runs", 202))["state"] == "failed"
