"""The error statement of methods that have no bound of their own: measured against the exact."""

import numpy as np
import numpy.typing as npt

from restitution.mechanics.hertz import FloatArray
from restitution.methods import exact
from restitution.methods.answer import Answer
from restitution.methods.options import Options


def measured(
    kappa: FloatArray,
    psi: FloatArray,
    epsilon_t: FloatArray,
    options: Options,
    switches: npt.NDArray[np.int32] | None = None,
) -> Answer:
    """Return an answer whose bound is |ε_t − exact| plus the exact one's own, for (N,).

    Switches that the method has counted are certain where the exact ones are and agree. This costs
    what the exact method costs.
    """
    truth = exact.follow_affordable(kappa, psi, options.damping, options.share)
    certain = None
    if switches is not None:
        certain = truth.switches_certain & (switches == truth.switches)
    return Answer(
        epsilon_t,
        np.abs(epsilon_t - truth.epsilon_t) + truth.error_bound,
        np.full(kappa.shape, options.method),
        switches,
        certain,
        exact.known(truth),
    )
