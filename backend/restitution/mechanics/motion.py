"""The collision in time: episodes, the motion at any instant, turns, sensitivity.

As in `collision`, z and u are the paper's divided by μ/α. What is returned is further divided by
u(0) = ψ, and so neither overflows nor underflows.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import (
    EPISODE,
    MOST_SWITCHES,
    WEAKEST,
    expected_switches,
    follow,
    rounding_bound,
)
from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped import (
    STRONGEST,
    damped_rounding_bound,
    expected_damped_switches,
)
from restitution.mechanics.damped_curves import damped_episodes, damped_tangential_curves
from restitution.mechanics.hertz import CONTACT_DURATION, HALF_CONTACT, FloatArray, normal_motion
from restitution.mechanics.viscoelastic import contact_duration, normal_contact


@dataclass(frozen=True)
class Motion:
    """One collision, followed from switch to switch.

    Attributes
    ----------
    kappa, psi, damping : float
        Parameters; ψ at least `collision.WEAKEST`.
    episodes : ndarray of `EPISODE`, shape (switches + 1,)
        Beginning of each episode.
    start : ndarray, shape (switches + 1,)
        Instants of these beginnings, scaled by t_scale; the first is 0.
    force : ndarray, shape (switches + 1,)
        |κz| at these beginnings.
    epsilon_t, switches_certain, error_bound
        As in `collision.Collision`.
    """

    kappa: float
    psi: float
    damping: float
    episodes: npt.NDArray[np.void]
    start: FloatArray
    force: FloatArray
    epsilon_t: float
    switches_certain: bool
    error_bound: float

    @property
    def switches(self) -> int:
        """Number of changes of regime."""
        return self.episodes.size - 1

    @property
    def duration(self) -> float:
        """Duration of the contact."""
        return contact_duration(self.damping)

    @property
    def end(self) -> FloatArray:
        """Instants at which the episodes end; the last is the end of the contact."""
        return np.append(self.start[1:], self.duration)

    @property
    def direction(self) -> npt.NDArray[np.int8]:
        """Sign of the spring in sliding episodes, 0 in sticking ones."""
        direction: npt.NDArray[np.int8] = np.where(
            self.episodes["sliding"], self.episodes["side"], 0
        ).astype(np.int8)
        return direction


class TangentialCurves(NamedTuple):
    """Tangential motion at given instants; arrays of shape (N,)."""

    velocity: FloatArray
    """u(t)/ψ."""
    elongation: FloatArray
    """z(t)/ψ, in units of t_scale times the velocity."""
    force: FloatArray
    """|F| with the sign of z, F = min(x^{3/2}, κ|z|); not divided by ψ."""
    regime: npt.NDArray[np.int8]
    """Sign of z while sliding, 0 while sticking."""


@compiled
def _caps(episodes: npt.NDArray[np.void], force: FloatArray) -> None:
    for j in range(force.size):
        root, _ = normal_motion(episodes[j]["q"])
        force[j] = root * root * root


def motion(
    kappa: float, psi: float, most_switches: float = MOST_SWITCHES, damping: float = 0.0
) -> Motion:
    """Return the collision episode by episode.

    Parameters
    ----------
    kappa, psi : float
        Positive and finite.
    most_switches : float, optional
        More expected switches than these are refused.
    damping : float, optional
        η.

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If the collision is too stiff to be followed.

    Examples
    --------
    >>> motion(18.0, 0.3).switches
    4
    """
    for name, value in (("kappa", kappa), ("psi", psi)):
        if not 0.0 < value < math.inf:
            raise ParameterError(name, value, "positive and finite")
    kappa, psi = float(kappa), max(float(psi), WEAKEST)
    if damping:
        contact = normal_contact(damping)
        psi = min(psi, STRONGEST)
        expected = expected_damped_switches(contact, kappa, psi)
        bound, impulse = damped_rounding_bound(contact, kappa, psi), contact.impulse
    else:
        expected, bound, impulse = expected_switches(kappa, psi), rounding_bound(kappa, psi), 2.0
    if expected > most_switches or (bound >= 1.0 and psi < impulse):
        raise CostError(
            f"kappa = {kappa:g} needs about {expected:.2g} switches, more than the "
            f"{most_switches:.6g} that are followed"
        )
    room = int(expected) + 2
    if damping:
        episodes, start, force, epsilon_t, certain = damped_episodes(kappa, psi, damping, room)
        return Motion(kappa, psi, damping, episodes, start, force, epsilon_t, bool(certain), bound)
    while True:
        episodes = np.zeros(room, dtype=EPISODE)
        epsilon_t, switches, certain = follow(kappa, psi, episodes)
        if switches < room:
            break
        room = switches + 1
    episodes = episodes[: switches + 1]
    square = episodes["q"] ** 2
    start = np.where(episodes["decompressing"], CONTACT_DURATION - square, square)
    force = np.empty(start.size)
    _caps(episodes, force)
    return Motion(kappa, psi, 0.0, episodes, start, force, epsilon_t, bool(certain), bound)


@compiled
def instants(duration: float, samples: int, switch_times: FloatArray) -> FloatArray:
    """Return `samples` uniform instants from 0 to `duration`, merged with the switches (N,)."""
    time = np.empty(samples + switch_times.size)
    step = duration / (samples - 1)
    j = 0
    for i in range(samples):
        uniform = duration if i == samples - 1 else i * step
        while j < switch_times.size and switch_times[j] < uniform:
            time[i + j] = switch_times[j]
            j += 1
        time[i + j] = uniform
    time[samples + j :] = switch_times[j:]
    return time


@compiled
def _tangential_curves(
    kappa: float,
    psi: float,
    episodes: npt.NDArray[np.void],
    start: FloatArray,
    time: FloatArray,
    curves: FloatArray,
    regime: npt.NDArray[np.int8],
) -> None:
    """Fill the rows u/ψ, z/ψ, F of `curves` (3, N) at the ascending instants `time` (N,)."""
    omega = math.sqrt(kappa)
    j = -1
    for i in range(time.size):
        while j + 1 < start.size and time[i] >= start[j + 1]:
            j += 1
            q0, side = episodes[j]["q"], float(episodes[j]["side"])
            root0, loss0 = normal_motion(q0)
            u0, rising0 = episodes[j]["velocity"], not episodes[j]["decompressing"]
            p0 = side * root0 * root0 * root0
        rising = time[i] <= HALF_CONTACT
        square = time[i] if rising else max(0.0, CONTACT_DURATION - time[i])
        root, loss = normal_motion(math.sqrt(square))
        cap = root * root * root
        if episodes[j]["sliding"]:
            if rising != rising0:
                gain = loss + loss0 - 2.0
            else:
                gain = loss0 - loss if rising else loss - loss0
            curves[0, i] = (u0 + side * gain) / psi
            curves[1, i] = side * cap / kappa / psi
            curves[2, i] = side * cap
            regime[i] = episodes[j]["side"]
        else:
            if rising != rising0:
                elapsed = time[i] - start[j]
            else:
                elapsed = square - q0 * q0 if rising else q0 * q0 - square
            sine, cosine = math.sin(omega * elapsed), math.cos(omega * elapsed)
            force = p0 * cosine + omega * u0 * sine
            curves[0, i] = (u0 * cosine - p0 / omega * sine) / psi
            curves[1, i] = (p0 / kappa * cosine + u0 / omega * sine) / psi
            curves[2, i] = math.copysign(min(abs(force), cap), force)
            regime[i] = 0


def tangential_curves(collision: Motion, time: FloatArray) -> TangentialCurves:
    """Return the tangential motion at the ascending instants `time` (N,), 0 … t_c.

    An instant of a switch belongs to the episode that begins there.
    """
    if collision.damping:
        curves, regime = damped_tangential_curves(
            collision.damping,
            (collision.kappa, collision.psi),
            (collision.episodes, collision.start, collision.force),
            time,
        )
        return TangentialCurves(curves[0], curves[1], curves[2], regime)
    curves = np.empty((3, time.size))
    regime = np.empty(time.size, np.int8)
    _tangential_curves(
        collision.kappa,
        collision.psi,
        collision.episodes,
        collision.start,
        np.ascontiguousarray(time, dtype=np.float64),
        curves,
        regime,
    )
    return TangentialCurves(curves[0], curves[1], curves[2], regime)


@compiled
def _reversals(
    kappa: float,
    episodes: npt.NDArray[np.void],
    start: FloatArray,
    force: FloatArray,
    duration: float,
    last_velocity: float,
) -> int:
    """Return how often u changes its sign."""
    omega = math.sqrt(kappa)
    count = 0
    for j in range(start.size):
        u0 = episodes[j]["velocity"]
        final = j + 1 == start.size
        if episodes[j]["sliding"]:
            u1 = last_velocity if final else episodes[j + 1]["velocity"]
            # a velocity of exactly 0 has not turned
            count += (u0 > 0.0 and u1 < 0.0) or (u0 < 0.0 and u1 > 0.0)
        else:
            lag = math.atan2(episodes[j]["side"] * force[j] / omega, u0)
            phase = omega * ((duration if final else start[j + 1]) - start[j]) + lag
            count += math.floor(phase / math.pi + 0.5) - math.floor(lag / math.pi + 0.5)
    return count


def reversals(collision: Motion) -> int:
    """Return the number of sign changes of the surface velocity within the contact."""
    return int(
        _reversals(
            collision.kappa,
            collision.episodes,
            collision.start,
            collision.force,
            collision.duration,
            collision.epsilon_t * collision.psi,
        )
    )


@compiled
def _sensitivity(
    kappa: float,
    psi: float,
    episodes: npt.NDArray[np.void],
    start: FloatArray,
    force: FloatArray,
) -> tuple[float, float]:
    """Return κ ∂(u(t_c)/ψ)/∂κ and ∂u(t_c)/∂ψ."""
    omega = math.sqrt(kappa)
    by_kappa, by_psi = 0.0, 1.0
    for j in range(start.size):
        if episodes[j]["sliding"]:
            continue
        u0 = episodes[j]["velocity"] / psi
        w0 = episodes[j]["side"] * force[j] / omega / psi
        angle = omega * (start[j + 1] - start[j])
        sine, cosine = math.sin(angle), math.cos(angle)
        by_kappa = by_kappa * cosine + 0.5 * (w0 * sine - angle * (u0 * sine + w0 * cosine))
        by_psi *= cosine
    return by_kappa, by_psi


def sensitivity(collision: Motion) -> tuple[float, float]:
    """Return ∂ε_t/∂ln κ at fixed ψ and ∂ε_t/∂ln ψ at fixed κ.

    Notes
    -----
    A shifted switch changes nothing to first order, for the force is continuous there. A change
    of u therefore passes sliding as it is and sticking times cos ωΔt: ∂u(t_c)/∂ψ = ∏ cos ωΔt_i.
    A change of κ acts in sticking only, on the frequency and on z = s x^{3/2}/κ at its beginning.
    """
    by_kappa, by_psi = _sensitivity(
        collision.kappa, collision.psi, collision.episodes, collision.start, collision.force
    )
    return float(by_kappa), float(by_psi - collision.epsilon_t)
