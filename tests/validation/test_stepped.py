"""Fixed time steps, judged by another program that takes the same ones."""

import csv
from pathlib import Path

import numpy as np
import pytest

from restitution.mechanics.stepping import step_collisions

TEXT = Path(__file__).with_name("stepped_by_lammps.csv").read_text()
ROWS = list(csv.DictReader(TEXT.splitlines()))


# the bias of LAMMPS is linear in ξ_scale/R = 1e-7, its factor about 30 here (docs/model.md)
@pytest.mark.parametrize("steps", [20, 50, 200])
@pytest.mark.parametrize("damped", [False, True])
def test_verlet_takes_the_steps_of_lammps(steps, damped):
    rows = [
        row for row in ROWS if int(row["steps"]) == steps and (float(row["damping"]) > 0) is damped
    ]
    assert len(rows) == 40
    for row in rows:
        kappa, psi, damping, phase, epsilon_t = (
            float(row[name]) for name in ("kappa", "psi", "damping", "phase", "epsilon_t")
        )
        ours = step_collisions(
            np.array([kappa]), np.array([psi]), steps, phase=phase, damping=damping
        )
        assert ours.epsilon_t[0] == pytest.approx(epsilon_t, abs=5e-6), row
