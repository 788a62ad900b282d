"""The universal map of ε_t over κ and ψ: computed once, kept on disk, read in nanoseconds."""

import contextlib
import hashlib
import os
import threading
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from restitution.errors import ParameterError
from restitution.mechanics.collision import collide
from restitution.mechanics.compiled import CACHE_FOLDER
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.limits import weak_limit
from restitution.mechanics.patches import (
    COEFFICIENTS,
    DEGREE,
    IntegerArray,
    SingleArray,
    look_up,
    psi_at,
    undivided,
)
from restitution.methods.answer import Answer, Options

KAPPA_RANGE = (1e-2, 1e3)
PSI_RANGE = (1e-3, 1e3)

FINEST = 2e-6
"""Smallest tolerance for which looking into the table pays: a third of it is that good."""

LEAST_GAIN = 5e-3
"""Seconds of following that are worth a look: reading 10 MB, and building them once."""

PHASE_BOUND = 1e-13
"""Rounding error of cos(√κ t_c), tenfold: the phase is 102 at most."""

DIVIDE_ABOVE = (9e-5, 9e-5, 9e-5, 1e-3, 2e-3, 2e-3, np.inf)
"""Error bound above which a patch is divided that came from 0, 1, 2 … divisions.

Smooth patches are done after three. What is left then lies on the borders between numbers of
switches, where ε_t has kinks: on lines, whose patches are worth dividing only for large errors."""

SAFETY = 3.0
"""Error bound over the largest error among the samples of a patch.

Between two of them, a sixth of the patch apart, a kink can add as much again at most: the error
grows from it linearly, with the same slope over the samples as between them."""

_SAMPLES = np.linspace(-14.0 / 13.0, 14.0 / 13.0, 8)
"""Across a patch from −1 to 1, and a quarter of their distance beyond: a kink that only cuts a
corner is seen from outside."""

_NODES = np.cos(np.pi * (np.arange(DEGREE + 1.0) + 0.5) / (DEGREE + 1))
_FROM_NODES = np.linalg.inv(np.vander(_NODES, increasing=True))
_AT_SAMPLES = np.vander(_SAMPLES, DEGREE + 1, increasing=True)

AT_ONCE = 64
"""Patches that are fitted together: 4096 collisions, which `collide` gives to one thread."""

_building = threading.Lock()


@dataclass(frozen=True)
class Table:
    """The arrays that `patches.look_up` reads."""

    division: IntegerArray
    patches: SingleArray
    bounds: SingleArray


def _collided(bands: npt.NDArray[np.int64], edges: FloatArray, points: FloatArray) -> FloatArray:
    """Return the exact ε_t [patch][ψ][κ] at the products of `points`, −1 … 1 across a patch."""
    shares = 0.5 * (points + 1.0)
    kappa = edges[:, 0, None] + edges[:, 1, None] * shares
    psi = psi_at(bands[:, None], edges[:, 2, None] + edges[:, 3, None] * shares)
    return collide(kappa[:, None, :], psi[:, :, None]).epsilon_t


def _fitted(bands: npt.NDArray[np.int64], edges: FloatArray) -> tuple[SingleArray, SingleArray]:
    """Return the coefficients (M, 16) of patches and bounds (M,) on their errors."""
    patches = np.empty((bands.size, COEFFICIENTS), np.float32)
    bounds = np.empty(bands.size, np.float32)
    for begin in range(0, bands.size, AT_ONCE):
        part = slice(begin, begin + AT_ONCE)
        at_nodes = _collided(bands[part], edges[part], _NODES)
        coefficients = (_FROM_NODES @ at_nodes @ _FROM_NODES.T).astype(np.float32)
        patches[part] = coefficients.reshape(-1, COEFFICIENTS)
        fitted = _AT_SAMPLES @ coefficients.astype(np.float64) @ _AT_SAMPLES.T
        truth = _collided(bands[part], edges[part], _SAMPLES)
        # one unit of single precision, for the bound itself is rounded
        bounds[part] = 1.000001 * SAFETY * np.abs(fitted - truth).max((1, 2)) + 1e-9
    return patches, bounds


def build() -> Table:
    """Return the table, computed from exact collisions: some 15 s of one core."""
    bands, edges = undivided()
    division = np.zeros(bands.size, np.int32)
    # what lies in the range at all
    reached = (edges[:, 0] <= KAPPA_RANGE[1]) & (edges[:, 0] + edges[:, 1] >= KAPPA_RANGE[0])
    slots = np.flatnonzero(reached)
    bands, edges = bands[slots], edges[slots]
    found: list[tuple[SingleArray, SingleArray]] = []
    count = 0
    for limit in DIVIDE_ABOVE:
        patches, bounds = _fitted(bands, edges)
        divided = bounds > limit
        done = ~divided
        found.append((patches[done], bounds[done]))
        division[slots[done]] = count + np.arange(np.count_nonzero(done))
        count += int(np.count_nonzero(done))
        quarters = np.arange(4 * np.count_nonzero(divided)) + division.size
        division[slots[divided]] = -quarters[::4]
        division = np.concatenate([division, np.zeros(quarters.size, np.int32)])
        slots = quarters
        bands, edges = np.repeat(bands[divided], 4), np.repeat(edges[divided], 4, axis=0)
        edges[:, [1, 3]] *= 0.5
        edges[:, 0] += edges[:, 1] * np.tile([0, 0, 1, 1], slots.size // 4)
        edges[:, 2] += edges[:, 3] * np.tile([0, 1, 0, 1], slots.size // 4)
    patches, bounds = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return Table(division, patches, bounds)


def _file() -> Path:
    """Return where the table is kept: beside the kernels, named by its own source as well."""
    digest = hashlib.sha256(Path(__file__).read_bytes()).hexdigest()[:16]
    return Path(CACHE_FOLDER, f"table-{digest}.npz")


def _read(file: Path) -> Table | None:
    """Return the table in `file`, None if there is none that is whole."""
    try:
        with file.open("rb") as stream, np.load(stream) as arrays:
            return Table(arrays["division"], arrays["patches"], arrays["bounds"])
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None


def _write(table: Table, file: Path) -> None:
    """Keep the table if that is possible; whole or not at all, for other processes may look."""
    partial = file.with_suffix(f".{os.getpid()}")
    with contextlib.suppress(OSError):
        try:
            with partial.open("wb") as stream:
                np.savez(stream, **vars(table))
            partial.replace(file)
        finally:
            partial.unlink(missing_ok=True)


_loaded: list[Table] = []


def table() -> Table:
    """Return the table: from memory, from disk, or built once and kept on both."""
    with _building:
        if not _loaded:
            found = _read(_file()) if CACHE_FOLDER else None
            if found is None:
                found = build()
                if CACHE_FOLDER:
                    _write(found, _file())
            _loaded.append(found)
        return _loaded[0]


def within(kappa: FloatArray, psi: FloatArray) -> npt.NDArray[np.bool_]:
    """Return where the table holds collisions (N,); it holds the limit ψ = ∞, but not ψ = 0."""
    return (
        (kappa >= KAPPA_RANGE[0])
        & (kappa <= KAPPA_RANGE[1])
        & (psi >= PSI_RANGE[0])
        & ((psi <= PSI_RANGE[1]) | np.isposinf(psi))
    )


def read(kappa: FloatArray, psi: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return ε_t and its error bound for collisions (N,) `within` the table."""
    arrays = table()
    epsilon_t, error_bound = np.empty(kappa.shape), np.empty(kappa.shape)
    look_up(kappa, psi, arrays.division, arrays.patches, arrays.bounds, epsilon_t, error_bound)
    return epsilon_t, error_bound


def solve(kappa: FloatArray, psi: FloatArray, options: Options) -> Answer:
    """Return ε_t of collisions (N,) from the table.

    The bound is that of the patch, certified when the table was built: three times the largest
    error among 64 samples of the patch. Cost: 10 to 30 ns in the order of a map.

    Raises
    ------
    ParameterError
        If a collision lies outside the table.
    """
    weak = psi == 0.0
    looked_up = np.where(weak, 1.0, psi)
    held = within(kappa, looked_up)
    if not np.all(held):
        first = int(np.argmin(held))
        raise ParameterError(
            "method",
            "table",
            f"another one for kappa = {kappa[first]:g}, psi = {psi[first]:g}: the table holds "
            f"kappa from {KAPPA_RANGE[0]:g} to {KAPPA_RANGE[1]:g} and "
            f"psi = gt_over_gn/mu_over_alpha from {PSI_RANGE[0]:g} to {PSI_RANGE[1]:g}",
        )
    epsilon_t, error_bound = read(kappa, looked_up)
    epsilon_t[weak] = weak_limit(kappa[weak])
    error_bound[weak] = PHASE_BOUND
    return Answer(epsilon_t, error_bound, np.full(kappa.shape, "table"))
