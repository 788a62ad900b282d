"""Real bodies: one impact in SI units, materials worth a look."""

from dataclasses import asdict
from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query, Request, Response

from restitution.api import answers
from restitution.api.arrays import LARGEST_SMALL_BODY, parse_nested, refuse_more_points
from restitution.api.bodies import read_map, read_scaling
from restitution.api.description import posted, stored
from restitution.api.forms import Payload, Result, flattened, respond, respond_to_body
from restitution.api.query import QueryRoute
from restitution.api.routes.collisions import batch_payload
from restitution.api.schemas import FormQuery, NoQuery
from restitution.studies.materials import MATERIALS, Material
from restitution.studies.parameters import CONVENTION
from restitution.studies.spheres import ScalingStudy, study_scaling
from restitution.studies.velocity_map import study_velocity_map

router = APIRouter(prefix="/api/v1", tags=["real spheres"], route_class=QueryRoute)

AFTER = ("velocity_1_m_s", "velocity_2_m_s", "spin_1_rad_s", "spin_2_rad_s")


def scaling_payload(study: ScalingStudy) -> Payload:
    """Return a collision of real bodies as keys and values."""
    after = study.after
    return vars(study) | {"after": None if after is None else after._asdict()}


def _row(payload: Payload) -> Payload:
    """Return a payload without objects in lists: words of warnings, vectors by component."""
    row = payload | {"warnings": " ".join(caution.code for caution in payload["warnings"])}
    row["after"] = {
        f"{name}.{axis}": None if payload["after"] is None else payload["after"][name][i]
        for name in AFTER
        for i, axis in enumerate("xyz")
    }
    return flattened(row)


@router.post("/scaling", summary="A collision of real bodies", responses=posted(answers.Scaling))
async def scaling(request: Request, form: Annotated[FormQuery, Query()]) -> Response:
    """Return what comes out of a collision of real bodies, in SI units and scaled."""

    def compute(body: bytes) -> Result:
        payload = scaling_payload(study_scaling(*read_scaling(parse_nested(body))))
        return Result(
            payload,
            lambda: {name: [value] for name, value in _row(payload).items()},
            lambda: _row(payload),
        )

    return await respond_to_body(request, form, LARGEST_SMALL_BODY, compute)


@router.post(
    "/scaling/map",
    summary="Real bodies over both velocities",
    responses=posted(answers.VelocityMap),
)
async def velocity_map(request: Request, form: Annotated[FormQuery, Query()]) -> Response:
    """Return ε_t of real bodies over both velocities, as arrays [tangential][normal]."""

    def compute(body: bytes) -> Result:
        wanted = read_map(parse_nested(body))
        axes = wanted.normal_velocity, wanted.tangential_velocity
        refuse_more_points(axes[0].count, axes[1].count)
        study = study_velocity_map(wanted.contact, *axes, wanted.quantities, wanted.options)
        normal, tangential = study.normal_velocity_m_s, study.tangential_velocity_m_s
        payload = {
            "normal_velocity_m_s": normal,
            "tangential_velocity_m_s": tangential,
            "mu_over_alpha": study.mu_over_alpha,
            **study.scales,
            **batch_payload(study.batch, (tangential.size, normal.size)),
            "convention": CONVENTION,
        }
        return Result(
            payload,
            lambda: {
                "normal_velocity_m_s": np.tile(normal, tangential.size),
                "tangential_velocity_m_s": np.repeat(tangential, normal.size),
                **study.batch.columns,
            },
        )

    return await respond_to_body(request, form, LARGEST_SMALL_BODY, compute)


def _item(material: Material) -> Payload:
    """Return a material without what it does not have."""
    return {name: value for name, value in asdict(material).items() if value is not None}


@router.get("/materials", summary="Real bodies", responses=stored(answers.Materials))
async def materials(request: Request, query: Annotated[NoQuery, Query()]) -> Response:
    """Return real bodies worth a look, each a valid body of ``/scaling``."""

    def compute() -> Result:
        return Result({"items": [*map(_item, MATERIALS)]}, dict)

    return await respond(request, query, compute, quick=True)
