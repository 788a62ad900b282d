"""A scaled collision as inputs of DEM codes; which they are, docs/for-dem-codes.md tells."""

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from restitution.bounds import Meaning
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.hertz import MAXIMUM_COMPRESSION
from restitution.methods.answer import EpsilonT
from restitution.quantities import QUANTITIES
from restitution.studies.collision.one import study_collision
from restitution.studies.collision.parameters import CONVENTION, CollisionParameters, Convention
from restitution.studies.spheres.bodies import Body, pair
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.powers import product_of_powers, representable

Law = Literal["this", "growing", "linear"]

GROWTH = math.sqrt(MAXIMUM_COMPRESSION)
"""κ over K_t/(α k_n) where k_t = K_t √(R_eff ξ), at the largest compression: (5/4)^{1/5}."""


@dataclass(frozen=True)
class CodeInput:
    """What one contact law of one code takes.

    Attributes
    ----------
    code, style : str
        The code and its name for the law.
    law : {"this", "growing", "linear"}
        The law of this model, one with k_t ∝ √ξ, or one with a linear normal spring.
    lines : list of str
        Of its input, as far as it can be told: SI units, "" for none.
    kappa : float
        κ there: where k_t follows from the materials, theirs.
    epsilon_t : float or None
        None where the law, or its damping, is another one.
    """

    code: str
    style: str
    law: Annotated[
        Law, Meaning("that of this model; one with k_t ∝ √ξ; one with a linear normal spring")
    ]
    lines: Annotated[list[str], Meaning("of its input, in SI units")]
    kappa: Annotated[float, Meaning("κ there; that of the materials where k_t follows from them")]
    epsilon_t: Annotated[float | None, Meaning("null where its law or damping is another one")]


@dataclass(frozen=True)
class CodesStudy:
    """A scaled collision of real bodies, as codes take it.

    Attributes are those of ``POST /codes``, in the SI unit that their names end in;
    `viscous_damping_per_metre_second` is γ in 1/(m s).

    Examples
    --------
    >>> import restitution as rs
    >>> glass = rs.Sphere(1e-3, 70e9, 0.21777, density_kg_m3=2500)
    >>> asked = CollisionParameters(4.6948, 1.4, 1.0, 0.09016)
    >>> found = study_codes(glass, glass, 0.1, asked)
    >>> f"{found.normal_stiffness_pa:.3g}", f"{found.tangential_stiffness_n_per_m:.3g}"
    ('4.9e+10', '8e+05')
    """

    alpha: float
    normal_velocity_m_s: float
    tangential_velocity_m_s: float
    friction_coefficient: Annotated[float, QUANTITIES["friction_coefficient"]]
    normal_stiffness_pa: Annotated[float, QUANTITIES["normal_stiffness_pa"]]
    tangential_stiffness_n_per_m: float
    viscous_damping_per_metre_second: Annotated[
        float, QUANTITIES["viscous_damping_per_metre_second"]
    ]
    growing_stiffness_pa: Annotated[float, QUANTITIES["growing_stiffness_pa"]]
    linear_stiffness_n_per_m: Annotated[float, QUANTITIES["linear_stiffness_n_per_m"]]
    contact_duration_s: float
    epsilon_n: float
    epsilon_t: EpsilonT
    codes: Annotated[list[CodeInput], Meaning("a contact law of a code each")]
    convention: Convention


def study_codes(
    body_1: Body, body_2: Body, normal_velocity: float, parameters: CollisionParameters
) -> CodesStudy:
    """Return what codes take for a scaled collision, if these bodies have it at a velocity.

    Parameters
    ----------
    body_1, body_2 : Sphere or Wall
        They say m_eff, R_eff, E* and α.
    normal_velocity : float
        g_n in m/s.
    parameters : CollisionParameters
        κ says k_t, μ/α the friction, g_t/g_n the other velocity, η the damping.

    Raises
    ------
    ParameterError
        If both are walls, or a quantity is beyond double precision.
    """
    both = pair(body_1, body_2)
    mass, radius, alpha = both.effective_mass_kg, both.effective_radius_m, both.alpha
    # with Mindlin's k_t κ is that of the materials, at any velocity
    at = scales(Contact(body_1, body_2, 0.0, "mindlin"), normal_velocity)
    eta, kappa = parameters.damping, parameters.kappa

    def held(name: str, *factors: tuple[float, int]) -> float:
        words = "κ, masses, radii, Young's moduli and the normal velocity"
        return representable(name, product_of_powers(*factors), words)

    normal = held("normal_stiffness_pa", (4.0 / 3.0, 10), (both.effective_modulus_pa, 10))
    scale = (alpha, 10), (mass, 10), (at.beta, 8), (normal_velocity, 4)
    duration = contact_duration(eta) * at.time_scale_s
    gamma = ((eta, 10), (at.beta, 6), (normal_velocity, -2), (radius, -5)) if eta else None
    told = {
        "friction_coefficient": parameters.mu_over_alpha * alpha,
        "normal_stiffness_pa": normal,
        "tangential_stiffness_n_per_m": held("tangential_stiffness_n_per_m", (kappa, 10), *scale),
        "viscous_damping_per_metre_second": held("viscous_damping_per_metre_second", *gamma)
        if gamma
        else 0.0,
        "growing_stiffness_pa": held(
            "growing_stiffness_pa", (kappa, 10), (alpha, 10), (normal, 10), (GROWTH, -10)
        ),
        "linear_stiffness_n_per_m": held(
            "linear_stiffness_n_per_m", (mass, 10), (math.pi, 20), (duration, -20)
        ),
    }
    # once all else is known to be held by a double
    found = study_collision(parameters, quantities=("epsilon_t", "epsilon_n"))
    return CodesStudy(
        alpha=alpha,
        normal_velocity_m_s=normal_velocity,
        tangential_velocity_m_s=parameters.gt_over_gn * normal_velocity,
        contact_duration_s=duration,
        epsilon_n=found.epsilon_n,
        epsilon_t=found.epsilon_t,
        codes=_inputs(told, kappa, at.kappa, found.epsilon_t, damped=eta > 0.0),
        convention=CONVENTION,
        **told,
    )


def _inputs(
    told: dict[str, float], kappa: float, mindlin: float, epsilon_t: float, *, damped: bool
) -> list[CodeInput]:
    """Return one contact law of a code each."""
    texts = {name: f"{value:.9g}" for name, value in told.items()}
    friction, normal = texts["friction_coefficient"], texts["normal_stiffness_pa"]
    constant, gamma = (
        texts["tangential_stiffness_n_per_m"],
        texts["viscous_damping_per_metre_second"],
    )
    growing, linear = texts["growing_stiffness_pa"], texts["linear_stiffness_n_per_m"]
    spring = f"tangential linear_history {constant} 0.0 {friction}"
    damping = "damping viscoelastic limit_damping"
    hooke = f"pair_style gran/hooke/history {linear} {constant} 0 0 {friction} 0"
    undamped = None if damped else epsilon_t
    return [
        CodeInput(
            "LAMMPS",
            "granular",
            "this",
            ["pair_style granular", f"pair_coeff * * hertz {normal} {gamma} {spring} {damping}"],
            kappa,
            epsilon_t,
        ),
        CodeInput(
            "LAMMPS",
            "gran/hertz/history",
            "growing",
            [
                " ".join(
                    ["pair_style gran/hertz/history", normal, growing, gamma, "0", friction, "0"]
                    + ["limit_damping"] * damped
                ),
                "pair_coeff * *",
            ],
            kappa,
            None,
        ),
        # what its dashpot would have to be is another law's
        CodeInput(
            "LAMMPS",
            "gran/hooke/history",
            "linear",
            [] if damped else [hooke, "pair_coeff * *"],
            kappa,
            None,
        ),
        CodeInput(
            "YADE",
            "HertzWithLinearShear",
            "this",
            [
                "Law2_ScGeom_MindlinPhys_HertzWithLinearShear(nonLin=0)",
                "NewtonIntegrator(damping=0)",
                f"phys.kso = {constant}",
            ],
            kappa,
            undamped,
        ),
        CodeInput("LIGGGHTS", "hertz", "growing", [], mindlin, None),
        CodeInput(
            "MercuryDPM",
            "HertzianViscoelasticSlidingFrictionSpecies",
            "this",
            [f"slidingStiffness {constant}"],
            kappa,
            undamped,
        ),
        CodeInput("MFIX", "HERTZIAN", "growing", [], mindlin, None),
    ]
