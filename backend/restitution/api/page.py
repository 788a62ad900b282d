"""The page: its files and plotly.js, compressed once and kept."""

import hashlib
import os
from importlib.resources import files
from pathlib import Path

import brotli
from fastapi import FastAPI, Request, Response
from starlette.datastructures import Headers
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

from restitution.mechanics.compiled import CACHE_FOLDER

PLOTLY = Path(str(files("plotly").joinpath("package_data", "plotly.min.js")))

PAGE_HEADERS = {
    # Plotly sets styles from its script; nothing else is inline, nothing comes from elsewhere.
    "Content-Security-Policy": (
        "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        # what a saved picture embeds is read once by the page itself, see embedded-fonts.js
        "font-src 'self' data:; "
        # no rule about frames: anybody may show it in one, that is what `embed` is for
        "object-src 'none'; base-uri 'none'; form-action 'none'"
    )
}

PLOTLY_HEADERS = {"Cache-Control": "public, max-age=86400"}

COMPRESSIBLE = {".css", ".html", ".js", ".json", ".svg"}


def _compressed(source: Path) -> Path:
    """Return where a compressed file is kept: beside the kernels, named by where it is from."""
    digest = hashlib.sha256(str(source.resolve()).encode()).hexdigest()[:16]
    return Path(CACHE_FOLDER, "page", f"{digest}-{source.name}.br")


def compress_page(frontend_directory: Path) -> None:
    """Compress plotly.js, to a quarter, and the files of the page once: six seconds."""
    if not CACHE_FOLDER:
        return
    texts = (file for file in frontend_directory.rglob("*") if file.suffix in COMPRESSIBLE)
    for source in (*texts, PLOTLY):
        target = _compressed(source)
        if not _is_current(target, source.stat()):
            target.parent.mkdir(parents=True, exist_ok=True)
            partial = target.with_suffix(f".{os.getpid()}")
            partial.write_bytes(brotli.compress(source.read_bytes(), quality=11, lgwin=22))
            # whole or not at all, for other processes may look
            partial.replace(target)


def _is_current(target: Path, source: os.stat_result) -> bool:
    return target.exists() and target.stat().st_mtime >= source.st_mtime


def add_page(app: FastAPI, frontend_directory: Path) -> None:
    """Let `app` serve the page in `frontend_directory`."""
    files = _Files(directory=frontend_directory)

    @app.get("/", include_in_schema=False)
    async def page(request: Request) -> Response:
        response = await files.get_response("index.html", request.scope)
        response.headers.update(PAGE_HEADERS)
        return response

    @app.get("/assets/plotly.min.js", include_in_schema=False)
    def plotly(request: Request) -> Response:
        response = files.file_response(PLOTLY, PLOTLY.stat(), request.scope)
        response.headers.update(PLOTLY_HEADERS)
        return response

    app.mount("/static", files, "static")


class _Files(StaticFiles):
    """The page's files, asked for again each time and answered 304 while they are the same."""

    def file_response(
        self,
        full_path: str | os.PathLike[str],
        stat_result: os.stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        """Return a file, compressed where the client takes that and it was done beforehand."""
        target = _compressed(Path(full_path))
        compressed = "br" in Headers(scope=scope).get("accept-encoding", "") and _is_current(
            target, stat_result
        )
        if compressed:
            full_path, stat_result = target, target.stat()
        response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = "no-cache"
        response.headers["Vary"] = "Accept-Encoding"
        if compressed and response.status_code == 200:
            response.headers["Content-Encoding"] = "br"
        return response
