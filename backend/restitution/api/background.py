"""The service within a process that does something else, as a notebook does."""

import atexit
import functools
import logging
import socket
import threading

import structlog
import uvicorn

from restitution.api.app import create_app
from restitution.api.settings import Settings
from restitution.errors import RestitutionError

FAREWELL = 1
"""Seconds that requests in flight get when the process ends."""


@functools.cache
def serve_in_background() -> str:
    """Return the address of the service in this process, at a free port for this machine alone.

    It is started by the first call and ends with the process.

    Raises
    ------
    RestitutionError
        If the page is not there, as in an installation without a checkout.
    """
    folder = Settings().frontend_directory
    if not (folder / "index.html").exists():
        raise RestitutionError(
            f"there is no page in {folder}: set RESTITUTION_FRONTEND_DIRECTORY to the folder "
            "frontend of a checkout, or name a server that runs"
        )
    if not structlog.is_configured():
        # the service would tell its events between the answers of a notebook
        quiet = structlog.make_filtering_bound_logger(logging.WARNING)
        structlog.configure(wrapper_class=quiet)
    # it listens at once: who comes before the service waits
    listener = socket.create_server(("127.0.0.1", 0))
    server = uvicorn.Server(
        uvicorn.Config(
            create_app(),
            http="restitution.api.connections:Connection",
            # one protocol less that could be attacked: nobody speaks it here
            ws="none",
            # nothing asks who the client is
            proxy_headers=False,
            log_config=None,
            access_log=False,
            timeout_graceful_shutdown=FAREWELL,
        )
    )
    thread = threading.Thread(
        target=server.run, args=([listener],), name="restitution service", daemon=True
    )
    thread.start()

    @atexit.register
    def stop() -> None:
        server.should_exit = True
        thread.join(2 * FAREWELL)

    return f"http://127.0.0.1:{listener.getsockname()[1]}"
