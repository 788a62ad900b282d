"""Real `restitution serve` processes for tests and benchmarks."""

import json
import os
import re
import socket
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Callable
from contextlib import contextmanager, suppress
from pathlib import Path

import psutil

from waiting import LIMIT_SECONDS, eventually

LONG = (
    "/api/v1/map?mu_over_alpha=1&kappa_min=1.1e6&kappa_max=2e6&kappa_count=80"
    "&gt_over_gn_count=200&quantities=switches"
)
"""A second or so of both cores: too stiff for lanes."""


class Serving:
    """A `restitution serve` process and what it writes."""

    def __init__(self, process, port, log):
        self.process, self.port, self.log = process, port, log
        self.url = f"http://127.0.0.1:{port}"

    def get(self, path, **headers):
        """Return status, headers and body, refusals too."""
        request = urllib.request.Request(self.url + path, headers=headers)
        try:
            with urllib.request.urlopen(request, timeout=LIMIT_SECONDS) as answer:
                return answer.status, answer.headers, answer.read()
        except urllib.error.HTTPError as refusal:
            return refusal.code, refusal.headers, refusal.read()

    def send(self, text):
        """Return a connection over which `text` was sent."""
        connection = socket.create_connection(("127.0.0.1", self.port), timeout=LIMIT_SECONDS)
        connection.sendall(text.encode())
        return connection

    def metric(self, pattern):
        text = self.get("/metrics")[2].decode()
        return sum(float(n) for n in re.findall(rf"^{pattern} ([\d.e+]+)$", text, re.MULTILINE))

    def events(self):
        lines = self.log.read_text().splitlines()
        return [json.loads(line) for line in lines if line.startswith("{")]

    def is_prepared(self):
        """Fail unless nothing is prepared any more: what it takes is what requests take."""
        assert any(event["event"] == "all is prepared" for event in self.events())

    def children(self):
        tasks = Path(f"/proc/{self.process.pid}/task")
        names = [c for t in tasks.iterdir() for c in (t / "children").read_text().split()]
        # the resource tracker of multiprocessing is one, too
        return [int(n) for n in names if b"spawn_main" in Path(f"/proc/{n}/cmdline").read_bytes()]


@contextmanager
def serving(folder, prefix=(), environment=None, limits=None, **settings):
    """Yield a server that is ready.

    `prefix` is a command that runs another, as `prlimit` does; `limits` of `api.connections` are
    others where no test could wait for them.
    """
    with starting(folder, prefix, environment, limits, **settings) as server:
        wait_until_ready(server.url, server.process, server.log)
        yield server


@contextmanager
def starting(folder, prefix=(), environment=None, limits=None, **settings):
    """Yield a server as soon as its process runs."""
    port, log = free_port(), folder / "log"
    settings = {f"RESTITUTION_{n.upper()}": str(v) for n, v in settings.items()}
    with (
        log.open("wb") as output,
        subprocess.Popen(
            [*prefix, *program(limits or {}), "serve", "--port", str(port)],
            stdout=output,
            stderr=subprocess.STDOUT,
            env=os.environ | settings | (environment or {}),
        ) as process,
    ):
        try:
            yield Serving(process, port, log)
        finally:
            kill_with_children(process)


def program(limits):
    if not limits:
        return [Path(sys.executable).with_name("restitution")]
    lines = ["from restitution.api import connections, serving", "from restitution.cli import main"]
    lines += [f"assert {n}; {n} = {v}" for n, v in limits.items()]
    return [sys.executable, "-c", "\n".join([*lines, "main()"])]


def kill_with_children(process: subprocess.Popen[bytes]) -> None:
    """Kill a process and those that it started, which would go on without it."""
    family = []
    if process.poll() is None:
        parent = psutil.Process(process.pid)
        family = [parent, *parent.children(recursive=True)]
    for member in family:
        # one may have ended by itself meanwhile
        with suppress(psutil.NoSuchProcess):
            member.kill()


def free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return int(listener.getsockname()[1])


def wait_until_ready(url: str, process: subprocess.Popen[bytes], log_path: Path) -> None:
    def is_ready() -> bool:
        try:
            urllib.request.urlopen(f"{url}/readyz", timeout=LIMIT_SECONDS).close()
        except (urllib.error.URLError, ConnectionError, TimeoutError):
            return False
        return True

    wait_until(is_ready, process, log_path)


def is_open(port: int) -> bool:
    """Return whether anything listens there."""
    try:
        socket.create_connection(("127.0.0.1", port), timeout=LIMIT_SECONDS).close()
    except OSError:
        return False
    return True


def wait_until(holds: Callable[[], bool], process: subprocess.Popen[bytes], log_path: Path) -> None:
    """Wait for what a process shall do first, as long as it runs."""

    def held_or_ended() -> bool:
        ended = process.poll() is not None
        assert ended or holds(), log_path.read_text(errors="replace")
        return not ended

    assert eventually(held_or_ended), log_path.read_text(errors="replace")
