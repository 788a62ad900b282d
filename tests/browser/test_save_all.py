"""All that is shown as one ZIP, for a lab report."""

import base64
import io
import json
import urllib.request
import zipfile
from pathlib import Path

import pytest
from explorer import collision_of, settle, strip_of, text, visit
from playwright.sync_api import Page, expect
from rest import rest

pytestmark = pytest.mark.browser

PANELS = ["result", "force", "velocity", "contact", "map", "cut"]


# A picture that does not decode is refused.
PICTURE_SIZE = """async ([name, base64]) => {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const type = name.endsWith("png") ? "image/png" : "image/svg+xml";
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([bytes], {type}));
  await image.decode();
  return [image.naturalWidth, image.naturalHeight];
}"""


def save_all(page: Page, folder: Path) -> zipfile.ZipFile:
    with page.expect_download() as download:
        page.get_by_test_id("save-all").click()
    assert download.value.suggested_filename.startswith("restitution-")
    file = folder / "all.zip"
    download.value.save_as(file)
    opened = zipfile.ZipFile(io.BytesIO(file.read_bytes()))
    assert opened.testzip() is None
    return opened


def kinds(names: list[str]) -> dict[str, list[str]]:
    """The panels that a ZIP has files of, by the kind of file."""
    found: dict[str, list[str]] = {"csv": [], "svg": [], "png": []}
    for name in names:
        what, _, kind = name.rpartition(".")
        if kind in found:
            found[kind].append(what.split("-")[1])
    return found


def test_all_that_is_shown_is_had_as_one_zip(used_tab: Page, server: str, tmp_path: Path):
    page = used_tab
    visit(page, "/?kappa=20&map=switches")
    settle(page, server)
    rest(page)
    opened = save_all(page, tmp_path)
    names = opened.namelist()
    pictures = PANELS[1:]
    assert kinds(names) == {"csv": PANELS, "svg": pictures, "png": pictures}
    for panel in PANELS:
        page.get_by_test_id(f"menu-{panel}").click()
        link = page.locator(f"#menu-{panel}").get_by_text("CSV + units", exact=True)
        address = f"{server}/{link.get_attribute('href')}"
        page.keyboard.press("Escape")
        name = next(n for n in names if n.startswith(f"restitution-{panel}") and "csv" in n)
        assert "kappa-20-" in name
        with urllib.request.urlopen(address) as answer:
            is_answer = opened.read(name) == answer.read()
        assert is_answer, name
    for name in (n for n in names if n.endswith((".svg", ".png"))):
        picture = base64.b64encode(opened.read(name)).decode()
        width, height = page.evaluate(PICTURE_SIZE, [name, picture])
        assert (width > 200, height > 150) == (True, True), name
    state = json.loads(opened.read("state.json"))
    link = opened.read("link.txt").decode().strip()
    assert state["link"] == link
    assert link in opened.read("README.txt").decode()
    assert state["parameters"]["kappa"] == {"symbol": "κ", "value": 20, "unit": "1"}
    epsilon_t = state["results"]["collision"]["epsilon_t"]
    assert (epsilon_t["symbol"], epsilon_t["unit"]) == ("ε_t", "1")
    assert float(f"{epsilon_t['value']:.4g}") == strip_of(page)["epsilon-t"]
    shown = strip_of(page)
    visit(page, "/?kappa=63")
    visit(page, link.removeprefix(server))
    settle(page, server)
    assert (collision_of(page)["kappa"], strip_of(page)) == (20, shown)
    expect(page.get_by_role("radio", name="switches")).to_be_checked()


def test_without_a_server_all_has_what_the_page_can_make(tab: Page, tmp_path: Path):
    rest(tab)
    tab.route("**/api/**", lambda route: route.abort())
    opened = save_all(tab, tmp_path)
    assert kinds(opened.namelist()) == {"csv": [], "svg": PANELS[1:], "png": PANELS[1:]}
    expect(tab.get_by_test_id("notice")).to_contain_text("tables of Result, Force, Velocity")
    assert text(tab, "notice") in opened.read("README.txt").decode()
    assert json.loads(opened.read("state.json"))["parameters"]["kappa"]["value"] == 63


@pytest.mark.verify
def test_nothing_is_had_of_what_the_lesson_covers(page: Page, tmp_path: Path):
    page.goto("/?scene=lesson&step=2")
    page.locator("[data-glass]").wait_for()
    rest(page)
    opened = save_all(page, tmp_path)
    assert opened.namelist() == ["README.txt", "link.txt", "state.json"]
    assert json.loads(opened.read("state.json"))["results"] == {}
