"""A slow server and one that is too busy: few questions at a time, and the right picture after."""

import collections
import urllib.parse

import numpy as np
import pytest
from explorer import PARAMETERS, REFUSE_KERNEL, Witness, collision_of, settle, text
from playwright.sync_api import Page, Request, expect
from rest import eventually, rest

pytestmark = pytest.mark.browser

MOST_IN_FLIGHT = 2
LEAST_WAIT = 500
"""Milliseconds before the first time that a server is asked again."""


class InFlight:
    """Counts, for each view, the requests that have been sent and not yet answered or given up."""

    def __init__(self, page: Page) -> None:
        self.now: collections.Counter[str] = collections.Counter()
        self.most: collections.Counter[str] = collections.Counter()
        self.sent: collections.Counter[str] = collections.Counter()
        page.on("request", self._begin)
        page.on("requestfinished", self._end)
        page.on("requestfailed", self._end)

    def _begin(self, request: Request) -> None:
        view = view_of(request)
        self.now[view] += 1
        self.sent[view] += 1
        self.most[view] = max(self.most[view], self.now[view])

    def _end(self, request: Request) -> None:
        self.now[view_of(request)] -= 1


def view_of(request: Request) -> str:
    return urllib.parse.urlsplit(request.url).path.rpartition("/")[2]


def delay(page: Page, milliseconds: int) -> None:
    """Let every request from now on take so much longer."""
    client = page.context.new_cdp_session(page)
    client.send("Network.enable")
    conditions = {"offline": False, "downloadThroughput": -1, "uploadThroughput": -1}
    client.send("Network.emulateNetworkConditions", conditions | {"latency": milliseconds})


def drag(page: Page, name: str, to: tuple[float, float]) -> None:
    """Drag to and fro, a step a frame, and let go at a share of the element's box."""
    box = page.get_by_test_id(name).bounding_box()
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    page.mouse.down()
    for phase in np.linspace(0, 2 * np.pi, 20):
        x, y = 0.5 + 0.3 * np.sin(phase), 0.5 + (to[1] - 0.5) * np.sin(phase)
        page.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"])
        # as a hand does: without a pause all would be one move
        page.evaluate("() => new Promise((resolve) => requestAnimationFrame(resolve))")
    page.mouse.move(box["x"] + to[0] * box["width"], box["y"] + to[1] * box["height"])
    page.mouse.up()


@pytest.mark.verify
@pytest.mark.own_page
@pytest.mark.parametrize("milliseconds", [100, 500])
def test_dragging_on_a_slow_network_asks_little_and_ends_at_the_right_place(
    page: Page, server: str, milliseconds: int
):
    witness = Witness(page, server)
    flight = InFlight(page)
    page.goto("/")
    settle(page, server)
    delay(page, milliseconds)
    for name in PARAMETERS:
        before = collision_of(page)[PARAMETERS[name]]
        drag(page, f"{name}-slider", (0.3, 0.5))
        settle(page, server)
        assert collision_of(page)[PARAMETERS[name]] < before
    drag(page, "crosshair", (0.7, 0.3))
    settle(page, server)
    # the map under the last μ/α, too
    rest(page)
    assert float(witness.last("map")["mu_over_alpha"]) == collision_of(page)["mu_over_alpha"]
    asked = {view: most for view, most in flight.most.items() if view in views(witness)}
    print(f"+{milliseconds} ms: at most in flight {asked}, sent {flight.sent['trace']} traces")
    assert max(asked.values()) <= MOST_IN_FLIGHT
    assert sum(flight.now.values()) == 0
    witness.assert_silence()


def views(witness: Witness) -> set[str]:
    return {call for call, _ in witness.calls}


@pytest.mark.own_page
def test_a_page_that_loads_slowly_becomes_right(page: Page, server: str):
    witness = Witness(page, server)
    delay(page, 500)
    page.goto("/?kappa=100&mu_over_alpha=1&gt_over_gn=0.3", wait_until="commit")
    expect(page.get_by_test_id("switches")).not_to_have_text("–")
    settle(page, server)
    assert collision_of(page) == {"kappa": 100, "mu_over_alpha": 1, "gt_over_gn": 0.3}
    witness.assert_silence()


# Runs before the page's own scripts: what waits, and how long it is told to.
NOTE_WAITS = """
window.waits = [];
const direct = window.setTimeout;
window.setTimeout = (task, wait, ...rest) => {
  window.waits.push(wait);
  return direct(task, wait, ...rest);
};
"""


@pytest.mark.own_page
def test_a_busy_server_is_asked_calmly_and_the_page_recovers(page: Page, server: str):
    page.add_init_script(NOTE_WAITS)
    page.add_init_script(REFUSE_KERNEL)
    flight = InFlight(page)
    page.goto("/")
    settle(page, server)
    rest(page)
    before = text(page, "summary")
    page.evaluate("""() => {
      window.banners = [];
      const banner = document.querySelector("[data-testid=banner]");
      const note = () => window.banners.push(banner.textContent);
      new MutationObserver(note).observe(banner, {childList: true, subtree: true});
    }""")
    busy = {"status": 503, "body": '{"detail": "too busy"}', "headers": {"Retry-After": "1"}}
    page.route("**/api/v1/**", lambda route: route.fulfill(**busy))
    page.get_by_test_id("kappa-slider").press("ArrowRight")
    page.get_by_test_id("mu-over-alpha-slider").press("ArrowRight")
    expect(page.get_by_test_id("banner")).not_to_be_empty()
    sent = flight.sent.copy()
    page.evaluate("() => { window.waits.length = 0; }")
    eventually(lambda: has_asked_again(flight, sent), page)
    # what the map knows may change; the account of the last collision stays
    assert text(page, "summary") == before
    # each of the two changes is asked for, and once more; then only whether the server answers,
    # after a wait
    asked = flight.sent - sent
    assert all(asked[view] <= 4 for view in asked if view != "collision")
    waits = [wait for wait in page.evaluate("() => window.waits") if wait >= LEAST_WAIT]
    assert asked["collision"] <= len(waits) + 1
    assert page.evaluate("() => window.banners.length") == 1
    page.unroute_all()
    expect(page.get_by_test_id("banner")).to_be_empty()
    settle(page, server)
    assert max(flight.most[view] for view in ("trace", "map", "collision")) <= MOST_IN_FLIGHT


def has_asked_again(flight: InFlight, sent: collections.Counter[str]) -> None:
    assert (flight.sent - sent)["collision"] >= 3
