"""ε_t and switches over the plane of κ and g_t/g_n."""

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from restitution.mechanics.hertz import FloatArray
from restitution.methods.answer import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import BatchStudy, study_batch


@dataclass(frozen=True)
class GridStudy:
    """A map.

    Attributes
    ----------
    kappa : ndarray, shape (n,)
    gt_over_gn : ndarray, shape (k,)
    batch : BatchStudy
        Columns of length k n, κ fastest.
    """

    kappa: FloatArray
    gt_over_gn: FloatArray
    batch: BatchStudy


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
