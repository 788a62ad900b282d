"""The cheapest method that meets the tolerance, per collision."""

from collections.abc import Callable, Collection
from typing import Any

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import (
    MOST_SWITCHES,
    TOO_STIFF,
    Collision,
    collide,
)
from restitution.mechanics.contact import ELASTIC, expected_switches
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import stiff_limit
from restitution.mechanics.stepping import most_steps
from restitution.methods import coulomb, exact, ode, stiff, table, timestep
from restitution.methods.answer import Answer
from restitution.methods.options import Options

METHODS: dict[str, Callable[[FloatArray, FloatArray, Options], Answer]] = {
    "exact": exact.solve,
    "coulomb": coulomb.solve,
    "pragmatic": coulomb.solve,
    "stiff": stiff.solve,
    "table": table.solve,
    "timestep": timestep.solve,
    "ode": ode.solve,
}

QUICK_SECONDS = 2e-3

SECONDS_FOR_A_STEP = 1.5e-8
"""Of one collision alone."""

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
    CostError
        If a method asked for by name would cost too much. ``auto`` is never refused: what is too
        stiff to be followed gets the stiff limit with its bound, or with damping, for which the
        limit and the table are not made, Coulomb's 0 with the bound by energy.
    """
    if options.method != "auto":
        return METHODS[options.method](kappa, psi, options)
    if is_exact(quantities, options):
        return _named(exact.follow_affordable(kappa, psi, options.damping, options.share), options)
    return (
        _cheapest_damped(kappa, psi, options) if options.damping else _cheapest(kappa, psi, options)
    )


def is_exact(quantities: Collection[str], options: Options) -> bool:
    """Return whether collisions that can be followed are, whatever the tolerance."""
    any_will_do = EPSILON_T_ALONE.issuperset(quantities)
    return options.method == "exact" or (options.method == "auto" and not any_will_do)


def _named(found: Collision, options: Options) -> Answer:
    """Return collisions of which not all were followed as an answer.

    The others are 0 within a bound, as Coulomb's law has it for so weak a slip.
    """
    resort = "coulomb" if options.damping else "stiff"
    method = np.where(found.switches == TOO_STIFF, resort, "exact")
    return Answer(
        found.epsilon_t,
        found.error_bound,
        method,
        found.switches,
        found.switches_certain,
        exact.known(found),
    )


def _cheapest_damped(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t of damped collisions (N,): 0 where energy bounds it so, else followed."""
    # the limit of 0 switches leaves to be followed what slides from its first swing on
    found = collide(kappa, psi, options.damping, 0.0)
    needed = np.flatnonzero(found.error_bound > options.tolerance)
    spent = kappa.size + int(found.switches.clip(0).sum())
    fine = exact.follow_affordable(
        kappa[needed], psi[needed], options.damping, options.share, spent=spent
    )
    columns: tuple[npt.NDArray[Any], ...] = found
    for column, followed in zip(columns, fine, strict=True):
        column[needed] = followed
    return _named(found, options)


def _cheapest(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t of collisions (N,) from closed forms, then the table, then followed.

    What answers depends on the request alone: the table serves requests that save time by it, and
    if there is none yet it is built.
    """
    tolerance = options.tolerance
    epsilon_t, bound = stiff_limit(kappa, psi)
    method = np.full(kappa.shape, "stiff")
    switches = np.full(kappa.shape, TOO_STIFF, np.int32)
    certain = np.zeros(kappa.shape, np.bool_)
    needed = np.flatnonzero(bound > tolerance)
    held = needed[table.within(kappa[needed], psi[needed])]
    if tolerance >= table.FINEST and exact.cost(kappa[held], psi[held]) >= table.LEAST_GAIN:
        read, certified = table.read(kappa[held], psi[held])
        met = certified <= tolerance
        done = held[met]
        epsilon_t[done], bound[done], method[done] = read[met], certified[met], "table"
        needed = np.flatnonzero(bound > tolerance)
    fine = exact.follow_affordable(kappa[needed], psi[needed], 0.0, options.share)
    epsilon_t[needed], bound[needed] = fine.epsilon_t, fine.error_bound
    switches[needed], certain[needed] = fine.switches, fine.switches_certain
    method[needed] = np.where(fine.switches == TOO_STIFF, "stiff", "exact")
    return Answer(epsilon_t, bound, method, switches, certain)


def switches_to_follow(kappa: float, psi: float) -> float:
    """Return about how many switches one collision has, 0 if they are too many to be followed.

    About as many with damping, whose contact would have to be prepared first.
    """
    switches = expected_switches(ELASTIC, kappa, psi)
    return switches if switches <= MOST_SWITCHES else 0.0


def is_quick(switches: float, options: Options, *, damped: bool) -> bool:
    """Return whether one collision is answered within two milliseconds of one core.

    `damped` says whether η > 0, which may not be known yet, as it takes work to find it by ε_n.
    The table may have to be built first, and the general solver takes longer at its best.
    """
    if options.method in {"table", "ode"}:
        return False
    steps = most_steps(options.steps) if options.method == "timestep" else 0
    dearer = exact.DEARER_BY_DAMPING if damped else 1.0
    following = exact.SECONDS_FOR_A_SWITCH * dearer * switches
    return following + SECONDS_FOR_A_STEP * steps < QUICK_SECONDS
