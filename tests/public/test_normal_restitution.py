"""ε_n in place of η in Python: in every function that takes a damping, and in contacts."""

import numpy as np
import pytest

import restitution as rs
from restitution.mechanics.contact import damping_of

ETA = damping_of(0.9)
ONE = 63, 1.4, 1.358
AXES = rs.Axis(1, 60, 4), 1.4, rs.Axis(0.5, 4, 3)
CALLS = {
    "epsilon_t": lambda **damped: rs.epsilon_t([18, 63], 1.4, 0.4, **damped),
    "collision": lambda **damped: rs.collision(*ONE, **damped).epsilon_t,
    "collisions": lambda **damped: rs.collisions([18, 63], 1.4, 0.4, **damped).columns["epsilon_t"],
    "trace": lambda **damped: rs.trace(*ONE, samples=9, **damped)["tangential_velocity"],
    "cut": lambda **damped: rs.cut(AXES[0], 1.4, 0.4, **damped).batch.columns["epsilon_t"],
    "map": lambda **damped: rs.map(*AXES, **damped).batch.columns["epsilon_t"],
    "table": lambda **damped: rs.table(rs.Axis(3, 6, 3), rs.Axis(0.1, 2, 3), **damped).epsilon_t,
    "steps": lambda **damped: rs.steps(0.1, *ONE, **damped).needed["velocity_verlet"].worst,
}


@pytest.mark.parametrize("call", CALLS)
def test_function_takes_the_damping_that_has_the_restitution(call):
    found = CALLS[call](normal_restitution=0.9)
    np.testing.assert_array_equal(found, CALLS[call](damping=ETA))


@pytest.mark.parametrize("call", CALLS)
def test_function_refuses_both_and_what_is_no_restitution(call):
    with pytest.raises(rs.ParameterError, match="left out, as damping is given"):
        CALLS[call](damping=0.1, normal_restitution=0.9)
    with pytest.raises(rs.ParameterError, match=r"normal_restitution must be from 1.5e-50 to 1"):
        CALLS[call](normal_restitution=1.1)


def test_table_with_an_axis_of_damping_takes_no_restitution():
    with pytest.raises(rs.ParameterError, match="left out, as damping is given"):
        rs.table(*(rs.Axis(0.1, 2, 3),) * 3, normal_restitution=0.9)


def test_contact_takes_one_of_both_and_a_map_its_velocity():
    steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
    with pytest.raises(rs.ParameterError, match="as dissipative_constant_s is given"):
        rs.Contact(steel, steel, 0.4, "mindlin", 1e-6, 0.9)
    contact = rs.Contact(steel, steel, 0.4, "mindlin", normal_restitution=0.9)
    found = contact.impact(speed_m_s=1.0, angle_deg=0.0)
    assert found.damping == ETA
    with pytest.raises(rs.ParameterError, match="at_normal_velocity_m_s must be given"):
        contact.map(rs.Axis(1, 2, 2), rs.Axis(0, 1, 2))


@pytest.mark.parametrize("beta_0", [1.5, -1.5, float("nan"), "rough", None, True])
def test_walton_refuses_what_is_no_beta_0(beta_0):
    with pytest.raises(rs.ParameterError, match="beta_0 must be from -1 to 1"):
        rs.walton(beta_0)
