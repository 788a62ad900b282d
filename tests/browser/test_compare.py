"""Collisions that are pinned: their lines and numbers beside those of the present one."""

import re
from pathlib import Path

import pytest
from explorer import Witness, ask, number, settle, visit
from playwright.sync_api import Page, expect
from rest import rest

pytestmark = pytest.mark.browser

LINES = """plot => Object.fromEntries((plot.data ?? [])
  .filter(({name}) => name.startsWith("pinned "))
  .map(({name, x, y}) => [name.slice(-1), {x: [...x], y: [...y]}]))"""

VIEWS = {"force-trace": "tangential_force_over_mu", "velocity": "tangential_velocity"}

A = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
B = {"kappa": 4.5, "mu_over_alpha": 1.4, "gt_over_gn": 3.75}
C = {"kappa": 18, "mu_over_alpha": 0.8, "gt_over_gn": 0.9, "damping": 0.3}
THREE = "pins=63,1.4,1.358;4.5,1.4,3.75;18,0.8,0.9,0.3"
PRESENT = {"kappa": 30, "mu_over_alpha": 1.25, "gt_over_gn": 1.2}
COMPARED = f"/?kappa=30&mu_over_alpha=1.25&gt_over_gn=1.2&{THREE}"

# Each row's value and difference in the order of the columns.
CELLS = """[...document.querySelectorAll(".compare tbody tr")].map((row) =>
  [...row.querySelectorAll("td")].map((cell) => [...cell.children].map((c) => c.textContent)))"""


def test_what_is_pinned_stays_as_the_api_has_it_and_is_asked_for_once(tab: Page, server: str):
    witness = Witness(tab, server)
    tab.get_by_test_id("pin").click()
    rest(tab)
    assert tab.url.endswith("&pins=63,1.4,1.358")
    asked = [query for call, query in witness.calls if call == "trace"]
    # the present one is asked for at every change
    assert [query["kappa"] for query in asked] == ["63", "63"]
    witness.calls.clear()
    for step in ("300", "500", "520"):
        tab.get_by_test_id("kappa-slider").fill(step)
        settle(tab, server)
    rest(tab)
    assert "63" not in [query["kappa"] for call, query in witness.calls if call == "trace"]
    answer = ask(server, "trace", **{k: v for k, v in asked[0].items() if k != "encoding"})
    for view, column in VIEWS.items():
        drawn = tab.get_by_test_id(view).evaluate(LINES)
        assert drawn == {"A": {"x": answer["time"], "y": answer[column]}}
    witness.assert_silence()


def test_pins_are_in_the_address_and_keep_their_letters(used_tab: Page, server: str):
    used_tab.goto(COMPARED + ";2,1,1")
    settle(used_tab, server)
    expect(used_tab.get_by_test_id("notice")).to_contain_text("not “2,1,1”")
    assert used_tab.url.endswith(THREE)
    used_tab.get_by_test_id("unpin-A").press("Enter")
    expect(used_tab.get_by_test_id("pin-B")).to_be_focused()
    assert used_tab.url.endswith(f"pins=;{THREE.split(';', 1)[1]}")
    used_tab.reload()
    settle(used_tab, server)
    rest(used_tab)
    assert sorted(used_tab.get_by_test_id("force-trace").evaluate(LINES)) == ["B", "C"]
    used_tab.get_by_test_id("pin-C").click()
    settle(used_tab, server)
    assert "kappa=18&mu_over_alpha=0.8&gt_over_gn=0.9&damping=0.3&" in used_tab.url
    used_tab.get_by_test_id("pin").click()
    expect(used_tab.get_by_test_id("notice")).to_contain_text("pinned already, as C")
    for letter in "BC":
        used_tab.get_by_test_id(f"unpin-{letter}").click()
    rest(used_tab)
    assert "pins" not in used_tab.url
    expect(used_tab.get_by_test_id("compare")).to_be_hidden()
    assert used_tab.get_by_test_id("force-trace").evaluate(LINES) == {}


def test_the_differences_are_those_of_the_api(used_tab: Page, server: str):
    visit(used_tab, COMPARED)
    settle(used_tab, server)
    rest(used_tab)
    rows = used_tab.evaluate(CELLS)
    present, *pinned = [ask(server, "collision", **each) for each in (PRESENT, A, B, C)]
    assert number(rows[0][0][0]) == float(f"{present['epsilon_t']:.4g}")
    for row, answer in zip(rows[1:], pinned, strict=True):
        for (value, difference), of, times in zip(row, quantities(), TIMES, strict=True):
            there, here = of(answer), of(present)
            # a share is given to a tenth of a percent
            shown = re.sub(r"[^\d.]*%|>\s", "", value)
            assert number(shown) == pytest.approx(times * there, rel=5e-4, abs=0.1 * (times > 1))
            off = 0 if difference == "=" else number(difference.removeprefix("+"))
            assert off == pytest.approx(times * (there - here), rel=5.1e-3, abs=1e-12)


TIMES = [1, 1, 1, 1, 1, 1, 1, 100, 1]


def quantities() -> list:
    """What the columns hold, in an answer."""
    parameters = ("kappa", "mu_over_alpha", "gt_over_gn", "damping")
    return [
        lambda answer: answer["epsilon_t"],
        *[lambda answer, key=key: answer["parameters"][key] for key in parameters],
        lambda answer: answer["switches"],
        lambda answer: answer["reversals"],
        lambda answer: answer["energy"]["dissipated_share"],
        lambda answer: answer["contact_duration"],
    ]


def test_a_frame_and_what_is_saved_of_it_hold_what_is_pinned(used_tab: Page, tmp_path: Path):
    used_tab.goto(f"{COMPARED}&embed=force")
    expect(used_tab.locator(".force .pin-key")).to_have_count(3)
    rest(used_tab)
    assert sorted(used_tab.get_by_test_id("force-trace").evaluate(LINES)) == ["A", "B", "C"]
    expect(used_tab.locator(".force .legend")).to_contain_text("C: κ = 18, μ/α = 0.8")
    expect(used_tab.get_by_test_id("compare")).to_be_hidden()
    used_tab.get_by_test_id("menu-force").click()
    with used_tab.expect_download() as download:
        used_tab.locator("#menu-force").get_by_role("button", name="SVG").click()
    download.value.save_as(tmp_path / "force.svg")
    saved = (tmp_path / "force.svg").read_text(encoding="utf-8")
    for dash in ("13px,4px", "9px,3px,2px,3px", "9px,3px,2px,3px,2px,3px"):
        assert f"stroke-dasharray: {dash};" in saved.replace(", ", ",")


@pytest.mark.verify
def test_what_is_pinned_while_the_server_is_away_comes_when_it_is_back(tab: Page):
    tab.route("**/api/**", lambda route: route.abort())
    tab.get_by_test_id("pin").click()
    expect(tab.get_by_test_id("banner")).to_contain_text("does not answer")
    assert tab.url.endswith("&pins=63,1.4,1.358")
    tab.unroute_all()
    expect(tab.get_by_test_id("banner")).to_be_empty()
    rest(tab)
    assert list(tab.get_by_test_id("velocity").evaluate(LINES)) == ["A"]
