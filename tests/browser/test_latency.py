"""How long after an input the answer is on the screen; printed beside an empty page's figure.

The makefile runs these tests in a process of their own: two at a time would measure each other.
"""

import statistics

import numpy as np
import pytest
from explorer import agrees, settle
from playwright.sync_api import Page

pytestmark = pytest.mark.browser

LONG = pytest.mark.verify
"""Every control takes minutes; in each run some stand for the others."""

RECORD = """() => {
  window.recorded = [];
  addEventListener("restitution:painted", (event) => window.recorded.push(event.detail));
}"""

# The same path with nothing to do: an input event, a frame, a task posted from that frame.
EMPTY = """() => {
  window.recorded = [];
  const slider = document.querySelector("input");
  const channel = new MessageChannel();
  const waiting = [];
  channel.port1.onmessage = () => {
    const inputTimeStamp = waiting.shift();
    window.recorded.push({view: "empty", inputTimeStamp, paintedAt: performance.now()});
  };
  slider.addEventListener("input", (event) => {
    slider.title = event.timeStamp;
    requestAnimationFrame(() => { waiting.push(event.timeStamp); channel.port2.postMessage(0); });
  });
}"""


# In the page and not by page.route, whose handlers would hold up the mouse of this same thread.
SLOW_NETWORK = """
window.addedDelay = 0;
window.underWay = {};
window.mostUnderWay = {};
const direct = window.fetch;
window.fetch = async (...request) => {
  const { pathname } = new URL(request[0], location);
  const body = JSON.parse(request[1]?.body ?? "{}");
  // One address serves the map of velocities and, with two columns, the cut beside it.
  const isCut = body.normal_velocity_m_s?.count === 2;
  const call = isCut ? "scaling/cut" : pathname.replace("/api/v1/", "");
  underWay[call] = (underWay[call] ?? 0) + 1;
  mostUnderWay[call] = Math.max(mostUnderWay[call] ?? 0, underWay[call]);
  try {
    await new Promise((resolve) => setTimeout(resolve, addedDelay));
    return await direct(...request);
  } finally {
    underWay[call] -= 1;
  }
};
"""


def drag(page: Page, place, seconds: float = 3.0, *, across: bool = False) -> None:
    """Drag to and fro, or round on the map, a step every 16 ms as a mouse sends them."""
    box = place.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for phase in np.linspace(0, 2 * np.pi, int(seconds / 0.016)):
        down = 0.3 * np.sin(2 * phase) * box["height"] if across else 0
        page.mouse.move(x + 0.35 * np.sin(phase) * box["width"], y + down)
        page.wait_for_timeout(8)
    page.mouse.up()


def empty_page(page: Page, server: str) -> list[float]:
    page.goto(f"{server}/healthz")
    page.set_content("<input type=range max=1000 style='width: 300px'>")
    page.evaluate(EMPTY)
    drag(page, page.locator("input"), 1.5)
    return latencies(page, "empty")


def latencies(page: Page, view: str) -> list[float]:
    records = page.evaluate("() => window.recorded")
    return [r["paintedAt"] - r["inputTimeStamp"] for r in records if r["view"] == view]


def summary(times: list[float]) -> str:
    p95 = np.percentile(times, 95)
    return f"median {statistics.median(times):5.1f} ms, p95 {p95:5.1f} ms of {len(times)}"


@pytest.mark.parametrize(
    "name",
    [
        "kappa",
        pytest.param("mu-over-alpha", marks=LONG),
        pytest.param("gt-over-gn", marks=LONG),
        pytest.param("damping", marks=LONG),
    ],
)
def test_force_trace_and_result_follow_a_drag(page: Page, server: str, name: str, capsys):
    page.goto("/")
    settle(page, server)
    page.evaluate(RECORD)
    drag(page, page.get_by_test_id(f"{name}-slider"))
    settle(page, server)
    times = latencies(page, "force-trace")
    empty = empty_page(page, server)
    with capsys.disabled():
        print(f"\n{name}: {summary(times)}; an empty page: {summary(empty)}")
    assert len(times) > 60
    # the goals are a median of 33 ms and a p95 of 60 ms; a shared machine's noise gets twice that
    # median, and any p95
    assert statistics.median(times) < 66


@pytest.mark.parametrize("delay", [pytest.param(0, marks=LONG), pytest.param(100, marks=LONG), 500])
@pytest.mark.parametrize(
    "name",
    [
        pytest.param("kappa", marks=LONG),
        "mu-over-alpha",
        pytest.param("gt-over-gn", marks=LONG),
        pytest.param("map", marks=LONG),
    ],
)
def test_strip_and_crosshair_follow_at_once_over_a_slow_network(
    page: Page, server: str, name: str, delay: int, capsys
):
    page.add_init_script(SLOW_NETWORK)
    page.goto("/")
    settle(page, server)
    page.evaluate("(delay) => { window.addedDelay = delay; }", delay)
    page.evaluate(RECORD)
    is_map = name == "map"
    drag(page, page.get_by_test_id("crosshair" if is_map else f"{name}-slider"), across=is_map)
    # More would be a queue: one request is under way, one comes after it.
    page.wait_for_timeout(500 + 2.5 * delay)
    assert agrees(page, server)
    # The last one asked for is that of the release.
    settled = latencies(page, "force-trace")[-1]
    strip, crosshair = latencies(page, "strip"), latencies(page, "crosshair")
    most = page.evaluate("() => window.mostUnderWay")
    empty = empty_page(page, server)
    with capsys.disabled():
        print(f"\n{name}, {delay} ms added: strip {summary(strip)}; crosshair {summary(crosshair)}")
        print(f"  empty page {summary(empty)}; settled after {settled:.0f} ms; under way {most}")
    assert len(crosshair) > 60
    # Beyond the map on the page its last values stand, so there are fewer of the strip.
    assert len(strip) > 30
    assert max(most.values()) <= 2
    # the goals are 150 ms after the release where nothing is added, and for each input a median of
    # 17 ms and a p95 of 33 ms; a shared machine's noise gets twice that
    assert settled < 300 + 2.2 * delay
    for times in (strip, crosshair):
        assert statistics.median(times) < 34


SPHERES_CONTROLS = ["normal-velocity-m-s", "tangential-velocity-m-s", "radius-m", "crosshair"]


@pytest.mark.parametrize(
    ("material", "name"),
    [
        pytest.param(
            material, name, marks=() if (material, name) == ("steel", "radius-m") else LONG
        )
        for material in ("steel", "alumina-on-glass")
        for name in SPHERES_CONTROLS
    ],
)
def test_impact_and_cut_follow_a_drag_of_real_spheres(
    page: Page, server: str, material: str, name: str, capsys
):
    page.add_init_script(SLOW_NETWORK)
    page.goto(f"/?scene=spheres&material={material}")
    is_map = name == "crosshair"
    place = page.get_by_test_id("velocity-crosshair" if is_map else f"{name}-slider")
    page.wait_for_load_state("networkidle")
    settle(page, server)
    page.evaluate(RECORD)
    drag(page, place, across=is_map)
    settle(page, server)
    page.wait_for_load_state("networkidle")
    times = {
        view: latencies(page, view) for view in ("impact", "result", "sphere-cut", "velocities")
    }
    most = page.evaluate("() => window.mostUnderWay")
    empty = empty_page(page, server)
    with capsys.disabled():
        print(f"\n{material}, {name}; under way {most}; an empty page: {summary(empty)}")
        for view, measured in times.items():
            print(f"  {view}: {summary(measured) if measured else 'as it was'}")
    # the cut is along g_t and the map over both: neither moves with it
    moving = {"impact", "result"} | ({"sphere-cut"} if name != "tangential-velocity-m-s" else set())
    # a request more would be a queue
    assert max(most.values()) == 1
    # the goals are a median of 33 ms and a p95 of 60 ms; a shared machine's noise gets twice that
    # median, and any p95
    for view in moving:
        assert len(times[view]) > 60
        assert statistics.median(times[view]) < 66
