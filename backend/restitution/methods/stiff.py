"""The stiff limit: ε_t = 0 within the energy that the spring can hold."""

import numpy as np

from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import stiff_bound, stiff_limit
from restitution.methods.answer import Answer
from restitution.methods.options import Options, refuse_damping


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return 1 − 2/ψ where the contact slides throughout, else 0, for collisions (N,).

    The bound is rounding in the first case, `limits.stiff_bound` in the second (1 between ψ = 2 and
    ψ*(κ), where that says nothing): proven from κ = 1.57 on, measured below. ``auto`` knows a
    sharper one, `limits.stiff_limit`. Cost: 20 ns.

    Raises
    ------
    ParameterError
        For η > 0.
    """
    refuse_damping("stiff", options.damping)
    epsilon_t, bound = stiff_limit(kappa, psi)
    return Answer(
        epsilon_t,
        np.where(psi < 2.0, stiff_bound(kappa, psi), bound),
        np.full(kappa.shape, "stiff"),
    )
