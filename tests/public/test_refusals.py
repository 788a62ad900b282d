"""Nonsense told to Python: each is refused by its name, with its value and what is allowed."""

import pickle
from fractions import Fraction

import numpy as np
import pytest

import restitution as rs

ONE = 63, 1.4, 1.358
BALL = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
STEEL = rs.Contact(BALL, BALL, 0.4, "mindlin")
LINE = rs.Axis(1, 2, 3)

STRANGERS = {
    "kappa": lambda: rs.epsilon_t(kapa=3, mu_over_alpha=1.4, gt_over_gn=1),
    "normal_restitution": lambda: rs.epsilon_t(*ONE, e_n=0.9),
    "method": lambda: rs.collision(*ONE, solver="exact"),
    "damping": lambda: rs.collisions(*ONE, eta=0.1),
    "columns": lambda: rs.trace(*ONE, column=["time"]),
    "tolerance": lambda: rs.cut(LINE, 1.4, 1, tolerence=1e-3),
    "quantities": lambda: rs.map(LINE, 1.4, LINE, quantity=["error"]),
    "error": lambda: rs.table(LINE, LINE, eror=0.1),
    "region": lambda: rs.steps(1e-3, scene="solids"),
    "beta_0": lambda: rs.walton(beta=0.5),
    "scene": lambda: rs.tradeoff(region="stiff"),
    "maximum": lambda: rs.Axis(minimum=1, max=2, count=5),
    "density_kg_m3": lambda: rs.Sphere(0.02, 2.1e11, 0.3, density=7850),
    "friction_coefficient": lambda: rs.Contact(BALL, BALL, frction=0.4),
    "normal_velocity_m_s": lambda: STEEL.impact(normal_velocity=1, tangential_velocity_m_s=1),
    "tangential_velocity_m_s": lambda: STEEL.map(LINE, tangential_velocity=LINE),
    "angle_deg": lambda: rs.SpeedAndAngle(1, angle=3),
    "integrator": lambda: rs.Options(integrater="velocity_verlet"),
}


@pytest.mark.parametrize("meant", STRANGERS)
def test_keyword_that_is_not_there_names_its_neighbour(meant):
    with pytest.raises(TypeError, match=rf"no such parameter: .*; did you mean {meant}\?$") as told:
        STRANGERS[meant]()
    assert isinstance(told.value, rs.RestitutionError)
    again = pickle.loads(pickle.dumps(told.value))  # noqa: S301 - our own
    assert (str(again), again.meant) == (str(told.value), meant)


def test_keyword_that_is_like_no_other_is_refused_alone():
    with pytest.raises(rs.UnknownParameterError, match=r"^no such parameter: xyz, got 3$"):
        rs.epsilon_t(*ONE, xyz=3)


WRONG = [
    (lambda: rs.epsilon_t("a", 1.4, 1), "kappa must be finite and > 0, got 'a'"),
    (lambda: rs.epsilon_t("63", 1.4, 1), "kappa must be finite and > 0, got '63'"),
    (lambda: rs.epsilon_t([1, None], 1.4, 1), "kappa[1] must be finite and > 0, got None"),
    (lambda: rs.epsilon_t([[1, -2]], 1.4, 1), "kappa[0,1] must be finite and > 0, got -2.0"),
    (lambda: rs.epsilon_t(1 + 2j, 1.4, 1), "kappa must be finite and > 0, got (1+2j)"),
    (lambda: rs.epsilon_t(True, 1.4, 1), "kappa must be finite and > 0, got True"),
    (lambda: rs.epsilon_t(10**400, 1.4, 1), "kappa must be finite and > 0, got inf"),
    (lambda: rs.epsilon_t({"a": 1}, 1.4, 1), "kappa must be finite and > 0, got {'a': 1}"),
    (lambda: rs.epsilon_t([[1, 2], [3]], 1.4, 1), "kappa must be an array of one length"),
    (lambda: rs.epsilon_t([1, 2], [1, 2, 3], 1), "kappa (2,), mu_over_alpha (3,), gt_over_gn ()"),
    (lambda: rs.epsilon_t(*ONE, damping="x"), "damping must be from 0 to 1e+30, got 'x'"),
    (lambda: rs.epsilon_t(*ONE, normal_restitution=[0.9, "x"]), "normal_restitution[0] must be"),
    (lambda: rs.collision(*ONE, normal_restitution=[0.9]), "normal_restitution must be from"),
    (lambda: rs.collision(*ONE, quantities=["eps"]), "a choice of epsilon_t, epsilon_n, switches"),
    (lambda: rs.collision(*ONE, quantities=3), "quantities must be a choice of"),
    (lambda: rs.collision(*ONE, episode_limit=-1), "episode_limit must be an integer from 0 to"),
    (lambda: rs.collisions([1, 2], 1.4, 1, quantities="eps"), "quantities must be a choice of"),
    (lambda: rs.collisions([[1, 2]], 1.4, 1), "kappa must be of shape () or (N,), got (1, 2)"),
    (lambda: rs.trace(*ONE, samples=10**9), "samples must be an integer from 2 to 20,000, got 1"),
    (lambda: rs.trace(*ONE, samples="x"), "samples must be an integer from 2 to 20,000, got 'x'"),
    (lambda: rs.trace(*ONE, columns=["tme"]), "columns must be a choice of time, compression"),
    (lambda: rs.Axis(1, 2, 5, "lin"), "scale must be linear or log, got 'lin'"),
    (lambda: rs.Axis("a", 2, 5), "minimum must be a finite number, got 'a'"),
    (lambda: rs.Axis(1, 2, 0), "count must be an integer ≥ 1, got 0"),
    (lambda: rs.map(63, 1.4, LINE), "kappa must be an Axis, got 63"),
    (lambda: rs.table(LINE, 3), "psi must be an Axis, got 3"),
    (lambda: rs.table(LINE, LINE, "x"), "damping must be from 0 to 1e+30, got 'x'"),
    (lambda: rs.table(LINE, LINE, sign="x"), "sign must be paper or reversed, got 'x'"),
    (lambda: rs.table(LINE, LINE, error=0), "error must be from 1e-12 to 1, got 0"),
    (lambda: rs.table(LINE, LINE, seconds=-1), "seconds must be finite and > 0, got -1"),
    (lambda: rs.steps(0, *ONE), "error must be from 1e-12 to 1, got 0"),
    (lambda: rs.steps(1e-3, region="solid"), "region must be one of figure4, stiff"),
    (lambda: rs.tradeoff("figur4"), "scene must be one of figure4, stiff"),
    (lambda: STEEL.map(3, LINE), "normal_velocity_m_s must be an Axis, got 3"),
    (
        lambda: STEEL.impact(speed_m_s=1, normal_velocity_m_s=2),
        "normal_velocity_m_s must be left out, as speed_m_s and angle_deg tell it, got 2",
    ),
]


@pytest.mark.parametrize(("call", "words"), WRONG, ids=[words for _, words in WRONG])
def test_value_is_refused_with_what_is_allowed(call, words):
    with pytest.raises(rs.ParameterError) as told:
        call()
    assert words in str(told.value)


def test_numbers_of_any_kind_are_numbers():
    exact = rs.epsilon_t(63, 1.4, 1)
    for kappa in (Fraction(63), np.float32(63), np.array(63, dtype=object), np.uint8(63)):
        assert rs.epsilon_t(kappa, 1.4, 1) == exact


def test_a_text_holds_several_quantities_as_in_a_query():
    found = rs.collisions([18, 63], 1.4, 1, quantities="epsilon_t,switches")
    assert list(found.columns) == ["epsilon_t", "switches"]
