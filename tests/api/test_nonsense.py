"""Nonsense in queries and bodies: refused in words before any work, never a 5xx, never NaN."""

import itertools
import json

import pytest
from document import ALWAYS_ON, EVERY_SIXTH, OPERATIONS, parameters_of, query_of, sixth_of
from starlette.datastructures import QueryParams

from restitution.wire.bodies import read_collisions
from restitution.wire.queries import CollisionQuery
from restitution.wire.reading import read_query
from restitution.wire.refusals import RefusedParametersError
from work import calls_of

COLLISION = {"kappa": "18", "mu_over_alpha": "1.4", "gt_over_gn": "0.4"}
CALLS = {
    "/collision": COLLISION,
    "/trace": COLLISION,
    "/cut": {"along": "gt_over_gn", "kappa": "18", "mu_over_alpha": "1.4"},
    "/map": {"mu_over_alpha": "1.4"},
}
WORDLIKE = """NaN nan -nan Infinity -Infinity inf -inf 1e999 -1e999 1e99999999999 text κ ½ １８ ٣ 😀
١ 1,4 1.4.1 --1 0x10 0b1 1e e5 null true [1] {} 1;2 1/2 1+1j -1 -5e-324 -1e308 %00 ../"""
NOT_NUMBERS = [
    *WORDLIKE.split(),
    *("", " ", "1 2", "1\x002", "\x00", "'; DROP TABLE", "9" * 400, "9" * 5000),
    # Hebrew from right to left, a mark that turns what follows round
    *("\u05d0\u05d1", "\u202e18", "18\u0301", "\ufeff18"),
]
# what is nonsense elsewhere but in range here
MEANT = {
    ("floor", "-1"),
    ("floor", "-5e-324"),
    ("beta_0", "-1"),
    ("beta_0", "-5e-324"),
    *itertools.product(("kappa_count", "gt_over_gn_count", "psi_count"), ["9" * 400]),
}
GETS = [name for name in ALWAYS_ON if OPERATIONS[name][0] == "get"]
PAIRS = [(name, parameter) for name in GETS for parameter in parameters_of(name)]


def test_nonsense_is_tried_on_every_parameter_of_a_query():
    assert len(PAIRS) > 80
    assert {"kappa", "error", "region", "scene", "psi_scale", "rtol"} <= {name for _, name in PAIRS}


@EVERY_SIXTH
@pytest.mark.parametrize(("call", "name"), PAIRS)
def test_nonsense_is_refused_by_name_with_the_value_received(service, call, name, sixth):
    _, path, _ = OPERATIONS[call]
    for nonsense in sixth_of(NOT_NUMBERS, PAIRS.index((call, name)), sixth):
        if (name, nonsense) in MEANT:
            continue
        given = query_of(call) | {name: nonsense}
        response = service.affordable(
            lambda given=given: service.client.get(path, params={n: str(given[n]) for n in given})
        )
        listed = service.problem(response, 422)["errors"]
        errors = {e["parameter"]: e for e in listed}
        assert len(errors) == len(listed), nonsense
        # some forbid others, which are named beside them
        assert name in errors, nonsense
        assert errors.keys() <= given.keys(), nonsense
        value = errors[name]["value"]
        assert value == nonsense[: max(200, len(value))], nonsense


@pytest.mark.parametrize("value", ["-0.0", "-0", "0", "0e5", "-0e-999", "1e-999"])
@pytest.mark.parametrize("path", CALLS)
def test_zero_has_no_sign(service, path, value):
    given = {**CALLS[path], "mu_over_alpha": value, "damping": value}
    answer = service.answer(path, **given)
    assert set(flat(answer["epsilon_t"])) == {1.0}


def flat(values):
    if not isinstance(values, list):
        return [values]
    return [number for value in values for number in flat(value)]


@pytest.mark.parametrize("value", ["-0.0", "0", "1e-999", "-1e-999"])
def test_stiffness_of_zero_is_refused(service, value):
    assert service.wrong("/collision", **{**COLLISION, "kappa": value}).keys() == {"kappa"}


@pytest.mark.parametrize(
    "query", ["kappa=%ff", "%ff=1", "kappa=%ud800", "=", "&&&", "kappa", "kappa=%"]
)
@pytest.mark.parametrize("path", CALLS)
def test_broken_queries_are_refused(service, path, query):
    response = service.affordable(lambda: service.client.get(f"/api/v1{path}?{query}"))
    service.problem(response, 422)


def test_thousands_of_parameters_are_refused(service):
    query = "&".join(f"p{i}={i}" for i in range(5000))
    response = service.affordable(lambda: service.client.get(f"/api/v1/collision?{query}"))
    service.problem(response, 422)


def test_counts_beyond_any_machine_are_refused(service):
    grid = {"mu_over_alpha": 1, "kappa_count": 10**15, "gt_over_gn_count": 10**15}
    response = service.affordable(lambda: service.get("/map", **grid))
    service.problem(response, 413)


BODY = '{"kappa": %s, "mu_over_alpha": 1.4, "gt_over_gn": [0.1, 0.2]}'
VALUES = {
    "NaN": "NaN",
    "[18, NaN]": "NaN",
    "Infinity": "Infinity",
    "[18, -Infinity]": "-Infinity",
    "1e999": "Infinity",
    "[18, -1e999]": "-Infinity",
    "[1e400, 18]": "Infinity",
    "-1": -1,
    "[0, -0.0]": 0,
    "null": None,
    "true": True,
    '"18"': "18",
    '""': "",
    '"\\u0000"': "\x00",
    '"\\ud800"': "?",
    '"\\u221e"': "∞",
    "[[18, 18]]": "[18,18]",
    '[{"a": 1}, 18]': '{"a":1}',
}


@pytest.mark.parametrize(("text", "value"), VALUES.items())
def test_nonsense_in_a_body_is_refused_by_name(service, text, value):
    response = service.affordable(lambda: service.post((BODY % text).encode()))
    errors = service.problem(response, 422)["errors"]
    assert errors[0]["parameter"].startswith("kappa")
    assert errors[0]["value"] == value


@pytest.mark.parametrize("digits", [20, 309, 400, 4301, 10_000])
@pytest.mark.parametrize("inside", ["%s", "[%s, 18]"])
def test_huge_integers_are_answered_or_refused_by_name(service, digits, inside):
    body = BODY % (inside % ("9" * digits))
    response = service.affordable(lambda: service.post(body.encode()))
    if digits < 308:
        assert response.status_code == 200
    else:
        entry = service.problem(response, 422)["errors"][0]
        assert entry["parameter"].startswith("kappa")


@pytest.mark.parametrize("depth", [100, 500, 900, 1000, 1023, 1024, 1100, 2000, 100_000, 1_000_000])
@pytest.mark.parametrize(("opening", "closing"), [("[", "]"), ('{"a":', "}")])
@pytest.mark.parametrize(
    "template",
    ["%s", BODY, '{"kappa": 18, "x": %s}', '{"quantities": %s}', '{"tolerance": %s}',
     '{"kappa": {"dtype": "f8", "bdata": "", "shape": %s}}'],
)  # fmt: skip
def test_deep_bodies_are_refused(service, template, opening, closing, depth):
    body = template % (opening * depth + "1" + closing * depth)
    response = service.affordable(lambda: service.post(body.encode()))
    assert response.status_code in {400, 422}
    service.problem(response, response.status_code)


BODIES = {
    "a hundred thousand unknown keys": json.dumps({f"k{i}": i for i in range(100_000)}),
    "lone surrogate as a key": '{"\\ud800": 1}',
    "lone surrogate as a method": '{"method": "\\udfff"}',
    "null byte as a key": '{"\\u0000": 1}',
    "a long text": BODY % ('"' + "x" * 1_000_000 + '"'),
    "a long key": '{"' + "x" * 1_000_000 + '": 1}',
    "a long method": '{"method": "' + "x" * 1_000_000 + '"}',
    "a million texts": BODY % ("[" + ",".join(['"x"'] * 1_000_000) + "]"),
    "a million NaN": BODY % ("[" + ",".join(["NaN"] * 1_000_000) + "]"),
    "a million minus ones": BODY % ("[" + ",".join(["-1"] * 1_000_000) + "]"),
    "a million numbers in one": BODY % ("[[" + ",".join(["1"] * 1_000_000) + "]]"),
    "a million quantities": '{"quantities": [' + ",".join(['"x"'] * 1_000_000) + "]}",
    "a million letters of base 64": BODY % ('{"dtype":"f8","bdata":"' + "A" * 1_000_001 + '"}'),
    "every parameter an object": '{"kappa": {}, "mu_over_alpha": {}, "gt_over_gn": {}}',
}


@pytest.mark.parametrize("text", BODIES.values(), ids=BODIES)
def test_monstrous_bodies_are_refused(service, text):
    body = text.encode()
    response = service.affordable(lambda: service.post(body))
    service.problem(response, 422)
    # a refusal is for reading
    assert len(response.content) < 200_000


LONGER_AND_LONGER = {
    "unknown keys": lambda n: json.dumps({f"k{i}": i for i in range(n)}),
    "unknown quantities": lambda n: '{"quantities": [' + ",".join(['"x"'] * n) + "]}",
    "texts": lambda n: BODY % ("[" + ",".join(['"x"'] * n) + "]"),
    "negative numbers": lambda n: BODY % ("[" + ",".join(["-1"] * n) + "]"),
    "NaN": lambda n: BODY % ("[" + ",".join(["NaN"] * n) + "]"),
    "letters": lambda n: BODY % ('"' + "x" * n + '"'),
}


@pytest.mark.parametrize("text", LONGER_AND_LONGER.values(), ids=LONGER_AND_LONGER)
def test_refusing_a_body_takes_work_in_proportion_to_its_length(text):
    def refused(length):
        with pytest.raises(RefusedParametersError):
            read_collisions(text(length).encode())

    few, many = (calls_of(lambda n=n: refused(n)) for n in (4000, 8000))
    assert many <= 2.1 * few


def test_refusing_a_query_takes_work_in_proportion_to_its_length():
    def refused(count):
        text = "&".join(f"p{i}={i}" for i in range(count)).encode()
        with pytest.raises(RefusedParametersError):
            read_query(CollisionQuery, QueryParams(text).multi_items())

    few, many = (calls_of(lambda n=n: refused(n)) for n in (1000, 2000))
    assert many <= 2.1 * few
