"""A collision followed from switch to switch: its episodes, turns, sensitivity, lost energy.

As in `collision`, z and u are the paper's divided by μ/α; `curves` has them at any instant.
"""

import math
from dataclasses import dataclass

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


@compiled
def dissipated_share(epsilon_t: float) -> float:
    """Return the share of the tangential energy that is lost, 1 − ε_t²."""
    return (1.0 - epsilon_t) * (1.0 + epsilon_t)


MASS_SHARES = {"wall": 1.0, "sphere": 0.5}
"""m_eff/m of the ball: its share of a relative velocity in the frame of the centre of mass."""


@compiled
def impulse_shares(alpha: float, mass_share: float) -> tuple[float, float]:
    """Return what of (1 − ε_t) g_t a ball's centre and its Rω change by (Eqs. 13, 14).

    `mass_share` is m_eff/m. The impulse is that at the point of contact, so that α of a change of
    g_t is one of the centres and 1 − α one of the spins.
    """
    return -alpha * mass_share, (1.0 - alpha) * mass_share
