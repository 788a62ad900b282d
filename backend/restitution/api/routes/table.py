"""Tables of ε_t for other codes."""

from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query, Request, Response

from restitution.api.arrays import refuse_more_points
from restitution.api.description import exported
from restitution.api.forms import Payload, Result, respond
from restitution.api.schemas import TableQuery
from restitution.export.c_header import c_header
from restitution.export.python_module import python_module
from restitution.studies.table_export import RestitutionTable, study_table, study_table_within

MOST_SECONDS = 5.0
"""Of one core, for one request."""

router = APIRouter(prefix="/api/v1", tags=["table"])


def table_result(table: RestitutionTable) -> Result:
    """Return a table in all its forms."""
    kappas, psis = table.kappa.values(positive=True), table.psi.values(positive=False)

    def rows() -> Payload:
        return {
            "kappa": np.tile(kappas, psis.size),
            "psi": np.repeat(psis, kappas.size),
            "epsilon_t": table.epsilon_t.ravel(),
            "largest_error": np.full(table.epsilon_t.size, table.largest_error),
        }

    payload = {
        "kappa": kappas,
        "psi": psis,
        "epsilon_t": table.epsilon_t,
        "largest_error": table.largest_error,
        "kappa_scale": table.kappa.scale,
        "psi_scale": table.psi.scale,
        "sign": table.sign,
    }
    texts = {"c": lambda: c_header(table), "python": lambda: python_module(table)}
    return Result(payload, rows, texts=texts)


@router.get("/table", summary="A table", response_class=Response, responses=exported())
def table(request: Request, query: Annotated[TableQuery, Query()]) -> Response:
    """Return ε_t over κ and ψ for other codes: CSV, NPZ, a C header or a Python module."""
    kappa, psi = query.axes
    refuse_more_points(kappa.count, psi.count)

    def compute() -> Result:
        if query.error is None:
            found = study_table(kappa, psi, query.sign, seconds=MOST_SECONDS)
        else:
            found = study_table_within(query.error, kappa, psi, query.sign, seconds=MOST_SECONDS)
        return table_result(found)

    return respond(request, query, compute)
