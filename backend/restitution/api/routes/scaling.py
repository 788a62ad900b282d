"""Real bodies: one impact in SI units, materials worth a look."""

from dataclasses import is_dataclass
from typing import Any

import numpy as np

from restitution.api.calls import Calls
from restitution.bounds import values
from restitution.studies.collision.parameters import CONVENTION
from restitution.studies.spheres.bounce import BounceStudy, study_bounce
from restitution.studies.spheres.codes import CodesStudy, study_codes
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.materials import MATERIALS, Material
from restitution.studies.spheres.velocity_map import study_velocity_map
from restitution.studies.spheres.walton import WaltonStudy, study_walton
from restitution.wire import answers
from restitution.wire.arrays import refuse_more_points
from restitution.wire.bodies import CodesBody, ScalingBody, VelocityMapBody
from restitution.wire.formats import Payload, Result
from restitution.wire.queries import BounceQuery, NoQuery, WaltonQuery
from restitution.wire.results import batch_payload, bounce_result, scaling_result

calls = Calls("real spheres")


def _as_body(contact: Contact) -> dict[str, Any]:
    """Return a contact as a body of `/scaling` says it, without what its bodies do not have."""
    return {
        name: _there(vars(value)) if is_dataclass(value) else value
        for name, value in _there(values(contact)).items()
    }


def _there(members: dict[str, Any]) -> dict[str, Any]:
    return {
        name: value for name, value in members.items() if value is not None and value is not False
    }


def _item(material: Material) -> Payload:
    """Return a material with the members of its contact among its own."""
    return _there(
        {"id": material.id, "title": material.title}
        | _as_body(material.contact)
        | {name: vars(material)[name] for name in ("impact", "source", "notes", "measured")}
    )


STEEL = MATERIALS["steel"]
CONTACT = _as_body(STEEL.contact)
del CONTACT["dissipative_constant_s"]
VELOCITIES = {
    "normal_velocity_m_s": {"min": 1, "max": 200, "count": 20, "scale": "linear"},
    "tangential_velocity_m_s": {"min": 0, "max": 200, "count": 15, "scale": "linear"},
}


@calls.posted(
    "/scaling",
    ScalingBody,
    answers.Scaling,
    "A collision of real bodies",
    example=CONTACT | {"impact": vars(STEEL.impact)},
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


@calls.posted(
    "/codes",
    CodesBody,
    CodesStudy,
    "Inputs of DEM codes",
    example={name: CONTACT[name] for name in ("body_1", "body_2")}
    | {"normal_velocity_m_s": 1, "kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358},
)
def codes(body: CodesBody) -> Result:
    """Return what LAMMPS, YADE and other codes take for a collision of bodies to be this one."""
    study = study_codes(body.body_1, body.body_2, body.normal_velocity_m_s, body.parameters)

    def table() -> Payload:
        rows = [
            {**vars(each), "lines": "\n".join(each.lines), "epsilon_t": _or_nan(each.epsilon_t)}
            for each in study.codes
        ]
        return {name: [row[name] for row in rows] for name in rows[0]}

    return Result(vars(study), table, table)


def _or_nan(value: float | None) -> float:
    return np.nan if value is None else value


@calls.computed(
    "/bounce",
    BounceQuery,
    BounceStudy,
    "A ball before and after it bounces",
    example={"kappa": 4.5, "mu_over_alpha": 1.4, "gt_over_gn": 1.1},
    quick=lambda query: query.is_quick,
)
def bounce(query: BounceQuery) -> Result:
    """Return how a ball comes, leaves, and leaves again when it has fallen back onto the wall.

    What leaves is linear in ε_t, by factors that depend on the bodies alone.
    """
    return bounce_result(
        study_bounce(
            query.parameters,
            alpha=query.alpha,
            partner=query.partner,
            spin_share=query.spin_share,
        )
    )


@calls.computed(
    "/walton",
    WaltonQuery,
    WaltonStudy,
    "From Walton's β₀ to κ",
    example={"beta_0": 0.4},
    quick=lambda _: True,
)
def walton(query: WaltonQuery) -> Result:
    """Return the smallest κ whose undamped collisions have a β₀, and the next larger ones."""
    study = study_walton(query.beta_0)
    kappas = [study.kappa, *study.others]
    return Result(vars(study), lambda: {"kappa": kappas, "beta_0": [study.beta_0] * len(kappas)})


@calls.stored("/materials", NoQuery, answers.Materials, "Real bodies")
def materials(_: NoQuery) -> Result:
    """Return real bodies worth a look, each a valid body of ``/scaling``."""
    return Result({"items": [*map(_item, MATERIALS.values())]}, dict)
