"""The C header and the Python module say what the table says, and so does the worked example."""

import importlib.util
import math
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from cases import every_day, left_to_verify
from restitution.export.c_header import c_header
from restitution.export.python_module import python_module
from restitution.mechanics.collision import collide
from restitution.studies.collision.axis import Axis
from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact, scales
from restitution.studies.spheres.impact import Impact
from restitution.studies.tables.export import study_table, study_table_within
from restitution.studies.tables.largest_error import BASES

DOCUMENT = (Path(__file__).parents[2] / "docs" / "event-driven.md").read_text()

COMPILER = shutil.which("cc")
with_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")

LOGARITHMIC = Axis(3.0, 6.0, 33, "log"), Axis(0.05, 2.0, 41, "log")
LINEAR = Axis(1.0, 9.0, 25), Axis(0.0, 2.5, 31)
SOFT = Axis(0.3, 6.0, 25, "log"), Axis(0.1, 2.0, 31)
GRIDS = pytest.mark.parametrize("axes", [LOGARITHMIC, LINEAR, SOFT], ids=["log", "linear", "soft"])
SIGNS = pytest.mark.parametrize("sign", every_day(["reversed"], of=["paper", "reversed"]))

MAIN = """
#include <stdio.h>
#include "restitution_table.h"
int main(void)
{
    double kappa, psi;
    while (scanf("%lf %lf", &kappa, &psi) == 2)
        printf("%.17g\\n", restitution_epsilon_t(kappa, psi));
    return 0;
}
"""


def built(folder, source):
    """Return a program made from C source, all warnings being errors."""
    (folder / "main.c").write_text(source)
    flags = ["-std=c99", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-pedantic"]
    program = folder / "program"
    subprocess.run(
        [COMPILER, *flags, "main.c", "-o", program, "-lm"], cwd=folder, check=True, timeout=120
    )
    return program


def numbers_from(program, rows):
    text = "\n".join(" ".join(repr(float(number)) for number in row) for row in rows)
    done = subprocess.run([program], input=text, capture_output=True, text=True, check=True)
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]


def module_from(folder, table):
    path = folder / "restitution_table.py"
    path.write_text(python_module(table))
    specification = importlib.util.spec_from_file_location("restitution_table", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


DAMPINGS = pytest.mark.parametrize(
    "damping",
    [left_to_verify(Axis(0.0, 0.5, 6)), Axis(0.01, 2.0, 7, "log")],
    ids=["linear", "log"],
)
MAIN_IN_THREE = (
    MAIN.replace("double kappa, psi;", "double kappa, psi, damping;")
    .replace("%lf %lf", "%lf %lf %lf")
    .replace("&kappa, &psi) == 2", "&kappa, &psi, &damping) == 3")
    .replace("(kappa, psi))", "(kappa, psi, damping))")
)


@SIGNS
@DAMPINGS
def test_module_in_three_parameters_is_within_its_stated_error(damping, sign, tmp_path):
    module = module_from(tmp_path, study_table(*LOGARITHMIC, sign, damping, seconds=30))
    rng = np.random.default_rng(5)
    worst = 0.0
    for eta in [
        damping.minimum,
        damping.maximum,
        *rng.uniform(damping.minimum, damping.maximum, 20),
    ]:
        at = points(LOGARITHMIC, 200)
        truth = collide(*at.T.copy(), eta, 1e5).epsilon_t * (1 if sign == "paper" else -1)
        found = np.array([module.epsilon_t(kappa, psi, eta) for kappa, psi in at.tolist()])
        worst = max(worst, np.abs(found - truth).max())
    assert 0 < worst <= module.LARGEST_ERROR


@with_compiler
@DAMPINGS
def test_c_header_in_three_parameters_is_the_python_module(damping, tmp_path):
    table = study_table(*LOGARITHMIC, "paper", damping, seconds=30)
    module = module_from(tmp_path, table)
    (tmp_path / "restitution_table.h").write_text(c_header(table))
    rng = np.random.default_rng(6)
    etas = rng.uniform(-0.05, 1.05 * damping.maximum, 2000)
    at = [(*pair, eta) for pair, eta in zip(points(LOGARITHMIC).tolist(), etas, strict=True)]
    at += [(4.0, 1.0, damping.minimum), (4.0, 1.0, damping.maximum), (4.0, 2.1, damping.maximum)]
    found = numbers_from(built(tmp_path, MAIN_IN_THREE), at)
    for place, (value,) in zip(at, found, strict=True):
        # roundings of a logarithm, times the slope within a cell
        assert value == pytest.approx(module.epsilon_t(*place), abs=1e-12, nan_ok=True)
    assert np.isnan(found).any()
    assert not np.isnan(found[-2])


def test_damping_of_the_table_is_stated():
    table = study_table(*LINEAR, "paper", 0.125, seconds=10)
    for text in (c_header(table), python_module(table)):
        assert "with viscous damping eta = 0.125" in text
        assert "not a number above psi = 2.5" in text
    table = study_table(*LOGARITHMIC, "paper", Axis(0.0, 0.5, 3), seconds=10)
    for text in (c_header(table), python_module(table)):
        assert "3 values of eta from 0 to 0.5 (linear)" in text
        assert "trilinear" in text
        assert f"({table.error_basis}: {BASES[table.error_basis]})." in text


def points(axes, count=2000):
    rng = np.random.default_rng(3)
    kappa, psi = (rng.uniform(axis.minimum, axis.maximum, count) for axis in axes)
    kappa[:2], psi[:2] = [axes[0].minimum, axes[0].maximum], [axes[1].minimum, axes[1].maximum]
    return np.column_stack([kappa, psi])


@SIGNS
@GRIDS
def test_python_module_is_within_its_stated_error(axes, sign, tmp_path):
    module = module_from(tmp_path, study_table(*axes, sign, seconds=10))
    at = points(axes)
    truth = collide(*at.T).epsilon_t * (1 if sign == "paper" else -1)
    found = np.array([module.epsilon_t(kappa, psi) for kappa, psi in at.tolist()])
    assert np.abs(found - truth).max() <= module.LARGEST_ERROR


@with_compiler
@SIGNS
@GRIDS
def test_c_header_is_the_python_module(axes, sign, tmp_path):
    table = study_table(*axes, sign, seconds=10)
    module = module_from(tmp_path, table)
    (tmp_path / "restitution_table.h").write_text(c_header(table))
    outside = [
        (0.1, 1.0),
        (7.0, 3.0),
        (99.0, 1.0),
        (5.0, 0.0),
        (5.0, -1.0),
        (5.0, 1e-9),
        (5.0, 1e9),
    ]
    at = [*points(axes).tolist(), *outside]
    for (kappa, psi), (value,) in zip(at, numbers_from(built(tmp_path, MAIN), at), strict=True):
        # roundings of a logarithm, times the slope within a cell
        assert value == pytest.approx(module.epsilon_t(kappa, psi), abs=1e-12, nan_ok=True)


def test_outside_the_table_there_is_no_number_but_where_sliding_is_exact(tmp_path):
    module = module_from(tmp_path, study_table(*LOGARITHMIC, "paper", seconds=10))
    assert math.isnan(module.epsilon_t(2.9, 1.0))
    assert math.isnan(module.epsilon_t(6.1, 1.0))
    assert math.isnan(module.epsilon_t(4.0, math.nan))
    assert module.epsilon_t(4.0, 8.0) == 0.75
    assert module.epsilon_t(4.0, 0.0) == module.epsilon_t(4.0, 0.05)
    soft = module_from(tmp_path, study_table(*SOFT, "paper", seconds=10))
    assert math.isnan(soft.epsilon_t(4.0, 2.1))


@SIGNS
def test_both_languages_state_sign_and_error(sign):
    table = study_table(*LINEAR, sign, seconds=10)
    for text in (c_header(table), python_module(table)):
        assert f"{'+1' if sign == 'paper' else '-1'} smooth spheres" in text
        stated = float(re.search(r"within them: ([\d.e+-]+)", text)[1])
        assert table.largest_error <= stated <= 1.001 * table.largest_error
        assert re.search(r'ERROR_BASIS\b.* "proven"$', text, re.MULTILINE)


# the worked example

GLASS = Sphere(0.003, 7e10, 0.22, density_kg_m3=2500.0)
CONTACT = Contact(GLASS, GLASS, 0.3, "mindlin")
ROLE = """
#include <stdio.h>
int main(void)
{
    sphere s[2];
    double n[3];
    material of;
    int k, i;
    while (scanf("%lf %lf %lf %lf", &of.radius, &of.friction, &of.kappa_at_1, &of.kappa_exponent) == 4) {
        for (k = 0; k < 2; k++)
            for (i = 0; i < 3; i++)
                if (scanf("%lf", &s[k].velocity[i]) != 1) return 1;
        for (k = 0; k < 2; k++)
            for (i = 0; i < 3; i++)
                if (scanf("%lf", &s[k].spin[i]) != 1) return 1;
        for (i = 0; i < 3; i++)
            if (scanf("%lf", &n[i]) != 1) return 1;
        if (!collide(&s[0], &s[1], n, &of)) return 2;
        for (k = 0; k < 2; k++)
            for (i = 0; i < 3; i++)
                printf("%.17g ", s[k].velocity[i]);
        for (k = 0; k < 2; k++)
            for (i = 0; i < 3; i++)
                printf("%.17g ", s[k].spin[i]);
        printf("\\n");
    }
    return 0;
}
"""  # noqa: E501 - C as people write it


def example(language):
    (code,) = re.findall(rf"```{language}\n(.*?)```", DOCUMENT, re.DOTALL)
    return code


def impacts(count):
    rng = np.random.default_rng(11)
    for _ in range(count):
        normal = rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        relative, v2 = rng.normal(size=(2, 3))
        v1 = v2 + relative - (relative @ normal + rng.uniform(0.1, 3)) * normal
        w1, w2 = rng.normal(size=(2, 3)) * 200
        yield Impact(*(tuple(v.tolist()) for v in (v1, v2, normal, w1, w2)))


def exact_table():
    return study_table_within(
        0.005, Axis(3.0, 6.0, 2, "log"), Axis(0.05, 2.0, 2, "log"), "paper", seconds=30
    )


def largest_misses(results):
    """Hold velocities and spins against the exact ones, within the error of the table."""
    for impact, found in results:
        study = study_scaling(CONTACT, impact)
        psi = study.psi
        # below its range the table stands still, which matters less the smaller ψ
        lost = 0.005 if psi >= 0.05 else 2.0
        speed = 0.5 * study.alpha * lost * study.tangential_velocity_m_s + 1e-12
        limits = (speed, speed, 2.5 * speed / 0.003, 2.5 * speed / 0.003)
        for mine, its, limit in zip(found, study.after, limits, strict=True):
            assert np.linalg.norm(np.array(mine) - its) <= limit


@with_compiler
def test_collision_rule_in_c_is_that_of_the_service(tmp_path):
    (tmp_path / "restitution_table.h").write_text(c_header(exact_table()))
    program = built(tmp_path, example("c") + ROLE)
    kappa = scales(CONTACT, 1.0).kappa
    many = list(impacts(200))
    rows = [
        [0.003, 0.3, kappa, 0.0, *i.velocity_1_m_s, *i.velocity_2_m_s, *i.spin_1_rad_s,
         *i.spin_2_rad_s, *i.normal]
        for i in many
    ]  # fmt: skip
    found = numbers_from(program, rows)
    assert len(found) == 200
    largest_misses(
        (impact, np.reshape(numbers, (4, 3))) for impact, numbers in zip(many, found, strict=True)
    )


def test_collision_rule_in_python_is_that_of_the_service(tmp_path, monkeypatch):
    module = module_from(tmp_path, exact_table())
    monkeypatch.setitem(__import__("sys").modules, "restitution_table", module)
    names: dict = {}
    exec(example("python"), names)  # noqa: S102 - the example is ours
    kappa = scales(CONTACT, 1.0).kappa

    def rule(impact):
        velocities, spins = names["collide"](
            (impact.velocity_1_m_s, impact.velocity_2_m_s),
            (impact.spin_1_rad_s, impact.spin_2_rad_s),
            impact.normal,
            radius=0.003,
            friction=0.3,
            kappa=kappa,
        )
        return [*velocities, *spins]

    largest_misses((impact, rule(impact)) for impact in impacts(200))
