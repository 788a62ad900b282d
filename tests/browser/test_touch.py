"""On a phone one finger scrolls; resting, or on the mark, it steers; and it hits its target."""

import pytest
from explorer import collision_of, settle
from playwright.sync_api import CDPSession, Locator, Page, expect
from rest import eventually, rest

from cases import every_day

pytestmark = [pytest.mark.browser, pytest.mark.own_page]

PICTURES = {
    "crosshair": "",
    "cut-mark": "",
    "velocity-crosshair": "scene=spheres",
    "error-crosshair": "scene=accuracy",
}

STRAIGHT_UP = 300


class Finger:
    """One finger on a phone, as the browser has it from the glass."""

    def __init__(self, page: Page) -> None:
        self._page = page
        self._client: CDPSession = page.context.new_cdp_session(page)
        self._client.send("Emulation.setTouchEmulationEnabled", {"enabled": True})

    def press(self, x: float, y: float) -> None:
        self._send("touchStart", [{"x": x, "y": y}])

    def move(self, x: float, y: float) -> None:
        self._send("touchMove", [{"x": x, "y": y}])

    def lift(self) -> None:
        self._send("touchEnd", [])

    def swipe(self, x: float, y: float, up: float) -> None:
        self.press(x, y)
        for step in range(1, 11):
            self.move(x, y - up * step / 10)
            self._page.evaluate("() => new Promise((resolve) => requestAnimationFrame(resolve))")
        self.lift()

    def _send(self, kind: str, points: list[dict[str, float]]) -> None:
        self._client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})


def open_on_phone(page: Page, server: str, query: str, height: int = 844) -> None:
    page.set_viewport_size({"width": 390, "height": height})
    page.goto(f"/?{query}")
    if "step=2" not in query:
        # that step covers the result
        settle(page, server)
    rest(page)


def place(picture: Locator, x: float, y: float) -> tuple[float, float]:
    """Where a share of a picture is in the window."""
    box = picture.bounding_box()
    return box["x"] + x * box["width"], box["y"] + y * box["height"]


def in_the_middle(page: Page, name: str) -> Locator:
    picture = page.get_by_test_id(name)
    picture.evaluate("e => e.scrollIntoView({block: 'center'})")
    rest(page)
    return picture


def mark_of(picture: Locator) -> tuple[float, float]:
    shares = picture.evaluate("e => ['--x', '--y'].map((n) => e.style.getPropertyValue(n))")
    return float(shares[0]), float(shares[1])


def aside(share: float) -> float:
    """A share of a picture that is not on its mark."""
    return share - 0.25 if share > 0.5 else share + 0.25


@pytest.mark.parametrize("name", every_day(["crosshair"], of=PICTURES))
def test_a_finger_that_swipes_over_a_picture_scrolls_and_changes_nothing(
    page: Page, server: str, name: str
):
    open_on_phone(page, server, PICTURES[name])
    picture = in_the_middle(page, name)
    before, top = page.url, page.evaluate("() => scrollY")
    x, y = mark_of(picture)
    Finger(page).swipe(*place(picture, aside(x), aside(y)), STRAIGHT_UP)
    eventually(lambda: has_scrolled(page, top + STRAIGHT_UP / 2), page)
    rest(page)
    assert page.url == before


def has_scrolled(page: Page, most: float) -> None:
    assert page.evaluate("() => scrollY") > most


@pytest.mark.parametrize("name", every_day(["cut-mark"], of=PICTURES))
def test_a_finger_that_rests_takes_hold(page: Page, server: str, name: str):
    open_on_phone(page, server, PICTURES[name])
    picture = in_the_middle(page, name)
    before, top = mark_of(picture), page.evaluate("() => scrollY")
    finger = Finger(page)
    x, y = aside(before[0]), aside(before[1])
    finger.press(*place(picture, x, y))
    expect(picture).to_have_attribute("data-held", "")
    finger.move(*place(picture, x + 0.1, y - 0.1))
    finger.lift()
    expect(picture).not_to_have_attribute("data-held", "")
    rest(page)
    assert mark_of(picture)[0] == pytest.approx(x + 0.1, abs=0.02)
    assert page.evaluate("() => scrollY") == top


def test_a_finger_on_the_crosshair_steers_at_once(page: Page, server: str):
    open_on_phone(page, server, "kappa=30&gt_over_gn=2")
    picture = in_the_middle(page, "crosshair")
    top = page.evaluate("() => scrollY")
    Finger(page).swipe(*place(picture, *mark_of(picture)), 60)
    rest(page)
    assert collision_of(page)["gt_over_gn"] > 2.2
    assert page.evaluate("() => scrollY") == top


@pytest.mark.verify
def test_a_finger_that_taps_brings_the_crosshair(page: Page, server: str):
    open_on_phone(page, server, "")
    picture = in_the_middle(page, "crosshair")
    finger = Finger(page)
    finger.press(*place(picture, 0.25, 0.25))
    finger.lift()
    rest(page)
    assert mark_of(picture) == pytest.approx((0.25, 0.25), abs=0.02)


# A surface draws itself all the time: it does not come to rest.
EYE = """() => {
  const scene = document.querySelector("[data-testid=surface]")?._fullLayout?.scene._scene;
  return Object.values(scene?.getCamera().eye ?? {});
}"""


@pytest.mark.verify
def test_a_finger_scrolls_over_the_surface_and_turns_it_when_it_has_rested(page: Page):
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto("/?shape=surface")
    picture = page.get_by_test_id("surface")
    eventually(lambda: has_turned(page, []), page)
    picture.evaluate("e => e.scrollIntoView({block: 'center'})")
    eye, top = page.evaluate(EYE), page.evaluate("() => scrollY")
    finger = Finger(page)
    finger.swipe(*place(picture, 0.5, 0.5), STRAIGHT_UP)
    eventually(lambda: has_scrolled(page, top + STRAIGHT_UP / 2), page)
    assert page.evaluate(EYE) == eye
    picture.evaluate("e => e.scrollIntoView({block: 'center'})")
    top = page.evaluate("() => scrollY")
    finger.press(*place(picture, 0.5, 0.5))
    expect(picture).to_have_attribute("data-held", "")
    for step in range(1, 6):
        finger.move(*place(picture, 0.5 + 0.05 * step, 0.5))
    finger.lift()
    eventually(lambda: has_turned(page, eye), page)
    assert page.evaluate("() => scrollY") == top


def has_turned(page: Page, eye: list[float]) -> None:
    assert page.evaluate(EYE) != eye


# What is operated, as large as it or its label is: the smaller of its sides.
SIZES_OF_TARGETS = """(main) => {
  const operable = "a[href], button, input, select, summary, [role=application], [tabindex='0']";
  const found = [];
  for (const element of document.querySelectorAll(operable)) {
    const isSeen = element.checkVisibility({visibilityProperty: true});
    if (!isSeen || element.closest(".unseen, .skip")) continue;
    const boxes = [element, ...(element.labels ?? [])].map((e) => e.getBoundingClientRect());
    const side = Math.min(...["width", "height"].map((n) => Math.max(...boxes.map((b) => b[n]))));
    const least = element.matches(main) ? 44 : 24;
    if (side < least - 0.01) {
      const name = element.ariaLabel || element.textContent.trim() || element.name;
      found.push(`${name.slice(0, 40)} (${element.className}): ${side} px, not ${least}`);
    }
  }
  return found;
}"""

MAIN = (
    ".scenes a, .chip, .parameter-slider, .parameter-field, .bounce-play, .lesson-option,"
    " .lesson-turns button, .handout-tools button, .message-close, .material select, .crosshair"
)
"""What a collision or the lesson is steered with."""

SCENES = {
    "explorer": "kappa=10&alpha=0.4",
    "message": "kappa=spring",
    "real spheres": "scene=spheres&normal_restitution=0.9&radius_2_m=0.01",
    "speed and accuracy": "scene=accuracy&method=timestep",
    "paper": "scene=paper&paper_verdict=fails",
    "lesson, choice": "scene=lesson&step=1&notes=shown",
    "lesson, goal": "scene=lesson&step=8&lang=de",
    "lesson, prediction": "scene=lesson&step=2&lang=de",
    "hand-out": "scene=lesson&handout=shown",
}


@pytest.mark.parametrize("scene", every_day(["lesson, prediction"], of=SCENES))
def test_what_a_finger_is_to_hit_is_large_enough(page: Page, server: str, scene: str):
    open_on_phone(page, server, SCENES[scene])
    assert page.evaluate(SIZES_OF_TARGETS, MAIN) == []


@pytest.mark.verify
def test_what_opens_has_targets_large_enough(page: Page, server: str):
    open_on_phone(page, server, "")
    page.get_by_test_id("menu-map").click()
    rest(page)
    assert page.evaluate(SIZES_OF_TARGETS, MAIN) == []
    page.locator("#menu-map").get_by_text("Table", exact=True).click()
    rest(page)
    assert page.evaluate(SIZES_OF_TARGETS, MAIN) == []


UNREACHED = """() => [...document.querySelectorAll(".lesson-option")].filter((option) => {
  const {left, top, width, height} = option.getBoundingClientRect();
  const found = document.elementFromPoint(left + width / 2, top + height / 2);
  return top + height <= innerHeight && !option.contains(found);
}).map((option) => option.textContent)"""


# A phone whose browser keeps its bars.
@pytest.mark.verify
@pytest.mark.parametrize("step", [1, 4, 7])
def test_no_slider_lies_over_an_answer(page: Page, server: str, step: int):
    open_on_phone(page, server, f"scene=lesson&step={step}", height=664)
    options = page.locator(".lesson-option")
    expect(options).not_to_have_count(0)
    for at in (0, 100, 200, 300):
        page.evaluate("(at) => scrollTo(0, at)", at)
        assert page.evaluate(UNREACHED) == []
