"""Kernels and page that are damaged, not to be trusted or cannot be kept: told in one line."""

import hashlib
import itertools
import os
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from structlog.testing import capture_logs

from cases import every_day, left_to_verify
from damages import DAMAGES, damage, files
from restitution.api import app, page
from restitution.api.settings import Settings
from restitution.mechanics.cache import LONGEST_WRITING
from restitution.mechanics.compiled import MODEL_VERSION
from waiting import eventually

NOWHERE = {"NUMBA_CACHE_DIR": "", "XDG_CACHE_HOME": "", "HOME": "/dev/null"}
"""No place for a cache but those that a test names, and the folder for temporary files."""


def times(folder: Path) -> dict[Path, int]:
    return {file: file.stat().st_mtime_ns for file in files(folder)}


# Of which neither calls another.
TWO_KERNELS = """
from restitution.mechanics.elastic import stiff_bound
from restitution.mechanics.scaled_velocity import psi_of

print(psi_of(1.4, 0.4), stiff_bound(18.0, 0.5))
"""


def ask(*prefix: str, **places: Path) -> tuple[str, list[str]]:
    """Return what the kernels answer in a process of its own, and what it tells of their state."""
    done = subprocess.run(
        [*prefix, sys.executable, "-c", TWO_KERNELS],
        env=os.environ | NOWHERE | {name: str(place) for name, place in places.items()},
        check=True,
        capture_output=True,
        text=True,
    )
    lines = done.stderr.splitlines()
    return done.stdout, [line for line in lines if not line.startswith("kernels are compiled")]


@pytest.fixture(scope="module")
def healthy(tmp_path_factory):
    """A folder with both kernels, and what they answer."""
    folder = tmp_path_factory.mktemp("healthy")
    answer, lines = ask(NUMBA_CACHE_DIR=folder)
    assert not lines
    assert [len(files(folder, suffix)) for suffix in (".nbi", ".nbc")] == [2, 2]
    return folder, answer


@pytest.fixture
def kept(healthy, tmp_path):
    """The same, for one test to spoil."""
    return shutil.copytree(healthy[0], tmp_path / "kept"), healthy[1]


def assert_healed(folder: Path, answer: str) -> None:
    """Assert that the next process says nothing and compiles nothing."""
    before = times(folder)
    assert ask(NUMBA_CACHE_DIR=folder) == (answer, [])
    assert times(folder) == before


@pytest.mark.parametrize(
    ("suffix", "how"),
    every_day([(".nbc", "random")], of=itertools.product([".nbi", ".nbc"], DAMAGES)),
)
def test_damaged_kernels_are_compiled_anew(kept, suffix, how):
    folder, answer = kept
    for file in files(folder, suffix):
        damage(file, how)
    found, lines = ask(NUMBA_CACHE_DIR=folder)
    assert found == answer
    (line,) = lines
    assert f"{suffix} is damaged: made anew" in line
    assert_healed(folder, answer)


@pytest.mark.verify
def test_code_of_another_kernel_is_not_run(kept):
    """As where two processes gave one name to two, or one was killed before it wrote its own."""
    folder, answer = kept
    first, second = files(folder, ".nbc")
    contents = first.read_bytes(), second.read_bytes()
    second.write_bytes(contents[0])
    first.write_bytes(contents[1])
    found, lines = ask(NUMBA_CACHE_DIR=folder)
    assert found == answer
    (line,) = lines
    assert "names the code of another kernel: made anew" in line
    assert_healed(folder, answer)


@pytest.mark.verify
def test_what_a_killed_writer_left_is_no_hindrance_and_goes(kept):
    folder, answer = kept
    code = files(folder, ".nbc")[0]
    left, in_work = (code.with_name(f"{code.name}.{name}") for name in ("killed", "writing"))
    for partial in (left, in_work):
        partial.write_bytes(code.read_bytes()[:100])
    long_ago = left.stat().st_mtime - 2 * LONGEST_WRITING
    os.utime(left, (long_ago, long_ago))
    # its index was written before
    code.unlink()
    assert ask(NUMBA_CACHE_DIR=folder) == (answer, [])
    assert (code.exists(), in_work.exists(), left.exists()) == (True, True, False)
    assert_healed(folder, answer)


@pytest.mark.verify
def test_processes_that_write_at_the_same_time_do_not_hinder_one_another(healthy, tmp_path):
    environment = os.environ | NOWHERE | {"NUMBA_CACHE_DIR": str(tmp_path)}
    together = [
        subprocess.Popen(
            [sys.executable, "-c", TWO_KERNELS],
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for _ in range(6)
    ]
    found, told = zip(*(process.communicate() for process in together), strict=True)
    assert set(found) == {healthy[1]}
    # some are first
    assert {line.partition(":")[0] for lines in told for line in lines.splitlines()} == {
        "kernels are compiled for this processor"
    }
    assert_healed(tmp_path, healthy[1])


@pytest.mark.verify
def test_kernels_are_done_without_a_place_for_them(healthy):
    # no temporary files either
    found, lines = ask("prlimit", "--fsize=0")
    assert found == healthy[1]
    (line,) = lines
    assert line.startswith("nothing is kept, each start compiles for a minute: ")


@pytest.mark.verify
def test_kernels_are_done_without_room_for_them(healthy, tmp_path):
    found, lines = ask("prlimit", "--fsize=1000", NUMBA_CACHE_DIR=tmp_path)
    assert found == healthy[1]
    (line,) = lines
    assert line.startswith("nothing can be kept in ")
    assert "File too large" in line
    assert not files(tmp_path, ".nbc")


class Bomb:
    """An object that makes a folder when it is unpickled."""

    def __init__(self, crater: Path) -> None:
        self._crater = crater

    def __reduce__(self):
        return os.mkdir, (str(self._crater),)


def fill_with_bombs(folder: Path, crater: Path) -> None:
    """Replace kernels by what `cache.read` takes for whole."""
    content = pickle.dumps(Bomb(crater))
    for file in files(folder, ".nb?"):
        file.write_bytes(content + hashlib.sha256(content).digest())


def give_away(path: Path) -> None:
    os.chown(path, STRANGER, STRANGER)


def replace_by_link(folder: Path) -> None:
    folder.rename(folder.with_name("elsewhere"))
    folder.symlink_to(folder.with_name("elsewhere"))


STRANGER = 12345
only_root = pytest.mark.skipif(os.geteuid() != 0, reason="only root can give files away")


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda folder: folder.chmod(0o777), "others may write to it (mode 0777)"),
        left_to_verify((lambda folder: folder.chmod(0o770), "others may write to it (mode 0770)")),
        left_to_verify((replace_by_link, "it is a link")),
        pytest.param(give_away, "it belongs to user 12345", marks=[only_root, pytest.mark.verify]),
    ],
)
def test_a_folder_that_others_could_write_is_not_used(healthy, tmp_path, change, reason):
    """That for temporary files, the last of the places where it may be."""
    assert ask(TMPDIR=tmp_path) == (healthy[1], [])
    folder = tmp_path / f"restitution-{os.geteuid()}" / MODEL_VERSION
    assert folder.stat().st_mode & 0o777 == 0o700
    fill_with_bombs(folder, tmp_path / "crater")
    change(folder)
    before = times(tmp_path)
    found, lines = ask(TMPDIR=tmp_path)
    assert found == healthy[1]
    (line,) = lines
    assert line.startswith(f"nothing is kept, each start compiles for a minute: {folder}: {reason}")
    assert times(tmp_path) == before
    assert not (tmp_path / "crater").exists()


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda file: file.chmod(0o666), "others may write to it (mode 0666)"),
        pytest.param(give_away, "it belongs to user 12345", marks=[only_root, pytest.mark.verify]),
    ],
)
def test_a_file_that_others_could_write_is_not_run(kept, tmp_path, change, reason):
    folder, answer = kept
    fill_with_bombs(folder, tmp_path / "crater")
    for file in files(folder):
        change(file)
    found, lines = ask(NUMBA_CACHE_DIR=folder)
    assert found == answer
    (line,) = lines
    assert f"is not trusted, {reason}: made anew" in line
    assert not (tmp_path / "crater").exists()
    assert_healed(folder, answer)


@pytest.mark.verify
def test_another_folder_is_taken_for_one_that_others_could_write(kept, tmp_path):
    folder, answer = kept
    wanted = folder / "restitution" / MODEL_VERSION
    wanted.chmod(0o777)
    found, lines = ask(NUMBA_CACHE_DIR=folder, XDG_CACHE_HOME=tmp_path / "other")
    assert found == answer
    other = tmp_path / "other" / "restitution" / MODEL_VERSION
    reason = "others may write to it (mode 0777)"
    assert lines == [f"the cache is in {other}, not in {wanted}: {reason}"]
    assert len(files(other)) == len(files(wanted))


def test_a_damaged_page_is_compressed_anew(tmp_path, monkeypatch):
    frontend = tmp_path / "frontend"
    frontend.mkdir()
    texts = {f"{name}.js": f"// {name}\n" * 100 for name in DAMAGES}
    for name, text in texts.items():
        (frontend / name).write_text(text)
    monkeypatch.setattr(page, "CACHE_FOLDER", str(tmp_path / "cache"))
    monkeypatch.setattr(page, "PLOTLY", frontend / "one bit.js")
    monkeypatch.setattr(page, "_compressed", {})
    page.compress_page(frontend)
    whole = {file: file.read_bytes() for file in files(tmp_path / "cache")}
    assert len(whole) == len(texts)
    for file, how in zip(whole, DAMAGES, strict=True):
        damage(file, how)
    page._compressed.clear()
    page.compress_page(frontend)
    assert {file: file.read_bytes() for file in files(tmp_path / "cache")} == whole
    with TestClient(app.create_app(Settings(frontend_directory=frontend))) as client:
        for name, text in texts.items():
            answer = client.get(f"/static/{name}", headers={"Accept-Encoding": "br"})
            assert (answer.headers["content-encoding"], answer.text) == ("br", text)


def test_what_could_not_be_prepared_is_tried_again(tmp_path, monkeypatch):
    monkeypatch.setattr(app, "FIRST_PAUSE", 0.01)
    (tmp_path / "gone.js").symlink_to(tmp_path / "nothing")
    service = app.create_app(Settings(frontend_directory=tmp_path))
    with capture_logs() as log, TestClient(service):

        def is_told():
            assert [e for e in log if e["event"].startswith("not all could be prepared")]

        def is_warm():
            assert service.state.warm.is_set()

        eventually(is_told)
        (tmp_path / "nothing").write_text("// there")
        eventually(is_warm)
