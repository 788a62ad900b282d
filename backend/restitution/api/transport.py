"""What happens to every answer on its way out: compression, headers, HEAD."""

import re
from functools import lru_cache
from types import MappingProxyType

from fastapi import Response
from starlette.datastructures import Headers, MutableHeaders
from starlette.middleware.cors import CORSMiddleware
from starlette.middleware.gzip import GZipMiddleware, IdentityResponder
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from uvicorn.middleware.proxy_headers import ProxyHeadersMiddleware

from restitution.api.problems import problem
from restitution.api.settings import PATH

COMPRESSED = '-gzip"'
"""Ends the entity tag of an answer that was compressed: a strong tag names bytes."""


def known_tag(tag: str, header: str) -> str | None:
    """Return `tag` as If-None-Match has it, compressed or not, None if it is not there."""
    names = {name.strip().removeprefix("W/") for name in header.split(",")}
    if compressed := {tag.removesuffix('"') + COMPRESSED} & names:
        return compressed.pop()
    return tag if names & {tag, "*"} else None


LONGEST_ACCEPT = 1000
"""In characters, five times what browsers send: no header may cost thousands of names."""


@lru_cache(maxsize=64)
def weights_of(header: str) -> MappingProxyType[str, float]:
    """Return what a header of the Accept kind names, in lower case, with its weight of 0 … 1."""
    weights = dict[str, float]()
    for part in header[:LONGEST_ACCEPT].split(","):
        name, _, weight = part.partition(";")
        value = re.fullmatch(r"\s*q=([01](?:\.\d{0,3})?)\s*", weight, re.IGNORECASE)
        weights.setdefault(name.strip().lower(), float(value[1]) if value else 1.0)
    return MappingProxyType(weights)


def takes(headers: Headers, encoding: str) -> bool:
    """Return whether a client takes an answer that is compressed so."""
    return weights_of(headers.get("accept-encoding", "")).get(encoding, 0.0) > 0.0


HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    # an answer of the API that is opened as a page may do nothing; pages have rules of their own
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
}

RAW_HEADERS = [(name.lower().encode(), value.encode()) for name, value in HEADERS.items()]


LEAST_TEXT = 1000
"""In bytes; what is shorter is not compressed."""


class Compression:
    """Compress with gzip, at level 1 and where it pays.

    Numbers in base64 shrink by a quarter at any level. For a force trace of 37 kB that takes
    longer than computing it, so only large arrays are compressed.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._plain = app
        self._texts = GZipMiddleware(app, minimum_size=LEAST_TEXT, compresslevel=1)
        self._arrays = GZipMiddleware(app, minimum_size=40_000, compresslevel=1)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""

        async def tagged(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(raw=message["headers"])
                if headers.get("content-encoding") == "gzip" and (tag := headers.get("etag")):
                    headers["etag"] = tag.removesuffix('"') + COMPRESSED
            await send(message)

        arrays = b"encoding=base64" in scope.get("query_string", b"")
        app: ASGIApp = self._arrays if arrays else self._texts
        if scope["type"] == "http" and not takes(Headers(scope=scope), "gzip"):
            # the middleware looks whether gzip is named, be it with a weight of nothing
            app = IdentityResponder(self._plain, LEAST_TEXT)
        await app(scope, receive, tagged)


class HeadersAndHead:
    """Add the headers of every answer; answer HEAD as GET without the body."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        head = scope["method"] == "HEAD"

        async def with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                present = {name for name, _ in message["headers"]}
                message["headers"] += [each for each in RAW_HEADERS if each[0] not in present]
            elif head:
                message = {**message, "body": b""}
            await send(message)

        await self._app({**scope, "method": "GET"} if head else scope, receive, with_headers)


class BelowPath:
    """Tell the application the path at which a proxy shows it: its description names it.

    Pages need none, for all their addresses are relative.
    """

    def __init__(self, app: ASGIApp, root_path: str, proxies: str) -> None:
        self._app, self._root_path = app, root_path
        # of this only the reading of addresses and networks: who asks is nobody's business
        self._proxies = ProxyHeadersMiddleware(app, proxies).trusted_hosts  # type: ignore[arg-type]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        if scope["type"] == "http" and (path := self._path(scope)):
            scope = {**scope, "root_path": path, "path": path + scope["path"]}
        await self._app(scope, receive, send)

    def _path(self, scope: Scope) -> str:
        """Return what a proxy says that may say so, else what was set."""
        said = Headers(scope=scope).get("x-forwarded-prefix", "").rstrip("/")
        if not re.fullmatch(PATH, said):
            return self._root_path
        client = scope.get("client")
        return said if (client[0] if client else None) in self._proxies else self._root_path


class OpenDoors(CORSMiddleware):
    """Let pages from anywhere GET and POST; refusals of a preflight are problems, too."""

    def __init__(self, app: ASGIApp) -> None:
        super().__init__(
            app,
            allow_origins=["*"],
            allow_methods=["GET", "POST"],
            allow_headers=["*"],
            expose_headers=["ETag", "Server-Timing", "Retry-After", "X-Request-ID"],
        )

    def preflight_response(self, request_headers: Headers) -> Response:
        """Return the answer to a preflight."""
        response = super().preflight_response(request_headers)
        if response.status_code == 200:
            return response
        detail = f"{bytes(response.body).decode()}; from other pages GET and POST are allowed"
        return problem(response.status_code, detail)
