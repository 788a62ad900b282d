"""The kernel in the page answers what the native ones do: the same counts, within both bounds."""

import math

import numpy as np
import pytest
from kernel_in_node import answers, collision, column, random_states

from cases import left_to_verify
from restitution.mechanics import limits
from restitution.mechanics.collision import EPISODE, MOST_SWITCHES, _collide_one, collide
from restitution.mechanics.contact import contact_duration, contact_of, normal_restitution
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.trace import study_trace
from restitution.studies.spheres.bounce import study_bounce

COLUMNS = {
    "time": "time",
    "compression": "compression",
    "compressionRate": "compression_rate",
    "normalForce": "normal_force",
    "tangentialVelocity": "tangential_velocity",
    "springElongation": "spring_elongation",
    "tangentialForceOverMu": "tangential_force_over_mu",
    "tangentialEnergy": "tangential_energy",
}
"""Of a trace in the page, and as the service has them."""


@pytest.mark.parametrize("count", [2000, left_to_verify(100_000)])
def test_collisions_are_those_of_the_native_kernels(count):
    states = random_states(count, seed=19)
    found = answers([["collision", collision(*state)] for state in zip(*states, strict=True)])
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
    found = answers([["collision", collision(*state)] for state in states])
    np.testing.assert_array_equal(column(found, "switches"), switches)
    shares = np.abs(column(found, "epsilonT") - epsilon_t) / column(found, "errorBound")
    assert shares.max() <= 1.0
    print(f"{len(states)} references: the largest error is {shares.max():.3f} of its bound")


@pytest.mark.parametrize("damping", [0.0, 0.1, 3.0])
def test_lists_are_those_of_one_after_the_other(damping):
    kappa, psi, _ = random_states(9000, seed=20)
    asked = {"kappa": [*kappa], "muOverAlpha": 1.0, "gtOverGn": [*psi], "damping": damping}
    calls = [["collision", collision(k, p, damping)] for k, p in zip(kappa, psi, strict=True)]
    lists = [["collisions", asked], ["simpleLaws", asked, normal_restitution(damping)]]
    listed, laws, *singly = answers([*lists, *calls])
    native = collide(kappa, psi, damping)
    for name, expected in (("switches", native.switches), ("isCertain", native.switches_certain)):
        np.testing.assert_array_equal(column(singly, name), expected)
        np.testing.assert_array_equal(listed[name], expected)
    bounds = column(singly, "errorBound") + listed["errorBound"]
    assert np.all(np.abs(column(singly, "epsilonT") - listed["epsilonT"]) <= bounds)
    assert np.all(np.abs(native.epsilon_t - listed["epsilonT"]) <= bounds)
    coulomb = limits.coulomb_restitution(psi, normal_restitution(damping))
    np.testing.assert_allclose(laws["coulomb"], coulomb, rtol=1e-13)
    np.testing.assert_allclose(column(singly, "coulomb"), coulomb, rtol=1e-13)
    for name, law in (("stiffBound", "stiff_bound"), ("stiffAsymptote", "stiff_asymptote")):
        expected = getattr(limits, law)(kappa, psi) if damping == 0.0 else np.full(9000, np.nan)
        np.testing.assert_allclose(np.array(laws[name], float), expected, rtol=1e-13)


@pytest.mark.parametrize("count", [60, left_to_verify(1000)])
def test_traces_are_those_of_the_service(count):
    states = list(zip(*random_states(count, seed=21), strict=True))
    found = answers([["trace", collision(*state), 100] for state in states])
    shares = []
    for state, trace in zip(states, found, strict=True):
        study = study_trace(CollisionParameters(**collision(*state)), samples=100)
        assert_alike(trace, study.collision)
        np.testing.assert_array_equal(trace["regime"], study["regime"])
        for name, theirs in COLUMNS.items():
            scale = np.abs(study[theirs]).max()
            shares.append(np.abs(np.array(trace[name]) - study[theirs]).max() / scale)
    # rounding of a phase √κ t_c of 300
    assert np.max(shares) < 1e-12
    print(f"{count} traces: the largest difference is {np.max(shares):.1e} of a column's largest")


def assert_alike(trace, study):
    """Hold what a trace says besides its columns to what the service has."""
    assert (trace["switches"], trace["isCertain"]) == (study.switches, study.switches_certain)
    assert trace["reversals"] == study.reversals
    starts = [episode.start for episode in study.episodes]
    np.testing.assert_allclose(trace["starts"][:200], starts, rtol=1e-12, atol=1e-12)
    assert trace["directions"][:200] == [episode.direction for episode in study.episodes]
    for name, expected in {
        "firstEpisodeShare": study.first_episode_share,
        "dissipatedShare": study.energy.dissipated_share,
        "coulomb": study.estimates.coulomb,
        "contactDuration": study.contact_duration,
        "epsilonN": study.epsilon_n,
        "errorBound": study.error_bound,
    }.items():
        assert trace[name] == pytest.approx(expected, rel=1e-12, abs=1e-12), name


@pytest.mark.parametrize("damping", [0.0, 0.3])
@pytest.mark.parametrize("psi", [0.0, math.inf])
def test_collisions_without_a_spring_are_those_of_the_service(psi, damping):
    given = collision(18.0, psi, damping)
    alone, trace = answers([["collision", given], ["trace", given, 400]])
    native = collide(18.0, psi, damping)
    assert (alone["switches"], alone["isCertain"]) == (0, True)
    assert alone["epsilonT"] == pytest.approx(float(native.epsilon_t), abs=1e-14)
    study = study_trace(CollisionParameters(**given))
    assert_alike(trace, study.collision)
    np.testing.assert_array_equal(trace["regime"], study["regime"])
    for name, theirs in COLUMNS.items():
        np.testing.assert_allclose(trace[name], study[theirs], atol=1e-14)


def test_contacts_of_every_damping_are_those_of_the_service():
    dampings = [0.0, 1e-300, 1e-100, 1e-20, 0.999, 1.0, 1e10, 1e30]
    found = answers([["collision", collision(18.0, 0.3, damping)] for damping in dampings])
    for damping, ours in zip(dampings, found, strict=True):
        assert ours["contactDuration"] == pytest.approx(contact_duration(damping), rel=1e-14)
        assert ours["epsilonN"] == pytest.approx(normal_restitution(damping), rel=1e-13)
        native = collide(18.0, 0.3, damping)
        assert ours["switches"] == native.switches
        assert ours["isCertain"] == native.switches_certain
        assert abs(ours["epsilonT"] - native.epsilon_t) <= 2.0 * native.error_bound


@pytest.mark.parametrize("partner", ["wall", "sphere"])
@pytest.mark.parametrize("damping", [0.0, 0.2])
def test_balls_bounce_as_those_of_the_service(partner, damping):
    given = collision(18.0, 0.7, damping)
    (first,) = answers([["collision", given]])
    (found,) = answers([["bounce", 0.3, partner, given, first]])
    study = study_bounce(CollisionParameters(**given), alpha=0.3, partner=partner)
    assert found["massShare"] == study.mass_share
    assert found["centreChange"] == study.centre_change
    assert found["spinChange"] == study.spin_change
    if study.second:
        assert found["kappa"] == pytest.approx(study.second.kappa, rel=1e-13)
        assert found["gtOverGn"] == pytest.approx(study.second.gt_over_gn, rel=1e-12)
        assert found["damping"] == pytest.approx(study.second.damping, rel=1e-13)
