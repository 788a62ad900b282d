"""The exact collision, episode by episode, and what follows from the episodes.

Its parameters are κ (Eq. 24, with α in it), ψ = (α/μ)(g_t/g_n) and η, which makes the `contact`;
z and u are the paper's divided by μ/α. ε_t = u(t_c)/u(0) (Eq. 7): +1 for smooth spheres, −1 for
gear wheels; some authors use the opposite sign.
"""

import contextvars
import functools
import math
import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from restitution.errors import require
from restitution.interruption import pause
from restitution.mechanics.compiled import compiled
from restitution.mechanics.contact import (
    Contact,
    by_contact,
    contact_of,
    energy_bound,
    expected_switches,
    rounding_bound,
    sliding_end,
    spring_in,
    sticking_end,
    stiffest_within,
)
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.lanes import block
from restitution.mechanics.lanes.damped import block as damped_block
from restitution.mechanics.lanes.rows import BLOCK, LEFT, Labels, work_space
from restitution.mechanics.scaled_velocity import WEAKEST

Item = TypeVar("Item")
Result = TypeVar("Result")

MOST_SWITCHES = 50_000
"""Largest expected number of switches that is followed: about 10 ms of one core."""

ENDLESS = 10_000_000
"""Switches after which a collision goes wrong: far beyond `MOST_SWITCHES` and what is expected."""

TOO_STIFF = -1
"""Stands for the number of switches of a collision that was not followed."""

PART = 8192
"""Collisions that one thread takes at a time: a millisecond, so that no thread is left over."""

EPISODE = np.dtype(
    [
        ("q", np.float64),
        ("velocity", np.float64),
        ("falling", np.bool_),
        ("side", np.int8),
        ("sliding", np.bool_),
    ]
)
"""The beginning of an episode: q, u, whether the normal force falls, sign of the spring, regime."""


collide_block = by_contact(block.collide_block, damped_block.collide_block)


class Collision(NamedTuple):
    """Result of `collide`; arrays of the parameters' common shape."""

    epsilon_t: FloatArray
    """Coefficient of tangential restitution; 0 where the collision is too stiff to follow."""
    switches: npt.NDArray[np.int32]
    """Changes of regime, `TOO_STIFF` where the collision is too stiff to follow."""
    switches_certain: npt.NDArray[np.bool_]
    """False where rounding decides about a switch."""
    error_bound: FloatArray
    """Bound on |error| of epsilon_t."""


@functools.cache
def workers() -> ThreadPoolExecutor:
    """Return the threads that share large arrays; the kernels hold no interpreter lock."""
    return ThreadPoolExecutor(os.cpu_count())


def in_threads(work: Callable[[Item], Result], items: Iterable[Item]) -> list[Result]:
    """Return what `work` makes of every item, shared among the processor's cores.

    Raises
    ------
    InterruptionError
        Between two items, if this thread's work was called off.
    """
    # each item in a context of its own, for one cannot be entered twice at a time
    tasks = [(contextvars.copy_context(), item) for item in items]

    def run(task: tuple[contextvars.Context, Item]) -> Result:
        context, item = task
        context.run(pause)
        return context.run(work, item)

    return list(workers().map(run, tasks))


def in_parts(fill: Callable[[int], None], size: int, part: int) -> None:
    """Call `fill` with the beginning of each part of `size` collisions; as of `in_threads`."""
    if size <= part:
        pause()
        fill(0)
    else:
        in_threads(fill, range(0, size, part))


@compiled
def _expect_each(
    contact: Contact, kappa: FloatArray, psi: FloatArray, expected: FloatArray
) -> None:
    for i in range(kappa.size):
        expected[i] = expected_switches(contact, kappa[i], psi[i])


def expected_switch_counts(kappa: FloatArray, psi: FloatArray, damping: float = 0.0) -> FloatArray:
    """Return about how many switches collisions (N,) have, rather too many than too few."""
    expected = np.empty(kappa.shape)
    _expect_each(contact_of(damping), kappa, psi, expected)
    return expected


@compiled
def record(
    episodes: npt.NDArray[np.void],
    i: int,
    q: float,
    velocity: float,
    falling: bool,
    side: int,
    sliding: bool,
) -> None:
    """Write the beginning of episode `i`."""
    episodes[i]["q"] = q
    episodes[i]["velocity"] = velocity
    episodes[i]["falling"] = falling
    episodes[i]["side"] = side
    episodes[i]["sliding"] = sliding


@compiled
def within_reach(contact: Contact, psi: float) -> float:
    """Return ψ or, where it is out of range, the end of the range: followed in its place."""
    return min(max(psi, WEAKEST), contact.strongest)


@compiled
def follow(
    contact: Contact, kappa: float, psi: float, episodes: npt.NDArray[np.void]
) -> tuple[float, int, bool]:
    """Follow one collision from switch to switch.

    Parameters
    ----------
    contact : Contact
        What η makes of the normal motion.
    kappa, psi : float
        Positive and finite; ψ may be out of reach.
    episodes : ndarray of `EPISODE`
        Filled with the first episodes, as many as it has room for; may be empty.

    Returns
    -------
    epsilon_t, switches, certain
        As in `Collision`.
    """
    wanted, psi = psi, within_reach(contact, psi)
    spring = spring_in(contact, kappa, psi)
    room = episodes.size
    falling, q, side, towards = False, 0.0, 1, psi
    sliding = contact.begins_sliding
    # without damping the limit is reached before a ψ is out of reach; with it the count may differ
    certain = sliding or (psi == wanted and kappa * psi > contact.least_load)
    for switches in range(ENDLESS):
        if switches < room:
            record(episodes, switches, q, side * towards, falling, side, sliding)
        if sliding:
            ends, falling, q, towards, sure = sliding_end(contact, spring, falling, q, towards)
            certain = certain and sure
            if not ends and switches == 0:
                # Eq. 15: what the cap takes, not what it leaves, is known to the last digit
                return 1.0 - contact.impulse / psi, switches, certain
            if not ends:
                # rounding can exceed what the energy allows
                return min(max(side * towards / psi, -1.0), 1.0), switches, certain
        else:
            falling, q, turned, towards, sure = sticking_end(contact, spring, falling, q, towards)
            side *= turned
            certain = certain and sure
        sliding = not sliding
    raise ArithmeticError("the collision does not end")


@compiled
def _collide_one(
    contact: Contact,
    most_switches: float,
    kappa: float,
    psi: float,
    nothing: npt.NDArray[np.void],
) -> tuple[float, int, bool, float]:
    """Return ε_t, switches, certainty and bound of one collision; `nothing` has no episode."""
    reached = within_reach(contact, psi)
    bound = rounding_bound(contact, kappa, reached)
    # stronger ones have few switches, and energy does not bound them
    weak = reached < contact.impulse
    if weak and (bound >= 1.0 or expected_switches(contact, kappa, reached) > most_switches):
        epsilon_t, switches, certain = 0.0, TOO_STIFF, False
        bound = energy_bound(contact, kappa, psi)
    else:
        epsilon_t, switches, certain = follow(contact, kappa, psi, nothing)
    if psi in (0.0, np.inf):
        switches, certain = 0, True
    return epsilon_t, switches, certain, bound


@compiled
def _collide_in_lanes(
    contact: Contact,
    most_switches: float,
    kappa: FloatArray,
    psi: FloatArray,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
    certain: npt.NDArray[np.bool_],
    bound: FloatArray,
    lanes: FloatArray,
    labels: Labels,
) -> None:
    """Fill the four arrays (N,) before the work space, a block of collisions at a time."""
    nothing = np.empty(0, dtype=EPISODE)
    stiffest = stiffest_within(contact, most_switches)
    for begin in range(0, kappa.size, BLOCK):
        end = min(begin + BLOCK, kappa.size)
        for i in range(begin, end):
            bound[i], certain[i] = rounding_bound(contact, kappa[i], psi[i]), True
        left = collide_block(
            contact, stiffest, begin, end, kappa, psi, bound, lanes, labels, epsilon_t, switches
        )
        for i in range(left):
            j = labels[LEFT + i]
            epsilon_t[j], switches[j], certain[j], bound[j] = _collide_one(
                contact, most_switches, kappa[j], psi[j], nothing
            )


def epsilon_in_lanes(contact: Contact, kappa: float, psi: float, bound: float) -> float | None:
    """Return ε_t of one collision as `collide` has it; None if it is followed there.

    `bound` is its `rounding_bound`.
    """
    epsilon_t, switches = np.empty(1), np.empty(1, np.int32)
    given = np.array([kappa]), np.array([psi]), np.array([bound])
    left = collide_block(contact, math.inf, 0, 1, *given, *work_space(), epsilon_t, switches)
    return None if left else float(epsilon_t[0])


def collide(
    kappa: npt.ArrayLike,
    psi: npt.ArrayLike,
    damping: float = 0.0,
    most_switches: float = MOST_SWITCHES,
) -> Collision:
    """Return the coefficient of tangential restitution and the number of switches.

    Parameters
    ----------
    kappa : array_like
        Stiffness κ of Eq. 24, positive and finite.
    psi : array_like
        ψ = (α/μ)(g_t/g_n), not negative; broadcast against `kappa`. 0 stands for the limit
        ψ → 0, with no switch; infinity gives ε_t = 1.
    damping : float, optional
        η, at most `MOST_DAMPING`.
    most_switches : float, optional
        Collisions with ψ < 1 + ε_n that are expected to switch more often are not followed: they
        have ε_t = 0 with `energy_bound`, and `TOO_STIFF` switches.

    Returns
    -------
    Collision
        Arrays of the common shape.

    Examples
    --------
    >>> epsilon_t, switches, _, _ = collide(63.0, [0.3, 1.0, 4.0])
    >>> switches
    array([4, 8, 0], dtype=int32)
    >>> collide(63.0, [0.3, 1.0, 4.0], damping=0.05).switches
    array([5, 9, 1], dtype=int32)
    """
    contact = contact_of(damping)
    most = float(most_switches)  # an integer would be compiled for anew
    kappas, psis = np.broadcast_arrays(
        np.asarray(kappa, dtype=np.float64), np.asarray(psi, dtype=np.float64)
    )
    require("kappa", kappas, (kappas > 0) & np.isfinite(kappas), "positive and finite")
    require("psi", psis, psis >= 0, "0 or more")
    # copies, for a kernel does not take what is broadcast
    flat = np.array(kappas, order="C").ravel(), np.array(psis, order="C").ravel()
    epsilon_t, bound = np.empty(kappas.size), np.empty(kappas.size)
    switches, certain = np.empty(kappas.size, np.int32), np.empty(kappas.size, np.bool_)
    columns: tuple[npt.NDArray[Any], ...] = *flat, epsilon_t, switches, certain, bound

    def fill(begin: int) -> None:
        mine: tuple[Any, ...] = tuple(column[begin : begin + PART] for column in columns)
        mine += work_space()
        _collide_in_lanes(contact, most, *mine)

    in_parts(fill, kappas.size, PART)
    shape = kappas.shape
    return Collision(
        epsilon_t.reshape(shape),
        switches.reshape(shape),
        certain.reshape(shape),
        bound.reshape(shape),
    )
