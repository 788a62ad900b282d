"""The page keeps to itself: no word, no stranger, no jolt, and it is there at once."""

import re

import pytest
from explorer import Witness, ask, eventually, settle, text, trace_of
from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.browser

LARGEST_LAYOUT_SHIFT = 0.05
WIRE_BYTES = 1_700_000
# The goal is 2 s; a machine shared with other work gets half as much again.
FIRST_VIEW_SECONDS = 3.0

# Runs before the page's own scripts; the page's policy does not concern it.
WATCH_FOR_PHENOMENON = """
window.shifts = [];
new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) {
    if (!entry.hadRecentInput) window.shifts.push(entry.value);
  }
}).observe({type: "layout-shift", buffered: true});
const isThere = () => {
  const strip = document.querySelector("[data-testid=epsilon-t]")?.textContent ?? "–";
  const lines = document.querySelectorAll("[data-testid=force-trace] .js-line");
  return strip !== "–" && [...lines].some((line) => line.getAttribute("d")?.length > 500);
};
const look = () => {
  if (isThere()) {
    requestAnimationFrame(() => setTimeout(() => { window.phenomenonAt = performance.now(); }));
  } else {
    requestAnimationFrame(look);
  }
};
look();
"""


def when_there(page: Page) -> float:
    """The milliseconds from navigation to the frame that holds strip and force trace."""

    def time() -> float:
        found = page.evaluate("() => window.phenomenonAt ?? null")
        assert found is not None
        return found

    return eventually(time, page)


@pytest.mark.parametrize("width", [390, 1440])
def test_the_page_says_nothing_calls_nobody_and_does_not_jump(page: Page, server: str, width: int):
    witness = Witness(page, server)
    page.set_viewport_size({"width": width, "height": 900})
    page.add_init_script(WATCH_FOR_PHENOMENON)
    page.goto("/")
    settle(page, server)
    page.wait_for_timeout(1000)
    shift = sum(page.evaluate("() => window.shifts"))
    print(f"layout shift at {width} px: {shift:.4f}")
    assert shift < LARGEST_LAYOUT_SHIFT
    for name in ("figure-5-a", "figure-6", "stiff-limit"):
        page.locator(f"[data-preset='{name}']").click()
        settle(page, server)
    page.get_by_test_id("kappa-slider").press("ArrowLeft")
    page.emulate_media(color_scheme="dark")
    page.set_viewport_size({"width": 820, "height": 1180})
    settle(page, server)
    assert sum(page.evaluate("() => window.shifts")) < 2 * LARGEST_LAYOUT_SHIFT
    witness.assert_silence()


def test_the_page_says_nothing_in_depth_nor_of_a_collision_without_a_picture(
    page: Page, server: str
):
    witness = Witness(page, server)
    page.goto("/?shape=surface")
    settle(page, server)
    page.get_by_test_id("surface").wait_for()
    page.wait_for_timeout(500)
    page.get_by_test_id("kappa-field").fill("1e12")
    page.get_by_test_id("force-withheld").wait_for()
    page.wait_for_timeout(500)
    # what Chromium says of any WebGL canvas that it draws without a graphics card
    witness.words = [word for word in witness.words if "GL Driver Message" not in word]
    witness.assert_silence()


def test_the_policy_allows_scripts_of_the_page_s_own_files_alone(page: Page):
    response = page.goto("/")
    policy = dict(
        directive.strip().partition(" ")[::2]
        for directive in response.headers["content-security-policy"].split(";")
    )
    scripts = policy.get("script-src", policy["default-src"])
    assert "'self'" in scripts
    for loose in ("unsafe-inline", "unsafe-eval", "*", "http", "data:"):
        assert loose not in scripts
    assert policy["object-src"] == "'none'"
    assert policy["base-uri"] == "'none'"
    html = response.text()
    for attributes, content in re.findall(r"<script([^>]*)>(.*?)</script>", html, re.DOTALL):
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


@pytest.mark.parametrize("attempts", [3, pytest.param(10, marks=pytest.mark.verify)])
def test_the_phenomenon_is_there_within_two_seconds(
    browser: Browser, server: str, attempts: int, capsys
):
    times = []
    for _ in range(attempts):
        # a context of its own has a cache of its own, empty
        context = browser.new_context(base_url=server, viewport={"width": 1440, "height": 900})
        page = context.new_page()
        page.add_init_script(WATCH_FOR_PHENOMENON)
        page.goto("/", wait_until="commit")
        times.append(when_there(page) / 1000)
        assert ask(server, "collision", kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358)["switches"]
        assert text(page, "switches").isdigit()
        assert max(len(curve["x"]) for curve in trace_of(page, "force-trace")) > 100
        context.close()
    with capsys.disabled():
        shown = ", ".join(f"{time:.2f}" for time in sorted(times))
        print(f"\nfirst view after {shown} s")
    assert sorted(times)[len(times) // 2] < FIRST_VIEW_SECONDS


def test_the_first_view_takes_few_bytes(page: Page, server: str, capsys):
    received: dict[str, int] = {}
    client = page.context.new_cdp_session(page)
    client.send("Network.enable")
    client.on(
        "Network.loadingFinished",
        lambda event: received.update({event["requestId"]: event["encodedDataLength"]}),
    )
    page.goto("/")
    settle(page, server)
    page.wait_for_timeout(1000)
    total = sum(received.values())
    with capsys.disabled():
        print(f"\nfirst view: {total / 1e6:.3f} MB over the wire in {len(received)} answers")
    assert len(received) > 10
    assert total <= WIRE_BYTES
