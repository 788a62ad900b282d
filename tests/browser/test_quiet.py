"""The page keeps to itself: no word, no stranger, no jolt; and what matters comes first."""

import itertools
import re
import urllib.parse
from collections.abc import Iterator
from typing import Any

import pytest
from explorer import PARAMETERS, Witness, ask, settle, text, trace_of
from playwright.sync_api import Browser, Page, Route, expect
from rest import (
    LARGEST_LAYOUT_SHIFT,
    WATCH_SHIFTS,
    count_pending,
    eventually,
    layout_shift,
    rest,
)
from whole_page import PLACES

from cases import every_day

pytestmark = pytest.mark.browser

WIRE_BYTES = 1_700_000

LATER_BYTES = {"kernel": 40_000, "moving by hand": 8_000}
LATER_PARTS = {
    "kernel": ("/kernel/",),
    "moving by hand": ("/quick-draw.js", "/figures/pixels.js", "/figures/heat-image.js"),
}

# What the page may do without: it is asked for after the phenomenon, or answered late.
WHAT_CAN_WAIT = ("map", "cut", "presets", "steps", "tradeoff", "materials", "paper")


PLACES_OF_SLIDERS = [*itertools.product(PARAMETERS, ("20", "500", "970"))]


@pytest.mark.own_page
@pytest.mark.parametrize("width", every_day([390], of=[390, 1440]))
@pytest.mark.parametrize(
    "moves",
    # of each slider one, or all
    [PLACES_OF_SLIDERS[::4], pytest.param(PLACES_OF_SLIDERS, marks=pytest.mark.verify)],
    ids=["some", "all"],
)
def test_the_page_says_nothing_calls_nobody_and_does_not_jump(
    page: Page, server: str, moves: list[tuple[str, str]], width: int
):
    witness = Witness(page, server)
    page.set_viewport_size({"width": width, "height": 900})
    page.add_init_script(WATCH_SHIFTS)
    page.goto("/")
    settle(page, server)
    rest(page)
    shift = layout_shift(page)
    print(f"layout shift at {width} px: {shift:.4f}")
    assert shift < LARGEST_LAYOUT_SHIFT
    for name in ("figure-5-a", "figure-6", "stiff-limit"):
        page.locator(f"[data-preset='{name}']").click()
        settle(page, server)
    page.get_by_test_id("kappa-slider").press("ArrowLeft")
    settle(page, server)
    places = page.evaluate(PLACES)
    for name, step in moves:
        page.get_by_test_id(f"{name}-slider").fill(step)
        settle(page, server)
        assert page.evaluate(PLACES) == places, (name, step)
    page.emulate_media(color_scheme="dark")
    page.set_viewport_size({"width": 820, "height": 1180})
    settle(page, server)
    witness.assert_silence()


@pytest.mark.verify
def test_the_page_says_nothing_in_depth_nor_of_a_collision_without_a_picture(
    page: Page, server: str
):
    witness = Witness(page, server)
    page.goto("/?shape=surface")
    settle(page, server)
    # a surface never rests: Plotly asks for a frame after every frame
    expect(page.get_by_test_id("surface").locator("canvas").first).to_be_attached()
    page.get_by_test_id("kappa-field").fill("1e12")
    page.get_by_test_id("force-reason").wait_for()
    # what Chromium says of any WebGL canvas that it draws without a graphics card
    witness.words = [word for word in witness.words if "GL Driver Message" not in word]
    witness.assert_silence()


def test_the_policy_allows_scripts_of_the_page_s_own_files_alone(page: Page):
    response = page.goto("/")
    policy = dict(
        directive.strip().partition(" ")[::2]
        for directive in response.headers["content-security-policy"].split(";")
    )
    # the kernel in the page is no script, but compiled in it
    assert policy["script-src"] == "'self' 'wasm-unsafe-eval'"
    assert policy["default-src"] == "'self'"
    assert policy["object-src"] == "'none'"
    assert policy["base-uri"] == "'none'"
    html = response.text()
    for attributes, content in re.findall(r"<script([^>]*)>(.*?)</script>", html, re.DOTALL):
        if 'type="application/json"' in attributes:
            continue  # words, which no browser runs
        assert "src=" in attributes
        assert content == ""
    assert re.findall(r"<[^>]+\son\w+\s*=", html) == []
    assert "javascript:" not in html


def test_the_policy_stops_a_script_that_found_its_way_in(page: Page, server: str):
    page.goto("/")
    settle(page, server)
    page.evaluate("""() => {
      const script = document.createElement("script");
      script.textContent = "window.broken = true";
      document.body.append(script);
    }""")
    assert page.evaluate("() => window.broken") is None


@pytest.fixture
def cold_page(browser: Browser, browser_context_args: dict[str, Any]) -> Iterator[Page]:
    """A page in a context of its own, whose cache is empty."""
    with browser.new_context(**browser_context_args) as context:
        count_pending(context)
        yield context.new_page()


def test_the_phenomenon_waits_for_nothing_but_its_own_answer(cold_page: Page, server: str):
    page, held = cold_page, []

    def hold(route: Route) -> None:
        held.append(route)

    page.route(
        lambda url: url.startswith(f"{server}/api/v1/") and call_of(url) in WHAT_CAN_WAIT,
        hold,
    )
    page.goto("/", wait_until="commit")
    settle(page, server)
    answer = ask(server, "collision", kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358)
    assert text(page, "switches") == str(answer["switches"])
    expect(page.locator("[data-testid=force-trace] .js-line").last).to_have_attribute(
        "d", re.compile(".{500}")
    )
    assert max(len(curve["x"]) for curve in trace_of(page, "force-trace")) > 100
    eventually(lambda: held_are({"map", "presets"}, held), page)
    for route in held:
        route.continue_()
    page.unroute_all()
    rest(page)
    assert page.get_by_test_id("map").locator("svg").count() > 0


def call_of(url: str) -> str:
    return urllib.parse.urlsplit(url).path.rpartition("/")[2]


def held_are(wanted: set[str], held: list[Route]) -> None:
    assert {call_of(route.request.url) for route in held} == wanted


@pytest.mark.parametrize("face", every_day(["expert"], of=["plain", "expert"]))
def test_the_first_view_takes_few_bytes(cold_page: Page, server: str, face: str):
    page = cold_page

    def is_compressed() -> None:
        answer = page.request.head("/assets/plotly.min.js", headers={"Accept-Encoding": "br"})
        assert answer.headers["content-encoding"] == "br", "plotly.js is still being compressed"

    eventually(is_compressed, page)
    received: dict[str, int] = {}
    # that come after the first picture
    parts: dict[str, set[str]] = {part: set() for part in LATER_PARTS}
    client = page.context.new_cdp_session(page)
    client.send("Network.enable")

    def note(event: dict) -> None:
        for part, addresses in LATER_PARTS.items():
            if any(address in event["request"]["url"] for address in addresses):
                parts[part].add(event["requestId"])

    client.on("Network.requestWillBeSent", note)
    client.on(
        "Network.loadingFinished",
        lambda event: received.update({event["requestId"]: event["encodedDataLength"]}),
    )
    page.goto(f"/?face={face}")
    settle(page, server)
    rest(page)
    later = {part: sum(map(received.pop, its)) for part, its in parts.items()}
    total = sum(received.values())
    for part, size in later.items():
        print(f"{part}, after the first picture: {size / 1e3:.1f} kB")
        assert 0 < size <= LATER_BYTES[part]
    print(f"first view, {face}: {total / 1e6:.3f} MB over the wire in {len(received)} answers")
    assert len(received) > 10
    assert total <= WIRE_BYTES
