"""Real bodies: one impact in SI units, materials worth a look."""

from dataclasses import asdict
from typing import Any

import numpy as np

from restitution.api.calls import Calls
from restitution.studies.collision.parameters import CONVENTION
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.materials import MATERIALS, Material
from restitution.studies.spheres.velocity_map import study_velocity_map
from restitution.wire import answers
from restitution.wire.arrays import refuse_more_points
from restitution.wire.bodies import ScalingBody, VelocityMapBody
from restitution.wire.formats import Payload, Result
from restitution.wire.queries import NoQuery
from restitution.wire.results import batch_payload, scaling_result

calls = Calls("real spheres")


def _item(material: Material) -> Payload:
    """Return a material without what it does not have."""
    return {name: value for name, value in asdict(material).items() if value is not None}


STEEL = _item(MATERIALS[0])
CONTACT: dict[str, Any] = {
    name: STEEL[name]
    for name in ("body_1", "body_2", "friction_coefficient", "tangential_stiffness_n_per_m")
}
VELOCITIES = {
    "normal_velocity_m_s": {"min": 1, "max": 200, "count": 20, "scale": "linear"},
    "tangential_velocity_m_s": {"min": 0, "max": 200, "count": 15, "scale": "linear"},
}


@calls.posted(
    "/scaling",
    ScalingBody,
    answers.Scaling,
    "A collision of real bodies",
    example=CONTACT | {"impact": STEEL["impact"]},
)
def scaling(body: ScalingBody) -> Result:
    """Return what comes out of a collision of real bodies, in SI units and scaled."""
    return scaling_result(study_scaling(body, body.impact))


@calls.posted(
    "/scaling/map",
    VelocityMapBody,
    answers.VelocityMap,
    "Real bodies over both velocities",
    example=CONTACT | VELOCITIES | {"quantities": ["epsilon_t", "coulomb"], "tolerance": 4e-3},
)
def velocity_map(body: VelocityMapBody) -> Result:
    """Return ε_t of real bodies over both velocities, as arrays [tangential][normal]."""
    refuse_more_points(*(axis.count for axis in body.axes))
    study = study_velocity_map(body, *body.axes, body.quantities, body.options)
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


@calls.stored("/materials", NoQuery, answers.Materials, "Real bodies")
def materials(_: NoQuery) -> Result:
    """Return real bodies worth a look, each a valid body of ``/scaling``."""
    return Result({"items": [*map(_item, MATERIALS)]}, dict)
