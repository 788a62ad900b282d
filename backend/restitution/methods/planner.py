"""The cheapest method that meets the tolerance, per collision."""

from collections.abc import Callable, Collection

import numpy as np

from restitution.errors import ParameterError
from restitution.mechanics.collision import TOO_STIFF
from restitution.mechanics.hertz import FloatArray
from restitution.methods import coulomb, exact, ode, stiff, timestep
from restitution.methods.answer import Answer, Options

METHODS: dict[str, Callable[[FloatArray, FloatArray, Options], Answer]] = {
    "exact": exact.solve,
    "coulomb": coulomb.solve,
    "pragmatic": coulomb.solve,
    "stiff": stiff.solve,
    "timestep": timestep.solve,
    "ode": ode.solve,
}

EPSILON_T_ALONE = frozenset(
    {"epsilon_t", "epsilon_n", "coulomb", "stiff_bound", "stiff_asymptote", "estimates"}
)
"""Quantities for which any method will do; the others need the exact one."""


def solve(
    kappa: FloatArray, psi: FloatArray, quantities: Collection[str], options: Options
) -> Answer:
    """Return ε_t of collisions (N,) by the method asked for, or by the cheapest that will do.

    Parameters
    ----------
    kappa, psi : ndarray, shape (N,)
        Positive and finite; 0 … ∞.
    quantities : collection of str
        What the caller is going to use.
    options : Options
        Method, tolerance, and options of methods.

    Raises
    ------
    ParameterError
        If there is no such method.
    CostError
        If a method asked for by name would cost too much. ``auto`` is never refused: what is too
        stiff to be followed gets the stiff limit with its bound.
    """
    if options.method != "auto":
        if options.method not in METHODS:
            allowed = f"one of auto, {', '.join(METHODS)}"
            raise ParameterError("method", options.method, allowed)
        return METHODS[options.method](kappa, psi, options)
    if not EPSILON_T_ALONE.issuperset(quantities):
        fine = exact.follow_affordable(kappa, psi)
        method = np.where(fine.switches == TOO_STIFF, "stiff", "exact")
        return Answer(
            fine.epsilon_t, fine.error_bound, method, fine.switches, fine.switches_certain
        )
    coarse = stiff.solve(kappa, psi, options)
    needed = coarse.error_bound > options.tolerance
    fine = exact.follow_affordable(kappa[needed], psi[needed])
    switches = np.full(kappa.shape, TOO_STIFF, np.int32)
    certain = np.zeros(kappa.shape, np.bool_)
    coarse.epsilon_t[needed], coarse.error_bound[needed] = fine.epsilon_t, fine.error_bound
    switches[needed], certain[needed] = fine.switches, fine.switches_certain
    method = np.where(switches == TOO_STIFF, "stiff", "exact")
    return Answer(coarse.epsilon_t, coarse.error_bound, method, switches, certain)
