"""The page: its files and plotly.js, compressed once and kept."""

import hashlib
import json
import os
import re
from functools import lru_cache
from importlib.resources import files
from mimetypes import guess_type
from pathlib import Path
from typing import Any, NamedTuple

import brotli
from fastapi import FastAPI, Request, Response
from starlette.datastructures import Headers
from starlette.staticfiles import NotModifiedResponse, StaticFiles
from starlette.types import Scope

from restitution.api.transport import known_tag, takes, weights_of
from restitution.mechanics import cache
from restitution.mechanics.compiled import CACHE_FOLDER

PLOTLY = Path(str(files("plotly").joinpath("package_data", "plotly.min.js"))).resolve()

PAGE_HEADERS = {
    # Plotly sets styles from its script; nothing else is inline, nothing comes from elsewhere.
    "Content-Security-Policy": (
        # the kernel that computes in the page is WebAssembly
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; "
        "style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        # what a saved picture embeds is read once by the page itself, see embedded-fonts.js
        "font-src 'self' data:; "
        # no rule about frames: anybody may show it in one, that is what `embed` is for
        "object-src 'none'; base-uri 'none'; form-action 'none'"
    )
}

PLOTLY_HEADERS = {"Cache-Control": "public, max-age=86400"}

HTML = "text/html; charset=utf-8"

COMPRESSIBLE = {".css", ".html", ".js", ".json", ".svg", ".wasm"}


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
            _compressed[entry] = _Compressed(body, entity_tag(body))


def entity_tag(body: bytes) -> str:
    """Return the entity tag of what is sent."""
    return f'"{hashlib.sha256(body).hexdigest()[:16]}"'


def pack(text: bytes, quality: int) -> bytes:
    """Return a text compressed by brotli."""
    packed: bytes = brotli.compress(text, quality=quality, lgwin=22)
    return packed


def _compress(source: Path) -> bytes:
    """Return a file compressed, from beside the kernels if it is there for this very text."""
    text = source.read_bytes()
    # named by where it is from: a file that changes takes no more room
    digest = hashlib.sha256(str(source).encode()).hexdigest()[:16]
    file = Path(CACHE_FOLDER, "page", f"{digest}-{source.name}.br")
    kept = cache.read(file) if CACHE_FOLDER else None
    if kept is not None and brotli.decompress(kept) == text:
        return kept
    body = pack(text, quality=11)
    if CACHE_FOLDER:
        cache.write(file, body)
    return body


def add_page(app: FastAPI, frontend_directory: Path) -> None:
    """Let `app` serve the page in `frontend_directory`."""
    files = _Files(directory=frontend_directory)

    @app.get("/", include_in_schema=False)
    def page(request: Request) -> Response:
        accepted = request.headers.get("accept-language", "")
        text = files.page(request.query_params.get("lang", ""), accepted)
        vary = "Accept-Encoding, Accept-Language"
        return _made(request, text, PAGE_HEADERS | {"Content-Type": HTML, "Vary": vary})

    @app.get("/words/{language}", include_in_schema=False)
    def later_words(request: Request, language: str) -> Response:
        headers = {"Content-Type": "application/json", "Vary": "Accept-Encoding"}
        return _made(request, files.later_words(language), headers)

    @app.get("/assets/plotly.min.js", include_in_schema=False)
    def plotly(request: Request) -> Response:
        response = files.file_response(PLOTLY, PLOTLY.stat(), request.scope)
        response.headers.update(PLOTLY_HEADERS)
        return response

    app.mount("/static", files, "static")


def _made(request: Request, text: str, headers: dict[str, str]) -> Response:
    """Answer with a text that is made of the page's files: asked for each time, compressed once."""
    headers["Cache-Control"] = "no-cache"
    body = text.encode()
    if takes(request.headers, "br"):
        body = _packed(text)
        headers["Content-Encoding"] = "br"
    return tagged(request, body, headers)


def tagged(request: Request, body: bytes, headers: dict[str, str]) -> Response:
    """Answer with a body under its entity tag, or that the client has it."""
    tag = entity_tag(body)
    if known := known_tag(tag, request.headers.get("if-none-match", "")):
        return Response(None, 304, headers | {"ETag": known})
    return Response(body, headers=headers | {"ETag": tag})


USUAL_LANGUAGE = "en"

LATER = (
    "bundle",
    "codes",
    "compare",
    "embedding",
    "errorMap",
    "lesson",
    "materials",
    "oneFile",
    "overlay",
    "paper",
    "presenting",
    "spheres",
    "steps",
    "sweep",
    "tradeoff",
    "warnings",
)
"""Texts that come with the scenes, and with what saves all, that are not in the first view."""

State = frozenset[Entry]
"""The page's files."""


def state_of(directory: Path) -> State:
    """Return what a folder holds now."""
    paths = (
        os.path.join(folder, name)  # noqa: PTH118 - asked for with each page, of each file
        for folder, _, names in os.walk(directory)
        for name in names
    )
    return frozenset(_entry(path, os.stat(path)) for path in paths)  # noqa: PTH116


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


@lru_cache(maxsize=20)
def _versioned_page(directory: Path, state: State, language: str) -> str:
    """Return the page in a language, with addresses that change with the files.

    Its words are in it and its modules are announced. All addresses are relative, for the page may
    stand below any path of a proxy.
    """
    modules = (path.relative_to(directory) for path in _imported(directory / "main.js"))
    announced = "\n    ".join(
        f'<link rel="modulepreload" href="static/{module.as_posix()}" />'
        for module in sorted(modules)
    )
    text = assembled(directory).replace("<!-- modules -->", announced)
    text = text.replace('lang="en"', f'lang="{language}"', 1)
    text = text.replace("<!-- words -->", _words(locales(directory, state), language))
    return text.replace('="static/', f'="static/{_version(state)}/')


def assembled(directory: Path) -> str:
    """Return index.html with the parts that it names, each in the room of its scene."""
    text = (directory / "index.html").read_text("utf-8")
    return PART.sub(lambda part: (directory / part[1]).read_text("utf-8"), text)


@lru_cache(maxsize=20)
def _packed(text: str) -> bytes:
    """Return a text compressed by brotli: words are a sixth less than gzip makes of them."""
    return pack(text.encode(), quality=9)


@lru_cache(maxsize=2)
def locales(directory: Path, state: State) -> dict[str, dict[str, Any]]:  # noqa: ARG001 - what it hangs on
    """Return the texts of each language that the page has."""
    return {
        file.stem: json.loads(file.read_text("utf-8"))
        for file in sorted((directory / "locales").glob("*.json"))
    }


def _words(locales: dict[str, dict[str, Any]], language: str) -> str:
    """Return the words of the first view as data."""
    words = {
        "language": language,
        "languages": languages_of(locales),
        "texts": texts_of(locales, language, later=False),
    }
    return f'<script type="application/json" id="words">{json_in_script(words)}</script>'


def languages_of(locales: dict[str, dict[str, Any]]) -> list[dict[str, str]]:
    """Return the languages, each with its own name for itself."""
    return [{"id": name, "name": own["name"]} for name, own in locales.items()]


def texts_of(locales: dict[str, dict[str, Any]], language: str, *, later: bool) -> dict[str, Any]:
    """Return the texts of a language, of the first view or those that come later.

    What it lacks is said in the usual one.
    """
    texts = _over(locales.get(USUAL_LANGUAGE, {}), locales.get(language, {}))
    return {name: text for name, text in texts.items() if (name in LATER) is later}


def json_in_script(value: dict[str, Any]) -> str:
    """Return JSON that no script ends in."""
    return _json(value).replace("<", "\\u003c")


def _json(value: dict[str, Any]) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def _over(usual: dict[str, Any], own: dict[str, Any]) -> dict[str, Any]:
    """Return texts with others in their place, where these are texts and not empty."""
    found = dict(usual)
    for key, text in own.items():
        below = usual.get(key, "")
        if isinstance(below, dict) and isinstance(text, dict):
            found[key] = _over(below, text)
        elif text and isinstance(text, str) and isinstance(below, str):
            found[key] = text
    return found


def _preferred(accepted: str) -> list[str]:
    """Return the languages of an Accept-Language header without their regions, best first."""
    weights = dict[str, float]()
    for tag, weight in weights_of(accepted).items():
        weights.setdefault(tag.partition("-")[0], weight)
    return sorted(
        (name for name, weight in weights.items() if weight), key=lambda name: -weights[name]
    )


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

    def page(self, wanted: str, accepted: str) -> str:
        """Return index.html for the files as they are now, in a language that it has.

        That is the one wanted, else the first of an Accept-Language header, else the usual one.
        """
        known = self._look()
        spoken = (name for name in (wanted, *_preferred(accepted)) if name in known)
        return _versioned_page(self._directory, self._state, next(spoken, USUAL_LANGUAGE))

    def later_words(self, language: str) -> str:
        """Return the texts of a language that the page does without at first, as JSON."""
        return _json(texts_of(self._look(), language, later=True))

    def _look(self) -> dict[str, dict[str, Any]]:
        """Take in how the files are now; return the texts of each language."""
        self._state = state_of(self._directory)
        return locales(self._directory, self._state)

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
        found = _compressed.get(entry) if takes(headers, "br") else None
        if found:
            told = {"ETag": found.tag, "Content-Encoding": "br"}
            response = Response(found.body, status_code, told, guess_type(full_path)[0])
            if self.is_not_modified(response.headers, headers):
                response = NotModifiedResponse(response.headers)
        else:
            response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = KEPT if kept else "no-cache"
        response.headers["Vary"] = "Accept-Encoding"
        # the tag says it all, or the address, and a hundred headers are some kilobytes
        for name in ("Last-Modified", "Accept-Ranges", *(("ETag",) if kept else ())):
            del response.headers[name]
        return response
