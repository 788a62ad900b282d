"""The service under test, and a strict reading of what it answers."""

import json
from typing import Any

from starlette.testclient import TestClient

from restitution.methods import planner
from restitution.wire.queries import QUICK_ROWS
from work import counted

PREFIX = "/api/v1"


def refuse_constant(text: str) -> None:
    raise AssertionError(f"{text} is not JSON")


def without_repetition(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    names = [name for name, _ in pairs]
    assert len(set(names)) == len(names), f"repeated keys in {names}"
    return dict(pairs)


def strict_json(text: str) -> Any:
    """Return the value of a JSON text that has neither NaN nor Infinity nor a repeated key."""
    return json.loads(text, parse_constant=refuse_constant, object_pairs_hook=without_repetition)


class Service:
    """Calls by their names in the contract: ``service.answer("/collision", kappa=18, …)``."""

    def __init__(self, client: TestClient) -> None:
        self.client = client

    def get(self, path: str, headers: dict[str, str] | None = None, **parameters: Any) -> Any:
        query = {name: str(value) for name, value in parameters.items()} or None
        return self.client.get(PREFIX + path, params=query, headers=headers)

    def post(
        self, body: Any, kind: str | None = "application/json", path: str = "/collisions", **query
    ) -> Any:
        content = body if isinstance(body, bytes) else json.dumps(body).encode()
        headers = {} if kind is None else {"Content-Type": kind}
        return self.client.post(
            PREFIX + path, content=content, headers=headers, params=query or None
        )

    def read(self, response: Any) -> Any:
        assert response.status_code == 200, response.text
        assert response.headers["content-type"] == "application/json"
        return strict_json(response.text)

    def answer(self, path: str, **parameters: Any) -> Any:
        return self.read(self.get(path, **parameters))

    def collisions(self, body: Any, **query: Any) -> Any:
        return self.read(self.post(body, **query))

    def problem(self, response: Any, status: int) -> Any:
        """Return the body of a refusal, having checked the shape that every refusal has."""
        assert response.status_code == status, response.text
        assert response.headers["content-type"] == "application/problem+json"
        assert response.headers["cache-control"] == "no-store"
        assert "etag" not in response.headers
        body = strict_json(response.text)
        assert {"type", "title", "status", "detail"} <= body.keys()
        assert body["status"] == status
        assert all(isinstance(body[key], str) and body[key] for key in ("type", "title", "detail"))
        for entry in body.get("errors", []):
            assert entry.keys() >= {"parameter", "value", "requirement"}
            assert isinstance(entry["requirement"], str)
            assert entry["requirement"] not in {"", "as documented"}, "says nothing"
        return body

    def refused(self, path: str, status: int = 422, **parameters: Any) -> Any:
        return self.problem(self.get(path, **parameters), status)

    def wrong(self, path: str, **parameters: Any) -> dict[str, Any]:
        """Return parameter → entry of `errors` of a 422."""
        errors = self.refused(path, **parameters)["errors"]
        assert errors
        return {entry["parameter"]: entry for entry in errors}

    def wrong_body(self, body: Any, **query: Any) -> dict[str, Any]:
        errors = self.problem(self.post(body, **query), 422)["errors"]
        assert errors
        return {entry["parameter"]: entry for entry in errors}

    def affordable(self, ask: Any, *, tries: bool = False) -> Any:
        """Return the response of `ask()`, whose work was within the budget of its line.

        What is wrong is refused before any work, what is too costly after hardly any; but for the
        general solver, which is stopped on its way, and where it is said that there are `tries`.
        """
        with counted() as work:
            response = ask()
        work.assert_affordable()
        if work["quick"]:
            # rows of nine numbers with their names
            assert len(response.content) <= 250 * QUICK_ROWS, response.url
        if response.status_code == 413:
            assert tries or work.seconds <= planner.QUICK_SECONDS, work
        elif response.status_code >= 400:
            assert work.of_numbers == 0, f"{response.status_code} after {work}"
        return response
