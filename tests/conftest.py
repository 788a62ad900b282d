"""Reference collisions, seeds of property tests, and a real server, shared by all tests."""

import csv
import os
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import settings

START_SECONDS = 60
"""A first start compiles the kernels."""

VALIDATION = Path(__file__).parent / "validation"

# one fixed sequence of examples: a failure on one machine is a failure on every machine
settings.register_profile("seeded", derandomize=True, deadline=None, max_examples=300)
settings.load_profile("seeded")


class Reference(NamedTuple):
    """Columns of the reference collisions; shape (N,)."""

    kappa: np.ndarray
    psi: np.ndarray
    epsilon_t: np.ndarray
    switches: np.ndarray
    nearest_grazing: np.ndarray
    first_switch_time: np.ndarray


class Damped(NamedTuple):
    """One of the damped reference collisions."""

    kappa: float
    psi: float
    damping: float
    epsilon_t: float
    epsilon_n: float
    contact_duration: float
    switches: int


def read(name: str) -> list[dict[str, str]]:
    with (VALIDATION / name).open() as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="session")
def reference() -> Reference:
    rows = read("collisions.csv") + read("collisions_more.csv")
    columns = {
        name: np.array([float(row[name] or "nan") for row in rows]) for name in Reference._fields
    }
    return Reference(**columns)


@pytest.fixture(scope="session")
def damped_reference() -> list[Damped]:
    rows = read("damped.csv")
    return [
        Damped(*(float(row[n]) for n in Damped._fields[:-1]), int(row["switches"])) for row in rows
    ]


@pytest.fixture(scope="session")
def reference_reversals() -> np.ndarray:
    names = ("kappa", "psi", "reversals")
    return np.array([[float(row[n]) for n in names] for row in read("collisions_more.csv")])


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The base URL of a `restitution serve` process."""
    with serving(tmp_path_factory.mktemp("server") / "log") as url:
        yield url


@pytest.fixture(scope="session")
def serve() -> Callable[..., AbstractContextManager[str]]:
    """For a server of a test's own."""
    return serving


@contextmanager
def serving(log_path: Path, **settings: str) -> Iterator[str]:
    """Yield the base URL of a `restitution serve` process with `settings` in its environment."""
    port = free_port()
    program = Path(sys.executable).with_name("restitution")
    with (
        log_path.open("wb") as log,
        subprocess.Popen(
            [program, "serve", "--host", "127.0.0.1", "--port", str(port)],
            stdout=log,
            stderr=subprocess.STDOUT,
            env=os.environ | settings,
        ) as process,
    ):
        try:
            wait_until_ready(f"http://127.0.0.1:{port}", process, log_path)
            yield f"http://127.0.0.1:{port}"
        finally:
            process.terminate()
            try:
                process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()


def free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return int(listener.getsockname()[1])


def wait_until_ready(url: str, process: subprocess.Popen[bytes], log_path: Path) -> None:
    deadline = time.monotonic() + START_SECONDS
    while time.monotonic() < deadline and process.poll() is None:
        try:
            urllib.request.urlopen(f"{url}/readyz", timeout=5).close()
        except (urllib.error.URLError, ConnectionError, TimeoutError):
            time.sleep(0.1)
        else:
            return
    pytest.fail(f"the server did not become ready:\n{log_path.read_text(errors='replace')}")
