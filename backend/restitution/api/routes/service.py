"""What the page and a supervisor ask: presets, health, readiness."""

from typing import Annotated, Any

from fastapi import APIRouter, Query, Request, Response

from restitution.api import answers
from restitution.api.description import refusals, stored
from restitution.api.errors import problem
from restitution.api.forms import Result, respond
from restitution.api.query import QueryRoute
from restitution.api.schemas import NoQuery
from restitution.studies.presets import PRESETS

router = APIRouter(route_class=QueryRoute)
health = APIRouter(tags=["service"])


@router.get(
    "/api/v1/presets",
    tags=["presets"],
    summary="Collisions worth a look",
    responses=stored(answers.Presets),
)
async def presets(request: Request, query: Annotated[NoQuery, Query()]) -> Response:
    """Return collisions worth a look."""
    return await respond(request, query, lambda: Result({"items": list(PRESETS)}, dict), quick=True)


@health.get(
    "/healthz",
    name="health",
    summary="Alive?",
    responses={200: {"model": answers.Health}},
)
async def healthz() -> dict[str, str]:
    """Return that the process answers."""
    return {"status": "ok"}


@health.get(
    "/readyz",
    name="readiness",
    summary="Ready?",
    response_model=None,
    responses=refusals(503) | {200: {"model": answers.Readiness}},
)
async def readyz(request: Request) -> dict[str, Any] | Response:
    """Return that the kernels are compiled."""
    if request.app.state.ready.is_set():
        return {"status": "ready"}
    return problem(503, "the kernels are being compiled", None, **{"Retry-After": "5"})
