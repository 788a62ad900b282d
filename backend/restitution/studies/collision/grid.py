"""ε_t and switches over the plane of κ and g_t/g_n."""

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from restitution.mechanics.hertz import FloatArray
from restitution.methods.options import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import BatchStudy, study_batch
from restitution.studies.collision.parameters import CONVENTION
from restitution.studies.tabular import Table, Tabular


@dataclass(frozen=True)
class GridStudy(Tabular):
    """A map.

    Attributes
    ----------
    kappa : ndarray, shape (n,)
    gt_over_gn : ndarray, shape (k,)
    batch : BatchStudy
        Columns of length k n, κ fastest.

    Examples
    --------
    >>> study_grid(Axis(1, 60, 6), Axis(0.1, 4, 5), 1.4).to_xarray().epsilon_t.dims
    ('gt_over_gn', 'kappa')
    """

    kappa: FloatArray
    gt_over_gn: FloatArray
    batch: BatchStudy

    def table(self) -> Table:
        """Return the quantities over g_t/g_n and κ."""
        return Table(
            {"gt_over_gn": self.gt_over_gn, "kappa": self.kappa},
            self.batch.found((self.gt_over_gn.size, self.kappa.size)),
            self.batch.held("mu_over_alpha", "damping"),
            {"convention": CONVENTION},
        )


def study_grid(
    kappa: Axis,
    gt_over_gn: Axis,
    mu_over_alpha: float,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    options: Options | None = None,
) -> GridStudy:
    """Return a map over `kappa` and `gt_over_gn` at one μ/α."""
    kappas, tangential = kappa.values(positive=True), gt_over_gn.values(positive=False)
    columns, rows = np.meshgrid(kappas, tangential)
    batch = study_batch(columns.ravel(), mu_over_alpha, rows.ravel(), quantities, options)
    return GridStudy(kappas, tangential, batch)
