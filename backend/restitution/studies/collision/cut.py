"""ε_t along a line through the parameters."""

from collections.abc import Collection
from dataclasses import dataclass

from restitution.mechanics.hertz import FloatArray
from restitution.methods.answer import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import BatchStudy, study_batch


@dataclass(frozen=True)
class CutStudy:
    """Quantities along one parameter; `values` and the columns have shape (count,)."""

    along: str
    values: FloatArray
    batch: BatchStudy


def study_cut(
    axis: Axis,
    mu_over_alpha: float,
    *,
    kappa: float | None = None,
    gt_over_gn: float | None = None,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    options: Options | None = None,
) -> CutStudy:
    """Return a cut along κ, or along g_t/g_n: the one that is not given."""
    if kappa is None:
        values = axis.values(positive=True)
        batch = study_batch(values, mu_over_alpha, gt_over_gn or 0.0, quantities, options)
        return CutStudy("kappa", values, batch)
    values = axis.values(positive=False)
    batch = study_batch(kappa, mu_over_alpha, values, quantities, options)
    return CutStudy("gt_over_gn", values, batch)
