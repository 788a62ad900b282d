"""What was changed is taken back and brought back, by buttons and by keys."""

import re

import pytest
from explorer import collision_of, settle, strip_of, visit
from playwright.sync_api import Page, expect
from rest import rest

pytestmark = pytest.mark.browser


def drag(page: Page, name: str) -> None:
    """Move a slider in several steps, as a hand does."""
    box = page.get_by_test_id(name).bounding_box()
    assert box is not None
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.4 * box["width"], y)
    page.mouse.down()
    for share in (0.5, 0.6, 0.7):
        page.mouse.move(box["x"] + share * box["width"], y)
        rest(page)
    page.mouse.up()
    rest(page)


def test_a_drag_is_taken_back_whole_and_brought_back(page: Page, server: str):
    page.goto("/?kappa=20")
    settle(page, server)
    rest(page)
    undo, redo = page.get_by_test_id("undo"), page.get_by_test_id("redo")
    expect(undo).to_be_disabled()
    before = page.url, strip_of(page)
    drag(page, "kappa-slider")
    after = page.url, strip_of(page)
    assert after[0] != before[0]
    undo.click()
    rest(page)
    assert (page.url, strip_of(page)) == before
    expect(page.get_by_test_id("said")).to_have_text(re.compile(r"^Undone: κ [\d.]+ → 20$"))
    expect(undo).to_be_disabled()
    assert page.evaluate("() => document.activeElement.dataset.testid") == "redo"
    page.keyboard.press("Control+Shift+Z")
    rest(page)
    assert (page.url, strip_of(page)) == after
    page.keyboard.press("Control+Z")
    page.get_by_test_id("presets").locator("[data-preset='gear-wheel']").click()
    rest(page)
    expect(redo).to_be_disabled()


@pytest.mark.verify
def test_control_z_in_a_field_is_the_fields_own(tab: Page, server: str):
    visit(tab, "/?kappa=20")
    settle(tab, server)
    tab.get_by_test_id("presets").locator("[data-preset='figure-6']").click()
    field = tab.get_by_test_id("gt-over-gn-field")
    field.click()
    tab.keyboard.press("ControlOrMeta+A")
    tab.keyboard.type("2.5")
    rest(tab)
    tab.keyboard.press("Control+Z")
    rest(tab)
    expect(field).not_to_have_value("2.5")
    assert collision_of(tab)["kappa"] == 100


@pytest.mark.verify
def test_the_browsers_back_goes_along_the_same_steps(tab: Page, server: str):
    visit(tab, "/?kappa=20")
    rest(tab)
    tab.get_by_test_id("presets").locator("[data-preset='figure-6']").click()
    # to turn to another scene is an entry of its own, however soon it is done
    tab.get_by_test_id("scenes").get_by_text("Speed and accuracy").click()
    rest(tab)
    last = tab.url
    tab.go_back()
    settle(tab, server)
    assert collision_of(tab)["kappa"] == 100
    tab.get_by_test_id("undo").click()
    settle(tab, server)
    assert collision_of(tab)["kappa"] == 20
    tab.keyboard.press("Control+y")
    tab.keyboard.press("Control+y")
    rest(tab)
    assert tab.url == last


@pytest.mark.verify
def test_an_impact_is_taken_back_with_the_collision_that_follows_from_it(page: Page, server: str):
    page.goto("/?scene=spheres")
    settle(page, server)
    rest(page)
    expect(page.get_by_test_id("undo")).to_be_disabled()
    before = page.url, strip_of(page)
    page.get_by_test_id("normal-velocity-m-s-slider").press("ArrowRight")
    rest(page)
    after = page.url, strip_of(page)
    page.keyboard.press("Control+Z")
    rest(page)
    assert (page.url, strip_of(page)) == before
    page.keyboard.press("Control+Shift+Z")
    rest(page)
    assert (page.url, strip_of(page)) == after
