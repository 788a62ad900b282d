"""Figures of a run: as a table, beside those of the last run, and stored for the next.

Machines differ and share their cores: a time is given over that of a calibration loop of its own
run, and the comparison with the last run is one of these ratios.
"""

import json
import os
import platform
import re
import statistics
import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from restitution.mechanics.compiled import MODEL_VERSION

RUNS = 7
SECONDS = {"ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1.0}

Clock = Callable[[], float]


def median(run: Callable[[], object], runs: int = RUNS, clock: Clock = time.thread_time) -> float:
    """Return the median time of `run` in seconds, after one run that does not count."""
    run()
    times = []
    for _ in range(runs):
        begin = clock()
        run()
        times.append(clock() - begin)
    return statistics.median(times)


def calibration() -> float:
    """Return the seconds of a fixed piece of interpreted and compiled arithmetic."""
    values = np.linspace(0.0, 1.0, 100_000)

    def run() -> float:
        total = sum(i * i for i in range(100_000))
        return total + float(np.sum(np.sin(values) ** 2))

    return median(run, 21)


def in_loops(name: str, value: float, unit: float) -> float:
    """Return a figure that is a time over that of the calibration loop, any other as it is."""
    found = re.search(r", (ns|µs|ms|s)\b", name)
    return value * SECONDS[found[1]] / unit if found else value


def report(figures: dict[str, float], results: Path) -> None:
    """Print figures, compared with those that `results` holds of the last run, and store them."""
    unit = calibration()
    last = json.loads(results.read_text()) if results.exists() else None
    width = max(map(len, figures))
    print(f"{'':{width}s}{'now':>12s}{'÷ loop':>12s}{'÷ last':>9s}")
    for name, value in figures.items():
        loop = in_loops(name, value, unit)
        ratio = ""
        if last and last["figures"].get(name):
            before = in_loops(name, last["figures"][name], last["calibration_s"])
            ratio = f"{loop / before:9.2f}"
        shown = f"{loop:12.3g}" if loop != value else f"{'':12s}"
        print(f"{name:{width}s}{value:12.4g}{shown}{ratio}".rstrip())
    record = {
        "measured_at": datetime.now(UTC).isoformat(timespec="seconds"),
        "machine": f"{platform.processor() or platform.machine()}, {os.cpu_count()} cores",
        "python": platform.python_version(),
        "model_version": MODEL_VERSION,
        "calibration_s": unit,
        "figures": figures,
    }
    results.write_text(json.dumps(record, indent=2, ensure_ascii=False) + "\n")
    print(f"stored in {results.name}; the calibration loop took {1e3 * unit:.2f} ms")
