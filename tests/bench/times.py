"""What a person waits for at the page: the first view, and what follows a hand that drags.

Prints a table and writes times.json, with the last run's figures beside. Each drag stands beside
that of an empty page, which is what browser and machine take by themselves.
"""

import statistics
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from explorer import ACQUAINTED, settle
from playwright.sync_api import Browser, BrowserContext, Locator, Page, sync_playwright
from record import report
from rest import WATCH_SHIFTS, count_pending, layout_shift, rest
from set_up_browser import ARGUMENTS, chromium_of_machine

from servers import serving

RESULTS = Path(__file__).parents[2] / "times.json"
FIRST_VIEWS = 5
DRAG_SECONDS = 3.0
SLIDERS = {"κ": "kappa", "μ/α": "mu-over-alpha", "g_t/g_n": "gt-over-gn", "η": "damping"}
NETWORKS = {"+0 ms": "0", "+100 ms": "100", "+500 ms": "500", "offline": "Infinity"}

# Runs before the page's own scripts: when strip and force trace are there.
WATCH = """
const isThere = () => {
  const strip = document.querySelector("[data-testid=epsilon-t]")?.textContent ?? "–";
  const lines = document.querySelectorAll("[data-testid=force-trace] .js-line");
  return strip !== "–" && [...lines].some((line) => line.getAttribute("d")?.length > 500);
};
const look = () => {
  if (isThere()) {
    requestAnimationFrame(() => setTimeout(() => { window.thereAt = performance.now(); }));
  } else {
    requestAnimationFrame(look);
  }
};
look();
"""

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
const direct = window.fetch;
window.fetch = async (...request) => {
  if (addedDelay === Infinity) {
    throw new TypeError("offline");
  }
  await new Promise((resolve) => setTimeout(resolve, addedDelay));
  return direct(...request);
};
"""

Figures = dict[str, float]


def main() -> None:
    figures: Figures = {}
    parts = {
        "first view": first_view,
        "explorer": explorer,
        "real spheres": spheres,
    }
    with TemporaryDirectory() as log, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium_of_machine(), args=ARGUMENTS)
        with serving(Path(log)) as server:
            for name, part in parts.items():
                print(f"{name} …", file=sys.stderr)
                figures |= part(browser, server.url)
        browser.close()
    report(figures, RESULTS)


def first_view(browser: Browser, server: str) -> Figures:
    """Return what it takes from navigation to strip and force trace, with an empty cache."""
    there, bytes_, shifts = [], [], []
    for _ in range(FIRST_VIEWS):
        context = open_context(browser)
        page = context.new_page()
        page.add_init_script(WATCH_SHIFTS)
        page.add_init_script(WATCH)
        received: dict[str, int] = {}
        client = context.new_cdp_session(page)
        client.send("Network.enable")
        client.on(
            "Network.loadingFinished",
            lambda event, received=received: received.update(
                {event["requestId"]: event["encodedDataLength"]}
            ),
        )
        page.goto(server)
        settle(page, server)
        rest(page)
        there.append(page.evaluate("() => thereAt"))
        shifts.append(layout_shift(page))
        bytes_.append(sum(received.values()))
        context.close()
    return {
        "first view, ms": statistics.median(there),
        "first view, longest, ms": max(there),
        "first view, MB over the wire": statistics.median(bytes_) / 1e6,
        "first view, layout shift": max(shifts),
    }


def explorer(browser: Browser, server: str) -> Figures:
    """Return how long after an input its views are painted, over several networks or none."""
    figures: Figures = {}
    places = {symbol: f"{name}-slider" for symbol, name in SLIDERS.items()}
    for symbol, name in (places | {"the map": "crosshair"}).items():
        for network, delay in NETWORKS.items():
            page = opened(browser, f"{server}/", server)
            page.evaluate(f"() => {{ window.addedDelay = {delay}; }}")
            drag(page, page.get_by_test_id(name), across=name == "crosshair")
            page.wait_for_timeout(1500)
            views = {view: latencies(page, view) for view in ("strip", "crosshair", "force-trace")}
            empty = empty_page(page, server)
            title = f"after dragging {symbol}, {network}"
            # the last one asked for is that of the release
            figures[f"settled {title}, ms"] = views["force-trace"][-1]
            for view, times in views.items():
                figures |= told(f"{view} {title}", times, empty)
            page.context.close()
    return figures


def spheres(browser: Browser, server: str) -> Figures:
    """Return how long after an input the views of real spheres show its answer."""
    figures: Figures = {}
    places = {
        "v_n": "normal-velocity-m-s-slider",
        "v_t": "tangential-velocity-m-s-slider",
        "R": "radius-m-slider",
        "the map": "velocity-crosshair",
    }
    for material in ("steel", "alumina-on-glass"):
        for symbol, name in places.items():
            page = opened(browser, f"{server}/?scene=spheres&material={material}", server)
            drag(page, page.get_by_test_id(name), across=symbol == "the map")
            rest(page)
            views = {view: latencies(page, view) for view in ("impact", "sphere-cut", "velocities")}
            empty = empty_page(page, server)
            for view, times in views.items():
                # the cut is along v_t and the map over both: neither moves with it
                if times:
                    figures |= told(f"{material}: {view} after dragging {symbol}", times, empty)
            page.context.close()
    return figures


def open_context(browser: Browser) -> BrowserContext:
    context = browser.new_context(viewport={"width": 1440, "height": 900}, reduced_motion="reduce")
    count_pending(context)
    context.add_init_script(SLOW_NETWORK)
    return context


def opened(browser: Browser, address: str, server: str) -> Page:
    page = open_context(browser).new_page()
    # all views are there, and follow
    page.add_init_script(ACQUAINTED)
    page.goto(address)
    settle(page, server)
    rest(page)
    page.evaluate(RECORD)
    return page


def drag(
    page: Page, place: Locator, seconds: float = DRAG_SECONDS, *, across: bool = False
) -> None:
    """Drag to and fro, or round on the map, a step every 16 ms as a mouse sends them."""
    box = place.bounding_box()
    assert box
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


def told(title: str, times: list[float], empty: list[float]) -> Figures:
    middle = statistics.median(times)
    return {
        f"{title}, ms": middle,
        f"{title}, p95, ms": float(np.percentile(times, 95)),
        f"{title}, over an empty page": middle / statistics.median(empty),
    }


if __name__ == "__main__":
    main()
