"""Compile or load the kernels before the first request needs them."""

from restitution.methods.options import Options
from restitution.methods.planner import switches_to_follow
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import QUANTITIES, study_batch
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.trace import study_trace
from restitution.studies.tables.export import study_table


def warm() -> None:
    """Run one collision through the kernels of what the page shows first."""
    study_trace(CollisionParameters(18.0, 1.4, 0.4), samples=2)
    study_batch(18.0, 1.4, 0.4, QUANTITIES, Options(method="stiff"))
    switches_to_follow(18.0, 0.3)


def warm_rest() -> None:
    """Run one through every other, and load the table or build it the first time (15 s)."""
    study_trace(CollisionParameters(18.0, 1.4, 0.4, 0.1), samples=2)
    study_trace(CollisionParameters(18.0, 1.4, 0.4), Options(method="timestep"), samples=2)
    study_batch(18.0, 1.4, 0.4, ("epsilon_t",), Options(method="table"))
    study_table(Axis(1.0, 2.0, 2), Axis(1.0, 2.0, 2), "paper", 0.1, seconds=1.0)
