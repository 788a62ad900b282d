"""The stiff limit: ε_t = 0 within the energy that the spring can hold."""

import numpy as np

from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import sliding_restitution, sliding_threshold, stiff_bound
from restitution.methods.answer import Answer, Options


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return 1 − 2/ψ where the contact slides throughout, else 0, for collisions (N,).

    The bound is proven: rounding in the first case, `limits.stiff_bound` in the second (1 between
    ψ = 2 and ψ*(κ), where that says nothing). Cost: tens of nanoseconds.
    """
    sliding = psi >= sliding_threshold(kappa)
    with np.errstate(divide="ignore"):
        epsilon_t = np.where(sliding, sliding_restitution(psi), 0.0)
    bound = np.where(sliding, 1e-15, np.nan_to_num(stiff_bound(kappa, psi), nan=1.0))
    return Answer(epsilon_t, bound, np.full(kappa.shape, "stiff"))
