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
    epsilon_in_lanes,
    follow,
    within_reach,
)
from restitution.mechanics.compiled import compiled
from restitution.mechanics.contact import (
    Contact,
    at_place,
    at_time,
    contact_duration,
    contact_of,
    expected_switches,
    rounding_bound,
)
from restitution.mechanics.hertz import FloatArray


@dataclass(frozen=True)
class Motion:
    """One collision, followed from switch to switch.

    Attributes
    ----------
    kappa, psi, damping : float
        Parameters; ψ within reach, see `within_reach`.
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
def _normal_curves(contact: Contact, time: FloatArray, curves: FloatArray) -> None:
    """Fill the rows x, ẋ, P of `curves` (3, N) at the times `time` (N,)."""
    for i in range(time.size):
        now = at_time(contact, time[i])
        curves[0, i] = now.root * now.root / contact.unit
        curves[1, i] = contact.last_rate + now.loss if now.falling else 1.0 - now.loss
        curves[2, i] = now.root * now.cap * contact.unit


def normal_curves(time: npt.ArrayLike, damping: float = 0.0) -> FloatArray:
    """Return compression, its rate and the normal force during a contact.

    Parameters
    ----------
    time : array_like, shape (...)
        Time since the first touch, scaled by t_scale; 0 … t_c.
    damping : float, optional
        η.

    Returns
    -------
    ndarray, shape (3, ...)
        x, ẋ and F_n, scaled by ξ_scale, g_n and m_eff ξ_scale / t_scale².

    Examples
    --------
    >>> x, rate, _ = normal_curves(0.5 * contact_duration(0.0))
    >>> bool(abs(x - 1.25**0.4) < 1e-15), bool(abs(rate) < 1e-15)
    (True, True)
    """
    contact = contact_of(damping)
    moments = np.asarray(time, dtype=np.float64)
    flat = np.ascontiguousarray(moments.ravel())
    if not np.all((flat >= 0) & (flat <= contact.duration / contact.unit)):
        raise AssertionError("a contact lasts from 0 to its duration")
    curves = np.empty((3, flat.size))
    _normal_curves(contact, flat, curves)
    return curves.reshape(3, *moments.shape)


@compiled
def _foresee(contact: Contact, kappa: float, psi: float) -> tuple[float, float]:
    """Return `expected_switches` and `rounding_bound`."""
    return expected_switches(contact, kappa, psi), rounding_bound(contact, kappa, psi)


@compiled
def _follow(
    contact: Contact,
    kappa: float,
    psi: float,
    episodes: npt.NDArray[np.void],
    passed: FloatArray,
    force: FloatArray,
) -> tuple[float, int, bool]:
    """Return what `follow` does; fill `passed` and the cap `force` at the episodes' beginnings."""
    epsilon_t, switches, certain = follow(contact, kappa, psi, episodes)
    for j in range(min(switches + 1, episodes.size)):
        begin = at_place(contact, episodes[j]["falling"], episodes[j]["q"])
        passed[j], force[j] = begin.passed, begin.root * begin.cap * contact.unit
    return epsilon_t, switches, certain


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
    contact = contact_of(damping)
    kappa, wanted = float(kappa), float(psi)
    psi = within_reach(contact, wanted)
    expected, bound = _foresee(contact, kappa, psi)
    if expected > most_switches or (bound >= 1.0 and psi < contact.impulse):
        raise CostError(
            f"kappa = {kappa:g} needs about {expected:.2g} switches, more than the "
            f"{most_switches:.6g} that are followed"
        )
    room = int(expected) + 2
    while True:
        episodes, passed, force = np.zeros(room, EPISODE), np.empty(room), np.empty(room)
        epsilon_t, switches, certain = _follow(contact, kappa, wanted, episodes, passed, force)
        if switches < room:
            break
        room = switches + 1
    # in a list it has the same, to the last digit
    in_lanes = epsilon_in_lanes(contact, kappa, wanted, bound)
    epsilon_t = epsilon_t if in_lanes is None else in_lanes
    episodes, passed = episodes[: switches + 1], passed[: switches + 1]
    start = np.where(episodes["falling"], contact.duration - passed, passed) / contact.unit
    return Motion(
        kappa,
        psi,
        damping,
        episodes,
        start,
        force[: switches + 1],
        epsilon_t,
        bool(certain),
        bound,
    )


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
    for k in range(j, switch_times.size):
        time[samples + k] = switch_times[k]
    return time


@compiled
def _tangential_curves(
    contact: Contact,
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
            begin = at_place(contact, episodes[j]["falling"], episodes[j]["q"])
            u0, side = episodes[j]["velocity"], float(episodes[j]["side"])
            p0 = side * (begin.root * begin.cap * contact.unit)
        now = at_time(contact, time[i])
        cap = now.cap * (now.root * contact.unit)
        if episodes[j]["sliding"]:
            if now.falling != begin.falling:
                gain = now.loss + begin.loss - contact.impulse
            else:
                gain = now.loss - begin.loss if now.falling else begin.loss - now.loss
            curves[0, i] = (u0 + side * gain) / psi
            curves[1, i] = side * cap / kappa / psi
            curves[2, i] = side * cap
            regime[i] = episodes[j]["side"]
        else:
            if now.falling != begin.falling:
                elapsed = contact.duration - now.passed - begin.passed
            else:
                elapsed = begin.passed - now.passed if now.falling else now.passed - begin.passed
            phase = omega * elapsed / contact.unit
            sine, cosine = math.sin(phase), math.cos(phase)
            pull = p0 * cosine + omega * u0 * sine
            curves[0, i] = (u0 * cosine - p0 / omega * sine) / psi
            curves[1, i] = (p0 / kappa * cosine + u0 / omega * sine) / psi
            curves[2, i] = math.copysign(min(abs(pull), cap), pull)
            regime[i] = 0


def tangential_curves(collision: Motion, time: FloatArray) -> TangentialCurves:
    """Return the tangential motion at the ascending instants `time` (N,), 0 … t_c.

    An instant of a switch belongs to the episode that begins there.
    """
    curves = np.empty((3, time.size))
    regime = np.empty(time.size, np.int8)
    _tangential_curves(
        contact_of(collision.damping),
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
