"""A real nginx with the template of the deployment, before real servers and before stubs."""

import http.client
import inspect
import json
import re
import socket
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import ExitStack, contextmanager, suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from itertools import islice
from typing import NamedTuple

import pytest
import uvicorn
from proxy import COLLISION, NGINX, TEMPLATE, Answer, Proxy, nginx

from cases import every_day
from servers import Serving, serving
from waiting import LIMIT_SECONDS

TRACE = "/api/v1/trace?mu_over_alpha=1.4&gt_over_gn=1.358&kappa="
CUT = "/api/v1/cut?along=kappa&gt_over_gn=1.358&mu_over_alpha="
pytestmark = pytest.mark.skipif(not NGINX, reason="there is no nginx: `make test` installs one")


class Cluster(NamedTuple):
    proxy: Proxy
    servers: list[Serving]


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    """Two servers, and nginx before them."""
    with ExitStack() as stack:
        servers = [
            stack.enter_context(serving(tmp_path_factory.mktemp("server"))) for _ in range(2)
        ]
        folder = tmp_path_factory.mktemp("proxy") / "nginx"
        ports = [server.port for server in servers]
        yield Cluster(stack.enter_context(nginx(folder, ports)), servers)


@pytest.fixture(scope="module")
def proxy(cluster: Cluster) -> Proxy:
    return cluster.proxy


class Stub(NamedTuple):
    """A server that answers everything alike, once it may."""

    port: int
    may_answer: threading.Event
    asked: threading.Semaphore
    """Released by every request that arrives."""


@contextmanager
def stub(status: int, headers: dict[str, str], *, held: bool = False) -> Iterator[Stub]:
    """Run a server; one that is `held` answers nothing until it is said that it may."""
    may_answer, asked = threading.Event(), threading.Semaphore(0)
    if not held:
        may_answer.set()

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            asked.release()
            may_answer.wait(LIMIT_SECONDS)
            self.send_response(status)
            for name, value in {"Content-Length": "2", **headers}.items():
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(b"{}")

        def log_message(self, *_: object) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield Stub(server.server_port, may_answer, asked)
        finally:
            may_answer.set()
            server.shutdown()


def assert_problem(answer: Answer, status: int) -> None:
    assert answer.status == status
    assert answer.headers["Content-Type"] == "application/problem+json"
    assert answer.headers["Cache-Control"] == "no-store"
    problem = json.loads(answer.body)
    assert set(problem) == {"type", "title", "status", "detail"}
    assert problem["status"] == status
    assert problem["title"] == http.HTTPStatus(status).phrase
    assert bool(answer.headers["Retry-After"]) == (status in {502, 503, 504})
    assert answer.headers["X-Request-ID"]


def test_repeated_requests_come_from_the_cache(proxy):
    first, second = (proxy.collide(11) for _ in range(2))
    assert [first.status, second.status] == [200, 200]
    assert [first.headers["X-Cache-Status"], second.headers["X-Cache-Status"]] == ["MISS", "HIT"]
    assert first.body == second.body
    assert second.headers["ETag"] == first.headers["ETag"]
    assert second.headers["Cache-Control"] == "public, max-age=86400"


def test_force_traces_are_kept_when_they_are_asked_for_again(proxy):
    states = [proxy.ask(f"{TRACE}11").headers["X-Cache-Status"] for _ in range(4)]
    assert states == ["MISS", "MISS", "HIT", "HIT"]


def test_known_answer_is_not_sent_again(proxy):
    tag = proxy.collide(12).headers["ETag"]
    answer = proxy.ask(f"{COLLISION}12", If_None_Match=tag)
    assert (answer.status, answer.body) == (304, b"")
    assert answer.headers["ETag"] == tag


def test_first_request_with_a_known_answer_is_answered_304_too(proxy):
    tag = proxy.ask(f"{COLLISION}12.5&format=csv").headers["ETag"]
    answer = proxy.ask(f"{COLLISION}12.5&format=csv&encoding=plain", If_None_Match=tag)
    assert answer.status == 304


def test_head_is_answered_from_the_cache(proxy):
    whole = proxy.collide(13)
    answer = proxy.ask(f"{COLLISION}13", "HEAD")
    assert (answer.status, answer.body) == (200, b"")
    assert answer.headers["X-Cache-Status"] == "HIT"
    assert answer.headers["Content-Length"] == str(len(whole.body))


def test_every_client_gets_an_encoding_that_it_reads(proxy):
    plain = proxy.ask(f"{CUT}14")
    packed = [
        proxy.ask(f"{CUT}14", Accept_Encoding=accepted)
        for accepted in ("gzip", "deflate, gzip;q=0.8", "gzip, deflate")
    ]
    assert plain.headers["Content-Encoding"] is None
    assert [answer.headers["Content-Encoding"] for answer in packed] == ["gzip"] * 3
    assert [answer.headers["X-Cache-Status"] for answer in packed] == ["MISS", "HIT", "HIT"]
    assert all(len(answer.body) < len(plain.body) for answer in packed)
    assert "Accept-Encoding" in plain.headers["Vary"]
    assert proxy.ask(f"{CUT}14").headers["Content-Encoding"] is None


def test_other_pages_may_read_answers_that_were_cached_for_our_own(proxy):
    proxy.collide(15)
    answer = proxy.ask(f"{COLLISION}15", Origin="https://lesson.example")
    assert answer.headers["Access-Control-Allow-Origin"] == "*"


def test_posts_are_not_cached(proxy):
    for _ in range(2):
        answer = proxy.post([18, 63])
        assert answer.status == 200
        assert len(json.loads(answer.body)["epsilon_t"]) == 2
        assert answer.headers["X-Cache-Status"] is None


def test_refusals_are_passed_on_and_not_cached(proxy):
    for _ in range(2):
        answer = proxy.collide(-1)
        assert answer.status == 422
        assert answer.headers["X-Cache-Status"] == "MISS"
        assert json.loads(answer.body)["errors"][0]["parameter"] == "kappa"


def test_every_answer_bears_the_name_of_its_own_request(proxy):
    names = [
        proxy.ask(f"{COLLISION}16", X_Request_ID=name).headers.get_all("X-Request-ID")
        for name in ("0" * 32, "36d1b5ea-6e2c-4e7e-8a0b-5f3a3f6c2f1d")
    ]
    assert names == [["0" * 32], ["36d1b5ea-6e2c-4e7e-8a0b-5f3a3f6c2f1d"]]
    (made,) = proxy.ask(f"{COLLISION}16", X_Request_ID="a b<script>").headers.get_all(
        "X-Request-ID"
    )
    assert re.fullmatch(r"[0-9a-f]{32}", made)


def test_answer_from_the_cache_does_not_bear_the_name_of_the_first_request(tmp_path):
    headers = {"Cache-Control": "public, max-age=86400", "X-Request-ID": "f" * 32}
    with stub(200, headers) as server, nginx(tmp_path / "nginx", [server.port]) as proxy:
        answers = [proxy.ask("/api/", X_Request_ID=digit * 32) for digit in "12"]
    assert [a.headers["X-Cache-Status"] for a in answers] == ["MISS", "HIT"]
    assert [a.headers.get_all("X-Request-ID") for a in answers] == [["1" * 32], ["2" * 32]]


def test_page_keeps_its_security_headers(proxy):
    answer = proxy.ask("/")
    assert answer.status == 200
    assert "default-src 'self'" in answer.headers["Content-Security-Policy"]
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert b"<html" in answer.body


def test_metrics_are_not_for_everyone(proxy):
    assert_problem(proxy.ask("/metrics"), 404)


def test_bodies_have_the_limits_of_the_service(proxy):
    too_long = b" " * (41 * 2**20)
    assert_problem(proxy.ask("/api/v1/collisions", "POST", too_long), 413)
    assert_problem(proxy.ask("/api/v1/scaling", "POST", too_long[: 3 * 2**20]), 413)
    within = proxy.ask("/api/v1/collisions", "POST", too_long[: 39 * 2**20])
    assert within.headers["Content-Type"] == "application/problem+json"
    assert within.status != 413


def test_what_is_no_http_is_refused_as_a_problem(proxy):
    with socket.create_connection(("127.0.0.1", proxy.port)) as client:
        client.sendall(b"nonsense\r\n\r\n")
        answer = client.recv(10_000)
    assert b"application/problem+json" in answer
    assert_problem(proxy.ask("/", X_Long="a" * 20_000), 431)
    assert_problem(proxy.ask(f"/{'a' * 20_000}"), 414)


def test_log_names_no_address_of_a_client():
    (log_format,) = re.findall(r"log_format.*?;", TEMPLATE, re.DOTALL)
    assert "$uri" in log_format
    assert not re.search(r"\$(remote|realip|proxy_protocol|http_|args|request_uri)", log_format)


BEGINNINGS = {
    "client_header_timeout": b"GET /api/v1/presets HTTP/1.1\r\nHost: a\r\nX-Slow: ",
    "client_body_timeout": (
        b"POST /api/v1/collisions HTTP/1.1\r\nHost: a\r\nContent-Length: 100\r\n\r\n{"
    ),
}
"""Limit → what a client sends that then says no more."""


def silent(proxy: Proxy, beginning: bytes) -> socket.socket:
    client = socket.create_connection(("127.0.0.1", proxy.port), timeout=LIMIT_SECONDS)
    client.sendall(beginning)
    return client


def test_slow_clients_hold_up_nobody(tmp_path, cluster):
    limits = dict.fromkeys(BEGINNINGS, "1h")
    with ExitStack() as stack:
        ports = [server.port for server in cluster.servers]
        proxy = stack.enter_context(nginx(tmp_path / "nginx", ports, **limits))
        for beginning in [*BEGINNINGS.values()] * 20:
            stack.enter_context(silent(proxy, beginning))
        assert [proxy.collide(20 + i).status for i in range(20)] == [200] * 20


@pytest.mark.parametrize("limit", every_day(["client_body_timeout"], of=BEGINNINGS))
def test_slow_clients_are_let_go(tmp_path, limit):
    (seconds,) = re.findall(rf"{limit} (\d+)s;", TEMPLATE)
    assert 5 <= int(seconds) <= 60
    limits = dict.fromkeys(BEGINNINGS, "1h") | {limit: "1s"}
    with (
        stub(200, {}) as server,
        nginx(tmp_path / "nginx", [server.port], **limits) as proxy,
        silent(proxy, BEGINNINGS[limit]) as client,
        suppress(ConnectionResetError),
    ):
        # until it is closed
        while client.recv(1000):
            pass


def test_connections_are_not_reused_when_the_server_may_be_closing_them():
    (upstream,) = re.findall(r"upstream servers \{.*?\n    \}\n", TEMPLATE, re.DOTALL)
    kept = int(re.search(r"keepalive_timeout (\d+)s;", upstream)[1])
    assert kept < inspect.signature(uvicorn.Config).parameters["timeout_keep_alive"].default


def test_saturated_server_is_passed_on(tmp_path):
    headers = {"Retry-After": "7", "Content-Type": "application/problem+json"}
    with stub(503, headers) as server, nginx(tmp_path / "nginx", [server.port]) as proxy:
        for _ in range(3):
            answer = proxy.collide(1)
            assert (answer.status, answer.body) == (503, b"{}")
            assert answer.headers["Retry-After"] == "7"


def test_more_requests_at_once_than_allowed_are_refused(tmp_path):
    with (
        stub(200, {}, held=True) as server,
        nginx(tmp_path / "nginx", [server.port], 2) as proxy,
        ThreadPoolExecutor(5) as pool,
    ):
        asked = [pool.submit(proxy.collide, i) for i in range(5)]
        for refused in islice(as_completed(asked), 3):
            assert_problem(refused.result(), 503)
        server.may_answer.set()
        assert sorted(one.result().status for one in asked) == [200, 200, 503, 503, 503]


def test_equal_requests_at_once_are_computed_once(tmp_path):
    headers = {"Cache-Control": "public, max-age=86400"}
    with (
        stub(200, headers, held=True) as server,
        nginx(tmp_path / "nginx", [server.port], proxy_cache_lock_timeout="1h") as proxy,
        ThreadPoolExecutor(8) as pool,
    ):
        asked = [pool.submit(proxy.collide, 1) for _ in range(8)]
        server.asked.acquire()
        # answered by nginx itself, and so after it has read the others
        for _ in range(50):
            assert proxy.ask("/metrics").status == 404
        server.may_answer.set()
        states = [one.result().headers["X-Cache-Status"] for one in asked]
    assert sorted(states) == ["HIT"] * 7 + ["MISS"]


def test_dead_server_is_not_noticed_and_two_are_reported(cluster):
    """The end of both servers, and so of this module."""
    proxy, servers = cluster
    known = proxy.collide(1)
    servers[0].process.kill()
    assert {proxy.collide(200 + i).status for i in range(30)} == {200}
    assert {proxy.post([2 + i]).status for i in range(10)} == {200}
    servers[1].process.kill()
    servers[1].process.wait()
    assert_problem(proxy.collide(300), 502)
    assert_problem(proxy.collide(301), 502)
    assert proxy.collide(1).body == known.body
