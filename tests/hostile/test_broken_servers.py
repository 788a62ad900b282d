"""Servers whose kept files are damaged, or that can keep none, answer as a healthy one."""

import itertools
import resource
import shutil
from pathlib import Path

import brotli
import numpy as np
import pytest

from damages import DAMAGES, damage, files
from restitution.api.page import compress_page
from restitution.api.settings import Settings
from restitution.api.warm import warm, warm_rest
from restitution.mechanics.compiled import CACHE_FOLDER, MODEL_VERSION
from servers import serving, starting, wait_until_ready
from waiting import eventually

COLLISION = "kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358"
QUESTIONS = (
    *(f"/api/v1/collision?{COLLISION}&method={m}" for m in ("exact", "table", "timestep", "stiff")),
    f"/api/v1/collision?{COLLISION}&damping=0.1",
    f"/api/v1/trace?{COLLISION}",
    f"/api/v1/trace?{COLLISION}&damping=0.1",
    "/api/v1/map?mu_over_alpha=1.4&tolerance=4e-3&quantities=epsilon_t",
    "/assets/plotly.min.js",
    "/static/main.js",
    "/",
)


def answers(server):
    """Return what a server answers, the page once it is compressed."""

    def is_compressed():
        assert server.get(QUESTIONS[-3], **{"Accept-Encoding": "br"})[1]["Content-Encoding"] == "br"

    eventually(is_compressed)
    found = {}
    for path in QUESTIONS:
        status, headers, body = server.get(path, **{"Accept-Encoding": "br"})
        packed = headers["Content-Encoding"] == "br"
        found[path] = status, brotli.decompress(body) if packed else body
    return found


def complaints(server):
    return [e["event"] for e in server.events() if e["level"] in {"warning", "error", "critical"}]


def assert_told(server, words):
    assert [event for event in server.events() if words in str(event)]


@pytest.fixture(scope="module")
def everything(tmp_path_factory):
    """A folder with all that a server keeps, and what it answers."""
    warm()
    compress_page(Settings().frontend_directory)
    warm_rest()
    folder = tmp_path_factory.mktemp("everything")
    shutil.copytree(CACHE_FOLDER, folder / "restitution" / MODEL_VERSION)
    with serving(tmp_path_factory.mktemp("log"), environment=at(folder)) as server:
        return folder, answers(server)


def at(folder: Path) -> dict[str, str]:
    return {"NUMBA_CACHE_DIR": str(folder), "XDG_CACHE_HOME": "", "HOME": "/dev/null"}


@pytest.mark.verify
@pytest.mark.parametrize("suffix", [".nbi", ".nbc", ".br", ".npz"])
def test_a_server_heals_whatever_is_damaged(everything, tmp_path, suffix):
    folder = shutil.copytree(everything[0], tmp_path / "kept")
    for file, how in zip(files(folder, suffix), itertools.cycle(DAMAGES), strict=False):
        damage(file, how)
    with serving(tmp_path, environment=at(folder)) as server:
        assert answers(server) == everything[1]
        (line,) = complaints(server)
        assert f"{suffix} is damaged: made anew" in line
        # what happens to the page from now on is of no consequence
        for file in files(folder, ".br"):
            file.write_bytes(b"")
        assert answers(server) == everything[1]
    with serving(tmp_path, environment=at(folder)) as server:
        assert answers(server) == everything[1]


@pytest.mark.verify
@pytest.mark.parametrize(
    "change",
    [
        lambda arrays: arrays | {"patches": arrays["patches"][:10, :7]},
        lambda arrays: arrays | {"patches": np.ones_like(arrays["patches"])},
        lambda arrays: arrays | {"division": np.full_like(arrays["division"], 2**30)},
        lambda arrays: {name: array.astype(float) for name, array in arrays.items()},
    ],
    ids=["shape", "values", "places", "type"],
)
def test_a_server_builds_a_table_anew_that_is_well_formed_and_wrong(everything, tmp_path, change):
    folder = shutil.copytree(everything[0], tmp_path / "kept")
    for file in files(folder, ".npz"):
        with np.load(file) as arrays:
            wrong = change(dict(arrays))
        np.savez(file, **wrong)
    with serving(tmp_path, environment=at(folder)) as server:
        assert answers(server) == everything[1]
        (line,) = complaints(server)
        assert ".npz is damaged: made anew" in line


@pytest.mark.verify
def test_a_server_does_without_room(everything, tmp_path):
    command = ("prlimit", f"--fsize={2**17}")
    for _ in range(2):
        with starting(tmp_path, command, at(tmp_path / "kept")) as server:
            # unasked, for the log is a file as well and tells of each question that came too early
            eventually(lambda: assert_told(server, "ready"))
            assert answers(server) == everything[1]
            first, *lines = complaints(server)
        assert "kernels are compiled" in first
        # kernels, page, table
        assert len(lines) == 3
        assert all("File too large" in line for line in lines)


@pytest.mark.verify
def test_a_server_does_without_descriptors(everything, tmp_path):
    """None is left while it compiles, and some are later."""
    with starting(tmp_path, environment=at(tmp_path / "kept")) as server:
        pid = server.process.pid
        eventually(lambda: assert_told(server, "preparing the kernels"))
        _, most = resource.prlimit(pid, resource.RLIMIT_NOFILE)
        # those in use stay, whichever of them are of a moment
        resource.prlimit(pid, resource.RLIMIT_NOFILE, (0, most))
        eventually(lambda: assert_told(server, "Too many open files"))
        resource.prlimit(pid, resource.RLIMIT_NOFILE, (most, most))
        wait_until_ready(server.url, server.process, server.log)
        assert answers(server) == everything[1]
    with serving(tmp_path, environment=at(tmp_path / "kept")) as server:
        assert answers(server) == everything[1]
