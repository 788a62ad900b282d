"""Collisions: one, its trace, along a cut, over a map, many at once."""

from collections.abc import Iterable
from itertools import islice
from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Query, Request, Response
from pydantic import ValidationError

from restitution.api import answers
from restitution.api.arrays import (
    LARGEST_BODY,
    MOST_ITEMS,
    Allowed,
    number_array,
    parse_named,
    refuse_more_points,
)
from restitution.api.description import computed, posted
from restitution.api.errors import (
    MOST_ERRORS,
    UNKNOWN,
    RefusedParametersError,
    from_validation,
    refusal,
)
from restitution.api.fields import REQUIREMENTS
from restitution.api.forms import Payload, Result, flattened, respond, respond_to_body
from restitution.api.query import QueryRoute
from restitution.api.schemas import (
    CollisionQuery,
    CollisionsBody,
    CutQuery,
    Formed,
    FormQuery,
    MapQuery,
    TraceQuery,
)
from restitution.errors import CostError
from restitution.mechanics.viscoelastic import MOST_DAMPING
from restitution.studies.batch import LISTED, BatchStudy, study_batch
from restitution.studies.collision import CollisionStudy, study_collision
from restitution.studies.cut import study_cut
from restitution.studies.grid import study_grid
from restitution.studies.trace import study_trace

router = APIRouter(prefix="/api/v1", tags=["collisions"], route_class=QueryRoute)

ALLOWED: dict[str, Allowed] = {
    "kappa": lambda values: values > 0.0,
    "mu_over_alpha": lambda values: values >= 0.0,
    "gt_over_gn": lambda values: values >= 0.0,
    "damping": lambda values: (values >= 0.0) & (values <= MOST_DAMPING),
}
"""Parameter of ``POST /collisions`` that may be a list → which finite numbers it takes."""

SINGLE = CollisionsBody.model_fields.keys() - ALLOWED.keys()
"""Parameters of ``POST /collisions`` that may not."""


FORM = {"format", "encoding", "quantities", "episode_limit"}
"""Parameters of a query that are not the collision's."""

QUICK_SAMPLES = 2000
"""Of a trace: with all its columns three milliseconds, most of them for writing it."""


def _understood(query: Formed, **more: Any) -> Payload:
    """Return the parameters as understood."""
    names = type(query).model_fields
    return {name: getattr(query, name) for name in names if name not in FORM} | more


def _collision_payload(query: CollisionQuery, study: CollisionStudy) -> Payload:
    psi = query.parameters.psi
    parameters = _understood(query, psi=psi if np.isfinite(psi) else None)
    return vars(study) | {"parameters": parameters}


def batch_payload(batch: BatchStudy, shape: tuple[int, ...]) -> Payload:
    """Return the columns of a batch as arrays of `shape`, and what holds for all of them."""
    return {
        **{name: column.reshape(shape) for name, column in batch.columns.items()},
        "method": batch.one_method,
        "error_bound": float(batch.error_bound.max()),
        "tolerance_met": bool(batch.tolerance_met.all()),
    }


@router.get("/collision", summary="One collision", responses=computed(answers.Collision))
async def collision(request: Request, query: Annotated[CollisionQuery, Query()]) -> Response:
    """Return what comes out of one collision and how it goes."""

    def compute() -> Result:
        study = study_collision(query.parameters, query.options, query.wanted, query.episode_limit)
        payload = _collision_payload(query, study)
        return Result(payload, lambda: {n: [v] for n, v in flattened(payload).items()})

    return await respond(request, query, compute, quick=query.is_quick)


@router.get("/trace", summary="A collision over time", responses=computed(answers.Trace))
async def trace(request: Request, query: Annotated[TraceQuery, Query()]) -> Response:
    """Return forces, velocities and the spring over time."""

    def compute() -> Result:
        study = study_trace(
            query.parameters, query.options, query.samples, query.wanted, query.episode_limit
        )
        payload = _collision_payload(query, study.collision)
        payload |= {**study.columns, "switch_times": study.switch_times, **study.method_columns}
        return Result(payload, lambda: study.columns)

    quick = query.samples <= QUICK_SAMPLES and query.is_quick
    return await respond(request, query, compute, quick=quick)


@router.get("/cut", summary="Collisions along one parameter", responses=computed(answers.Cut))
async def cut(request: Request, query: Annotated[CutQuery, Query()]) -> Response:
    """Return ε_t, switches or simple laws along one parameter."""

    def compute() -> Result:
        study = study_cut(
            query.axis,
            query.mu_over_alpha,
            kappa=query.kappa,
            gt_over_gn=query.gt_over_gn,
            quantities=query.wanted,
            options=query.options,
        )
        payload = {
            "along": study.along,
            "values": study.values,
            **batch_payload(study.batch, study.values.shape),
        }
        return Result(payload, lambda: {study.along: study.values, **study.batch.columns})

    return await respond(request, query, compute)


@router.get(
    "/map",
    name="map",
    summary="Collisions over two parameters",
    responses=computed(answers.Map),
)
async def grid(request: Request, query: Annotated[MapQuery, Query()]) -> Response:
    """Return ε_t, switches or simple laws over κ and g_t/g_n, as arrays [g_t/g_n][κ]."""
    kappa, tangential = query.axes
    refuse_more_points(kappa.count, tangential.count)

    def compute() -> Result:
        study = study_grid(kappa, tangential, query.mu_over_alpha, query.wanted, query.options)
        shape = study.gt_over_gn.size, study.kappa.size
        payload = {
            "kappa": study.kappa,
            "gt_over_gn": study.gt_over_gn,
            **batch_payload(study.batch, shape),
        }
        return Result(
            payload,
            lambda: {
                "kappa": np.tile(study.kappa, shape[0]),
                "gt_over_gn": np.repeat(study.gt_over_gn, shape[1]),
                **study.batch.columns,
            },
        )

    return await respond(request, query, compute)


@router.post(
    "/collisions",
    summary="Up to a million collisions",
    responses=posted(answers.Collisions),
)
async def collisions(request: Request, form: Annotated[FormQuery, Query()]) -> Response:
    """Return ε_t and switches of many collisions, in the order of the parameters."""
    return await respond_to_body(request, form, LARGEST_BODY, _collide_many)


def _collide_many(text: bytes) -> Result:
    body = parse_named(text, (*ALLOWED, *SINGLE))
    _refuse_too_many(len(value) for value in body.values() if isinstance(value, list))
    arrays, errors = {}, []
    for name, allowed in ALLOWED.items():
        value = body.get(name, 0.0 if name == "damping" else None)
        arrays[name], wrong = number_array(name, value, REQUIREMENTS[name], allowed)
        errors += wrong
    unknown = (key for key in body if key not in ALLOWED and key not in SINGLE)
    errors += [refusal(key, body[key], UNKNOWN) for key in islice(unknown, MOST_ERRORS + 1)]
    try:
        options = CollisionsBody.model_validate({key: body[key] for key in SINGLE & body.keys()})
    except ValidationError as error:
        errors += from_validation(error.errors())
    lengths = {name: array.size for name, array in arrays.items() if array.ndim}
    if len(set(lengths.values())) > 1:
        errors += [
            refusal(name, f"{length} elements", "of one length with the other lists")
            for name, length in lengths.items()
        ]
    if errors:
        raise RefusedParametersError(errors)
    _refuse_too_many(lengths.values())
    batch = study_batch(
        arrays["kappa"],
        arrays["mu_over_alpha"],
        arrays["gt_over_gn"],
        options.quantities,
        options.options,
        arrays["damping"],
    )
    payload: Payload = {
        **{name: batch.columns[name] for name in LISTED if name in batch.columns},
        "method": batch.method,
        "error_bound": batch.error_bound,
        "tolerance_met": batch.tolerance_met.tolist(),
    }
    return Result(payload, lambda: payload)


def _refuse_too_many(lengths: Iterable[int]) -> None:
    if (count := max(lengths, default=1)) > MOST_ITEMS:
        raise CostError(
            f"{count:,} collisions in one request are more than {MOST_ITEMS:,}, the limit"
        )
