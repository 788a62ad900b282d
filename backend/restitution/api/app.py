"""Assembly of the service."""

import gc
import importlib
import itertools
import threading
import time
from collections.abc import AsyncIterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager

from fastapi import FastAPI

from restitution.api import document, problems
from restitution.api.admission import Admission
from restitution.api.guide import add_guide
from restitution.api.observing import LOGGER, observe, set_up_log
from restitution.api.one_file import add_one_file
from restitution.api.page import add_page, compress_page
from restitution.api.reference_pages import add_reference_pages
from restitution.api.routes import collisions, paper, scaling, service, table, tradeoff
from restitution.api.runs import Runs
from restitution.api.settings import Settings, settings_of_environment
from restitution.api.transport import BelowPath, Compression, HeadersAndHead, OpenDoors
from restitution.api.warm import warm, warm_rest

ROOMS = (collisions, scaling, table, tradeoff, paper, service)

MOST_NEW_OBJECTS = 10_000
"""Before Python looks for cycles among them. At its own 700 it looks through all requests that wait
for their turn again and again, a quarter of the CPU of a collision among 32 clients."""

FIRST_PAUSE, LONGEST_PAUSE = 5, 30
"""Seconds from a failure to prepare to the next try: twice as long each time, up to the second."""


def create_app(settings: Settings | None = None) -> FastAPI:
    """Return the service; its kernels are made ready in the background once it runs.

    The table follows them: until it is there, the first time after a minute, what uses it waits.
    """
    settings = settings or settings_of_environment()
    app = FastAPI(
        **document.about(),
        lifespan=_lifespan,
        # FastAPI's own would load their scripts from elsewhere
        docs_url=None,
        redoc_url=None,
        # an address with a slash too many is none: sent on, a client would go to whatever Host says
        redirect_slashes=False,
    )
    # the kernels of the first view; all kernels and the table
    app.state.ready, app.state.warm = threading.Event(), threading.Event()
    app.state.runs = Runs() if settings.tradeoff_runs else None
    app.state.admission = Admission(settings.most_quick, settings.most_long, settings.most_waiting)
    app.state.frontend_directory = settings.frontend_directory
    problems.install(app)
    # the last one added is the first to see a request
    app.add_middleware(Compression)
    app.add_middleware(OpenDoors)
    app.add_middleware(HeadersAndHead)
    for room in ROOMS:
        # as they are: of a router that is included FastAPI asks for the route twice
        app.router.routes += room.calls.routes
    app.include_router(service.health)
    observe(app, log_requests=settings.log_requests)
    app.add_middleware(BelowPath, settings.root_path, settings.forwarded_allow_ips)
    document.install(app, [body for room in ROOMS for body in room.calls.bodies])
    add_reference_pages(app)
    add_guide(app)
    add_page(app, settings.frontend_directory)
    add_one_file(app, settings.frontend_directory)
    return app


def create_service() -> FastAPI:
    """Return the service of a process of its own, which logs and seldom looks for garbage."""
    set_up_log()
    # numba with them, before anybody connects: an import that fails half-way, as for lack of
    # descriptors, fails ever after in this process
    importlib.import_module("restitution.mechanics.kernels")
    gc.set_threshold(MOST_NEW_OBJECTS)
    return create_app()


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    def prepare() -> None:
        for attempt in itertools.count():
            try:
                prepare_all()
            except Exception:  # noqa: BLE001 - whatever it is, it may pass
                # at the end of the process no pool of threads takes anything more
                if not _a_pool_works():
                    return
                pause = min(FIRST_PAUSE * 2**attempt, LONGEST_PAUSE)
                LOGGER.exception("not all could be prepared: tried again", in_seconds=pause)
                time.sleep(pause)
            else:
                return

    def prepare_all() -> None:
        begin = time.perf_counter()
        warm()
        app.state.ready.set()
        LOGGER.info("ready", kernels_took_seconds=round(time.perf_counter() - begin, 1))
        compress_page(app.state.frontend_directory)
        warm_rest()
        app.state.warm.set()
        LOGGER.info("all is prepared", took_seconds=round(time.perf_counter() - begin, 1))

    LOGGER.info("preparing the kernels")
    threading.Thread(target=prepare, name="kernels", daemon=True).start()
    yield


def _a_pool_works() -> bool:
    with ThreadPoolExecutor(1) as pool:
        try:
            pool.submit(int)
        except RuntimeError:
            return False
    return True
