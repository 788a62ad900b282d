"""The page's files: who may load what, how small it comes over the wire, how long it is kept."""

import json
import os
import re

import brotli
import pytest
from starlette.testclient import TestClient

from restitution.api import page
from restitution.api.app import create_app
from restitution.api.settings import Settings


@pytest.fixture(scope="module")
def client():
    page.compress_page(Settings().frontend_directory)
    with TestClient(create_app()) as client:
        yield client


def test_page_loads_nothing_inline_and_nothing_from_elsewhere(client):
    answer = client.get("/")
    policy = answer.headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "script-src 'self' 'wasm-unsafe-eval';" in policy
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


def test_kernel_comes_compressed_as_what_a_browser_compiles_while_it_loads(client):
    answer = client.get("/static/kernel/kernel.wasm", headers={"Accept-Encoding": "br"})
    assert answer.headers["content-type"] == "application/wasm"
    assert answer.headers["content-encoding"] == "br"
    assert int(answer.headers["content-length"]) < 40_000


def test_answers_and_modules_come_compressed_to_those_who_can(client):
    kinds = {"/api/v1/map?mu_over_alpha=1.4": "gzip", "/static/main.js": "br"}
    for path, kind in kinds.items():
        packed = client.get(path, headers={"Accept-Encoding": "gzip, deflate, br"})
        assert packed.headers["content-encoding"] == kind, path
        bare = client.get(path, headers={"Accept-Encoding": "identity"})
        assert "content-encoding" not in bare.headers


@pytest.mark.parametrize(
    "path",
    ["/", "/words/de", "/static/main.js", "/restitution.html", "/api/v1/map?mu_over_alpha=1.4"],
)
@pytest.mark.parametrize(
    ("accepted", "kinds"),
    [
        ("br;q=0, gzip;q=0", {None}),
        ("gzip;q=0.0, brotli, zebra", {None}),
        ("gzip;Q=0.5, br; q=0.000", {"gzip", None}),
        ("BR, gzip;q=0", {"br", None}),
    ],
)
def test_nobody_gets_a_compression_that_was_refused(client, path, accepted, kinds):
    answer = client.get(path, headers={"Accept-Encoding": accepted})
    assert answer.status_code == 200
    assert answer.headers.get("content-encoding") in kinds
    # else a cache between would hand on what another client had
    assert "accept-encoding" in answer.headers["vary"].lower()
    assert answer.text


def test_files_without_a_version_are_asked_for_again_and_found_unchanged(client):
    first = client.get("/static/main.js")
    assert first.headers["cache-control"] == "no-cache"
    again = client.get("/static/main.js", headers={"If-None-Match": first.headers["etag"]})
    assert again.status_code == 304


def addresses(client):
    """Return what the page loads from the folder of its files."""
    return re.findall(r'(?:href|src)="(static/[^"]+)"', client.get("/").text)


def test_files_at_the_addresses_of_the_page_are_kept(client):
    found = addresses(client)
    assert len(found) > 100
    for address in found:
        answer = client.get(address)
        assert answer.status_code == 200, address
        assert "immutable" in answer.headers["cache-control"], address


def test_page_announces_its_modules_and_not_those_of_scenes_that_come_later(client):
    announced = re.findall(
        r'rel="modulepreload" href="static/\w{16}/([^"]+)"', client.get("/").text
    )
    assert announced == sorted(set(announced))
    assert "scenes/explorer/map.js" in announced
    later = {"main.js", "scenes/lesson/lesson.js", "scenes/spheres/scene.js"}
    assert not [name for name in announced if name in later]


def words(client, path="/", **headers):
    """Return the language that the page is in, and the words that are in it."""
    text = client.get(
        path, headers={name.replace("_", "-"): of for name, of in headers.items()}
    ).text
    language = re.search('<html lang="(.*?)">', text)[1]
    found = json.loads(re.search('type="application/json" id="words">(.*?)</script>', text)[1])
    assert found["language"] == language
    return language, found


@pytest.mark.parametrize(
    ("path", "accepted", "language"),
    [
        ("/", "", "en"),
        ("/?lang=de", "en-GB", "de"),
        ("/", "de-CH, en", "de"),
        ("/", "ja, DE;q=0.8, en;q=0.9", "en"),
        ("/", "en;q=0.3, de ; q=0.31", "de"),
        ("/", "de;q=0, ja", "en"),
        ("/?lang=ja", "de", "de"),
        ("/?lang=../main", ",;q=,de;q=x;;*", "de"),
    ],
)
def test_the_page_speaks_the_language_asked_for_else_the_best_of_the_browser(
    client, path, accepted, language
):
    assert words(client, path, accept_language=accepted)[0] == language
    assert "Accept-Language" in client.get(path).headers["vary"]


def test_what_a_language_lacks_is_said_in_english_and_no_word_is_markup(tmp_path):
    english = {"name": "English", "a": {"b": "deep", "c": "<b>"}, "d": "flat", "e": "left"}
    german = {"name": "Deutsch", "a": "ein Text", "d": {"of": "another shape"}, "e": "", "f": "neu"}
    (tmp_path / "locales").mkdir()
    for name, texts in {"en": english, "de": german}.items():
        (tmp_path / "locales" / f"{name}.json").write_text(json.dumps(texts))
    (tmp_path / "index.html").write_text('<html lang="en"><!-- words -->')
    (tmp_path / "main.js").write_text("")
    with TestClient(create_app(Settings(frontend_directory=tmp_path))) as client:
        assert "<b>" not in client.get("/").text
        _, found = words(client, "/?lang=de")
    assert found["texts"] == english | {"name": "Deutsch", "f": "neu"}
    assert found["languages"] == [{"id": "de", "name": "Deutsch"}, {"id": "en", "name": "English"}]


@pytest.mark.parametrize("language", ["en", "de", "fr", "es"])
def test_what_is_not_in_the_first_view_comes_with_words_of_its_own(client, language):
    whole = json.loads((Settings().frontend_directory / f"locales/{language}.json").read_text())
    first = words(client, f"/?lang={language}")[1]["texts"]
    later = client.get(f"/words/{language}").json()
    assert first | later == whole
    assert set(first) & set(later) == set()
    assert set(later) == set(page.LATER)


def test_words_of_a_language_that_is_not_there_are_the_usual_ones(client):
    assert client.get("/words/ja").json() == client.get("/words/en").json()


def test_the_first_view_says_nothing_that_comes_later():
    folder = Settings().frontend_directory
    modules = page._imported(folder / "main.js")
    # they name texts of their scene without saying them
    names = {folder / "state" / f"{name}.js" for name in ("lesson", "paper", "tradeoff-options")}
    parts = [*(modules - names), folder / "index.html", *folder.glob("scenes/explorer/**/*.html")]
    # what one file says of itself it has from the start
    later = set(page.LATER) - {"oneFile"}
    key = re.compile(rf"""["'`](?:{"|".join(later)})\.\w+""")
    found = {part.name: key.findall(part.read_text("utf-8")) for part in parts}
    assert {name: keys for name, keys in found.items() if keys} == {}


@pytest.mark.parametrize("path", ["/", "/words/de"])
def test_an_unchanged_page_is_not_sent_again(client, path):
    tag = client.get(path).headers["etag"]
    again = client.get(path, headers={"If-None-Match": tag})
    assert (again.status_code, again.content) == (304, b"")


def test_a_changed_file_has_a_new_address_and_is_not_kept_at_the_old_one(tmp_path):
    (tmp_path / "index.html").write_text('<script type="module" src="static/main.js"></script>')
    (tmp_path / "main.js").write_text('import "./a.js";\n')
    (tmp_path / "a.js").write_text("// old")
    with TestClient(create_app(Settings(frontend_directory=tmp_path))) as client:
        [old] = addresses(client)
        (tmp_path / "a.js").write_text("// new")
        stale = client.get(old.replace("main", "a"))
        assert (stale.text, stale.headers["cache-control"]) == ("// new", "no-cache")
        [new] = addresses(client)
        assert new != old
        assert "immutable" in client.get(new).headers["cache-control"]
        assert client.get(old).headers["cache-control"] == "no-cache"


def test_a_file_that_changed_since_it_was_compressed_comes_as_it_is_now(tmp_path):
    script = tmp_path / "script.js"
    script.write_text("// old")
    page.compress_page(tmp_path)
    script.write_text("// new, and longer than the old one")
    later = script.stat().st_mtime + 10
    os.utime(script, (later, later))
    with TestClient(create_app(Settings(frontend_directory=tmp_path))) as client:
        answer = client.get("/static/script.js", headers={"Accept-Encoding": "br"})
    assert answer.text == "// new, and longer than the old one"


def test_a_file_that_changed_between_two_starts_is_compressed_as_it_is_now(tmp_path, monkeypatch):
    monkeypatch.setattr(page, "_compressed", {})
    script = tmp_path / "script.js"
    for text in ("// old", "// new"):
        script.write_text(text)
        page._compressed.clear()
        page.compress_page(tmp_path)
    with TestClient(create_app(Settings(frontend_directory=tmp_path))) as client:
        answer = client.get("/static/script.js", headers={"Accept-Encoding": "br"})
    assert (answer.headers["content-encoding"], answer.text) == ("br", "// new")


@pytest.mark.parametrize(
    "path", ["/", "/static/main.js", "/assets/plotly.min.js", "/api/v1/presets", "/nothing"]
)
def test_head_tells_the_headers_of_get(client, path):
    told, whole = client.head(path), client.get(path)
    assert told.status_code == whole.status_code
    assert told.content == b""
    varying = {"date", "server-timing", "x-request-id", "content-length"}
    assert {n: v for n, v in told.headers.items() if n not in varying} == {
        n: v for n, v in whole.headers.items() if n not in varying
    }


@pytest.mark.parametrize(
    "path", ["/", "/static/main.js", "/api/v1/presets", "/nothing", "/healthz"]
)
def test_every_answer_guards_the_browser(client, path):
    headers = client.get(path).headers
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    assert "default-src" in headers["content-security-policy"]
