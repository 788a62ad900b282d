"""Colours by choice, a link to copy, one panel alone, and the menu of each picture."""

import re
from pathlib import Path

import pytest
from explorer import ask, collision_of, settle, text, visit
from playwright.sync_api import Page, expect
from rest import LARGEST_LAYOUT_SHIFT, WATCH_SHIFTS, layout_shift, rest

from cases import every_day

pytestmark = pytest.mark.browser

PANELS = ["result", "force", "velocity", "contact", "map", "cut"]
ACCURACY_PANELS = ["tradeoff", "error_map", "overlay", "steps"]
SPHERES_PANELS = ["velocities", "sphere_cut", "impact", "place"]


def paper(page: Page) -> str:
    return page.evaluate("() => getComputedStyle(document.documentElement).backgroundColor")


def choose(page: Page, panel: str, name: str) -> None:
    page.get_by_test_id(f"menu-{panel}").click()
    page.locator(f"#menu-{panel}").get_by_text(name, exact=True).click()


def test_colours_are_those_chosen_and_stand_in_the_address(tab: Page):
    tab.emulate_media(color_scheme="light")
    light = paper(tab)
    line = tab.locator("[data-testid=force-trace] .js-line").last
    stroke = line.evaluate("(e) => e.style.stroke")
    tab.get_by_test_id("theme").select_option("dark")
    rest(tab)
    assert paper(tab) != light
    assert line.evaluate("(e) => e.style.stroke") != stroke
    assert "theme=dark" in tab.url
    tab.go_back()
    rest(tab)
    assert paper(tab) == light
    assert line.evaluate("(e) => e.style.stroke") == stroke


@pytest.mark.parametrize(
    "panel",
    every_day(["impact"], of=PANELS + ACCURACY_PANELS + SPHERES_PANELS),
)
def test_embedded_panel_stands_alone_and_leads_to_the_full_page(used_tab: Page, panel: str):
    used_tab.set_viewport_size({"width": 480, "height": 360})
    address = f"/?embed={panel}&kappa=20"
    # a panel of real spheres without its scene is loaded, see `visit`
    if panel in SPHERES_PANELS:
        used_tab.goto(address)
    else:
        visit(used_tab, address)
    assert_stands_alone(used_tab, panel)


@pytest.mark.verify
def test_embedded_panel_loads_alone(page: Page):
    page.set_viewport_size({"width": 480, "height": 360})
    page.goto("/?embed=map&kappa=20")
    assert_stands_alone(page, "map")


def assert_stands_alone(page: Page, panel: str) -> None:
    page.get_by_test_id("full-page").wait_for()
    rest(page)
    for each in PANELS + ACCURACY_PANELS + SPHERES_PANELS:
        assert page.locator(f"[data-panel={each}]").is_visible() == (each == panel)
    assert not page.get_by_test_id("share").is_visible()
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 480
    rest(page)
    link = page.get_by_test_id("full-page")
    link.hover()
    address = link.get_attribute("href")
    assert address is not None
    assert "embed" not in address
    # real spheres have a stiffness of their own
    assert ("kappa=20" in address) is (panel not in SPHERES_PANELS)


@pytest.mark.parametrize("panel", every_day(["map"], of=PANELS[1:]))
def test_every_picture_gives_its_data_and_itself(
    used_tab: Page, server: str, panel: str, tmp_path: Path
):
    visit(used_tab, "/?kappa=20")
    settle(used_tab, server)
    rest(used_tab)
    begins = {
        "CSV": rb"(time|kappa|gt_over_gn|bounces),",
        "CSV + units": rb"# ",
        "CSV 0,5": rb"(time|kappa|gt_over_gn|bounces);.*\n(-?\d+,\d+;|0;)",
        "JSON": rb"\{",
        "PNG": rb"\x89PNG",
        "SVG": rb"<svg",
    }
    for name, beginning in begins.items():
        with used_tab.expect_download() as download:
            choose(used_tab, panel, name)
        used_tab.keyboard.press("Escape")
        saved = tmp_path / download.value.suggested_filename
        download.value.save_as(saved)
        assert saved.name.startswith(f"restitution-{panel}")
        assert "kappa-20-" in saved.name
        assert saved.suffix == f".{name.split()[0].lower()}"
        assert re.match(beginning, saved.read_bytes())


@pytest.mark.parametrize("panel", every_day(["map"], of=PANELS))
def test_table_and_request_are_there_by_keyboard(tab: Page, panel: str):
    rest(tab)
    button = tab.get_by_test_id(f"menu-{panel}")
    for name, shown in [("Table", "table caption"), ("API request", "pre")]:
        button.focus()
        tab.keyboard.press("ArrowDown")
        while tab.evaluate("() => document.activeElement.textContent") != name:
            tab.keyboard.press("ArrowDown")
        tab.keyboard.press("Enter")
        assert tab.get_by_test_id("sheet").locator(shown).first.is_visible()
        tab.keyboard.press("Escape")
        assert tab.evaluate("() => document.activeElement.dataset.testid") == f"menu-{panel}"


@pytest.mark.verify
def test_request_of_the_result_answers_what_the_strip_shows(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20")
    settle(used_tab, server)
    choose(used_tab, "result", "API request")
    line = used_tab.locator("pre").first.inner_text()
    query = "kappa=20&mu_over_alpha=1.4&gt_over_gn=1.358"
    assert line == f'curl "{server}/api/v1/collision?{query}"'


@pytest.mark.verify
def test_arrow_keys_move_the_crosshair_one_parameter_at_a_time(tab: Page, server: str):
    tab.get_by_test_id("crosshair").focus()
    rest(tab)
    before = collision_of(tab)
    tab.keyboard.press("ArrowLeft")
    rest(tab)
    after = collision_of(tab)
    assert after["kappa"] < before["kappa"]
    assert after["gt_over_gn"] == before["gt_over_gn"]
    tab.keyboard.press("Shift+ArrowUp")
    settle(tab, server)
    rest(tab)
    assert collision_of(tab)["gt_over_gn"] > before["gt_over_gn"]
    assert text(tab, "switches") == str(ask(server, "collision", **collision_of(tab))["switches"])


@pytest.mark.own_page
@pytest.mark.parametrize(
    ("width", "height"), every_day([(320, 640)], of=[(320, 640), (390, 844), (1440, 900)])
)
def test_nothing_moves_after_the_first_paint_and_nothing_is_too_wide(
    page: Page, server: str, width: int, height: int
):
    page.set_viewport_size({"width": width, "height": height})
    page.add_init_script(WATCH_SHIFTS)
    page.goto("/?theme=dark")
    settle(page, server)
    rest(page)
    assert layout_shift(page) < LARGEST_LAYOUT_SHIFT
    assert page.evaluate("() => document.documentElement.scrollWidth") <= width


@pytest.mark.verify
def test_a_picture_that_cannot_be_saved_now_is_said_and_can_be_later(page: Page, server: str):
    page.route("**/save-drawing.js", lambda route: route.abort())
    page.goto("/?kappa=20")
    settle(page, server)
    rest(page)
    choose(page, "contact", "SVG")
    expect(page.get_by_test_id("banner")).to_contain_text("What saves pictures did not arrive")
    page.unroute_all()
    expect(page.get_by_test_id("banner")).to_be_empty()
    with page.expect_download():
        choose(page, "contact", "SVG")
