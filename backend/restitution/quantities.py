"""What a column of a result is: in words, as a symbol, and in which unit. Said once, by its name.

Annotations of members take it from here as their `Meaning`, frames and data sets as attributes
(`studies.tabular`). Scaled quantities name what they are scaled by, see docs/model.md; "1" is the
unit of a pure number, and of a word or a truth there is none.
"""

from dataclasses import dataclass

from restitution.bounds import Meaning


@dataclass(frozen=True)
class Quantity(Meaning):
    """A quantity: `text` says what it is."""

    symbol: str = ""
    unit: str = "1"


FORCE = "m_eff ξ_scale/t_scale²"
ENERGY = "α m_eff g_n²"

QUANTITIES = {
    # what a collision is told by
    "kappa": Quantity("κ of Eq. 24, with α in it", "κ"),
    "mu_over_alpha": Quantity("μ/α", "μ/α"),
    "gt_over_gn": Quantity("g_t/g_n", "g_t/g_n"),
    "psi": Quantity("(α/μ)(g_t/g_n)", "ψ"),
    "damping": Quantity("η = (3/2) A β^{2/5} g_n^{1/5}", "η"),
    "normal_restitution": Quantity(
        "coefficient of normal restitution, in place of the damping that has it", "ε_n"
    ),
    # what comes out
    "epsilon_t": Quantity("coefficient of tangential restitution", "ε_t"),
    "epsilon_n": Quantity("coefficient of normal restitution", "ε_n"),
    "switches": Quantity("changes between sliding and sticking"),
    "coulomb": Quantity("ε_t of a contact that slides throughout, Eq. 16, but at least 0", "ε_t"),
    "stiff_bound": Quantity("bound on |ε_t| of a stiff spring, ψ < 2", "|ε_t|"),
    "stiff_asymptote": Quantity("amplitude of ε_t of a stiff spring, ψ < 2", "|ε_t|"),
    "largest_switches": Quantity("most switches that any g_t/g_n has at this κ"),
    "error": Quantity("ε_t of the method that answered − the exact one", "ε_t − ε_t,exact"),
    "method": Quantity("the one that answered", unit=""),
    "error_bound": Quantity("bound on the absolute error of ε_t"),
    "tolerance_met": Quantity("whether error_bound is within the tolerance", unit=""),
    "largest_error": Quantity("largest error of interpolation in the table"),
    "reversals": Quantity("sign changes of g_t during the contact"),
    "first_episode_share": Quantity("share of the contact until the first switch"),
    "contact_duration": Quantity("duration of the contact", "t_c", "t_scale"),
    "energy": Quantity("tangential energy, u²/2 + κz²/2 with u = g_t/g_n", unit=ENERGY),
    "dissipated_share": Quantity("share of the tangential energy that is lost"),
    # over time
    "time": Quantity("time since the touch", "t", "t_scale"),
    "compression": Quantity("compression", "x", "ξ_scale"),
    "compression_rate": Quantity("rate of compression", "ẋ", "g_n"),
    "normal_force": Quantity("normal force", "F_n", FORCE),
    "tangential_force_over_mu": Quantity(
        "tangential force over μ, negative while it brakes", "F_t/μ", FORCE
    ),
    "tangential_velocity": Quantity("tangential velocity at the point of contact", "g_t", "g_n"),
    "spring_elongation": Quantity("elongation of the tangential spring", "z", "ξ_scale"),
    "regime": Quantity("0 while it sticks, the sign of z while it slides"),
    "tangential_energy": Quantity("u²/2 + κz²/2 with u = g_t/g_n", unit=ENERGY),
    # of real bodies
    "normal_velocity_m_s": Quantity("normal velocity at the point of contact", "g_n", "m/s"),
    "tangential_velocity_m_s": Quantity(
        "tangential velocity at the point of contact", "g_t", "m/s"
    ),
    "time_scale_s": Quantity("unit of time of the scaled collision, Eq. 21", "t_scale", "s"),
    "length_scale_m": Quantity("unit of length of the scaled collision, Eq. 21", "ξ_scale", "m"),
    "contact_duration_s": Quantity("duration of the contact", "t_c", "s"),
    "maximum_compression_m": Quantity("largest compression", "ξ_max", "m"),
    "maximum_normal_force_n": Quantity("largest normal force", "F_max", "N"),
    "alpha": Quantity("factor of the mass distribution, Eq. 12", "α"),
    "beta": Quantity("strength of the contact, Eq. 18", "β", "m^{−1/2} s⁻²"),
    "effective_mass_kg": Quantity("effective mass", "m_eff", "kg"),
    "effective_radius_m": Quantity("effective radius", "R_eff", "m"),
    "effective_modulus_pa": Quantity("effective modulus", "E*", "Pa"),
    "tangential_stiffness_n_per_m": Quantity("stiffness of the tangential spring", "k_t", "N/m"),
    "friction_coefficient": Quantity("coefficient of friction", "μ"),
    "normal_stiffness_pa": Quantity("(4/3) E*, of codes with Hertz's force", "k_n", "Pa"),
    "viscous_damping_per_metre_second": Quantity(
        "damping of codes with Hertz's force", "γ", "1/(m s)"
    ),
    "growing_stiffness_pa": Quantity(
        "of codes with k_t = K_t √(R_eff ξ): that with the same κ", "K_t", "Pa"
    ),
    "linear_stiffness_n_per_m": Quantity(
        "of codes with a linear normal spring: that with a contact as long", "k_n", "N/m"
    ),
    "velocity_1_m_s": Quantity("velocity of body 1", "v_1", "m/s"),
    "velocity_2_m_s": Quantity("velocity of body 2", "v_2", "m/s"),
    "spin_1_rad_s": Quantity("angular velocity of body 1", "ω_1", "rad/s"),
    "spin_2_rad_s": Quantity("angular velocity of body 2", "ω_2", "rad/s"),
    "dissipative_constant_s": Quantity("dissipative constant of Eq. 1", "A", "s"),
    "centre_restitution": Quantity(
        "1 - alpha (1 - epsilon_t), the tangential velocity of the centres after over before, "
        "without spin before",
        "e_c",
    ),
    "impulse_ratio": Quantity(
        "tangential over normal impulse, the friction coefficient where it slides throughout"
    ),
    "walton_beta_0": Quantity("-epsilon_t for psi -> 0, -1 smooth spheres, +1 gear wheels", "β_0"),
    "beta_0": Quantity("of Walton's model, -1 smooth spheres, +1 gear wheels", "β_0"),
    # of a ball that bounces
    "spin_share": Quantity("share of g_t that spin has, 0 if all of it is travel"),
    "mass_share": Quantity("m_eff/m of the ball, 1 off a wall, 1/2 off an equal ball"),
    "centre_change": Quantity(
        "change of the tangential velocity of the ball's centre, over (1 − ε_t) g_t"
    ),
    "spin_change": Quantity("change of Rω of the ball, over (1 − ε_t) g_t"),
    "normal_velocity": Quantity(
        "velocity of the ball along the normal, positive away from the other body", unit="g_n"
    ),
    "centre_velocity": Quantity("velocity of the ball's centre along g_t", "v_t", "g_n"),
    "spin_velocity": Quantity(
        "velocity of the ball's surface by its spin, positive as it rolls along g_t", "Rω", "g_n"
    ),
    "angle_deg": Quantity(
        "angle of the ball's path to the normal, negative where it leads back", unit="°"
    ),
    "bounces": Quantity("how often the ball has bounced"),
    # of methods on many collisions
    "tolerance": Quantity("largest absolute error of ε_t wanted"),
    "phase": Quantity("where in a time step the contact begins"),
    "rtol": Quantity("relative tolerance of the general solver"),
    "floor": Quantity("ε_t where Coulomb's law would have less"),
    "collisions": Quantity("how many collisions were measured"),
    "unanswered": Quantity("share of them that the method refuses"),
    "microseconds_per_collision": Quantity("time that one takes", unit="µs"),
    "wrong_sign": Quantity("share with the wrong sign of ε_t"),
    "wrong_switches": Quantity("share with a wrong number of switches"),
    "integrator": Quantity("how time steps are taken", unit=""),
    "steps": Quantity("time steps per contact", "N"),
    "error_median": Quantity("median of |ε_t − exact|"),
    "error_p95": Quantity("95th percentile of |ε_t − exact|"),
    "error_max": Quantity("largest |ε_t − exact|"),
    "collision": Quantity("place among the collisions, from 0"),
}


def unit_of(column: str) -> str:
    """Return the unit of a column, of ``energy.initial`` that of ``energy``; "" for words."""
    known = (QUANTITIES[part] for part in reversed(column.split(".")) if part in QUANTITIES)
    return next((quantity.unit for quantity in known), "")
