"""Bounds said once: what Python's own classes refuse, and the words for it."""

import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal, get_args

import numpy as np
import pytest
from annotated_types import Ge, Gt, Le

import restitution as rs
from restitution.bounds import Words, annotations, interval, plain, requirement
from restitution.errors import ParameterError
from restitution.mechanics.stepping import INTEGRATORS
from restitution.methods.answer import AnsweringMethod
from restitution.methods.options import Integrator, Method, Options
from restitution.methods.planner import METHODS
from restitution.studies.accuracy.scenes import SCENES, SceneName
from restitution.studies.collision.parameters import CollisionParameters
from restitution.wire.answers import MixedMethod

ROOT = Path(__file__).parents[1]

STEEL = {
    "radius_m": 0.02,
    "youngs_modulus_pa": 2.1e11,
    "poisson_ratio": 0.3,
    "density_kg_m3": 7850.0,
}


@pytest.mark.parametrize(
    ("annotation", "words"),
    [
        (Annotated[float, Gt(0)], "finite and > 0"),
        (Annotated[float, Gt(0)] | None, "finite and > 0"),
        (Annotated[float, Ge(0)], "finite and ≥ 0"),
        (Annotated[float, Ge(1e-13), Le(1)], "from 1e-13 to 1"),
        (Annotated[float, Gt(-1), Le(0.5)], "> -1 and ≤ 0.5"),
        (Annotated[int, Ge(4), Le(1_000_000)], "an integer from 4 to 1,000,000"),
        (Annotated[int, Ge(2)], "an integer ≥ 2"),
        (float, "a finite number"),
        (Literal["a", "b"], "a or b"),
        (Literal["a", "b", "c"], "one of a, b, c"),
        (Annotated[float, Gt(0)] | Literal["mindlin"], "finite and > 0, or mindlin"),
        (list[Literal["a", "b"]], "a list, not empty, of a, b"),
        (tuple[float, float, float], "three finite numbers"),
        (rs.Sphere, "an object"),
        (Annotated[float, Gt(0), Words("as it pleases")], "as it pleases"),
    ],
)
def test_the_words_of_a_refusal_follow_from_the_bounds(annotation, words):
    assert requirement(annotation) == words


def test_an_interval_holds_what_is_allowed_and_nothing_else():
    low, high = interval(Annotated[float, Gt(0)])
    assert low == math.ulp(0.0)
    assert high < math.inf
    assert interval(Annotated[float, Gt(-1), Le(0.5)]) == (math.nextafter(-1, 0), 0.5)
    # a count may be too long for a double
    assert interval(Annotated[int, Ge(2)]) == (2, math.inf)


@pytest.mark.parametrize("value", [-1, 0, -0.0, math.nan, math.inf, True, "1", None, 10**400])
def test_a_radius_that_is_none_is_refused_by_name_and_value(value):
    with pytest.raises(rs.ParameterError, match="radius_m must be finite and > 0") as refused:
        rs.Sphere(**STEEL | {"radius_m": value})
    assert refused.value.value is value


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"poisson_ratio": 0.6}, "poisson_ratio"),
        ({"density_kg_m3": None}, "density_kg_m3"),
        ({"mass_kg": 1.0}, "mass_kg"),
        ({"inertia": "round"}, "inertia"),
        ({"yield_stress_pa": -1.0}, "yield_stress_pa"),
    ],
)
def test_a_sphere_refuses_what_does_not_suit_it(change, name):
    with pytest.raises(rs.ParameterError) as refused:
        rs.Sphere(**STEEL | change)
    assert refused.value.parameter == name


def test_numbers_become_of_their_kind():
    sphere = rs.Sphere(**STEEL | {"radius_m": 1, "poisson_ratio": np.float32(-0.0)})
    assert (type(sphere.radius_m), type(sphere.poisson_ratio)) == (float, float)
    assert math.copysign(1.0, sphere.poisson_ratio) == 1.0
    assert Options(steps=50.0).steps == 50
    with pytest.raises(rs.ParameterError, match="an integer from 4"):
        Options(steps=50.5)


@pytest.mark.parametrize("vector", [3, (1, 2), (1, 2, math.nan), "abc", (1, 2, True), None])
def test_a_vector_has_three_finite_numbers(vector):
    with pytest.raises(rs.ParameterError, match="three finite numbers"):
        rs.Impact(vector, (0, 0, 0), (0, 0, 1))


def test_an_impact_is_told_in_one_way():
    wall = rs.Wall(youngs_modulus_pa=7e10, poisson_ratio=0.25)
    contact = rs.Contact(rs.Sphere(**STEEL), wall, 0.4, "mindlin")
    with pytest.raises(rs.ParameterError, match="left out, as velocities are given"):
        contact.impact(normal_velocity_m_s=1.0, normal=(0, 0, 1))
    with pytest.raises(rs.ParameterError, match="normal_velocity_m_s, tangential_velocity_m_s"):
        contact.impact(normal_velocity_m_s=1.0)
    with pytest.raises(rs.UnknownParameterError, match=r"no such parameter: velocity, got 1.0"):
        contact.impact(velocity=1.0)
    with pytest.raises(rs.ParameterError, match="wall"):
        rs.Contact(wall, wall, 0.4, "mindlin")


@pytest.mark.parametrize("name", ["method", "integrator"])
def test_words_are_those_that_there_are(name):
    with pytest.raises(rs.ParameterError, match="must be one of") as refused:
        Options(**{name: "no such"})
    assert refused.value.parameter == name


def test_words_in_types_are_those_of_the_code():
    assert set(get_args(plain(Method))) == {"auto", *METHODS}
    assert set(get_args(plain(AnsweringMethod))) == set(METHODS)
    assert set(get_args(plain(MixedMethod))) == {*METHODS, "mixed"}
    assert set(get_args(Integrator)) == set(INTEGRATORS)
    assert set(get_args(SceneName)) == set(SCENES)


def test_what_is_worked_out_is_no_option():
    assert "share" not in annotations(Options)
    assert Options().beside_others(0.1, 0.5).share == 0.5


BOUNDS_OF_THE_PAGE = """
import { KNOBS } from "./frontend/state/accuracy.js";
import { PARAMETERS } from "./frontend/state/parameters.js";
const values = JSON.parse(process.argv[1]);
const found = [...Object.values(KNOBS), ...PARAMETERS].map(({ key, initial, admits }) => [
  key,
  { initial, admitted: values.filter(admits) },
]);
console.log(JSON.stringify(Object.fromEntries(found)));
"""


def test_page_admits_what_the_service_does():
    ends = (1e-13, 0.1, 1.0, 4.0, 1e6, 1e30, 1e300)
    beside = (math.nextafter(end, to) for end in ends for to in (-math.inf, math.inf))
    values = sorted({*ends, *beside, -1.0, -5e-324, 0.0, 5e-324, 3.0, 4.5, 5.0, 1e6 + 1})
    done = subprocess.run(
        [
            Path(sys.executable).with_name("node"),
            "--input-type=module",
            "--eval",
            BOUNDS_OF_THE_PAGE,
            json.dumps(values),
        ],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    page = json.loads(done.stdout)
    usual = CollisionParameters(kappa=1.0, mu_over_alpha=1.0, gt_over_gn=1.0)
    for name, of in page.items():
        one = usual if name in annotations(CollisionParameters) else Options()

        def is_admitted(value, name=name, one=one):
            # the page has no whole numbers beside others
            whole = int(value) if name == "steps" and value.is_integer() else value
            try:
                return bool(replace(one, **{name: whole}))
            except ParameterError:
                return False

        assert of["admitted"] == [value for value in values if is_admitted(value)], name
        if one is not usual:
            assert of["initial"] == getattr(one, name)
