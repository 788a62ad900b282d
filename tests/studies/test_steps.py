"""The calculator of steps per contact: what it promises holds, by itself and by the report."""

import numpy as np
import pytest

from cases import every_day
from restitution.mechanics.collision import collide
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.mechanics.stepping import step_collisions
from restitution.studies.accuracy.candidates import STEPS
from restitution.studies.accuracy.scenes import SCENES
from restitution.studies.accuracy.steps import (
    ABOUT_AN_ANSWER,
    LADDER,
    TWINS,
    Tried,
    study_steps,
)
from restitution.studies.accuracy.tradeoff import load_tradeoff
from restitution.studies.collision.parameters import CollisionParameters
from work import counted

ONE = CollisionParameters(18.0, 1.4, 0.5)
DAMPED = CollisionParameters(18.0, 1.4, 0.5, 0.3)
MEASURED = ["figure4", "stiff", "solids", "damped"]


def errors(collision, steps, integrator, phases):
    kappa, psi = np.array([collision.kappa]), np.array([collision.psi])
    exact = collide(kappa, psi, collision.damping, 1000.0).epsilon_t
    stepped = [
        step_collisions(kappa, psi, steps, integrator, phase, damping=collision.damping)
        for phase in phases
    ]
    return np.array([abs(one.epsilon_t - exact) for one in stepped])


@pytest.mark.parametrize("collision", [ONE, DAMPED])
@pytest.mark.parametrize("integrator", ["velocity_verlet", "forward_euler"])
@pytest.mark.parametrize("error", every_day([1e-2], of=[1e-2, 1e-3]))
def test_steps_needed_keep_the_error_and_fewer_do_not(collision, integrator, error):
    study = study_steps(error, collision)
    needed, phases = study.needed[integrator], np.arange(32) / 32
    assert needed.reason is None
    assert needed.p95 <= needed.worst
    tried = needed.worst_tried
    assert tried.first <= needed.worst <= tried.last
    assert tried.last in LADDER
    above = [n for n in LADDER if n > tried.last]
    # the largest hold by the ladder, and take too long to be looked at again
    for steps in [*range(needed.worst, tried.last + 1)[:: 1 + tried.last // 300], *above[:3]]:
        assert errors(collision, steps, integrator, phases).max() <= error, steps
    below = LADDER[LADDER.index(tried.first) - 1]
    assert errors(collision, below, integrator, phases).max() > error


def test_a_number_of_steps_between_two_rungs_that_fails_is_not_hidden_by_them():
    # every rung from 91 on keeps a thousandth, 98 steps do not
    phases = np.arange(32) / 32
    assert errors(ONE, 91, "velocity_verlet", phases).max() <= 1e-3
    assert errors(ONE, 98, "velocity_verlet", phases).max() > 1.2e-3
    needed = study_steps(1e-3, ONE).needed["velocity_verlet"]
    assert (needed.worst, needed.worst_tried) == (100, Tried(91, 181, 91))


@pytest.mark.verify
def test_no_number_of_steps_above_the_answer_fails():
    rng = np.random.default_rng(1)
    phases = np.arange(32) / 32
    over = []
    while len(over) < 40:
        kappa, psi = 10.0 ** rng.uniform(-0.5, 2.6), 10.0 ** rng.uniform(-1.5, 0.4)
        error = 10.0 ** rng.uniform(-3.3, -1.7)
        collision = CollisionParameters(kappa, 1.0, psi)
        needed = study_steps(error, collision).needed["velocity_verlet"]
        # of larger ones not every number was tried
        if needed.worst is None or needed.worst > 250:
            continue
        every = range(needed.worst, 5 * needed.worst)
        over.append(max(errors(collision, n, "velocity_verlet", phases).max() for n in every))
        assert over[-1] <= error, (kappa, psi, error)
        others = (np.arange(32) + 0.37) / 32
        nearest = range(needed.worst, 2 * needed.worst)
        between = max(errors(collision, n, "velocity_verlet", others).max() for n in nearest)
        # an instant between two that were tried may be a little worse
        assert between <= 1.15 * error, (kappa, psi, error)


def test_steps_needed_hold_for_phases_that_were_not_tried():
    needed = study_steps(1e-3, ONE).needed["velocity_verlet"]
    others = (np.arange(200) + 0.37) / 200
    # between 32 phases the error cannot rise much; it is continuous in the phase
    assert errors(ONE, needed.worst, "velocity_verlet", others).max() <= 1.1e-3


def test_an_error_that_comes_back_with_more_steps_is_not_met():
    study = study_steps(1e-3, CollisionParameters(2840.0, 1.0, 0.204))
    met = {n: spread.error_max <= 1e-3 for name, n, spread in study.ladder if "forward" in name}
    worst = study.needed["forward_euler"].worst
    failing = max(n for n in LADDER if not met[n])
    assert failing < worst
    assert any(met[n] for n in LADDER if n < failing)


STIFF_ONE = CollisionParameters(1e4, 1.0, 0.01)


@pytest.mark.parametrize(
    "where", every_day([ONE, STIFF_ONE, "stiff"], of=[ONE, STIFF_ONE, "stiff", "damped"])
)
def test_work_is_bounded_before_it_whatever_is_asked(where):
    with counted() as work:
        study = study_steps(1e-3, where)
    contacts = study.collisions * study.phases
    # two integrators, the ladder and what is tried about two answers each; a step more or less
    tried = 2 * (sum(LADDER) + 2 * (ABOUT_AN_ANSWER + sum(LADDER[-3:])))
    by_rule = 2 * 2 * study.collisions * study.rule_steps[1]
    # a contact is allowed twice its steps, and four
    assert work["steps"] <= 2.1 * (contacts * tried + by_rule)


def test_what_no_rung_meets_is_none_with_a_reason():
    needed = study_steps(1e-12, ONE).needed["forward_euler"]
    assert needed.p95 is None
    assert needed.worst is None
    assert "65,536 steps" in needed.reason


@pytest.mark.parametrize("kappa", [18.0, 1e4])
def test_stability_limit_is_half_the_phase_of_a_swing(kappa):
    study = study_steps(1e-3, CollisionParameters(kappa, 1.0, 1e-9))
    assert study.stability_limit == pytest.approx(np.sqrt(kappa) * CONTACT_DURATION / 2)
    largest = {n: s.error_max for name, n, s in study.ladder if name == "velocity_verlet"}
    # a swing that gains energy in each step is soon far beyond ±1
    unstable = [n for n in LADDER if n < 0.9 * study.stability_limit]
    stable = [n for n in LADDER if n > 1.1 * study.stability_limit]
    assert min(largest[n] for n in unstable[-2:]) > 10 * max(largest[n] for n in stable)


def test_stability_limit_is_that_of_the_damped_contact():
    for damping in (1e-6, 0.3, 5.0):
        study = study_steps(1e-3, CollisionParameters(18.0, 1.4, 0.5, damping))
        phase = np.sqrt(18.0) * contact_duration(damping)
        assert study.stability_limit == pytest.approx(phase / 2), damping


def test_vanishing_damping_needs_the_steps_of_none():
    # but for the share of 1e-9 by which the errors then differ
    none, vanishing = (
        study_steps(1e-3, CollisionParameters(18.0, 1.4, 0.5, damping)) for damping in (0.0, 1e-12)
    )
    assert vanishing.needed == none.needed


def test_rule_of_fifty_keeps_95_percent_of_figure_4_within_a_thousandth():
    study = study_steps(1e-3, "figure4")
    spread = study.rule["velocity_verlet"]
    assert spread.error_p95 < 1e-3 < spread.error_max < 1e-2
    # of real solids it leaves single ones ten times as far off
    assert study_steps(1e-3, "solids").rule["velocity_verlet"].error_max > 1e-2


def test_worst_errors_do_not_go_with_the_stiffness():
    # κ from 0.1 to 10⁶, and yet the same 700 steps or so
    for region in ("figure4", "stiff", "solids"):
        assert 500 < study_steps(1e-3, region).needed["velocity_verlet"].worst <= 1024, region


def test_rule_is_not_tried_beyond_the_steps_of_a_request():
    study = study_steps(1e-3, CollisionParameters(1e12, 1.0, 1.0))
    assert study.rule_steps == (5e7, 5e7)
    assert study.rule["velocity_verlet"].error_max is None


@pytest.mark.parametrize("region", every_day(["figure4"], of=MEASURED))
@pytest.mark.parametrize("error", every_day([1e-3], of=[1e-2, 1e-3, 1e-4]))
def test_steps_needed_agree_with_the_measured_table(region, error):
    rows = {
        row["options"]["steps"]: row["error_p95"]
        for row in load_tradeoff()[region]["rows"]
        if row["options"].get("integrator") == "velocity_verlet"
    }
    needed = study_steps(error, region).needed["velocity_verlet"].p95
    # two samples of some thousand contacts: their p95 agree within a fifth
    for steps in STEPS:
        if steps >= needed:
            assert rows[steps] <= 1.2 * error
        if steps < needed / 2:
            assert rows[steps] > 0.8 * error


@pytest.mark.parametrize("region", every_day(["solids"], of=SCENES))
def test_every_region_is_answered(region):
    study = study_steps(1e-3, region)
    assert study.collisions == 128
    assert [name for name, _, _ in study.ladder].count("forward_euler") == len(LADDER)
    for twin, other in TWINS.items():
        assert study.needed[twin] == study.needed[other]
