"""Warnings where the model is left, and none where it is not."""

import math
import re
from dataclasses import replace

from restitution.studies.spheres.bodies import Sphere, Wall
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Impact, Velocities

STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
HOLLOW = replace(STEEL, inertia="hollow")
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


def test_oblique_begins_where_turning_takes_a_hundredth_of_the_normal_velocity():
    contact = replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin")
    # turn × velocity over g_n is 0.01, at a velocity of which friction takes hardly any
    smooth = replace(contact, friction_coefficient=1e-3)
    crossing = math.sqrt(0.01 * 0.04 / scales(contact, 1.0).contact_duration_s)
    assert codes(smooth, Velocities(1.0, 0.99 * crossing)) == []
    assert codes(smooth, Velocities(1.0, 1.01 * crossing)) == ["oblique"]
    # friction slows the centres: what passes more slowly turns less
    assert codes(contact, Velocities(1.0, 1.01 * crossing)) == []


def test_spin_alone_does_not_turn_the_normal_but_rolling_on_another_does():
    contact = replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin")
    still, up = (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    spinning = Impact((0.0, 0.0, -1.0), still, up, (0.0, 1e3, 0.0))
    assert codes(contact, spinning) == []
    # the surfaces rest on each other, and what they have after the turn is all they have
    rolling = Impact((1.0, 0.0, -1.0), still, up, (0.0, 50.0, 0.0))
    (warning,) = study_scaling(contact, rolling).warnings
    assert warning.code == "oblique"
    assert "a tangential velocity of up to 0.003 m/s" in warning.text


def test_spin_about_the_normal_counts_where_that_turns():
    contact = replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin")
    still, up = (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    passing = Impact((1.0, 0.0, -1.0), still, up)
    assert codes(contact, passing) == []
    assert codes(contact, replace(passing, spin_1_rad_s=(0.0, 0.0, 1e3))) == ["oblique"]


def test_hollow_spheres_are_told_from_solid_ones():
    gentle = replace(FIGURE_2, tangential_stiffness_n_per_m="mindlin")
    for bodies in ({"body_1": HOLLOW}, {"body_2": HOLLOW}, {"body_1": HOLLOW, "body_2": HOLLOW}):
        assert codes(replace(gentle, **bodies), Velocities(0.01, 0.01)) == ["hollow"]


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


def test_a_warning_has_the_numbers_of_its_sentence_by_name():
    soft = Contact(replace(STEEL, yield_stress_pa=1e8), HOLLOW, 0.4, 1e12)
    impacts = [Velocities(20.0, 5.0), Velocities(1.0, 11.0), Velocities(2000.0, 1.0)]
    found = [w for impact in impacts for w in study_scaling(soft, impact).warnings]
    assert {warning.code for warning in found} >= {"plastic_flow", "oblique", "hollow"}
    for warning in found:
        digits = 2 if warning.code == "oblique" else 3
        told = re.findall(r"\d[\d.]*(?:e-?\d+)?", warning.text.replace(",", ""))
        values = [100 * v if name == "share" else v for name, v in warning.values.items()]
        assert {float(f"{value:.{digits}g}") for value in values} <= {float(each) for each in told}
