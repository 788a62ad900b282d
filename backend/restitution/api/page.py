"""The page: its files and plotly.js, compressed once and kept."""

import hashlib
import os
import re
from functools import lru_cache
from importlib.resources import files
from mimetypes import guess_type
from pathlib import Path
from typing import NamedTuple

import brotli
from fastapi import FastAPI, Request, Response
from fastapi.responses import HTMLResponse
from starlette.datastructures import Headers
from starlette.staticfiles import NotModifiedResponse, StaticFiles
from starlette.types import Scope

from restitution.api.transport import known_tag
from restitution.mechanics import cache
from restitution.mechanics.compiled import CACHE_FOLDER

PLOTLY = Path(str(files("plotly").joinpath("package_data", "plotly.min.js"))).resolve()

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


Entry = tuple[str, int, int]
"""A file as it is now: path, size, time in nanoseconds."""


class _Compressed(NamedTuple):
    """A file compressed by brotli, and the entity tag of that."""

    body: bytes
    tag: str


_compressed: dict[Entry, _Compressed] = {}
"""Kept in memory, 1.5 MB: what happens to its files while a server runs is of no consequence."""


def compress_page(frontend_directory: Path) -> None:
    """Compress plotly.js, to a quarter, and the files of the page: six seconds the first time."""
    texts = (file for file in frontend_directory.rglob("*") if file.suffix in COMPRESSIBLE)
    for source in (*texts, PLOTLY):
        path = source.resolve()
        entry = _entry(path, path.stat())
        if entry not in _compressed:
            body = _compress(path)
            _compressed[entry] = _Compressed(body, f'"{hashlib.sha256(body).hexdigest()[:32]}"')


def _compress(source: Path) -> bytes:
    """Return a file compressed, from beside the kernels if it is there for this very text."""
    text = source.read_bytes()
    # named by where it is from: a file that changes takes no more room
    digest = hashlib.sha256(str(source).encode()).hexdigest()[:16]
    file = Path(CACHE_FOLDER, "page", f"{digest}-{source.name}.br")
    kept = cache.read(file) if CACHE_FOLDER else None
    if kept is not None and brotli.decompress(kept) == text:
        return kept
    body: bytes = brotli.compress(text, quality=11, lgwin=22)
    if CACHE_FOLDER:
        cache.write(file, body)
    return body


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


State = frozenset[Entry]
"""The page's files."""

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
    """Return the page with addresses that change with the files, and its modules announced.

    All are relative, for the page may stand below any path of a proxy.
    """
    modules = (path.relative_to(directory) for path in _imported(directory / "main.js"))
    announced = "\n    ".join(
        f'<link rel="modulepreload" href="static/{module.as_posix()}" />'
        for module in sorted(modules)
    )
    text = _assembled(directory).replace("<!-- modules -->", announced)
    return text.replace('="static/', f'="static/{_version(state)}/')


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


def _entry(file: str | os.PathLike[str], found: os.stat_result) -> Entry:
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
        headers = Headers(scope=scope)
        # a file may have changed since the page was asked for, or since it was compressed
        entry = _entry(full_path, stat_result)
        kept = entry in self._state and version == _version(self._state)
        found = _compressed.get(entry) if "br" in headers.get("accept-encoding", "") else None
        if found:
            told = {"ETag": found.tag, "Content-Encoding": "br"}
            response = Response(found.body, status_code, told, guess_type(full_path)[0])
            if self.is_not_modified(response.headers, headers):
                response = NotModifiedResponse(response.headers)
        else:
            response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = KEPT if kept else "no-cache"
        response.headers["Vary"] = "Accept-Encoding"
        # the tag says it all, and a hundred headers are some kilobytes
        for name in ("Last-Modified", "Accept-Ranges"):
            del response.headers[name]
        return response
