"""What a step of the lesson needs is in a projector's window, and nothing hides it on a phone."""

import itertools

import pytest
from explorer import FADE, settle
from lesson import LANGUAGES, PREDICTIONS, STEPS, Texts, says
from playwright.sync_api import Browser, Page, expect
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

# Where each goal is reached: its longest answer is on the page.
REACHED = {
    "stop": "gt_over_gn=2.8",
    "reversal": "kappa=63",
    "coulomb": "gt_over_gn=3.2",
    "gear": "kappa=0.96",
    "collapse": "mu_over_alpha=2.8&gt_over_gn=1.4",
    "damping": "damping=0.2",
    "timestep": "steps=500",
}

# The parts of the present step that reach out of the window, or a picture out of its room.
BEYOND = """() => {
  const below = [...document.querySelectorAll(".plot-panel .plot")]
    .filter((e) => e.checkVisibility())
    .map((e) => [e, e.closest(".plot-panel")].map((part) => part.getBoundingClientRect()))
    .filter(([plot, panel]) => plot.bottom > panel.bottom + 1)
    .map(([plot, panel]) => `a picture ends ${plot.bottom - panel.bottom} px below its panel`);
  const root = document.documentElement.dataset;
  const looks = root.look.split(" ").map((panel) => `[data-panel="${panel}"]`);
  const steered = (root.steers ? root.steers.split(" ") : []).map((key) => key === "steps"
    ? "[data-testid=accuracy-slider]"
    : `[data-parameter="${key.replaceAll("_", "-")}"]`);
  const ofDesk = "presenting" in root ? [] : [".lesson-turns", "[data-testid=summary]"];
  const needed = [
    ".lesson-title", ".lesson-text", ".lesson-question", "[data-testid=epsilon-t]",
    ...ofDesk, ...looks, ...steered,
  ];
  const out = needed.flatMap((selector) => {
    const element = document.querySelector(selector);
    const box = element.getBoundingClientRect();
    const ends = looks.includes(selector) ? [...element.children] : [];
    const end = Math.max(...ends.map((part) => part.getBoundingClientRect().bottom), 0);
    const isIn = box.width > 0 && box.top >= 0 && box.left >= 0 && end <= box.bottom + 1
      && box.bottom <= innerHeight && box.right <= innerWidth;
    const all = [box.top, box.bottom, end].map(Math.round);
    return isIn ? [] : [`${selector}: ${all[0]} to ${all[1]}, its parts to ${all[2]}`];
  });
  return [...below, ...out];
}"""


EVERY_DAY = [("de", "off", (1, 3)), ("de", "on", (5, 9))]
ALL_STEPS = tuple(range(len(STEPS)))


@pytest.mark.parametrize(
    ("language", "presenting", "steps"),
    every_day(
        EVERY_DAY, of=[*EVERY_DAY, *itertools.product(LANGUAGES, ("off", "on"), [ALL_STEPS])]
    ),
)
def test_all_that_a_step_needs_is_in_the_window_of_a_projector(
    page: Page, server: str, language: str, presenting: str, steps: tuple[int, ...]
):
    texts = Texts(language)
    page.set_viewport_size({"width": 1280, "height": 720})
    beyond = {}
    options = f"lang={language}&presenting={presenting}"
    for i, step in [(i, list(STEPS)[i]) for i in steps]:
        _, _, right = STEPS[step]
        page.goto(f"/?scene=lesson&step={i + 1}&{options}")
        says(page, "lesson-title", texts.step(step, "title"))
        if step in PREDICTIONS:
            page.evaluate(FADE)
            rest(page)
            beyond[f"{step}, covered"] = page.evaluate(BEYOND)
            page.get_by_test_id("predict-anyway").click()
        settle(page, server)
        if isinstance(right, str):
            for option in page.locator(".lesson-option").all():
                option.click()
                name = f"{step}, {option.get_attribute('data-option')}"
                beyond[name] = page.evaluate(BEYOND)
        else:
            page.goto(f"/?scene=lesson&step={i + 1}&{options}&{REACHED[step]}")
            settle(page, server)
            said = f"{texts.say('reached')} {texts.step(step, 'verdicts.met')}"
            says(page, "lesson-feedback", said)
            page.evaluate(FADE)
            rest(page)
            beyond[f"{step}, reached"] = page.evaluate(BEYOND)
    assert {where: parts for where, parts in beyond.items() if parts} == {}


# What lies at the middle of an element, or hides it.
ON_TOP = """(element) => {
  element.scrollIntoView({block: "nearest"});
  const {left, top, width, height} = element.getBoundingClientRect();
  return [0.1, 0.5, 0.9].every((share) => {
    const there = document.elementFromPoint(left + width / 2, top + share * height);
    return element.contains(there);
  });
}"""


@pytest.mark.parametrize("step", every_day([2, 7], of=[1, 2, 3, 4, 5, 6, 7]))
def test_on_a_phone_nothing_lies_over_an_answer(page: Page, step: int):
    page.set_viewport_size({"width": 390, "height": 844})
    page.goto(f"/?scene=lesson&step={step}&lang=de")
    expect(page.get_by_test_id("lesson-title")).not_to_be_empty()
    rest(page)
    answers = page.locator(".lesson-question button:visible, .predict-handle").all()
    assert answers
    assert [answer.evaluate(ON_TOP) for answer in answers] == [True] * len(answers)


FOR_ALL = ["[data-testid=epsilon-t]", "[data-testid=summary]", "#controls", ".force", ".bounce"]
FOR_EXPERTS = [".velocity", ".cut-panel", "[data-testid=method]", "[data-testid=switches]"]


def shown(page: Page, selectors: list[str]) -> list[bool]:
    return [page.locator(selector).first.is_visible() for selector in selectors]


def test_a_first_visit_sees_the_plain_face_and_who_wants_all_finds_it_again(
    browser: Browser, server: str
):
    with browser.new_context(base_url=server, reduced_motion="reduce") as context:
        page = context.new_page()
        page.goto("/")
        settle(page, server)
        assert shown(page, [*FOR_ALL, ".map-panel"]) == [True] * 6
        assert shown(page, FOR_EXPERTS) == [False] * 4
        assert "face" not in page.url
        page.get_by_test_id("face").click()
        assert shown(page, [*FOR_ALL, *FOR_EXPERTS]) == [True] * 9
        assert "face=expert" in page.url
        again = context.new_page()
        again.goto("/")
        settle(again, server)
        assert shown(again, FOR_EXPERTS) == [True] * 4


@pytest.mark.verify
@pytest.mark.parametrize(
    ("query", "seen"),
    [
        ("face=plain", [False] * 4),
        # which begins plain
        ("scene=lesson&step=1", [False] * 4),
        ("scene=lesson&step=1&face=expert", [True] * 4),
        # where the number is not the usual one, the way it is got is shown
        ("face=plain&method=coulomb", [False, False, True, False]),
    ],
)
def test_an_address_and_the_lesson_have_a_face_of_their_own(
    page: Page, server: str, query: str, seen: list[bool]
):
    page.goto(f"/?{query}")
    settle(page, server)
    assert shown(page, FOR_EXPERTS) == seen


@pytest.mark.verify
def test_the_hint_of_a_first_visit_is_sent_away_for_good(browser: Browser, server: str):
    with browser.new_context(base_url=server, reduced_motion="reduce") as context:
        page = context.new_page()
        hint = page.get_by_test_id("hint")
        page.goto("/")
        expect(hint).to_be_visible()
        page.goto("/?embed=force")
        expect(hint).to_be_hidden()
        page.goto("/")
        hint.get_by_role("button").click()
        expect(hint).to_be_hidden()
        page.reload()
        settle(page, server)
        expect(hint).to_be_hidden()


@pytest.mark.verify
def test_a_frame_that_may_keep_nothing_shows_and_switches_all_the_same(
    browser: Browser, server: str
):
    words: list[str] = []
    with browser.new_context(base_url=server, reduced_motion="reduce") as context:
        page = context.new_page()
        page.on("pageerror", lambda error: words.append(str(error)))
        page.add_init_script("""Object.defineProperty(window, "localStorage", {
          get() { throw new DOMException("not here", "SecurityError"); },
        });""")
        page.goto("/")
        settle(page, server)
        page.get_by_test_id("hint").get_by_role("button").click()
        expect(page.get_by_test_id("hint")).to_be_hidden()
        page.get_by_test_id("face").click()
        expect(page.locator(".velocity")).to_be_visible()
        page.get_by_test_id("face").click()
        expect(page.locator(".velocity")).to_be_hidden()
    assert words == []
