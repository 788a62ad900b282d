"""What the page and a supervisor ask: presets, health, readiness."""

from typing import Any

from fastapi import APIRouter, Request, Response

from restitution.api.calls import Calls
from restitution.api.document import refusals
from restitution.api.problems import problem
from restitution.studies.collision.presets import PRESETS
from restitution.wire import answers
from restitution.wire.formats import Result
from restitution.wire.queries import NoQuery

calls = Calls("presets")
health = APIRouter(tags=["service"])


@calls.stored("/presets", NoQuery, answers.Presets, "Collisions worth a look")
def presets(_: NoQuery) -> Result:
    """Return collisions worth a look."""
    return Result({"items": [*PRESETS.values()]}, dict)


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
