"""The paper, statement by statement."""

from dataclasses import fields

from restitution.api.calls import Calls
from restitution.paper import Item, study_paper
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

    return Result({"items": list(items)}, table, table)
