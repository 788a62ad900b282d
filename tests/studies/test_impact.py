"""Impacts in three dimensions: what they conserve and lose, and that no frame is preferred."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from restitution.errors import ParameterError
from restitution.studies.spheres.bodies import Moment, Sphere, Wall
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Impact, Velocities

GLASS = Sphere(0.0031, 6.9e10, 0.24, mass_kg=3e-4, inertia=Moment(1.4e-9))
LIGHT = Sphere(0.011, 3.2e9, 0.37, density_kg_m3=410.0, inertia="hollow")

VECTOR = st.tuples(*[st.floats(-30.0, 30.0)] * 3)
DIRECTION = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 0.01)
INERTIA = st.one_of(st.sampled_from(["solid", "hollow"]), st.floats(1e-9, 1e-3).map(Moment))


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
    Contact,
    spheres(),
    spheres(),
    st.floats(0.0, 2.0),
    st.one_of(st.just("mindlin"), st.floats(1.0, 1e12)),
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
        own = factor is None
        inertia = body.inertia.moment_kg_m2 if own else factor * body.mass_kg * body.radius_m**2
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
    contact = Contact(*bodies, 0.3, "mindlin")
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
    contact = Contact(GLASS, LIGHT, 0.3, "mindlin")
    impact = Impact((1.0, -2.0, 0.5), (0.2, 0.1, 0.9), (-1.0, 3.0, 0.2), (40.0, 9.0, -7.0))
    straight = study_scaling(contact, impact).after
    # a cyclic change of axes is a rotation without rounding
    v1, v2, w1, w2 = (tuple(np.roll(v, 1).tolist()) for v in motion_before(impact))
    normal = tuple(np.roll(impact.normal, 1).tolist())
    turned = study_scaling(contact, Impact(v1, v2, normal, w1, w2)).after
    for mine, its in zip(straight, turned, strict=True):
        assert np.roll(mine, 1) == pytest.approx(its, rel=1e-12)


def test_both_forms_of_an_impact_agree():
    contact = Contact(GLASS, Wall(2e11, 0.3), 0.2, "mindlin")
    moving = study_scaling(contact, Impact((0.3, 0.0, -2.0), (0.0,) * 3, (0.0, 0.0, 7.0)))
    given_velocities = study_scaling(contact, Velocities(2.0, 0.3))
    assert moving.epsilon_t == given_velocities.epsilon_t
    assert moving.kappa == given_velocities.kappa
    assert given_velocities.after is None
    assert moving.after.velocity_2_m_s == (0.0, 0.0, 0.0)


def test_spin_alone_moves_the_surfaces():
    contact = Contact(GLASS, Wall(2e11, 0.3), 0.2, "mindlin")
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
        study_scaling(Contact(GLASS, Wall(2e11, 0.3), 0.2, "mindlin"), impact)


def test_centre_ratio_of_a_computed_impact_converts_back():
    contact = Contact(GLASS, Wall(2e11, 0.3), 0.2, "mindlin")
    study = study_scaling(contact, Impact((0.5, 0.0, -2.0), (0.0,) * 3, (0.0, 0.0, 1.0)))
    ratio = study.after.velocity_1_m_s[0] / 0.5
    assert 1 - (1 - ratio) / study.alpha == pytest.approx(study.epsilon_t, abs=1e-14)
