"""One collision of real bodies: from materials and velocities to ε_t, and back to velocities."""

import math
from dataclasses import dataclass
from typing import Annotated

from restitution.bounds import Meaning
from restitution.methods.answer import AnsweringMethod, EpsilonT, ErrorBound, ToleranceMet
from restitution.methods.options import Options
from restitution.quantities import QUANTITIES
from restitution.studies.collision.one import CollisionStudy, study_collision
from restitution.studies.collision.parameters import CONVENTION, CollisionParameters, Convention
from restitution.studies.spheres.contact import Contact, friction_over_alpha, scales, velocity_ratio
from restitution.studies.spheres.impact import (
    After,
    Crossing,
    Impact,
    SpeedAndAngle,
    Velocities,
    after_impact,
    contact_velocity,
)
from restitution.studies.spheres.turning import turned
from restitution.studies.spheres.validity import Caution, cautions
from restitution.studies.spheres.walton import walton_beta_0

CONVENTIONS = "; ".join(
    [
        CONVENTION,
        *(
            f"{name} = {QUANTITIES[name].text}"
            for name in ("centre_restitution", "impulse_ratio", "walton_beta_0")
        ),
    ]
)


@dataclass(frozen=True)
class ScalingStudy:
    """A collision of real bodies; attributes are those of ``POST /scaling``.

    `psi` is None where it is infinite, `switches` where they were not counted, `walton_beta_0`
    where double precision does not hold it, `after` where the impact was given by the velocity at
    the point of contact. Names end in their SI unit; those without one are pure numbers, but β of
    Eq. 18, which is in m^{-1/2} s^{-2}.

    Examples
    --------
    >>> import restitution as rs
    >>> steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
    >>> found = rs.Contact(steel, steel, 0.4, "mindlin").impact(
    ...     normal_velocity_m_s=1.0, tangential_velocity_m_s=0.5
    ... )
    >>> round(1e6 * found.contact_duration_s), round(found.maximum_normal_force_n)
    (120, 4022)
    """

    kappa: float
    mu_over_alpha: float
    gt_over_gn: float
    damping: float
    psi: Annotated[float | None, Meaning("null where it is infinite")]
    alpha: float
    beta: float
    effective_mass_kg: float
    effective_radius_m: float
    effective_modulus_pa: float
    tangential_stiffness_n_per_m: float
    dissipative_constant_s: Annotated[float, QUANTITIES["dissipative_constant_s"]]
    normal_velocity_m_s: float
    tangential_velocity_m_s: float
    time_scale_s: float
    length_scale_m: float
    contact_duration_s: float
    maximum_compression_m: float
    maximum_normal_force_n: float
    epsilon_n: float
    epsilon_t: EpsilonT
    centre_restitution: Annotated[float, QUANTITIES["centre_restitution"]]
    impulse_ratio: Annotated[float, QUANTITIES["impulse_ratio"]]
    walton_beta_0: Annotated[float | None, QUANTITIES["walton_beta_0"]]
    switches: int | None
    after: After | None
    warnings: Annotated[list[Caution], Meaning("where the collision leaves the model")]
    method: AnsweringMethod
    error_bound: ErrorBound
    tolerance_met: ToleranceMet
    convention: Convention


def study_scaling(
    contact: Contact,
    impact: Velocities | SpeedAndAngle | Impact,
    options: Options | None = None,
) -> ScalingStudy:
    """Return what comes out of a collision of real bodies.

    Parameters
    ----------
    contact : Contact
        Bodies, friction, stiffness.
    impact : Velocities, SpeedAndAngle or Impact
        The velocity at the point of contact, or the motion of both bodies.
    options : Options, optional
        Method and tolerance.

    Raises
    ------
    ParameterError
        If the bodies do not approach or a quantity is beyond double precision.

    Examples
    --------
    >>> from restitution.studies.spheres.bodies import Sphere
    >>> steel = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
    >>> study = study_scaling(Contact(steel, steel, 0.4, 1e12), Velocities(20.0, 5.0))
    >>> round(study.kappa), round(1e6 * study.contact_duration_s, 1)
    (11225, 66.1)
    """
    if isinstance(impact, SpeedAndAngle):
        impact = impact.velocities
    if isinstance(impact, Velocities):
        approach, g_n, g_t = None, impact.normal_velocity_m_s, impact.tangential_velocity_m_s
        # of bodies that do not spin
        crossing = Crossing(g_t, 0.0, 0.0)
    else:
        approach = contact_velocity(impact, contact.pair)
        g_n, g_t = approach.normal_velocity, approach.tangential_velocity
        crossing = approach.crossing
    at = scales(contact, g_n)
    parameters = CollisionParameters(
        at.kappa,
        friction_over_alpha(contact.friction_coefficient, at.pair.alpha),
        velocity_ratio(g_t, g_n),
        at.damping,
    )
    found = study_collision(parameters, options, ("epsilon_t", "epsilon_n", "switches"))
    after = None
    if isinstance(impact, Impact) and approach:
        after = after_impact(impact, at.pair, approach, found.epsilon_n, found.epsilon_t)
    let_turn = turned(at, crossing, parameters, g_t, found.epsilon_n, found.epsilon_t)
    return ScalingStudy(
        kappa=at.kappa,
        mu_over_alpha=parameters.mu_over_alpha,
        gt_over_gn=parameters.gt_over_gn,
        damping=at.damping,
        psi=parameters.psi if math.isfinite(parameters.psi) else None,
        alpha=at.pair.alpha,
        beta=at.beta,
        effective_mass_kg=at.pair.effective_mass_kg,
        effective_radius_m=at.pair.effective_radius_m,
        effective_modulus_pa=at.pair.effective_modulus_pa,
        tangential_stiffness_n_per_m=at.tangential_stiffness_n_per_m,
        dissipative_constant_s=at.dissipative_constant_s,
        normal_velocity_m_s=g_n,
        tangential_velocity_m_s=g_t,
        time_scale_s=at.time_scale_s,
        length_scale_m=at.length_scale_m,
        contact_duration_s=found.contact_duration * at.time_scale_s,
        maximum_compression_m=at.maximum_compression_m,
        maximum_normal_force_n=at.maximum_normal_force_n,
        epsilon_n=found.epsilon_n,
        epsilon_t=found.epsilon_t,
        centre_restitution=1.0 - at.pair.alpha * (1.0 - found.epsilon_t),
        impulse_ratio=impulse_ratio(contact.friction_coefficient, at.pair.alpha, found),
        walton_beta_0=walton_beta_0(at.kappa, at.damping),
        switches=found.switches,
        after=after,
        warnings=cautions(contact, at, let_turn, g_t),
        method=found.method,
        error_bound=found.error_bound,
        tolerance_met=found.tolerance_met,
        convention=CONVENTIONS,
    )


def impulse_ratio(friction_coefficient: float, alpha: float, found: CollisionStudy) -> float:
    """Return the tangential impulse over the normal one, from 0 to μ.

    α(1 − ε_t) g_t over (1 + ε_n) g_n (Eqs. 13, 14): of its digits, 1 − ε_t keeps those above
    1e-16 ψ. Where a contact slides throughout it is μ by Coulomb's law.
    """
    parameters = found.parameters
    if found.switches == 0 and parameters.gt_over_gn > 0.0:
        return friction_coefficient
    slowed = alpha * (1.0 - found.epsilon_t) / (1.0 + found.epsilon_n)
    return min(slowed * parameters.gt_over_gn, friction_coefficient)
