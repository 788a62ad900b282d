"""A ball before and after it bounces: as real bodies do, and by what a bounce leaves as it was."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from restitution.errors import ParameterError
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.spheres.bodies import Moment, Sphere, Wall
from restitution.studies.spheres.bounce import study_bounce
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Impact

INERTIA = st.one_of(
    st.sampled_from(["solid", "hollow"]),
    # α from 1/10001 to 0.9
    st.floats(4e-9, 3.6e-4).map(Moment),
)


AGREES = 1e-11
"""Of a velocity of some g_n: rounding of both ways, of which one scales by materials."""


@st.composite
def contacts(draw):
    ball = Sphere(
        0.02,
        draw(st.floats(1e6, 1e12)),
        draw(st.floats(0.0, 0.5)),
        mass_kg=0.1,
        inertia=draw(INERTIA),
    )
    other = draw(st.sampled_from([Wall(7e10, 0.25), ball]))
    damping = draw(st.sampled_from([0.0, 1e-6]))
    friction = draw(st.floats(0.0, 1.5))
    return Contact(ball, other, friction, "mindlin", dissipative_constant_s=damping)


def motions_of_bodies(contact, impact, direction):
    """Return the study, and the first body's motion before and after, over g_n."""
    study = study_scaling(contact, impact)
    speed = study.normal_velocity_m_s
    states = [
        (impact.velocity_1_m_s, impact.spin_1_rad_s),
        (study.after.velocity_1_m_s, study.after.spin_1_rad_s),
    ]
    radius = contact.body_1.radius_m
    return study, [
        (v[2] / speed, direction * v[0] / speed, direction * radius * spin[1] / speed)
        for v, spin in states
    ]


def impact_of(contact, normal_velocity, centre, spin):
    """Return an impact along z with velocities of the first body along x; a sphere mirrors it."""
    share = 1.0 if isinstance(contact.body_2, Wall) else 0.5
    velocity = (centre * normal_velocity, 0.0, -share * normal_velocity)
    turning = (0.0, spin * normal_velocity / contact.body_1.radius_m, 0.0)
    is_wall = share == 1.0
    return Impact(
        velocity_1_m_s=velocity,
        velocity_2_m_s=(0.0, 0.0, 0.0) if is_wall else (-velocity[0], 0.0, -velocity[2]),
        normal=(0.0, 0.0, 1.0),
        spin_1_rad_s=turning,
        spin_2_rad_s=(0.0, 0.0, 0.0) if is_wall else turning,
    )


def collision_of(study):
    return CollisionParameters(study.kappa, study.mu_over_alpha, study.gt_over_gn, study.damping)


def as_tuple(motion):
    return motion.normal_velocity, motion.centre_velocity, motion.spin_velocity


@given(
    contacts(),
    st.floats(0.05, 20.0),
    st.floats(0.001, 10.0),
    st.floats(0.0, 1.0),
    st.sampled_from([-1, 1]),
)
def test_ball_comes_and_leaves_as_one_of_real_bodies(contact, speed, gt_over_gn, share, direction):
    is_wall = isinstance(contact.body_2, Wall)
    relative = gt_over_gn * (1.0 if is_wall else 0.5)
    centre, spin = (1.0 - share) * relative, -share * relative
    impact = impact_of(contact, speed, direction * centre, direction * spin)
    study, real = motions_of_bodies(contact, impact, direction)
    found = study_bounce(
        collision_of(study),
        alpha=study.alpha,
        partner="wall" if is_wall else "sphere",
        spin_share=share,
    )
    assert found.first.epsilon_t == study.epsilon_t
    for motion, expected in zip(found.motions, real, strict=False):
        assert as_tuple(motion) == pytest.approx(expected, rel=0, abs=AGREES)


@given(contacts(), st.floats(0.05, 20.0), st.floats(0.001, 10.0), st.floats(0.0, 1.0))
def test_second_collision_is_that_of_real_bodies_that_come_back(contact, speed, gt_over_gn, share):
    contact = replace(contact, body_2=Wall(7e10, 0.25))
    contact = replace(
        contact,
        # Mindlin's stiffness goes with the impact, that of one contact does not
        tangential_stiffness_n_per_m=study_scaling(
            contact, impact_of(contact, speed, gt_over_gn, 0.0)
        ).tangential_stiffness_n_per_m,
    )
    impact = impact_of(contact, speed, (1.0 - share) * gt_over_gn, -share * gt_over_gn)
    study, (_, leaves) = motions_of_bodies(contact, impact, 1)
    found = study_bounce(collision_of(study), alpha=study.alpha, spin_share=share)
    normal, centre, spin = leaves
    again = impact_of(contact, normal * speed, centre / normal, spin / normal)
    second, (_, leaves_again) = motions_of_bodies(contact, again, 1)
    # a contact that stops the surfaces leaves them with rounding errors alone
    if abs(study.epsilon_t) > 1e-9:
        assert found.second.direction == np.sign(study.epsilon_t)
        for name in ("kappa", "mu_over_alpha", "gt_over_gn", "damping"):
            assert vars(found.second)[name] == pytest.approx(vars(second)[name], rel=1e-6), name
    # in units of g_n of the first one
    expected = [normal * value for value in leaves_again]
    assert as_tuple(found.motions[2]) == pytest.approx(expected, rel=0, abs=1e-7)


@given(
    st.floats(0.1, 1e3),
    st.floats(0.0, 4.0),
    st.floats(0.0, 10.0),
    st.sampled_from([0.0, 0.2]),
    st.floats(0.01, 1.0),
    st.floats(0.0, 1.0),
    st.sampled_from(["wall", "sphere"]),
)
def test_bounces_keep_the_angular_momentum_about_the_contact_and_lose_energy(
    kappa, friction, gt_over_gn, damping, alpha, share, partner
):
    parameters = CollisionParameters(kappa, friction, gt_over_gn, damping)
    found = study_bounce(parameters, alpha=alpha, partner=partner, spin_share=share)
    # J/(mR²) = α/(1 − α)
    momenta = [(1.0 - alpha) * m.centre_velocity + alpha * m.spin_velocity for m in found.motions]
    assert momenta == pytest.approx([momenta[0]] * len(momenta), rel=0, abs=1e-13)
    energies = [
        (1.0 - alpha) * (m.normal_velocity**2 + m.centre_velocity**2) + alpha * m.spin_velocity**2
        for m in found.motions
    ]
    assert np.all(np.diff(energies) <= 1e-13 * energies[0])


def test_what_leaves_is_linear_in_epsilon_t_by_the_two_factors():
    found = study_bounce(CollisionParameters(4.5, 1.4, 1.1), alpha=0.4, spin_share=0.25)
    before, after = found.motions[:2]
    lost = (1.0 - found.first.epsilon_t) * 1.1
    assert after.centre_velocity == before.centre_velocity + found.centre_change * lost
    assert after.spin_velocity == before.spin_velocity + found.spin_change * lost
    other = study_bounce(CollisionParameters(63.0, 0.7, 0.2, 0.1), alpha=0.4)
    assert (other.centre_change, other.spin_change) == (found.centre_change, found.spin_change)


def test_superball_hops_to_and_fro():
    """A gear wheel, ε_t = −1, of which 5/7 of g_t are spin goes back as it came, and again."""
    gear_wheel = CollisionParameters(0.95304, 1e5, 1.0)
    found = study_bounce(gear_wheel, spin_share=5 / 7)
    assert found.first.epsilon_t == pytest.approx(-1.0, abs=1e-3)
    ways = [m.centre_velocity for m in found.motions]
    assert ways == pytest.approx([2 / 7, -2 / 7, 2 / 7], abs=1e-3)
    assert found.second.direction == -1


def test_ball_that_leaves_with_surfaces_at_rest_rolls():
    """ε_t = 0, as ψ = 2: the rim is then as fast as the centre."""
    stopped = CollisionParameters(4.5, 1.4, 2.8)
    found = study_bounce(stopped)
    assert found.first.epsilon_t == pytest.approx(0.0, abs=1e-14)
    after = found.motions[1]
    assert after.spin_velocity == pytest.approx(after.centre_velocity, abs=1e-13)


def test_sphere_does_not_come_back_and_nor_does_what_no_double_holds():
    parameters = CollisionParameters(4.5, 1.4, 1.1)
    found = study_bounce(parameters, partner="sphere")
    assert found.second is None
    assert len(found.motions) == 2
    beyond = study_bounce(CollisionParameters(1e300, 1.4, 1.1, 1e30))
    assert beyond.second is None
    assert len(beyond.motions) == 2


def test_no_tangential_velocity_has_no_direction():
    found = study_bounce(CollisionParameters(4.5, 1.4, 0.0))
    assert (found.first.direction, found.second.direction) == (0, 0)
    assert as_tuple(found.motions[1]) == (1.0, 0.0, 0.0)


def test_velocity_beyond_double_precision_is_refused_in_words():
    fast = CollisionParameters(0.953, 1.7e308, 1.7e308)
    with pytest.raises(ParameterError, match=r"spin_velocity must be within 1.7e308"):
        study_bounce(fast, alpha=0.01)
