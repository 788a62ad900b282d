"""Speed against accuracy: every method with every knob on the collisions of a scene."""

import json
import os
import platform
import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from restitution.errors import RestitutionError
from restitution.mechanics.compiled import MODEL_VERSION
from restitution.mechanics.hertz import FloatArray
from restitution.studies.accuracy.candidates import (
    COLLISIONS,
    Candidate,
    Counts,
    Run,
    candidates,
)
from restitution.studies.accuracy.reference import Reference, reference
from restitution.studies.accuracy.scenes import SCENES, SceneName
from restitution.studies.accuracy.steps import Needed, Spread, Tried, study_steps
from restitution.studies.collision.dampings import by_damping

REPEATS = 5

WANTED_ERRORS = (1e-2, 1e-3, 1e-4)
"""For which the steps per contact are looked up."""


@dataclass(frozen=True)
class Row:
    """A method with its knobs on a scene.

    Attributes
    ----------
    method, options : str, dict
        As in the API; `ode` has a knob of its own, `spring`, where it locates no events.
    collisions : int
        How many of the scene it took for its errors.
    unanswered : float
        Share of them that it refused; the other figures are about the rest, None if there is none.
    microseconds_per_collision : float
        CPU time of one thread, the median of repeats.
    error_median, error_p95, error_max : float
        Of |ε_t − exact| plus the bound on the exact one's own error, which is all that the exact
        method has.
    wrong_sign : float
        Share of collisions with ε_t of the opposite sign; 0 has none.
    wrong_switches : float
        Share with another number of switches than the exact one where that is certain; None where
        the method counts none.
    """

    method: str
    options: dict[str, str | float]
    collisions: int
    unanswered: float
    microseconds_per_collision: float | None = None
    error_median: float | None = None
    error_p95: float | None = None
    error_max: float | None = None
    wrong_sign: float | None = None
    wrong_switches: float | None = None


@dataclass(frozen=True)
class WantedError:
    """The steps per contact that a wanted error takes, by integrator; as of ``GET /steps``."""

    error: float
    needed: dict[str, Needed]
    rule: dict[str, Spread]
    rule_steps: tuple[float, float]


@dataclass(frozen=True)
class Measurement:
    """What was measured on a scene, when and on which machine.

    Attributes
    ----------
    scene : str
        The region of collisions, as ``"figure4"``.
    measured_at, machine, model_version : str
        Date; processor and libraries; a hash of the code that was measured.
    steps : list of WantedError
        For some wanted errors.
    rows : list of Row
        Methods with their knobs.

    Examples
    --------
    >>> sorted({row.method for row in stored_measurement("stiff").rows})[0]
    'auto'
    """

    scene: SceneName
    measured_at: str
    machine: str
    model_version: str
    steps: list[WantedError]
    rows: list[Row] = field(default_factory=list)


@dataclass(frozen=True)
class _Outcome:
    """What a method made of the collisions that it did not refuse."""

    answered: npt.NDArray[np.intp]
    epsilon_t: FloatArray
    switches: Counts
    seconds: float


def measure(candidate: Candidate, truth: Reference) -> Row:
    """Return the cost and the errors of one method with its knobs."""
    truth = truth.at(slice(candidate.collisions))
    count = truth.kappa.size
    outcome = _outcome(candidate, truth)
    share = 1.0 - outcome.answered.size / count
    if share == 1.0:
        return Row(candidate.method, candidate.options, count, share)
    truth = truth.at(outcome.answered)
    wrong_switches = None
    if outcome.switches is not None:
        counted = truth.switches_certain & (outcome.switches >= 0)
        wrong = outcome.switches[counted] != truth.switches[counted]
        wrong_switches = float(wrong.mean()) if wrong.size else None
    error = np.abs(outcome.epsilon_t - truth.epsilon_t) + truth.error_bound
    median, p95, largest = np.quantile(error, (0.5, 0.95, 1.0)).tolist()
    opposite = np.sign(outcome.epsilon_t) * np.sign(truth.epsilon_t) < 0
    return Row(
        candidate.method,
        candidate.options,
        count,
        share,
        1e6 * outcome.seconds,
        median,
        p95,
        largest,
        float(np.mean(opposite)),
        wrong_switches,
    )


def _outcome(candidate: Candidate, truth: Reference) -> _Outcome:
    """Return the outcome of collisions, those of each η by themselves."""
    groups = by_damping(truth.damping)
    few = max(1, candidate.timed_collisions // len(groups))
    outcomes = []
    for eta, places in groups:
        part = candidate, truth.kappa[places], truth.psi[places], eta
        outcomes.append(_one_by_one(*part) if candidate.slow else _at_once(*part, few))
    answered = [places[part.answered] for (_, places), part in zip(groups, outcomes, strict=True)]
    sizes = [places.size for places in answered]
    counts = [part.switches for part in outcomes if part.switches is not None]
    return _Outcome(
        np.concatenate(answered),
        np.concatenate([part.epsilon_t for part in outcomes]),
        np.concatenate(counts) if counts else None,
        sum(part.seconds * size for part, size in zip(outcomes, sizes, strict=True) if size)
        / max(1, sum(sizes)),
    )


def _at_once(
    candidate: Candidate, kappa: FloatArray, psi: FloatArray, damping: float, few: int
) -> _Outcome:
    """Return the outcome of collisions as one request, of which `few` are timed several times."""
    answered = np.arange(kappa.size)
    try:
        epsilon_t, switches = candidate.run(kappa, psi, damping)
    except RestitutionError:
        each = (_answers(candidate.run, kappa[[i]], psi[[i]], damping) for i in answered)
        answered = np.flatnonzero(np.fromiter(each, bool))
        if answered.size == 0:
            return _Outcome(answered, np.empty(0), None, np.nan)
        kappa, psi = kappa[answered], psi[answered]
        epsilon_t, switches = candidate.run(kappa, psi, damping)
    timed = candidate.timed or candidate.run
    times = []
    for _ in range(REPEATS):
        # of the process: so many collisions are shared by several threads
        begin = time.process_time()
        timed(kappa[:few], psi[:few], damping)
        times.append(time.process_time() - begin)
    return _Outcome(answered, epsilon_t, switches, statistics.median(times) / kappa[:few].size)


def _answers(run: Run, kappa: FloatArray, psi: FloatArray, damping: float) -> bool:
    try:
        run(kappa, psi, damping)
    except RestitutionError:
        return False
    return True


def _one_by_one(
    candidate: Candidate, kappa: FloatArray, psi: FloatArray, damping: float
) -> _Outcome:
    """Return the outcome of collisions as a request each, with their mean time."""
    answered, results, seconds = [], [], 0.0
    # the first call of all imports libraries
    _answers(candidate.run, kappa[:1], psi[:1], damping)
    for i in range(kappa.size):
        begin = time.thread_time()
        try:
            results.append(candidate.run(kappa[[i]], psi[[i]], damping))
        except RestitutionError:
            continue
        seconds += time.thread_time() - begin
        answered.append(i)
    counts = [switches for _, switches in results if switches is not None]
    return _Outcome(
        np.array(answered, np.intp),
        np.array([epsilon_t[0] for epsilon_t, _ in results]),
        np.concatenate(counts) if counts else None,
        seconds / max(1, len(answered)),
    )


def study_tradeoff(
    scene: SceneName, chosen: Sequence[Candidate] | None = None
) -> Iterator[tuple[float, Measurement]]:
    """Yield the progress, 0 … 1, and what is measured so far on a scene, row by row.

    Parameters
    ----------
    scene : str
        Of `SCENES`.
    chosen : sequence of Candidate, optional
        Those to measure; all of `candidates` by default.
    """
    every = candidates(damped=any(SCENES[scene].dampings)) if chosen is None else chosen
    truth = reference(scene, COLLISIONS)
    measurement = Measurement(
        scene,
        datetime.now(UTC).isoformat(timespec="seconds"),
        machine(),
        MODEL_VERSION,
        [_steps(scene, error) for error in WANTED_ERRORS],
    )
    yield 0.0, measurement
    for done, candidate in enumerate(every, 1):
        measurement.rows.append(measure(candidate, truth))
        yield done / len(every), measurement


def _steps(scene: SceneName, error: float) -> WantedError:
    study = study_steps(error, scene)
    return WantedError(error, study.needed, study.rule, study.rule_steps)


def machine() -> str:
    """Return the processor and the versions that a measurement depends on, without any name."""
    cpu = platform.processor() or platform.machine()
    information = Path("/proc/cpuinfo")
    if information.exists():
        lines = information.read_text("utf-8").splitlines()
        cpu = next((x.split(":")[1].strip() for x in lines if x.startswith("model name")), cpu)
    return (
        f"{cpu}, {os.cpu_count()} cores; Python {platform.python_version()}, "
        f"numpy {np.__version__}, numba {version('numba')}"
    )


STORED = Path(__file__).with_name("tradeoff.json")
"""The last measurement of every scene, kept with the package."""


def load_tradeoff(source: Path = STORED) -> dict[SceneName, Any]:
    """Return stored measurements, scene → `Measurement` as a dictionary."""
    stored: dict[SceneName, Any] = json.loads(source.read_text("utf-8"))
    return stored


def stored_measurement(scene: SceneName) -> Measurement:
    """Return the measurement of a scene that is kept with the package."""
    stored = load_tradeoff()[scene]
    steps = [
        WantedError(
            wanted["error"],
            {name: _kept(needed) for name, needed in wanted["needed"].items()},
            {name: Spread(**spread) for name, spread in wanted["rule"].items()},
            (wanted["rule_steps"][0], wanted["rule_steps"][1]),
        )
        for wanted in stored["steps"]
    ]
    return Measurement(**stored | {"steps": steps, "rows": [Row(**row) for row in stored["rows"]]})


def _kept(needed: dict[str, Any]) -> Needed:
    tried = {
        name: Tried(**needed[name]) if needed[name] else None
        for name in ("p95_tried", "worst_tried")
    }
    return Needed(**needed | tried)


def store_tradeoff(measurement: Measurement, target: Path = STORED) -> None:
    """Write a measurement over the last one of its scene; others stay as they are."""
    kept = load_tradeoff(target) if target.exists() else {}
    kept[measurement.scene] = asdict(measurement)
    _write({scene: kept[scene] for scene in SCENES if scene in kept}, target)


def _write(stored: dict[SceneName, Any], target: Path) -> None:
    # whole or not at all: measurements of other scenes are in it
    partial = target.with_name(f"{target.name}.{os.getpid()}")
    try:
        partial.write_text(json.dumps(stored, indent=1) + "\n", "utf-8")
        partial.replace(target)
    finally:
        partial.unlink(missing_ok=True)


def store_rows(scene: SceneName, rows: Sequence[Row], target: Path = STORED) -> None:
    """Write rows of a scene beside those of other methods, over the last ones of their own."""
    kept = load_tradeoff(target)
    methods = {row.method for row in rows}
    others = [row for row in kept[scene]["rows"] if row["method"] not in methods]
    kept[scene]["rows"] = others + [asdict(row) for row in rows]
    _write(kept, target)
