"""The paper, statement by statement."""

from dataclasses import fields

from restitution.api.calls import Calls
from restitution.paper import DEFINITIONS, Item, distinct_corrections, study_paper
from restitution.wire import answers
from restitution.wire.formats import Payload, Result
from restitution.wire.queries import FormQuery

calls = Calls("paper")


@calls.computed(
    "/paper",
    FormQuery,
    answers.Paper,
    "The paper, checked",
    # computed once, in about a second
    quick=lambda _: study_paper.cache_info().currsize > 0,
)
def paper(_: FormQuery) -> Result:
    """Return what is printed, what is computed now, and a verdict, for each statement."""
    items = study_paper()

    def table() -> Payload:
        names = [field.name for field in fields(Item)]
        return {name: [getattr(item, name) for item in items] for name in names}

    payload = {
        "items": list(items),
        "corrections": list(distinct_corrections(items)),
        "definitions": [item.id for item in items if item.id in DEFINITIONS],
    }
    return Result(payload, table, table)
