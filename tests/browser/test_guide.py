"""The guide as people see it: every page whole and quiet, with search, in both themes."""

import re
import subprocess
import sys
import urllib.parse
from pathlib import Path

import pytest
from explorer import Witness
from playwright.sync_api import Page, expect
from rest import rest

pytestmark = [pytest.mark.browser, pytest.mark.verify]

ROOT = Path(__file__).parents[2]
GUIDE = ROOT / "build" / "guide"


@pytest.fixture(scope="module", autouse=True)
def guide() -> Path:
    """The guide made anew, where `make docs` makes it and the server looks for it."""
    command = [sys.executable, ROOT / "deploy" / "make_guide.py", GUIDE]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return GUIDE


def test_every_page_is_whole_and_quiet_and_no_wider_than_a_phone(
    page: Page, server: str, guide: Path
):
    pages = sorted(file.name for file in guide.glob("*.html"))
    documents = {file.stem for file in (ROOT / "docs").glob("*.md")}
    assert documents < {name.removesuffix(".html") for name in pages}
    witness = Witness(page, server)
    bad: list[str] = []
    page.on("response", lambda r: r.status >= 400 and bad.append(f"{r.status} {r.url}"))
    page.set_viewport_size({"width": 360, "height": 740})
    for name in pages:
        page.goto(f"/guide/{name}")
        rest(page)
        assert page.evaluate("() => document.documentElement.scrollWidth") <= 360, name
    assert (witness.words, witness.strangers, bad) == ([], [], [])


def test_no_link_leads_nowhere(guide: Path):
    anchors = {
        file.name: set(re.findall(r'\bid="([^"]+)"', file.read_text()))
        for file in guide.glob("*.html")
    }
    for name in anchors:
        for link in re.findall(r'\b(?:href|src)="([^"]+)"', (guide / name).read_text()):
            address = urllib.parse.urlsplit(link)
            if address.scheme or address.netloc or link in ("../", "../docs"):
                continue
            # it may stand below any path
            assert not link.startswith("/"), (name, link)
            target = urllib.parse.unquote(address.path) or name
            assert (guide / target).is_file(), (name, link)
            if address.fragment and target in anchors:
                assert urllib.parse.unquote(address.fragment) in anchors[target] | {"top"}, (
                    name,
                    link,
                )


def test_reference_tells_bounds_symbols_and_units_that_no_docstring_says(guide: Path):
    text = re.sub(r"<[^>]+>", "", (guide / "reference.html").read_text())
    assert "radius_m, youngs_modulus_pafloat, finite and &gt; 0" in text
    assert re.search(r"maximum_normal_force_n\s*F_max: largest normal force in N", text)


def test_search_finds_a_name_a_word_and_a_symbol(page: Page, server: str):
    witness = Witness(page, server)
    for asked, found in [
        ("velocity map", "restitution.VelocityMap"),
        ("gear wheel", "The model"),
        ("κ", "What the numbers are worth"),
    ]:
        page.goto("/guide/")
        page.get_by_role("textbox", name="Search").fill(asked)
        page.keyboard.press("Enter")
        results = page.locator("#search-results .search")
        expect(results.get_by_role("link", name=found).first).to_be_visible()
        expect(page.get_by_text("Search finished")).to_be_visible()
    witness.assert_silence()


def test_theme_follows_the_system_and_is_chosen(page: Page):
    colour = "() => getComputedStyle(document.body).backgroundColor"
    page.emulate_media(color_scheme="light")
    page.goto("/guide/")
    light = page.evaluate(colour)
    page.emulate_media(color_scheme="dark")
    dark = page.evaluate(colour)
    assert (light, dark) == ("rgb(255, 254, 251)", "rgb(26, 30, 36)")
    toggle = page.locator(".content-icon-container .theme-toggle")
    toggle.click()
    assert page.evaluate(colour) == light
    page.evaluate("() => localStorage.clear()")


def test_symbols_are_set_in_the_type_of_the_page(page: Page):
    page.goto("/guide/model.html")
    rest(page)
    loaded = page.evaluate(
        "() => [...document.fonts].filter((f) => f.status === 'loaded').map((f) => f.family)"
    )
    assert '"Inter with STIX"' in loaded or "Inter with STIX" in loaded


def test_it_leads_to_the_explorer_and_back(page: Page, server: str):
    page.goto("/guide/model.html")
    page.get_by_role("link", name="Explorer").first.click()
    # whose address soon holds its state
    page.wait_for_url(re.compile(rf"{re.escape(server)}/(\?.*)?$"))
    page.get_by_role("link", name="Guide").click()
    page.wait_for_url(f"{server}/guide/")
