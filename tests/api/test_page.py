"""The page's files: who may load what, how small it comes over the wire, how long it is kept."""

import brotli
import pytest
from starlette.testclient import TestClient

from restitution.api import page
from restitution.api.app import create_app


@pytest.fixture(scope="module")
def client():
    page.compress_plotly()
    with TestClient(create_app()) as client:
        yield client


def test_page_loads_nothing_inline_and_nothing_from_elsewhere(client):
    answer = client.get("/")
    policy = answer.headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "script-src" not in policy
    assert "unsafe-eval" not in policy
    assert "<script>" not in answer.text
    assert "style=" not in answer.text


def test_page_may_be_framed_by_a_course(client):
    headers = client.get("/").headers
    assert "frame-ancestors" not in headers["content-security-policy"]
    assert "x-frame-options" not in headers


def test_plotly_comes_compressed_and_whole(client):
    packed = client.get("/assets/plotly.min.js", headers={"Accept-Encoding": "br"})
    assert packed.headers["content-encoding"] == "br"
    assert int(packed.headers["content-length"]) < 1_200_000
    plain = client.get("/assets/plotly.min.js", headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.headers
    body = packed.content
    # the client may have unpacked it already
    assert plain.content in (body, body if len(body) > 2e6 else brotli.decompress(body))
    assert packed.headers["vary"].lower().count("accept-encoding") == 1


def test_answers_and_modules_come_compressed_to_those_who_can(client):
    for path in ("/api/v1/map?mu_over_alpha=1.4", "/static/main.js"):
        assert client.get(path).headers["content-encoding"] == "gzip", path
        bare = client.get(path, headers={"Accept-Encoding": "identity"})
        assert "content-encoding" not in bare.headers


def test_modules_are_asked_for_again_and_found_unchanged(client):
    first = client.get("/static/main.js")
    assert first.headers["cache-control"] == "no-cache"
    again = client.get("/static/main.js", headers={"If-None-Match": first.headers["etag"]})
    assert again.status_code == 304
