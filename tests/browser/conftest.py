"""A real server and a real browser for the tests of this folder."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from set_up_browser import ARGUMENTS, chromium_of_machine

if TYPE_CHECKING:
    from collections.abc import Iterator

# A first start compiles the kernels.
START_SECONDS = 60


@pytest.fixture(scope="session")
def browser_type_launch_args(browser_type_launch_args: dict[str, Any]) -> dict[str, Any]:
    chosen = {**browser_type_launch_args, "args": ARGUMENTS}
    path = chromium_of_machine()
    # Without a path Playwright takes the one it has downloaded itself.
    return {**chosen, "executable_path": path} if path else chosen


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The base URL of a `restitution serve` process."""
    log_path = tmp_path_factory.mktemp("server") / "log"
    port = free_port()
    program = Path(sys.executable).with_name("restitution")
    with (
        log_path.open("wb") as log,
        subprocess.Popen(
            [program, "serve", "--host", "127.0.0.1", "--port", str(port)],
            stdout=log,
            stderr=subprocess.STDOUT,
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


@pytest.fixture(scope="session")
def base_url(server: str) -> str:
    """What `page.goto` adds its path to; the plugin's own fixture is one that pytest 9 warns of."""
    return server


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
