"""A collision at any instant: velocity, spring, force, energy, and instants to look at.

As in `collision`, z and u are the paper's divided by μ/α. Curves are further divided by u(0) = ψ,
and so neither overflow nor underflow; columns are in the units of the service.
"""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import EPISODE, within_reach
from restitution.mechanics.compiled import compiled
from restitution.mechanics.contact import Contact, at_place, at_time, contact_of
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.motion import Motion
from restitution.mechanics.scaled_velocity import psi_of


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
def _tangential_columns(
    contact: Contact,
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    episodes: npt.NDArray[np.void],
    start: FloatArray,
    time: FloatArray,
    cap: FloatArray,
    columns: FloatArray,
    regime: npt.NDArray[np.int8],
) -> None:
    """Fill the rows of `columns` (4, N) as `tangential_columns` returns them."""
    psi, omega = psi_of(mu_over_alpha, gt_over_gn), math.sqrt(kappa)
    reached, has_spring = within_reach(contact, psi), 0.0 < psi < math.inf
    if has_spring:
        _tangential_curves(contact, kappa, reached, episodes, start, time, columns[:3], regime)
    # a collision weaker than the one that was followed has proportionally weaker forces
    weaker = min(1.0, psi / reached)
    for i in range(time.size):
        if has_spring:
            velocity, elongation = gt_over_gn * columns[0, i], gt_over_gn * columns[1, i]
            force = columns[2, i] * weaker
        elif psi == 0.0:
            velocity, elongation, force, regime[i] = 0.0, 0.0, 0.0, 0
        else:
            velocity, force, regime[i] = gt_over_gn, cap[i], 1
            stretch, most = cap[i] / kappa * mu_over_alpha, gt_over_gn * time[i]
            # 0 where it is the product of μ = 0 and what overflows
            elongation = min(0.0 if math.isnan(stretch) else stretch, most)
        columns[0, i], columns[1, i], columns[2, i] = velocity, elongation, 0.0 - force
        swing = omega * elongation
        columns[3, i] = 0.5 * (velocity * velocity + swing * swing)


def tangential_columns(
    collision: Motion | None,
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    damping: float,
    time: FloatArray,
    cap: FloatArray,
) -> tuple[FloatArray, npt.NDArray[np.int8]]:
    """Return g_t(t)/g_n, the elongation, F_t/μ and the tangential energy (4, N), and the regime.

    They are formed from u/u(0) and z/u(0), so that no product leaves the double range on the way;
    one that is beyond it is infinite.

    Parameters
    ----------
    collision : Motion, or None
        None for ψ = 0 and ψ = ∞, which have no spring.
    kappa, mu_over_alpha, gt_over_gn, damping : float
        Its parameters.
    time, cap : ndarray, shape (N,)
        Ascending instants, 0 … t_c, and x^{3/2} there.
    """
    columns, regime = np.empty((4, time.size)), np.empty(time.size, np.int8)
    nothing = np.empty(0, EPISODE), np.empty(0)
    episodes, start = nothing if collision is None else (collision.episodes, collision.start)
    _tangential_columns(
        *(contact_of(damping), kappa, mu_over_alpha, gt_over_gn, episodes, start),
        *(time, np.ascontiguousarray(cap), columns, regime),
    )
    return columns, regime
