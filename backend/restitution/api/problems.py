"""Refusals: one table from error to status, one shape (RFC 9457) for all of them."""

import http
from typing import Any

import orjson
from fastapi import FastAPI, Request, Response
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect
from starlette.routing import Match

from restitution.api.admission import RETRY_AFTER, SaturatedError
from restitution.api.metrics import REFUSED
from restitution.errors import CostError, ParameterError
from restitution.interruption import InterruptionError
from restitution.wire.refusals import (
    MOST_ERRORS,
    MalformedBodyError,
    RefusedParametersError,
    as_received,
    refusal,
    sentences,
)

TITLES = {499: "Client Closed Request"}
"""Of statuses that no standard has."""


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


def refused(errors: list[dict[str, Any]]) -> Response:
    """Return the answer to wrong parameters."""
    return problem(422, "; ".join(sentences(errors)), errors[:MOST_ERRORS])


def _parameters(_: Request, error: Exception) -> Response:
    assert isinstance(error, RefusedParametersError)
    return refused(error.errors)


def _parameter(_: Request, error: Exception) -> Response:
    assert isinstance(error, ParameterError)
    return refused([refusal(error.parameter, error.value, error.requirement)])


def _malformed(_: Request, error: Exception) -> Response:
    return problem(400, str(error))


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
    MalformedBodyError: _malformed,
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
