"""The universal map of ε_t over κ and ψ: computed once, kept on disk, read in nanoseconds."""

import hashlib
import io
import threading
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from restitution.errors import ParameterError
from restitution.mechanics import cache
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
from restitution.methods.answer import Answer
from restitution.methods.options import Options, refuse_damping

KAPPA_RANGE = (1e-2, 1e3)
PSI_RANGE = (1e-3, 1e3)

FINEST = 2e-6
"""Smallest tolerance for which looking into the table pays: a third of it is that good."""

LEAST_GAIN = 5e-3
"""Seconds of following that are worth a look: reading 10 MB, and building them once."""

PHASE_BOUND = 1e-13
"""Rounding error of cos(√κ t_c), tenfold: the phase is 102 at most."""

DIVIDE_ABOVE = (9.5e-5, 9.5e-5, 9.5e-5, 1e-3, 2.5e-3, 2.5e-3, np.inf)
"""Error bound above which a patch is divided that came from 0, 1, 2 … divisions.

Smooth patches are done after three. What is left then lies on the borders between numbers of
switches, where ε_t has kinks: on lines, whose patches are worth dividing only for large errors."""

SAFETY = 4.0
"""Error bound over the largest error among the samples of a patch.

Where ε_t is smooth the samples miss a few per cent of it, next to a kink up to three fifths: of
six million points beside borders and elsewhere none had more than 0.65 of its bound."""

_SAMPLES = np.linspace(-28.0 / 27.0, 28.0 / 27.0, 8)
"""Across a patch from −1 to 1, and an eighth of their distance beyond: a kink that only cuts a
corner is seen from outside."""

_NODES = np.cos(np.pi * (np.arange(DEGREE + 1.0) + 0.5) / (DEGREE + 1))
_FROM_NODES = np.linalg.inv(np.vander(_NODES, increasing=True))
_AT_SAMPLES = np.vander(_SAMPLES, DEGREE + 1, increasing=True)

AT_ONCE = 128
"""Patches that are fitted together: no more collisions at a time than one thread takes."""

_building = threading.Lock()


@dataclass(frozen=True)
class Table:
    """The arrays that `patches.look_up` reads."""

    division: IntegerArray
    patches: SingleArray
    bounds: SingleArray


def _collided(
    bands: npt.NDArray[np.int64], edges: FloatArray, across: FloatArray, along: FloatArray
) -> FloatArray:
    """Return the exact ε_t [patch][ψ][κ] at the products of points, −1 … 1 across a patch."""
    kappa = edges[:, 0, None] + edges[:, 1, None] * 0.5 * (along + 1.0)
    psi = psi_at(bands[:, None], edges[:, 2, None] + edges[:, 3, None] * 0.5 * (across + 1.0))
    return collide(kappa[:, None, :], psi[:, :, None]).epsilon_t


def _certified(
    bands: npt.NDArray[np.int64], edges: FloatArray, coefficients: FloatArray, limit: float
) -> FloatArray:
    """Return bounds (M,) on the errors of patches; half the samples do beyond `limit`."""
    largest = np.zeros(bands.size)
    undecided = np.arange(bands.size)
    for rows in (slice(0, None, 2), slice(1, None, 2)):
        truth = _collided(bands[undecided], edges[undecided], _SAMPLES[rows], _SAMPLES)
        fitted = _AT_SAMPLES[rows] @ coefficients[undecided] @ _AT_SAMPLES.T
        error = np.abs(fitted - truth).max((1, 2))
        largest[undecided] = np.maximum(largest[undecided], error)
        undecided = undecided[SAFETY * error <= limit]
    # a unit of single precision more, for bounds are rounded to it
    return 1.000001 * SAFETY * largest + 1e-9


def _fitted(
    bands: npt.NDArray[np.int64], edges: FloatArray, limit: float
) -> tuple[SingleArray, SingleArray]:
    """Return the coefficients (M, 16) of patches and bounds (M,) on their errors."""
    patches = np.empty((bands.size, COEFFICIENTS), np.float32)
    bounds = np.empty(bands.size, np.float32)
    for begin in range(0, bands.size, AT_ONCE):
        part = slice(begin, begin + AT_ONCE)
        at_nodes = _collided(bands[part], edges[part], _NODES, _NODES)
        coefficients = (_FROM_NODES @ at_nodes @ _FROM_NODES.T).astype(np.float32)
        patches[part] = coefficients.reshape(-1, COEFFICIENTS)
        bounds[part] = _certified(bands[part], edges[part], coefficients.astype(np.float64), limit)
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
        patches, bounds = _fitted(bands, edges, limit)
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
    """Return the table in `file`, None if there is none as it was written."""
    if (content := cache.read(file)) is None:
        return None
    with np.load(io.BytesIO(content)) as arrays:
        return Table(arrays["division"], arrays["patches"], arrays["bounds"])


def _write(table: Table, file: Path) -> None:
    """Keep the table if that is possible."""
    content = io.BytesIO()
    np.savez(content, **vars(table))
    cache.write(file, content.getvalue())


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

    The bound is that of the patch, certified when the table was built: four times the largest
    error among 64 samples of the patch. Cost: 6 ns in the order of a map, 15 ns at random.

    Raises
    ------
    ParameterError
        If a collision lies outside the table, as all do that have η > 0.
    """
    refuse_damping("table", options.damping)
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
