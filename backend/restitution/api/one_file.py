"""The page as one file that asks nobody: every module, style, word and number of it in one HTML."""

import base64
import gzip
import json
import os
import re
import threading
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from fastapi import FastAPI, Request, Response

from restitution.api.page import (
    HTML,
    PLOTLY,
    USUAL_LANGUAGE,
    State,
    assembled,
    json_in_script,
    languages_of,
    locales,
    pack,
    state_of,
    tagged,
    texts_of,
)
from restitution.api.transport import takes
from restitution.studies.collision.presets import PRESETS
from restitution.wire.formats import as_json

NAME = "restitution.html"

POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' data: 'wasm-unsafe-eval'; "
    "style-src 'unsafe-inline' data:; font-src data:; img-src data: blob:; "
    "base-uri 'none'; form-action 'none'"
)
"""Of what is not in the file nothing can be asked for."""

USUAL_SERVER = "http://127.0.0.1:8000/"
"""Of `restitution serve`: what the page shows of requests is asked there."""

IMPORTS = re.compile(r'(\bfrom |\bimport |\bimport\()"(\.[^"]+)"')

KINDS = {".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml"}

SERVED = re.compile(r"<!-- served -->.*?<!-- /served -->", re.DOTALL)
"""What the page has of a server alone."""

LINK = re.compile(r"<link\b[^>]*>")

MAIN = '<script type="module" blocking="render" src="static/main.js"></script>'

PLOTLY_SCRIPT = '<script defer src="assets/plotly.min.js"></script>'


def one_file(directory: Path) -> str:
    """Return the page in `directory` as one HTML document, the same for the same files.

    Modules have the names of their files in an import map, for one in an address of its own knows
    of no other beside it.
    """
    text = SERVED.sub("", assembled(directory))
    text = LINK.sub(partial(_link, directory), text)
    parts = {
        '<meta charset="utf-8" />': '<meta charset="utf-8" />\n'
        f'    <meta http-equiv="Content-Security-Policy" content="{POLICY}" />',
        "<!-- words -->": _script("application/json", json_in_script(_contents(directory)), "file"),
        "<!-- modules -->": _script(
            "importmap", json_in_script({"imports": _modules(directory)}), "modules"
        ),
        MAIN: '<script type="module" blocking="render">import "main.js";</script>',
        PLOTLY_SCRIPT: _script("text/plain", _unended(PLOTLY.read_text("utf-8")), "plotly"),
    }
    for marked, part in parts.items():
        before, found, after = text.partition(marked)
        assert found, marked
        text = before + part + after
    return text


class _Packed(NamedTuple):
    """The document compressed, for a state of the files that it is made of."""

    state: State
    bodies: dict[str, bytes]


def add_one_file(app: FastAPI, directory: Path) -> None:
    """Let `app` hand out the page in `directory` as one file, made when it is first asked for."""
    directory = directory.resolve()
    lock = threading.Lock()
    kept = _Packed(frozenset(), {})

    def bodies() -> dict[str, bytes]:
        nonlocal kept
        state = state_of(directory)
        # a class that asks at once has it made once
        with lock:
            if kept.state != state:
                text = one_file(directory).encode()
                # the same in every worker, without the time at which it was made
                packed = {"br": pack(text, quality=9), "gzip": gzip.compress(text, mtime=0)}
                kept = _Packed(state, packed)
            return kept.bodies

    @app.get(f"/{NAME}", include_in_schema=False)
    def page_as_one_file(request: Request) -> Response:
        found = bodies()
        encoding = next((name for name in found if takes(request.headers, name)), "")
        body = found[encoding] if encoding else gzip.decompress(found["gzip"])
        headers = {
            "Content-Type": HTML,
            "Content-Disposition": f'attachment; filename="{NAME}"',
            "Cache-Control": "no-cache",
            **({"Content-Encoding": encoding, "Vary": "Accept-Encoding"} if encoding else {}),
        }
        return tagged(request, body, headers)


def _contents(directory: Path) -> dict[str, Any]:
    """Return what a server would be asked for and knows without computing."""
    words = locales(directory, state_of(directory))
    kernel = (directory / "kernel" / "kernel.wasm").read_bytes()
    return {
        "language": USUAL_LANGUAGE,
        "languages": languages_of(words),
        "texts": {
            name: {
                "first": texts_of(words, name, later=False),
                "later": texts_of(words, name, later=True),
            }
            for name in words
        },
        "presets": json.loads(as_json({"items": [*PRESETS.values()]}, "plain"))["items"],
        "server": USUAL_SERVER,
        "kernel": base64.b64encode(kernel).decode(),
    }


def _modules(directory: Path) -> dict[str, str]:
    """Return the address of every module by its path in the folder of the page."""
    return {
        path.relative_to(directory).as_posix(): _address(path, _named(directory, path))
        for path in sorted(directory.rglob("*.js"))
    }


def _named(directory: Path, path: Path) -> str:
    """Return a module that calls the others, and itself, by their paths in the page's folder."""

    def name(found: re.Match[str]) -> str:
        target = os.path.normpath(path.parent.relative_to(directory) / found[2])
        return f'{found[1]}"{Path(target).as_posix()}"'

    source = IMPORTS.sub(name, path.read_text("utf-8"))
    # an error would else be told with the whole of the address
    return f"{source}//# sourceURL={path.relative_to(directory).as_posix()}\n"


def _link(directory: Path, found: re.Match[str]) -> str:
    """Return what a link of the page leads to, in its place."""
    tag = found[0]
    address = re.search(r'href="static/([^"]+)"', tag)
    if not address or 'rel="preload"' in tag:
        return "" if address else tag
    path = directory / address[1]
    if 'rel="stylesheet"' not in tag:
        return tag.replace(address[0], f'href="{_attribute(_address(path))}"')
    sheet = re.sub(r'url\("([^"]+)"\)', partial(_inside, path.parent), path.read_text("utf-8"))
    if "data-comes-with" not in tag:
        return f"<style>\n{sheet}</style>"
    # one that comes later is let come as from a server
    return tag.replace(address[0], f'href="{_attribute(_address(path, sheet))}"')


def _inside(folder: Path, found: re.Match[str]) -> str:
    """Return a font that a style sheet names, in the style sheet."""
    font = base64.b64encode((folder / found[1]).read_bytes()).decode()
    return f'url("data:font/woff2;base64,{font}")'


def _address(path: Path, text: str | None = None) -> str:
    """Return an address that holds a file; base64 would be a quarter larger when it is packed."""
    text = path.read_text("utf-8") if text is None else text
    # what an address cannot hold as it is
    escaped = re.sub(r"[%#\t\n\r]", lambda sign: quote(sign[0]), text)
    return f"data:{KINDS[path.suffix]};charset=utf-8,{escaped}"


def _attribute(text: str) -> str:
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def _script(kind: str, text: str, name: str) -> str:
    return f'<script type="{kind}" id="{name}">{text}</script>'


def _unended(text: str) -> str:
    """Return a script that stands in a page as it is."""
    assert not re.search("</script|<!--", text, re.IGNORECASE)
    return text
