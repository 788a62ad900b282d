"""The OpenAPI document is whole, and says what the service does."""

import copy
import itertools
import re

import jsonschema_rs
import pytest
from fastapi.openapi.models import OpenAPI
from starlette.testclient import TestClient

from restitution.api.app import create_app

DOCUMENT = create_app().openapi()
OPERATIONS = {
    operation["operationId"]: (method, path, operation)
    for path, operations in DOCUMENT["paths"].items()
    for method, operation in operations.items()
}
RUNS = {"start_run", "run", "cancel_run"}
"""Off unless enabled; tests/api/test_tradeoff.py switches them on."""

every_example = pytest.mark.parametrize(
    ("method", "path", "operation"),
    [OPERATIONS[name] for name in sorted(OPERATIONS.keys() - RUNS)],
    ids=sorted(OPERATIONS.keys() - RUNS),
)
FORMS = [{"encoding": "base64"}, {"format": "csv"}, {"format": "npz"}]


def resolved(part):
    """Return a part of the document, or what it refers to."""
    if "$ref" not in part:
        return part
    assert part.keys() == {"$ref"}
    found = DOCUMENT
    for name in part["$ref"].removeprefix("#/").split("/"):
        found = found[name]
    return found


def parameters_of(operation):
    return [resolved(parameter) for parameter in operation.get("parameters", [])]


def closed(schema):
    """Return `schema` with every object closed to keys that it does not name."""
    if isinstance(schema, list):
        return [closed(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    inner = {name: closed(value) for name, value in schema.items()}
    return {"additionalProperties": False} | inner if "properties" in schema else inner


COMPONENTS = closed(copy.deepcopy(DOCUMENT["components"]["schemas"]))


def fits(schema, value):
    """Return what of a JSON value does not fit `schema`, which lists every key."""
    whole = closed(schema) | {"components": {"schemas": COMPONENTS}}
    return [str(error) for error in jsonschema_rs.Draft202012Validator(whole).iter_errors(value)]


def example_of(client, method, path, operation, **more):
    query = {p["name"]: p["example"] for p in parameters_of(operation) if "example" in p}
    body = operation.get("requestBody")
    content = body and body["content"]["application/json"]["example"]
    return client.request(method, path, params=query | more or None, json=content)


def test_document_is_one_of_openapi():
    OpenAPI.model_validate(DOCUMENT)
    assert DOCUMENT["openapi"].startswith("3.1")
    assert DOCUMENT["info"]["license"]["identifier"] == "MIT"
    assert DOCUMENT["servers"]


@pytest.mark.parametrize(
    "reference", sorted(set(re.findall(r"'\$ref': '([^']+)'", str(DOCUMENT)))), ids=str
)
def test_references_lead_somewhere(reference):
    assert resolved({"$ref": reference})


def test_nothing_is_described_that_nothing_refers_to():
    for kind, parts in DOCUMENT["components"].items():
        for name in parts:
            assert f"'#/components/{kind}/{name}'" in str(DOCUMENT), (kind, name)


@pytest.mark.parametrize(
    "operation", [operation for _, _, operation in OPERATIONS.values()], ids=OPERATIONS
)
def test_operations_say_what_they_do(operation):
    assert re.fullmatch(r"[a-z_]+", operation["operationId"])
    assert operation["summary"]
    assert operation["description"].endswith(".")
    assert set(operation["tags"]) <= {tag["name"] for tag in DOCUMENT["tags"]}
    for parameter in parameters_of(operation):
        assert parameter["description"], parameter["name"]
        assert parameter["schema"].keys() & {"type", "enum"}, parameter["name"]
    for status, given in operation["responses"].items():
        response = resolved(given)
        assert response["description"], status
        if status == "304":
            assert "content" not in response
        elif int(status) >= 400:
            assert response["content"].keys() == {"application/problem+json"}
            assert "Cache-Control" in response["headers"]
        else:
            assert response["content"]


@pytest.mark.parametrize("bound", ["ge", "gt", "le", "lt", "multiple_of"])
def test_bounds_are_those_of_json_schema(bound):
    # pydantic leaves its own words where a validator stands between a number and its bounds
    assert f"'{bound}':" not in str(DOCUMENT)


@every_example
def test_examples_are_answered_as_described(service, method, path, operation):
    response = example_of(service.client, method, path, operation)
    assert response.status_code == 200, response.text
    described = operation["responses"]["200"]
    kind = response.headers["content-type"]
    assert kind in described["content"]
    for name in described.get("headers", {}):
        assert name in response.headers
    if kind == "application/json":
        assert fits(described["content"][kind]["schema"], response.json()) == []


def takes(operation, form):
    allowed = {p["name"]: p["schema"].get("enum", ()) for p in parameters_of(operation)}
    return all(value in allowed.get(name, ()) for name, value in form.items())


@pytest.mark.parametrize(
    ("name", "form"),
    [(n, f) for n in sorted(OPERATIONS.keys() - RUNS) for f in FORMS if takes(OPERATIONS[n][2], f)],
    ids=str,
)
def test_every_form_is_described(service, name, form):
    method, path, operation = OPERATIONS[name]
    response = example_of(service.client, method, path, operation, **form)
    assert response.status_code == 200
    kind = response.headers["content-type"]
    described = operation["responses"]["200"]["content"]
    assert kind in described
    if kind == "application/json":
        assert fits(described[kind]["schema"], response.json()) == []


@pytest.mark.parametrize("form", ["c", "python"])
def test_code_is_described_as_text(service, form):
    response = service.get("/table", format=form, kappa_count=4, psi_count=3)
    described = OPERATIONS["table"][2]["responses"]["200"]["content"]
    assert response.headers["content-type"] in described


EXTREMES = [
    *itertools.product(
        (5e-324, 1e-3, 63.0, 1e12, 1e308),
        (0.0, 5e-324, 1.4, 1e308),
        (0.0, 5e-324, 1.358, 1e308),
        ("auto", "stiff", "timestep"),
    )
]


@pytest.mark.parametrize(("kappa", "mu_over_alpha", "gt_over_gn", "method"), EXTREMES)
def test_what_may_be_null_is_described_so(service, kappa, mu_over_alpha, gt_over_gn, method):
    query = {"kappa": kappa, "mu_over_alpha": mu_over_alpha, "gt_over_gn": gt_over_gn}
    everything = "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote,error"
    cut = {"along": "kappa", "minimum": kappa / 2, "maximum": kappa, "quantities": everything}
    asked = {
        "collision": query | {"method": method},
        "trace": query | {"method": method, "samples": 9},
        "cut": {n: query[n] for n in ("mu_over_alpha", "gt_over_gn")} | cut | {"count": 3},
    }
    for name, parameters in asked.items():
        _, path, operation = OPERATIONS[name]
        response = service.client.get(path, params=parameters)
        assert str(response.status_code) in operation["responses"]
        if response.status_code == 200:
            schema = operation["responses"]["200"]["content"]["application/json"]["schema"]
            assert fits(schema, response.json()) == [], name


def test_wrong_answers_do_not_fit():
    # the judge of the tests above can say no
    schema = {"$ref": "#/components/schemas/Presets"}
    assert fits(schema, {"items": []}) == []
    assert fits(schema, {"items": [], "more": 1})
    assert fits(schema, {"items": [{"id": 1}]})
    assert fits(schema, {})


@pytest.mark.parametrize("path", DOCUMENT["paths"])
def test_other_methods_are_405_with_those_that_there_are(path):
    client = TestClient(create_app())
    response = client.patch(path.replace("{name}", "1"))
    assert response.status_code == 405
    assert response.headers["content-type"] == "application/problem+json"
    allowed = {method.lower() for method in response.headers["allow"].split(", ")}
    assert allowed - {"head", "options"} == DOCUMENT["paths"][path].keys()
