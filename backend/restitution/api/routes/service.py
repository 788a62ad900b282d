"""What the page and a supervisor ask: presets, health, readiness."""

from typing import Annotated, Any

from fastapi import APIRouter, Query, Request, Response

from restitution.api.errors import problem
from restitution.api.forms import Result, respond
from restitution.api.query import QueryRoute
from restitution.api.schemas import NoQuery
from restitution.studies.presets import PRESETS, Preset

router = APIRouter(route_class=QueryRoute)
health = APIRouter(tags=["service"])


@router.get("/api/v1/presets", tags=["presets"], response_model=dict[str, list[Preset]])
async def presets(request: Request, query: Annotated[NoQuery, Query()]) -> Response:
    """Return collisions worth a look."""
    return await respond(request, query, lambda: Result({"items": list(PRESETS)}, dict), quick=True)


@health.get("/healthz")
async def healthz() -> dict[str, str]:
    """Return that the process answers."""
    return {"status": "ok"}


@health.get("/readyz", response_model=None)
async def readyz(request: Request) -> dict[str, Any] | Response:
    """Return that the kernels are compiled."""
    if request.app.state.ready.is_set():
        return {"status": "ready"}
    return problem(503, "the kernels are being compiled", None, **{"Retry-After": "5"})
