"""The OpenAPI document as tests use it: calls, their examples, and a strict judge of answers."""

import copy
import functools
import json
from collections.abc import Sequence
from typing import Any

import jsonschema_rs
import pytest

from restitution.api.app import create_app

DOCUMENT = create_app().openapi()
OPERATIONS = {
    operation["operationId"]: (method, path, operation)
    for path, operations in DOCUMENT["paths"].items()
    for method, operation in operations.items()
}
RUNS = {"start_run", "run", "cancel_run"}
"""Off unless enabled; tests/api/test_tradeoff.py switches them on."""

ALWAYS_ON = sorted(OPERATIONS.keys() - RUNS)

JSON = "application/json"
PROBLEM = "application/problem+json"


def resolved(part: Any) -> Any:
    """Return a part of the document, or what it refers to."""
    if "$ref" not in part:
        return part
    assert part.keys() <= {"$ref", "default"}
    found = DOCUMENT
    for name in part["$ref"].removeprefix("#/").split("/"):
        found = found[name]
    return found


def parameters_of(name: str) -> dict[str, Any]:
    """Return the parameters of the query of an operation by their names."""
    listed = map(resolved, OPERATIONS[name][2].get("parameters", []))
    return {p["name"]: p for p in listed if p["in"] == "query"}


def query_of(name: str) -> dict[str, Any]:
    """Return the query of the example of an operation."""
    return {n: p["example"] for n, p in parameters_of(name).items() if "example" in p}


def body_of(name: str) -> Any:
    """Return the body of the example of an operation, None if it has none."""
    body = OPERATIONS[name][2].get("requestBody")
    return body and copy.deepcopy(body["content"][JSON]["example"])


EVERY_SIXTH = pytest.mark.parametrize(
    "sixth", [0, *(pytest.param(n, marks=pytest.mark.verify) for n in range(1, 6))]
)
"""Each value at a sixth of the places, each place with a sixth of the values; the rest later."""


def sixth_of(values: Sequence[Any], place: int, sixth: int) -> Sequence[Any]:
    """Return every sixth of the values, another one from place to place."""
    return values[(place + sixth) % 6 :: 6]


def closed(schema: Any) -> Any:
    """Return `schema` with every object closed to keys that it does not name."""
    if isinstance(schema, list):
        return [closed(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    inner = {name: closed(value) for name, value in schema.items()}
    return {"additionalProperties": False} | inner if "properties" in schema else inner


@functools.cache
def _judge(schema: str) -> jsonschema_rs.Draft202012Validator:
    components = {"schemas": closed(DOCUMENT["components"]["schemas"])}
    return jsonschema_rs.Draft202012Validator(
        closed(json.loads(schema)) | {"components": components}
    )


def misfits(schema: Any, value: Any) -> list[str]:
    """Return what of a JSON value does not fit `schema`, beyond whose keys there may be none."""
    return [str(error) for error in _judge(json.dumps(schema)).iter_errors(value)]


def assert_described(name: str, response: Any) -> None:
    """Assert that a response is one that the document has for an operation."""
    responses = OPERATIONS[name][2]["responses"]
    told = f"{response.request.url} {response.status_code} {response.text[:300]}"
    assert str(response.status_code) in responses, told
    described = resolved(responses[str(response.status_code)])
    for header in described.get("headers", {}):
        assert header in response.headers, told
    if response.status_code == 304:
        assert response.content == b""
        return
    kind = response.headers["content-type"]
    assert kind in described["content"], told
    if kind in {JSON, PROBLEM}:
        # neither NaN nor a lone half of a character
        value = json.loads(response.content.decode(), parse_constant=_refuse)
        assert misfits(described["content"][kind]["schema"], value) == [], told


def _refuse(text: str) -> None:
    raise AssertionError(f"{text} is not JSON")
