"""A slider goes there and back by itself, is stopped by any touch, and leaves a trail."""

import re
import urllib.parse
from pathlib import Path

import pytest
from explorer import Witness, collision_of, settle, text, visit
from playwright.sync_api import Page, expect
from rest import eventually, rest
from test_access import objections

pytestmark = pytest.mark.browser

# How many different traces lie behind that of the present collision.
TRAILS = """plot => new Set((plot.data ?? [])
  .filter(({name, x}) => name.startsWith("trail") && x.length > 9)
  .map(({y}) => y.join())).size"""

# So wide and so fast that its end is not waited for.
FAST = "/?kappa=20&sweep=kappa,0.1,1000,2"


def let_move(page: Page) -> None:
    page.emulate_media(reduced_motion="no-preference")


def leaves_trails(page: Page, count: int) -> None:
    for view in ("force-trace", "velocity"):
        assert page.get_by_test_id(view).evaluate(TRAILS) >= count


def test_a_slider_runs_until_something_is_touched_and_is_taken_back_whole(
    used_tab: Page, server: str
):
    visit(used_tab, FAST)
    settle(used_tab, server)
    rest(used_tab)
    witness = Witness(used_tab, server)
    let_move(used_tab)
    play = used_tab.get_by_test_id("kappa-sweep")
    play.click()
    expect(play).to_have_accessible_name("Stop κ")
    expect(used_tab.get_by_test_id("said")).to_have_text("κ goes from 0.1 to 1000 and back")
    eventually(lambda: leaves_trails(used_tab, 5), used_tab)
    used_tab.get_by_test_id("summary").click()
    rest(used_tab)
    settle(used_tab, server)
    kappa = collision_of(used_tab)["kappa"]
    assert kappa != 20
    assert used_tab.get_by_test_id("kappa-field").input_value() == f"{kappa:g}"
    expect(play).to_have_accessible_name(re.compile("κ$"))
    expect(used_tab.get_by_test_id("said")).to_have_text(f"κ has stopped at {kappa:g}")
    # what is seen is what is saved
    leaves_trails(used_tab, 5)
    witness.assert_silence()
    used_tab.get_by_test_id("undo").click()
    settle(used_tab, server)
    rest(used_tab)
    assert collision_of(used_tab)["kappa"] == 20
    assert used_tab.url.endswith("&sweep=kappa,0.1,1000,2")
    assert used_tab.get_by_test_id("force-trace").evaluate(TRAILS) == 0


def test_where_nothing_is_to_move_each_press_is_a_step(tab: Page, server: str):
    slider, play = (tab.get_by_test_id(f"mu-over-alpha-{part}") for part in ("slider", "sweep"))
    slider.fill("750")
    settle(tab, server)
    for place in ("850", "950", "1000", "900"):
        play.press("Space")
        rest(tab)
        assert slider.input_value() == place
        value = collision_of(tab)["mu_over_alpha"]
        assert value == float(place) / 250
        expect(tab.get_by_test_id("said")).to_have_text(f"μ/α\u00a0=\u00a0{value:g}")
    leaves_trails(tab, 3)
    settle(tab, server)


def test_range_time_and_repetition_are_set_beside_the_slider(tab: Page):
    tab.set_viewport_size({"width": 390, "height": 844})
    tab.get_by_test_id("gt-over-gn-sweep").click()
    more = tab.get_by_test_id("sweep-more")
    more.press("Enter")
    expect(more).to_have_attribute("aria-expanded", "true")
    for name, value in (("from", "0.5"), ("to", "2")):
        tab.get_by_test_id(f"sweep-{name}").fill(value)
    tab.get_by_test_id("sweep-seconds").select_option("16")
    tab.get_by_test_id("sweep-loop").uncheck()
    rest(tab)
    assert tab.url.endswith("&sweep=gt_over_gn,0.5,2,16,once")
    assert objections(tab) == []
    tab.get_by_test_id("sweep-to").fill("5")
    rest(tab)
    card = tab.get_by_test_id("sweep-details")
    expect(card).to_contain_text("to must be a number from 0 to 4")
    tab.keyboard.press("Escape")
    expect(card).to_be_hidden()
    more.click()
    tab.get_by_test_id("sweep-away").click()
    rest(tab)
    assert "sweep" not in tab.url
    expect(more).to_be_hidden()
    expect(tab.get_by_test_id("gt-over-gn-sweep")).to_be_focused()


STOPS = {
    "a key": lambda page: page.keyboard.press("ArrowUp"),
    "the button": lambda page: page.keyboard.press("Space"),
    "a clicker": lambda page: page.keyboard.press("PageDown"),
    "another slider": lambda page: page.get_by_test_id("gt-over-gn-slider").click(),
    "another sweep": lambda page: page.get_by_test_id("mu-over-alpha-sweep").click(),
    "back": lambda page: page.go_back(),
    "another window": lambda page: page.evaluate(
        "() => document.dispatchEvent(new Event('visibilitychange'))"
    ),
}


@pytest.mark.verify
@pytest.mark.parametrize("stop", STOPS)
def test_whatever_one_does_stops_it(used_tab: Page, server: str, stop: str):
    visit(used_tab, "/?kappa=50")
    visit(used_tab, FAST)
    settle(used_tab, server)
    rest(used_tab)
    let_move(used_tab)
    play = used_tab.get_by_test_id("kappa-sweep")
    play.press("Enter")
    eventually(lambda: leaves_trails(used_tab, 3), used_tab)
    STOPS[stop](used_tab)
    expect(play).to_have_accessible_name("Sweep κ")
    used_tab.emulate_media(reduced_motion="reduce")
    used_tab.keyboard.press("x")
    rest(used_tab)
    settle(used_tab, server)
    if stop == "back":
        assert collision_of(used_tab)["kappa"] == 50


@pytest.mark.verify
def test_once_is_there_and_back_and_ends_by_itself(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20&sweep=kappa,1,100,1,once")
    settle(used_tab, server)
    rest(used_tab)
    let_move(used_tab)
    used_tab.get_by_test_id("kappa-sweep").click()
    expect(used_tab.get_by_test_id("said")).to_have_text(
        re.compile("κ has stopped at (20|19.9|20.0)")
    )


@pytest.mark.verify
def test_sliders_of_other_scenes_run_too(used_tab: Page, server: str):
    for address, name in (
        ("/?scene=spheres&sweep=radius_m,0.001,0.1,2", "radius-m"),
        ("/?scene=lesson&step=4&sweep=damping,0,1,2", "damping"),
        ("/?spin_share=0.2&sweep=spin_share,0,1,2", "spin-share"),
    ):
        visit(used_tab, address)
        rest(used_tab)
        before = used_tab.url
        let_move(used_tab)
        used_tab.get_by_test_id(f"{name}-sweep").click()
        key = urllib.parse.parse_qs(address)["sweep"][0].partition(",")[0]
        slider = used_tab.get_by_test_id("spin-share" if name == "spin-share" else f"{name}-slider")
        first = slider.input_value()
        eventually(
            lambda slider=slider, first=first: has_moved(slider.input_value(), first), used_tab
        )
        used_tab.keyboard.press("x")
        rest(used_tab)
        query = urllib.parse.parse_qs(urllib.parse.urlsplit(used_tab.url).query)
        assert used_tab.url != before
        assert key in query
        used_tab.emulate_media(reduced_motion="reduce")
        settle(used_tab, server)


def has_moved(value: str, first: str) -> None:
    assert value != first


@pytest.mark.verify
def test_a_saved_picture_shows_the_sweep(tab: Page, tmp_path: Path):
    for _ in range(4):
        tab.get_by_test_id("kappa-sweep").click()
        rest(tab)
    tab.locator(".force .menu-button").click()
    with tab.expect_download() as saved:
        tab.locator(".force .menu").get_by_text("SVG").click()
    file = tmp_path / "force.svg"
    saved.value.save_as(file)
    opacities = re.findall(r'class="trace scatter[^>]*opacity: ([.\d]+)', file.read_text())
    # those behind are drawn before what is present
    assert [float(each) < 0.6 for each in opacities].count(True) == 7
    assert text(tab, "said").startswith("κ")
