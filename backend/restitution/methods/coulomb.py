"""Coulomb's law with a cut-off: what event-driven codes use."""

import numpy as np

from restitution.mechanics.contact import normal_restitution
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import coulomb_restitution
from restitution.methods.answer import Answer
from restitution.methods.measured import measured
from restitution.methods.options import Options


def law(psi: FloatArray, options: Options) -> FloatArray:
    """Return ε_t by Eq. 16, or with ε₀ = `options.floor` by the pragmatic model, for (N,)."""
    floor = options.floor if options.method == "pragmatic" else 0.0
    with np.errstate(divide="ignore"):
        return coulomb_restitution(psi, normal_restitution(options.damping), floor)


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t of collisions (N,) by `law`.

    The error is measured: the distance to the exact ε_t and its own bound. The law itself costs
    nanoseconds, its error what the exact method costs.
    """
    return measured(kappa, psi, law(psi, options), options)
