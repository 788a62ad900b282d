"""Processes that serve: one, or several that a parent watches over."""

import asyncio
import contextlib
import multiprocessing
import os
import signal
import socket
import threading
import time
from multiprocessing.connection import wait
from multiprocessing.context import SpawnProcess
from pathlib import Path
from typing import Any

import uvicorn
from prometheus_client.multiprocess import mark_process_dead

from restitution.api.observing import LOGGER, set_up_log
from restitution.errors import RestitutionError

LONGEST_FAREWELL = 8
"""Seconds that requests in flight get when the service stops; supervisors wait for ten."""

BACKLOG = 2048
"""Connections that wait to be accepted, as uvicorn has it."""

SPAWN = multiprocessing.get_context("spawn")


class Server(uvicorn.Server):
    """A server that says so when it begins to stop."""

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Let what is computed be answered; what waits is told to ask again."""
        self.config.loaded_app.state.admission.end()
        await super().shutdown(sockets)
        if called_off := self.server_state.tasks:
            # they have that to answer
            await asyncio.wait(called_off, timeout=1)


def server(app: Any, farewell: int) -> Server:
    """Return an application, or what a name makes, on uvicorn.

    At its end, what is in flight gets `farewell` seconds.
    """
    # which a parent of workers does not need
    from restitution.api.connections import Connection  # noqa: PLC0415

    config = uvicorn.Config(
        app,
        factory=isinstance(app, str),
        http=Connection,
        # one protocol less that could be attacked: nobody speaks it here
        ws="none",
        log_config=None,
        access_log=False,
        # or the environment says how many, in words that uvicorn does not check
        workers=1,
        server_header=False,
        # nothing asks who the client is
        proxy_headers=False,
        timeout_graceful_shutdown=farewell,
    )
    # before signals are caught: who stops it now need not wait
    config.load()
    return Server(config)


def listeners(host: str, port: int) -> list[socket.socket]:
    """Return a listening socket for each address of `host`, at the same port.

    Raises
    ------
    RestitutionError
        If there is no such address, or somebody else has the port.
    """
    bound: list[socket.socket] = []
    try:
        found = socket.getaddrinfo(
            host or None, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )
        for family, kind, protocol, _, address in dict.fromkeys(found):
            each = socket.socket(family, kind, protocol)
            bound.append(each)
            each.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            if family == socket.AF_INET6:
                # the same port of the older kind has a socket of its own
                each.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
            # a port that was chosen is the same for all
            each.bind((address[0], port or bound[0].getsockname()[1], *address[2:]))
            # two that begin at the same moment may both bind; only one may listen
            each.listen(BACKLOG)
    except (OSError, UnicodeError) as error:
        for each in bound:
            each.close()
        # a name that cannot be one has another kind of error
        reason = getattr(error, "strerror", None) or "there is no such host"
        raise RestitutionError(f"cannot listen at {address_of(host, port)}: {reason}") from error
    return bound


def unix_listener(path: str) -> socket.socket:
    """Return a listening socket of this machine alone, which anybody here may speak to.

    Raises
    ------
    RestitutionError
        If it cannot be made, or somebody listens there.
    """
    found = socket.socket(socket.AF_UNIX)
    try:
        if Path(path).is_socket() and not _is_served(path):
            # left by a server that was killed
            Path(path).unlink()
        found.bind(path)
        Path(path).chmod(0o666)
        found.listen(BACKLOG)
    except (OSError, ValueError) as error:
        found.close()
        reason = getattr(error, "strerror", None) or error
        raise RestitutionError(f"cannot listen at {path}: {reason}") from error
    return found


def _is_served(path: str) -> bool:
    with socket.socket(socket.AF_UNIX) as asking:
        return asking.connect_ex(path) == 0


def address_of(host: str, port: int) -> str:
    """Return host and port as addresses have them."""
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


def serve_alone(sockets: list[socket.socket]) -> None:
    """Serve in this process until it is told to end."""
    with contextlib.suppress(KeyboardInterrupt):
        server("restitution.api.app:create_service", LONGEST_FAREWELL).run(sockets)


def serve_in_workers(sockets: list[socket.socket], count: int) -> None:
    """Serve in `count` processes until this one is told to end; one that is killed is replaced.

    uvicorn's supervisor kills those that take long to start, which on a busy machine all do, and
    sees only then that one has died.
    """
    set_up_log()
    told: list[int] = []
    woken, wake = socket.socketpair()
    wake.setblocking(False)
    signal.set_wakeup_fd(wake.fileno())
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda number, _: told.append(number))
    workers = [_worker(sockets) for _ in range(count)]
    try:
        while not told:
            wait([woken, *(worker.sentinel for worker in workers)])
            for place, worker in enumerate(workers):
                if not worker.is_alive() and not told:
                    _bury(worker)
                    workers[place] = _worker(sockets)
    finally:
        for each in sockets:
            each.close()
        for worker in workers:
            worker.terminate()
        for worker in workers:
            worker.join()


def _worker(sockets: list[socket.socket]) -> SpawnProcess:
    worker = SPAWN.Process(target=_work, args=(sockets,))
    # Ctrl-C, which a terminal sends to all of them, is for this process to pass on
    here = signal.signal(signal.SIGINT, signal.SIG_IGN)
    worker.start()
    signal.signal(signal.SIGINT, here)
    return worker


def _bury(worker: SpawnProcess) -> None:
    """Say that a worker has died, and forget what it was about."""
    assert worker.pid
    assert worker.exitcode is not None
    if "PROMETHEUS_MULTIPROC_DIR" in os.environ:
        mark_process_dead(worker.pid)  # type: ignore[no-untyped-call]
    if worker.exitcode > 0:
        # it failed by itself, and would again
        LOGGER.error("a worker failed, the service ends", pid=worker.pid, status=worker.exitcode)
        raise SystemExit(worker.exitcode)
    LOGGER.warning("a worker died, another begins", pid=worker.pid, signal=-worker.exitcode)


def _work(sockets: list[socket.socket]) -> None:
    threading.Thread(target=_end_with_parent, name="parent", daemon=True).start()
    serve_alone(sockets)


def _end_with_parent() -> None:
    """End this process when its parent is there no more, which could not tell it."""
    parent = multiprocessing.parent_process()
    assert parent
    parent.join()
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(LONGEST_FAREWELL + 2)
    os._exit(1)
