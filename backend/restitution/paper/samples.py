"""The collisions by which statements are judged; every one is seeded and computed once."""

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.errors import CostError
from restitution.mechanics.collision import Collision, collide
from restitution.mechanics.contact import normal_curves
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import sliding_threshold
from restitution.mechanics.motion import Motion, motion
from restitution.mechanics.stepping import INTEGRATORS, tangential_step
from restitution.methods.ode import integrate
from restitution.studies.collision.presets import SOLID
from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.contact import Contact, scales

SEED = 2008

ROUNDING = 1e-11
"""What is equal up to rounding: sums of some thousand terms of order 1, each right to 1e-16."""

SLOPE = 1e-6
"""Of a difference quotient of fourth order over a five-hundredth of an episode, in its scale."""

SOLVER = 1e-5
"""Of an adaptive solver asked for 1e-8 in each step, after some hundred steps."""

PRINTED_KAPPA = 18.0
"""κ of Figs. 4 and 5 as their captions have it."""

KAPPA = PRINTED_KAPPA / SOLID
"""The same taken for ακ, as the sequence of switches in the text demands."""

FRICTION = 0.4
"""μ of Figs. 1, 2 and 4."""

MU_OVER_ALPHA = FRICTION / SOLID

STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
STIFFNESS = 1e12
"""Spheres and k_t in N/m of Fig. 2."""


def steel(
    friction: float = FRICTION, stiffness: float = STIFFNESS, damping: float = 0.0
) -> Contact:
    """Return the contact of Fig. 2; `damping` is A in s."""
    return Contact(STEEL, STEEL, friction, stiffness, damping)


@functools.cache
def mindlin_kappa() -> float:
    """Return κ of Mindlin's stiffness for the steel, whatever its size and speed."""
    return scales(Contact(STEEL, STEEL, FRICTION, "mindlin"), 1.0).kappa


ZOOMS = 6
"""Each narrows a range sixteenfold: after them a place is known to 1e-7 of its first spacing."""


def maximum(
    values: Callable[..., FloatArray], *axes: FloatArray
) -> tuple[float, tuple[float, ...]]:
    """Return the largest of `values` over ranges, and where it is.

    Parameters
    ----------
    values : callable
        Of arrays of one shape, one for each axis.
    *axes : ndarray, shape (N,)
        Ascending, and so close that the highest peak has a point of its own.
    """
    top, where = -np.inf, tuple(float(axis[0]) for axis in axes)
    for _ in range(ZOOMS):
        found = values(*np.meshgrid(*axes, indexing="ij"))
        best = [int(i) for i in np.unravel_index(int(np.argmax(found)), found.shape)]
        top = float(np.max(found))
        where = tuple(float(axis[i]) for axis, i in zip(axes, best, strict=True))
        axes = tuple(
            np.linspace(axis[max(i - 1, 0)], axis[min(i + 1, axis.size - 1)], 33)
            for axis, i in zip(axes, best, strict=True)
        )
    return top, where


def last(holds: Callable[[FloatArray], npt.NDArray[np.bool_]], axis: FloatArray) -> float:
    """Return up to where something holds, by points (N,) that are closer than where it does not."""
    for _ in range(ZOOMS):
        at = int(np.flatnonzero(holds(axis))[-1])
        axis = np.linspace(axis[at], axis[min(at + 1, axis.size - 1)], 17)
    return float(axis[0])


def means(
    values: Callable[[FloatArray], FloatArray], low: float, high: float
) -> tuple[float, float]:
    """Return the mean and the standard deviation of `values` over an interval, taken evenly.

    The 8000 points are closer where the interval begins, for ε_t swings the more often there.
    """
    edges = np.geomspace(low, high, 8001)
    found = values(np.sqrt(edges[1:] * edges[:-1]))
    weights = np.diff(edges)
    mean = float(np.average(found, weights=weights))
    return mean, float(np.sqrt(np.average((found - mean) ** 2, weights=weights)))


def over_psi(kappa: float) -> Callable[[FloatArray], FloatArray]:
    """Return ε_t of a κ as a function of ψ (N,)."""
    return lambda psi: collide(kappa, psi).epsilon_t


def soft_border(psi: float) -> float:
    """Return κ below which a collision with ψ > 2 sticks for a while."""
    return last(lambda kappas: sliding_threshold(kappas) > psi, np.linspace(0.02, 0.6, 600))


class Many(NamedTuple):
    """Random collisions; arrays (N,)."""

    kappa: FloatArray
    psi: FloatArray
    result: Collision


@functools.cache
def many() -> Many:
    """Return 20,000 collisions, κ in .05…1000 and ψ in .003…3, both log-uniform."""
    random = np.random.default_rng(SEED)
    kappa = 10.0 ** random.uniform(np.log10(0.05), 3.0, 20_000)
    psi = 10.0 ** random.uniform(np.log10(0.003), np.log10(3.0), 20_000)
    return Many(kappa, psi, collide(kappa, psi))


@functools.cache
def motions(damping: float = 0.0, count: int = 60) -> tuple[Motion, ...]:
    """Return the course of random collisions, κ in .5…400 and ψ in .02…2.2, both log-uniform."""
    random = np.random.default_rng(SEED)
    kappas = 10.0 ** random.uniform(np.log10(0.5), np.log10(400.0), count)
    psis = 10.0 ** random.uniform(np.log10(0.02), np.log10(2.2), count)
    return tuple(
        motion(kappa, psi, damping=damping)
        for kappa, psi in zip(kappas.tolist(), psis.tolist(), strict=True)
    )


def normal(damping: float, time: FloatArray) -> FloatArray:
    """Return x, ẋ and the normal force (3, N) at `time` (N,)."""
    return normal_curves(time, damping)


def slope(
    curve: Callable[[FloatArray], FloatArray], time: FloatArray, step: FloatArray
) -> FloatArray:
    """Return the derivative of `curve` at `time` by a difference quotient of fourth order."""
    near = curve(time + step) - curve(time - step)
    far = curve(time + 2.0 * step) - curve(time - 2.0 * step)
    return (8.0 * near - far) / (12.0 * step)


class Moments(NamedTuple):
    """Instants within the episodes of a collision; arrays (N,), z and u divided by μ/α."""

    psi: float
    kappa: float
    time: FloatArray
    normal_force: FloatArray
    velocity: FloatArray
    elongation: FloatArray
    force: FloatArray
    sliding: FloatArray
    """Sign of the spring while sliding, else 0."""
    acceleration: FloatArray
    """u̇, by differences."""
    spring_rate: FloatArray
    """ż, by differences."""


def _moments(course: Motion) -> Moments:
    lengths = course.end - course.start
    lasting = lengths > 1e-3
    begin, length = course.start[lasting], lengths[lasting]
    time = (begin[:, None] + length[:, None] * np.array([0.3, 0.5, 0.7])).ravel()
    step = np.repeat(np.minimum(length / 500.0, 3e-3 / np.sqrt(1.0 + course.kappa)), 3)

    def velocity(at: FloatArray) -> FloatArray:
        return course.psi * tangential_curves(course, at).velocity

    def elongation(at: FloatArray) -> FloatArray:
        return course.psi * tangential_curves(course, at).elongation

    curves = tangential_curves(course, time)
    return Moments(
        course.psi,
        course.kappa,
        time,
        normal(course.damping, time)[2],
        course.psi * curves.velocity,
        course.psi * curves.elongation,
        curves.force,
        np.asarray(curves.regime, dtype=float),
        slope(velocity, time, step),
        slope(elongation, time, step),
    )


@functools.cache
def moments(damping: float = 0.0) -> tuple[Moments, ...]:
    """Return instants within the episodes of `motions`."""
    return tuple(map(_moments, motions(damping)))


def largest(values: Callable[[Moments], FloatArray], damping: float = 0.0) -> float:
    """Return the largest of some `values` over all `moments`."""
    return max(float(np.max(values(at), initial=0.0)) for at in moments(damping))


def stepped(
    kappa: float, velocity: float, dts: FloatArray, caps: FloatArray
) -> tuple[float, npt.NDArray[np.bool_]]:
    """Return u at the end of given steps (N,) under given caps (N,), and where it was at the cap.

    The caps are those at the ends of the steps, with μ/α in them; z and u are not divided by it.
    """
    kicks = INTEGRATORS["velocity_verlet"]
    force, capped = 0.0, np.empty(dts.size, np.bool_)
    for i, (dt, cap) in enumerate(zip(dts.tolist(), caps.tolist(), strict=True)):
        velocity, force, capped[i] = tangential_step(dt, kicks, kappa * dt, cap, velocity, force)
    return velocity, capped


class Solved(NamedTuple):
    """Collisions by the general solver and exactly; arrays (N,)."""

    kappa: FloatArray
    psi: FloatArray
    solver: FloatArray
    exact: FloatArray


SOLVED = ((63.0, 0.97), (63.0, 0.17), (5.0, 0.5), (18.0, 1.2))
"""κ and ψ of the collisions that the general solver is asked for: 4, 4, 6 and 8 switches."""


@functools.cache
def solved(spring: str = "events") -> Solved:
    """Return collisions by an adaptive solver that knows nothing of closed forms.

    `spring` as of `methods.ode.integrate`: ``events`` or ``held`` for one that is held at the cap,
    ``free`` for the one of Eq. 23 as printed.
    """
    kappa, psi = np.array(SOLVED).T
    found = [_solution(k, p, spring) for k, p in SOLVED]
    return Solved(kappa, psi, np.array(found), collide(kappa, psi).epsilon_t)


def _solution(kappa: float, psi: float, spring: str) -> float:
    try:
        return integrate(kappa, psi, 1e-8, spring).epsilon_t  # type: ignore[arg-type]
    except CostError:
        return np.nan
