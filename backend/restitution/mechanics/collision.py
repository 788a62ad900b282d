"""The exact collision without damping, episode by episode, and what follows from the episodes.

The two parameters are κ (Eq. 24, with α in it) and ψ = (α/μ)(g_t/g_n); z and u are the paper's
divided by μ/α. ε_t = u(t_c)/u(0) (Eq. 7): +1 for smooth spheres, −1 for gear wheels; some authors
use the opposite sign.
"""

import contextvars
import functools
import math
import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from restitution.errors import require
from restitution.interruption import pause
from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import (
    CONTACT_DURATION,
    MAXIMUM_FORCE,
    FloatArray,
    normal_motion,
)
from restitution.mechanics.switching import (
    COMPRESSING,
    DECOMPRESSING,
    MONOTONE_STIFFNESS,
    ROUNDING,
    SLIDING_TO_THE_END,
    first_sliding_end,
    sliding_end,
    slip_extremum,
    slip_reach,
    sticking_end_after_compression,
    sticking_end_in_decompression,
)

Item = TypeVar("Item")
Result = TypeVar("Result")

WEAKEST = 1e-100
"""ψ below which ε_t, the switches and u/ψ no longer depend on it, to double precision.

The difference to the limit ψ → 0 is of order (ψκ^{5/4})^{2/3}: below 1e-16 for κ < 1e60. Raising
a smaller ψ to this one keeps every intermediate quantity clear of underflow."""

MOST_SWITCHES = 50_000
"""Largest expected number of switches that is followed: about 10 ms of one core."""

TOO_STIFF = -1
"""Stands for the number of switches of a collision that was not followed."""

PART = 4096
"""Collisions that one thread takes at a time: some milliseconds, so that no thread is left over."""

EPISODE = np.dtype(
    [
        ("q", np.float64),
        ("velocity", np.float64),
        ("decompressing", np.bool_),
        ("side", np.int8),
        ("sliding", np.bool_),
    ]
)
"""The beginning of an episode: q, u, in which half, sign of the spring, regime."""


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


def in_parts(fill: Callable[[int], None], size: int) -> None:
    """Call `fill` with the beginning of each part of `size` collisions; as of `in_threads`."""
    if size <= PART:
        pause()
        fill(0)
    else:
        in_threads(fill, range(0, size, PART))


@compiled
def expected_switches(kappa: float, psi: float) -> float:
    """Return about how many switches a collision has, rather too many than too few.

    They crowd into the decompression, from where the cap has fallen to the spring's amplitude, of
    order ψ√κ, or where the first sliding ends; there one takes about half a radian of √κ t.
    """
    if psi >= 2.0:
        return 4.0
    omega = math.sqrt(kappa)
    begin: float = min(0.5 * CONTACT_DURATION, 1.2 * (psi * omega) ** (2.0 / 3.0))
    begin = min(begin, 1.2 * (2.5 * (2.0 - psi)) ** 0.4)
    return 4.0 + 2.0 * omega * begin / math.pi


@compiled
def _expect_each(kappa: FloatArray, psi: FloatArray, expected: FloatArray) -> None:
    for i in range(kappa.size):
        expected[i] = expected_switches(kappa[i], psi[i])


def expected_switch_counts(kappa: FloatArray, psi: FloatArray) -> FloatArray:
    """Return `expected_switches` of collisions (N,): what following them will cost."""
    expected = np.empty(kappa.shape)
    _expect_each(kappa, psi, expected)
    return expected


@compiled
def stiff_bound(kappa: float, psi: float) -> float:
    """Return min(1, (5/4)^{3/5}/(ψ√κ)), a bound on |ε_t| for ψ < 2; see `limits.stiff_bound`."""
    return min(1.0, MAXIMUM_FORCE / math.sqrt(kappa) / psi)


SHARP_STIFF_LIMIT = 4.484842352
"""max over τ of (τ + π/2)^{3/2} − (2/5) τ^{5/2}, rounded up; at τ = 2.0035."""

NO_LESS = 2.3e-308
"""Bounds stay above the smallest normal double: a bound of 0 would promise too much."""


@compiled
def sharp_stiff_bound(kappa: float, psi: float) -> float:
    """Return min(`stiff_bound`, 4.4848 κ^{-5/4}/ψ), a bound on |ε_t| for ψ < 2.

    The second is proven from κ = `MONOTONE_STIFFNESS` on (docs/model.md) and smaller than the
    first from κ = 6.2 on.
    """
    half_power = kappa**-0.625
    # in two halves, between which a small ψ makes up for a large κ
    sharp = SHARP_STIFF_LIMIT * half_power / psi * half_power
    bound = stiff_bound(kappa, psi)
    return max(NO_LESS, min(bound, sharp) if kappa >= MONOTONE_STIFFNESS else bound)


@compiled
def rounding_bound(kappa: float, psi: float) -> float:
    """Return a bound on the rounding error of ε_t.

    Errors never grow, for two motions under the same cap only approach each other (docs/model.md).
    What remains is the phase √κ t_c of a swing whose amplitude is at most `stiff_bound`, and some
    roundings of ε_t itself. The factor is five times the largest error seen in tests/validation.
    """
    return 4e-15 * (1.0 + math.sqrt(kappa) * stiff_bound(kappa, psi))


@compiled
def record(
    episodes: npt.NDArray[np.void],
    i: int,
    q: float,
    velocity: float,
    decompressing: bool,
    side: int,
    sliding: bool,
) -> None:
    """Write the beginning of episode `i`."""
    episodes[i]["q"] = q
    episodes[i]["velocity"] = velocity
    episodes[i]["decompressing"] = decompressing
    episodes[i]["side"] = side
    episodes[i]["sliding"] = sliding


@compiled
def velocity_to_stop(q: float, decompressing: bool) -> float:
    """Return what the cap can still take from the velocity in the rest of the contact, 1 + ẋ."""
    _, loss = normal_motion(q)
    return loss if decompressing else 2.0 - loss


@compiled
def sticking_end(
    kappa: float, phase: int, q: float, side: int, velocity: float
) -> tuple[bool, float, int, float, bool]:
    """Return the half, q, side, velocity towards that side, and certainty of the next sliding.

    Sticking began in `phase` at q on the given side with the given velocity.
    """
    omega = math.sqrt(kappa)
    decompressing = certain = True
    if phase == COMPRESSING:
        decompressing, q, side, velocity, certain = sticking_end_after_compression(
            kappa, omega, q, velocity
        )
        towards = side * velocity
    else:
        q, towards = sticking_end_in_decompression(omega, q, abs(velocity))
        side = -side
    if decompressing and kappa * (velocity_to_stop(q, True) - towards) > slip_reach(kappa, q):
        # Only rounding has put the spring on the cap: it moves away, faster than the cap falls.
        q, towards = sticking_end_in_decompression(omega, q, -towards)
        side, certain = -side, False
    return decompressing, q, side, towards, certain


@compiled
def next_sliding_end(kappa: float, q: float, decompressing: bool, lacking: float) -> float:
    """Return q where sliding ends that began at q and lacks the velocity `lacking` to go on."""
    high = q
    if kappa < MONOTONE_STIFFNESS:
        extremum = slip_extremum(kappa)
        high = min(q, extremum) if decompressing else extremum
    return sliding_end(kappa, kappa * lacking, high, high)


@compiled
def follow(kappa: float, psi: float, episodes: npt.NDArray[np.void]) -> tuple[float, int, bool]:
    """Follow one collision from switch to switch.

    Parameters
    ----------
    kappa, psi : float
        Positive and finite; ψ at least `WEAKEST`.
    episodes : ndarray of `EPISODE`
        Filled with the first episodes, as many as it has room for; may be empty.

    Returns
    -------
    epsilon_t, switches, certain
        As in `Collision`.
    """
    phase, q, certain = first_sliding_end(kappa, psi)
    room = episodes.size
    if room > 0:
        record(episodes, 0, 0.0, psi, False, 1, True)
    if phase == SLIDING_TO_THE_END:
        return 1.0 - 2.0 / psi, 0, certain
    omega = math.sqrt(kappa)
    phase_rounding = 8.0 * ROUNDING * (1.0 + omega)
    side = 1
    switches = 0
    while True:
        root, loss = normal_motion(q)
        compressing = phase == COMPRESSING
        velocity = psi - loss if compressing else -1.5 * side * root * (1.0 - loss) / kappa
        switches += 1
        if switches < room:
            record(episodes, switches, q, velocity, not compressing, side, False)
        decompressing, q, side, towards, sure = sticking_end(kappa, phase, q, side, velocity)
        switches += 1
        if switches < room:
            record(episodes, switches, q, side * towards, decompressing, side, True)
        lacking = velocity_to_stop(q, decompressing) - towards
        # the velocity of a swing is known to the rounding of its phase, times its amplitude
        root, _ = normal_motion(q)
        swing = math.hypot(root * root * root / omega, towards)
        certain = certain and sure and abs(lacking) > phase_rounding * swing
        if lacking <= 0.0:
            return -side * lacking / psi, switches, certain
        q = next_sliding_end(kappa, q, decompressing, lacking)
        phase = DECOMPRESSING


@compiled
def _collide_each(
    kappa: FloatArray,
    psi: FloatArray,
    most_switches: float,
    epsilon_t: FloatArray,
    switches: npt.NDArray[np.int32],
    certain: npt.NDArray[np.bool_],
    bound: FloatArray,
) -> None:
    """Fill the last four arrays (N,) for the parameters in the first two."""
    nothing = np.empty(0, dtype=EPISODE)
    for i in range(kappa.size):
        k, p = kappa[i], max(psi[i], WEAKEST)
        bound[i] = rounding_bound(k, p)
        # for ψ ≥ 2 there are few switches, and the stiff limit says nothing
        if p < 2.0 and (bound[i] >= 1.0 or expected_switches(k, p) > most_switches):
            epsilon_t[i], switches[i], certain[i] = 0.0, TOO_STIFF, False
            bound[i] = sharp_stiff_bound(k, psi[i])
        else:
            epsilon_t[i], switches[i], certain[i] = follow(k, p, nothing)
        if psi[i] == 0.0:
            switches[i], certain[i] = 0, True


def collide_in_parts(
    kappa: npt.ArrayLike, psi: npt.ArrayLike, each: Callable[..., None]
) -> Collision:
    """Return what `each` makes of collisions, shared among threads where they are many.

    It takes κ and ψ (N,) and fills ε_t, switches, certainty and bound (N,).
    """
    kappas, psis = np.broadcast_arrays(
        np.asarray(kappa, dtype=np.float64), np.asarray(psi, dtype=np.float64)
    )
    require("kappa", kappas, (kappas > 0) & np.isfinite(kappas), "positive and finite")
    require("psi", psis, psis >= 0, "0 or more")
    # copies, for a kernel does not take what is broadcast
    flat = np.array(kappas, order="C").ravel(), np.array(psis, order="C").ravel()
    epsilon_t, bound = np.empty(kappas.size), np.empty(kappas.size)
    switches, certain = np.empty(kappas.size, np.int32), np.empty(kappas.size, np.bool_)
    columns = *flat, epsilon_t, switches, certain, bound

    def fill(begin: int) -> None:
        each(*(column[begin : begin + PART] for column in columns))

    in_parts(fill, kappas.size)
    shape = kappas.shape
    return Collision(
        epsilon_t.reshape(shape),
        switches.reshape(shape),
        certain.reshape(shape),
        bound.reshape(shape),
    )


def collide(
    kappa: npt.ArrayLike, psi: npt.ArrayLike, most_switches: float = MOST_SWITCHES
) -> Collision:
    """Return the coefficient of tangential restitution and the number of switches.

    Parameters
    ----------
    kappa : array_like
        Stiffness κ of Eq. 24, positive and finite.
    psi : array_like
        ψ = (α/μ)(g_t/g_n), not negative; broadcast against `kappa`. 0 stands for the limit
        ψ → 0, with no switch; infinity gives ε_t = 1.
    most_switches : float, optional
        Collisions with ψ < 2 that are expected to switch more often are not followed: they have
        ε_t = 0 with the sharp stiff limit as bound, and `TOO_STIFF` switches.

    Returns
    -------
    Collision
        Arrays of the common shape.

    Examples
    --------
    >>> epsilon_t, switches, _, _ = collide(18.0, [0.3, 1.0, 4.0])
    >>> switches
    array([4, 4, 0], dtype=int32)
    """
    most = float(most_switches)  # an integer would be compiled for anew
    return collide_in_parts(
        kappa, psi, lambda kappas, psis, *out: _collide_each(kappas, psis, most, *out)
    )
