"""Warnings where the model is left, and none where it is not."""

import math
from dataclasses import replace

from restitution.studies.spheres.bodies import Sphere, Wall
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Impact, Velocities

STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
FIGURE_2 = Contact(STEEL, STEEL, 0.4, 1e12)


def codes(contact, impact):
    return [caution.code for caution in study_scaling(contact, impact).warnings]


def test_gentle_impact_of_mindlins_stiffness_warns_of_nothing():
    gentle = replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin")
    assert codes(gentle, Velocities(0.01, 0.01)) == []


def test_warnings_begin_where_they_say():
    rubber = Sphere(0.02, 1e6, 0.49, density_kg_m3=1100.0)
    contact = Contact(rubber, Wall(1e12, 0.3), 0.4, "mindlin")
    share = scales(contact, 1.0).maximum_compression_m / 0.02
    limit = (0.05 / share) ** 1.25
    assert codes(contact, Velocities(0.999 * limit, 0.0)) == []
    assert codes(contact, Velocities(1.001 * limit, 0.0)) == ["compression"]


def test_plastic_flow_begins_at_johnsons_velocity():
    soft = replace(STEEL, yield_stress_pa=4e8)
    contact = Contact(soft, STEEL, 0.4, "mindlin")
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
    assert (
        codes(replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin"), Velocities(9.0, 0.0)) == []
    )


def test_turning_normal_is_that_of_the_centres_not_of_spin():
    contact = replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin")
    turn = scales(contact, 1.0).contact_duration_s / 0.04
    crossing = 0.05 / turn
    assert codes(contact, Velocities(1.0, 0.99 * crossing)) == []
    assert codes(contact, Velocities(1.0, 1.01 * crossing)) == ["oblique"]
    still = (0.0, 0.0, 0.0)
    spinning = Impact((0.0, 0.0, -1.0), still, (0.0, 0.0, 1.0), (0.0, 1e4, 0.0))
    assert codes(contact, spinning) == []


def test_normal_of_a_wall_does_not_turn():
    contact = Contact(STEEL, Wall(2.1e11, 0.3), 0.4, "mindlin")
    assert codes(contact, Velocities(1.0, 1e4)) == []


def test_stiffness_of_figure_2_is_far_from_mindlins():
    assert codes(FIGURE_2, Velocities(1.0, 0.5)) == ["tangential_stiffness"]


def test_stiffness_beside_which_mindlins_underflows_is_far_from_it():
    dust = Sphere(1e-210, 1e-250, 0.3, mass_kg=1e-300)
    contact = Contact(dust, dust, 0.4, 1e-320)
    assert scales(contact, 1e35).mindlin_stiffness_n_per_m == 0.0
    assert "tangential_stiffness" in codes(contact, Velocities(1e35, 1e35))
