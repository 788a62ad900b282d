"""From SI units to the scaled collision and back: published numbers, conservation, symmetry."""

import math
import re
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from restitution.errors import ParameterError
from restitution.mechanics.viscoelastic import (
    MOST_DAMPING,
    contact_duration,
    largest_force,
    normal_restitution,
)
from restitution.studies.bodies import Sphere, Wall, pair
from restitution.studies.impact import Impact
from restitution.studies.materials import MATERIALS
from restitution.studies.scaling import Contact, scales
from restitution.studies.spheres import Velocities, study_scaling

DOCUMENT = (Path(__file__).parents[2] / "docs" / "real-spheres.md").read_text()

STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
FIGURE_2 = Contact(STEEL, STEEL, 0.4, 1e12)
GLASS = Sphere(0.0031, 6.9e10, 0.24, mass_kg=3e-4, inertia=1.4e-9)
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
    assert scales(Contact(body, body, 0.1, None), speed).kappa == pytest.approx(kappa, abs=5e-4)


def test_beta_of_equal_materials_is_that_of_eq_18():
    modulus, nu, radius, mass = 3.3e9, 0.41, 0.007, 0.0123
    body = Sphere(radius, modulus, nu, mass_kg=mass)
    printed = 2 * modulus / (3 * (1 - nu**2)) * math.sqrt(radius / 2) / (mass / 2)
    assert scales(Contact(body, body, 0.1, None), 1.0).beta == pytest.approx(printed, rel=1e-14)


MAGNITUDE = st.floats(-60.0, 60.0).map(lambda exponent: 10.0**exponent)
EXTREME = st.builds(
    Sphere, MAGNITUDE, MAGNITUDE, st.floats(-0.99, 0.5), mass_kg=MAGNITUDE, inertia=MAGNITUDE
)


@given(
    bodies=st.tuples(EXTREME, EXTREME), stiffness=MAGNITUDE, dissipation=MAGNITUDE, g_n=MAGNITUDE
)
def test_extremes_keep_every_digit(bodies, stiffness, dissipation, g_n):
    with mpmath.workdps(50):
        first, second = (
            {
                name: mpmath.mpf(getattr(body, name))
                for name in ("mass_kg", "radius_m", "inertia", "youngs_modulus_pa", "poisson_ratio")
            }
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


@pytest.mark.parametrize(
    ("inertia", "alpha"), [("solid", 2 / 7), ("hollow", 2 / 5), (0.5 * 0.02**2 * 3.0, 1 / 3)]
)
def test_alpha_of_a_sphere_on_a_wall_is_that_of_two_equal_spheres(inertia, alpha):
    body = Sphere(0.02, 1e9, 0.3, mass_kg=3.0, inertia=inertia)
    wall = Wall(1e10, 0.2)
    for first, second in ((body, body), (body, wall), (wall, body)):
        assert pair(first, second).alpha == pytest.approx(alpha, rel=1e-14)


def test_wall_is_the_limit_of_a_large_sphere():
    wall = pair(GLASS, Wall(2e11, 0.28))
    # Eqs. 12 and 18 differ by R₁/R₂ and m₁/m₂
    large = pair(GLASS, Sphere(1e10, 2e11, 0.28, mass_kg=1e10))
    for name in ("alpha", "effective_mass_kg", "effective_radius_m", "effective_modulus_pa"):
        assert getattr(large, name) == pytest.approx(getattr(wall, name), rel=1e-11), name


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
            else body.inertia * mass * length**2,
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


# impacts in three dimensions

VECTOR = st.tuples(*[st.floats(-30.0, 30.0)] * 3)
DIRECTION = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 0.01)
INERTIA = st.one_of(st.sampled_from(["solid", "hollow"]), st.floats(1e-9, 1e-3))


@st.composite
def spheres(draw):
    return Sphere(
        draw(st.floats(1e-4, 0.1)),
        draw(st.floats(1e6, 1e12)),
        draw(st.floats(-0.5, 0.5)),
        mass_kg=draw(st.floats(1e-6, 10.0)),
        inertia=draw(INERTIA),
    )


@st.composite
def impacts(draw):
    """An approaching impact: the relative velocity is turned round where it would not be."""
    normal = np.array(draw(DIRECTION))
    first, second = np.array(draw(VECTOR)), np.array(draw(VECTOR))
    approach = (second - first) @ normal
    if abs(approach) < 1e-3:
        first = second - normal
    elif approach < 0:
        first, second = second, first
    spins = draw(VECTOR), draw(VECTOR)
    return Impact(tuple(first.tolist()), tuple(second.tolist()), tuple(normal.tolist()), *spins)


CONTACTS = st.builds(
    Contact, spheres(), spheres(), st.floats(0.0, 2.0), st.one_of(st.none(), st.floats(1.0, 1e12))
)


def moments_of(contact, impact, motion):
    """Return momentum, angular momentum and energy, each with the sum of what it is made of."""
    both = (contact.body_1, motion[0], motion[2]), (contact.body_2, motion[1], motion[3])
    unit = np.array(impact.normal) / np.linalg.norm(impact.normal)
    places = (contact.body_1.radius_m * unit, -contact.body_2.radius_m * unit)
    momentum, angular, energy = np.zeros(3), np.zeros(3), 0.0
    sizes = np.zeros(3)
    for (body, velocity, spin), place in zip(both, places, strict=True):
        v, w = np.array(velocity), np.array(spin)
        factor = {"solid": 0.4, "hollow": 2 / 3}.get(body.inertia)
        inertia = body.inertia if factor is None else factor * body.mass_kg * body.radius_m**2
        momentum += body.mass_kg * v
        angular += body.mass_kg * np.cross(place, v) + inertia * w
        energy += 0.5 * body.mass_kg * v @ v + 0.5 * inertia * w @ w
        speed, turn = np.linalg.norm(v), np.linalg.norm(w)
        sizes += (
            body.mass_kg * speed,
            body.mass_kg * np.linalg.norm(place) * speed + inertia * turn,
            0.5 * body.mass_kg * speed**2 + 0.5 * inertia * turn**2,
        )
    return momentum, angular, energy, sizes


def motion_before(impact):
    return (
        impact.velocity_1_m_s,
        impact.velocity_2_m_s,
        impact.spin_1_rad_s,
        impact.spin_2_rad_s,
    )


@given(contact=CONTACTS, impact=impacts())
def test_impact_conserves_momentum_and_angular_momentum(contact, impact):
    after = study_scaling(contact, impact).after
    p0, l0, _, sizes_0 = moments_of(contact, impact, motion_before(impact))
    p1, l1, _, sizes_1 = moments_of(contact, impact, after)
    size = np.maximum(sizes_0, sizes_1)
    assert np.abs(p1 - p0).max() <= 1e-12 * size[0]
    assert np.abs(l1 - l0).max() <= 1e-12 * size[1]


@given(contact=CONTACTS, impact=impacts())
def test_impact_loses_the_energy_that_both_coefficients_say(contact, impact):
    study = study_scaling(contact, impact)
    _, _, before, sizes = moments_of(contact, impact, motion_before(impact))
    _, _, after, _ = moments_of(contact, impact, study.after)
    g_t = study.tangential_velocity_m_s
    lost = 0.5 * study.alpha * study.effective_mass_kg * g_t**2 * (1 - study.epsilon_t**2)
    assert before - after == pytest.approx(lost, rel=1e-12, abs=1e-12 * sizes[2])


@given(contact=CONTACTS, impact=impacts())
def test_surfaces_part_with_both_coefficients(contact, impact):
    study = study_scaling(contact, impact)
    normal = np.array(impact.normal) / np.linalg.norm(impact.normal)
    radii = contact.body_1.radius_m, contact.body_2.radius_m

    def surfaces(v1, v2, w1, w2):
        turning = radii[0] * np.array(w1) + radii[1] * np.array(w2)
        return np.array(v1) - np.array(v2) - np.cross(turning, normal)

    before, after = surfaces(*motion_before(impact)), surfaces(*study.after)
    tangential = before - (before @ normal) * normal
    expected = study.epsilon_t * tangential + study.normal_velocity_m_s * normal
    # velocities up to 60 m/s and surfaces up to 6 m/s, in which rounding is 1e-14, times levers
    spin = max(map(abs, (*study.after.spin_1_rad_s, *study.after.spin_2_rad_s)))
    assert after == pytest.approx(expected, abs=1e-12 * (1.0 + max(radii) * spin))


@given(contact=CONTACTS, impact=impacts())
def test_swapping_the_spheres_changes_nothing(contact, impact):
    study = study_scaling(contact, impact)
    swapped = replace(contact, body_1=contact.body_2, body_2=contact.body_1)
    v1, v2, w1, w2 = motion_before(impact)
    normal = tuple(-part for part in impact.normal)
    other = study_scaling(swapped, Impact(v2, v1, normal, w2, w1))
    assert other.kappa == pytest.approx(study.kappa, rel=1e-13)
    assert other.gt_over_gn == pytest.approx(study.gt_over_gn, rel=1e-13)
    # a phase √κ t_c of up to 1e3, known to 1e-13 of itself
    assert other.epsilon_t == pytest.approx(study.epsilon_t, abs=1e-10)
    v1, v2, w1, w2 = other.after
    for mine, its in zip(study.after, (v2, v1, w2, w1), strict=True):
        assert mine == pytest.approx(its, rel=1e-10, abs=1e-10 * (1 + max(map(abs, mine))))


@given(bodies=st.tuples(spheres(), spheres()), impact=impacts(), axis=DIRECTION,
       angle=st.floats(0.0, 6.3))  # fmt: skip
def test_rotating_the_frame_rotates_what_comes_out(bodies, impact, axis, angle):
    unit = np.array(axis) / np.linalg.norm(axis)
    cross = np.cross(np.eye(3), unit)
    rotation = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross

    def turned(vector):
        return tuple((rotation @ np.array(vector)).tolist())

    # Mindlin's stiffness: κ is of order 1, and roundings of the rotation stay small
    contact = Contact(*bodies, 0.3, None)
    study = study_scaling(contact, impact)
    v1, v2, w1, w2 = map(turned, motion_before(impact))
    other = study_scaling(contact, Impact(v1, v2, turned(impact.normal), w1, w2))
    speed = 60.0 + 60.0 * (contact.body_1.radius_m + contact.body_2.radius_m)
    g_n, g_t = study.normal_velocity_m_s, study.tangential_velocity_m_s
    assert other.normal_velocity_m_s == pytest.approx(g_n, abs=1e-14 * speed)
    assert other.tangential_velocity_m_s == pytest.approx(g_t, abs=1e-14 * speed)
    turns = contact.pair.turning_shares_per_m
    limits = 1.0, 1.0, 1.0 + turns[0], 1.0 + turns[1]
    for mine, its, limit in zip(study.after, other.after, limits, strict=True):
        assert its == pytest.approx(turned(mine), abs=1e-12 * speed * limit)


def test_rotated_impact_ends_rotated():
    contact = Contact(GLASS, LIGHT, 0.3, None)
    impact = Impact((1.0, -2.0, 0.5), (0.2, 0.1, 0.9), (-1.0, 3.0, 0.2), (40.0, 9.0, -7.0))
    straight = study_scaling(contact, impact).after
    # a cyclic change of axes is a rotation without rounding
    v1, v2, w1, w2 = (tuple(np.roll(v, 1).tolist()) for v in motion_before(impact))
    normal = tuple(np.roll(impact.normal, 1).tolist())
    turned = study_scaling(contact, Impact(v1, v2, normal, w1, w2)).after
    for mine, its in zip(straight, turned, strict=True):
        assert np.roll(mine, 1) == pytest.approx(its, rel=1e-12)


def test_both_forms_of_an_impact_agree():
    contact = Contact(GLASS, Wall(2e11, 0.3), 0.2, None)
    moving = study_scaling(contact, Impact((0.3, 0.0, -2.0), (0.0,) * 3, (0.0, 0.0, 7.0)))
    given_velocities = study_scaling(contact, Velocities(2.0, 0.3))
    assert moving.epsilon_t == given_velocities.epsilon_t
    assert moving.kappa == given_velocities.kappa
    assert given_velocities.after is None
    assert moving.after.velocity_2_m_s == (0.0, 0.0, 0.0)


def test_spin_alone_moves_the_surfaces():
    contact = Contact(GLASS, Wall(2e11, 0.3), 0.2, None)
    study = study_scaling(
        contact, Impact((0.0, 0.0, -2.0), (0.0,) * 3, (0.0, 0.0, 1.0), (0.0, 50.0, 0.0))
    )
    # the contact point lies at −R n: v = ω × (−R n)
    assert study.tangential_velocity_m_s == pytest.approx(50.0 * GLASS.radius_m, rel=1e-14)
    # the surface moves towards −x, so friction pushes the ball towards +x
    assert study.after.velocity_1_m_s[0] > 0.0


@pytest.mark.parametrize(
    ("impact", "words"),
    [
        (Impact((0.0, 0.0, 1.0), (0.0,) * 3, (0.0, 0.0, 1.0)), "approach"),
        (Impact((1.0, 0.0, 0.0), (0.0,) * 3, (0.0, 0.0, 1.0)), "approach"),
        (Impact((0.0,) * 3, (0.0,) * 3, (0.0, 0.0, 1.0)), "approach"),
        (Impact((0.0, 0.0, -1.0), (0.0,) * 3, (0.0, 0.0, 1.0), (0.0,) * 3, (1.0, 0.0, 0.0)),
         "a wall does not turn"),
    ],
)  # fmt: skip
def test_impossible_impacts_are_refused(impact, words):
    with pytest.raises(ParameterError, match=words):
        study_scaling(Contact(GLASS, Wall(2e11, 0.3), 0.2, None), impact)


def test_two_walls_are_refused():
    with pytest.raises(ParameterError, match="sphere"):
        pair(Wall(1e10, 0.2), Wall(1e10, 0.2))


# where the model is left


def codes(contact, impact):
    return [caution.code for caution in study_scaling(contact, impact).warnings]


def test_gentle_impact_of_mindlins_stiffness_warns_of_nothing():
    gentle = replace(FIGURE_2, tangential_stiffness_n_per_m=None)
    assert codes(gentle, Velocities(0.01, 0.01)) == []


def test_warnings_begin_where_they_say():
    rubber = Sphere(0.02, 1e6, 0.49, density_kg_m3=1100.0)
    contact = Contact(rubber, Wall(1e12, 0.3), 0.4, None)
    share = scales(contact, 1.0).maximum_compression_m / 0.02
    limit = (0.05 / share) ** 1.25
    assert codes(contact, Velocities(0.999 * limit, 0.0)) == []
    assert codes(contact, Velocities(1.001 * limit, 0.0)) == ["compression"]


def test_plastic_flow_begins_at_johnsons_velocity():
    soft = replace(STEEL, yield_stress_pa=4e8)
    contact = Contact(soft, STEEL, 0.4, None)
    at = scales(contact, 1.0)
    # Johnson 1985, Eq. 11.20: ½ m v² = (53.4/(E*⁴ )) R³ Y⁵ up to the rounding of 1.6 and 53.4
    modulus, radius, mass = (
        at.pair.effective_modulus_pa,
        at.pair.effective_radius_m,
        at.pair.effective_mass_kg,
    )
    speed = math.sqrt(2 * 53.4 * radius**3 * 4e8**5 / modulus**4 / mass)
    assert codes(contact, Velocities(0.97 * speed, 0.0)) == []
    assert codes(contact, Velocities(1.03 * speed, 0.0)) == ["plastic_flow"]
    assert codes(replace(FIGURE_2, tangential_stiffness_n_per_m=None), Velocities(9.0, 0.0)) == []


def test_turning_normal_is_that_of_the_centres_not_of_spin():
    contact = replace(FIGURE_2, tangential_stiffness_n_per_m=None)
    turn = scales(contact, 1.0).contact_duration_s / 0.04
    crossing = 0.05 / turn
    assert codes(contact, Velocities(1.0, 0.99 * crossing)) == []
    assert codes(contact, Velocities(1.0, 1.01 * crossing)) == ["oblique"]
    still = (0.0, 0.0, 0.0)
    spinning = Impact((0.0, 0.0, -1.0), still, (0.0, 0.0, 1.0), (0.0, 1e4, 0.0))
    assert codes(contact, spinning) == []


def test_normal_of_a_wall_does_not_turn():
    contact = Contact(STEEL, Wall(2.1e11, 0.3), 0.4, None)
    assert codes(contact, Velocities(1.0, 1e4)) == []


def test_stiffness_of_figure_2_is_far_from_mindlins():
    assert codes(FIGURE_2, Velocities(1.0, 0.5)) == ["tangential_stiffness"]


def test_stiffness_beside_which_mindlins_underflows_is_far_from_it():
    dust = Sphere(1e-210, 1e-250, 0.3, mass_kg=1e-300)
    contact = Contact(dust, dust, 0.4, 1e-320)
    assert scales(contact, 1e35).mindlin_stiffness_n_per_m == 0.0
    assert "tangential_stiffness" in codes(contact, Velocities(1e35, 1e35))


# what was measured


def test_kharaz2001_oblique_impacts_beside_the_model():
    (material,) = (m for m in MATERIALS if m.measured)
    wall = {name: part for name, part in material.body_2.items() if name != "wall"}
    contact = Contact(Sphere(**material.body_1), Wall(**wall), material.friction_coefficient, None)
    listed = re.findall(r"^\| ([\d.]+)° \|(.*)\|$", DOCUMENT, re.MULTILINE)
    for (angle, cells), point in zip(listed, material.measured.points, strict=True):
        study = study_scaling(
            contact, Velocities(point.normal_velocity_m_s, point.tangential_velocity_m_s)
        )
        psi, measured, computed = (float(c.replace("−", "-")) for c in cells.split("|"))
        # the digits of the document
        assert float(angle) == pytest.approx(point.angle_deg, abs=0.0051)
        assert psi == pytest.approx(study.psi, abs=0.0051)
        assert measured == pytest.approx(point.epsilon_t, abs=0.00051)
        assert computed == pytest.approx(study.epsilon_t, abs=0.00051)
        assert point.angle_deg < 30 or abs(study.epsilon_t - point.epsilon_t) < 0.03


def test_centre_ratio_of_a_computed_impact_converts_back():
    contact = Contact(GLASS, Wall(2e11, 0.3), 0.2, None)
    study = study_scaling(contact, Impact((0.5, 0.0, -2.0), (0.0,) * 3, (0.0, 0.0, 1.0)))
    ratio = study.after.velocity_1_m_s[0] / 0.5
    assert 1 - (1 - ratio) / study.alpha == pytest.approx(study.epsilon_t, abs=1e-14)
