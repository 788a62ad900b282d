"""What follows a hand that drags: every picture, at every step, whatever the server takes.

How long it takes is measured by `make times`; here it is what comes, and before what.
"""

import math
from collections.abc import Iterator

import pytest
from explorer import (
    COUNT_DRAWINGS,
    REFUSE_KERNEL,
    Witness,
    agrees,
    ask,
    collision_of,
    settle,
    text,
    visit,
)
from playwright.sync_api import Locator, Page
from rest import eventually, rest
from test_truth import assert_pictured, assert_traces

from cases import every_day

pytestmark = pytest.mark.browser

SLIDERS = ["kappa", "mu-over-alpha", "gt-over-gn", "damping"]
# What is one of a kind; the others are dragged by `make verify`.
EVERY_DAY = {"kappa"}
STEPS = 4

# Notes what is painted and for which input.
RECORD = """() => {
  window.painted = {};
  window.lastInput = 0;
  addEventListener("restitution:painted", ({detail: {view, inputTimeStamp}}) => {
    (painted[view] ??= []).push(inputTimeStamp);
  });
  for (const kind of ["input", "pointermove"]) {
    addEventListener(kind, (event) => { lastInput = event.timeStamp; }, {capture: true});
  }
}"""

# Runs before the page's own scripts. Lets requests of the API wait at a gate, and counts those
# that are under way; a request that the page has given up is none.
GATE = """(() => {
  window.underWay = {};
  window.mostUnderWay = {};
  window.asked = {};
  window.begun = {};
  let open = Promise.resolve();
  let unlock = () => {};
  window.shut = () => { open = new Promise((resolve) => { unlock = resolve; }); };
  window.unlock = () => unlock();
  // The page waits for an answer for a quarter of a minute; here it waits for the test.
  AbortSignal.timeout = () => new AbortController().signal;
  const direct = window.fetch;
  window.fetch = async (url, init = {}) => {
    const body = JSON.parse(init.body ?? "{}");
    // One address serves the map of velocities and, with two columns, the cut beside it.
    const isCut = body.normal_velocity_m_s?.count === 2;
    const path = new URL(url, location).pathname.replace("/api/v1/", "");
    const call = isCut ? "scaling/cut" : path;
    underWay[call] = (underWay[call] ?? 0) + 1;
    asked[call] = (asked[call] ?? 0) + 1;
    begun[call] = (begun[call] ?? 0) + 1;
    mostUnderWay[call] = Math.max(mostUnderWay[call] ?? 0, underWay[call]);
    let isCounted = true;
    const end = () => {
      underWay[call] -= isCounted ? 1 : 0;
      isCounted = false;
    };
    init.signal?.addEventListener("abort", () => {
      asked[call] -= isCounted ? 1 : 0;
      end();
    });
    try {
      await open;
      return await direct.call(window, url, init);
    } finally {
      end();
    }
  };
})();"""


LATE = "(views) => views.filter((view) => !(painted[view]?.at(-1) >= lastInput))"


def drag(page: Page, place: Locator, *, across: bool = False) -> Iterator[None]:
    """Take a slider, or the crosshair of a map, from step to step; let go after the last."""
    box = place.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for step in range(STEPS):
        share = 0.03 * (step + 1)
        page.mouse.move(x - share * box["width"], y + (share * box["height"] if across else 0))
        yield
    page.mouse.up()


def follows(page: Page, *views: str) -> None:
    """Wait until views show the answer to the last input, or to a later one."""

    def is_painted() -> None:
        late = page.evaluate(LATE, views)
        assert late == []

    eventually(is_painted, page)


@pytest.mark.parametrize("name", every_day(EVERY_DAY, of=SLIDERS))
def test_force_trace_and_result_follow_every_step_of_a_drag(used_tab: Page, server: str, name: str):
    witness = Witness(used_tab, server)
    visit(used_tab, "/")
    settle(used_tab, server)
    rest(used_tab)
    witness.calls.clear()
    used_tab.evaluate(RECORD)
    used_tab.evaluate(COUNT_DRAWINGS)
    for _ in drag(used_tab, used_tab.get_by_test_id(f"{name}-slider")):
        follows(used_tab, "crosshair", "force-trace")
        rest(used_tab)
        assert agrees(used_tab, server)
        # the kernel's, so not to the last digit
        there = collision_of(used_tab)
        samples = max(300, math.ceil(10 * there["kappa"] ** 0.5))
        assert_pictured(used_tab, ask(server, "trace", **there, samples=samples), 1e-11)
        assert witness.last("trace") is None
        assert text(used_tab, "provenance").endswith("here")
    rest(used_tab)
    assert_traces(used_tab, server, witness, collision_of(used_tab))
    # while dragging it is moved by hand; Plotly draws it after the release, or for another axis
    if name != "damping":
        assert used_tab.evaluate("() => drawings['force-trace']") <= STEPS // 2


@pytest.mark.own_page
@pytest.mark.parametrize("name", every_day(EVERY_DAY, of=[*SLIDERS[:3], "crosshair"]))
def test_controls_strip_and_crosshair_do_not_wait_for_the_server(
    page: Page, server: str, name: str
):
    """Where a browser refuses the kernel."""
    page.add_init_script(GATE)
    page.add_init_script(REFUSE_KERNEL)
    page.goto("/")
    settle(page, server)
    rest(page)
    page.evaluate(RECORD)
    before = text(page, "summary")
    traces = page.evaluate("() => asked.trace")
    page.evaluate("() => shut()")
    is_map = name == "crosshair"
    place = page.get_by_test_id("crosshair" if is_map else f"{name}-slider")
    for _ in drag(page, place, across=is_map):
        follows(page, "crosshair", "strip")
    assert text(page, "summary") == before, "an answer came through the gate"
    # what the map knows stands in
    assert page.get_by_test_id("result").get_attribute("data-from-map") is not None
    page.evaluate("() => unlock()")
    rest(page)
    assert agrees(page, server)
    # one was under way while the hand moved, and the newest wish came after it
    assert page.evaluate("() => asked.trace") - traces <= 2
    assert max(page.evaluate("() => mostUnderWay").values()) <= 2


@pytest.mark.own_page
@pytest.mark.parametrize("name", every_day({"mu-over-alpha"}, of=[*SLIDERS, "crosshair"]))
def test_nothing_waits_for_the_server_while_a_hand_drags(page: Page, server: str, name: str):
    page.add_init_script(GATE)
    page.goto("/?bounce=wall_twice")
    settle(page, server)
    rest(page)
    page.evaluate(RECORD)
    before = page.evaluate("() => ({...begun})")
    page.evaluate("() => shut()")
    is_map = name == "crosshair"
    place = page.get_by_test_id("crosshair" if is_map else f"{name}-slider")
    for _ in drag(page, place, across=is_map):
        follows(page, "crosshair", "strip", "force-trace")
        rest(page)
        assert agrees(page, server)
        # nothing at all, nor what is given up
        assert page.evaluate("() => ({...begun})") == before
    page.evaluate("() => unlock()")
    rest(page)
    assert agrees(page, server)
    # the hand rests: the server confirms
    assert page.evaluate("() => begun.trace") == before["trace"] + 1


SPHERES = [
    ("steel", "normal-velocity-m-s"),
    ("steel", "radius-m"),
    ("alumina-on-glass", "tangential-velocity-m-s"),
    ("alumina-on-glass", "crosshair"),
]


@pytest.mark.own_page
@pytest.mark.parametrize(("material", "name"), every_day(SPHERES[3:4], of=SPHERES))
def test_impact_and_cut_follow_every_step_of_a_drag_of_real_spheres(
    page: Page, server: str, material: str, name: str
):
    page.add_init_script(GATE)
    page.goto(f"/?scene=spheres&material={material}")
    settle(page, server)
    rest(page)
    page.evaluate(RECORD)
    is_map = name == "crosshair"
    place = page.get_by_test_id("velocity-crosshair" if is_map else f"{name}-slider")
    # the cut is along g_t and the map over both: neither moves with it
    moving = ["impact", "result"] + ([] if name.startswith("tangential") else ["sphere-cut"])
    for _ in drag(page, place, across=is_map):
        follows(page, *moving)
    rest(page)
    assert agrees(page, server)
    # a request more would be a queue
    assert max(page.evaluate("() => mostUnderWay").values()) == 1
