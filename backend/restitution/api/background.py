"""The service within a process that does something else, as a notebook does."""

import atexit
import functools
import logging
import socket
import threading

import structlog

from restitution.api.app import create_app
from restitution.api.serving import server

FAREWELL = 1
"""Seconds that requests in flight get when the process ends."""


@functools.cache
def serve_in_background() -> str:
    """Return the address of the service in this process, at a free port for this machine alone.

    It is started by the first call and ends with the process.

    Raises
    ------
    SettingsError
        If a setting is wrong.
    """
    service = create_app()
    if not structlog.is_configured():
        # the service would tell its events between the answers of a notebook
        quiet = structlog.make_filtering_bound_logger(logging.WARNING)
        structlog.configure(wrapper_class=quiet)
    # it listens at once: who comes before the service waits
    listener = socket.create_server(("127.0.0.1", 0))
    running = server(service, FAREWELL)
    thread = threading.Thread(
        target=running.run, args=([listener],), name="restitution service", daemon=True
    )
    thread.start()

    @atexit.register
    def stop() -> None:
        running.should_exit = True
        thread.join(2 * FAREWELL)

    return f"http://127.0.0.1:{listener.getsockname()[1]}"
