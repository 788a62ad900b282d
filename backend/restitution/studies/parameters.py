"""The three parameters of a collision, and the two that it depends on."""

import functools
import math
from dataclasses import dataclass

from restitution.errors import require
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.scaled_velocity import psi_of
from restitution.mechanics.viscoelastic import MOST_DAMPING

CONVENTION = (
    "epsilon_t = g_t(t_c)/g_t(0) at the contact point: +1 smooth spheres, -1 gear wheels "
    "(some authors use the opposite sign); kappa is that of Eq. 24, divided by alpha"
)


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

    @functools.cached_property
    def psi(self) -> float:
        """ψ = (α/μ)(g_t/g_n)."""
        return psi_of(self.mu_over_alpha, self.gt_over_gn)


def check(
    kappa: float | FloatArray,
    mu_over_alpha: float | FloatArray,
    gt_over_gn: float | FloatArray,
    damping: float | FloatArray = 0.0,
) -> None:
    """Raise `ParameterError` unless κ > 0, μ/α, g_t/g_n, η ≥ 0, all finite; of any shape.

    η beyond `MOST_DAMPING` is refused as well.
    """
    # plain comparisons: for the numbers of one collision arrays would take longer than it does
    require("kappa", kappa, (kappa > 0.0) & (kappa < math.inf), "finite and > 0")
    for name, value in (("mu_over_alpha", mu_over_alpha), ("gt_over_gn", gt_over_gn)):
        require(name, value, (value >= 0.0) & (value < math.inf), "finite and ≥ 0")
    allowed = (damping >= 0.0) & (damping <= MOST_DAMPING)
    require("damping", damping, allowed, f"from 0 to {MOST_DAMPING:g}, up to which it is followed")
