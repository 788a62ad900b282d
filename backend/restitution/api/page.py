"""The page: its files and plotly.js, compressed once and kept."""

import hashlib
import os
from importlib.resources import files
from pathlib import Path

import brotli
from fastapi import FastAPI, Request
from fastapi.responses import FileResponse
from starlette.staticfiles import StaticFiles

from restitution.mechanics.compiled import CACHE_FOLDER

PLOTLY = Path(str(files("plotly").joinpath("package_data", "plotly.min.js")))

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

PLOTLY_HEADERS = {
    "Cache-Control": "public, max-age=86400",
    "Vary": "Accept-Encoding",
    "X-Content-Type-Options": "nosniff",
}


def _compressed_plotly() -> Path:
    """Return where the compressed plotly.js is kept: beside the kernels, named by its content."""
    digest = hashlib.sha256(PLOTLY.read_bytes()).hexdigest()[:16]
    return Path(CACHE_FOLDER, f"plotly-{digest}.min.js.br")


def compress_plotly() -> None:
    """Compress plotly.js once, to a quarter: five seconds, too long for a request."""
    target = _compressed_plotly()
    if CACHE_FOLDER and not target.exists():
        partial = target.with_suffix(f".{os.getpid()}")
        partial.write_bytes(brotli.compress(PLOTLY.read_bytes(), quality=11, lgwin=22))
        # whole or not at all, for other processes may look
        partial.replace(target)


def add_page(app: FastAPI, frontend_directory: Path) -> None:
    """Let `app` serve the page in `frontend_directory`."""
    compressed = _compressed_plotly()

    @app.get("/", include_in_schema=False)
    def page() -> FileResponse:
        return FileResponse(frontend_directory / "index.html", headers=PAGE_HEADERS)

    @app.get("/assets/plotly.min.js", include_in_schema=False)
    def plotly(request: Request) -> FileResponse:
        kind = "text/javascript"
        if "br" in request.headers.get("accept-encoding", "") and compressed.exists():
            headers = PLOTLY_HEADERS | {"Content-Encoding": "br"}
            return FileResponse(compressed, headers=headers, media_type=kind)
        return FileResponse(PLOTLY, headers=PLOTLY_HEADERS, media_type=kind)

    app.mount("/static", _Files(directory=frontend_directory), "static")


class _Files(StaticFiles):
    """The page's files, asked for again each time and answered 304 while they are the same."""

    def file_response(self, *args: object, **kwargs: object) -> FileResponse:
        response = super().file_response(*args, **kwargs)  # type: ignore[arg-type]
        response.headers["Cache-Control"] = "no-cache"
        return response  # type: ignore[return-value]
