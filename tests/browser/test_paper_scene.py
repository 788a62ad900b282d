"""The scene of the paper lists what the API answers, and each statement opens what shows it."""

import itertools
import re
import urllib.parse

import numpy as np
import pytest
from explorer import Witness, ask, collision_of, settle, trace_of, visit
from playwright.sync_api import Page, expect
from rest import eventually, rest
from test_access import objections

from cases import every_day

pytestmark = pytest.mark.browser

SCENE = "/?scene=paper"


def open_scene(page: Page, options: str = "") -> None:
    visit(page, SCENE + options)
    expect(page.locator(".statement").first).to_be_visible()


def test_every_statement_stands_there_with_its_verdict(used_tab: Page, server: str):
    witness = Witness(used_tab, server)
    open_scene(used_tab)
    paper = ask(server, "paper")
    items = paper["items"]
    shown = used_tab.locator(".statement")
    expect(shown).to_have_count(len(items))
    found = shown.evaluate_all(
        "all => all.map((one) => [one.dataset.statement, one.querySelector('.verdict').innerText])"
    )
    words = {"holds": "holds", "corrected": "holds with a correction", "fails": "does not hold"}
    marks = {"holds": "✓", "corrected": "≈", "fails": "✗"}
    verdicts = {item["id"]: item["verdict"] for item in items}
    assert {name for name, _ in found} == verdicts.keys()
    for name, said in found:
        defines = ", a definition" if name in paper["definitions"] else ""
        expected = f"{marks[verdicts[name]]} {words[verdicts[name]]}{defines}"
        assert re.sub(r"\s+", " ", said) == expected
    counts = [sum(v == verdict for v in verdicts.values()) for verdict in words]
    expect(used_tab.get_by_test_id("paper-count")).to_have_text(
        f"{counts[0]} hold, {len(paper['definitions'])} of them as definitions; {counts[1]} hold "
        f"with a correction, {len(paper['corrections'])} different ones in all; {counts[2]} do not."
    )
    witness.assert_silence()


@pytest.mark.verify
def test_printed_and_computed_are_set_as_symbols(used_tab: Page, server: str):
    open_scene(used_tab)
    item = next(i for i in ask(server, "paper")["items"] if i["id"] == "equation-27")
    shown = used_tab.locator('[data-statement="equation-27"]')
    printed, computed = shown.locator("dd").all_inner_texts()
    plain = re.compile(r"[_^{}\s]")
    assert plain.sub("", printed) == plain.sub("", item["printed"])
    assert plain.sub("", computed) == plain.sub("", item["computed"])
    everything = used_tab.get_by_test_id("paper-list").inner_text()
    assert not re.search(r"[\^{}]|\w_\w", everything), "a symbol that is not set"
    shown.locator("summary").click()
    expect(shown.locator("details p")).to_have_count(3)
    expect(shown.locator("details p").nth(1)).to_have_text("The correction, one for 5 statements:")
    assert shown.locator("[lang=en]").count() == 4, "printed, computed, evidence, correction"


@pytest.mark.verify
def test_the_list_is_loaded_only_when_the_scene_is_shown(page: Page, server: str):
    witness = Witness(page, server)
    page.goto("/")
    settle(page, server)
    assert witness.last("paper") is None
    page.get_by_test_id("scenes").get_by_text("The paper").click()
    expect(page.locator(".statement").first).to_be_visible()
    assert [call for call, _ in witness.calls].count("paper") == 1
    page.get_by_test_id("scenes").get_by_text("Explorer").click()
    page.get_by_test_id("scenes").get_by_text("The paper").click()
    expect(page.locator(".statement").first).to_be_visible()
    assert [call for call, _ in witness.calls].count("paper") == 1


def test_filters_cut_the_list_and_stand_in_the_address(used_tab: Page, server: str):
    items = ask(server, "paper")["items"]
    open_scene(used_tab)
    choose(used_tab, "paper_verdict", "fails")
    fails = [i["id"] for i in items if i["verdict"] == "fails"]
    expect(used_tab.locator(".statement")).to_have_count(len(fails))
    choose(used_tab, "paper_kind", "number")
    numbers = [i["id"] for i in items if i["verdict"] == "fails" and i["kind"] == "number"]
    expect(used_tab.locator(".statement")).to_have_count(len(numbers))
    eventually(lambda: _holds("paper_verdict=fails" in used_tab.url), used_tab)
    assert "paper_kind=number" in used_tab.url
    used_tab.reload()
    expect(used_tab.locator(".statement")).to_have_count(len(numbers))
    choose(used_tab, "paper_kind", "equation")
    expect(used_tab.get_by_test_id("paper-list")).to_have_text("There is no such statement.")


def choose(page: Page, name: str, value: str) -> None:
    page.locator(f'[name="{name}"][value="{value}"]').check()


def _holds(condition: bool) -> None:
    assert condition


@pytest.mark.parametrize(
    "name", every_day(["figure-4"], of=["equation-27", "figure-4", "claim-letter-g"])
)
def test_a_statement_opens_what_shows_it_and_back_returns(used_tab: Page, server: str, name: str):
    item = next(i for i in ask(server, "paper")["items"] if i["id"] == name)
    open_scene(used_tab)
    used_tab.evaluate("() => { window.same = true; }")
    used_tab.locator(f'[data-statement="{name}"]').get_by_text("Show it").click()
    settle(used_tab, server)
    assert used_tab.evaluate("window.same"), "without loading the page anew"
    wanted = dict(urllib.parse.parse_qsl(item["link"].removeprefix("?")))
    found = dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(used_tab.url).query))
    assert wanted.items() <= found.items()
    expect(used_tab.get_by_test_id("force-trace")).to_be_visible()
    used_tab.go_back()
    expect(used_tab.locator(f'[data-statement="{name}"]')).to_be_visible()


@pytest.mark.verify
def test_curves_of_several_frictions_are_one_over_psi(used_tab: Page, server: str):
    open_scene(used_tab)

    def curves_agree() -> None:
        curves = trace_of(used_tab, "collapse")
        assert len(curves) == 6
        for friction, curve in zip((0.5, 1.4, 3.5), curves[::2], strict=True):
            answer = ask(
                server,
                "cut",
                along="gt_over_gn",
                kappa=5,
                mu_over_alpha=friction,
                minimum=curve["x"][0],
                maximum=curve["x"][-1],
                count=600,
            )
            np.testing.assert_allclose(curve["y"], answer["epsilon_t"], atol=1e-12)
        over_psi = [curve["y"] for curve in curves[1::2]]
        np.testing.assert_allclose(over_psi[1:], [over_psi[0]] * 2, atol=1e-12)
        # over g_t/g_n they are not one
        x = curves[0]["x"]
        others = [np.interp(x, c["x"], c["y"]) for c in curves[2::2]]
        assert np.max(np.abs(others[0] - curves[0]["y"])) > 0.2

    eventually(curves_agree, used_tab)
    expect(used_tab.get_by_test_id("collapse-said")).to_contain_text("they are one")


@pytest.mark.verify
def test_stiff_springs_stay_under_their_law_and_reach_it(used_tab: Page):
    open_scene(used_tab)

    def law_holds() -> None:
        points, law, _ = trace_of(used_tab, "stiff-law")
        assert len(points["x"]) > 1000
        limit = np.interp(points["x"], law["x"], law["y"])
        stiff = np.array(points["x"]) > 1
        over = (np.array(points["y"]) - limit)[stiff]
        # 4.4848 is the constant rounded
        assert over.max() < 1e-5
        assert over.max() > np.log10(0.98)

    eventually(law_holds, used_tab)
    expect(used_tab.get_by_test_id("stiff-law-said")).to_contain_text("4.4848")


@pytest.mark.verify
def test_most_switches_follow_their_law(used_tab: Page):
    open_scene(used_tab)

    def law_holds() -> None:
        counts, law = trace_of(used_tab, "switch-law")
        assert len(counts["x"]) == 40
        difference = 10 ** np.array(counts["y"]) - 10 ** np.array(law["y"])
        assert np.max(np.abs(difference)) <= 2.5

    eventually(law_holds, used_tab)


@pytest.mark.verify
def test_figures_of_the_paper_are_shown_with_their_captions(tab: Page, server: str):
    presets = {p["id"]: p for p in ask(server, "presets")["items"]}
    figure = presets["figure-4"]
    tab.locator('[data-preset="figure-4"]').click()
    settle(tab, server)
    assert collision_of(tab)["gt_over_gn"] == figure["gt_over_gn"]
    assert "map=switches" in tab.url
    assert "map_x=alpha_kappa" in tab.url
    caption = tab.locator(".presets .preset-source")
    expect(caption).to_contain_text("over ακ 0…20")
    # on another map the caption says nothing of it
    choose(tab, "map", "epsilon_t")
    expect(caption).not_to_contain_text("over ακ 0…20")
    tab.locator('[data-preset="figure-2"]').click()
    expect(tab.get_by_test_id("velocities")).to_be_visible()
    expect(tab.get_by_test_id("figure-caption")).to_contain_text("equal steel spheres")
    choose(tab, "velocity_law", "coulomb")
    expect(tab.get_by_test_id("figure-caption")).to_be_empty()
    visit(tab, presets["figure-1"]["link"])
    expect(tab.get_by_test_id("figure-caption")).to_contain_text("Coulomb's law")


@pytest.mark.verify
def test_the_scene_is_printed_with_its_evidence(used_tab: Page):
    open_scene(used_tab)
    used_tab.emulate_media(media="print")
    used_tab.evaluate("() => window.dispatchEvent(new Event('beforeprint'))")
    expect(used_tab.locator(".statement details p").first).to_be_visible()
    expect(used_tab.locator(".paper-filters")).to_be_hidden()
    expect(used_tab.locator(".masthead .scenes")).to_be_hidden()
    expect(used_tab.locator(".statement").last).to_be_visible()


@pytest.mark.verify
@pytest.mark.parametrize(
    ("width", "scheme"),
    [*itertools.product((390, 1440), ("light", "dark"))],
)
def test_axe_finds_nothing_to_object_to_in_the_list(used_tab: Page, width: int, scheme: str):
    used_tab.set_viewport_size({"width": width, "height": 900})
    used_tab.emulate_media(color_scheme=scheme)
    open_scene(used_tab, "&paper_verdict=fails")
    used_tab.locator(".statement summary").first.click()
    expect(used_tab.get_by_test_id("switch-law-said")).not_to_be_empty()
    rest(used_tab)
    assert objections(used_tab) == []


@pytest.mark.verify
@pytest.mark.parametrize("panel", ["collapse", "stiff_law", "switch_law"])
def test_a_result_beyond_the_paper_fills_its_frame(used_tab: Page, panel: str):
    used_tab.set_viewport_size({"width": 1440, "height": 700})
    visit(used_tab, f"/?embed={panel}")
    plot = used_tab.get_by_test_id(panel.replace("_", "-"))
    expect(used_tab.get_by_test_id(f"{panel.replace('_', '-')}-said")).not_to_be_empty()
    assert plot.bounding_box()["height"] > 450
    assert used_tab.evaluate("document.documentElement.scrollHeight") <= 700
    expect(used_tab.get_by_test_id("embed-caption")).to_be_empty()


@pytest.mark.verify
def test_the_list_stands_in_a_frame_with_its_head(used_tab: Page):
    visit(used_tab, "/?embed=paper&paper_verdict=fails")
    expect(used_tab.get_by_test_id("paper-count")).to_be_visible()
    expect(used_tab.locator(".statement").first).to_be_visible()
    expect(used_tab.get_by_test_id("scenes")).to_be_hidden()
    expect(used_tab.get_by_test_id("collapse")).to_be_hidden()


@pytest.mark.verify
def test_the_keyboard_goes_on_in_the_scene_that_was_opened(tab: Page, server: str):
    tab.locator('[data-preset="figure-1"]').focus()
    tab.keyboard.press("Enter")
    expect(tab.get_by_test_id("figure-caption")).to_contain_text("Coulomb's law")
    expect(tab.locator("#impact-controls")).to_be_focused()
    open_scene(tab)
    tab.locator('[data-statement="equation-7"] a').focus()
    tab.keyboard.press("Enter")
    settle(tab, server)
    expect(tab.locator("#controls")).to_be_focused()
