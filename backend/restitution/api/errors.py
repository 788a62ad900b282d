"""Refusals: one table from error to status, one shape (RFC 9457) for all of them."""

import http
import math
import reprlib
from typing import Any

import orjson
from fastapi import FastAPI, Request, Response
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect
from starlette.routing import Match

from restitution.api.admission import RETRY_AFTER, SaturatedError
from restitution.api.fields import REQUIREMENTS
from restitution.api.metrics import REFUSED
from restitution.errors import CostError, ParameterError
from restitution.interruption import InterruptionError

LONGEST_ECHO = 200
"""Characters of a refused value that are sent back."""

MOST_ERRORS = 100
"""Entries of a refusal; a refusal is for reading."""

TITLES = {499: "Client Closed Request"}
"""Of statuses that no standard has."""

UNKNOWN = "left out: this call has no such parameter"


class RefusedParametersError(Exception):
    """Several parameters are wrong at once; `errors` as in the answer."""

    def __init__(self, errors: list[dict[str, Any]]) -> None:
        super().__init__(f"{len(errors)} parameters")
        self.errors = errors


def as_received(value: object) -> object:
    """Return a refused value in a form that JSON can hold."""
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else ("Infinity" if value > 0 else "-Infinity")
    if isinstance(value, float) or (isinstance(value, int) and abs(value) < 2**53):
        return value
    text = value if isinstance(value, str) else _json_text(value)
    return text[:LONGEST_ECHO].encode("utf-8", "replace").decode()


def _json_text(value: object) -> str:
    """Return the JSON of a list or an object; Python's words for what JSON cannot hold."""
    try:
        return orjson.dumps(value).decode()
    except TypeError:
        # too deep, too large a number, or half a character
        return reprlib.repr(value)


def refusal(parameter: str, value: object, requirement: str) -> dict[str, Any]:
    """Return one entry of `errors`."""
    return {
        "parameter": as_received(parameter),
        "value": as_received(value),
        "requirement": requirement,
    }


def problem(
    status: int, detail: str, errors: list[dict[str, Any]] | None = None, **headers: str
) -> Response:
    """Return a refusal as ``application/problem+json``."""
    body: dict[str, Any] = {
        "type": "about:blank",
        "title": TITLES.get(status) or http.HTTPStatus(status).phrase,
        "status": status,
        "detail": detail,
    }
    if errors is not None:
        body["errors"] = errors
    return Response(
        orjson.dumps(body),
        status,
        {"Cache-Control": "no-store", **headers},
        "application/problem+json",
    )


def _sentence(parameter: str, value: object, requirement: str) -> str:
    if value is None:
        return f"{parameter} is missing; it must be {requirement}"
    return f"{parameter} must be {requirement}, got {value}"


def sentences(errors: list[dict[str, Any]]) -> list[str]:
    """Return a sentence for each of the first `MOST_ERRORS` wrong parameters."""
    first = [_sentence(**error) for error in errors[:MOST_ERRORS]]
    return [*first, "and more"] if len(errors) > MOST_ERRORS else first


def refused(errors: list[dict[str, Any]]) -> Response:
    """Return the answer to wrong parameters."""
    return problem(422, "; ".join(sentences(errors)), errors[:MOST_ERRORS])


def from_validation(found: list[Any]) -> list[dict[str, Any]]:
    """Return the entries for errors found by pydantic."""
    errors = []
    for error in found:
        where = [part for part in error["loc"] if part not in {"query", "body"}]
        name = str(where[0]) if where else ""
        element = len(where) > 1
        match error["type"]:
            case "extra_forbidden":
                requirement = UNKNOWN
            case "words":
                requirement = f"a comma-separated choice of {error['ctx']['allowed']}"
            case "word":
                requirement = f"one of {error['ctx']['allowed']}"
            case _:
                requirement = REQUIREMENTS.get(f"{name}[]" if element else name, error["msg"])
        value = None if error["type"] == "missing" else error["input"]
        errors.append(refusal(f"{name}[{where[1]}]" if element else name, value, requirement))
    return errors


def _parameters(_: Request, error: Exception) -> Response:
    assert isinstance(error, RefusedParametersError)
    return refused(error.errors)


def _parameter(_: Request, error: Exception) -> Response:
    assert isinstance(error, ParameterError)
    return refused([refusal(error.parameter, error.value, error.requirement)])


def _cost(_: Request, error: Exception) -> Response:
    REFUSED.labels("cost").inc()
    return problem(413, str(error))


def _saturated(_: Request, error: Exception) -> Response:
    return problem(503, f"{error}; ask again", None, **{"Retry-After": str(RETRY_AFTER)})


def _interrupted(_: Request, __: Exception) -> Response:
    """Return what nobody will read: the client has left."""
    return problem(499, "the client left before the answer")


def _http(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    headers = dict(error.headers or {})
    match error.status_code:
        case 404:
            detail = f"there is nothing at {as_received(request.url.path)}"
        case 405:
            headers = {"Allow": ", ".join(_allowed(request))}
            detail = f"{request.method} is not allowed here, but {headers['Allow']}"
        case _:
            detail = str(error.detail)
    return problem(error.status_code, detail, None, **headers)


def _allowed(request: Request) -> list[str]:
    """Return the methods of an address; Starlette tells those of its first route only."""
    routes = request.app.routes
    return [
        method
        for method in ("GET", "HEAD", "POST", "DELETE")
        if any(r.matches({**request.scope, "method": method})[0] is Match.FULL for r in routes)
    ]


def _defect(_: Request, __: Exception) -> Response:
    return problem(500, "a defect of this program; the log of the server has the details")


HANDLERS = {
    RefusedParametersError: _parameters,
    ParameterError: _parameter,
    CostError: _cost,
    SaturatedError: _saturated,
    InterruptionError: _interrupted,
    ClientDisconnect: _interrupted,
    HTTPException: _http,
    Exception: _defect,
}


def install(app: FastAPI) -> None:
    """Let `app` answer every error as a problem."""
    for error, handler in HANDLERS.items():
        app.add_exception_handler(error, handler)
