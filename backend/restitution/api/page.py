"""The page: its files and plotly.js, compressed once and kept."""

import hashlib
import os
import re
from functools import lru_cache
from importlib.resources import files
from pathlib import Path

import brotli
from fastapi import FastAPI, Request, Response
from fastapi.responses import HTMLResponse
from starlette.datastructures import Headers
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

from restitution.api.transport import known_tag
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
    def page(request: Request) -> Response:
        text = files.page()
        tag = f'"{hashlib.sha256(text.encode()).hexdigest()[:32]}"'
        headers = PAGE_HEADERS | {"Cache-Control": "no-cache", "ETag": tag}
        if known := known_tag(tag, request.headers.get("if-none-match", "")):
            return Response(None, 304, headers | {"ETag": known})
        return HTMLResponse(text, headers=headers)

    @app.get("/assets/plotly.min.js", include_in_schema=False)
    def plotly(request: Request) -> Response:
        response = files.file_response(PLOTLY, PLOTLY.stat(), request.scope)
        response.headers.update(PLOTLY_HEADERS)
        return response

    app.mount("/static", files, "static")


State = frozenset[tuple[str, int, int]]
"""The page's files, each with its size and its time in nanoseconds."""

KEPT = "max-age=31536000, immutable"

IMPORT = re.compile(r'^(?:import|} from|export .* from)\b.*"(\.[^"]+)";', re.MULTILINE)

PART = re.compile(r"<!-- (\S+\.html) -->")


@lru_cache(maxsize=2)
def _version(state: State) -> str:
    """Return a name for what the files hold: the same on every machine that has the same."""
    digest = hashlib.sha256()
    for name, size, _ in sorted(state):
        digest.update(f"{Path(name).name} {size}\n".encode() + Path(name).read_bytes())
    return digest.hexdigest()[:16]


@lru_cache(maxsize=2)
def _versioned_page(directory: Path, state: State) -> str:
    """Return the page with addresses that change with the files, and its modules announced."""
    modules = (path.relative_to(directory) for path in _imported(directory / "main.js"))
    announced = "\n    ".join(
        f'<link rel="modulepreload" href="/static/{module.as_posix()}" />'
        for module in sorted(modules)
    )
    text = _assembled(directory).replace("<!-- modules -->", announced)
    return text.replace('="/static/', f'="/static/{_version(state)}/')


def _assembled(directory: Path) -> str:
    """Return index.html with the parts that it names, each in the room of its scene."""
    text = (directory / "index.html").read_text("utf-8")
    return PART.sub(lambda part: (directory / part[1]).read_text("utf-8"), text)


def _imported(module: Path) -> set[Path]:
    """Return the modules that are loaded along with one, not those that it loads when needed."""
    found, waiting = set[Path](), [module]
    while waiting:
        file = waiting.pop()
        names = IMPORT.findall(file.read_text("utf-8"))
        imports = {Path(os.path.normpath(file.parent / name)) for name in names}
        waiting += imports - found
        found |= imports
    return found


def _entry(file: str | os.PathLike[str], found: os.stat_result) -> tuple[str, int, int]:
    return os.fspath(file), found.st_size, found.st_mtime_ns


class _Files(StaticFiles):
    """The page's files, at addresses that name their version and at those that do not.

    With the version a file is asked for once and kept. Without, or with that of other files, it
    is asked for each time and answered 304 while it is the same.
    """

    def __init__(self, directory: Path) -> None:
        super().__init__(directory=directory)
        self._directory = directory.resolve()
        self._state: State = frozenset()

    def page(self) -> str:
        """Return index.html for the files as they are now."""
        paths = (
            os.path.join(folder, name)  # noqa: PTH118 - asked for with each page, of each file
            for folder, _, names in os.walk(self._directory)
            for name in names
        )
        self._state = frozenset(_entry(path, os.stat(path)) for path in paths)  # noqa: PTH116
        return _versioned_page(self._directory, self._state)

    def get_path(self, scope: Scope) -> str:
        """Return the path of a file in the folder, which knows no versions."""
        return self._split(scope)[1]

    def _split(self, scope: Scope) -> tuple[str, str]:
        path = super().get_path(scope)
        match = re.fullmatch(r"([0-9a-f]{16})/(.*)", path)
        return (match[1], match[2]) if match else ("", path)

    def file_response(
        self,
        full_path: str | os.PathLike[str],
        stat_result: os.stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        """Return a file, compressed where the client takes that and it was done beforehand."""
        version, _ = self._split(scope)
        # a file may have changed since the page was asked for
        unchanged = _entry(full_path, stat_result) in self._state
        kept = unchanged and version == _version(self._state)
        target = _compressed(Path(full_path))
        compressed = "br" in Headers(scope=scope).get("accept-encoding", "") and _is_current(
            target, stat_result
        )
        if compressed:
            full_path, stat_result = target, target.stat()
        response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = KEPT if kept else "no-cache"
        # the tag says it all, and a hundred headers are some kilobytes
        for name in ("Last-Modified", "Accept-Ranges"):
            del response.headers[name]
        response.headers["Vary"] = "Accept-Encoding"
        if compressed and response.status_code == 200:
            response.headers["Content-Encoding"] = "br"
        return response
