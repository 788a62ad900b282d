"""A corpus of extremes for every call of the OpenAPI document: answered or refused as described.

Whatever is said: within the budget, with a status of the document, and by its schemas. Who is
refused by which name is in test_nonsense.py, what extremes are answered in test_extremes.py.
"""

import codecs
import gzip
import json

import pytest
from document import (
    ALWAYS_ON,
    EVERY_SIXTH,
    OPERATIONS,
    RUNS,
    assert_described,
    body_of,
    parameters_of,
    query_of,
    sixth_of,
)

pytestmark = pytest.mark.usefixtures("few_steps")

HUGE = "1" + "0" * 400
DEEP = 100_000

NUMBERLIKE = """NaN inf -Infinity 1e999 -1e999 5e-324 -5e-324 2.2250738585072014e-308 -0.0 -0 0
1e-999 1e308 -1e308 1.7976931348623157e308 9007199254740993 1 2 0.5 +1 1_000 0x1p3 true null"""

IN_QUERIES = [
    *NUMBERLIKE.split(),
    *(HUGE, "-" + HUGE, "0." + "0" * 5000 + "1", "9" * 50_000),
    *("", " ", "\x00", "1\x00", "\r\n", "κ", "١٨", "𝟏", "\u202e1", "\u05d0", "e\u0301", "😀" * 50),
    *("epsilon_t,epsilon_t", "epsilon_t,,switches", ",", "epsilon_t" + ",epsilon_t" * 2000),
    *("json\n", "JSON", "csv,npz", "../../etc/passwd", "<script>", "%s%n", "${1+1}", "' OR 1=1 --"),
]

RAW_QUERIES = [
    *("=", "&", "&&&", ";", "?", "%", "%%", "%0", "%zz", "%00=%00", "a", "a=", "=b", "#"),
    # a lone surrogate, an overlong slash, the end of a two-byte letter, of no encoding at all
    *("kappa=%ed%a0%80", "kappa=%c0%af", "%c3=1", "%ff%fe=%ff", "kappa=%u0031"),
    *("kappa[]=1", "kappa[0]=1", "kappa.x=1", "__proto__=1", "constructor=1", "self=1", "format"),
    *("format=json&format=csv", "encoding=base64&encoding=base64", "kappa=1&kappa=1&kappa=2"),
    "x=1&" * 10_000,
    "k" * 50_000,
]

JSONLIKE = """NaN Infinity -Infinity 1e999 -1e999 5e-324 -5e-324 -0.0 0 -0 1e308 -1e308 1e-999
1.7976931348623157e308 9007199254740993 1 0.5 2.0 true false null [] {} [[]] [{}]"""

IN_BODIES = [
    *JSONLIKE.split(),
    *(HUGE, "-" + HUGE, "1" * 5000, "[" + HUGE + "]", "0." + "0" * 5000 + "1"),
    *('"NaN"', '"1"', '""', '"\\u0000"', '"\\ud800"', '"\\udfff\\ud800"', '"\\u202e\\u05d0"'),
    *('"mindlin"', '"solid"', '["epsilon_t", "epsilon_t"]', '["switches", 1]', '{"\\ud800": 1}'),
    *("[1, 2, 3]", "[NaN, 1, 1]", "[1e308, 1e308, 1e308]", "[5e-324, 0, 0]", "[1, [2], 3]"),
    *('{"dtype": "f8", "bdata": "AAAA"}', '{"dtype": "f8", "bdata": "AAAAAAAA8H8="}'),
    *('{"dtype": "f8", "bdata": "AAAAAAAA8D8=", "shape": "2"}', '{"dtype": "O", "bdata": ""}'),
    *('{"dtype": ">f8", "bdata": "P/AAAAAAAAA="}', '{"bdata": 1}', '{"shape": -1}', '"😀"'),
    *('{"min": 1, "max": 1}', '{"min": 5e-324, "max": 1e308, "count": 2}', '{"moment_kg_m2": 0}'),
    *("[" * DEEP + "]" * DEEP, '{"a":' * DEEP + "1" + "}" * DEEP, "[" + "1," * DEEP + "1]"),
    # about the depths at which readers of JSON give up
    *('{"a":' * depth + "1" + "}" * depth for depth in (700, 1000, 1100)),
]

KINDS = {
    "application/json; charset=utf-8": 200,
    "application/json;charset=UTF-8;q=1": 200,
    # JSON has one encoding, whatever is said of it
    "application/json; charset=utf-16": 200,
    "application/json; charset=nonsense": 200,
    "APPLICATION/JSON": 200,
    "text/json": 415,
    "application/json5": 415,
    "application/problem+json": 415,
    "application/json, text/plain": 415,
    "application/x-www-form-urlencoded": 415,
    "multipart/form-data; boundary=x": 415,
    "": 415,
    ";": 415,
}


POSTS = [name for name in ALWAYS_ON if body_of(name)]
every_post = pytest.mark.parametrize("name", POSTS)


def test_every_call_is_tried():
    assert set(POSTS) == {n for n, (_, _, o) in OPERATIONS.items() if "requestBody" in o}
    assert len(ALWAYS_ON) >= 14


def address(name):
    return OPERATIONS[name][1].replace("{name}", "1")


def asked(service, name, query, body=None, kind="application/json"):
    """Return the response to `query`, text or pairs, having held it against the document."""
    method, _, _ = OPERATIONS[name]
    content = json.dumps(body_of(name)).encode() if body is None and body_of(name) else body
    headers = {"Content-Type": kind.encode()} if content is not None else {}
    to = address(name)
    if isinstance(query, str):
        to, query = f"{to}?{query}", None
    response = service.affordable(
        lambda: service.client.request(
            method, to, params=query or None, content=content, headers=headers
        )
    )
    assert_described(name, response)
    return response


PAIRS = [(name, parameter) for name in OPERATIONS for parameter in parameters_of(name)]


@EVERY_SIXTH
@pytest.mark.parametrize(("name", "parameter"), PAIRS)
def test_extreme_parameters_are_answered_or_refused(service, name, parameter, sixth):
    example = {n: str(value) for n, value in query_of(name).items()}
    for value in sixth_of(IN_QUERIES, PAIRS.index((name, parameter)), sixth):
        asked(service, name, example | {parameter: value})


@EVERY_SIXTH
@pytest.mark.parametrize("name", OPERATIONS)
def test_extreme_queries_are_answered_or_refused(service, name, sixth):
    for query in sixth_of(RAW_QUERIES, [*OPERATIONS].index(name), sixth):
        example = "&".join(f"{n}={value}" for n, value in query_of(name).items())
        for whole in (query, f"{example}&{query}"):
            asked(service, name, whole)


@pytest.mark.parametrize("name", sorted(RUNS))
@pytest.mark.parametrize(
    "run", ["1", "%00", "%0d%0a", "κ", "%ff", "..%2f..", "a" * 5000, "%F0%9F%98%80"]
)
def test_extreme_names_of_runs_are_refused(service, name, run):
    method, path, _ = OPERATIONS[name]
    assert_described(name, service.client.request(method, path.replace("{name}", run)))


def leaves(value, path=()):
    """Return the paths to all members of an object, of objects within it and elements of lists."""
    inner = value.items() if isinstance(value, dict) else enumerate(value)
    found = []
    for key, item in inner:
        found.append((*path, key))
        if isinstance(item, dict | list):
            found += leaves(item, (*path, key))
    return found


def with_text(body, path, text):
    """Return the JSON of `body` with the member at `path` replaced by JSON that may be none."""
    holder = body
    for key in path[:-1]:
        holder = holder[key]
    holder[path[-1]] = "HERE"
    return json.dumps(body).replace('"HERE"', text, 1).encode()


PLACES = {
    f"{name}-{'.'.join(map(str, path))}": (name, path)
    for name in POSTS
    for path in leaves(body_of(name))
}
MEMBERS = {where: place for where, place in PLACES.items() if isinstance(place[1][-1], str)}
every_member = pytest.mark.parametrize(("name", "path"), MEMBERS.values(), ids=MEMBERS)


@EVERY_SIXTH
@pytest.mark.parametrize(("name", "path"), PLACES.values(), ids=PLACES)
def test_extreme_members_are_answered_or_refused(service, name, path, sixth):
    for text in sixth_of(IN_BODIES, [*PLACES.values()].index((name, path)), sixth):
        response = asked(service, name, {}, with_text(body_of(name), path, text))
        assert response.status_code in {200, 400, 413, 422}
        # a refusal is for reading
        assert response.status_code == 200 or len(response.content) < 100_000


@every_member
def test_members_given_twice_are_refused(service, name, path):
    text = f'1, "{path[-1]}": 1'
    assert asked(service, name, {}, with_text(body_of(name), path, text)).status_code == 422


@every_member
def test_unknown_members_are_refused(service, name, path):
    body = body_of(name)
    holder = body
    for key in path[:-1]:
        holder = holder[key]
    holder["κ\x00"] = 1
    errors = asked(service, name, {}, json.dumps(body).encode()).json()["errors"]
    assert any("κ\x00" in entry["parameter"] for entry in errors)


@every_post
def test_broken_bodies_are_refused(service, name):
    whole = json.dumps(body_of(name)).encode()
    broken = {
        "empty": b"",
        "white": b" \r\n\t",
        "of other encodings": json.dumps("κ", ensure_ascii=False).encode("utf-16"),
        "compressed": gzip.compress(whole),
        "twice": whole + whole,
        "trailing": whole + b"]",
        "a comment": whole + b"// end",
        "single quotes": whole.replace(b'"', b"'"),
        "null byte": whole + b"\x00",
        "not utf-8": whole.replace(b'"', b'"\xff', 1),
        "a cut letter": whole[:-1] + b', "\xc3": 1}',
        "half a surrogate pair, encoded": whole[:-1] + b', "\xed\xa0\x80": 1}',
        "a form": b"kappa=1&mu_over_alpha=1",
        "a list": b"[" + whole + b"]",
        "a number": b"3",
        "deep lists": b"[" * DEEP,
        "deep objects": b'{"a":' * DEEP,
    }
    broken |= {f"cut after {n}": whole[:n] for n in range(1, len(whole), 11)}
    for what, body in broken.items():
        assert asked(service, name, {}, body).status_code == 400, what


@every_post
@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32"])
def test_another_encoding_is_refused_by_its_name(service, name, encoding):
    answer = asked(service, name, {}, json.dumps(body_of(name)).encode(encoding))
    assert answer.status_code == 400
    assert answer.json()["detail"].endswith(f"must be JSON in UTF-8, this is {encoding.upper()}")


@every_post
def test_a_byte_order_mark_is_passed_over(service, name):
    text = json.dumps(body_of(name)).encode()
    marked, plain = (asked(service, name, {}, begin + text) for begin in (codecs.BOM_UTF8, b""))
    assert (marked.status_code, marked.content) == (200, plain.content)


@every_post
@pytest.mark.parametrize(("kind", "status"), KINDS.items())
def test_kinds_of_content_are_answered_or_refused(service, name, kind, status):
    assert asked(service, name, {}, kind=kind).status_code == status
