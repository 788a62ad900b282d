"""Tables of ε_t for other codes."""

from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query, Request, Response

from restitution.api.arrays import refuse_more_points
from restitution.api.description import exported
from restitution.api.forms import Payload, Result, respond
from restitution.api.query import QueryRoute
from restitution.api.schemas import TableQuery
from restitution.export.c_header import c_header
from restitution.export.python_module import python_module
from restitution.studies.axis import Axis
from restitution.studies.table_export import RestitutionTable, study_table, study_table_within
from restitution.studies.table_grid import TableGrid

MOST_SECONDS = 5.0
"""Of one core, for one request."""

router = APIRouter(prefix="/api/v1", tags=["table"], route_class=QueryRoute)


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
        }

    payload = {
        "kappa": kappas,
        "psi": psis,
        "epsilon_t": table.epsilon_t,
        "largest_error": table.largest_error,
        "kappa_scale": table.kappa.scale,
        "psi_scale": table.psi.scale,
        "sign": table.sign,
        **third,
    }
    texts = {"c": lambda: c_header(table), "python": lambda: python_module(table)}
    return Result(payload, rows, texts=texts)


@router.get("/table", summary="A table", response_class=Response, responses=exported())
async def table(request: Request, query: Annotated[TableQuery, Query()]) -> Response:
    """Return ε_t over κ and ψ for other codes: CSV, NPZ, a C header or a Python module.

    `damping` holds for all entries, or is a third axis up to `damping_max`.
    """
    kappa, psi = query.axes
    third = query.third
    refuse_more_points(*reversed(TableGrid(kappa, psi, third).shape))

    def compute() -> Result:
        asked = kappa, psi, query.sign, third
        if query.error is None:
            found = study_table(*asked, seconds=MOST_SECONDS)
        else:
            found = study_table_within(query.error, *asked, seconds=MOST_SECONDS)
        return table_result(found)

    return await respond(request, query, compute)
