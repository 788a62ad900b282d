"""Tables on Dask: what is interrupted, killed or resumed ends as if it had not been."""

import itertools
import os
import pickle
import signal
import subprocess
import sys
from pathlib import Path

import dask
import numpy as np
import psutil
import pytest
import zarr
from click.testing import CliRunner
from distributed import Client

from cases import every_day
from restitution.cli import main
from restitution.errors import CostError, ParameterError, RestitutionError
from restitution.export.on_dask import compute_table, local_cluster
from restitution.export.zarr_store import (
    CHUNK_ENTRIES,
    chunk_shape,
    finish,
    missing_chunks,
    open_store,
    write_chunk,
)
from restitution.studies.collision.axis import Axis
from restitution.studies.tables.export import study_table
from restitution.studies.tables.grid import TableGrid
from waiting import LIMIT_SECONDS

PLANE = TableGrid(Axis(0.5, 30.0, 90, "log"), Axis(0.05, 3.0, 70, "log"), 0.0)
DAMPED_PLANE = TableGrid(Axis(0.5, 30.0, 90, "log"), Axis(0.0, 3.0, 70), 0.2)
SPACE = TableGrid(Axis(2.0, 30.0, 31, "log"), Axis(0.05, 2.0, 29, "log"), Axis(0.0, 0.4, 7))
LONG = TableGrid(Axis(0.5, 60.0, 500, "log"), Axis(0.05, 2.0, 500, "log"), 0.0)
LONG_CHUNK = 10_000
LOG = ["--kappa-scale", "log", "--psi-scale", "log"]
LONG_OPTIONS = ["--kappa", "0.5", "60", "--kappa-count", "500",
                "--psi", "0.05", "2", "--psi-count", "500", *LOG]  # fmt: skip
GRIDS = {"two": PLANE, "eta": DAMPED_PLANE, "three": SPACE}
STORES = itertools.product(GRIDS, ["paper", "reversed"])


@pytest.fixture(scope="module")
def cluster():
    with local_cluster(2) as started:
        yield started


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """The store of `LONG`, made without any Dask."""
    path = tmp_path_factory.mktemp("undisturbed") / "table.zarr"
    open_store(path, LONG, "paper", LONG_CHUNK)
    for index in missing_chunks(path)[0]:
        write_chunk(str(path), index)
    finish(path)
    return contents(path)


def contents(path):
    """Return what the files of a store hold, by name."""
    return {
        file.relative_to(path).as_posix(): file.read_bytes()
        for file in sorted(path.rglob("*"))
        if file.is_file()
    }


def times_of_chunks(path):
    return {
        file: file.stat().st_mtime_ns for file in path.glob("epsilon_t/c/**/*") if file.is_file()
    }


def entries(path):
    return np.asarray(zarr.open_group(path, mode="r")["epsilon_t"][...])


@pytest.mark.parametrize(("parameters", "sign"), every_day([("three", "reversed")], of=STORES))
def test_store_is_the_table_computed_in_place(parameters, sign, tmp_path, cluster):
    grid = GRIDS[parameters]
    path = tmp_path / "table.zarr"
    open_store(path, grid, sign, 700)
    progress = list(compute_table(path, grid, sign, scheduler=cluster.scheduler_address))
    largest = finish(path)
    table = study_table(grid.kappa, grid.psi, sign, grid.damping, seconds=60)
    group = zarr.open_group(path, mode="r")
    assert group["epsilon_t"].chunks != grid.shape
    # to the bit
    assert entries(path).tobytes() == table.epsilon_t.tobytes()
    # each chunk is judged by itself, but no error is larger than a bound
    assert largest.found <= table.largest_error
    assert table.largest_error <= 3.0 * largest.stated
    assert group.attrs["largest_error"] == largest.stated
    assert group.attrs["error_basis"] == largest.basis
    for name, axis in grid.axes.items():
        assert np.array_equal(group[name][...], axis.values(positive=False))
    assert group["epsilon_t"].metadata.dimension_names == tuple(grid.axes)
    total = group["epsilon_t"].nchunks
    assert progress == [(done, total) for done in range(total + 1)]


def test_cells_between_chunks_are_judged(tmp_path):
    path = tmp_path / "table.zarr"
    grid = TableGrid(Axis(3.0, 9.0, 3, "log"), Axis(0.1, 2.0, 3, "log"), Axis(0.0, 0.3, 2))
    # an entry each: every cell lies between chunks
    open_store(path, grid, "paper", 1)
    for index in missing_chunks(path)[0]:
        write_chunk(str(path), index)
    table = study_table(grid.kappa, grid.psi, "paper", grid.damping, seconds=60)
    assert entries(path).tobytes() == table.epsilon_t.tobytes()
    assert table.error_basis == "measured slope"
    # a cell by itself is known at least as well
    assert 0.5 * table.largest_error <= finish(path).stated <= table.largest_error


def test_nothing_of_a_local_cluster_is_open_to_other_machines(cluster):
    with Client(cluster, set_as_default=False) as client:
        pids = {os.getpid(), *client.run(os.getpid).values()}
    listening = [
        connection.laddr.ip
        for pid in pids
        for connection in psutil.Process(pid).net_connections("inet")
        if connection.status == psutil.CONN_LISTEN
    ]
    # the scheduler, both workers, their nannies
    assert len(listening) >= 5
    assert set(listening) == {"127.0.0.1"}


@pytest.mark.verify
def test_killed_worker_leaves_no_trace(tmp_path, cluster, undisturbed):
    path = tmp_path / "table.zarr"
    open_store(path, LONG, "paper", LONG_CHUNK)
    with Client(cluster, set_as_default=False) as client:
        pids = client.run(os.getpid)
        for done, total in compute_table(path, LONG, "paper", scheduler=cluster.scheduler_address):
            if done == total // 2:
                os.kill(next(iter(pids.values())), signal.SIGKILL)
        finish(path)
        client.wait_for_workers(2)
        assert set(client.run(os.getpid).values()) != set(pids.values())
    assert contents(path) == undisturbed


@pytest.mark.verify
def test_killed_run_goes_on_with_what_is_missing(tmp_path, cluster, undisturbed):
    path = tmp_path / "table.zarr"
    open_store(path, LONG, "paper", LONG_CHUNK)
    program = Path(sys.executable).with_name("restitution")
    command = [program, "table", *LONG_OPTIONS, "--store", path, "--workers", "2"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        for line in process.stderr:
            if line.startswith("4 of"):
                workers = psutil.Process(process.pid).children(recursive=True)
                process.kill()
                break
    # they notice, instead of going on by themselves
    _, alive = psutil.wait_procs(workers, timeout=LIMIT_SECONDS)
    assert not alive
    before = times_of_chunks(path)
    missing, total = missing_chunks(path)
    assert 4 <= total - len(missing) < total
    progress = list(compute_table(path, LONG, "paper", scheduler=cluster.scheduler_address))
    finish(path)
    assert progress[0] == (total - len(missing), total)
    assert progress[-1] == (total, total)
    after = times_of_chunks(path)
    assert len(after) == total
    renewed = {file for file in after if before.get(file) != after[file]}
    assert len(renewed) == len(missing)
    assert contents(path) == undisturbed


def test_finished_table_is_left_as_it_is_by_the_command(tmp_path):
    path = tmp_path / "table.zarr"
    options = ["--kappa", "3", "6", "--kappa-count", "9", "--psi", "0.1", "2", "--psi-count", "8"]
    third = [*LOG, "--damping", "0", "0.2", "--damping-count", "3"]
    grid = TableGrid(Axis(3.0, 6.0, 9, "log"), Axis(0.1, 2.0, 8, "log"), Axis(0.0, 0.2, 3))
    open_store(path, grid, "paper", 40)
    for index in missing_chunks(path)[0]:
        write_chunk(str(path), index)
    before = times_of_chunks(path)
    done = CliRunner().invoke(main, ["table", *options, *third, "--store", str(path)])
    assert done.exit_code == 0, done.output
    assert f"{len(before)} of {len(before)} chunks are in" in done.stderr
    assert "9 × 8 × 3 entries" in done.stderr
    assert times_of_chunks(path) == before


OTHERS = {
    "kappa maximum": TableGrid(Axis(0.5, 31.0, 90, "log"), PLANE.psi, 0.0),
    "kappa count": TableGrid(Axis(0.5, 30.0, 91, "log"), PLANE.psi, 0.0),
    "psi scale": TableGrid(PLANE.kappa, Axis(0.05, 3.0, 70), 0.0),
    "damping": TableGrid(PLANE.kappa, PLANE.psi, 0.1),
    "damping minimum": TableGrid(PLANE.kappa, PLANE.psi, Axis(0.0, 1.0, 3)),
}


@pytest.mark.parametrize(("words", "other"), OTHERS.items(), ids=list(OTHERS))
def test_store_of_other_parameters_is_refused(words, other, tmp_path):
    path = tmp_path / "table.zarr"
    open_store(path, PLANE, "paper")
    before = contents(path)
    with pytest.raises(ParameterError, match=words):
        next(compute_table(path, other, "paper"))
    with pytest.raises(ParameterError, match="sign"):
        next(compute_table(path, PLANE, "reversed"))
    assert contents(path) == before


def test_store_of_another_model_is_refused_by_command_and_worker(tmp_path):
    path = tmp_path / "table.zarr"
    open_store(path, PLANE, "paper")
    zarr.open_group(path, mode="r+").attrs["model_version"] = "another"
    with pytest.raises(ParameterError, match="model version"):
        open_store(path, PLANE, "paper")
    with pytest.raises(RestitutionError, match="same restitution everywhere"):
        write_chunk(str(path), (0, 0))
    assert len(missing_chunks(path)[0]) == missing_chunks(path)[1]


def test_what_is_no_store_is_refused_and_kept(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    for path in (tmp_path, tmp_path / "notes.txt"):
        with pytest.raises(ParameterError, match="Zarr store"):
            open_store(path, PLANE, "paper")
    zarr.create_group(tmp_path / "other.zarr")
    with pytest.raises(ParameterError, match="Zarr store"):
        open_store(tmp_path / "other.zarr", PLANE, "paper")
    assert (tmp_path / "notes.txt").read_text() == "mine"


def test_wrong_axes_and_stiff_collisions_leave_no_store(tmp_path):
    path = tmp_path / "table.zarr"
    with pytest.raises(ParameterError, match="kappa"):
        next(
            compute_table(
                path, TableGrid(Axis(2.0, 1.0, 9, "log", "kappa "), PLANE.psi, 0.0), "paper"
            )
        )
    with pytest.raises(CostError, match="50,000"):
        next(compute_table(path, TableGrid(Axis(1e12, 1e13, 9), PLANE.psi, 0.0), "paper"))
    assert not list(tmp_path.iterdir())


def test_path_that_workers_do_not_have_is_told_in_words(tmp_path, cluster):
    path = tmp_path / "table.zarr"
    progress = compute_table(path, PLANE, "paper", scheduler=cluster.scheduler_address)
    next(progress)
    path.rename(tmp_path / "elsewhere.zarr")
    with pytest.raises(RestitutionError, match="a path that every worker has"):
        next(progress)


def test_parameter_error_survives_the_way_between_processes():
    error = pickle.loads(pickle.dumps(ParameterError("kappa", -1.0, "positive")))  # noqa: S301 - ours
    assert str(error) == "kappa must be positive, got -1.0"
    assert (error.parameter, error.value, error.requirement) == ("kappa", -1.0, "positive")


def test_worker_out_of_reach_is_told_in_words(tmp_path):
    progress = compute_table(tmp_path / "t.zarr", PLANE, "paper", scheduler="tcp://127.0.0.1:9")
    next(progress)
    with (
        dask.config.set({"distributed.comm.timeouts.connect": "0.5s"}),
        pytest.raises(RestitutionError, match="no Dask scheduler answers at"),
    ):
        next(progress)


@pytest.mark.parametrize("absent", ["distributed", "zarr"])
def test_missing_extra_is_named(absent, tmp_path, monkeypatch):
    for module in [name for name in sys.modules if name.startswith("restitution.export.")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, absent, None)
    done = CliRunner().invoke(main, ["table", "--store", str(tmp_path / "table.zarr")])
    assert done.exit_code == 1
    assert f"there is no {absent}" in done.stderr
    assert "pip install 'restitution[cluster]'" in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--store", "t.zarr", "--error", "0.1"], "--error is of no use with --store"),
        (["--store", "t.zarr", "--format", "c"], "--format is of no use with --store"),
        (["--workers", "2"], "--workers is of no use with a table without --store"),
        (["--store", "t.zarr", "--workers", "2", "--scheduler", "tcp://x:1"], "--workers"),
    ],
)
def test_options_of_no_use_are_refused(options, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(main, ["table", *options])
    assert done.exit_code == 2
    assert words in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "shape", [(2, 2), (150, 200), (4000, 4000), (3, 4000, 4000), (10**4, 10**4, 10**4), (2, 10**7)]
)
def test_chunks_are_small_few_and_of_one_size(shape):
    chunk = chunk_shape(shape)
    assert np.prod(chunk) <= 1.02 * CHUNK_ENTRIES
    numbers = [-(-count // side) for count, side in zip(shape, chunk, strict=True)]
    least = np.prod([float(count) for count in shape]) / CHUNK_ENTRIES
    assert np.prod([float(number) for number in numbers]) <= 1 + 2.0 * least
    # the last along an axis is hardly smaller
    for count, side, number in zip(shape, chunk, numbers, strict=True):
        assert 0 <= number * side - count < number
