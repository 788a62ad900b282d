"""The scene of speed and accuracy shows what the API answers, and its points are controls."""

from pathlib import Path

import numpy as np
import pytest
from explorer import Witness, ask, collision_of, settle, text, trace_of, visit
from playwright.sync_api import Page, expect
from rest import eventually, rest

from cases import every_day
from servers import serving

pytestmark = pytest.mark.browser

STEPS = "/?scene=accuracy&method=timestep&steps=100&kappa=20"


@pytest.mark.verify
def test_points_of_the_tradeoff_are_those_measured(used_tab: Page, server: str):
    visit(used_tab, "/?scene=accuracy&region=solids&statistic=median")
    stored = ask(server, "tradeoff", scene="solids")["rows"]

    def points_agree() -> None:
        curves = trace_of(used_tab, "tradeoff")[:-1]
        drawn = {
            (round(x, 9), round(y, 9)) for c in curves for x, y in zip(c["x"], c["y"], strict=True)
        }
        steps = [r for r in stored if r["options"].get("integrator") == "velocity_verlet"]
        assert steps
        for row in steps:
            x, y = np.log10([row["microseconds_per_collision"], row["error_median"]])
            assert (round(float(x), 9), round(float(y), 9)) in drawn

    eventually(points_agree, used_tab)


@pytest.mark.verify
def test_a_click_on_a_point_chooses_its_method(used_tab: Page, server: str):
    visit(used_tab, "/?scene=accuracy")
    plot = used_tab.get_by_test_id("tradeoff")
    expect(plot.locator("path.point").first).to_be_attached()
    names = plot.evaluate("plot => plot.data.map((trace) => trace.name)")
    steps = plot.locator(".scatterlayer .trace").nth(names.index("time steps, Verlet"))
    box = steps.locator("path.point").first.bounding_box()
    used_tab.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, steps=3)
    rest(used_tab)
    used_tab.mouse.down()
    used_tab.mouse.up()
    expect(used_tab.get_by_test_id("method")).to_have_value("timestep")
    settle(used_tab, server)


def test_the_map_of_the_error_is_that_of_the_api(used_tab: Page, server: str):
    visit(used_tab, STEPS)
    settle(used_tab, server)

    def cells_agree() -> None:
        cells = used_tab.get_by_test_id("error-map").evaluate(
            "plot => plot.data?.[0].z.map((row) => [...row]) ?? []"
        )
        assert cells
        answer = ask(
            server,
            "map",
            mu_over_alpha=1.4,
            kappa_count=len(cells[0]),
            gt_over_gn_count=len(cells),
            method="timestep",
            steps=100,
            quantities="error",
        )
        wanted = np.log10(np.maximum(np.abs(answer["error"]), 1e-8))
        np.testing.assert_allclose(np.array(cells), wanted, atol=1e-9)

    eventually(cells_agree, used_tab)


@pytest.mark.parametrize("damping", every_day(["&damping=0.3"], of=["", "&damping=0.3"]))
def test_steps_lie_over_the_exact_force(used_tab: Page, server: str, damping: str):
    visit(used_tab, STEPS + damping)
    settle(used_tab, server)
    answer = ask(server, "trace", **collision_of(used_tab), method="timestep", steps=100)

    def curves_agree() -> None:
        curves = [curve["y"] for curve in trace_of(used_tab, "overlay")]
        assert answer["method_tangential_force_over_mu"] in curves

    eventually(curves_agree, used_tab)
    used_tab.get_by_test_id("integrator").select_option("forward_euler")
    expect(used_tab.get_by_test_id("overlay-steps")).to_have_text("In 100 steps of")
    eventually(
        lambda: expect(used_tab.get_by_test_id("provenance")).to_contain_text("time steps"),
        used_tab,
    )
    assert "integrator=forward_euler" in used_tab.url


@pytest.mark.verify
@pytest.mark.parametrize(
    ("region", "damping"),
    [("solids", ""), ("damped", "&damping=0.3")],
)
def test_the_calculator_tells_what_the_api_tells(
    used_tab: Page, server: str, region: str, damping: str
):
    visit(used_tab, f"/?scene=accuracy&wanted_error=1e-2&region={region}{damping}")
    settle(used_tab, server)
    here = ask(server, "steps", error=1e-2, **collision_of(used_tab))["needed"]["velocity_verlet"]
    there = ask(server, "steps", error=1e-2, region=region)["needed"]["velocity_verlet"]
    wanted = [here["p95"], here["worst"], there["p95"], there["worst"]]

    def numbers_agree() -> None:
        row = used_tab.get_by_test_id("steps").locator("tbody tr").first
        shown = [cell.replace("\u202f", "") for cell in row.locator("td").all_inner_texts()]
        assert shown == [str(steps) for steps in wanted]
        tried = here["worst_tried"]
        note = used_tab.get_by_test_id("steps").locator("p")
        expect(note).to_contain_text(f"numbers from {tried['first']} to {tried['last']} were tried")

    eventually(numbers_agree, used_tab)


def test_the_slider_from_fast_to_exact_says_what_each_place_costs(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20")
    settle(used_tab, server)
    used_tab.get_by_test_id("method").select_option("timestep")
    slider = used_tab.get_by_test_id("accuracy-slider")
    bounds = []
    for notch in ("0", "9", "17"):
        slider.fill(notch)
        settle(used_tab, server)
        said = text(used_tab, "provenance")
        assert said.startswith("time steps ±")
        assert said.endswith("s")
        bounds.append(said)
    assert len(set(bounds)) == 3


def test_numbers_of_another_method_fade_at_once(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=20")
    settle(used_tab, server)
    has_faded = used_tab.get_by_test_id("method").evaluate(
        """(choice) => {
          choice.value = "timestep";
          choice.dispatchEvent(new Event("change"));
          return document.querySelector("[data-testid=result]").hasAttribute("data-stale");
        }"""
    )
    assert has_faded
    settle(used_tab, server)
    assert text(used_tab, "provenance").startswith("time steps ±")


def test_a_method_that_does_not_answer_says_so_and_the_exact_result_stands_in(
    used_tab: Page, server: str
):
    visit(used_tab, "/?kappa=5000&method=table")
    settle(used_tab, server)
    expect(used_tab.get_by_test_id("accuracy-refusal")).to_contain_text("κ from 0.01 to 1000")
    assert text(used_tab, "provenance").startswith("exact")


@pytest.mark.verify
def test_measuring_anew_shows_its_progress_and_can_be_stopped(page: Page, tmp_path: Path):
    with serving(tmp_path, tradeoff_runs=True) as server:
        page.goto(f"{server.url}/?scene=accuracy&region=solids")
        button = page.get_by_test_id("remeasure")
        progress = page.get_by_label("Progress of the measurement")
        expect(button).to_have_text("Measure anew")
        button.click()
        expect(button).to_have_text("Stop")
        expect(progress).to_be_visible()
        button.click()
        expect(button).to_have_text("Measure anew")
        expect(progress).to_be_hidden()


def test_measuring_anew_is_not_offered_where_it_is_off(used_tab: Page):
    visit(used_tab, "/?scene=accuracy")
    expect(used_tab.get_by_test_id("tradeoff-source")).to_contain_text("Measured")
    expect(used_tab.get_by_test_id("remeasure")).to_be_hidden()


@pytest.mark.verify
def test_steps_are_asked_for_once_and_only_where_they_are_shown(used_tab: Page, server: str):
    witness = Witness(used_tab, server)

    def asked() -> int:
        stepped = [q for call, q in witness.calls if call == "trace" and "steps" in q]
        return len(stepped)

    visit(used_tab, STEPS)
    settle(used_tab, server)
    eventually(
        lambda: expect(used_tab.get_by_test_id("overlay-name")).to_contain_text("off by"), used_tab
    )
    rest(used_tab)
    assert asked() == 1
    used_tab.get_by_role("link", name="Explorer").click()
    for kappa in ("30", "40", "50"):
        used_tab.get_by_test_id("kappa-field").fill(kappa)
        settle(used_tab, server)
    assert asked() == 1
