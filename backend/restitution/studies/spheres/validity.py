"""Where a collision of real bodies leaves the model."""

import math
from dataclasses import dataclass

from restitution.studies.spheres.contact import Contact, Scales
from restitution.studies.spheres.powers import product_of_powers

LARGEST_COMPRESSION = 0.05
"""Of the smaller radius; beyond it Hertz's law is off by about as much."""

LARGEST_TURN = 0.05
"""Radians by which the normal may turn during the contact, mixing normal and tangential motion."""

YIELD_PRESSURE = 1.6
"""Largest pressure of a Hertz contact over the yield stress where plastic flow begins; J1985."""

FAR_FROM_MINDLIN = 3.0
"""Factor between the tangential stiffness and Mindlin's."""


@dataclass(frozen=True)
class Caution:
    """A reason to doubt the result: a word for programs and a sentence for people."""

    code: str
    text: str


def cautions(contact: Contact, at: Scales, crossing_velocity: float) -> list[Caution]:
    """Return where a collision leaves the model.

    Parameters
    ----------
    contact : Contact
        The bodies and their laws.
    at : Scales
        Their contact at the normal velocity of the impact.
    crossing_velocity : float
        Tangential part of the centres' relative velocity in m/s, 0 or more.
    """
    found = [
        _compression(at),
        _plastic_flow(contact, at),
        _turning_normal(at, crossing_velocity),
        _stiffness(at),
    ]
    return [caution for caution in found if caution]


def _compression(at: Scales) -> Caution | None:
    share = at.maximum_compression_m / min(at.pair.radii_m)
    if share <= LARGEST_COMPRESSION:
        return None
    return Caution(
        "compression",
        f"the bodies are compressed by {_short(100 * share)} % of the smaller radius; "
        "Hertz's law is for small compressions, up to about 5 %",
    )


def _plastic_flow(contact: Contact, at: Scales) -> Caution | None:
    stresses = [contact.body_1.yield_stress_pa, contact.body_2.yield_stress_pa]
    weakest = min((stress for stress in stresses if stress is not None), default=math.inf)
    # p = (2/π) E* a / R_eff with a = √(R_eff ξ), J1985
    pressure = product_of_powers(
        (2.0 / math.pi, 10),
        (at.pair.effective_modulus_pa, 10),
        (at.maximum_compression_m, 5),
        (at.pair.effective_radius_m, -5),
    )
    if pressure <= YIELD_PRESSURE * weakest:
        return None
    return Caution(
        "plastic_flow",
        f"the pressure reaches {_short(pressure)} Pa, {_short(pressure / weakest)} times the yield "
        "stress; from 1.6 times on the material flows, which the model does not know",
    )


def _turning_normal(at: Scales, crossing_velocity: float) -> Caution | None:
    distance = sum(at.pair.radii_m)
    turn = (crossing_velocity / distance) * at.contact_duration_s
    if turn <= LARGEST_TURN:
        return None
    return Caution(
        "oblique",
        f"the normal turns by {_short(turn)} rad during the contact, so oblique is the impact; the "
        "model keeps it fixed",
    )


def _stiffness(at: Scales) -> Caution | None:
    mindlin = at.mindlin_stiffness_n_per_m
    ratio = at.tangential_stiffness_n_per_m / mindlin if mindlin > 0.0 else math.inf
    if 1.0 / FAR_FROM_MINDLIN <= ratio <= FAR_FROM_MINDLIN:
        return None
    return Caution(
        "tangential_stiffness",
        f"the tangential stiffness is {_short(ratio)} times that of smooth elastic bodies at the "
        f"largest compression (Mindlin), {_short(mindlin)} N/m",
    )


def _short(value: float) -> str:
    """Return three digits as they are written by hand: 2,480, or 4.03e8."""
    mantissa, _, power = f"{float(f'{value:.3g}'):,g}".partition("e")
    return f"{mantissa}e{int(power)}" if power else mantissa
