"""The damped collision in time: normal and tangential motion at any instant, see `motion`.

Times, lengths and forces go in and come out scaled as in `hertz`, whatever units the contact has.
"""

import math

import numpy as np
import numpy.typing as npt

from restitution.mechanics.collision import EPISODE
from restitution.mechanics.compiled import compiled
from restitution.mechanics.damped import follow_damped
from restitution.mechanics.damped_normal_motion import Contact, damped_motion, rate_at
from restitution.mechanics.damped_sliding import at_time, place
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.viscoelastic import normal_contact


@compiled
def half_and_place(contact: Contact, time: float) -> tuple[bool, float]:
    """Return the half and q at a time scaled by t_scale."""
    moment = time * contact.unit
    if moment <= contact.peak_time:
        return at_time(contact, moment)
    return True, place(contact, True, contact.duration - moment)


@compiled
def _normal_curves(contact: Contact, time: FloatArray, curves: FloatArray) -> None:
    for i in range(time.size):
        falling, q = half_and_place(contact, time[i])
        root, cap, loss, _ = damped_motion(contact, falling, q)
        curves[0, i] = root * root / contact.unit
        curves[1, i] = rate_at(contact, falling, loss)
        curves[2, i] = root * cap * contact.unit


def damped_normal_curves(damping: float, time: FloatArray) -> FloatArray:
    """Return x, ẋ and the normal force (3, N) at the instants `time` (N,), 0 … t_c, for η > 0."""
    curves = np.empty((3, time.size))
    _normal_curves(normal_contact(damping), np.ascontiguousarray(time, dtype=np.float64), curves)
    return curves


@compiled
def _beginnings(
    contact: Contact, episodes: npt.NDArray[np.void], start: FloatArray, force: FloatArray
) -> None:
    for j in range(start.size):
        falling = episodes[j]["decompressing"]
        root, cap, _, time = damped_motion(contact, falling, episodes[j]["q"])
        start[j] = (contact.duration - time if falling else time) / contact.unit
        force[j] = root * cap * contact.unit
    # the spring is at rest when the contact begins, and so is the force
    force[0] = 0.0


def damped_episodes(
    kappa: float, psi: float, damping: float, room: int
) -> tuple[npt.NDArray[np.void], FloatArray, FloatArray, float, bool]:
    """Return episodes, instants and forces of their beginnings, ε_t and certainty for η > 0.

    Parameters as of `damped.follow_damped`; `room` is how many episodes are expected.
    """
    contact = normal_contact(damping)
    while True:
        episodes = np.zeros(room, dtype=EPISODE)
        epsilon_t, switches, certain = follow_damped(contact, kappa, psi, episodes)
        if switches < room:
            break
        room = switches + 1
    episodes = episodes[: switches + 1]
    start, force = np.empty(episodes.size), np.empty(episodes.size)
    _beginnings(contact, episodes, start, force)
    return episodes, start, force, epsilon_t, certain


@compiled
def _tangential_curves(
    contact: Contact,
    kappa: float,
    psi: float,
    episodes: npt.NDArray[np.void],
    start: FloatArray,
    force: FloatArray,
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
            falling0, side = episodes[j]["decompressing"], float(episodes[j]["side"])
            _, _, loss0, passed0 = damped_motion(contact, falling0, episodes[j]["q"])
            u0, p0 = episodes[j]["velocity"], side * force[j]
        falling, q = half_and_place(contact, time[i])
        root, cap, loss, passed = damped_motion(contact, falling, q)
        cap *= root * contact.unit
        if episodes[j]["sliding"]:
            if falling != falling0:
                gain = loss + loss0 - contact.impulse
            else:
                gain = loss - loss0 if falling else loss0 - loss
            curves[0, i] = (u0 + side * gain) / psi
            curves[1, i] = side * cap / kappa / psi
            curves[2, i] = side * cap
            regime[i] = episodes[j]["side"]
        else:
            if falling != falling0:
                elapsed = contact.duration - passed - passed0
            else:
                elapsed = passed0 - passed if falling else passed - passed0
            phase = omega * elapsed / contact.unit
            sine, cosine = math.sin(phase), math.cos(phase)
            pull = p0 * cosine + omega * u0 * sine
            curves[0, i] = (u0 * cosine - p0 / omega * sine) / psi
            curves[1, i] = (p0 / kappa * cosine + u0 / omega * sine) / psi
            curves[2, i] = math.copysign(min(abs(pull), cap), pull)
            regime[i] = 0


def damped_tangential_curves(
    damping: float,
    parameters: tuple[float, float],
    course: tuple[npt.NDArray[np.void], FloatArray, FloatArray],
    time: FloatArray,
) -> tuple[FloatArray, npt.NDArray[np.int8]]:
    """Return u/ψ, z/ψ, F as rows (3, N), and regimes (N,), at the ascending instants `time`.

    `parameters` are κ and ψ, `course` the first three results of `damped_episodes`.
    """
    curves = np.empty((3, time.size))
    regime = np.empty(time.size, np.int8)
    moments = np.ascontiguousarray(time, dtype=np.float64)
    kappa, psi = parameters
    episodes, start, force = course
    _tangential_curves(
        normal_contact(damping), kappa, psi, episodes, start, force, moments, curves, regime
    )
    return curves, regime
