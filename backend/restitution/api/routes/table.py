"""Tables of ε_t for other codes."""

from restitution.api.calls import Calls
from restitution.studies.tables.export import study_table_as_wanted
from restitution.wire.arrays import refuse_more_points
from restitution.wire.formats import Result
from restitution.wire.queries import TableQuery
from restitution.wire.results import table_result

MOST_SECONDS = 5.0
"""Of one core, for one request."""

calls = Calls("table")


@calls.computed(
    "/table",
    TableQuery,
    None,
    "A table",
    example={"kappa_count": 20, "psi_count": 15},
    limit=lambda query: refuse_more_points(*query.counts),
)
def table(query: TableQuery) -> Result:
    """Return ε_t over κ and ψ for other codes: CSV, NPZ, a C header or a Python module.

    `damping` holds for all entries, or is a third axis up to `damping_max`.
    """
    return table_result(
        study_table_as_wanted(
            query.error, *query.axes, query.sign, query.third, seconds=MOST_SECONDS
        )
    )
