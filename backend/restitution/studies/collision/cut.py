"""ε_t along a line through the parameters."""

from collections.abc import Collection
from dataclasses import dataclass

from restitution.mechanics.hertz import FloatArray
from restitution.methods.options import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import BatchStudy, study_batch
from restitution.studies.collision.parameters import CONVENTION
from restitution.studies.tabular import Table, Tabular


@dataclass(frozen=True)
class CutStudy(Tabular):
    """Quantities along one parameter.

    Attributes
    ----------
    along : str
        ``"kappa"`` or ``"gt_over_gn"``.
    values : ndarray, shape (count,)
        Of that parameter.
    batch : BatchStudy
        Columns of shape (count,).

    Examples
    --------
    >>> study_cut(Axis(1, 60, 4), 1.4, gt_over_gn=5.6).to_pandas().epsilon_t.to_list()
    [0.5, 0.5, 0.5, 0.5]
    """

    along: str
    values: FloatArray
    batch: BatchStudy

    def table(self) -> Table:
        """Return the quantities over the parameter that varies."""
        rest = [name for name in self.batch.given if name != self.along]
        return Table(
            {self.along: self.values},
            self.batch.found(self.values.shape),
            self.batch.held(*rest),
            {"convention": CONVENTION},
        )


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
