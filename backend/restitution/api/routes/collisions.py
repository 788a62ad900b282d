"""Collisions: one, its trace, along a cut, over a map, many at once."""

from typing import Any

import numpy as np

from restitution.api.calls import Calls
from restitution.studies.collision.cut import study_cut
from restitution.studies.collision.grid import study_grid
from restitution.studies.collision.many import LISTED, study_batch
from restitution.studies.collision.one import study_collision
from restitution.studies.collision.trace import study_trace
from restitution.wire import answers
from restitution.wire.arrays import MOST_ITEMS, refuse_more_points
from restitution.wire.bodies import CollisionsBody, read_collisions
from restitution.wire.formats import Payload, Result, flattened
from restitution.wire.queries import (
    CollisionQuery,
    CutQuery,
    MapQuery,
    TraceQuery,
)
from restitution.wire.results import batch_payload, collision_payload

calls = Calls("collisions")

ONE = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}

LARGEST_LIST = 40 * 2**20
"""Bytes of a million collisions."""

MOST_ELEMENTS = 4 * MOST_ITEMS + 100
"""Of four lists for each, and what else there is."""


@calls.computed(
    "/collision",
    CollisionQuery,
    answers.Collision,
    "One collision",
    example=ONE,
    quick=lambda query: query.is_quick,
)
def collision(query: CollisionQuery) -> Result:
    """Return what comes out of one collision and how it goes."""
    study = study_collision(query.parameters, query.options, query.wanted, query.episode_limit)
    payload = collision_payload(query, study)
    return Result(payload, lambda: {n: [v] for n, v in flattened(payload).items()})


@calls.computed(
    "/trace",
    TraceQuery,
    answers.Trace,
    "A collision over time",
    example=ONE,
    quick=lambda query: query.is_quick,
)
def trace(query: TraceQuery) -> Result:
    """Return forces, velocities and the spring over time."""
    study = study_trace(
        query.parameters, query.options, query.samples, query.wanted, query.episode_limit
    )
    payload = collision_payload(query, study.collision)
    payload |= {**study.columns, "switch_times": study.switch_times, **study.method_columns}
    return Result(payload, lambda: study.columns)


@calls.computed(
    "/cut",
    CutQuery,
    answers.Cut,
    "Collisions along one parameter",
    example={"along": "gt_over_gn", "kappa": 63, "mu_over_alpha": 1.4},
)
def cut(query: CutQuery) -> Result:
    """Return ε_t, switches or simple laws along one parameter."""
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
        **query.found(),
    }
    return Result(payload, lambda: {study.along: study.values, **study.batch.columns})


@calls.computed(
    "/map",
    MapQuery,
    answers.Map,
    "Collisions over two parameters",
    example={"mu_over_alpha": 1.4, "kappa_count": 20, "gt_over_gn_count": 15},
    limit=lambda query: refuse_more_points(*(axis.count for axis in query.axes)),
)
def map(query: MapQuery) -> Result:  # noqa: A001 - the name of the call
    """Return ε_t, switches or simple laws over κ and g_t/g_n, as arrays [g_t/g_n][κ]."""
    study = study_grid(*query.axes, query.mu_over_alpha, query.wanted, query.options)
    shape = study.gt_over_gn.size, study.kappa.size
    payload = {
        "kappa": study.kappa,
        "gt_over_gn": study.gt_over_gn,
        **batch_payload(study.batch, shape),
        **query.found(),
    }
    return Result(
        payload,
        lambda: {
            "kappa": np.tile(study.kappa, shape[0]),
            "gt_over_gn": np.repeat(study.gt_over_gn, shape[1]),
            **study.batch.columns,
        },
    )


MANY: dict[str, Any] = {"kappa": [18, 63], "mu_over_alpha": 1.4, "gt_over_gn": [0.4, 1.358]}


@calls.posted(
    "/collisions",
    CollisionsBody,
    answers.Collisions,
    "Up to a million collisions",
    example=MANY,
    largest=LARGEST_LIST,
    most_elements=MOST_ELEMENTS,
    read=read_collisions,
)
def collisions(body: CollisionsBody) -> Result:
    """Return ε_t and switches of many collisions, in the order of the parameters."""
    batch = study_batch(
        body.kappa,
        body.mu_over_alpha,
        body.gt_over_gn,
        body.quantities,
        body.options,
        body.dampings,
    )
    found = {}
    if body.normal_restitution is not None:
        found["damping"] = np.broadcast_to(batch.given["damping"], batch.method.shape)
    payload: Payload = {
        **{name: batch.columns[name] for name in LISTED if name in batch.columns},
        **found,
        "method": batch.method,
        "error_bound": batch.error_bound,
        "tolerance_met": batch.tolerance_met.tolist(),
    }
    return Result(payload, lambda: payload)
