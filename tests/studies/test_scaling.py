"""From SI units to the scaled collision: published numbers, formulas, every digit, units."""

import math
from dataclasses import replace

import mpmath
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from restitution.errors import ParameterError
from restitution.mechanics.contact import (
    MOST_DAMPING,
    contact_duration,
    largest_force,
    normal_restitution,
)
from restitution.studies.spheres.bodies import Moment, Sphere
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Velocities

STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
FIGURE_2 = Contact(STEEL, STEEL, 0.4, 1e12)
GLASS = Sphere(0.0031, 6.9e10, 0.24, mass_kg=3e-4, inertia=Moment(1.4e-9))
LIGHT = Sphere(0.011, 3.2e9, 0.37, density_kg_m3=410.0, inertia="hollow")


def test_schwager2008_figure_2_caption():
    at = scales(FIGURE_2, 20.0)
    # every digit that docs/model.md gives
    assert at.pair.alpha == pytest.approx(2 / 7, rel=1e-15)
    assert at.pair.effective_mass_kg == pytest.approx(0.131528, abs=5e-7)
    assert at.beta == pytest.approx(1.16968e11, abs=5e5)
    assert scales(FIGURE_2, 1.0).kappa == pytest.approx(37204, abs=0.5)
    assert at.kappa == pytest.approx(11225, abs=0.5)
    assert at.contact_duration_s == pytest.approx(66.1e-6, abs=5e-8)
    assert at.maximum_compression_m == pytest.approx(449e-6, abs=5e-7)


def test_schwager2008_footnote_2_with_its_mass_for_the_effective_mass():
    force = scales(replace(FIGURE_2, friction_coefficient=0.5), 20.0).maximum_normal_force_n
    # the paper's energy balance has m for m_eff, 2^{3/5} too large
    elongation_times_stiffness = 0.5 * 2**0.6 * force
    assert elongation_times_stiffness == pytest.approx(1.10973e5, abs=0.5)
    assert elongation_times_stiffness / 1e12 == pytest.approx(0.11097e-6, abs=5e-12)


@pytest.mark.parametrize(
    ("poisson", "kappa"), [(0.0, 5.490), (0.25, 4.705), (0.3, 4.521), (0.5, 3.660)]
)
@pytest.mark.parametrize(("radius", "speed"), [(1e-3, 0.01), (0.5, 70.0)])
def test_kappa_of_mindlin_depends_on_poissons_ratio_alone(poisson, kappa, radius, speed):
    body = Sphere(radius, 7e10, poisson, density_kg_m3=2500.0)
    assert scales(Contact(body, body, 0.1, "mindlin"), speed).kappa == pytest.approx(
        kappa, abs=5e-4
    )


def test_beta_of_equal_materials_is_that_of_eq_18():
    modulus, nu, radius, mass = 3.3e9, 0.41, 0.007, 0.0123
    body = Sphere(radius, modulus, nu, mass_kg=mass)
    printed = 2 * modulus / (3 * (1 - nu**2)) * math.sqrt(radius / 2) / (mass / 2)
    assert scales(Contact(body, body, 0.1, "mindlin"), 1.0).beta == pytest.approx(
        printed, rel=1e-14
    )


MAGNITUDE = st.floats(-60.0, 60.0).map(lambda exponent: 10.0**exponent)
EXTREME = st.builds(
    Sphere,
    MAGNITUDE,
    MAGNITUDE,
    st.floats(-0.99, 0.5),
    mass_kg=MAGNITUDE,
    inertia=MAGNITUDE.map(Moment),
)


@given(
    bodies=st.tuples(EXTREME, EXTREME), stiffness=MAGNITUDE, dissipation=MAGNITUDE, g_n=MAGNITUDE
)
def test_extremes_keep_every_digit(bodies, stiffness, dissipation, g_n):
    with mpmath.workdps(50):
        first, second = (
            {
                name: mpmath.mpf(getattr(body, name))
                for name in ("mass_kg", "radius_m", "youngs_modulus_pa", "poisson_ratio")
            }
            | {"inertia": mpmath.mpf(body.inertia.moment_kg_m2)}
            for body in bodies
        )

        def joined(name):
            return 1 / (1 / first[name] + 1 / second[name])

        mass, radius = joined("mass_kg"), joined("radius_m")
        modulus = 1 / sum(
            (1 - body["poisson_ratio"] ** 2) / body["youngs_modulus_pa"] for body in (first, second)
        )
        alpha = 1 / (
            1 + sum(mass * body["radius_m"] ** 2 / body["inertia"] for body in (first, second))
        )
        fifth = mpmath.mpf(1) / 5
        beta = mpmath.mpf(4) / 3 * modulus * mpmath.sqrt(radius) / mass
        kappa = stiffness / (alpha * mass * beta ** (4 * fifth) * g_n ** (2 * fifth))
        damping = 1.5 * dissipation * beta ** (2 * fifth) * g_n**fifth
    assume(damping <= MOST_DAMPING)
    at = scales(Contact(*bodies, 0.1, stiffness, dissipation), g_n)
    with mpmath.workdps(50):
        force = largest_force(at.damping) * mass * beta ** (2 * fifth) * g_n ** (6 * fifth)
    assert at.pair.alpha == pytest.approx(float(alpha), rel=1e-14)
    assert at.beta == pytest.approx(float(beta), rel=1e-14)
    assert at.kappa == pytest.approx(float(kappa), rel=1e-14)
    assert at.damping == pytest.approx(float(damping), rel=1e-14)
    assert at.maximum_normal_force_n == pytest.approx(float(force), rel=1e-14)


def test_damping_is_that_of_its_formula():
    at = scales(replace(FIGURE_2, dissipative_constant_s=1e-6), 20.0)
    assert at.damping == pytest.approx(1.5e-6 * at.beta**0.4 * 20.0**0.2, rel=1e-14)


def test_damped_impact_is_softer_and_shorter_of_breath():
    undamped = study_scaling(FIGURE_2, Velocities(1.0, 1.0))
    damped = study_scaling(replace(FIGURE_2, dissipative_constant_s=1e-6), Velocities(1.0, 1.0))
    assert damped.epsilon_n == pytest.approx(normal_restitution(damped.damping), rel=1e-12)
    assert damped.epsilon_n < undamped.epsilon_n
    assert damped.maximum_compression_m < undamped.maximum_compression_m
    assert damped.contact_duration_s == pytest.approx(
        contact_duration(damped.damping) * damped.time_scale_s, rel=1e-14
    )


def test_damping_beyond_what_is_followed_is_refused_in_words():
    with pytest.raises(ParameterError, match="dissipative_constant_s"):
        study_scaling(replace(FIGURE_2, dissipative_constant_s=1e30), Velocities(1.0, 1.0))


def test_scaled_collision_does_not_change_with_the_units():
    # the same impact in units of 1/8 m, 1/4 s and 1/2 kg
    study = study_scaling(Contact(GLASS, LIGHT, 0.3, 2e5), Velocities(0.7, 0.4))
    length, time, mass = 8.0, 4.0, 2.0
    pressure, density = mass / length / time**2, mass / length**3

    def in_units(body):
        return replace(
            body,
            radius_m=body.radius_m * length,
            youngs_modulus_pa=body.youngs_modulus_pa * pressure,
            mass_kg=body.mass_kg and body.mass_kg * mass,
            density_kg_m3=body.density_kg_m3 and body.density_kg_m3 * density,
            inertia=body.inertia
            if isinstance(body.inertia, str)
            else Moment(body.inertia.moment_kg_m2 * mass * length**2),
        )

    other = study_scaling(
        Contact(in_units(GLASS), in_units(LIGHT), 0.3, 2e5 * mass / time**2),
        Velocities(0.7 * length / time, 0.4 * length / time),
    )
    for name in ("kappa", "psi", "alpha", "epsilon_t", "gt_over_gn", "mu_over_alpha"):
        assert getattr(other, name) == pytest.approx(getattr(study, name), rel=1e-13), name
    assert other.contact_duration_s == pytest.approx(study.contact_duration_s * time, rel=1e-13)
    ratio = other.maximum_normal_force_n / study.maximum_normal_force_n
    assert ratio == pytest.approx(mass * length / time**2, rel=1e-13)
