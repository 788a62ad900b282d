"""The page's own fonts: small, complete, there without a jolt, in every picture that is saved."""

import ast
import base64
import re
import subprocess
import sys
import urllib.error
import urllib.request
from pathlib import Path

import numpy as np
import pytest
from explorer import ACQUAINTED, Witness
from fontTools.ttLib import TTFont
from playwright.sync_api import Browser, Error, Page, Route
from rest import eventually, rest
from whole_page import PLACES, SCENES, open_scene

from cases import every_day

pytestmark = pytest.mark.browser

SOFT_HYPHEN = "\u00ad"
"""Not seen: where it parts a word, a hyphen is."""

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "frontend" / "fonts"
FONTS = sorted(FOLDER.glob("*.woff2"))
MOST_BYTES = 130_000
FAMILIES = {"Inter Variable", "STIX Two Text"}

# Where Plotly has put its words, and how wide they are.
WORDS = """() => [...document.querySelectorAll(".plot text")].map((text) => {
  const {x, y, width} = text.getBoundingClientRect();
  return [text.textContent, x, y, width];
})"""

# A font is asked for when a layout needs it.
FONTS_ARE_THERE = """async () => {
  document.body.getBoundingClientRect();
  await document.fonts.ready;
}"""

LENGTHS = """() => [...document.querySelectorAll("svg text")]
  .filter((text) => text.getComputedTextLength() > 0)
  .map((text) => [text.textContent, text.getComputedTextLength()])"""


def test_fonts_are_small_and_their_licences_are_with_them():
    sizes = {font.name: font.stat().st_size for font in FONTS}
    print(sizes)
    assert sum(sizes.values()) <= MOST_BYTES
    licences = [text.read_text() for text in FOLDER.glob("*.LICENSE")]
    for project in ("The Inter Project", "The STIX Fonts Project", "The Noto Project"):
        assert any(project in text and "SIL OPEN FONT LICENSE" in text for text in licences)


def letters_of_the_page() -> dict[str, str]:
    """Every character beyond ASCII that the page may show, with a file that it is from."""
    page = list((ROOT / "frontend").rglob("*"))
    texts = {
        file.name: file.read_text(encoding="utf-8")
        for file in page
        if file.suffix in {".html", ".js", ".json", ".css"}
    }
    for file in (ROOT / "backend").rglob("*.py"):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        documented = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
        docs = {
            node.body[0].value
            for node in ast.walk(tree)
            if isinstance(node, documented) and ast.get_docstring(node)
        }
        strings = (
            node.value
            for node in ast.walk(tree)
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in docs
        )
        texts[file.name] = "\n".join(strings)
    return {
        letter: name
        for name, text in texts.items()
        for letter in text
        if ord(letter) > 0x7E and letter != SOFT_HYPHEN
    }


@pytest.mark.verify
def test_the_fonts_have_every_character_that_the_page_may_show():
    known = set().union(*(TTFont(font).getBestCmap() for font in FONTS))
    shown = letters_of_the_page()
    # It would not do to look at nothing.
    assert {"κ", "⁻", "ä", "≳", "⬢", "↺"} <= shown.keys()
    assert {letter: name for letter, name in shown.items() if ord(letter) not in known} == {}
    for first, last in ((0xA0, 0x17F), (0x391, 0x3A1), (0x3A3, 0x3C9)):
        # A soft hyphen is not seen, and Unicode has withdrawn ŉ.
        assert set(range(first, last + 1)) - {0xAD, 0x149} <= known


def test_figures_are_all_of_one_width():
    for font in map(TTFont, FONTS):
        letters = font.getBestCmap()
        if ord("0") not in letters:
            continue
        widths = [font["hmtx"][letters[ord(digit)]][0] for digit in "0123456789"]
        # STIX's are 494 or 495 thousandths.
        assert max(widths) - min(widths) <= 0.001 * font["head"].unitsPerEm


@pytest.mark.verify
def test_make_fonts_writes_the_same_bytes_anew(tmp_path: Path):
    subprocess.run([sys.executable, ROOT / "deploy" / "make_fonts.py", tmp_path], check=True)
    written = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    made = (file for file in FOLDER.iterdir() if file.suffix != ".md")
    assert written == {file.name: file.read_bytes() for file in made}


@pytest.mark.parametrize("font", FONTS, ids=lambda font: font.name)
def test_fonts_are_served_once(server: str, font: Path):
    address = f"{server}/static/fonts/{font.name}"
    with urllib.request.urlopen(address) as answer:
        assert answer.headers["Content-Type"] == "font/woff2"
        assert "Content-Encoding" not in answer.headers
        assert answer.read() == font.read_bytes()
        known = urllib.request.Request(address, headers={"If-None-Match": answer.headers["ETag"]})
    with pytest.raises(urllib.error.HTTPError, match="304"):
        urllib.request.urlopen(known)


# Whatever shows words of its own.
MARK_WORDS = """() => {
  const isSaid = (element, part) => /["'].+["']/.test(getComputedStyle(element, part).content);
  for (const element of document.body.querySelectorAll("*")) {
    const texts = [...element.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE);
    const speaks = texts.some((text) => text.data.trim() !== "")
      || isSaid(element, "::before") || isSaid(element, "::after");
    element.toggleAttribute("data-speaks", speaks && element.checkVisibility());
  }
}"""


@pytest.mark.own_page
@pytest.mark.parametrize("scene", every_day(["explorer"], of=SCENES))
def test_no_letter_of_the_page_is_from_another_font(page: Page, server: str, scene: str):
    open_scene(page, server, SCENES[scene])
    if scene == "hand-out":
        page.emulate_media(media="print")
    rest(page)
    page.evaluate(MARK_WORDS)
    devtools = page.context.new_cdp_session(page)
    devtools.send("DOM.enable")
    devtools.send("CSS.enable")
    root = devtools.send("DOM.getDocument")["root"]["nodeId"]
    speaking = {"nodeId": root, "selector": "[data-speaks]"}
    nodes = devtools.send("DOM.querySelectorAll", speaking)["nodeIds"]
    assert len(nodes) > 50
    strangers = {}
    used = set()
    for node in nodes:
        try:
            fonts = devtools.send("CSS.getPlatformFontsForNode", {"nodeId": node})["fonts"]
        except Error:
            # gone meanwhile
            continue
        used |= {font["familyName"] for font in fonts}
        if not all(font["isCustomFont"] for font in fonts):
            html = devtools.send("DOM.getOuterHTML", {"nodeId": node})["outerHTML"]
            strangers[html[:200]] = [font["familyName"] for font in fonts]
    assert strangers == {}
    assert used == FAMILIES


def held(page: Page) -> list[Route]:
    """The answers with fonts that are held back, as the page asks for them."""
    routes: list[Route] = []
    page.route("**/fonts/*", lambda route: routes.append(route))  # noqa: PLW0108 - it is given attributes
    return routes


@pytest.mark.parametrize("width", every_day([1440], of=[390, 1440]))
def test_a_font_that_comes_late_moves_nothing_and_is_measured_anew(
    browser: Browser, page: Page, server: str, width: int
):
    size = {"width": width, "height": 900}
    # Pictures that stand still: where their words are is compared.
    options = {"base_url": server, "viewport": size, "reduced_motion": "reduce"}
    with browser.new_context(**options) as context:
        late = context.new_page()
        late.add_init_script(ACQUAINTED)
        witness = Witness(late, server)
        routes = held(late)
        late.goto("/", wait_until="domcontentloaded")

        def is_drawn() -> None:
            assert len(late.evaluate(WORDS)) > 20
            assert late.get_by_test_id("epsilon-t").inner_text() != "–"

        eventually(is_drawn, late)
        before, places = late.evaluate(WORDS), late.evaluate(PLACES)
        assert len(routes) == late.locator("link[as=font]").count() == 2
        for route in routes:
            route.continue_()
        page.set_viewport_size(size)
        open_scene(page, server, "")
        words = page.evaluate(WORDS)

        def is_redrawn() -> None:
            now = late.evaluate(WORDS)
            assert [word for word, *_ in now] == [word for word, *_ in words]
            lengths = [[length for _, *length in of] for of in (now, words)]
            np.testing.assert_allclose(*lengths, atol=0.1)

        eventually(is_redrawn, late)
        assert before != late.evaluate(WORDS)
        for part, place in late.evaluate(PLACES).items():
            np.testing.assert_allclose(place, places[part], atol=1, err_msg=part)
        witness.assert_silence()


PICTURES = {"force": "", "map": "", "contact": "", "tradeoff": "scene=accuracy"}


def saved(page: Page, panel: str, form: str, folder: Path) -> bytes:
    page.get_by_test_id(f"menu-{panel}").click()
    with page.expect_download() as download:
        page.locator(f"#menu-{panel}").get_by_text(form, exact=True).click()
    download.value.save_as(folder / f"{panel}.{form}")
    return (folder / f"{panel}.{form}").read_bytes()


def alone(browser: Browser, svg: str) -> Page:
    """A page that holds nothing but a picture."""
    page = browser.new_page(device_scale_factor=3)
    page.set_content(f"<body style='margin: 0'>{svg}</body>")
    page.evaluate(FONTS_ARE_THERE)
    return page


@pytest.mark.parametrize("panel", every_day(["contact"], of=PICTURES))
def test_saved_pictures_bring_their_fonts(
    browser: Browser, page: Page, server: str, panel: str, tmp_path: Path
):
    open_scene(page, server, PICTURES[panel])
    svg = saved(page, panel, "SVG", tmp_path).decode()
    bare = re.sub(r"<style>.*?</style>", "", svg)
    assert svg.count("@font-face") >= 2
    # On the page itself, which has the fonts, they change nothing; elsewhere they do.
    page.evaluate("(svg) => { document.body.innerHTML = svg; }", bare)
    page.evaluate(FONTS_ARE_THERE)
    there = page.evaluate(LENGTHS)
    drawn, without = alone(browser, svg), alone(browser, bare)
    lengths = [drawn.evaluate(LENGTHS), without.evaluate(LENGTHS)]
    assert [text for text, _ in lengths[0]] == [text for text, _ in there]
    on_page, of_own, of_others = (
        np.array([length for _, length in each]) for each in (there, *lengths)
    )
    np.testing.assert_allclose(of_own, on_page, rtol=1e-4, atol=0.02)
    assert np.abs(of_others / on_page - 1).max() > 0.02
    drawn.close()
    without.close()


# The share of pixels by which a bitmap differs from the picture in a page of its own.
DIFFERENCE = """async ([one, other]) => {
  const pixels = async (address) => {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const pen = canvas.getContext("2d");
    pen.drawImage(image, 0, 0);
    // of the title; the last column of an element whose width is broken may be lacking
    return pen.getImageData(0, 0, 900, 90).data;
  };
  const [a, b] = [await pixels(one), await pixels(other)];
  return a.reduce((sum, value, i) => sum + (Math.abs(value - b[i]) > 64 ? 1 : 0), 0) / a.length;
}"""


@pytest.mark.verify
@pytest.mark.parametrize("panel", ["force", "contact"])
def test_saved_bitmaps_are_set_in_the_same_fonts(
    browser: Browser, page: Page, server: str, panel: str, tmp_path: Path
):
    open_scene(page, server, PICTURES[panel])
    svg = saved(page, panel, "SVG", tmp_path).decode()
    png = saved(page, panel, "PNG", tmp_path)
    shares = []
    for picture in (svg, re.sub(r"<style>.*?</style>", "", svg)):
        drawn = alone(browser, picture)
        shot = drawn.locator("svg").first.screenshot()
        addresses = [f"data:image/png;base64,{encoded(image)}" for image in (png, shot)]
        shares.append(drawn.evaluate(DIFFERENCE, addresses))
        drawn.close()
    own, others = shares
    print(f"{panel}: {own:.5f} of the title's pixels differ, {others:.5f} without fonts")
    assert own < 0.1 * others


def encoded(image: bytes) -> str:
    return base64.b64encode(image).decode()
