"""The OpenAPI document is whole, and says what the service does."""

import itertools
import re

import pytest
from document import (
    ALWAYS_ON,
    DOCUMENT,
    OPERATIONS,
    PROBLEM,
    assert_described,
    body_of,
    misfits,
    parameters_of,
    query_of,
    resolved,
)
from fastapi.openapi.models import OpenAPI
from starlette.testclient import TestClient

from cases import every_day
from restitution.api.app import create_app

pytestmark = pytest.mark.usefixtures("few_steps")

every_example = pytest.mark.parametrize("name", ALWAYS_ON)
FORMS = [{"encoding": "base64"}, {"format": "csv"}, {"format": "npz"}]


def ask_example(client, name, **more):
    method, path, _ = OPERATIONS[name]
    return client.request(method, path, params=query_of(name) | more or None, json=body_of(name))


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


def test_descriptions_are_not_about_python():
    assert not re.search(r">>>|(Raises|Examples)\\n---", str(DOCUMENT))


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
    for parameter in map(resolved, operation.get("parameters", [])):
        assert parameter["description"], parameter["name"]
        assert resolved(parameter["schema"]).keys() & {"type", "enum"}, parameter["name"]
    for status, given in operation["responses"].items():
        response = resolved(given)
        assert response["description"], status
        if status == "304":
            assert "content" not in response
        elif int(status) >= 400:
            assert response["content"].keys() == {PROBLEM}
            assert "Cache-Control" in response["headers"]
        else:
            assert response["content"]


@pytest.mark.parametrize("bound", ["ge", "gt", "le", "lt", "multiple_of"])
def test_bounds_are_those_of_json_schema(bound):
    # pydantic leaves its own words where a validator stands between a number and its bounds
    assert f"'{bound}':" not in str(DOCUMENT)


@every_example
def test_examples_are_answered_as_described(service, name):
    response = ask_example(service.client, name)
    assert response.status_code == 200, response.text
    assert_described(name, response)


def takes(name, form):
    allowed = {n: resolved(p["schema"]).get("enum", ()) for n, p in parameters_of(name).items()}
    return all(value in allowed.get(n, ()) for n, value in form.items())


@pytest.mark.parametrize(
    ("name", "form"), [(n, f) for n in ALWAYS_ON for f in FORMS if takes(n, f)], ids=str
)
def test_every_form_is_described(service, name, form):
    response = ask_example(service.client, name, **form)
    assert response.status_code == 200
    assert_described(name, response)


@every_example
def test_what_the_client_has_is_described(service, name):
    method, path, operation = OPERATIONS[name]
    first = ask_example(service.client, name)
    known = {"If-None-Match": first.headers.get("etag", "*")}
    again = service.client.request(
        method, path, params=query_of(name) or None, json=body_of(name), headers=known
    )
    assert (again.status_code == 304) is ("304" in operation["responses"])
    assert_described(name, again)


@pytest.mark.parametrize("form", ["c", "python"])
def test_code_is_described_as_text(service, form):
    response = service.get("/table", format=form, kappa_count=4, psi_count=3)
    assert response.headers["content-type"] == "text/plain; charset=utf-8"
    assert_described("table", response)


EXTREMES = list(
    itertools.product(
        (5e-324, 1e-3, 63.0, 1e12, 1e308),
        (0.0, 5e-324, 1.4, 1e308),
        (0.0, 5e-324, 1.358, 1e308),
        ("auto", "stiff", "timestep"),
    )
)


# a fifth of them, with each value of each
@pytest.mark.parametrize(
    ("kappa", "mu_over_alpha", "gt_over_gn", "method"), every_day(EXTREMES[::5], of=EXTREMES)
)
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
        assert_described(name, service.client.get(OPERATIONS[name][1], params=parameters))


def test_wrong_answers_do_not_fit():
    # the judge of the tests above can say no
    schema = {"$ref": "#/components/schemas/Presets"}
    assert misfits(schema, {"items": []}) == []
    assert misfits(schema, {"items": [], "more": 1})
    assert misfits(schema, {"items": [{"id": 1}]})
    assert misfits(schema, {})


@pytest.mark.parametrize("path", DOCUMENT["paths"])
def test_other_methods_are_405_with_those_that_there_are(path):
    client = TestClient(create_app())
    response = client.patch(path.replace("{name}", "1"))
    assert response.status_code == 405
    assert response.headers["content-type"] == "application/problem+json"
    allowed = {method.lower() for method in response.headers["allow"].split(", ")}
    assert allowed - {"head", "options"} == DOCUMENT["paths"][path].keys()
