"""The three parameters of a collision, and the two that it depends on."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from restitution.errors import require
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.viscoelastic import MOST_DAMPING

CONVENTION = (
    "epsilon_t = g_t(t_c)/g_t(0) at the contact point: +1 smooth spheres, -1 gear wheels "
    "(some authors use the opposite sign); kappa is that of Eq. 24, divided by alpha"
)


def scaled_velocity(mu_over_alpha: npt.ArrayLike, gt_over_gn: npt.ArrayLike) -> FloatArray:
    """Return ψ = (g_t/g_n)/(μ/α), broadcast.

    Infinite for μ = 0 and where it overflows, 0 for g_t = 0 only: a positive quotient that
    underflows is the smallest positive double, which has the same ε_t.
    """
    friction = np.asarray(mu_over_alpha, dtype=np.float64)
    tangential = np.asarray(gt_over_gn, dtype=np.float64)
    with np.errstate(all="ignore"):
        psi = np.where(friction == 0.0, np.inf, tangential / friction)
    smallest = np.nextafter(0.0, 1.0)
    return np.where((psi == 0.0) & (tangential > 0.0), smallest, psi)


@dataclass(frozen=True)
class CollisionParameters:
    """κ, μ/α, g_t/g_n and η of one collision.

    Attributes
    ----------
    kappa : float
        κ of Eq. 24, positive.
    mu_over_alpha : float
        μ/α, 0 or more.
    gt_over_gn : float
        Tangential over normal velocity at the contact point before the collision, 0 or more.
    damping : float
        η = (3/2) A β^{2/5} g_n^{1/5}, 0 … `MOST_DAMPING`.
    """

    kappa: float
    mu_over_alpha: float
    gt_over_gn: float
    damping: float = 0.0

    def __post_init__(self) -> None:
        check(self.kappa, self.mu_over_alpha, self.gt_over_gn, self.damping)

    @property
    def psi(self) -> float:
        """ψ = (α/μ)(g_t/g_n)."""
        return float(scaled_velocity(self.mu_over_alpha, self.gt_over_gn))


def check(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike = 0.0,
) -> None:
    """Raise `ParameterError` unless κ > 0, μ/α, g_t/g_n, η ≥ 0, all finite; of any shape.

    η beyond `MOST_DAMPING` is refused as well.
    """
    kappas = np.asarray(kappa, dtype=np.float64)
    require("kappa", kappas, np.isfinite(kappas) & (kappas > 0), "finite and > 0")
    for name, value in (("mu_over_alpha", mu_over_alpha), ("gt_over_gn", gt_over_gn)):
        values = np.asarray(value, dtype=np.float64)
        require(name, values, np.isfinite(values) & (values >= 0), "finite and ≥ 0")
    etas = np.asarray(damping, dtype=np.float64)
    allowed = (etas >= 0) & (etas <= MOST_DAMPING)
    require("damping", etas, allowed, f"from 0 to {MOST_DAMPING:g}, up to which it is followed")
