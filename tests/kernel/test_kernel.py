"""The kernel in the page answers what the native ones do: the same counts, within both bounds."""

import math

import make_numerics
import numpy as np
import pytest
from kernel_runtimes import collision, column, random_states

from cases import left_to_verify
from restitution.mechanics import limits
from restitution.mechanics.collision import (
    EPISODE,
    MOST_SWITCHES,
    TOO_STIFF,
    _collide_one,
    collide,
)
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
def test_collisions_are_those_of_the_native_kernels(answers, count):
    states = list(zip(*random_states(count, seed=19), strict=True))
    found = answers([["collision", collision(*state)] for state in states])
    native = natively(states)
    assert_same_verdicts(found, native)
    bounds = column(found, "errorBound") + native[:, 3]
    shares = np.abs(column(found, "epsilonT") - native[:, 0]) / bounds
    assert shares.max() <= 1.0
    print(f"{count} collisions: the largest difference is {shares.max():.3f} of both bounds")


def natively(states):
    """Return ε_t, switches, whether they are certain, and the bound, a row for each κ, ψ and η."""
    nothing = np.empty(0, EPISODE)
    return np.array(
        [
            _collide_one(contact_of(eta), MOST_SWITCHES, kappa, psi, nothing)
            for kappa, psi, eta in states
        ]
    )


def assert_same_verdicts(found, native):
    """Hold all that is said of ε_t besides itself to what the native kernels say."""
    _, switches, certain, bound = native.T
    np.testing.assert_array_equal(column(found, "isCertain"), certain)
    # a count that is not certain is a guess, and another processor may guess otherwise
    told = (certain == 1) | (switches == TOO_STIFF)
    np.testing.assert_array_equal(column(found, "switches")[told], switches[told])
    # a contact of η is prepared by a browser's own powers and logarithms
    np.testing.assert_allclose(column(found, "errorBound"), bound, rtol=1e-12)


def test_references_are_met_within_the_bound(answers, reference, damped_reference):
    elastic = zip(reference.kappa, reference.psi, np.zeros(reference.kappa.size), strict=True)
    states = [*elastic, *((d.kappa, d.psi, d.damping) for d in damped_reference)]
    epsilon_t = [*reference.epsilon_t, *(d.epsilon_t for d in damped_reference)]
    switches = [*reference.switches, *(d.switches for d in damped_reference)]
    found = answers([["collision", collision(*state)] for state in states])
    assert_same_verdicts(found, natively(states))
    np.testing.assert_array_equal(column(found, "switches"), switches)
    shares = np.abs(column(found, "epsilonT") - epsilon_t) / column(found, "errorBound")
    assert shares.max() <= 1.0
    print(f"{len(states)} references: the largest error is {shares.max():.3f} of its bound")


def test_extremes_are_met_within_the_bound(answers):
    truths = list(make_numerics.read().values())
    states = [(truth.kappa, truth.psi, 0.0) for truth in truths]
    found = answers([["collision", collision(*state)] for state in states])
    assert_same_verdicts(found, natively(states))
    shares = []
    for truth, ours in zip(truths, found, strict=True):
        if ours["isCertain"] and truth.switches is not None:
            assert ours["switches"] == truth.switches, truth
        # where |ε_t| ≤ 1 is all that is known, the bound of what was not followed says it, too
        known = 0.0 if truth.made == "bound" and ours["switches"] < 0 else truth.uncertainty
        error = truth.error(ours["epsilonT"])
        assert error <= ours["errorBound"] + known, truth
        if truth.made != "bound":
            shares.append(error / ours["errorBound"])
    print(f"{len(shares)} extremes: the largest error is {max(shares):.3f} of its bound")


def test_no_count_next_to_a_border_is_certain_and_wrong(answers):
    borders = [
        (kappa, side, 0.0)
        for kappa, psi, *_ in make_numerics.NEIGHBOURS
        for side in (psi, math.nextafter(psi, math.inf))
    ]
    known = [switches for *_, here, there in make_numerics.NEIGHBOURS for switches in (here, there)]
    found = answers([["collision", collision(*state)] for state in borders])
    assert_same_verdicts(found, natively(borders))
    for ours, switches in zip(found, known, strict=True):
        assert not ours["isCertain"] or ours["switches"] == switches


def test_reversals_are_those_of_sixty_digits(answers, reference_reversals):
    states = reference_reversals[:, :2]
    found = answers([["trace", collision(*state), 2] for state in states])
    np.testing.assert_array_equal(column(found, "reversals"), reference_reversals[:, 2])


def test_normal_motion_is_that_of_high_precision(answers, damped_reference):
    found = answers([["collision", collision(d.kappa, d.psi, d.damping)] for d in damped_reference])
    for name, expected in (("epsilonN", "epsilon_n"), ("contactDuration", "contact_duration")):
        known = [getattr(d, expected) for d in damped_reference]
        np.testing.assert_allclose(column(found, name), known, rtol=1e-13)


@pytest.mark.parametrize("damping", [0.0, 0.1, 3.0])
def test_lists_are_those_of_one_after_the_other(answers, damping):
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
def test_traces_are_those_of_the_service(answers, count):
    states = list(zip(*random_states(count, seed=21), strict=True))
    found = answers([["trace", collision(*state), 100] for state in states])
    shares, ends = [], []
    for state, trace in zip(states, found, strict=True):
        study = study_trace(CollisionParameters(**collision(*state)), samples=100)
        assert_alike(trace, study.collision)
        bounds = trace["errorBound"] + study.collision.error_bound
        ends.append(abs(trace["epsilonT"] - study.collision.epsilon_t) / bounds)
        np.testing.assert_array_equal(trace["regime"], study["regime"])
        for name, theirs in COLUMNS.items():
            scale = np.abs(study[theirs]).max()
            shares.append(np.abs(np.array(trace[name]) - study[theirs]).max() / scale)
    # rounding of a phase √κ t_c of 300
    assert np.max(shares) < 1e-12
    assert max(ends) <= 1.0
    print(f"{count} traces: the largest difference is {np.max(shares):.1e} of a column's largest")
    print(f"of ε_t it is {max(ends):.3f} of both bounds")


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
def test_collisions_without_a_spring_are_those_of_the_service(answers, psi, damping):
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


def test_contacts_of_every_damping_are_those_of_the_service(answers):
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
def test_balls_bounce_as_those_of_the_service(answers, partner, damping):
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
