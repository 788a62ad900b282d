"""On a projector: large type, two pictures, controls that fade, and a clicker's keys."""

import re

import pytest
from explorer import FADE, settle, visit
from lesson import Texts, says
from playwright.sync_api import Page, expect
from rest import eventually, rest
from test_access import objections

from cases import every_day

pytestmark = pytest.mark.browser

PROJECTOR = {"width": 1280, "height": 720}
STATES = {
    "bounce and map": "",
    "force and cut": "left=force&right=cut",
    "velocity": "left=velocity&right=velocity&energy=shown",
    "switches": "left=map&right=force&map=switches",
}

# How large each text is as it is seen, in pixels; an index is part of a symbol.
SIZES = """() => {
  const least = {};
  for (const e of document.querySelectorAll("body *")) {
    const isText = [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim());
    const isSeen = e.checkVisibility({visibilityProperty: true, opacityProperty: true});
    if (!isText || !isSeen || e.closest("sub, sup, .index, .unseen, .skip, option")) continue;
    const drawing = e.closest(".bounce-stage");
    const drawn = drawing?.querySelector("svg").viewBox.baseVal.width;
    const scale = drawing ? drawing.clientWidth / drawn : 1;
    const size = scale * parseFloat(getComputedStyle(e).fontSize);
    const isNumber = /^[\\d.,×−^ a-p]*$/.test(e.textContent.trim());
    const kind = e.closest("svg, .bounce-ribbon") && isNumber ? "numbers" : "words";
    if (!e.matches("tspan[style*='70%']"))
      least[kind] = Math.min(least[kind] ?? 99, size);
  }
  return least;
}"""


def present(page: Page, query: str = "") -> None:
    page.set_viewport_size(PROJECTOR)
    visit(page, f"/?presenting=on&{query}")
    expect(page.locator(":root[data-presenting]")).to_have_count(1)
    page.evaluate(FADE)
    rest(page)


@pytest.mark.parametrize("state", every_day(["force and cut"], of=STATES))
def test_type_can_be_read_from_the_last_row(used_tab: Page, state: str):
    present(used_tab, STATES[state])
    sizes = used_tab.evaluate(SIZES)
    print(f"{state}: {sizes}")
    assert sizes["words"] >= 20
    assert sizes["numbers"] >= 16
    room = used_tab.evaluate("() => [document.body.scrollWidth, document.body.scrollHeight]")
    assert room == [1280, 720]


def test_the_pictures_are_those_picked_and_stand_in_the_address(used_tab: Page):
    present(used_tab)
    shown = used_tab.locator("[data-picked]").filter(visible=True)
    expect(shown).to_have_count(2)
    used_tab.get_by_test_id("presenting-right").select_option("velocity")
    expect(used_tab.get_by_test_id("velocity")).to_be_visible()
    expect(used_tab.get_by_test_id("map")).to_be_hidden()
    expect(used_tab).to_have_url(re.compile("presenting=on&right=velocity"))
    used_tab.get_by_test_id("presenting-left").select_option("velocity")
    expect(shown).to_have_count(1)
    assert shown.bounding_box()["width"] > 1200


def test_a_key_begins_and_ends_it(tab: Page):
    tab.keyboard.press("p")
    expect(tab.get_by_test_id("presenting-tools")).to_be_visible()
    tab.keyboard.press("Escape")
    expect(tab.get_by_test_id("presenting-tools")).to_be_hidden()
    expect(tab.locator(".masthead")).to_be_visible()
    assert "presenting" not in tab.url
    tab.get_by_test_id("kappa-field").press("p")
    expect(tab.locator(":root[data-presenting]")).to_have_count(0)


def test_a_clicker_walks_the_lesson_and_uncovers_what_is_covered(used_tab: Page):
    texts = Texts("en")
    present(used_tab, "scene=lesson&step=1&lang=en")
    used_tab.keyboard.press("PageDown")
    says(used_tab, "lesson-title", texts.step("stop", "title"))
    expect(used_tab.locator(":root[data-glass]")).to_have_count(1)
    used_tab.keyboard.press("PageDown")
    expect(used_tab.locator(":root[data-glass]")).to_have_count(0)
    says(used_tab, "lesson-title", texts.step("stop", "title"))
    used_tab.keyboard.press("PageDown")
    says(used_tab, "lesson-title", texts.step("reversal", "title"))
    used_tab.keyboard.press("PageUp")
    says(used_tab, "lesson-title", texts.step("stop", "title"))


@pytest.mark.verify
def test_a_clicker_walks_the_presets(used_tab: Page, server: str):
    present(used_tab)
    presets = used_tab.locator("[data-preset]")
    expect(presets).not_to_have_count(0)
    settle(used_tab, server)
    states = [preset.get_attribute("aria-pressed") for preset in presets.all()]
    at = states.index("true")
    used_tab.keyboard.press("PageDown")
    expect(presets.nth(at + 1)).to_have_attribute("aria-pressed", "true")
    expect(presets.nth(at)).to_have_attribute("aria-pressed", "false")
    used_tab.keyboard.press("PageUp")
    expect(presets.nth(at)).to_have_attribute("aria-pressed", "true")
    settle(used_tab, server)


@pytest.mark.verify
def test_controls_fade_until_somebody_moves(used_tab: Page):
    present(used_tab)
    # with the last timer
    faded = used_tab.locator(":root[data-idle]")
    expect(faded).to_have_count(1)
    controls = used_tab.locator("#controls")
    eventually(lambda: assert_opacity(controls, "0"), used_tab)
    used_tab.mouse.move(300, 300)
    expect(faded).to_have_count(0)
    eventually(lambda: assert_opacity(controls, "1"), used_tab)
    used_tab.get_by_test_id("kappa-slider").focus()
    rest(used_tab)
    assert_opacity(controls, "1")


def assert_opacity(element, opacity: str) -> None:
    assert element.evaluate("e => getComputedStyle(e).opacity") == opacity


@pytest.mark.parametrize("scheme", every_day(["dark"], of=["light", "dark"]))
@pytest.mark.parametrize("query", every_day([""], of=["", "scene=lesson&step=6"]))
def test_axe_finds_nothing_to_object_to(used_tab: Page, scheme: str, query: str):
    used_tab.emulate_media(color_scheme=scheme)
    present(used_tab, query)
    used_tab.mouse.move(300, 300)
    assert objections(used_tab) == []
