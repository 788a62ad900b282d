"""What studies found, as answers: keys and values, rows, texts."""

import numpy as np

from restitution.bounds import annotations
from restitution.export.c_header import c_header
from restitution.export.layout import SIGNS
from restitution.export.python_module import python_module
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import BatchStudy
from restitution.studies.collision.one import CollisionStudy
from restitution.studies.spheres.bounce import BallMotion, BounceStudy
from restitution.studies.spheres.collision import ScalingStudy
from restitution.studies.spheres.impact import After
from restitution.studies.tables.export import RestitutionTable
from restitution.wire.formats import Payload, Result, flattened
from restitution.wire.queries import CollisionQuery, as_understood


def collision_payload(query: CollisionQuery, study: CollisionStudy) -> Payload:
    """Return a collision with its parameters as understood."""
    psi = query.parameters.psi
    parameters = as_understood(query, psi=psi if np.isfinite(psi) else None)
    return vars(study) | {"parameters": parameters}


def batch_payload(batch: BatchStudy, shape: tuple[int, ...]) -> Payload:
    """Return the columns of a batch as arrays of `shape`, and what holds for all of them."""
    return {
        **{name: column.reshape(shape) for name, column in batch.columns.items()},
        "method": batch.one_method,
        "error_bound": float(batch.error_bound.max()),
        "tolerance_met": bool(batch.tolerance_met.all()),
    }


def scaling_result(study: ScalingStudy) -> Result:
    """Return a collision of real bodies in all its forms."""
    after = study.after
    payload = vars(study) | {"after": None if after is None else after._asdict()}
    return Result(
        payload,
        lambda: {name: [value] for name, value in _row(payload).items()},
        lambda: _row(payload),
    )


def _row(payload: Payload) -> Payload:
    """Return a payload without objects in lists: words of warnings, vectors by component."""
    row = payload | {"warnings": " ".join(caution.code for caution in payload["warnings"])}
    row["after"] = {
        f"{name}.{axis}": None if payload["after"] is None else payload["after"][name][i]
        for name in After._fields
        for i, axis in enumerate("xyz")
    }
    return flattened(row)


def bounce_result(study: BounceStudy) -> Result:
    """Return a ball that bounces: its collisions and factors, and its motions as rows."""
    payload = vars(study)
    rows = {
        "bounces": list(range(len(study.motions))),
        **{
            name: [getattr(motion, name) for motion in study.motions]
            for name in annotations(BallMotion)
        },
    }
    others = {name: value for name, value in payload.items() if name != "motions"}
    return Result(payload, lambda: rows, lambda: others | rows, convention=study.convention)


def table_result(table: RestitutionTable) -> Result:
    """Return a table in all its forms."""
    etas, psis, kappas = table.nodes().values
    entries = table.epsilon_t.ravel()
    third: Payload = {}
    if isinstance(table.damping, Axis):
        third = {"damping": etas, "damping_scale": table.damping.scale}
    elif table.damped:
        third = {"damping": table.damping}

    def rows() -> Payload:
        eta, psi, kappa = np.meshgrid(etas, psis, kappas, indexing="ij")
        return {
            "kappa": kappa.ravel(),
            "psi": psi.ravel(),
            **({"damping": eta.ravel()} if third else {}),
            "epsilon_t": entries,
            "largest_error": np.full(entries.size, table.largest_error),
            "error_basis": np.full(entries.size, table.error_basis),
        }

    payload = {
        "kappa": kappas,
        "psi": psis,
        "epsilon_t": table.epsilon_t,
        "largest_error": table.largest_error,
        "error_basis": table.error_basis,
        "kappa_scale": table.kappa.scale,
        "psi_scale": table.psi.scale,
        "sign": table.sign,
        **third,
    }
    texts = {"c": lambda: c_header(table), "python": lambda: python_module(table)}
    return Result(payload, rows, texts=texts, convention=f"epsilon_t = {SIGNS[table.sign]}")
