"""Requests that are made to cost: what they take before they are admitted is bounded."""

import concurrent.futures
import contextlib
import http.client
import itertools
import json
import random
import string
from pathlib import Path

import pytest

import restitution as rs
from restitution.api.admission import MOST_HELD
from restitution.api.calls import LONGEST_QUERY
from restitution.wire import parsing
from restitution.wire.refusals import MalformedBodyError, RefusedParametersError
from servers import serving
from waiting import eventually
from work import counted

MEGABYTE = 2**20

NAMES = ["".join(n) for k in (1, 2) for n in itertools.product(string.ascii_lowercase, repeat=k)]

LIST_OF_LISTS = b'{"kappa":[' + b"[]," * (12 * MEGABYTE) + b'[]],"mu_over_alpha":1,"gt_over_gn":1}'
NUMBERS = b"[" + b"1," * 999_999 + b"1]"
BODIES = {
    "lists in a list": ("collisions", LIST_OF_LISTS, 400, "lists and objects"),
    "objects in a list": (
        "collisions",
        b'{"kappa":[' + b"{}," * (12 * MEGABYTE) + b"{}]}",
        400,
        "lists and objects",
    ),
    "depth": ("collisions", b'{"kappa":' + b"[" * MEGABYTE, 400, "lists and objects"),
    "more than four lists": (
        "collisions",
        b'{"kappa":[' + b"1," * (5 * MEGABYTE) + b"1]}",
        413,
        "elements",
    ),
    "a list twice": (
        "collisions",
        b'{"kappa":' + NUMBERS + b',"kappa":' + NUMBERS + b',"mu_over_alpha":1,"gt_over_gn":1}',
        422,
        "kappa must be given once",
    ),
    "keys of objects in an impact": (
        "scaling",
        b'{"impact":' + b'{"a":' * 200_000 + b"1" + b"}" * 200_001,
        400,
        "lists and objects",
    ),
    "keys given twice, deep": (
        "scaling",
        b'{"impact":{' + b'"a":1,"a":2,' * 100_000 + b'"b":1}}',
        413,
        "elements",
    ),
}


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    with serving(tmp_path_factory.mktemp("server")) as server:
        eventually(server.is_prepared)
        yield server


def largest_resident(server) -> int:
    """Return the most memory that the server has had in RAM, in bytes."""
    status = Path(f"/proc/{server.process.pid}/status").read_text()
    return 1024 * int(status.partition("VmHWM:")[2].split()[0])


def post(server, call: str, body: bytes) -> tuple[int, bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", server.port)
    with contextlib.closing(connection):
        connection.request("POST", f"/api/v1/{call}", body, {"Content-Type": "application/json"})
        answer = connection.getresponse()
        return answer.status, answer.read()


@pytest.mark.parametrize("attack", ["names given twice", "names", "one name", "a long value"])
def test_a_query_that_nobody_means_is_refused_unread(server, attack):
    query = {
        "names given twice": "&".join(f"{n}&{n}" for n in NAMES * 20),
        "names": "&".join(f"{n}=1" for n in NAMES * 20),
        "one name": "kappa=1&" * 6000,
        "a long value": "kappa=" + "7" * 50_000,
    }[attack][:50_000]
    status, _, body = server.get(f"/api/v1/collision?{query}")
    assert status == 422
    assert b"query must be of at most 8,192 bytes" in body


def test_the_longest_query_that_is_read_is_refused_by_name(server):
    query = "&".join(f"{n}&{n}" for n in NAMES * 4)[:LONGEST_QUERY]
    status, _, body = server.get(f"/api/v1/collision?{query}")
    assert status == 422
    assert b"no such parameter" in body


@pytest.mark.parametrize("name", BODIES)
def test_a_body_that_would_become_much_larger_is_refused(server, name):
    call, body, status, words = BODIES[name]
    found, answer = post(server, call, body)
    assert found == status
    assert words in answer.decode()


def test_many_large_bodies_at_once_stay_within_bounds(server):
    """Ten at a time; those for which there is no room are sent away."""
    before = largest_resident(server)
    with concurrent.futures.ThreadPoolExecutor(10) as clients:
        found = [*clients.map(lambda _: _tried(server), range(20))]
    assert set(found) <= {400, 503, "cut off"}
    assert 400 in found
    assert largest_resident(server) < before + MOST_HELD + 3 * 40 * MEGABYTE
    # nothing is held when all have gone
    assert post(server, "collisions", LIST_OF_LISTS)[0] == 400


def _tried(server) -> int | str:
    try:
        return post(server, "collisions", LIST_OF_LISTS)[0]
    except ConnectionError:
        # refused while it was sending
        return "cut off"


def test_a_map_with_too_many_dampings_is_refused_before_any_is_prepared():
    steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
    contact = rs.Contact(steel, steel, 0.4, "mindlin", dissipative_constant_s=1e-6)
    with counted() as work, pytest.raises(rs.CostError, match="10,000 different values of damping"):
        contact.map(rs.Axis(1, 20, 10_000), rs.Axis(0, 10, 50))
    assert work.of_numbers == 0


def test_limits_let_everything_through_that_is_meant(server):
    lists = b",".join(
        b'"%s":%s' % (name, NUMBERS)
        for name in (b"kappa", b"mu_over_alpha", b"gt_over_gn", b"damping")
    )
    few = b'"quantities":["epsilon_t"],"tolerance":1e-2'
    status, answer = post(server, "collisions", b"{%s,%s}" % (lists, few))
    assert status in (200, 413)
    assert b"elements" not in answer[:300]


SCRAPS = [
    *('"kappa":', '"psi":', '"a', '"x"', '"', ":", "{", "}", "[", "]", ",", ",", " ", "\\"),
    *("1", "2.5", "-", "NaN", "1e400", "null", '"y":[1,2,3,4,5,6,7,8,9]', "[11,12,13,14,15,16]"),
]


def read_by(reader, body: bytes) -> str:
    try:
        return repr(reader(body))
    except MalformedBodyError as error:
        return f"malformed: {error}"
    except RefusedParametersError as error:
        return f"refused: {error}"


@pytest.mark.verify
def test_long_lists_are_read_in_pieces_as_they_are_in_one(monkeypatch):
    monkeypatch.setattr(parsing, "PIECE", 8)
    draw, read = random.Random(7), 0
    for _ in range(20_000):
        scraps = draw.choices(SCRAPS, k=draw.randint(1, 12))
        lists = {name: draw.choices([1, 2.5, None, 10**400], k=draw.randint(0, 9)) for name in "ab"}
        for text in ["{" + "".join(scraps) + "}", json.dumps(lists) + draw.choice(["", "]"])]:
            expected = read_by(parsing.parse_nested, text.encode())
            found = read_by(parsing.parse_lists, text.encode())
            # what is refused anyway may be refused for something else
            assert found == expected or expected.startswith("refused"), text
            read += found.startswith("{'")
    assert read > 5_000
