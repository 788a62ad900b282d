"""Where a collision of real bodies leaves the model."""

import math
from dataclasses import dataclass

from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.contact import Contact, Scales
from restitution.studies.spheres.powers import product_of_powers
from restitution.studies.spheres.turning import Turned

LARGEST_COMPRESSION = 0.05
"""Of the smaller radius; beyond it Hertz's law is off by about as much."""

LARGEST_CHANGE = 0.01
"""Of g_n and of g_t: what the velocities after an impact may owe to the fixed normal."""

YIELD_PRESSURE = 1.6
"""Largest pressure of a Hertz contact over the yield stress where plastic flow begins; J1985."""

FAR_FROM_MINDLIN = 3.0
"""Factor between the tangential stiffness and Mindlin's."""


@dataclass(frozen=True)
class Caution:
    """A reason to doubt the result: a word for programs and a sentence for people.

    Attributes
    ----------
    code, text : str
        The word and the sentence, in English.
    values : mapping of str to float or None
        The numbers of the sentence, in SI units, for those who say it in another language; None
        where one is beyond double precision.
    """

    code: str
    text: str
    values: dict[str, float | None]


def cautions(
    contact: Contact, at: Scales, let_turn: Turned, tangential_velocity: float
) -> list[Caution]:
    """Return where a collision leaves the model.

    Parameters
    ----------
    contact : Contact
        The bodies and their laws.
    at : Scales
        Their contact at the normal velocity of the impact.
    let_turn : Turned
        What a turning normal would change.
    tangential_velocity : float
        g_t in m/s, 0 or more.
    """
    found = [
        _compression(at),
        _plastic_flow(contact, at),
        _turning_normal(let_turn, tangential_velocity),
        _stiffness(at),
        _hollow(contact),
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
        _held(share=share),
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
        _held(pressure_pa=pressure, over_yield_stress=pressure / weakest),
    )


def _turning_normal(let_turn: Turned, tangential_velocity: float) -> Caution | None:
    angle, lost, moved = let_turn
    if lost <= LARGEST_CHANGE and moved <= LARGEST_CHANGE * tangential_velocity:
        return None
    # beyond that ε_t, over so small a velocity before, says nothing
    of_epsilon = moved <= 10.0 * tangential_velocity
    moves = (
        {"epsilon_t_change": moved / tangential_velocity}
        if of_epsilon
        else {"tangential_velocity_m_s": moved}
    )
    sideways = (
        f"move ε_t by up to {_short(moved / tangential_velocity, 2)}"
        if of_epsilon
        else f"leave a tangential velocity of up to {_short(moved, 2)} m/s"
    )
    return Caution(
        "oblique",
        f"the normal, which the model keeps fixed, turns by {_short(angle, 2)} rad during the "
        f"contact: let turn, it would take about {_short(lost, 2)} from ε_n, seen along the first "
        f"normal, and {sideways}",
        _held(angle_rad=angle, epsilon_n_change=lost, **moves),
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
        _held(over_mindlin=ratio, mindlin_n_per_m=mindlin),
    )


def _hollow(contact: Contact) -> Caution | None:
    shells = [
        body
        for body in (contact.body_1, contact.body_2)
        if isinstance(body, Sphere) and body.inertia == "hollow"
    ]
    if not shells:
        return None
    return Caution(
        "hollow",
        "a hollow sphere has the moment of inertia of a thin shell, but the contact of a solid "
        "body (Hertz): a shell gives way by bending, too, and is softer",
        {},
    )


def _held(**values: float) -> dict[str, float | None]:
    return {name: value if math.isfinite(value) else None for name, value in values.items()}


def _short(value: float, digits: int = 3) -> str:
    """Return some digits as they are written by hand: 2,480, or 4.03e8."""
    if math.isinf(value):
        return "more than 1.8e308"
    mantissa, _, power = f"{float(f'{value:.{digits}g}'):,g}".partition("e")
    return f"{mantissa}e{int(power)}" if power else mantissa
