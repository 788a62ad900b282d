"""Speed against accuracy: the stored measurement, measuring anew, the steps that an error takes."""

from dataclasses import asdict, fields
from typing import Annotated, Any

import numpy as np
import orjson
from fastapi import Path, Request, Response
from starlette.exceptions import HTTPException

from restitution.api import document
from restitution.api.calls import PROGRAM_VERSION, Calls, parameters, respond
from restitution.api.runs import Run, Runs
from restitution.studies.accuracy.steps import MOST_STEPS, RULE, Spread, study_steps
from restitution.studies.accuracy.tradeoff import load_tradeoff
from restitution.wire import answers
from restitution.wire.formats import Payload, Result
from restitution.wire.queries import NoQuery, SceneQuery, StepsQuery, TradeoffQuery, as_understood

SPREAD = tuple(part.name for part in fields(Spread))

RunName = Annotated[str, Path(description="`id` of a measurement")]

calls = Calls("tradeoff")


def _columns(rows: list[dict[str, Any]]) -> Payload:
    """Return rows as arrays (N,), what does not exist as NaN, options as words."""
    columns: Payload = {}
    for name in rows[0]:
        values = [row[name] for row in rows]
        if name == "options":
            values = [" ".join(f"{knob}={v}" for knob, v in value.items()) for value in values]
        columns[name] = np.array([np.nan if value is None else value for value in values])
    return columns


@calls.get(
    "/tradeoff",
    summary="The stored measurement",
    response_class=Response,
    responses=document.stored(TradeoffQuery, answers.Tradeoff),
    openapi_extra=document.asked(TradeoffQuery, {"scene": "figure4"}),
)
async def tradeoff(request: Request) -> Response:
    """Return what every method costs and how far it is off on the collisions of a scene."""
    query = parameters(request, TradeoffQuery)
    can_run = request.app.state.runs is not None
    stored = {**load_tradeoff()[query.scene], "can_be_measured_anew": can_run}

    def compute() -> Result:
        columns = _columns(stored["rows"])
        whole = {name: value for name, value in stored.items() if not isinstance(value, list)}
        return Result(stored, lambda: columns, lambda: whole | columns)

    version = f"{PROGRAM_VERSION} {stored['measured_at']} {can_run}"
    return await respond(request, query, compute, version, quick=True)


@calls.computed(
    "/steps",
    StepsQuery,
    answers.Steps,
    "Steps per contact",
    example={"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358},
)
def steps(query: StepsQuery) -> Result:
    """Return how many time steps per contact a wanted error takes, by each integrator."""
    where = query.parameters
    study = study_steps(query.error, where or query.region or "figure4")
    psi = where.psi if where else np.inf
    fewest, most = study.rule_steps
    too_many = f"not tried beyond {MOST_STEPS:,} steps" if most > MOST_STEPS else None
    names, rungs, spreads = zip(*study.ladder, strict=True)
    ladder = {
        "integrator": np.array(names),
        "steps": np.array(rungs, np.int32),
        **{part: np.array([vars(spread)[part] for spread in spreads]) for part in SPREAD},
    }
    payload = {
        "parameters": as_understood(query)
        | {
            "damping": where.damping if where else None,
            "psi": psi if np.isfinite(psi) else None,
        },
        "collisions": study.collisions,
        "phases": study.phases,
        "stability_limit": study.stability_limit,
        "needed": {name: asdict(needed) for name, needed in study.needed.items()},
        "rule": {"factor": RULE, "steps_min": fewest, "steps_max": most, "reason": too_many}
        | {name: asdict(spread) for name, spread in study.rule.items()},
        **ladder,
    }
    return Result(payload, lambda: ladder)


def _runs(request: Request) -> Runs:
    runs: Runs | None = request.app.state.runs
    if runs is None:
        raise HTTPException(
            403, "measuring anew is switched off here; RESTITUTION_TRADEOFF_RUNS=true allows it"
        )
    return runs


def _run(request: Request, name: str) -> Run:
    run = _runs(request).last
    if run is None or run.id != name:
        raise HTTPException(404)
    return run


def _described(run: Run, status: int = 200) -> Response:
    body = {
        "id": run.id,
        "scene": run.scene,
        "state": run.state,
        "progress": run.progress,
        "result": asdict(run.result) if run.result else None,
    }
    headers = {"Cache-Control": "no-store"}
    if status == 202:
        # relative to the address that was posted to, for the client may know that by another path
        headers["Location"] = f"runs/{run.id}"
    return Response(orjson.dumps(body), status, headers, "application/json")


@calls.post(
    "/tradeoff/runs",
    name="start_run",
    summary="Measure anew",
    status_code=202,
    response_class=Response,
    responses=document.told(answers.Run, 202) | document.refusals(403, 409, 422),
    openapi_extra=document.asked(SceneQuery),
)
async def start(request: Request) -> Response:
    """Measure a scene anew, in the background."""
    query = parameters(request, SceneQuery)
    run = _runs(request).start(query.scene)
    if run is None:
        raise HTTPException(409, "a measurement is under way; wait for it or cancel it")
    return _described(run, 202)


@calls.get(
    "/tradeoff/runs/{name}",
    name="run",
    summary="Progress and result",
    response_class=Response,
    responses=document.told(answers.Run) | document.refusals(403, 404, 422),
)
async def progress(request: Request, name: RunName) -> Response:
    """Return how far a measurement is, and its result when it is done."""
    parameters(request, NoQuery)
    return _described(_run(request, name))


@calls.delete(
    "/tradeoff/runs/{name}",
    name="cancel_run",
    summary="Cancel",
    response_class=Response,
    responses=document.told(answers.Run) | document.refusals(403, 404, 422),
)
async def cancel(request: Request, name: RunName) -> Response:
    """Cancel a measurement; it stops after the row that it is at."""
    parameters(request, NoQuery)
    run = _run(request, name)
    run.cancel()
    return _described(run)
