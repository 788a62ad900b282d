"""What the service has at /guide, with a guide and without one."""

import base64
import hashlib

import pytest
from fastapi import FastAPI
from starlette.testclient import TestClient

from restitution.api import guide
from restitution.api.guide import add_guide

SCRIPT = "document.title = 1"
PAGE = f"<script>{SCRIPT}</script>" + 1000 * " "


def browser(folder, **options):
    app = FastAPI()
    add_guide(app, [folder / "nothing", folder / "guide"])
    return TestClient(app, headers={"Accept": "text/html,*/*;q=0.8"}, **options)


@pytest.fixture
def made(tmp_path):
    (tmp_path / "guide").mkdir()
    (tmp_path / "guide" / "index.html").write_text(PAGE)
    (tmp_path / "secret").write_text("")
    return browser(tmp_path)


def test_without_its_slash_it_is_found_whatever_the_path_before_it(tmp_path):
    answer = browser(tmp_path, follow_redirects=False).get("/guide")
    assert (answer.status_code, answer.headers["location"]) == (307, "guide/")


@pytest.mark.parametrize("path", ["/guide/", "/guide/model.html"])
def test_a_bare_checkout_says_how_to_make_it(tmp_path, path):
    answer = browser(tmp_path).get(path)
    assert answer.status_code == 404
    assert "<code>make docs</code>" in answer.text
    assert "unsafe-inline" not in answer.headers["content-security-policy"].partition("style")[0]
    problem = browser(tmp_path).get(path, headers={"Accept": "*/*"})
    assert problem.headers["content-type"] == "application/problem+json"
    assert "make docs" in problem.json()["detail"]
    assert {answer.headers["vary"], problem.headers["vary"]} == {"Accept"}


def test_it_is_there_as_soon_as_it_is_made(tmp_path):
    client = browser(tmp_path)
    assert client.get("/guide/").status_code == 404
    (tmp_path / "guide").mkdir()
    (tmp_path / "guide" / "index.html").write_text(PAGE)
    assert client.get("/guide/").text == PAGE


def test_the_script_that_is_in_it_may_run_and_no_other(made):
    policy = made.get("/guide/").headers["content-security-policy"]
    (scripts,) = [part for part in policy.split("; ") if part.startswith("script-src")]
    digest = base64.b64encode(hashlib.sha256(SCRIPT.encode()).digest()).decode()
    assert scripts == f"script-src 'self' 'sha256-{digest}'"
    assert "default-src 'none'" in policy


def test_nothing_beside_it_is_told(made):
    for path in ("/guide/..%2fsecret", "/guide/%2e%2e/secret", "/guide//secret"):
        assert made.get(path).status_code == 404


def test_a_client_that_has_a_page_is_told_so(made):
    tag = made.get("/guide/").headers["etag"]
    for known in (tag, tag.removesuffix('"') + '-gzip"'):
        again = made.get("/guide/", headers={"If-None-Match": known})
        assert (again.status_code, again.text) == (304, "")


def test_a_file_is_looked_through_for_scripts_once_while_it_is_the_same(
    made, tmp_path, monkeypatch
):
    looked, through = [], guide.policy
    monkeypatch.setattr(guide, "policy", lambda *given: looked.append(given) or through(*given))
    rules = {made.get("/guide/").headers["content-security-policy"] for _ in range(3)}
    assert (len(looked), len(rules)) == (1, 1)
    (tmp_path / "guide" / "index.html").write_text(PAGE.replace("= 1", "= 2"))
    assert made.get("/guide/").headers["content-security-policy"] not in rules
