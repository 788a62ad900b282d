"""What a client may take of a server until its request is there, and while it takes the answer.

uvicorn bounds nothing of this with the fast one of its parsers. nginx before it does; alone, a
server has these limits.
"""

import math
import uuid
from typing import Any

from httptools import HttpParserCallbackError, HttpParserError, HttpParserUpgrade
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol

from restitution.api.admission import ENDING, RETRY_AFTER, saturated
from restitution.api.problems import problem
from restitution.api.transport import HEADERS

LONGEST_HEAD = 64 * 2**10
"""Bytes of address and headers, as nginx allows for."""

MOST_HEADERS = 100
"""Those of browsers have some twenty."""

LONGEST_WAIT = 10.0
"""Seconds that a connection may be without a request, and that a head may take."""

LONGEST_UPLOAD = 60.0
"""Seconds until a request must be there with its body: 40 MiB at 6 Mbit/s."""

LEAST_PIECE = 64
"""Bytes that come for each piece of a body, on average: each costs what a thousand bytes do."""

MOST_SMALL_PIECES = 1000
"""Before the average counts."""

MOST_PIPELINED = 32
"""Requests that wait for the answer to another one on their connection."""

LONGEST_PAUSE = 30.0
"""Seconds in which a client that is given an answer must take some of it, as with nginx."""

MOST_CONNECTIONS = 800
"""Open in one process, which often may have 1,024 files."""

MADE_ROOM = MOST_CONNECTIONS // 20
"""Idle connections that give way at once: to look for the oldest takes a while."""

FAREWELL = 5.0
"""Seconds in which a client that was refused may go on sending, to come to read why."""

ROUND = 1.0
"""Seconds from one look at a connection to the next."""

NOTHING, HEAD, BODY = range(3)
"""What of a request is being read."""

NO_REQUEST = "this is not an HTTP request"

NO_ADDRESS = 400, f"{NO_REQUEST}: it has no address that could be read"
TOO_LONG = 431, f"address and headers are longer than {LONGEST_HEAD:,} bytes"
TOO_MANY = 431, f"there are more than {MOST_HEADERS} headers"
TOO_SMALL = 400, f"the body comes in pieces of less than {LEAST_PIECE} bytes"
TOO_CROWDED = 400, f"more than {MOST_PIPELINED} requests wait for answers on one connection"


class Connection(HttpToolsProtocol):
    """A connection whose client may be slow, silent, greedy or none at all."""

    def __init__(self, *given: Any, **more: Any) -> None:
        super().__init__(*given, **more)
        self._reading = NOTHING
        # when that, or being idle, began
        self._since = self.loop.time()
        # bytes of this delivery, and whether a request begins with it
        self._arrived, self._is_new = 0, False
        # of the request: bytes of its deliveries, of those without a piece of a body, and pieces
        self._delivered = self._overhead = self._pieces = 0
        self._keep_alive = True
        self._refusal: tuple[int, str] | None = None
        # what is left to say to a client that was refused, and whether it was said
        self._last_words: bytes | None = None
        self._is_over = False
        # what the client has not taken yet, and when it last took some
        self._unsent, self._taken = 0, 0.0

    @property
    def idle_since(self) -> float:
        """When it became idle; infinite while somebody works on an answer for it."""
        refused = self._last_words is not None
        is_busy = not refused and bool(self.cycle and not self.cycle.response_complete)
        return math.inf if is_busy or self.transport.is_closing() else self._since

    def connection_made(self, transport: Any) -> None:
        """Begin to watch over a connection; if there are too many, idle ones give way."""
        super().connection_made(transport)
        self._watch = self.loop.call_later(ROUND, self._look)
        if len(self.connections) > MOST_CONNECTIONS:
            self._make_room()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop watching."""
        self._watch.cancel()
        super().connection_lost(exc)

    def _make_room(self) -> None:
        others = [o for o in self.connections if isinstance(o, Connection) and o is not self]
        idle = sorted((o.idle_since, id(o), o) for o in others if o.idle_since < math.inf)
        for _, _, other in idle[:MADE_ROOM]:
            other.transport.close()
        if not idle:
            saturated()
            self._refuse(503, "more connections are open than can be served; ask again")

    def data_received(self, data: bytes) -> None:
        """Read on, unless the client was refused."""
        if self._last_words is not None:
            return
        self._unset_keepalive_if_required()
        self._arrived, self._is_new = len(data), False
        pieces = self._pieces
        try:
            self.parser.feed_data(data)
        except HttpParserUpgrade:
            # no other protocol is spoken here, and what came with this one is lost
            self.cycle.keep_alive = False
        except HttpParserCallbackError:
            self._refuse(*(self._refusal or NO_ADDRESS))
        except HttpParserError as error:
            self._refuse(400, f"{NO_REQUEST}: {error}")
        else:
            if self._reading != NOTHING and not self._is_new:
                self._delivered += len(data)
                self._overhead += 0 if self._pieces > pieces else len(data)
            if self._overhead > LONGEST_HEAD:
                self._refuse(*TOO_LONG)
            elif self._pieces > max(MOST_SMALL_PIECES, self._delivered // LEAST_PIECE):
                self._refuse(*TOO_SMALL)

    def on_message_begin(self) -> None:
        """Begin a request."""
        super().on_message_begin()
        self._reading, self._since = HEAD, self.loop.time()
        self._is_new, self._delivered = True, self._arrived
        self._overhead = self._pieces = 0
        if len(self.pipeline) >= MOST_PIPELINED:
            self._stop(*TOO_CROWDED)

    def on_headers_complete(self) -> None:
        """Hand over a request whose head is right."""
        if len(self.headers) > MOST_HEADERS:
            self._stop(*TOO_MANY)
        # one that came with a single delivery, and that a short one, needs no counting
        counted = not self._is_new or self._arrived > LONGEST_HEAD
        if counted and self._size_of_head() > LONGEST_HEAD:
            self._stop(*TOO_LONG)
        super().on_headers_complete()
        self._reading = BODY
        # what may follow a body in chunks is for nobody
        self.headers = []
        if self.expect_100_continue:
            # if it is answered before, its body may come or not: nobody could tell what follows
            self._keep_alive, self.cycle.keep_alive = self.cycle.keep_alive, False

    def on_body(self, body: bytes) -> None:
        """Take a piece of a body."""
        super().on_body(body)
        self._pieces += 1

    def on_message_complete(self) -> None:
        """Let a request be whole."""
        super().on_message_complete()
        self._reading = NOTHING
        if self.expect_100_continue:
            self.cycle.keep_alive = self._keep_alive

    def on_response_complete(self) -> None:
        """Go on with the request that waits; a refused client gets its last words."""
        more = bool(self.pipeline)
        super().on_response_complete()
        if self._reading == NOTHING:
            self._since = self.loop.time()
        if self._last_words is not None and not more:
            self._end()

    def shutdown(self) -> None:
        """Let what is under way be answered; what is not wholly there is not waited for."""
        if self._reading == BODY and self._last_words is None:
            self._refuse(503, f"{ENDING}; ask again")
        super().shutdown()
        if self._is_over:
            # who was refused has not as long to come to see it as otherwise
            self.loop.call_later(ROUND, self.transport.abort)

    def _stop(self, status: int, detail: str) -> None:
        """Leave the parser with a refusal: it hides what it was left with."""
        self._refusal = status, detail
        raise ValueError(detail)

    def _size_of_head(self) -> int:
        return len(self.url) + sum(len(name) + len(value) + 4 for name, value in self.headers)

    def _look(self) -> None:
        """Look how long the client has been about what it does."""
        self._watch = self.loop.call_later(ROUND, self._look)
        now = self.loop.time()
        if (unsent := self.transport.get_write_buffer_size()) != self._unsent:
            self._unsent, self._taken = unsent, now
        if unsent and now - self._taken > LONGEST_PAUSE:
            self.transport.abort()
        elif self._is_over:
            if now - self._since > FAREWELL and not unsent:
                self.transport.abort()
        elif self._last_words is not None or self.flow.read_paused:
            # it is we who do not read
            self._since = now
        else:
            self._look_at_request(now - self._since)

    def _look_at_request(self, elapsed: float) -> None:
        if self._reading == BODY:
            # also of one that was answered before: who reads no answer until all is sent may see it
            if elapsed > LONGEST_UPLOAD:
                self._refuse(408, f"the body took longer than {LONGEST_UPLOAD:g} s")
        elif self._reading == HEAD:
            if elapsed > LONGEST_WAIT:
                self._refuse(408, f"the head of the request took longer than {LONGEST_WAIT:g} s")
        elif elapsed > LONGEST_WAIT and self.idle_since < math.inf:
            self.transport.close()

    def _refuse(self, status: int, detail: str) -> None:
        """Answer what will be no request, after those before it, and read no further."""
        self._last_words = self._words(status, detail)
        # of those that one delivery brings many would be kept until the client goes
        (self.headers or []).clear()
        waits = bool(self.cycle and not self.cycle.response_complete)
        if self._reading == BODY:
            if self.pipeline:
                # nobody has begun to work on it
                self.pipeline.popleft()
            elif self.cycle.response_started:
                self._last_words, self.cycle.keep_alive = b"", False
            else:
                self.cycle.disconnected, waits = True, False
                self.cycle.message_event.set()
        if not waits:
            self._end()

    def _words(self, status: int, detail: str) -> bytes:
        headers = HEADERS | {
            "Access-Control-Allow-Origin": "*",
            "Connection": "close",
            "X-Request-ID": uuid.uuid4().hex,
        }
        if status == 503:
            headers["Retry-After"] = str(RETRY_AFTER)
        answer = problem(status, detail, None, **headers)
        fields = (*self.server_state.default_headers, *answer.raw_headers)
        lines = (b"%s: %s\r\n" % field for field in fields)
        return b"".join([STATUS_LINE[status], *lines, b"\r\n", answer.body])

    def _end(self) -> None:
        """Say the last words; who still sends is read a while, or would never come to see them."""
        self._is_over = True
        self._unset_keepalive_if_required()
        if self.transport.is_closing():
            return
        self.transport.write(self._last_words or b"")
        self.transport.write_eof()
        self.flow.resume_reading()
        self._since = self.loop.time()
