"""Coulomb's law with a cut-off: what event-driven codes use."""

import numpy as np

from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import coulomb_restitution
from restitution.methods import exact
from restitution.methods.answer import Answer, Options


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t by Eq. 16, or with ε₀ = `options.floor` by the pragmatic model, for (N,).

    The error is measured: the distance to the exact ε_t and its own bound. The law itself costs
    nanoseconds, its error what the exact method costs.
    """
    floor = options.floor if options.method == "pragmatic" else 0.0
    with np.errstate(divide="ignore"):
        epsilon_t = coulomb_restitution(psi, floor=floor)
    truth = exact.follow_affordable(kappa, psi)
    return Answer(
        epsilon_t,
        np.abs(epsilon_t - truth.epsilon_t) + truth.error_bound,
        np.full(kappa.shape, options.method),
        exact=exact.known(truth),
    )
