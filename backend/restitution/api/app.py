"""Assembly of the service."""

import threading
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import click
from fastapi import FastAPI
from starlette.middleware.cors import CORSMiddleware
from starlette.middleware.gzip import GZipMiddleware

from restitution.api import description, errors
from restitution.api.description import about
from restitution.api.page import add_page, compress_plotly
from restitution.api.reference_pages import add_reference_pages
from restitution.api.routes import collisions, scaling, service, table, tradeoff
from restitution.api.runs import Runs
from restitution.api.settings import Settings
from restitution.api.warm import warm, warm_rest


def create_app(settings: Settings | None = None) -> FastAPI:
    """Return the service; its kernels are made ready in the background once it runs.

    The table follows them: until it is there, the first time 20 s later, requests that use it wait.
    """
    settings = settings or Settings()
    app = FastAPI(
        **about(),
        lifespan=_lifespan,
        # FastAPI's own would load their scripts from elsewhere
        docs_url=None,
        redoc_url=None,
    )
    app.state.ready = threading.Event()
    app.state.runs = Runs() if settings.tradeoff_runs else None
    errors.install(app)
    app.add_middleware(
        CORSMiddleware,
        allow_origins=["*"],
        allow_methods=["GET", "POST"],
        allow_headers=["*"],
        expose_headers=["ETag", "Server-Timing", "Retry-After"],
    )
    # level 1: numbers in base64 shrink by a quarter at any level
    app.add_middleware(GZipMiddleware, minimum_size=1000, compresslevel=1)
    app.include_router(collisions.router)
    app.include_router(scaling.router)
    app.include_router(table.router)
    app.include_router(tradeoff.router)
    app.include_router(service.router)
    description.install(app)
    add_reference_pages(app)
    add_page(app, settings.frontend_directory)
    return app


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    def prepare() -> None:
        begin = time.perf_counter()
        warm()
        app.state.ready.set()
        click.echo(f"ready: the kernels took {time.perf_counter() - begin:.1f} s")
        compress_plotly()
        warm_rest()

    click.echo("preparing the kernels: compiled the first time (half a minute), then from a cache")
    threading.Thread(target=prepare, name="kernels", daemon=True).start()
    yield
