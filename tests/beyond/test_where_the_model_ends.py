"""The numbers of "Where the model ends" in docs/model.md, computed anew."""

import math
import re
from pathlib import Path

import numpy as np
import pytest
from other_laws import DURATION, HARDEST, KAPPA, as_the_area, epsilon_t, hooke, tsuji
from scipy.integrate import quad
from scipy.optimize import brentq
from turning_spheres import Spheres, let_turn

from restitution.mechanics.collision import collide
from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.contact import Contact, scales

TEXT = (Path(__file__).parents[2] / "docs" / "model.md").read_text()
SECTION = " ".join(
    TEXT.partition("## Where the model ends")[2].partition("\n## ")[0].replace("\n*", "\n").split()
)
PSIS = (0.1, 1.0, 2.5)

LAWS = {
    "this model": {},
    "tangential dashpot, as goes with ε_n = 0.9": {"dashpot": tsuji(0.9)},
    "k_t ∝ √ξ, F_t = k_t ζ": {"softness": as_the_area},
    "the same, ζ falling with the radius of the contact": {
        "softness": as_the_area,
        "rescaled": True,
    },
    "k_t ∝ √ξ, dF_t = k_t dζ": {"softness": as_the_area, "summed": True},
    "the same, F_t falling with the radius of the contact": {
        "softness": as_the_area,
        "summed": True,
        "rescaled": True,
    },
    "linear normal spring, contact as long": {"normal": hooke},
    "linear normal spring, k_t = (2/7) k_n": {
        "normal": hooke,
        "kappa": (math.pi / DURATION) ** 2,
    },
    "rolling friction 0.01, on a wall": {"rolling": 0.01},
    "adhesion, a pull of 1 % of the largest force": {"adhesion": 0.01 * HARDEST},
}


def written(value, digits=2):
    return f"{value:.{digits}f}".replace("-", "−")


@pytest.mark.parametrize("law", LAWS)
def test_row_of_the_table_is_what_the_law_gives(law):
    cells = " | ".join(written(epsilon_t(psi, **LAWS[law])) for psi in PSIS)
    assert f"| {law} | {cells} |" in TEXT


def test_table_has_no_other_row():
    assert len(re.findall(r"\| [−\d.]+ \|\n", TEXT.partition("## Where the model")[2])) == len(LAWS)


def test_steps_of_the_examples_give_what_the_model_does():
    exact = collide(KAPPA, PSIS).epsilon_t
    # first order, 20,000 steps
    assert [epsilon_t(psi) for psi in PSIS] == pytest.approx(exact.tolist(), abs=3e-4)
    steel = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
    assert scales(Contact(steel, steel, 0.4, "mindlin"), 1.0).kappa == pytest.approx(KAPPA)


def test_springs_that_grow_with_the_contact_beside_the_experiment():
    growing = {"softness": as_the_area, "kappa": 4.717}
    created = epsilon_t(0.0997, **growing)
    assert f"ε_t = {created:.3f} at κ = 4.72, ψ = 0.1" in SECTION
    summed = epsilon_t(0.0997, **growing, summed=True, rescaled=True)
    model = float(collide(4.717, 0.0997).epsilon_t)
    measured = 1.0 - (1.0 - 0.79344) / (2.0 / 7.0)
    assert (
        f"the last one has {summed:.2f}, the model {model:.2f} and the experiment of "
        f"[real-spheres.md](real-spheres.md) {measured:.2f}" in SECTION
    )
    lowest = epsilon_t(0.1) - epsilon_t(0.1, softness=as_the_area, summed=True, rescaled=True)
    assert f"move down by up to {lowest:.2f}" in SECTION


def test_weak_impacts_on_two_sevenths_of_the_normal_spring_are_gear_wheels():
    law = LAWS["linear normal spring, k_t = (2/7) k_n"]
    for psi in (0.01, 0.5, 0.99):
        assert epsilon_t(psi, **law) == pytest.approx(-1.0, abs=1e-3)
    assert epsilon_t(1.5, **law) > -0.9


def test_rolling_friction_lifts_what_slides_by_its_law():
    lifted = epsilon_t(2.5, rolling=0.01) - epsilon_t(2.5)
    law = 5.0 * 0.01 / (1.4 * 2.5)
    assert lifted == pytest.approx(law, abs=1e-4)
    assert f"5μ_r g_n/g_t, {law:.3f} here" in SECTION


WORK = 0.1
"""w of glass, J/m²."""


@pytest.mark.parametrize(
    ("radius", "said"), [(50e-6, ("0.26 m/s for spheres of 50 µm", "5.6 mm/s")),
                         (1.5e-3, ("0.015 m/s for 1.5 mm", "0.33 mm/s"))],
)  # fmt: skip
def test_adhesion_matters_below_the_speeds_that_are_said(radius, said):
    glass = Sphere(radius, 7e10, 0.22, density_kg_m3=2500.0)
    at = scales(Contact(glass, glass, 0.4, "mindlin"), 1.0)
    pull = 2.0 * math.pi * WORK * at.pair.effective_radius_m
    largest = at.maximum_normal_force_n
    speed = (pull / (0.01 * largest)) ** (1 / 1.2)
    torn = _torn_apart() * (
        WORK**5 * at.pair.effective_radius_m**4 / at.pair.effective_modulus_pa**2
    ) ** (1 / 3)
    sticking = 1e3 * math.sqrt(2.0 * torn / at.pair.effective_mass_kg)
    assert said == (
        f"{speed:.2g} m/s for {said[0].partition(' for ')[2]}",
        f"{sticking:.2g} mm/s",
    )
    assert said[0] in SECTION
    assert said[1] in SECTION


def _torn_apart():
    """Return the work to separate a JKR contact that touches without force, w = R = E* = 1."""

    def approach(a):
        return a**2 - math.sqrt(2.0 * math.pi * a)

    def slope(a):
        return 2.0 * a - 0.5 * math.sqrt(2.0 * math.pi / a)

    def pull(a):
        return math.sqrt(8.0 * math.pi * a**3) - 4.0 / 3.0 * a**3

    smallest = brentq(slope, 0.1, 3.0)
    touching = brentq(approach, 1.01 * smallest, 10.0)
    return quad(lambda a: pull(a) * slope(a), smallest, touching)[0]


def test_work_to_tear_a_contact_apart_is_what_is_said():
    assert f"takes {_torn_apart():.2f} (w⁵R_eff⁴/E*²)^{{1/3}}" in SECTION


def test_steel_whose_normal_turns_leaves_as_is_said():
    steel = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
    contact = Contact(steel, steel, 0.4, "mindlin")
    at, still = scales(contact, 1.0), np.zeros(3)
    radius = 0.02 / at.length_scale_m
    left = let_turn(
        Spheres(
            radii=(radius, radius),
            masses=(2.0, 2.0),
            moments=(0.8 * radius**2,) * 2,
            friction=0.4,
            stiffness=at.kappa * contact.pair.alpha,
            velocities=(np.array([11.0, 0.0, -1.0]), still),
            spins=(still, still),
        )
    )
    kept = contact.impact(normal_velocity_m_s=1.0, tangential_velocity_m_s=11.0)
    normal, tangential = left.velocity[2], left.velocity[0] / 11.0
    assert (
        f"turns by {left.angle:.3f} rad: {normal:.3f} g_n instead of {kept.epsilon_n:.0f}, and "
        f"ε_t = {tangential:.3f} instead of {kept.epsilon_t:.3f}" in SECTION
    )
