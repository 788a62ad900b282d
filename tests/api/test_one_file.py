"""The page as one file: whole, small, the same each time, with nothing that is elsewhere."""

import base64
import gzip
import html.parser
import json
import re
import urllib.parse
from pathlib import Path

import brotli
import pytest
from click.testing import CliRunner
from starlette.testclient import TestClient

from restitution.api import one_file
from restitution.api.app import create_app
from restitution.api.page import PLOTLY
from restitution.api.settings import Settings
from restitution.cli import main

FRONTEND = Settings().frontend_directory

MOST_BYTES = 2_500_000
"""Compressed, as an LMS or a mail takes it."""


class Parts(html.parser.HTMLParser):
    """Elements with their attributes, and what stands in scripts and styles."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.texts = [], {}
        self._open = None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.elements.append((tag, given))
        self._open = given.get("id") or given.get("type") or tag
        self.texts.setdefault(self._open, "")

    handle_startendtag = handle_starttag

    def handle_endtag(self, _):
        self._open = None

    def handle_data(self, data):
        self.texts[self._open or ""] = self.texts.get(self._open or "", "") + data


@pytest.fixture(scope="module")
def text():
    return one_file.one_file(FRONTEND)


@pytest.fixture(scope="module")
def parts(text):
    return Parts(text)


@pytest.fixture(scope="module")
def modules(parts):
    """The source of each module by the name that others call it by."""
    addresses = json.loads(parts.texts["modules"])["imports"]
    kind = "data:text/javascript;charset=utf-8,"
    assert {address[: len(kind)] for address in addresses.values()} == {kind}
    return {name: urllib.parse.unquote(its[len(kind) :]) for name, its in addresses.items()}


def test_nothing_is_elsewhere(parts):
    led = [
        (tag, name, address)
        for tag, attributes in parts.elements
        for name, address in attributes.items()
        if name in {"src", "href", "srcset", "action", "poster"}
        and not address.startswith(("data:", "#"))
    ]
    # to the page itself, from a frame of it
    assert led == [("a", "href", "./")]
    for tag, attributes in parts.elements:
        sheet = attributes.get("href", "") if tag == "link" else ""
        assert "url(" not in re.sub(r'url\("data:', "", sheet)
    assert re.findall(r'url\((?!"data:)', parts.texts["style"]) == []


def test_policy_lets_nothing_be_asked_for(parts):
    policies = [given for tag, given in parts.elements if given.get("http-equiv")]
    (policy,) = policies
    assert policy["http-equiv"] == "Content-Security-Policy"
    rules = dict(rule.strip().split(" ", 1) for rule in policy["content"].split(";"))
    assert rules["default-src"] == "'none'"
    sources = {source for rule in rules.values() for source in rule.split()}
    assert sources == {"'none'", "'unsafe-inline'", "'wasm-unsafe-eval'", "data:", "blob:"}
    assert "blob:" not in rules["script-src"]
    # before anything that it is about
    tags = [tag for tag, _ in parts.elements]
    assert tags.index("meta") + 1 == [given for _, given in parts.elements].index(policy)


def test_every_module_is_there_and_calls_those_that_are(modules):
    names = {path.relative_to(FRONTEND).as_posix() for path in FRONTEND.rglob("*.js")}
    assert modules.keys() == names
    static = re.compile(r'^(?:import|} from|export .* from)\b.*"([^"]+)";', re.MULTILINE)
    comment = re.compile(r"/\*.*?\*/", re.DOTALL)
    called = {
        name
        for source in modules.values()
        for name in static.findall(source)
        + re.findall(r'\bimport\("([^"]+)"\)', comment.sub("", source))
    }
    assert called <= names
    assert len(called) > 150


def test_modules_are_as_they_were_but_for_the_names_of_others(modules):
    def unnamed(source):
        return re.sub(r'(from |import |import\()"[^"]+"|//# sourceURL.*\n', r"\1", source)

    for name, source in modules.items():
        assert unnamed(source) == unnamed((FRONTEND / name).read_text("utf-8")), name


def bare(sheet):
    """Return a style sheet without the addresses of its fonts."""
    return re.sub(r"url\([^)]*\)", "url()", sheet)


def test_every_style_sheet_is_there_in_its_place(parts):
    text = (FRONTEND / "index.html").read_text("utf-8")
    sheets = re.findall(r'rel="stylesheet"\s+href="static/([^"]+)"', text)
    inside = [
        parts.texts["style"],
        *(given["href"] for tag, given in parts.elements if given.get("rel") == "stylesheet"),
    ]
    whole = bare(urllib.parse.unquote("".join(inside)))
    for sheet in sheets:
        assert bare((FRONTEND / sheet).read_text("utf-8")) in whole, sheet
    later = [given for _, given in parts.elements if "data-comes-with" in given]
    assert later
    assert all("disabled" in given for given in later)


def test_plotly_and_kernel_are_whole(parts):
    assert parts.texts["plotly"] == PLOTLY.read_text("utf-8")
    kernel = json.loads(parts.texts["file"])["kernel"]
    assert base64.b64decode(kernel) == (FRONTEND / "kernel" / "kernel.wasm").read_bytes()


def test_words_of_every_language_and_presets_are_those_of_the_server(parts, service):
    contents = json.loads(parts.texts["file"])
    languages = {path.stem for path in (FRONTEND / "locales").glob("*.json")}
    assert contents["texts"].keys() == languages
    assert {each["id"] for each in contents["languages"]} == languages
    for language, texts in contents["texts"].items():
        answer = service.client.get(f"/?lang={language}").text
        first = json.loads(re.search(r'id="words">(.*?)</script>', answer)[1])
        assert texts["first"] == first["texts"]
        assert contents["languages"] == first["languages"]
        assert texts["later"] == service.client.get(f"/words/{language}").json()
    assert contents["presets"] == service.client.get("/api/v1/presets").json()["items"]


def test_what_a_server_alone_has_is_left_out(text, parts):
    assert "guide/" not in [given.get("href") for _, given in parts.elements]
    assert "<!-- served -->" not in text


def test_it_is_the_same_each_time_and_small_when_compressed(text):
    assert one_file.one_file(FRONTEND) == text
    sizes = [len(gzip.compress(text.encode())), len(brotli.compress(text.encode(), quality=5))]
    print(f"{len(text.encode()):,} bytes, {sizes[0]:,} by gzip, {sizes[1]:,} by brotli")
    assert max(sizes) <= MOST_BYTES


def test_command_writes_it_and_says_nothing(text, tmp_path):
    out = tmp_path / "restitution.html"
    done = CliRunner().invoke(main, ["page", "--out", str(out)])
    assert (done.exit_code, done.output) == (0, "")
    assert out.read_text("utf-8") == text


def test_command_writes_to_standard_output(text):
    assert CliRunner().invoke(main, ["page", "--out", "-"]).stdout == text


@pytest.mark.parametrize(
    ("out", "said"), [(".", "is a folder"), ("nowhere/page.html", "there is no folder nowhere")]
)
def test_command_refuses_what_is_no_file(out, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(main, ["page", "--out", out])
    assert done.exit_code == 2
    assert said in done.output
    assert list(tmp_path.iterdir()) == []


@pytest.fixture(scope="module")
def client():
    with TestClient(create_app()) as client:
        yield client


@pytest.mark.parametrize("encoding", ["br", "gzip", "identity"])
def test_server_hands_it_out_compressed_once_for_its_files(client, text, encoding, monkeypatch):
    def asked(**more):
        return client.get("/restitution.html", headers={"Accept-Encoding": encoding, **more})

    first = asked()
    assert (first.status_code, first.text) == (200, text)
    assert first.headers.get("content-encoding", "identity") == encoding
    assert first.headers["content-type"].startswith("text/html")
    assert first.headers["content-disposition"] == 'attachment; filename="restitution.html"'
    assert first.headers["vary"].lower().count("accept-encoding") == 1

    def refuse(_: Path):
        raise AssertionError("it was made before")

    monkeypatch.setattr(one_file, "one_file", refuse)
    assert asked().headers["etag"] == first.headers["etag"]
    again = asked(**{"If-None-Match": first.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")


def test_it_is_no_call_of_the_interface(client):
    assert "/restitution.html" not in client.get("/openapi.json").json()["paths"]
