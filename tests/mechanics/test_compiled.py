"""Kernels are kept between runs, and taken from folders that can only be read."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from restitution.mechanics.compiled import MODEL_VERSION

RUN = """
import sys
import tempfile
from pathlib import Path

make = tempfile.TemporaryFile

def refuse(*arguments, dir, **options):
    # as a read-only file system does, also to root
    if Path(dir).is_relative_to(sys.argv[1]):
        raise PermissionError(dir)
    return make(*arguments, dir=dir, **options)

tempfile.TemporaryFile = refuse

from restitution.mechanics.compiled import CACHE_FOLDER
from restitution.mechanics.hertz import normal_motion

normal_motion(0.5)
print(CACHE_FOLDER)
"""


def run(
    first: Path, second: Path, read_only: Path, processor: str = "generic", told: str = "kernels"
) -> Path:
    """Use a kernel with a cache in `first`, or in `second` if that one is read-only.

    `told` is how the only line begins that it says; "" if it says nothing.
    """
    environment = {
        **os.environ,
        "NUMBA_CACHE_DIR": str(first),
        "XDG_CACHE_HOME": str(second),
        "NUMBA_CPU_NAME": processor,
        "NUMBA_CPU_FEATURES": "",
    }
    done = subprocess.run(
        [sys.executable, "-c", RUN, read_only],
        env=environment,
        check=True,
        capture_output=True,
        text=True,
    )
    folder = done.stdout.strip()
    if told:
        (line,) = done.stderr.splitlines()
        assert line.startswith("kernels are compiled for this processor: about 10 s")
        assert line.endswith(folder)
    else:
        assert not done.stderr
    return Path(folder)


def files(folder: Path) -> dict[str, bytes]:
    """Return the files below `folder` that are no links."""
    return {
        f.name: f.read_bytes() for f in folder.rglob("*.nb?") if f.is_file() and not f.is_symlink()
    }


# that the next run compiles nothing is seen every day in tests/hostile/test_broken_state.py
@pytest.mark.verify
def test_kernels_are_kept_for_the_next_run(tmp_path):
    folder = run(tmp_path / "a", tmp_path / "b", tmp_path / "none")
    assert folder == tmp_path / "a" / "restitution" / MODEL_VERSION
    kept = files(folder)
    assert kept
    assert run(tmp_path / "a", tmp_path / "b", tmp_path / "none", told="") == folder
    assert files(folder) == kept


@pytest.mark.verify
def test_kernels_in_a_read_only_folder_are_used_from_another(tmp_path):
    kept = files(run(tmp_path / "a", tmp_path / "b", tmp_path / "none"))
    for _ in range(2):
        folder = run(tmp_path / "a", tmp_path / "b", tmp_path / "a", told="")
        assert folder == tmp_path / "b" / "restitution" / MODEL_VERSION
        assert {f.name for f in folder.rglob("*.nb?")} == set(kept)
        assert not files(folder)


@pytest.mark.verify
def test_kernels_missing_in_a_read_only_folder_are_compiled_into_the_other(tmp_path):
    original = run(tmp_path / "a", tmp_path / "b", tmp_path / "none")
    kept = files(original)
    folder = run(tmp_path / "a", tmp_path / "b", tmp_path / "a", "x86-64")
    assert files(folder)
    assert files(original) == kept


ANSWERS = """
import hashlib

import numpy as np

from restitution.mechanics.collision import collide
from restitution.mechanics.compiled import CACHE_FOLDER
from restitution.mechanics.contact import contact_of
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.trace import study_trace

rng = np.random.default_rng(2008)
kappa, psi = np.exp(rng.uniform(np.log([0.02, 1e-4]), np.log([1e4, 4]), (3000, 2))).T.copy()
found = [contact_of(0.1).pieces]
for damping in (0.0, 1e-6, 0.1, 3.0):
    found.append(collide(kappa, psi, damping).epsilon_t)
    found += study_trace(CollisionParameters(63.0, 1.4, 1.358, damping)).columns.values()
print(hashlib.sha256(b"".join(np.ascontiguousarray(each).tobytes() for each in found)).hexdigest())
"""


@pytest.mark.verify
def test_a_process_that_compiles_answers_as_one_that_loads_and_as_any_processor(tmp_path):
    any_processor = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
    answers = {
        subprocess.run(
            [sys.executable, "-c", ANSWERS],
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path), **more},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        for more in ({}, {}, any_processor)
    }
    assert len(answers) == 1


TOGETHER = """
from concurrent.futures import ThreadPoolExecutor

import restitution

with ThreadPoolExecutor(8) as pool:
    print(*pool.map(lambda _: float(restitution.epsilon_t(18.0, 1.4, 5.6)), range(8)))
"""


@pytest.mark.verify
def test_threads_that_are_the_first_to_ask_at_the_same_time_are_all_answered(tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", TOGETHER],
        env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
        check=True,
        capture_output=True,
        text=True,
    )
    assert done.stdout.split() == ["0.5"] * 8
