"""The kernel in the page answers what the native ones do: the same counts, within both bounds."""

import math

import numpy as np
import pytest
from kernel_in_node import answers, column, random_states

from cases import left_to_verify
from restitution.mechanics.collision import EPISODE, MOST_SWITCHES, _collide_one, collide
from restitution.mechanics.contact import (
    contact_duration,
    contact_of,
    largest_force,
    normal_restitution,
)
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.trace import study_trace

COLUMNS = {
    "time": "time",
    "compression": "compression",
    "compressionRate": "compression_rate",
    "normalForce": "normal_force",
    "tangentialVelocity": "tangential_velocity",
    "springElongation": "spring_elongation",
    "tangentialForce": "tangential_force_over_mu",
    "tangentialEnergy": "tangential_energy",
}
"""Of a trace in the page, and as the service has them."""


@pytest.mark.parametrize("count", [2000, left_to_verify(100_000)])
def test_collisions_are_those_of_the_native_kernels(count):
    states = random_states(count, seed=19)
    found = answers([["collision", *map(float, state)] for state in zip(*states, strict=True)])
    nothing = np.empty(0, EPISODE)
    native = np.array(
        [
            _collide_one(contact_of(eta), MOST_SWITCHES, kappa, psi, nothing)
            for kappa, psi, eta in zip(*states, strict=True)
        ]
    )
    np.testing.assert_array_equal(column(found, "switches"), native[:, 1])
    np.testing.assert_array_equal(column(found, "isCertain"), native[:, 2])
    bounds = column(found, "errorBound") + native[:, 3]
    shares = np.abs(column(found, "epsilonT") - native[:, 0]) / bounds
    assert shares.max() <= 1.0
    print(f"{count} collisions: the largest difference is {shares.max():.3f} of both bounds")


def test_references_are_met_within_the_bound(reference, damped_reference):
    elastic = zip(reference.kappa, reference.psi, np.zeros(reference.kappa.size), strict=True)
    states = [*elastic, *((d.kappa, d.psi, d.damping) for d in damped_reference)]
    epsilon_t = [*reference.epsilon_t, *(d.epsilon_t for d in damped_reference)]
    switches = [*reference.switches, *(d.switches for d in damped_reference)]
    found = answers([["collision", *map(float, state)] for state in states])
    np.testing.assert_array_equal(column(found, "switches"), switches)
    shares = np.abs(column(found, "epsilonT") - epsilon_t) / column(found, "errorBound")
    assert shares.max() <= 1.0
    print(f"{len(states)} references: the largest error is {shares.max():.3f} of its bound")


@pytest.mark.parametrize("damping", [0.0, 0.1, 3.0])
def test_lists_are_those_of_one_after_the_other(damping):
    kappa, psi, _ = random_states(9000, seed=20)
    calls = [["collision", k, p, damping] for k, p in zip(kappa, psi, strict=True)]
    listed, *singly = answers([["collisions", [*kappa], [*psi], damping], *calls])
    native = collide(kappa, psi, damping)
    for name, expected in (("switches", native.switches), ("isCertain", native.switches_certain)):
        np.testing.assert_array_equal(column(singly, name), expected)
        np.testing.assert_array_equal(listed[name], expected)
    bounds = column(singly, "errorBound") + listed["errorBound"]
    assert np.all(np.abs(column(singly, "epsilonT") - listed["epsilonT"]) <= bounds)
    assert np.all(np.abs(native.epsilon_t - listed["epsilonT"]) <= bounds)


@pytest.mark.parametrize("count", [60, left_to_verify(1000)])
def test_traces_are_those_of_the_service(count):
    states = list(zip(*random_states(count, seed=21), strict=True))
    found = answers([["trace", *map(float, state), 100] for state in states])
    shares = []
    for (kappa, psi, damping), trace in zip(states, found, strict=True):
        study = study_trace(CollisionParameters(kappa, 1.0, psi, damping), samples=100)
        collision = study.collision
        assert trace["switches"] == collision.switches
        assert trace["reversals"] == collision.reversals
        np.testing.assert_array_equal(trace["regime"], study["regime"])
        units = {"tangentialVelocity": psi, "springElongation": psi, "tangentialEnergy": psi**2}
        for name, theirs in COLUMNS.items():
            sign = -1.0 if name == "tangentialForce" else 1.0
            ours = sign * units.get(name, 1.0) * np.array(trace[name])
            scale = np.abs(study[theirs]).max()
            shares.append(np.abs(ours - study[theirs]).max() / scale)
    # rounding of a phase √κ t_c of 300
    assert np.max(shares) < 1e-12
    print(f"{count} traces: the largest difference is {np.max(shares):.1e} of a column's largest")


@pytest.mark.parametrize("damping", [0.0, 0.3])
@pytest.mark.parametrize("psi", [0.0, math.inf])
def test_collisions_without_a_spring_are_those_of_the_service(psi, damping):
    collision, trace = answers([["collision", 18.0, psi, damping], ["trace", 18.0, psi, damping]])
    native = collide(18.0, psi, damping)
    assert (collision["switches"], collision["isCertain"]) == (0, True)
    assert collision["epsilonT"] == pytest.approx(float(native.epsilon_t), abs=1e-14)
    friction = 0.0 if psi else 1.0
    study = study_trace(CollisionParameters(18.0, friction, float(psi > 0.0), damping))
    np.testing.assert_array_equal(trace["regime"], study["regime"])
    np.testing.assert_array_equal(trace["starts"], [0.0])
    np.testing.assert_allclose(trace["tangentialVelocity"], study["tangential_velocity"])
    np.testing.assert_allclose(trace["springElongation"], study["spring_elongation"])
    force = study["tangential_force_over_mu"]
    np.testing.assert_allclose(-np.array(trace["tangentialForce"]), force, atol=1e-14)
    slope = study.collision.sensitivity
    assert trace["sensitivity"]["kappa"] == pytest.approx(slope.kappa, abs=1e-13)


def test_contacts_of_every_damping_are_those_of_the_service():
    dampings = [0.0, 1e-300, 1e-100, 1e-20, 0.999, 1.0, 1e10, 1e30]
    calls = [[["contactOf", d], ["collision", 18.0, 0.3, d]] for d in dampings]
    found = answers([call for pair in calls for call in pair])
    for damping, contact, ours in zip(dampings, found[::2], found[1::2], strict=True):
        assert contact["duration"] == pytest.approx(contact_duration(damping), rel=1e-14)
        assert contact["normalRestitution"] == pytest.approx(normal_restitution(damping), rel=1e-13)
        assert contact["largestForce"] == pytest.approx(largest_force(damping), rel=1e-14)
        native = collide(18.0, 0.3, damping)
        assert ours["switches"] == native.switches
        assert ours["isCertain"] == native.switches_certain
        assert abs(ours["epsilonT"] - native.epsilon_t) <= 2.0 * native.error_bound
