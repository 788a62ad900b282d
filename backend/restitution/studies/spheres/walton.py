"""Walton's β₀, what is left of a tangential velocity that sticks, and the κ that has it; W1993."""

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from annotated_types import Ge, Le

from restitution.bounds import Meaning, as_float, interval, requirement
from restitution.errors import ParameterError
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.methods import planner
from restitution.methods.options import Options
from restitution.quantities import QUANTITIES
from restitution.studies.collision.parameters import Convention

Beta0 = Annotated[float, Ge(-1), Le(1), QUANTITIES["beta_0"]]

OTHERS = 3
"""Further κ that are named."""


@dataclass(frozen=True)
class WaltonStudy:
    """The smallest κ whose undamped collisions have a β₀; there are others, without end.

    Attributes
    ----------
    beta_0 : float
        −ε_t for ψ → 0.
    kappa : float
        From 0 to 0.953: the spring swings once at most.
    others : list of float
        The next larger κ that have it as well.

    Examples
    --------
    >>> found = study_walton(0.4)
    >>> round(found.kappa, 4), [round(kappa, 3) for kappa in found.others]
    (0.3795, [1.786, 6.597, 10.817])
    """

    beta_0: Beta0
    kappa: Annotated[float, Ge(0), QUANTITIES["kappa"]]
    others: Annotated[list[float], Meaning("the next larger κ that have the same β₀")]
    convention: Convention


CONVENTION = (
    "beta_0 = -epsilon_t for psi -> 0, as the contact sticks throughout: -cos(sqrt(kappa) t_c) "
    "without damping; kappa is that of Eq. 24, the smallest that has it; others have it as well"
)


def walton_beta_0(kappa: float, damping: float) -> float | None:
    """Return −ε_t for ψ → 0, None where double precision does not hold the phase of the spring."""
    options = Options(damping=damping)
    found = planner.solve(np.array([kappa]), np.array([0.0]), ("epsilon_t",), options)
    return None if found.error_bound[0] >= 1.0 else 0.0 - float(found.epsilon_t[0])


def study_walton(beta_0: float) -> WaltonStudy:
    """Return the κ of Eq. 24 whose undamped collisions have a β₀ of Walton's model.

    Parameters
    ----------
    beta_0 : float
        −1 … 1, a pure number.

    Returns
    -------
    WaltonStudy
        The smallest κ, from 0 to 0.953, and the next larger ones: cos(√κ t_c) = −β₀ has
        infinitely many.

    Raises
    ------
    ParameterError
        If it is out of range.

    Examples
    --------
    >>> round(study_walton(1.0).kappa, 5)
    0.95304
    """
    low, high = interval(Beta0)
    if not low <= as_float(beta_0) <= high:
        raise ParameterError("beta_0", beta_0, requirement(Beta0))
    # without the cancellation of arccos near smooth spheres
    phase = 2.0 * math.asin(math.sqrt(0.5 * (1.0 + beta_0)))
    turns = (2.0 * math.pi * n + side * phase for n in range(1, OTHERS + 1) for side in (-1, 1))
    larger = sorted({(each / CONTACT_DURATION) ** 2 for each in turns})
    kappa = (phase / CONTACT_DURATION) ** 2
    return WaltonStudy(float(beta_0), kappa, [k for k in larger if k > kappa][:OTHERS], CONVENTION)
