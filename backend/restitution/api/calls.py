"""A call of the service, declared once: what is read, what is computed, what is answered.

A route is a function from what was read to a `Result`. Reading, admission, entity tags, the form
of the answer, its headers and its description follow from the declaration.
"""

import functools
import hashlib
import itertools
import time
from collections.abc import AsyncIterator, Callable, Iterator, Mapping
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import parse_qsl

import orjson
from fastapi import APIRouter, Request, Response
from fastapi.routing import APIRoute
from starlette.exceptions import HTTPException
from starlette.responses import StreamingResponse
from starlette.types import Receive, Scope, Send

from restitution.api import document
from restitution.api.admission import admission_of
from restitution.api.metrics import COMPUTE, METHOD
from restitution.api.transport import known_tag
from restitution.bounds import values
from restitution.mechanics.compiled import fingerprint
from restitution.wire.formats import CsvOptions, Result, formed
from restitution.wire.parsing import Parts
from restitution.wire.queries import FormQuery
from restitution.wire.reading import read_object, read_query
from restitution.wire.refusals import RefusedParametersError, refusal

PROGRAM_VERSION = fingerprint(Path(__file__).parents[1])
"""Changes with any source of the package, and so with any answer."""

LARGEST_BODY = 2 * 2**20

MOST_ELEMENTS = 10_000
"""In a body of one collision or map; those of the dearest have some fifty."""

LONGEST_QUERY = 8192
"""Bytes, as nginx allows for a whole address; the longest of ours has some 600."""

Asked = TypeVar("Asked")
Compute = Callable[[Asked], Result]


class CallRoute(APIRoute):
    """A route whose function takes the request as it is: FastAPI's own way to it takes 0.1 ms."""

    def __init__(self, *given: Any, **more: Any) -> None:
        super().__init__(*given, **more)

        async def handle(scope: Scope, receive: Receive, send: Send) -> None:
            request = Request(scope, receive, send)
            response = await self.endpoint(request, **request.path_params)
            await response(scope, receive, send)

        self.app = handle


class Calls(APIRouter):
    """Routes of one subject, under the address of this version of the interface."""

    def __init__(self, tag: str) -> None:
        super().__init__(
            prefix="/api/v1",
            tags=[tag],
            route_class=CallRoute,
            generate_unique_id_function=document.operation_id,
        )
        self.bodies: list[type] = []

    def computed(
        self,
        path: str,
        query: type[Asked],
        answer: Any,
        summary: str,
        *,
        example: Mapping[str, Any] | None = None,
        limit: Callable[[Asked], None] | None = None,
        quick: Callable[[Asked], bool] = lambda _: False,
    ) -> Callable[[Compute[Asked]], Compute[Asked]]:
        """Declare a GET.

        Parameters
        ----------
        path : str
            Below ``/api/v1``.
        query : type
            Dataclass of its parameters.
        answer : type, optional
            What is answered, for the document; None for texts alone.
        summary : str
            In a few words.
        example : mapping, optional
            Parameters that together make a request.
        limit : callable, optional
            Raises `CostError` for what is refused before it waits for its turn.
        quick : callable, optional
            Whether computing and writing the answer takes no more than some milliseconds.
        """
        responses = document.computed(query, answer)
        return self._get(path, query, summary, responses, example, limit, quick)

    def stored(
        self, path: str, query: type[Asked], answer: Any, summary: str
    ) -> Callable[[Compute[Asked]], Compute[Asked]]:
        """Declare a GET of what is at hand."""
        responses = document.stored(query, answer)
        return self._get(path, query, summary, responses, None, None, lambda _: True)

    def _get(
        self,
        path: str,
        query: type[Asked],
        summary: str,
        responses: document.Described,
        example: Mapping[str, Any] | None,
        limit: Callable[[Asked], None] | None,
        quick: Callable[[Asked], bool],
    ) -> Callable[[Compute[Asked]], Compute[Asked]]:
        def declare(compute: Compute[Asked]) -> Compute[Asked]:
            async def endpoint(request: Request) -> Response:
                asked = parameters(request, query)
                if limit:
                    limit(asked)
                work = functools.partial(compute, asked)
                return await respond(request, asked, work, quick=quick(asked))

            described = document.asked(query, example)
            self._add("GET", path, endpoint, compute, summary, responses, described)
            return compute

        return declare

    def posted(
        self,
        path: str,
        body: type[Asked],
        answer: Any,
        summary: str,
        *,
        example: Mapping[str, Any],
        largest: int = LARGEST_BODY,
        most_elements: int = MOST_ELEMENTS,
        read: Callable[[bytes], Asked] | None = None,
    ) -> Callable[[Compute[Asked]], Compute[Asked]]:
        """Declare a POST of JSON of at most `largest` bytes; `read` where it has a reader."""
        reader = read or functools.partial(read_object, body)

        def declare(compute: Compute[Asked]) -> Compute[Asked]:
            async def endpoint(request: Request) -> Response:
                form = parameters(request, FormQuery)
                async with _body(request, largest, Parts(most_elements)) as text:
                    work = functools.partial(
                        _computed,
                        request,
                        form,
                        lambda: compute(reader(text)),
                        {"Cache-Control": "no-store"},
                    )
                    return await admission_of(request).in_thread(request, work)

            self.bodies.append(body)
            responses, asked = document.posted(answer), document.sent(body, example, FormQuery)
            self._add("POST", path, endpoint, compute, summary, responses, asked)
            return compute

        return declare

    def _add(
        self,
        method: str,
        path: str,
        endpoint: Callable[..., Any],
        compute: Callable[..., Any],
        summary: str,
        responses: document.Described,
        asked: dict[str, Any],
    ) -> None:
        self.add_api_route(
            path,
            endpoint,
            methods=[method],
            name=compute.__name__,
            summary=summary,
            description=compute.__doc__,
            response_class=Response,
            responses=responses,
            openapi_extra=asked,
        )


def parameters(request: Request, query: type[Asked]) -> Asked:
    """Return the parameters of a request.

    Raises
    ------
    RefusedParametersError
        Which names all that is wrong, or that the query is one that nobody means: reading it
        would take longer than most answers.
    """
    if (length := len(request.scope["query_string"])) > LONGEST_QUERY:
        words = f"of at most {LONGEST_QUERY:,} bytes"
        raise RefusedParametersError([refusal("query", f"{length:,} bytes", words)])
    text = request.scope["query_string"].decode("latin-1")
    return read_query(query, parse_qsl(text, keep_blank_values=True))


async def respond(
    request: Request,
    query: Any,
    compute: Callable[[], Result],
    version: str = PROGRAM_VERSION,
    *,
    quick: bool = False,
) -> Response:
    """Return the answer to `query` in its form, or 304 if the client has it already.

    `version` stands for everything else that the answer depends on.
    """
    tag = entity_tag(request.scope["path"], query, version)
    headers = {"ETag": tag, "Cache-Control": "public, max-age=86400"}
    at_hand = request.headers.get("if-none-match")
    if at_hand and (known := known_tag(tag, at_hand)):
        return Response(None, 304, headers | {"ETag": known})
    work = functools.partial(_computed, request, query, compute, headers)
    admission = admission_of(request)
    # before that it might have to wait for a kernel to be compiled
    if quick and request.app.state.warm.is_set():
        return await admission.quickly(work)
    return await admission.in_thread(request, work)


def entity_tag(path: str, query: Any, version: str) -> str:
    """Return the strong ETag of `query`, its defaults filled in and its numbers doubles."""
    canonical = orjson.dumps([version, path, values(query)], option=orjson.OPT_SORT_KEYS)
    return f'"{hashlib.sha256(canonical).hexdigest()[:32]}"'


def _computed(
    request: Request, query: Any, compute: Callable[[], Result], headers: dict[str, str]
) -> Response:
    """Return an answer in its form, with the time that computing it took."""
    begin = time.perf_counter()
    result = compute()
    elapsed = time.perf_counter() - begin
    COMPUTE.labels(request.scope["path"].rpartition("/")[2]).observe(elapsed)
    if (method := result.payload.get("method")) is not None:
        METHOD.labels(method if isinstance(method, str) else "list").inc()
    headers["Server-Timing"] = f"compute;dur={1e3 * elapsed:.3f}"
    form = getattr(query, "format", "json"), getattr(query, "encoding", "plain")
    options = query if isinstance(query, CsvOptions) else None
    return _in_blocks(*formed(result, *form, options), headers)


def _in_blocks(kind: str, blocks: Iterator[bytes], headers: Mapping[str, str]) -> Response:
    """Return an answer written block by block, in one piece if the second block is its last."""
    first = list(itertools.islice(blocks, 3))
    if len(first) < 3:
        return Response(b"".join(first), 200, dict(headers), kind)
    return StreamingResponse(itertools.chain(first, blocks), 200, dict(headers), kind)


@asynccontextmanager
async def _body(request: Request, largest: int, parts: Parts) -> AsyncIterator[bytes]:
    """Hold the body of a request as long as it is worked on.

    Raises
    ------
    HTTPException
        415 for another content type, 413 for too much.
    SaturatedError
        If the bodies of others leave no room for it.
    MalformedBodyError, CostError
        If it has too many parts.
    """
    admission, size = admission_of(request), 0
    kind = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if kind != "application/json":
        raise HTTPException(415, "the body must be application/json")
    pieces: list[bytes] = []
    try:
        async for chunk in request.stream():
            admission.hold(len(chunk))
            size += len(chunk)
            if size > largest:
                raise HTTPException(413, f"the body is larger than {largest:,} bytes")
            parts.count(chunk)
            pieces.append(chunk)
        body = b"".join(pieces)
        # not held twice
        pieces.clear()
        yield body
    finally:
        admission.release(size)
