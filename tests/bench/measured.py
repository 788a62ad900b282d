"""A server under measurement, and kept connections to it."""

import asyncio
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from servers import free_port, wait_until_ready

TICK = os.sysconf("SC_CLK_TCK")


class Connection(asyncio.Protocol):
    """A kept connection, one request at a time."""

    def __init__(self) -> None:
        self._buffer = bytearray()
        self._needed = -1
        self._done: asyncio.Future[int] | None = None
        self.headers = b""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        self.transport = transport

    def data_received(self, data: bytes) -> None:
        self._buffer += data
        if self._needed < 0:
            end = self._buffer.find(b"\r\n\r\n")
            if end < 0:
                return
            self.headers = bytes(self._buffer[:end]).lower()
            found = re.search(rb"content-length: (\d+)", self.headers)
            self._needed = end + 4 + (int(found[1]) if found else 0)
        if len(self._buffer) >= self._needed and self._done and not self._done.done():
            self._done.set_result(int(self.headers[9:12]))

    def connection_lost(self, error: Exception | None) -> None:
        if self._done and not self._done.done():
            self._done.set_exception(error or ConnectionError("closed"))

    async def get(self, path: str, headers: str = "") -> int:
        return await self._answer(f"GET {path} HTTP/1.1\r\nHost: x\r\n{headers}\r\n".encode())

    async def post(self, path: str, body: bytes) -> int:
        head = f"POST {path} HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
        return await self._answer(f"{head}Content-Length: {len(body)}\r\n\r\n".encode() + body)

    async def _answer(self, request: bytes) -> int:
        self._buffer.clear()
        self._needed = -1
        self._done = asyncio.get_running_loop().create_future()
        self.transport.write(request)
        return await asyncio.wait_for(self._done, 30.0)


async def connect(port: int, kept: Connection | None = None) -> Connection:
    """Return the connection that was kept, or a new one where the server closes that.

    nginx does so after a thousand requests, and whoever serves when nothing is asked for a while.
    """
    if kept and not kept.transport.is_closing() and b"connection: close" not in kept.headers:
        return kept
    loop = asyncio.get_running_loop()
    return (await loop.create_connection(Connection, "127.0.0.1", port))[1]


def processes(root: int) -> list[int]:
    """Return a process and its descendants."""
    found = [root]
    for task in Path(f"/proc/{root}/task").iterdir():
        for child in (task / "children").read_text().split():
            found += processes(int(child))
    return found


def cpu(root: int) -> float:
    """Return the CPU seconds of a process and its descendants."""
    fields = [
        Path(f"/proc/{n}/stat").read_text().rpartition(")")[2].split() for n in processes(root)
    ]
    return sum(int(f[11]) + int(f[12]) for f in fields) / TICK


def resident(root: int) -> list[float]:
    """Return the resident MB of the processes that serve."""
    texts = [Path(f"/proc/{n}/status").read_text() for n in processes(root)]
    sizes = [int(re.search(r"VmRSS:\s+(\d+)", text)[1]) / 1024 for text in texts]
    return [round(size, 1) for size in sizes if size > 60]


@contextmanager
def service(factory: str = "stored:create", workers: int = 1) -> Iterator[tuple[int, int]]:
    """Yield port and process id of a server that is warm."""
    port = free_port()
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder, "log")
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
        if workers > 1:
            environment["PROMETHEUS_MULTIPROC_DIR"] = folder
        command = [sys.executable, "-m", "uvicorn", "--factory", factory, "--port", str(port)]
        command += ["--workers", str(workers), "--no-access-log", "--log-level", "warning"]
        with (
            log.open("wb") as output,
            subprocess.Popen(command, stdout=output, stderr=output, env=environment) as process,
        ):
            try:
                wait_until_ready(f"http://127.0.0.1:{port}", process, log)
                # the table is loaded, too
                time.sleep(4)
                yield port, process.pid
            finally:
                process.send_signal(signal.SIGTERM)
                process.wait()
