"""Regions of collisions on which methods are compared, and samples of them."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from restitution.mechanics.hertz import FloatArray

FRICTION = 1.4
"""μ/α of the scenes; it only stretches the axis of g_t/g_n."""

Stretch = Callable[[FloatArray], FloatArray]


def _linear(low: float, high: float) -> Stretch:
    return lambda share: low + (high - low) * share


def _log(low: float, high: float) -> Stretch:
    return lambda share: 10.0 ** (np.log10(low) + np.log10(high / low) * share)


def _log_over_all_doubles(share: FloatArray) -> FloatArray:
    return 10.0 ** (600.0 * share - 300.0)


@dataclass(frozen=True)
class Scene:
    """A region with its distribution of collisions.

    Attributes
    ----------
    title : str
        What it is, for people.
    kappa, psi : callable
        From a share, 0 … 1, of the distribution to κ and to ψ.
    dampings : tuple of float
        η, which the collisions have in turn.
    """

    title: str
    kappa: Stretch
    psi: Stretch
    dampings: tuple[float, ...] = (0.0,)

    def sample(self, count: int) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return κ, ψ and η (count,) of collisions that fill the region evenly, always the same.

        Notes
        -----
        The additive sequence of the plastic number ρ, ρ³ = ρ + 1: any stretch of it is spread
        over the square without holes.
        """
        plastic = 1.3247179572447460
        index = np.arange(1, count + 1)
        shares = np.mod(0.5 + index / plastic, 1.0), np.mod(0.5 + index / plastic**2, 1.0)
        return self.kappa(shares[0]), self.psi(shares[1]), np.resize(self.dampings, count)


_SLIP = _linear(0.01 / FRICTION, 4.0 / FRICTION)

SceneName = Literal["figure4", "stiff", "solids", "damped", "extremes"]

SCENES: dict[SceneName, Scene] = {
    "figure4": Scene(
        "Figure 4 of the paper: κ 0.1…70, g_t/g_n 0.01…4 at μ/α = 1.4", _linear(0.1, 70.0), _SLIP
    ),
    "stiff": Scene(
        "Stiff contacts: κ 10³…10⁶ on a log scale, g_t/g_n 0.01…4 at μ/α = 1.4",
        _log(1e3, 1e6),
        _SLIP,
    ),
    "solids": Scene(
        "Real solids, with Mindlin's stiffness: κ 3.5…5.5, g_t/g_n 0.01…4 at μ/α = 1.4",
        _linear(3.5, 5.5),
        _SLIP,
    ),
    "damped": Scene(
        "Damped contacts: κ and g_t/g_n as in Figure 4, η 0.01…0.5 (ε_n 0.99…0.60)",
        _linear(0.1, 70.0),
        _SLIP,
        (0.01, 0.02, 0.04, 0.08, 0.16, 0.3, 0.5),
    ),
    "extremes": Scene(
        "The whole double range: κ and ψ 10⁻³⁰⁰…10³⁰⁰ on log scales",
        _log_over_all_doubles,
        _log_over_all_doubles,
    ),
}
