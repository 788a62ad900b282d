"""Coefficient of tangential restitution of frictional viscoelastic spheres.

>>> import restitution
>>> float(restitution.epsilon_t(kappa=18, mu_over_alpha=1.4, gt_over_gn=5.6))
0.5
>>> trace = restitution.trace(kappa=18, mu_over_alpha=1.4, gt_over_gn=0.5)
>>> trace["tangential_velocity"].shape
(404,)
"""

import numpy as np
import numpy.typing as npt

from restitution.methods.answer import Options
from restitution.studies.batch import study_batch
from restitution.studies.parameters import CollisionParameters
from restitution.studies.trace import study_trace

__all__ = ["epsilon_t", "trace"]


def epsilon_t(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike = 0.0,
) -> npt.NDArray[np.float64]:
    """Return the exact coefficient of tangential restitution.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn : array_like
        κ of Eq. 24, μ/α, and g_t/g_n before the collision; broadcast together.
    damping : array_like, optional
        η = (3/2) A β^{2/5} g_n^{1/5}; broadcast as well.

    Returns
    -------
    ndarray
        ε_t, of the common shape: +1 smooth spheres, −1 gear wheels.

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If a collision is too stiff to be followed.
    """
    kappas, friction, tangential, etas = np.broadcast_arrays(
        kappa, mu_over_alpha, gt_over_gn, damping
    )
    batch = study_batch(
        kappas.ravel(),
        friction.ravel(),
        tangential.ravel(),
        ("epsilon_t",),
        Options("exact"),
        etas.ravel(),
    )
    return np.asarray(batch.columns["epsilon_t"].reshape(kappas.shape))


def trace(
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    samples: int = 400,
    damping: float = 0.0,
) -> dict[str, npt.NDArray[np.float64]]:
    """Return forces, velocities and the spring over the time of one contact.

    Columns as of ``GET /api/v1/trace``, scaled by t_scale, ξ_scale, g_n and their combinations;
    each of length `samples` + switches.
    """
    parameters = CollisionParameters(kappa, mu_over_alpha, gt_over_gn, damping)
    return study_trace(parameters, Options("exact"), samples).columns  # type: ignore[return-value]
