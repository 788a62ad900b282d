"""Costs and times: kernels, a general solver at the same points, requests, start-up.

Prints a table and writes bench.json. If an earlier bench.json is there, each figure is compared
with it as a ratio, after both are divided by a calibration loop of their own run: machines differ
and share their cores.
"""

import http.client
import json
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from record import RUNS, median, report
from solver import solve_with_events

from one_by_one import collide_each
from restitution.mechanics import collision, contact
from restitution.mechanics.damped import preparing
from restitution.mechanics.lanes.rows import work_space
from restitution.methods import planner, table
from restitution.methods.options import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.grid import study_grid
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.trace import study_trace

RESULTS = Path(__file__).parents[2] / "bench.json"
RESTITUTION = Path(sys.executable).with_name("restitution")
PORT = 8641
SLOW_MILLISECONDS = 50
MOST_SWITCHES = float(collision.MOST_SWITCHES)


def kernel(kappa: np.ndarray, psi: np.ndarray) -> dict[str, float]:
    """Return µs of thread CPU per collision, one after the other and in lanes, one thread."""
    outputs = (
        np.empty(kappa.size),
        np.empty(kappa.size, np.int32),
        np.empty(kappa.size, np.bool_),
        np.empty(kappa.size),
    )
    run = contact.ELASTIC, MOST_SWITCHES, kappa, psi, *outputs
    alone = median(lambda: collide_each(*run))
    in_lanes = median(lambda: collision._collide_in_lanes(*run, *work_space()))
    return {
        "alone": 1e6 * alone / kappa.size,
        "in lanes": 1e6 * in_lanes / kappa.size,
        "ratio": alone / in_lanes,
        "switches": float(outputs[1].mean()),
    }


def plane(kappa: np.ndarray, tangential: np.ndarray) -> list[np.ndarray]:
    """Return κ and ψ of a map at μ/α = 1.4."""
    return [axis.ravel() for axis in np.meshgrid(kappa, tangential / 1.4)]


def kernels() -> dict[str, float]:
    """Return the costs of mechanics and studies."""
    rng = np.random.default_rng(2008)
    grid = plane(np.linspace(0.1, 70, 500), np.linspace(0.01, 4, 500))
    order = rng.permutation(grid[0].size)
    stiff = np.exp(rng.uniform(np.log(70.0), np.log(1e4), 100_000))
    figures = {
        name: kernel(*collisions)
        for name, collisions in {
            "linear grid": grid,
            "shuffled": [axis[order] for axis in grid],
            "log grid": plane(np.geomspace(0.1, 70, 500), np.geomspace(0.01, 4, 500)),
            "κ 70…10⁴": [stiff, rng.uniform(0.01, 2.0, stiff.size)],
        }.items()
    }
    axes = Axis(0.1, 70, 300), Axis(0.01, 4, 200)
    one = CollisionParameters(63.0, 1.4, 1.358)
    trace = median(lambda: study_trace(one, Options(), 400), 101)
    return {
        **{f"collision, {name}, µs CPU": each["alone"] for name, each in figures.items()},
        **{f"in lanes, {name}, µs CPU": each["in lanes"] for name, each in figures.items()},
        **{f"alone over in lanes, {name}": each["ratio"] for name, each in figures.items()},
        "switches per collision, linear grid": figures["linear grid"]["switches"],
        "map 300×200, ms wall, all cores": 1e3
        * median(lambda: study_grid(*axes, 1.4), clock=time.perf_counter),
        "trace of 400 samples, ms CPU": 1e3 * trace,
    }


def damping_figures(eta: float = 0.1) -> dict[str, float]:
    """Return the costs of an η and of collisions with it, one thread."""
    rng = np.random.default_rng(2011)
    linear = np.meshgrid(np.linspace(0.1, 70, 150), np.linspace(0.01, 4, 150) / 1.4)
    ranges = np.log([[0.3, 400.0], [0.05, 3.0]])
    scattered = [np.exp(rng.uniform(low, high, 20_000)) for low, high in ranges]
    figures = {}
    for name, axes in (("linear grid", linear), ("κ .3…400, ψ .05…3", scattered)):
        kappa, psi = (axis.ravel() for axis in axes)
        outputs = [np.empty(kappa.size, t) for t in (float, np.int32, np.bool_, float)]
        run = [contact.contact_of(eta), float(MOST_SWITCHES), kappa, psi, *outputs]
        alone = median(lambda run=run: collide_each(*run))
        in_lanes = median(lambda run=run: collision._collide_in_lanes(*run, *work_space()))
        figures[f"damped collision, {name}, µs CPU"] = 1e6 * alone / kappa.size
        figures[f"damped in lanes, {name}, µs CPU"] = 1e6 * in_lanes / kappa.size
    prepare = median(lambda: preparing.prepare(eta, preparing.MOST_STEPS), 51)
    return figures | {"preparing a new η, ms CPU": 1e3 * prepare}


def table_figures() -> dict[str, float]:
    """Return the costs of the table, and what a map for the screen saves by it."""
    begin = time.thread_time()
    table.build()
    built = time.thread_time() - begin
    grid = np.meshgrid(np.geomspace(*table.KAPPA_RANGE, 1000), np.geomspace(*table.PSI_RANGE, 1000))
    kappa, psi = (axis.ravel() for axis in grid)
    order = np.random.default_rng(1).permutation(kappa.size)
    shuffled = kappa[order], psi[order]
    screen = np.meshgrid(np.geomspace(0.1, 1e6, 200), np.linspace(0.01, 4, 150) / 1.4)
    kappas, psis = (axis.ravel() for axis in screen)
    options = Options(tolerance=4e-3)
    cheap = median(
        lambda: planner.solve(kappas, psis, ("epsilon_t",), options), clock=time.process_time
    )
    exact = median(lambda: collision.collide(kappas, psis), clock=time.process_time)
    return {
        "table, built once, s CPU": built,
        "table, map order, ns CPU": 1e9 * median(lambda: table.read(kappa, psi)) / kappa.size,
        "table, random order, ns CPU": 1e9 * median(lambda: table.read(*shuffled)) / kappa.size,
        "map to κ = 10⁶, exact over auto at 4e-3": exact / cheap,
    }


def general_solver(points: int = 40) -> dict[str, float]:
    """Return cost and error of scipy's solve_ivp with events beside ours at the same points."""
    rng = np.random.default_rng(2008)
    kappa, psi = rng.uniform(0.1, 70, points), rng.uniform(0.01, 4, points) / 1.4
    exact = collision.collide(kappa, psi).epsilon_t
    errors, begin = [], time.thread_time()
    for k, p, e in zip(kappa, psi, exact, strict=True):
        errors.append(abs(solve_with_events(k, p) - e))
    theirs = (time.thread_time() - begin) / points
    repeated = np.tile(kappa, 500), np.tile(psi, 500)
    outputs = [np.empty(repeated[0].size, t) for t in (float, np.int32, np.bool_, float)]
    run = [contact.ELASTIC, MOST_SWITCHES, *repeated, *outputs]
    ours = median(lambda: collide_each(*run))
    return {
        "solve_ivp with events (rtol 1e-9), µs CPU per collision": 1e6 * theirs,
        "its median error in ε_t": float(np.median(errors)),
        "its largest error in ε_t": float(np.max(errors)),
        "its cost over ours": theirs / (ours / repeated[0].size),
    }


@contextmanager
def server(cache: str | None = None):
    """Start a real server; yield the seconds until it was ready."""
    environment = os.environ | ({"NUMBA_CACHE_DIR": cache} if cache else {})
    begin = time.perf_counter()
    process = subprocess.Popen(
        [RESTITUTION, "serve", "--port", str(PORT)],
        env=environment,
        stdout=subprocess.DEVNULL,
        # its log, of which a terminal would get more than of the table
        stderr=subprocess.DEVNULL,
    )
    try:
        while True:
            try:
                connection = http.client.HTTPConnection("127.0.0.1", PORT, timeout=5)
                connection.request("GET", "/readyz")
                if connection.getresponse().status == 200:
                    break
            except OSError:
                pass
            time.sleep(0.01)
        yield time.perf_counter() - begin
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(20)


def start_up() -> dict[str, float]:
    """Return the seconds from the command to readiness, with and without cached kernels."""
    with tempfile.TemporaryDirectory() as cache:
        with server(cache) as first:
            pass
        again = []
        for _ in range(3):
            with server(cache) as seconds:
                again.append(seconds)
    return {"start, first time, s": first, "start, kernels cached, s": statistics.median(again)}


def requests() -> dict[str, float]:
    """Return the wall time of requests over one kept connection, as a client sees it."""
    common = "kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358"
    paths = {
        "GET /collision, ms": f"/collision?{common}",
        "GET /trace, 400 samples, JSON, ms": f"/trace?{common}",
        "GET /trace, 400 samples, base64, ms": f"/trace?{common}&encoding=base64",
        "GET /map, 200×150, base64, ms": "/map?mu_over_alpha=1.4&encoding=base64",
        "GET /cut, 400 points, base64, ms": (
            "/cut?along=gt_over_gn&kappa=63&mu_over_alpha=1.4&encoding=base64"
        ),
        "GET /steps, a region, ms": "/steps?region=figure4",
        "GET /table, 200×150, NPZ, ms": "/table?format=npz",
        "GET /table for an error of 0.05, NPZ, ms": "/table?error=0.05&format=npz",
        "GET /paper, computed before, ms": "/paper",
        "GET /collision by the general solver, κ = 10⁶, ms": (
            "/collision?kappa=1e6&mu_over_alpha=1&gt_over_gn=1&method=ode"
        ),
    }
    million = {"kappa": np.linspace(0.1, 70, 1_000_000).tolist(), "mu_over_alpha": 1.4}
    body = json.dumps(million | {"gt_over_gn": 1.0})
    texts = json.dumps(million | {"kappa": ["x"] * 1_000_000, "gt_over_gn": 1.0})
    results = {}
    with server():
        connection = http.client.HTTPConnection("127.0.0.1", PORT)

        def fetch(method: str, path: str, body: str | None = None) -> None:
            connection.request(method, f"/api/v1{path}", body, {"Content-Type": "application/json"})
            assert connection.getresponse().read()

        def wall(*request: str, runs: int) -> float:
            return median(lambda: fetch(*request), runs, time.perf_counter)

        for name, path in paths.items():
            slow = 1e3 * wall("GET", path, runs=1) > SLOW_MILLISECONDS
            results[name] = 1e3 * wall("GET", path, runs=RUNS if slow else 51)
        results["POST /collisions, 10⁶ collisions, s"] = wall("POST", "/collisions", body, runs=3)
        refused = wall("POST", "/collisions", texts, runs=3)
        results["POST /collisions, 10⁶ texts refused, s"] = refused
    return results


def main() -> None:
    """Measure, compare with the last run, print and store."""
    figures = (
        kernels() | damping_figures() | table_figures() | general_solver() | requests() | start_up()
    )
    report(figures, RESULTS)


if __name__ == "__main__":
    main()
