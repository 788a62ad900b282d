"""Large tables with damaged parts: computed anew when they are gone on with, or refused."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from damages import DAMAGES, damage, files
from restitution.errors import ParameterError
from restitution.export.on_dask import compute_table
from restitution.export.zarr_store import finish, missing_chunks, open_store, write_chunk
from restitution.studies.collision.axis import Axis
from restitution.studies.tables.grid import TableGrid

GRID = TableGrid(Axis(3.0, 6.0, 9, "log"), Axis(0.1, 2.0, 8, "log"), 0.0)


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A table in four chunks, finished."""
    store = tmp_path_factory.mktemp("tables") / "table.zarr"
    open_store(store, GRID, "paper", 20)
    for index in missing_chunks(store)[0]:
        write_chunk(str(store), index)
    finish(store)
    return store


def contents(store: Path) -> dict[str, bytes]:
    return {file.relative_to(store).as_posix(): file.read_bytes() for file in files(store)}


@pytest.mark.parametrize("how", [*DAMAGES, "gone"])
@pytest.mark.parametrize("name", ["epsilon_t/c/1/0", "interpolation_error/c/1/1/0", "kappa/c/0"])
def test_a_damaged_part_of_a_large_table_is_computed_anew(finished, tmp_path, caplog, name, how):
    store = shutil.copytree(finished, tmp_path / "table.zarr")
    if how == "gone":
        (store / name).unlink()
    else:
        damage(store / name, how)
    open_store(store, GRID, "paper", 20)
    for index in missing_chunks(store)[0]:
        write_chunk(str(store), index)
    finish(store)
    assert contents(store) == contents(finished)
    # an error that is gone is that of a chunk that was never written
    assert len(caplog.messages) == (how != "gone" or "interpolation_error" not in name)
    assert all("damaged" in message for message in caplog.messages)
    assert missing_chunks(store)[0] == []


@pytest.mark.parametrize("name", ["zarr.json", "epsilon_t/zarr.json", "psi/zarr.json"])
def test_a_table_whose_description_is_damaged_is_refused(finished, tmp_path, name):
    store = shutil.copytree(finished, tmp_path / "table.zarr")
    damage(store / name, "truncated")
    with pytest.raises(ParameterError, match="store must be a new path"):
        next(compute_table(store, GRID, "paper"))


@pytest.mark.verify
def test_the_command_goes_on_over_a_damaged_chunk(tmp_path):
    program = Path(sys.executable).with_name("restitution")
    ends = ["--kappa", "0.5", "60", "--psi", "0.05", "2"]
    counts = ["--kappa-count", "500", "--psi-count", "500"]
    command = [program, "table", *ends, *counts, "--store", tmp_path / "table.zarr"]
    runs = []
    for _ in range(2):
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        runs.append((contents(tmp_path / "table.zarr"), done.stderr))
        (tmp_path / "table.zarr" / "epsilon_t" / "c" / "0" / "1").write_bytes(b"")
    assert runs[1][0] == runs[0][0]
    assert "1 of 4 chunks in" in runs[1][1]
    assert "are damaged, as that at (0, 1): computed anew" in runs[1][1]
