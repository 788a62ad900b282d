"""What a turning normal changes: estimate and warning beside spheres that are let turn."""

import math

import numpy as np
import pytest
from turning_spheres import Spheres, let_turn

from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Impact, contact_velocity
from restitution.studies.spheres.validity import LARGEST_CHANGE

STEEL = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850.0)
AT_REST = (0.0, 0.0, 0.0)
UP = (0.0, 0.0, 1.0)


def scaled(contact, impact):
    """Return the bodies of an impact along `UP` in units of m_eff, ξ_scale and t_scale."""
    pair, g_n = contact.pair, impact.velocity_2_m_s[2] - impact.velocity_1_m_s[2]
    at = scales(contact, g_n)
    masses = [1.0 / share for share in pair.mass_shares]
    radii = [radius / at.length_scale_m for radius in pair.radii_m]
    moments = [
        radius / (share * at.length_scale_m)
        for radius, share in zip(radii, pair.turning_shares_per_m, strict=True)
    ]
    return Spheres(
        radii=tuple(radii),
        masses=tuple(masses),
        moments=tuple(moments),
        friction=contact.friction_coefficient,
        stiffness=at.kappa * pair.alpha,
        velocities=tuple(np.array(v) / g_n for v in (impact.velocity_1_m_s, impact.velocity_2_m_s)),
        spins=tuple(
            np.array(spin) * at.time_scale_s for spin in (impact.spin_1_rad_s, impact.spin_2_rad_s)
        ),
    )


def changes(contact, impact):
    """Return what turning takes from the normal velocity after, and moves the tangential one.

    Over g_n and over g_t, between the model and the spheres that are let turn; the latter as a
    vector's length.
    """
    left = let_turn(scaled(contact, impact)).velocity
    approach = contact_velocity(impact, contact.pair)
    tangential = np.ldexp(approach.tangential, approach.exponent)
    kept = study_scaling(contact, impact)
    moved = left[:2] - kept.epsilon_t * tangential[:2] / approach.normal_velocity
    share = approach.normal_velocity / approach.tangential_velocity
    return kept.epsilon_n - left[2], share * float(np.hypot(*moved))


def estimates(contact, impact, monkeypatch):
    """Return the same as the warning estimates it, whether or not it is given."""
    found = []

    def note(let_turn, tangential_velocity):
        found.append((let_turn.normal, let_turn.tangential / tangential_velocity))

    with monkeypatch.context() as patch:
        patch.setattr("restitution.studies.spheres.validity._turning_normal", note)
        study_scaling(contact, impact)
    return found[0]


def is_warned(contact, impact):
    return "oblique" in [caution.code for caution in study_scaling(contact, impact).warnings]


def random_impact(rng):
    """Return spheres of any material that pass each other at .1 to 30 times g_n, spinning."""
    sizes = 10.0 ** rng.uniform(-3.0, -1.0) * np.array([1.0, 10.0 ** rng.uniform(-0.7, 0.7)])
    young = 10.0 ** rng.uniform(6.0, 12.0)
    first, second = (
        Sphere(
            radius,
            young,
            rng.uniform(0.0, 0.5),
            density_kg_m3=10.0 ** rng.uniform(2.7, 4.3),
            inertia=str(rng.choice(["solid", "hollow"])),
        )
        for radius in sizes.tolist()
    )
    contact = Contact(first, second, 10.0 ** rng.uniform(-1.3, 0.3), "mindlin")
    # compressions of a thousandth to a twentieth of the smaller radius
    share = 10.0 ** rng.uniform(-3.0, -1.3)
    at_one = scales(contact, 1.0).maximum_compression_m
    g_n = (share * sizes.min() / at_one) ** 1.25
    if rng.random() < 0.5:
        stiffness = scales(contact, g_n).tangential_stiffness_n_per_m * 10.0 ** rng.uniform(-1, 1)
        contact = Contact(first, second, contact.friction_coefficient, stiffness)
    crossing = g_n * 10.0 ** rng.uniform(-1.0, 1.5)
    direction = rng.uniform(0.0, 2.0 * math.pi)
    spins = [
        tuple((rng.normal(size=3) * crossing / radius * rng.choice([0.0, 1.0])).tolist())
        for radius in sizes
    ]
    velocity = (crossing * math.cos(direction), crossing * math.sin(direction), -g_n)
    return contact, Impact(velocity, AT_REST, UP, *spins)


def test_turning_takes_a_third_of_an_oblique_bounce_and_the_warning_says_so(monkeypatch):
    contact = Contact(STEEL, STEEL, 0.4, "mindlin")
    impact = Impact((11.0, 0.0, -1.0), AT_REST, UP)
    lost, moved = changes(contact, impact)
    assert lost == pytest.approx(1.0 - 0.672, abs=1e-3)
    assert estimates(contact, impact, monkeypatch) == pytest.approx((lost, moved), rel=0.05)
    (warning,) = study_scaling(contact, impact).warnings
    assert warning.code == "oblique"
    assert "about 0.32 from ε_n" in warning.text
    assert "ε_t by up to 0.045" in warning.text


def test_spheres_that_do_not_pass_each_other_leave_as_the_model_has_it():
    contact = Contact(STEEL, STEEL, 0.4, "mindlin")
    # the tangential velocity is that of spins alone, and friction hardly moves the centres
    impact = Impact((0.0, 0.0, -1.0), AT_REST, UP, (0.0, -50.0, 0.0))
    # what is left of it is the compression over the radius, 2e-3
    assert changes(contact, impact) == pytest.approx((0.0, 0.0), abs=2e-3)
    assert not is_warned(contact, impact)


def beside(monkeypatch, seed, count):
    """Return estimated and true changes (count, 2) of random impacts, and which are warned of."""
    rng = np.random.default_rng(seed)
    rows = []
    for _ in range(count):
        case = random_impact(rng)
        rows.append((estimates(*case, monkeypatch), changes(*case), (is_warned(*case), 0.0)))
    guessed, true, warned = np.array(rows).transpose(1, 0, 2)
    return guessed, true, warned[:, 0] > 0.0


def assert_near(guessed, true, warned):
    """Hold the estimate and the warning to what docs/real-spheres.md says of them."""
    counted = true > LARGEST_CHANGE
    ratio = [guessed[:, i][counted[:, i]] / true[:, i][counted[:, i]] for i in range(2)]
    for name, each in zip(("normal", "tangential"), ratio, strict=True):
        spread = np.quantile(each, [0.0, 0.05, 0.5, 0.95, 1.0]).round(2).tolist()
        print(f"{name}: estimate over truth {spread} of {each.size}")
    inside = np.mean((ratio[0] > 0.75) & (ratio[0] < 1.5))
    assert inside >= 0.95
    assert np.mean((ratio[1] > 0.5) & (ratio[1] < 3.0)) >= 0.9
    largest = true.max(axis=1)
    assert np.all(warned[largest > 2.0 * LARGEST_CHANGE])
    assert np.mean(largest[warned] > 0.5 * LARGEST_CHANGE) > 0.95


def test_estimate_is_near_what_turning_changes(monkeypatch):
    guessed, true, warned = beside(monkeypatch, 35, 6)
    assert 0 < warned.sum() < 6
    assert_near(guessed, true, warned)


@pytest.mark.verify
def test_estimate_is_near_what_turning_changes_over_materials_speeds_and_angles(monkeypatch):
    assert_near(*beside(monkeypatch, 16, 200))
