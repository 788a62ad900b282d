"""The page in a real browser beside a real server: it shows what the API answers."""

import re
import urllib.parse
from collections.abc import Iterator

import numpy as np
import pytest
from explorer import (
    PARAMETERS,
    REFUSE_KERNEL,
    Witness,
    agrees,
    ask,
    collision_of,
    settle,
    text,
    trace_of,
    visit,
)
from playwright.sync_api import Page, expect
from rest import eventually, rest

from cases import every_day

pytestmark = pytest.mark.browser


@pytest.fixture
def explorer(tab: Page, server: str) -> Iterator[Page]:
    """The opened page; the test fails on any word in the console or request to elsewhere."""
    witness = Witness(tab, server)
    yield tab
    witness.assert_silence()


def test_the_phenomenon_is_on_the_screen_without_a_click(explorer, server):
    answer = ask(server, "collision", **collision_of(explorer))
    assert answer["switches"] >= 4
    assert answer["reversals"] >= 2
    for plot in ("force-trace", "velocity", "map"):
        assert explorer.get_by_test_id(plot).locator("svg").count() > 0


@pytest.mark.parametrize("name", every_day(["kappa"], of=PARAMETERS))
def test_dragging_a_slider_with_the_mouse_shows_the_collision_there(explorer, server, name):
    before = collision_of(explorer)
    box = explorer.get_by_test_id(f"{name}-slider").bounding_box()
    y = box["y"] + box["height"] / 2
    explorer.mouse.move(box["x"] + 0.5 * box["width"], y)
    explorer.mouse.down()
    for share in np.linspace(0.5, 0.3, 12):
        explorer.mouse.move(box["x"] + share * box["width"], y)
    explorer.mouse.up()
    settle(explorer, server)
    after = collision_of(explorer)
    assert [k for k in after if after[k] != before[k]] == [PARAMETERS[name]]


@pytest.mark.parametrize("name", every_day(["gt-over-gn"], of=PARAMETERS))
def test_arrow_keys_move_a_slider(explorer, server, name):
    before = collision_of(explorer)[PARAMETERS[name]]
    explorer.get_by_test_id(f"{name}-slider").focus()
    for _ in range(5):
        explorer.keyboard.press("ArrowRight")
    settle(explorer, server)
    assert collision_of(explorer)[PARAMETERS[name]] > before
    for _ in range(8):
        explorer.keyboard.press("ArrowLeft")
    settle(explorer, server)
    assert collision_of(explorer)[PARAMETERS[name]] < before


@pytest.mark.verify
def test_a_click_on_the_map_moves_the_sliders_there(explorer, server):
    box = explorer.get_by_test_id("map").bounding_box()
    explorer.mouse.click(box["x"] + 0.45 * box["width"], box["y"] + 0.7 * box["height"])
    settle(explorer, server)
    first = collision_of(explorer)
    explorer.mouse.click(box["x"] + 0.75 * box["width"], box["y"] + 0.3 * box["height"])
    settle(explorer, server)
    second = collision_of(explorer)
    assert second["kappa"] > first["kappa"]
    assert second["gt_over_gn"] > first["gt_over_gn"]
    assert second["mu_over_alpha"] == first["mu_over_alpha"]
    shown = float(explorer.get_by_test_id("kappa-field").input_value())
    assert shown == pytest.approx(second["kappa"], rel=1e-5)


NONSENSE = ("-1", "", "1e999", "spring", "NaN", "0")


@pytest.mark.parametrize(
    "several",
    [NONSENSE[1:4], pytest.param(NONSENSE, marks=pytest.mark.verify)],
    ids=["some", "all"],
)
def test_typed_numbers_count_and_nonsense_keeps_the_last_picture(explorer, server, several):
    field = explorer.get_by_test_id("kappa-field")
    field.fill("18")
    field.press("Enter")
    settle(explorer, server)
    assert collision_of(explorer)["kappa"] == 18.0
    before = text(explorer, "epsilon-t")
    for nonsense in several:
        field.fill(nonsense)
        said = "beyond" if nonsense == "1e999" else "must be"
        expect(explorer.get_by_test_id("kappa-problem")).to_contain_text(said)
        assert text(explorer, "epsilon-t") == before
    field.blur()
    # words are read by a module that comes when they are typed
    expect(field).to_have_value("18")


def test_presets_show_what_they_are_named_after(explorer, server):
    presets = {item["id"]: item for item in ask(server, "presets")["items"]}
    for name in ("figure-5-a", "figure-5-g", "figure-6", "pure-sliding"):
        preset = presets[name]
        explorer.get_by_test_id("presets").locator(f"[data-preset='{name}']").click()
        settle(explorer, server)
        shown = collision_of(explorer)
        assert shown == {key: preset[key] for key in shown}


def test_the_force_trace_is_that_of_the_api(explorer, server):
    answer = ask(server, "trace", **collision_of(explorer), samples=2000)
    curves = trace_of(explorer, "force-trace")
    found = [
        np.abs(np.interp(c["x"], answer["time"], answer["tangential_force_over_mu"]) - c["y"]).max()
        for c in curves
        if len(c["x"]) > 100
    ]
    # the page draws fewer samples: linear interpolation of a curve with kinks at its switches
    assert min(found) < 1e-3, found


def test_the_map_is_that_of_the_api(explorer, server):
    # a coarse one may be asked for while the number is typed
    with explorer.expect_request(re.compile(r"/api/v1/map\?.*kappa_count=240")) as asked:
        explorer.get_by_test_id("mu-over-alpha-field").fill("0.9")
        explorer.keyboard.press("Enter")
    settle(explorer, server)
    rest(explorer)
    query = dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(asked.value.url).query))
    answer = ask(server, "map", **(query | {"encoding": "plain"}))
    cells = "m => m.data.find((t) => t.z).z.map((row) => [...row])"
    drawn = explorer.get_by_test_id("map").evaluate(cells)
    np.testing.assert_array_equal(drawn, answer["epsilon_t"])
    explorer.get_by_role("radio", name="switches").check()
    drawn = explorer.get_by_test_id("map").evaluate(cells)
    np.testing.assert_array_equal(drawn, answer["switches"])


def test_the_address_holds_the_state_and_back_returns_to_it(explorer, server):
    first = collision_of(explorer)
    explorer.get_by_test_id("presets").locator("[data-preset='figure-6']").click()
    settle(explorer, server)
    explorer.reload()
    settle(explorer, server)
    assert collision_of(explorer)["kappa"] == 100.0
    explorer.go_back()
    settle(explorer, server)
    assert collision_of(explorer) == first


@pytest.mark.verify
def test_what_back_returned_to_is_kept_by_a_change_at_once(explorer, server):
    presets = explorer.get_by_test_id("presets")
    first = collision_of(explorer)
    presets.locator("[data-preset='figure-6']").click()
    # as a hand that changes its mind: back, and on to another one
    explorer.evaluate("() => history.back()")
    explorer.wait_for_function("() => !location.search.includes('kappa=100')")
    presets.locator("[data-preset='gear-wheel']").click()
    settle(explorer, server)
    explorer.go_back()
    settle(explorer, server)
    assert collision_of(explorer) == first


ADDRESSES = [
    "?kappa=%3Cscript%3Ealert(1)%3C/script%3E&map=%00&scale=%F0%9F%98%80",
    "?kappa=-1&mu_over_alpha=NaN&gt_over_gn=1e999",
    "?kappa=5e-324&mu_over_alpha=1.7e308&gt_over_gn=5e-324",
]


@pytest.mark.parametrize("address", every_day(ADDRESSES[:1], of=ADDRESSES))
def test_nonsense_in_the_address_ends_in_a_working_page(explorer, server, address):
    explorer.goto(f"/{address}")
    settle(explorer, server)
    assert agrees(explorer, server)


@pytest.mark.own_page
def test_a_lost_server_keeps_the_picture_and_the_page_recovers(page: Page, server: str):
    page.add_init_script(REFUSE_KERNEL)
    page.goto("/")
    settle(page, server)
    rest(page)
    before = text(page, "summary")
    page.route("**/api/**", lambda route: route.abort())
    page.route("**/healthz", lambda route: route.abort())
    page.get_by_test_id("kappa-slider").press("ArrowRight")
    expect(page.get_by_test_id("banner")).to_contain_text("The last picture stays")
    assert text(page, "summary") == before
    expect(page.get_by_test_id("from-map")).to_have_css("opacity", "1")
    page.unroute_all()
    expect(page.get_by_test_id("banner")).to_be_empty()
    settle(page, server)


def test_without_its_server_the_page_computes_collisions_itself(tab: Page, server: str):
    rest(tab)
    tab.route("**/api/**", lambda route: route.abort())
    tab.get_by_test_id("kappa-slider").press("ArrowRight")
    expect(tab.get_by_test_id("banner")).to_contain_text("this page computes collisions by itself")

    def is_right() -> None:
        assert agrees(tab, server)

    for name, key in (("mu-over-alpha", "ArrowLeft"), ("damping", "PageUp")):
        tab.get_by_test_id(f"{name}-slider").press(key)
        eventually(is_right, tab)
        assert text(tab, "provenance").endswith("here")
    # another method has nobody who answers by it
    tab.get_by_test_id("method").select_option("timestep")
    expect(tab.get_by_test_id("accuracy-refusal")).to_contain_text("The server is away")
    language = tab.get_by_test_id("language")
    language.select_option("de")
    expect(language).not_to_have_value("de")
    assert "lang=de" not in tab.url
    tab.unroute_all()
    expect(tab.get_by_test_id("banner")).to_be_empty()
    settle(tab, server)
    assert not text(tab, "provenance").endswith("here")


@pytest.mark.verify
def test_damping_moves_everything(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=18&mu_over_alpha=1.4&gt_over_gn=0.3")
    settle(used_tab, server)
    field = used_tab.get_by_test_id("damping-field")
    field.fill("0.3")
    field.press("Enter")
    settle(used_tab, server)
    assert collision_of(used_tab)["damping"] == 0.3
    # model.md: ε_n at η = 0.3
    assert text(used_tab, "epsilon-n") == "0.7221"
    assert int(text(used_tab, "switches")) % 2 == 1
    used_tab.locator("[data-preset='figure-6']").click()
    settle(used_tab, server)
    assert "damping" not in used_tab.url
