"""The paper, statement by statement."""

from dataclasses import fields
from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from restitution.api import answers
from restitution.api.description import computed
from restitution.api.forms import Payload, Result, respond
from restitution.api.query import QueryRoute
from restitution.api.schemas import FormQuery
from restitution.studies.paper import Item, study_paper

router = APIRouter(prefix="/api/v1", tags=["paper"], route_class=QueryRoute)


@router.get("/paper", summary="The paper, checked", responses=computed(answers.Paper))
async def paper(request: Request, query: Annotated[FormQuery, Query()]) -> Response:
    """Return what is printed, what is computed now, and a verdict, for each statement."""

    def compute() -> Result:
        items = study_paper()

        def table() -> Payload:
            names = [field.name for field in fields(Item)]
            return {name: [getattr(item, name) for item in items] for name in names}

        return Result({"items": list(items)}, table, table)

    # computed once, in about a second
    return await respond(request, query, compute, quick=study_paper.cache_info().currsize > 0)
