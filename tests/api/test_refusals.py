"""Refusals: RFC 9457 for every status, all that is wrong at once, in words a user can act on."""

import pytest

COLLISION = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
PATHS = ("/collision", "/trace", "/cut", "/map")


@pytest.mark.parametrize(
    "path", ["/nothing", "/collision/17", "/collisions/17", "/map.csv", "/../secret", "/%00", "/κ"]
)
def test_unknown_addresses_are_404(service, path):
    response = service.get(path)
    assert response.request.url.path in service.problem(response, 404)["detail"]


@pytest.mark.parametrize(
    "path", ["/nothing", "/static/nothing.js", "/healthz/x", "/api", "/api/v2"]
)
def test_unknown_addresses_outside_the_interface_are_404(service, path):
    service.problem(service.client.get(path), 404)


@pytest.mark.parametrize("method", ["POST", "PUT", "PATCH", "DELETE"])
@pytest.mark.parametrize("path", [*PATHS, "/presets"])
def test_other_verbs_are_405_with_those_allowed(service, path, method):
    response = service.client.request(method, "/api/v1" + path, params=COLLISION)
    detail = service.problem(response, 405)["detail"]
    assert method in detail
    assert "GET" in detail
    assert response.headers["allow"] == "GET"


@pytest.mark.parametrize("method", ["GET", "PUT", "PATCH", "DELETE"])
def test_collisions_takes_post_only(service, method):
    response = service.client.request(method, "/api/v1/collisions")
    service.problem(response, 405)
    assert response.headers["allow"] == "POST"


@pytest.mark.parametrize(
    "kind",
    [None, "", "text/plain", "application/x-www-form-urlencoded", "multipart/form-data", "κ",
     "application/json5", "json", "application/xml; charset=utf-8"],
)  # fmt: skip
def test_other_content_types_are_415(service, kind):
    kind = kind if kind is None else kind.encode()
    problem = service.problem(service.post(COLLISION, kind), 415)
    assert "application/json" in problem["detail"]


@pytest.mark.parametrize("kind", ["application/json; charset=utf-8", "Application/JSON"])
def test_content_type_may_have_parameters_and_capitals(service, kind):
    assert service.post(COLLISION, kind).status_code == 200


@pytest.mark.parametrize(
    "body",
    [b"", b"{", b'{"kappa": 18', b"nonsense", b"{'kappa': 18}", b'{"kappa": 18,}', b"\x00", b"\xff",
     b'{"kappa": 018}', b'{"kappa": .5}', b"// {}\n{}", b"{} {}", b"[1, 2]", b"17", b"null",
     b'"kappa"', b'{"kappa": "\x01"}', b'{"kappa\xff": 1}'],
)  # fmt: skip
def test_malformed_json_is_400(service, body):
    service.problem(service.post(body), 400)


def test_body_beyond_its_limit_is_413_with_the_limit(service):
    body = b'{"kappa": 18' + b" " * (40 * 2**20) + b"}"
    problem = service.problem(service.affordable(lambda: service.post(body)), 413)
    assert "40" in problem["detail"]


def test_large_body_below_its_limit_is_read(service):
    body = b'{"kappa": 18, "mu_over_alpha": 1, "gt_over_gn": 1' + b" " * (30 * 2**20) + b"}"
    assert service.affordable(lambda: service.post(body)).status_code == 200


@pytest.mark.parametrize(
    ("path", "missing"),
    [
        ("/collision", {"kappa", "mu_over_alpha", "gt_over_gn"}),
        ("/trace", {"kappa", "mu_over_alpha", "gt_over_gn"}),
        ("/cut", {"along", "mu_over_alpha"}),
        ("/map", {"mu_over_alpha"}),
    ],
)
def test_missing_parameters_are_all_named_with_null(service, path, missing):
    wrong = service.wrong(path)
    assert wrong.keys() == missing
    assert all(entry["value"] is None for entry in wrong.values())


def test_everything_wrong_is_named_at_once(service):
    wrong = service.wrong(
        "/trace?kappa=-1&kappa=-2&mu_over_alpha=abc&samples=1&colour=red&tolerance=2&method=guess"
        "&steps=1.5&integrator=&phase=2&rtol=1&floor=NaN&damping=-1&episode_limit=-1&quantities=x"
        "&format=xml&encoding=utf8"
    )
    assert wrong.keys() == {
        "kappa", "mu_over_alpha", "gt_over_gn", "samples", "colour", "tolerance", "method", "steps",
        "integrator", "phase", "rtol", "floor", "damping", "episode_limit", "quantities", "format",
        "encoding",
    }  # fmt: skip
    assert wrong["gt_over_gn"]["value"] is None
    assert wrong["floor"]["value"] == "NaN"
    assert wrong["steps"]["value"] == "1.5"


def test_wrong_ranges_and_wrong_values_are_named_at_once(service):
    wrong = service.wrong(
        "/cut", along="kappa", kappa=18, mu_over_alpha=-1, minimum=3, maximum=2, colour="red"
    )
    assert wrong.keys() == {"kappa", "gt_over_gn", "mu_over_alpha", "maximum", "colour"}


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("name", ["", "Kappa", "psi", "κ", "x" * 5000, "kappa ", "a.b", "\x00"])
def test_unknown_parameters_are_named(service, path, name):
    given = {"mu_over_alpha": "1.4", name: "1"}
    entry = service.wrong(path, **given)[name[:200]]
    assert entry["value"] == "1"


@pytest.mark.parametrize("path", PATHS)
def test_repeated_parameters_are_named_once_with_their_values(service, path):
    query = "?mu_over_alpha=1&mu_over_alpha=2&tolerance=1e-3&tolerance=1e-3"
    errors = service.refused(path + query)["errors"]
    repeated = [e for e in errors if e["parameter"] in {"mu_over_alpha", "tolerance"}]
    assert [e["parameter"] for e in repeated] == ["mu_over_alpha", "tolerance"]
    assert "1" in repeated[0]["value"]
    assert "2" in repeated[0]["value"]


def test_repeated_form_of_a_post_is_refused(service):
    response = service.post(COLLISION, path="/collisions?format=csv&format=csv")
    assert [e["parameter"] for e in service.problem(response, 422)["errors"]] == ["format"]


@pytest.mark.parametrize(
    ("path", "parameters", "words"),
    [
        ("/collision", {**COLLISION, "kappa": 0}, ["kappa", "> 0", "got 0"]),
        ("/collision", {**COLLISION, "gt_over_gn": "fast"}, ["gt_over_gn", "≥ 0", "fast"]),
        ("/collision", {"kappa": 1, "mu_over_alpha": 1}, ["gt_over_gn", "is missing"]),
        ("/collision", {**COLLISION, "damping": "1e31"}, ["damping", "1e31", "from 0 to 1e+30"]),
        ("/collision", {**COLLISION, "method": "guess"}, ["method", "guess", "exact", "stiff"]),
        ("/collision", {**COLLISION, "color": 1}, ["color", "no such parameter"]),
        ("/collision", {**COLLISION, "steps": 2}, ["steps", "4", "1,000,000", "got 2"]),
        ("/collision", {**COLLISION, "quantities": "epsilon"}, ["quantities", "sensitivity"]),
        ("/trace", {**COLLISION, "samples": 1}, ["samples", "2", "20,000"]),
        ("/cut", {"along": "psi", "mu_over_alpha": 1}, ["along", "psi", "gt_over_gn", "kappa"]),
        ("/cut", {"along": "kappa", "mu_over_alpha": 1}, ["gt_over_gn", "along"]),
        ("/cut", {"along": "kappa", "mu_over_alpha": 1, "gt_over_gn": 1, "minimum": 80},
         ["minimum", "80", "70"]),
        ("/map", {"mu_over_alpha": 1, "kappa_min": 0, "kappa_scale": "log"}, ["kappa_min", "> 0"]),
        ("/map", {"mu_over_alpha": 1, "gt_over_gn_min": 0, "gt_over_gn_scale": "log"},
         ["gt_over_gn_min", "log"]),
        ("/collision", {**COLLISION, "kappa": "0,5"}, ["> 0, with a decimal point, got 0,5"]),
    ],
    ids=str,
)  # fmt: skip
def test_detail_says_what_is_wrong_and_what_would_be_right(service, path, parameters, words):
    detail = service.refused(path, **parameters)["detail"]
    assert [word for word in words if word not in detail] == []
    # one sentence that can be shown as it is
    assert "<class" not in detail
    assert "pydantic" not in detail


@pytest.mark.parametrize(("kappa_count", "gt_over_gn_count"), [(4000, 2500), (1001, 1000)])
def test_too_large_maps_are_413_with_cost_and_limit(service, kappa_count, gt_over_gn_count):
    problem = service.affordable(
        lambda: service.get(
            "/map", mu_over_alpha=1, kappa_count=kappa_count, gt_over_gn_count=gt_over_gn_count
        )
    )
    detail = service.problem(problem, 413)["detail"]
    assert "1,000,000" in detail
    assert f"{kappa_count:,}" in detail


def test_map_at_the_limit_is_answered(service):
    grid = {"mu_over_alpha": 0, "kappa_count": 1000, "gt_over_gn_count": 1000}
    response = service.get("/map", **grid, quantities="epsilon_t", encoding="base64")
    assert response.status_code == 200
