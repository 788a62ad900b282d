"""Clients that are slow, silent, greedy or none: what a connection costs is bounded by itself."""

import concurrent.futures
import contextlib
import json
import re
import select
import socket
from pathlib import Path

import psutil
import pytest

from cases import every_day, left_to_verify
from restitution.api import connections
from restitution.api.admission import MOST_HELD
from servers import LONG, serving
from waiting import LIMIT_SECONDS, eventually

MEGABYTE = 2**20
MAY_TAKE = 20 * MEGABYTE

COLLISION = "/api/v1/collision?kappa=18&mu_over_alpha=1.4&gt_over_gn=0.4"
GET = "GET /healthz HTTP/1.1\r\nHost: x\r\n"
POST = "POST /api/v1/collisions HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
CHUNKED = POST + "Transfer-Encoding: chunked\r\n\r\n"
BODY = '{"kappa":[18],"mu_over_alpha":1.4,"gt_over_gn":0.4}'
WHOLE_POST = f"{POST}Content-Length: {len(BODY)}\r\n\r\n{BODY}"


def serving_well(folder, **limits):
    """Yield a server that has logged no error in the end."""
    named = {f"connections.{n}": value for n, value in limits.items()}
    with serving(folder, limits=named) as server:
        eventually(server.is_prepared)
        yield server
        assert not [event for event in server.events() if event["level"] == "error"]


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    yield from serving_well(tmp_path_factory.mktemp("server"))


@pytest.fixture(scope="module")
def hurried(tmp_path_factory):
    """One whose times are short, and which looks at them often."""
    times = {"LONGEST_WAIT": 0.5, "LONGEST_UPLOAD": 1, "LONGEST_PAUSE": 0.5, "ROUND": 0.05}
    yield from serving_well(tmp_path_factory.mktemp("hurried"), **times)


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    """One with room for 20 connections, as silent as they want."""
    few = {"MOST_CONNECTIONS": 20, "MADE_ROOM": 1, "LONGEST_WAIT": 3600}
    yield from serving_well(tmp_path_factory.mktemp("small"), **few)


def received(connection, answers=None) -> list[tuple[int, dict[str, str], bytes]]:
    """Return status, headers and body of what comes until the end, or of so many answers."""
    found = []
    with connection.makefile("rb") as file:
        while (answers is None or len(found) < answers) and (line := file.readline()):
            lines = iter(file.readline, b"\r\n")
            headers = dict(each.decode().strip().lower().split(": ", 1) for each in lines)
            body = file.read(int(headers.get("content-length", 0)))
            found.append((int(line.split()[1]), headers, body))
    return found


def exchange(server, text, answers=None):
    with server.send(text) as connection:
        return received(connection, answers)


def assert_refused(answer, status, words):
    found, headers, body = answer
    assert found == status
    assert headers["content-type"] == "application/problem+json"
    assert headers["connection"] == "close"
    assert headers["x-content-type-options"] == "nosniff"
    assert re.fullmatch("[0-9a-f]{32}", headers["x-request-id"])
    problem = json.loads(body)
    assert problem["status"] == status
    assert words in problem["detail"]


def is_well(server) -> bool:
    return server.get(COLLISION)[0] == 200


def open_connections(server) -> int:
    found = psutil.Process(server.process.pid).net_connections("tcp")
    return sum(each.status == psutil.CONN_ESTABLISHED for each in found)


@contextlib.contextmanager
def memory_bounded(server, most):
    process = Path(f"/proc/{server.process.pid}")
    (process / "clear_refs").write_text("5")
    before = psutil.Process(server.process.pid).memory_info().rss
    yield
    peak = 1024 * int((process / "status").read_text().partition("VmHWM:")[2].split()[0])
    assert peak < before + most


HEADS = {
    "short headers": (GET + "a:b\r\n" * (6 * MEGABYTE), 431, "headers"),
    "one header": (GET + "a:" + "b" * (30 * MEGABYTE), 431, "longer than 65,536 bytes"),
    "an address": ("GET /" + "a" * (30 * MEGABYTE), 431, "longer than 65,536 bytes"),
    "a head in one delivery": (GET + f"a: {'b' * 70_000}\r\n\r\n", 431, "longer than 65,536"),
    "more headers than a hundred": (GET + "a:b\r\n" * 100 + "\r\n", 431, "more than 100 headers"),
    "trailers": (CHUNKED + "0\r\n" + "a:b\r\n" * (6 * MEGABYTE), 431, "headers"),
    "one trailer": (CHUNKED + "0\r\na:" + "b" * (30 * MEGABYTE), 431, "longer than 65,536 bytes"),
    "what is said of a chunk": (CHUNKED + "2;" + "a" * (30 * MEGABYTE), 431, "longer than 65,536"),
    "chunks of one byte": (CHUNKED + "1\r\n \r\n" * 500_000, 400, "less than 64 bytes"),
}


# without end, too long in one part, and of too many parts, before a body and within it
EVERY_DAY = ["short headers", "one header", "more headers than a hundred", "chunks of one byte"]


@pytest.mark.parametrize("name", every_day(EVERY_DAY, of=HEADS))
def test_a_head_without_end_is_refused(server, name):
    text, status, words = HEADS[name]
    with memory_bounded(server, MAY_TAKE):
        (answer,) = exchange(server, text)
    assert_refused(answer, status, words)


def test_ten_heads_of_79_megabytes_at_once_take_little(server):
    block = b"a:b\r\n" * 200_000

    def sent(_):
        with server.send(GET) as connection:
            # a machine that is busy may not get it all out in the time that it is read
            with contextlib.suppress(ConnectionError):
                for _ in range(79):
                    connection.sendall(block)
            return received(connection)

    with memory_bounded(server, MAY_TAKE), concurrent.futures.ThreadPoolExecutor(10) as clients:
        found = [*clients.map(sent, range(10))]
    for (answer,) in found:
        assert_refused(answer, 431, "headers")


@pytest.mark.parametrize("part", [f"a: {'b' * 60_000}\r\n", "a:b\r\n" * 99])
def test_heads_up_to_the_limits_are_read(server, part):
    (answer,) = exchange(server, f"{GET}{part}\r\n", 1)
    assert answer[0] == 200


def test_a_head_after_a_large_body_counts_alone(server):
    spaces = " " * 200_000
    post = f"{POST}Content-Length: {len(BODY + spaces)}\r\n\r\n{BODY}{spaces}"
    with server.send(f"{post}{GET}\r\n{post}{GET}") as client:
        assert [status for status, _, _ in received(client, 3)] == [200] * 3
        client.sendall(b"\r\n")
        assert received(client, 1)[0][0] == 200


NO_REQUESTS = [
    "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",
    "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    "hello\r\n\r\n",
    "GET / HTTP/9.9\r\n\r\n",
    "GET /é HTTP/1.1\r\nHost: x\r\n\r\n",
    "GET http://[ HTTP/1.1\r\nHost: x\r\n\r\n",
    "CONNECT x:443 HTTP/1.1\r\nHost: x\r\n\r\n",
    GET + "Content-Length: 1\r\nContent-Length: 2\r\n\r\n",
    GET + "Content-Length: -1\r\n\r\n",
    GET + "Transfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\n",
    GET + "no colon\r\n\r\n",
    GET + "a\0b: c\r\n\r\n",
]


@pytest.mark.parametrize("text", NO_REQUESTS)
def test_what_is_no_request_is_told_so(server, text):
    (answer,) = exchange(server, text)
    assert_refused(answer, 400, "this is not an HTTP request")


@pytest.mark.parametrize("path", ["/docs/", "/api/v1/presets/", "//elsewhere.example/", "/static"])
def test_nobody_is_sent_to_where_host_says(server, path):
    (answer,) = exchange(server, f"GET {path} HTTP/1.1\r\nHost: elsewhere.example\r\n\r\n", 1)
    status, headers, body = answer
    assert status == 404
    assert "location" not in headers
    assert json.loads(body)["detail"] == f"there is nothing at {path}"


@pytest.mark.parametrize("head", [CHUNKED, f"{GET}Transfer-Encoding: chunked\r\n\r\n"])
def test_a_body_that_breaks_off_is_refused_once(server, head):
    (answer,) = exchange(server, f"{head}2\r\n{{}}\r\nnonsense\r\n")
    assert_refused(answer, 400, "this is not an HTTP request")


def test_pipelined_requests_are_answered_in_order(server):
    paths = [COLLISION.replace("=18", f"={kappa}") for kappa in (18, 63, 7, 400)]
    text = "".join(f"GET {path} HTTP/1.1\r\nHost: x\r\n\r\n" for path in paths)
    found = exchange(server, text, len(paths))
    assert [body for _, _, body in found] == [server.get(path)[2] for path in paths]


@pytest.mark.parametrize("end", ["nonsense\r\n\r\n", f"{CHUNKED}2\r\n{{}}\r\nnonsense\r\n"])
def test_who_is_refused_gets_the_answers_before(server, end):
    found = exchange(server, f"{WHOLE_POST}{GET}\r\n{end}")
    assert [status for status, _, _ in found[:2]] == [200, 200]
    assert_refused(found[2], 400, "this is not an HTTP request")
    assert len(found) == 3


def test_requests_that_do_not_wait_for_answers_are_bounded(server):
    found = exchange(server, WHOLE_POST + f"{GET}\r\n" * 5000)
    assert [status for status, _, _ in found[:-1]] == [200] * (1 + connections.MOST_PIPELINED)
    assert_refused(found[-1], 400, "more than 32 requests wait")


def test_a_client_that_asks_before_it_sends_is_told_to_go_on(server):
    with server.send(
        f"{POST}Expect: 100-continue\r\nContent-Length: {len(BODY)}\r\n\r\n"
    ) as client:
        assert received(client, 1)[0][0] == 100
        client.sendall(BODY.encode())
        ((status, headers, _),) = received(client, 1)
        assert status == 200
        assert "connection" not in headers
        # and the connection is kept
        client.sendall(f"{GET}\r\n".encode())
        assert received(client, 1)[0][0] == 200


def test_a_client_that_asks_before_it_sends_what_is_refused_is_let_go(server):
    head = POST.replace("application/json", "text/plain") + "Expect: 100-continue\r\n"
    (answer,) = exchange(server, f"{head}Content-Length: 100\r\n\r\n")
    assert (answer[0], answer[1]["connection"]) == (415, "close")


@pytest.mark.parametrize("other", ["websocket", "h2c"])
def test_other_protocols_are_not_spoken(server, other):
    (answer,) = exchange(server, f"{GET}Connection: Upgrade\r\nUpgrade: {other}\r\n\r\n")
    assert (answer[0], answer[1]["connection"]) == (200, "close")


def test_a_connection_goes_on_after_a_body_that_was_refused(server):
    head = POST.replace("application/json", "text/plain")
    with server.send(f"{head}Content-Length: {len(BODY)}\r\n\r\n") as client:
        assert received(client, 1)[0][0] == 415
        client.sendall(BODY.encode() + WHOLE_POST.encode())
        assert received(client, 1)[0][0] == 200


def test_a_body_that_nobody_asked_for_is_let_go(server):
    text = f"{GET}Content-Length: {41 * MEGABYTE}\r\n\r\n{' ' * 41 * MEGABYTE}"
    with memory_bounded(server, MAY_TAKE):
        assert exchange(server, text, 1)[0][0] == 200


def slowly(server, size):
    """Upload `size` bytes in chunks, all but the end; return the connection."""
    connection = server.send(CHUNKED)
    chunk = f"{MEGABYTE:x}\r\n{' ' * MEGABYTE}\r\n".encode()
    with contextlib.suppress(ConnectionError):
        for _ in range(size // MEGABYTE):
            connection.sendall(chunk)
    return connection


@pytest.mark.verify
def test_slow_uploads_without_a_length_are_held_within_bounds(server):
    with memory_bounded(server, 2 * MOST_HELD), contextlib.ExitStack() as stack:
        uploads = [stack.enter_context(slowly(server, 39 * MEGABYTE)) for _ in range(12)]
        # two of them fit in, and with the rest of a hundred the beginning of another
        for upload in uploads[2:]:
            assert received(upload, 1)[0][0] == 503
        assert is_well(server)
        assert exchange(server, WHOLE_POST, 1)[0][0] == 200
        for upload in uploads[:2]:
            upload.sendall(b"0\r\n\r\n")
            assert received(upload, 1)[0][0] == 400
    # nothing is held when all have gone
    with slowly(server, 39 * MEGABYTE) as upload:
        upload.sendall(b"0\r\n\r\n")
        assert received(upload, 1)[0][0] == 400


@pytest.mark.parametrize("text", ["", "\r\n\r\n"])
def test_a_silent_connection_is_closed(hurried, text):
    assert exchange(hurried, text) == []


def test_a_kept_connection_is_closed_whatever_stands_between_requests(hurried):
    with hurried.send(f"{GET}\r\n") as connection:
        assert received(connection, 1)[0][0] == 200
        connection.sendall(b"\r\n")
        assert received(connection) == []


def test_a_head_that_does_not_end_is_told_so(hurried):
    (answer,) = exchange(hurried, GET)
    assert_refused(answer, 408, "the head of the request took longer")


@pytest.mark.parametrize(
    "text",
    [
        left_to_verify(f"{POST}Content-Length: 100\r\n\r\n{{"),
        f"{CHUNKED}1\r\n{{\r\n",
    ],
)
def test_a_body_that_does_not_end_is_told_so(hurried, text):
    (answer,) = exchange(hurried, text)
    assert_refused(answer, 408, "the body took longer")
    assert exchange(hurried, WHOLE_POST, 1)[0][0] == 200


def test_a_body_that_nobody_waits_for_ends_the_connection(hurried):
    with hurried.send(f"{GET}Content-Length: 100\r\n\r\n ") as connection:
        assert received(connection, 1)[0][0] == 200
        assert received(connection) == []


@pytest.mark.verify
def test_time_of_the_server_is_not_the_clients(hurried):
    """A body behind a request that takes long is not read meanwhile."""
    spaces = " " * (4 * MEGABYTE)
    post = f"{POST}Content-Length: {len(BODY + spaces)}\r\n\r\n{BODY}{spaces}"
    longs = "".join(f"GET {LONG}&floor=0.{i} HTTP/1.1\r\nHost: x\r\n\r\n" for i in (1, 2))
    found = exchange(hurried, longs + post, 3)
    assert [status for status, _, _ in found] == [200] * 3


def test_who_takes_nothing_of_the_answer_is_cut_off(hurried):
    path = "/api/v1/map?mu_over_alpha=1&kappa_count=1000&gt_over_gn_count=300&format=csv"
    with socket.socket() as connection:
        # more than fits into both ends of it: some megabytes
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(LIMIT_SECONDS)
        connection.connect(("127.0.0.1", hurried.port))
        connection.sendall(f"GET {path} HTTP/1.1\r\nHost: x\r\n\r\n".encode())
        assert connection.recv(15) == b"HTTP/1.1 200 OK"

        def cut_off():
            assert open_connections(hurried) == 0

        eventually(cut_off)
    assert is_well(hurried)


def test_two_hundred_silent_connections_harm_nobody(server):
    with contextlib.ExitStack() as stack:
        for text in ("", GET):
            for _ in range(100):
                stack.enter_context(server.send(text))
        assert is_well(server)


def test_silent_connections_give_way_the_oldest_first(small):
    with contextlib.ExitStack() as stack:
        old = [stack.enter_context(small.send(text)) for text in ["", GET] * 8]
        assert is_well(small)
        young = [stack.enter_context(small.send(GET)) for _ in range(15)]
        assert is_well(small)

        def gave_way():
            assert len(select.select(old, [], [], 0)[0]) >= 12

        eventually(gave_way)
        for each in young:
            each.sendall(b"\r\n")
        assert [received(each, 1)[0][0] for each in young] == [200] * 15


def test_who_finds_all_connections_at_work_is_told_to_come_again(small):
    with contextlib.ExitStack() as stack:
        head = f"{POST}Expect: 100-continue\r\nContent-Length: 100\r\n\r\n"
        uploads = [stack.enter_context(small.send(head)) for _ in range(20)]
        assert [received(upload, 1)[0][0] for upload in uploads] == [100] * 20
        (answer,) = exchange(small, "")
        assert_refused(answer, 503, "more connections are open")
        assert int(answer[1]["retry-after"]) >= 1
        uploads.pop().close()

        def served():
            assert exchange(small, f"{GET}\r\n", 1)[0][0] == 200

        eventually(served)
    assert small.metric(r'restitution_requests_refused_total\{reason="saturated"\}') >= 1


def test_the_guide_states_the_limits():
    guide = (Path(__file__).parents[2] / "docs" / "deployment.md").read_text(encoding="utf-8")
    limits = dict(re.findall(r"^\| (.*?) \| (.*?) \|", guide, re.MULTILINE))
    seconds = "{:g} s".format
    expected = {
        "its head, or what is between pieces of its body": f"{connections.LONGEST_HEAD:,} bytes",
        "headers": str(connections.MOST_HEADERS),
        "time for its head": seconds(connections.LONGEST_WAIT),
        "time for all of it": seconds(connections.LONGEST_UPLOAD),
        "requests behind another one on their connection": str(connections.MOST_PIPELINED),
        "connections, in one process": str(connections.MOST_CONNECTIONS),
        "a connection without a request": seconds(connections.LONGEST_WAIT),
        "an answer of which nothing is taken": seconds(connections.LONGEST_PAUSE),
    }
    assert expected.items() <= limits.items()
