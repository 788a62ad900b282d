"""HTTP around an answer: entity tags, 304, lifetime, timing, and who may ask from a browser."""

import re

import pytest

COLLISION = {"kappa": "18", "mu_over_alpha": "1.4", "gt_over_gn": "0.4"}
CALLS = {
    "/collision": COLLISION,
    "/trace": COLLISION,
    "/cut": {"along": "kappa", "mu_over_alpha": "1.4", "gt_over_gn": "0.4"},
    "/map": {"mu_over_alpha": "1.4"},
}
DEFAULTS = {
    "/collision": {
        "damping": "0",
        "tolerance": "1e-10",
        "method": "auto",
        "steps": "50",
        "integrator": "velocity_verlet",
        "phase": "0",
        "rtol": "1e-9",
        "floor": "0",
        "episode_limit": "200",
        "format": "json",
    },
    "/trace": {"samples": "400", "episode_limit": "200", "tolerance": "0.0000000001"},
    "/cut": {
        "minimum": ".1",
        "maximum": "70",
        "count": "400",
        "scale": "linear",
        "quantities": "epsilon_t,switches",
    },
    "/map": {
        "kappa_min": ".1",
        "kappa_max": "70",
        "kappa_count": "200",
        "kappa_scale": "linear",
        "gt_over_gn_min": ".01",
        "gt_over_gn_max": "4",
        "gt_over_gn_count": "150",
        "gt_over_gn_scale": "linear",
        "quantities": "epsilon_t,switches",
    },
}
every_call = pytest.mark.parametrize(("path", "parameters"), CALLS.items(), ids=CALLS)


def tag(service, path, parameters, **more):
    response = service.get(path, **(parameters | more))
    assert response.status_code == 200, response.text
    return response.headers["etag"]


@every_call
def test_tag_is_strong(service, path, parameters):
    assert re.fullmatch(r'"[\x21\x23-\x7e]+"', tag(service, path, parameters))


@every_call
@pytest.mark.parametrize("friction", ["1.40", "14e-1", "+1.4", "1.4000000000000000000001"])
def test_tag_is_the_same_for_the_same_number(service, path, parameters, friction):
    assert tag(service, path, parameters, mu_over_alpha=friction) == tag(service, path, parameters)


@pytest.mark.parametrize("kappa", ["18.0", "1.8e1", "18.", "0018", "180E-1"])
def test_tag_is_the_same_for_the_same_whole_number(service, kappa):
    assert tag(service, "/collision", COLLISION, kappa=kappa) == tag(
        service, "/collision", COLLISION
    )


@pytest.mark.parametrize(
    ("path", "name", "value"),
    [(path, name, value) for path, more in DEFAULTS.items() for name, value in more.items()],
)
def test_tag_is_the_same_when_a_default_is_given(service, path, name, value):
    plain = tag(service, path, CALLS[path])
    assert tag(service, path, CALLS[path], **{name: value}) == plain


def test_tag_does_not_depend_on_the_order_of_parameters(service):
    backwards = dict(reversed(COLLISION.items()))
    assert tag(service, "/collision", backwards) == tag(service, "/collision", COLLISION)


def test_tags_differ_between_requests(service):
    changes = (
        {"kappa": "18.000000000000004"},
        {"method": "exact"},
        {"format": "csv"},
        {"format": "npz"},
        {"encoding": "base64"},
        {"episode_limit": "1"},
        {"quantities": "epsilon_t"},
        {"tolerance": "1e-9"},
    )
    tags = {tag(service, "/collision", COLLISION, **change) for change in ({}, *changes)}
    tags |= {tag(service, path, CALLS[path]) for path in ("/trace", "/cut", "/map")}
    assert len(tags) == 1 + len(changes) + 3


@every_call
def test_answers_are_public_for_a_day(service, path, parameters):
    control = service.get(path, **parameters).headers["cache-control"]
    assert control == "public, max-age=86400"


@every_call
def test_answer_says_how_long_it_took(service, path, parameters):
    timing = service.get(path, **parameters).headers["server-timing"]
    match = re.fullmatch(r"compute;dur=(\d+(\.\d+)?)", timing)
    assert match
    assert 0 <= float(match[1]) < 5000


def plain(tag):
    return tag.replace("-gzip", "")


def test_tags_of_compressed_and_other_bytes_differ_and_both_are_known(service):
    texts = {"Accept-Encoding": "gzip"}, {"Accept-Encoding": "identity"}
    packed, other = (service.get("/trace", h, **COLLISION) for h in texts)
    assert packed.headers["content-encoding"] == "gzip"
    assert "content-encoding" not in other.headers
    assert packed.headers["etag"] != other.headers["etag"] == plain(packed.headers["etag"])
    for response in (packed, other):
        again = service.get("/trace", {"If-None-Match": response.headers["etag"]}, **COLLISION)
        assert again.status_code == 304
        assert again.headers["etag"] == response.headers["etag"]


@every_call
@pytest.mark.parametrize(
    "form", ["{}", "W/{}", '"other", {}', '{}, "other"', '"other" , W/{} ', "*"]
)
def test_known_answers_are_not_sent_again(service, path, parameters, form):
    current = tag(service, path, parameters)
    response = service.get(path, {"If-None-Match": form.format(current)}, **parameters)
    assert response.status_code == 304
    assert response.content == b""
    # of compressed bytes the tag is another one, and "*" does not say which
    assert response.headers["etag"] in ({current, plain(current)} if form == "*" else {current})
    assert response.headers["cache-control"] == "public, max-age=86400"


@every_call
@pytest.mark.parametrize("form", ["{}x", '"other"', "", "nonsense", '"'])
def test_unknown_answers_are_sent(service, path, parameters, form):
    current = tag(service, path, parameters)
    response = service.get(path, {"If-None-Match": form.format(current)}, **parameters)
    assert response.status_code == 200
    assert response.content


def test_wrong_requests_are_refused_even_if_a_tag_is_known(service):
    response = service.get("/collision", {"If-None-Match": "*"}, kappa=-1)
    service.problem(response, 422)


def test_presets_are_cached_like_other_answers(service):
    response = service.get("/presets")
    assert response.headers["cache-control"] == "public, max-age=86400"
    again = service.get("/presets", {"If-None-Match": response.headers["etag"]})
    assert again.status_code == 304


def test_post_says_how_long_it_took(service):
    response = service.post({"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4})
    assert re.fullmatch(r"compute;dur=\d+(\.\d+)?", response.headers["server-timing"])


@every_call
@pytest.mark.parametrize("more", [{}, {"format": "csv"}, {"mu_over_alpha": "-1"}], ids=str)
def test_any_page_may_read_answers_and_refusals(service, path, parameters, more):
    response = service.get(path, {"Origin": "https://example.org"}, **(parameters | more))
    assert response.headers["access-control-allow-origin"] == "*"


def test_any_page_may_read_304(service):
    known = {
        "If-None-Match": tag(service, "/collision", COLLISION),
        "Origin": "https://example.org",
    }
    response = service.get("/collision", known, **COLLISION)
    assert response.status_code == 304
    assert response.headers["access-control-allow-origin"] == "*"


@pytest.mark.parametrize(("method", "path"), [("POST", "/collisions"), ("GET", "/trace")])
def test_any_page_may_ask_whether_it_may_ask(service, method, path):
    response = service.client.options(
        "/api/v1" + path,
        headers={
            "Origin": "https://example.org",
            "Access-Control-Request-Method": method,
            "Access-Control-Request-Headers": "content-type, if-none-match",
        },
    )
    assert response.status_code == 200
    assert response.headers["access-control-allow-origin"] == "*"
    assert method in response.headers["access-control-allow-methods"]
    allowed = response.headers["access-control-allow-headers"].lower()
    assert "content-type" in allowed
    assert "if-none-match" in allowed
