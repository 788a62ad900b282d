"""The motion in time: Newton's law, the cap, energy, turns, sensitivity, another solver."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solver import solve_with_events

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import collide
from restitution.mechanics.contact import normal_curves
from restitution.mechanics.curves import tangential_curves
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.mechanics.motion import motion, reversals, sensitivity

kappas = st.builds(lambda e: 10.0**e, st.floats(-3, 4))
psis = st.builds(lambda e: 10.0**e, st.floats(-4, 1))


@given(kappas, psis)
def test_episodes_alternate_and_fill_the_contact(kappa, psi):
    path = motion(kappa, psi)
    assert path.start[0] == 0.0
    assert np.all(np.diff(path.start) >= 0.0)
    assert path.end[-1] == CONTACT_DURATION
    assert np.all((path.direction != 0) == (np.arange(path.start.size) % 2 == 0))
    assert path.switches == collide(kappa, psi).switches


@given(kappas, psis)
def test_sliding_changes_side_each_time_from_the_third_episode_of_it(kappa, psi):
    sides = motion(kappa, psi).direction[2::2]
    assert np.all(sides[1:] == -sides[:-1])


@given(kappas, psis)
def test_motion_obeys_newton_and_the_cap_and_loses_energy_only_by_sliding(kappa, psi):
    path = motion(kappa, psi)
    inner = np.linspace(0.0, CONTACT_DURATION, 4001)
    time = np.sort(np.concatenate([inner, path.start]))
    curves = tangential_curves(path, time)
    cap = normal_curves(time)[2]
    assert np.all(np.abs(curves.force) <= cap * (1 + 1e-14))
    energy = curves.velocity**2 + (np.sqrt(kappa) * curves.elongation) ** 2
    rises = np.diff(energy)
    rounding = 1e-14 * (1.0 + np.sqrt(kappa)) * (1 + 1 / psi)
    assert rises.max() <= rounding
    sticking = (curves.regime[:-1] == 0) & (curves.regime[1:] == 0)
    assert np.all(np.abs(rises[sticking]) <= rounding)
    # ∫F dt by the trapezoidal rule against the loss of velocity
    step = np.diff(time)
    impulse = np.sum(0.5 * step * (curves.force[1:] + curves.force[:-1]))
    curvature = (1.0 + kappa) * (CONTACT_DURATION / 4000) ** 2
    assert abs(psi * (curves.velocity[-1] - 1.0) + impulse) <= curvature * (1 + psi)


@given(kappas, psis)
def test_last_velocity_is_epsilon_t(kappa, psi):
    path = motion(kappa, psi)
    last = tangential_curves(path, np.array([CONTACT_DURATION])).velocity[0]
    assert last == pytest.approx(path.epsilon_t, rel=0, abs=path.error_bound)


@given(kappas, psis)
def test_switch_instants_lie_on_the_cap(kappa, psi):
    path = motion(kappa, psi)
    time = path.start[1:]
    curves, cap = tangential_curves(path, time), normal_curves(time)[2]
    # the phase of the spring carries its own rounding
    np.testing.assert_allclose(
        kappa * psi * np.abs(curves.elongation), cap, rtol=1e-9, atol=1e-12 * (1 + kappa * psi)
    )


def test_reversals_agree_with_sixty_digits(reference_reversals):
    for kappa, psi, expected in reference_reversals:
        assert reversals(motion(kappa, psi)) == expected, (kappa, psi)


@pytest.mark.parametrize(
    ("kappa", "psi"),
    [(18.0, 0.3), (63.0, 0.97), (0.3, 3.2), (5.0, 0.01), (1000.0, 0.5), (1.2, 1.5), (18.0, 3.0)],
)
def test_sensitivity_is_the_derivative(kappa, psi):
    h = 1e-6
    by_kappa, by_psi = sensitivity(motion(kappa, psi))
    up, down = collide([kappa * (1 + h), kappa * (1 - h)], psi).epsilon_t
    assert by_kappa == pytest.approx((up - down) / (2 * h), abs=1e-8)
    up, down = collide(kappa, [psi * (1 + h), psi * (1 - h)]).epsilon_t
    assert by_psi == pytest.approx((up - down) / (2 * h), abs=1e-8)


@pytest.mark.parametrize(
    ("kappa", "psi"), [(18.0, 0.3), (63.0, 0.97), (0.3, 3.2), (2.5, 0.7), (0.9, 1.9), (18.0, 3.0)]
)
def test_a_general_solver_with_events_agrees(kappa, psi):
    # its tolerance of 1e-9, lost some digits over up to eight restarts
    assert solve_with_events(kappa, psi) == pytest.approx(collide(kappa, psi).epsilon_t, abs=1e-6)


def test_weakest_collisions_are_followed_in_units_of_their_own_velocity():
    weak, weaker = (
        tangential_curves(motion(2.0, psi), np.linspace(0, CONTACT_DURATION, 50))
        for psi in (1e-90, 5e-324)
    )
    np.testing.assert_allclose(weak.velocity, weaker.velocity, atol=1e-15)


def test_too_stiff_collisions_are_refused_with_the_reason():
    with pytest.raises(CostError, match="kappa = 1e\\+15 needs about"):
        motion(1e15, 1.0)


@pytest.mark.parametrize(("kappa", "psi"), [(0.0, 1.0), (1.0, 0.0), (np.nan, 1.0), (1.0, np.inf)])
def test_impossible_parameters_are_refused(kappa, psi):
    with pytest.raises(ParameterError, match="must be positive and finite"):
        motion(kappa, psi)
