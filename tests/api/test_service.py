"""Presets, health, readiness, and what a defect looks like from outside."""

import re
from concurrent.futures import ThreadPoolExecutor

import pytest
from starlette.testclient import TestClient

from restitution.api.app import create_app

FIELDS = {
    "id",
    "title",
    "kappa",
    "mu_over_alpha",
    "gt_over_gn",
    "damping",
    "alpha",
    "source",
    "link",
    "caption",
}


@pytest.fixture(scope="module")
def presets(service):
    return service.answer("/presets")["items"]


def test_presets_have_the_contracts_fields(presets):
    assert presets
    for preset in presets:
        assert preset.keys() >= FIELDS
        assert preset["title"]
        assert preset["source"]
        assert re.fullmatch(r"[a-z0-9-]+", preset["id"])
        assert 0 < preset["alpha"] <= 1


def test_presets_have_identifiers_of_their_own(presets):
    assert len({preset["id"] for preset in presets}) == len(presets)


def test_presets_are_collisions_that_can_be_asked_for(service, presets):
    for preset in presets:
        collision = {
            name: preset[name] for name in ("kappa", "mu_over_alpha", "gt_over_gn", "damping")
        }
        trace = service.answer("/trace", **collision)
        assert trace["method"] == "exact"
        assert trace["tolerance_met"] is True


def test_presets_of_figure_5_switch_as_the_paper_says(service, presets):
    # model.md §5: 0, 2, 4, 6, 8 (e), 6 (f), 8 (g), 6, 4, 6 (j), 4, 2, 4, 2 (o) in the order a … o
    found = [
        service.answer("/collision", **{n: p[n] for n in ("kappa", "mu_over_alpha", "gt_over_gn")})[
            "switches"
        ]
        for p in presets
        if re.fullmatch(r"figure-5-[a-o]", p["id"])
    ]
    assert found == [0, 2, 4, 6, 8, 6, 8, 6, 4, 6, 4, 2, 4, 2, 2]


def test_health_is_told_at_once():
    # without the lifespan nothing is compiled
    response = TestClient(create_app()).get("/healthz")
    assert response.status_code == 200


def test_readiness_waits_for_the_kernels(service):
    response = TestClient(create_app()).get("/readyz")
    service.problem(response, 503)
    assert int(response.headers["retry-after"]) > 0
    assert service.client.get("/readyz").status_code == 200


def test_defects_are_problems_without_their_inner_details(service):
    app = create_app()

    @app.get("/defect")
    def defect():
        raise RuntimeError("secret")

    client = TestClient(app, raise_server_exceptions=False)
    problem = service.problem(client.get("/defect"), 500)
    assert "secret" not in problem["detail"]


def test_openapi_names_every_call_and_parameter(service):
    description = service.client.get("/openapi.json").json()
    paths = description["paths"]
    assert {
        f"/api/v1{p}" for p in ("/collision", "/trace", "/cut", "/map", "/presets", "/collisions")
    } <= (paths.keys())
    names = {p.get("name") for p in paths["/api/v1/trace"]["get"]["parameters"]}
    assert names >= {
        "kappa",
        "mu_over_alpha",
        "gt_over_gn",
        "samples",
        "episode_limit",
        "quantities",
    }


def test_answers_are_the_same_when_many_ask_at_once(service):
    queries = [
        (path, {"mu_over_alpha": 1, **more})
        for gt_over_gn in (0.3, 0.9, 2.5)
        for path, more in (
            ("/collision", {"kappa": 2e6, "gt_over_gn": gt_over_gn}),
            ("/trace", {"kappa": 2000, "gt_over_gn": gt_over_gn}),
            ("/map", {"gt_over_gn_max": gt_over_gn}),
            ("/cut", {"along": "kappa", "gt_over_gn": gt_over_gn, "maximum": 1e4}),
        )
    ]
    alone = [service.answer(path, **query) for path, query in queries]
    with ThreadPoolExecutor(8) as pool:
        asked = [pool.submit(service.answer, path, **query) for path, query in 4 * queries]
        assert [future.result() for future in asked] == 4 * alone
