"""A collision in fixed time steps, as codes of discrete elements compute it.

The normal and the tangential motion advance together with dt = t_c/N. After each step the spring,
grown by dt times the velocity, is cut back to the cap. What is written here as κz, the force of
the spring, is the spring itself in those codes; it keeps every product within the double range.
"""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import in_parts
from restitution.mechanics.compiled import compiled
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.scaled_velocity import WEAKEST

PART = 4096
"""Collisions that one thread takes at a time: some milliseconds, so that no thread is left over."""

INTEGRATORS: dict[str, tuple[float, float, float]] = {
    "velocity_verlet": (0.5, 0.5, 0.0),
    "symplectic_euler": (1.0, 0.0, 0.0),
    "forward_euler": (0.0, 0.0, 1.0),
}
"""Integrator → shares of a step's kick that are given before the drift, after it by the new force,
and after it by the old one."""

LOCK_STEP = 256
"""Collisions that advance together: their state stays in the first cache, and the loop over them
is what a processor does four or eight at a time."""


class Stepped(NamedTuple):
    """Result of `step_collisions`; arrays (N,)."""

    epsilon_t: FloatArray
    """Coefficient of tangential restitution; beyond ±1 where the steps are too long."""
    switches: npt.NDArray[np.int32]
    """Changes between a spring at the cap and one below, at the ends of steps."""


def most_steps(steps: int) -> int:
    """Return a bound on the steps of a contact that is meant to have `steps`.

    Each step takes from the rate of compression, whatever the integrator, so that the contact
    ends; the latest known end is after 1.5 times as long (`forward_euler`, `steps` = 4).
    """
    return 2 * steps + 4


@compiled
def normal_step(
    dt: float,
    kicks: tuple[float, float, float],
    damping: float,
    x: float,
    rate: float,
    force: float,
) -> tuple[float, float, float]:
    """Return compression, its rate and the normal force after one step.

    The damping acts by the rate before the last kick, which is what is known then.
    """
    before, after, late = kicks
    middle = rate - before * dt * force
    x += dt * middle
    middle -= late * dt * force
    new = max(0.0, math.sqrt(x) * (x + damping * middle)) if x > 0.0 else 0.0
    return x, middle - after * dt * new, new


@compiled
def tangential_step(
    dt: float,
    kicks: tuple[float, float, float],
    stiffness: float,
    cap: float,
    velocity: float,
    force: float,
) -> tuple[float, float, bool]:
    """Return velocity, force of the spring and whether it is at the cap, after one step.

    `stiffness` is κ dt, `cap` the normal force at the end of the step.
    """
    before, after, late = kicks
    middle = velocity - before * dt * force
    stretched = force + stiffness * middle
    capped = abs(stretched) >= cap
    new = min(max(stretched, -cap), cap)
    return middle - after * dt * new - late * dt * force, new, capped


@compiled
def _step_together(
    kappa: FloatArray,
    psi: FloatArray,
    dt: float,
    phase: float,
    limit: int,
    kicks: tuple[float, float, float],
    damping: float,
    velocity: FloatArray,
    switches: npt.NDArray[np.int32],
) -> None:
    """Fill the last two arrays (N,) with u(t_c) and switches of collisions in lock step."""
    count = kappa.size
    force = np.zeros(count)
    stiffness = np.empty(count)
    # as wide as the other numbers, so that the loop over collisions has one width
    sliding = np.full(count, np.int64(damping == 0.0))
    changes = np.zeros(count, np.int64)
    for i in range(count):
        velocity[i] = psi[i]
        stiffness[i] = kappa[i] * dt
    x, rate, cap = -phase * dt, 1.0, 0.0
    touched = False
    for _ in range(limit):
        x, rate, cap = normal_step(dt, kicks, damping, x, rate, cap)
        for i in range(count):
            velocity[i], force[i], capped = tangential_step(
                dt, kicks, stiffness[i], cap, velocity[i], force[i]
            )
            changes[i] += sliding[i] ^ np.int64(capped)
            sliding[i] = np.int64(capped)
        if touched and (x <= 0.0 or (cap == 0.0 and rate < 0.0)):
            break
        touched = x > 0.0
    for i in range(count):
        switches[i] = changes[i]


@compiled
def _step_each(
    kappa: FloatArray,
    psi: FloatArray,
    dt: float,
    phase: float,
    limit: int,
    kicks: tuple[float, float, float],
    damping: float,
    together: int,
    velocity: FloatArray,
    switches: npt.NDArray[np.int32],
) -> None:
    """Fill the last two arrays (N,), `together` collisions at a time."""
    for begin in range(0, kappa.size, together):
        end = min(begin + together, kappa.size)
        _step_together(
            kappa[begin:end],
            psi[begin:end],
            dt,
            phase,
            limit,
            kicks,
            damping,
            velocity[begin:end],
            switches[begin:end],
        )


def step_collisions(
    kappa: FloatArray,
    psi: FloatArray,
    steps: int,
    integrator: str = "velocity_verlet",
    phase: float = 0.0,
    together: int = LOCK_STEP,
    damping: float = 0.0,
) -> Stepped:
    """Return what a code with fixed time steps makes of collisions.

    Parameters
    ----------
    kappa, psi : ndarray, shape (N,)
        Positive and finite; 0 … ∞. ψ below `WEAKEST` is followed as `WEAKEST`.
    steps : int
        Steps per contact, t_c/dt, at least 4.
    integrator : str, optional
        Of `INTEGRATORS`.
    phase : float, optional
        Where in a step the contact begins, 0 … 1. The step in which it begins stretches the spring
        by a whole dt u, as those codes do; so 1 is 0, a step later.
    together : int, optional
        Collisions that share the computation of the normal motion, which depends on none of their
        parameters but η. 1 costs what a code pays whose contacts begin when they like.
    damping : float, optional
        η. `steps` then are those of the damped contact, whose count of switches is odd.

    Returns
    -------
    Stepped
        Always finite: |u(t_c) − u(0)| is at most the sum of the caps times dt. A contact is taken
        to begin and end at the cap, which is zero there; so the number of switches is even.

    Examples
    --------
    >>> fine = step_collisions(np.array([18.0]), np.array([1.0]), 1000)
    >>> float(fine.epsilon_t[0].round(5)), int(fine.switches[0])
    (0.10475, 4)
    """
    dt = contact_duration(damping) / steps
    kicks = INTEGRATORS[integrator]
    start = np.clip(psi, WEAKEST, np.finfo(float).max)
    velocity, switches = np.empty(kappa.size), np.empty(kappa.size, np.int32)
    kappas = np.ascontiguousarray(kappa)

    def fill(begin: int) -> None:
        part = slice(begin, begin + PART)
        _step_each(
            kappas[part],
            start[part],
            dt,
            phase,
            most_steps(steps),
            kicks,
            damping,
            together,
            velocity[part],
            switches[part],
        )

    in_parts(fill, kappa.size, PART)
    switches[(psi == 0.0) | (psi == np.inf)] = 0
    return Stepped(velocity / start, switches)


@compiled
def _record(
    kappa: float,
    psi: float,
    dt: float,
    phase: float,
    kicks: tuple[float, float, float],
    damping: float,
    course: FloatArray,
) -> int:
    """Fill the rows of `course` (3, steps) with time, force, velocity; return how many steps."""
    course[:, 0] = 0.0, 0.0, psi
    x, rate, cap = -phase * dt, 1.0, 0.0
    velocity, force = psi, 0.0
    touched = False
    for i in range(1, course.shape[1]):
        x, rate, cap = normal_step(dt, kicks, damping, x, rate, cap)
        velocity, force, _ = tangential_step(dt, kicks, kappa * dt, cap, velocity, force)
        course[0, i], course[1, i], course[2, i] = (i - phase) * dt, force, velocity
        if touched and (x <= 0.0 or (cap == 0.0 and rate < 0.0)):
            return i + 1
        touched = x > 0.0
    return int(course.shape[1])


def stepped_course(
    kappa: float,
    psi: float,
    steps: int,
    integrator: str = "velocity_verlet",
    phase: float = 0.0,
    damping: float = 0.0,
) -> FloatArray:
    """Return time, spring force and velocity at the touch and at the end of each step.

    Parameters as of `step_collisions`, ψ positive and finite.

    Returns
    -------
    ndarray, shape (3, steps taken + 1)
        Time since the touch; κz/m, positive for a stretched spring; u/m. Scaled, m = μ/α.
    """
    course = np.empty((3, most_steps(steps) + 1))
    dt = contact_duration(damping) / steps
    used = _record(kappa, max(psi, WEAKEST), dt, phase, INTEGRATORS[integrator], damping, course)
    return course[:, :used]
