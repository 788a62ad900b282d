"""Reference collisions, seeds of property tests, and a real server, shared by all tests."""

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from starlette.testclient import TestClient

from restitution.api.app import create_app
from restitution.api.warm import warm, warm_rest
from restitution.studies.accuracy import steps
from servers import serving
from service import Service
from waiting import eventually

VALIDATION = Path(__file__).parent / "validation"

# one fixed sequence of examples: a failure on one machine is a failure on every machine
settings.register_profile(
    "seeded",
    derandomize=True,
    deadline=None,
    max_examples=100,
    # a clock of its own
    suppress_health_check=[HealthCheck.too_slow],
)
# of `make verify`
settings.register_profile("many", settings.get_profile("seeded"), max_examples=1000)
settings.load_profile("seeded")


def pytest_sessionstart(session: pytest.Session) -> None:
    """Compile the kernels and build the table once, before each of several workers would."""
    several = getattr(session.config.option, "numprocesses", None)
    if several and not hasattr(session.config, "workerinput"):
        warm()
        warm_rest()


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


@pytest.fixture
def few_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """The lowest rungs of the ladder of time steps, where it matters alone that there is one."""
    monkeypatch.setattr(steps, "LADDER", steps.LADDER[:4])
    monkeypatch.setattr(steps, "MOST_STEPS", 100)


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The base URL of a `restitution serve` process."""
    with serving(tmp_path_factory.mktemp("server")) as running:
        yield running.url


@pytest.fixture(scope="session")
def service() -> Iterator[Service]:
    """The service in this process, ready."""
    with TestClient(create_app()) as client:

        def is_warm() -> None:
            # before that nothing is computed on the event loop
            assert client.app.state.warm.is_set(), "the kernels or the table are not ready"

        eventually(is_warm)
        yield Service(client)
