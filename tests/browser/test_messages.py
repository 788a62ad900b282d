"""What the page has to say of itself lies over nothing, and can be sent away."""

import pytest
from explorer import settle
from playwright.sync_api import Page, expect
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

SIZES = [(390, 844), (1280, 720)]

# Links, buttons and choices in the window that something else lies over, by their words.
COVERED = """() => {
  const operable = "a, button, select, input, summary, [tabindex='0']";
  const all = [...document.querySelectorAll(operable)].filter((e) => e.checkVisibility());
  const isCovered = (element) => {
    const {left, top, width, height} = element.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    if (width === 0 || x < 0 || y < 0 || y >= innerHeight) return false;
    const found = document.elementFromPoint(x, y);
    return found.closest(".messages") && !element.closest(".messages");
  };
  return all.filter(isCovered).map((element) => element.ariaLabel || element.textContent.trim());
}"""


def message(page: Page, name: str):
    return page.locator(f".message.{name}")


def close(page: Page, name: str) -> None:
    message(page, name).get_by_role("button").click()


@pytest.mark.parametrize(("width", "height"), every_day(SIZES[:1], of=SIZES))
def test_what_was_wrong_in_an_address_covers_nothing_and_is_closed(
    page: Page, server: str, width: int, height: int
):
    page.set_viewport_size({"width": width, "height": height})
    page.goto("/?kappa=spring&mu_over_alpha=tight&gt_over_gn=fast")
    settle(page, server)
    rest(page)
    expect(message(page, "notice")).to_be_visible()
    assert page.evaluate(COVERED) == []
    close(page, "notice")
    expect(message(page, "notice")).to_be_hidden()


@pytest.mark.parametrize(("width", "height"), every_day(SIZES[:1], of=SIZES))
def test_a_lost_server_covers_nothing_and_is_said_again_when_something_is_wanted_of_it(
    tab: Page, width: int, height: int
):
    tab.set_viewport_size({"width": width, "height": height})
    tab.route("**/api/**", lambda route: route.abort())
    tab.get_by_test_id("kappa-slider").press("ArrowRight")
    expect(tab.get_by_test_id("banner")).to_contain_text("does not answer")
    tab.evaluate("() => scrollTo(0, 0)")
    assert tab.evaluate(COVERED) == []
    close(tab, "banner")
    expect(message(tab, "banner")).to_be_hidden()
    tab.get_by_test_id("kappa-slider").press("ArrowRight")
    expect(message(tab, "banner")).to_be_visible()
    expect(tab.get_by_test_id("banner")).to_contain_text("does not answer")
    tab.unroute_all()
    expect(message(tab, "banner")).to_be_hidden()


@pytest.mark.verify
def test_far_down_a_message_is_in_sight(page: Page, server: str):
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto("/?kappa=spring")
    settle(page, server)
    rest(page)
    page.evaluate("() => scrollTo(0, document.body.scrollHeight)")
    expect(message(page, "notice")).to_be_in_viewport()


@pytest.mark.verify
def test_a_message_is_gone_with_the_next_step(used_tab: Page, server: str):
    used_tab.goto("/?kappa=spring")
    settle(used_tab, server)
    expect(message(used_tab, "notice")).to_be_visible()
    used_tab.locator("[data-preset='figure-6']").click()
    expect(message(used_tab, "notice")).to_be_hidden()
