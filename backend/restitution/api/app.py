"""Assembly of the service."""

import threading
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from importlib.metadata import version
from importlib.resources import files

import click
from fastapi import FastAPI
from fastapi.responses import FileResponse
from starlette.middleware.cors import CORSMiddleware
from starlette.staticfiles import StaticFiles

from restitution.api import errors
from restitution.api.routes import collisions, service
from restitution.api.settings import Settings
from restitution.api.warm import warm

PLOTLY = "/assets/plotly.min.js"

PAGE_HEADERS = {
    # Plotly sets styles from its script; nothing else is inline, nothing comes from elsewhere.
    "Content-Security-Policy": (
        "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        "object-src 'none'; base-uri 'none'; form-action 'none'"
    ),
    "Cache-Control": "no-cache",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
}


def create_app(settings: Settings | None = None) -> FastAPI:
    """Return the service; its kernels are made ready in the background once it runs."""
    settings = settings or Settings()
    app = FastAPI(
        title="Restitution",
        version=version("restitution"),
        summary="Coefficient of tangential restitution of colliding frictional spheres",
        lifespan=_lifespan,
        # both would load their scripts from elsewhere
        docs_url=None,
        redoc_url=None,
    )
    app.state.ready = threading.Event()
    errors.install(app)
    app.add_middleware(
        CORSMiddleware,
        allow_origins=["*"],
        allow_methods=["GET", "POST"],
        allow_headers=["*"],
        expose_headers=["ETag", "Server-Timing", "Retry-After"],
    )
    app.include_router(collisions.router)
    app.include_router(service.router)
    _add_page(app, settings)
    return app


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    def prepare() -> None:
        begin = time.perf_counter()
        warm()
        app.state.ready.set()
        click.echo(f"ready: the kernels took {time.perf_counter() - begin:.1f} s")

    click.echo("preparing the kernels: compiled the first time (half a minute), then from a cache")
    threading.Thread(target=prepare, name="kernels", daemon=True).start()
    yield


def _add_page(app: FastAPI, settings: Settings) -> None:
    script = files("plotly").joinpath("package_data", "plotly.min.js")

    @app.get("/", include_in_schema=False)
    def page() -> FileResponse:
        return FileResponse(settings.frontend_directory / "index.html", headers=PAGE_HEADERS)

    @app.get(PLOTLY, include_in_schema=False)
    def plotly() -> FileResponse:
        return FileResponse(str(script), headers={"Cache-Control": "public, max-age=86400"})

    app.mount("/static", _Static(directory=settings.frontend_directory), "static")


class _Static(StaticFiles):
    """The page's files, asked for again each time and answered 304 while they are the same."""

    def file_response(self, *args: object, **kwargs: object) -> FileResponse:
        response = super().file_response(*args, **kwargs)  # type: ignore[arg-type]
        response.headers["Cache-Control"] = "no-cache"
        return response  # type: ignore[return-value]
