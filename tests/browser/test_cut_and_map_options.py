"""The cut, the map's axes and its third dimension in a real browser beside a real server."""

import json
import re

import numpy as np
import pytest
from explorer import ask, collision_of, settle, visit
from lesson import LOCALES
from playwright.sync_api import Page, expect
from rest import rest

pytestmark = pytest.mark.browser

CURVE = "plot => [...(plot.data ?? []).find((t) => t.name === 'epsilon_t')?.y ?? []]"
FULL_CUT = 800
GERMAN = json.loads((LOCALES / "de.json").read_text(encoding="utf-8"))


def cut_of(page: Page) -> list[float]:
    """ε_t along the cut as it is drawn, once that is the full one."""
    rest(page)
    curve = page.get_by_test_id("cut").evaluate(CURVE)
    assert len(curve) == FULL_CUT
    return curve


def test_the_cut_is_that_of_the_api(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20&mu_over_alpha=2&gt_over_gn=1&scale=log")
    settle(used_tab, server)
    asked = {"along": "gt_over_gn", "kappa": 20, "mu_over_alpha": 2, "count": FULL_CUT}
    answer = ask(server, "cut", **asked, minimum=0.005, maximum=5, scale="log")
    assert np.array_equal(cut_of(used_tab), answer["epsilon_t"])


def test_a_click_on_the_cut_moves_the_velocity_ratio_alone(used_tab: Page, server: str):
    visit(used_tab, "/")
    settle(used_tab, server)
    # until then the cut is that of the page before
    rest(used_tab)
    before = collision_of(used_tab)
    expect(used_tab.get_by_test_id("cut-mark")).to_have_attribute("data-placed", "")
    mark = used_tab.get_by_test_id("cut-mark")
    box = mark.bounding_box()
    mark.click(position={"x": 0.5 * box["width"], "y": 0.3 * box["height"]})
    settle(used_tab, server)
    # the middle of an axis from 0.01 to 4, to a pixel
    after = collision_of(used_tab)
    assert after.pop("gt_over_gn") == pytest.approx(2.005, abs=0.02)
    assert after == {key: before[key] for key in after}


def test_the_cut_runs_along_kappa_where_that_is_chosen(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20&mu_over_alpha=2&gt_over_gn=1&scale=log&map_y=psi")
    used_tab.locator("[name=cut_x][value=kappa]").check()
    settle(used_tab, server)
    assert "cut_x=kappa" in used_tab.url
    asked = {"along": "kappa", "mu_over_alpha": 2, "gt_over_gn": 1, "count": FULL_CUT}
    answer = ask(server, "cut", **asked, minimum=0.1, maximum=1000, scale="log")
    assert np.array_equal(cut_of(used_tab), answer["epsilon_t"])
    mark = used_tab.get_by_test_id("cut-mark")
    box = mark.bounding_box()
    mark.click(position={"x": 0.75 * box["width"], "y": 0.3 * box["height"]})
    settle(used_tab, server)
    after = collision_of(used_tab)
    assert after.pop("kappa") == pytest.approx(100, rel=0.03)
    assert after == {"mu_over_alpha": 2, "gt_over_gn": 1}


def test_a_logarithmic_cut_shows_magnitude_and_sign(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=200&gt_over_gn=1&scale=log&cut_x=kappa&cut_y=log")
    settle(used_tab, server)
    rest(used_tab)
    curves = used_tab.get_by_test_id("cut").evaluate(
        "plot => Object.fromEntries(plot.data.map((t) => [t.name, [...t.y]]))"
    )
    asked = {"along": "kappa", "mu_over_alpha": 1.4, "gt_over_gn": 1, "count": FULL_CUT}
    answer = ask(server, "cut", **asked, minimum=0.1, maximum=1000, scale="log")
    floor = min(y for y in curves["epsilon_t"] if y is not None and not np.isnan(y))
    for name, sign in (("epsilon_t", 1), ("epsilon_t, negative", -1)):
        there = [np.log10(sign * e) for e in answer["epsilon_t"] if sign * e > 0]
        wanted = [y for y in there if y > floor]
        drawn = [y for y in curves[name] if y is not None and y > floor]
        np.testing.assert_allclose(drawn, wanted, rtol=1e-12)
    mark = used_tab.get_by_test_id("cut-mark")
    expect(mark).not_to_have_attribute("data-negative", "")
    used_tab.get_by_test_id("kappa-field").fill("1")
    settle(used_tab, server)
    expect(mark).to_have_attribute("data-negative", "")
    expect(used_tab.locator(".negative-key")).to_be_visible()
    used_tab.locator("[name=cut_y][value=linear]").check()
    expect(used_tab.locator(".negative-key")).to_be_hidden()
    expect(mark).not_to_have_attribute("data-negative", "")


@pytest.mark.verify
def test_the_stiff_limit_is_shown_and_named_only_where_it_says_something(
    used_tab: Page, server: str
):
    key = used_tab.locator(".stiff-limit-key")
    visit(used_tab, "/?kappa=4.5")
    settle(used_tab, server)
    rest(used_tab)
    expect(key).to_be_hidden()
    visit(used_tab, "/?kappa=63")
    settle(used_tab, server)
    expect(key).to_be_visible()
    dash = used_tab.get_by_test_id("cut").evaluate(
        "plot => plot.data.find((t) => t.name === 'stiff limit').line.dash"
    )
    assert dash == "1px,4px"
    style = key.locator(".swatch").evaluate("e => getComputedStyle(e).borderTopStyle")
    assert style == "dotted"


@pytest.mark.verify
def test_over_psi_the_map_and_the_cut_are_asked_for_once_whatever_the_friction(
    used_tab: Page, server: str
):
    visit(used_tab, "/?map_y=psi")
    settle(used_tab, server)
    before = cut_of(used_tab)
    asked = []
    used_tab.on("request", lambda r: asked.append(r.url) if "/map?" in r.url else None)
    used_tab.get_by_test_id("mu-over-alpha-field").fill("3")
    settle(used_tab, server)
    assert cut_of(used_tab) == before
    assert asked == []


@pytest.mark.verify
def test_the_surface_exists_only_while_it_is_asked_for(used_tab: Page, server: str):
    visit(used_tab, "/")
    settle(used_tab, server)
    canvases = used_tab.locator("canvas")
    expect(canvases).to_have_count(0)
    toggle = used_tab.get_by_test_id("map-shape").locator("input")
    toggle.check()
    expect(used_tab.get_by_test_id("surface").locator("canvas").first).to_be_attached()
    assert "shape=surface" in used_tab.url
    toggle.uncheck()
    expect(canvases).to_have_count(0)
    assert "shape=flat" in used_tab.url


@pytest.mark.verify
@pytest.mark.own_page
def test_a_cut_that_is_refused_says_so_in_the_page_s_language_and_why_in_the_server_s(page: Page):
    body = json.dumps({"detail": "kappa is 63, which is too much"})
    page.route("**/api/v1/cut?*", lambda route: route.fulfill(status=422, body=body))
    page.goto("/?lang=de")
    reason = page.get_by_test_id("cut-reason")
    expect(reason).to_have_text(f"{GERMAN['cut']['none']}: kappa is 63, which is too much")
    expect(reason.locator("[lang=en]")).to_have_text("kappa is 63, which is too much")


@pytest.mark.verify
def test_the_pictures_speak_the_language_of_the_page(page: Page, server: str):
    page.goto("/?lang=de")
    settle(page, server)
    force, on_map = GERMAN["force"], GERMAN["map"]
    expect(page.locator("#force-title")).to_have_text(force["title"])
    expect(page.get_by_test_id("map-x").locator("label").last).to_have_attribute(
        "title", on_map["paperAxis"]
    )
    expect(page.get_by_test_id("force-trace").locator(".xtitle")).to_contain_text("skaliert")
    about_force = force["described_other"].replace("{{mu}}", "μ").replace("{{count}}", "8")
    expect(page.get_by_test_id("force-trace")).to_have_attribute(
        "aria-label", re.compile(f"^{re.escape(about_force)}")
    )
    keys = GERMAN["crosshair"]["keys"].removeprefix("{{x}}, {{y}}")
    expect(page.get_by_test_id("crosshair")).to_have_attribute(
        "aria-label", re.compile(f"{re.escape(keys)}$")
    )
    expect(page.get_by_test_id("map")).to_have_attribute(
        "aria-label", re.compile("^Tangentialer Restitutionskoeffizient ε_t über κ von 0,1 bis 70")
    )
