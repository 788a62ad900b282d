"""How long after an input the answer is on the screen; printed beside an empty page's figure."""

import statistics

import numpy as np
import pytest
from explorer import settle
from playwright.sync_api import Page

pytestmark = pytest.mark.browser

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


def drag(page: Page, slider, seconds: float = 3.0) -> None:
    """Drag to and fro, a step every 16 ms as a mouse sends them."""
    box = slider.bounding_box()
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.5 * box["width"], y)
    page.mouse.down()
    for phase in np.linspace(0, 2 * np.pi, int(seconds / 0.016)):
        page.mouse.move(box["x"] + (0.5 + 0.35 * np.sin(phase)) * box["width"], y)
        page.wait_for_timeout(8)
    page.mouse.up()


def latencies(page: Page, view: str) -> list[float]:
    records = page.evaluate("() => window.recorded")
    return [r["paintedAt"] - r["inputTimeStamp"] for r in records if r["view"] == view]


def summary(times: list[float]) -> str:
    p95 = np.percentile(times, 95)
    return f"median {statistics.median(times):5.1f} ms, p95 {p95:5.1f} ms of {len(times)}"


@pytest.mark.parametrize("name", ["kappa", "mu-over-alpha", "gt-over-gn"])
def test_force_trace_and_result_follow_a_drag(page: Page, server: str, name: str, capsys):
    page.goto("/")
    settle(page, server)
    page.evaluate(RECORD)
    drag(page, page.get_by_test_id(f"{name}-slider"))
    settle(page, server)
    times = latencies(page, "force-trace")
    page.goto(f"{server}/healthz")
    page.set_content("<input type=range max=1000 style='width: 300px'>")
    page.evaluate(EMPTY)
    drag(page, page.locator("input"), 1.5)
    empty = latencies(page, "empty")
    with capsys.disabled():
        print(f"\n{name}: {summary(times)}; an empty page: {summary(empty)}")
    assert len(times) > 60
    # the goals are a median of 33 ms and a p95 of 60 ms; a shared machine's noise gets twice that
    assert statistics.median(times) < 66
    assert np.percentile(times, 95) < 120
