"""The presets that are figures of the paper show what the paper shows."""

import pytest
from explorer import number, settle, text, visit
from playwright.sync_api import Page, expect
from rest import rest

pytestmark = pytest.mark.browser


def choose(page: Page, server: str, preset: str) -> None:
    visit(page, "/")
    settle(page, server)
    page.locator(f"[data-preset='{preset}']").click()
    settle(page, server)
    rest(page)


def words_in(page: Page, name: str) -> list[str]:
    return page.get_by_test_id(name).locator(".scatterlayer .textpoint").all_text_contents()


@pytest.mark.verify
def test_figure_1_shows_coulombs_result_beside_coulombs_map(used_tab: Page, server: str):
    choose(used_tab, server, "figure-1")
    assert text(used_tab, "epsilon-t") == "0"
    assert used_tab.get_by_test_id("method").input_value() == "coulomb"
    used_tab.get_by_role("link", name="Explorer").click()
    settle(used_tab, server)
    assert used_tab.get_by_test_id("method").input_value() == "auto"


@pytest.mark.verify
def test_figure_2_shows_that_epsilon_t_is_negative_at_small_tangential_velocity(
    used_tab: Page, server: str
):
    choose(used_tab, server, "figure-2")
    assert number(text(used_tab, "epsilon-t")) < -0.1
    ring = used_tab.locator("[data-testid=velocity-crosshair] .crosshair-ring").bounding_box()
    map_ = used_tab.get_by_test_id("velocity-crosshair").bounding_box()
    assert map_["y"] + map_["height"] - (ring["y"] + ring["height"]) > 20
    expect(used_tab.get_by_test_id("figure-caption")).to_contain_text("logarithmic")


def test_figure_4_has_its_letters_and_its_numbers_in_circles(used_tab: Page, server: str):
    used_tab.set_viewport_size({"width": 1920, "height": 1080})
    choose(used_tab, server, "figure-4")
    words = words_in(used_tab, "map")
    assert {"0", "2", "4", "6", "8"} <= set(words)
    assert {"a", "b", "c", "d", "e", "f"} <= set(words)


@pytest.mark.verify
def test_figure_6_says_how_many_slides_there_are_and_how_kappa_is_read(used_tab: Page, server: str):
    choose(used_tab, server, "figure-6")
    expect(used_tab.locator(".preset-source").first).to_be_attached()
    caption = used_tab.get_by_test_id("presets").locator(".preset-source")
    expect(caption).to_contain_text("three more slides")
    expect(caption).to_contain_text("not read as ακ")
    bars = used_tab.get_by_test_id("force-trace").evaluate(
        """plot => plot.data.find(({name}) => name === "ribbon").marker.color"""
    )
    # it slides, and after each of three times that it sticks it slides again
    assert len(bars) == 7


@pytest.mark.verify
def test_the_force_of_the_gear_wheel_is_seen(used_tab: Page, server: str):
    choose(used_tab, server, "gear-wheel")
    force = used_tab.get_by_test_id("force-trace").evaluate(
        """plot => plot.data.find(({name}) => name === "tangential force / mu").y"""
    )
    assert max(map(abs, force.values() if isinstance(force, dict) else force)) > 0.1
    assert "tangential force drawn × 10³" in words_in(used_tab, "force-trace")


@pytest.mark.verify
@pytest.mark.parametrize("kappa", ["20000", "2500000"])
def test_many_switches_are_told_where_they_cannot_be_drawn(used_tab: Page, server: str, kappa: str):
    visit(used_tab, f"/?kappa={kappa}&gt_over_gn=1&scale=log")
    settle(used_tab, server)
    rest(used_tab)
    switches = int(text(used_tab, "switches"))
    plot = used_tab.get_by_test_id("force-trace")
    ribbon = plot.evaluate("""(plot) => {
      const {x, width, text} = plot.data.find(({name}) => name === "ribbon");
      return {end: x.at(-1) + width.at(-1) / 2, widths: [...width], words: [...text]};
    }""")
    assert ribbon["end"] == pytest.approx(float(text(used_tab, "contact-duration")), abs=1e-3)
    told = [word for word in ribbon["words"] if "switches" in word]
    assert told
    assert sum(int(word.split()[0]) for word in told) >= 0.7 * switches


def test_lost_energy_says_of_which_motion_it_is_and_symbols_explain_it(tab: Page):
    tab.set_viewport_size({"width": 1440, "height": 900})
    expect(tab.locator(".figures")).to_contain_text("tangential energy lost")
    # whatever the tab was used for before
    tab.get_by_test_id("symbols").evaluate("symbols => { symbols.open = false; }")
    tab.get_by_test_id("symbols").locator("summary").click()
    for term in ("switches", "turns", "tangential energy lost"):
        expect(tab.get_by_test_id("symbols").get_by_text(term, exact=True)).to_be_visible()
    tab.get_by_test_id("menu-result").click()
    tab.locator("#menu-result").get_by_text("Table", exact=True).click()
    expect(tab.get_by_test_id("sheet")).to_contain_text("tangential energy lost")
