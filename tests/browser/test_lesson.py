"""The lesson: walked by mouse and by keyboard in both languages, cited, ill translated, printed."""

import json
import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from explorer import Witness, agrees, collision_of, eventually, settle
from playwright.sync_api import Browser, Page, Route, expect
from test_access import objections

pytestmark = pytest.mark.browser

LOCALES = Path(__file__).parents[2] / "frontend" / "locales"
LANGUAGES = ("en", "de")

SYMBOLS = {
    "epsilon_t": "εt",
    "epsilon_n": "εn",
    "kappa": "κ",
    "mu_over_alpha": "μ/α",
    "gt_over_gn": "gt/gn",
    "damping": "η",
    "psi": "ψ",
    "mu": "μ",
    "gt": "gt",
}

Answer = str | dict[str, float]

# Each step with an answer that is wrong, what is said to it, and one that is right: an option, or
# values of controls; `accuracy` is a notch between fast and exact.
STEPS: dict[str, tuple[Answer, str, Answer]] = {
    "spin": ("plus", "reasons.plus", "minus"),
    "stop": ({"gt-over-gn": 3.5}, "verdicts.forward", {"gt-over-gn": 2.8}),
    "reversal": ({"kappa": 10}, "verdicts.few", {"kappa": 63}),
    "switching": ("any", "reasons.any", "even"),
    "coulomb": ({"gt-over-gn": 2}, "verdicts.sticks", {"gt-over-gn": 3.2}),
    "gear": ({"kappa": 2}, "verdicts.backward", {"kappa": 0.96}),
    "stiff": ("root", "reasons.root", "power"),
    "collapse": ({"mu-over-alpha": 2.8}, "verdicts.apart", {"gt-over-gn": 1.4}),
    "damping": ({"kappa": 30}, "verdicts.even", {"damping": 0.2}),
    "timestep": ({"accuracy": 0}, "verdicts.sign", {"accuracy": 6}),
}

# Where the thumb stands for a value, as a share of the slider.
SHARES: dict[str, Callable[[float], float]] = {
    "kappa": lambda value: math.log10(value / 0.1) / 4,
    "mu-over-alpha": lambda value: value / 4,
    "gt-over-gn": lambda value: math.sqrt(value / 4),
    "damping": lambda value: math.sqrt(value / 1.5),
    "accuracy": lambda notch: notch / 17,
}


class Texts:
    """What the lesson says in a language, as it is to be read on the page."""

    def __init__(self, language: str) -> None:
        content = (LOCALES / f"{language}.json").read_text(encoding="utf-8")
        self._texts = json.loads(content)["lesson"]

    def say(self, key: str, **values: object) -> str:
        found = self._texts
        for name in key.split("."):
            found = found[name]
        known = SYMBOLS | {name: str(value) for name, value in values.items()}
        return re.sub(r"{{(\w+)}}", lambda match: known[match[1]], found)

    def step(self, step: str, key: str) -> str:
        return self.say(f"steps.{step}.{key}")


def read(page: Page, name: str) -> str:
    """A text of the page in letters alone, however it breaks its lines."""
    return " ".join(page.get_by_test_id(name).inner_text().split())


def says(page: Page, name: str, wanted: str) -> None:
    def check() -> None:
        assert read(page, name) == " ".join(wanted.split())

    eventually(check, page)


def by_mouse(page: Page, answer: Answer) -> None:
    if isinstance(answer, str):
        page.locator(f"[data-option='{answer}']").click()
        return
    for name, value in answer.items():
        slider = page.get_by_test_id(f"{name}-slider")
        slider.scroll_into_view_if_needed()
        box = slider.bounding_box()
        thumb = 9 if name != "accuracy" else 8
        width = box["width"] - 2 * thumb
        now = slider.evaluate("s => (s.value - s.min) / (s.max - s.min)")
        y = box["y"] + box["height"] / 2
        page.mouse.move(box["x"] + thumb + now * width, y)
        page.mouse.down()
        page.mouse.move(box["x"] + thumb + SHARES[name](value) * width, y, steps=4)
        page.mouse.up()


def tab_to(page: Page, selector: str) -> None:
    for _ in range(120):
        if page.evaluate("(wanted) => document.activeElement.matches(wanted)", selector):
            return
        page.keyboard.press("Tab")
    pytest.fail(f"the Tab key does not come to {selector}")


def by_keyboard(page: Page, answer: Answer) -> None:
    if isinstance(answer, str):
        tab_to(page, f"[data-option='{answer}']")
        page.keyboard.press("Enter")
        return
    for name, value in answer.items():
        if name == "accuracy":
            tab_to(page, "[data-testid='accuracy-slider']")
            page.keyboard.press("Home")
            for _ in range(int(value)):
                page.keyboard.press("ArrowRight")
        else:
            tab_to(page, f"[data-testid='{name}-field']")
            page.keyboard.press("Control+A")
            page.keyboard.type(str(value))
            page.keyboard.press("Enter")


def next_by_mouse(page: Page) -> None:
    page.get_by_test_id("lesson-next").click()


def next_by_keyboard(page: Page) -> None:
    tab_to(page, "[data-testid='lesson-next']")
    page.keyboard.press("Enter")


HANDS = {"mouse": (by_mouse, next_by_mouse), "keyboard": (by_keyboard, next_by_keyboard)}


@pytest.mark.parametrize("hand", HANDS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_the_lesson_can_be_walked(page: Page, server: str, language: str, hand: str):
    witness = Witness(page, server)
    texts = Texts(language)
    answer, turn = HANDS[hand]
    page.goto(f"/?scene=lesson&lang={language}")
    for i, (step, (wrong, reason, right)) in enumerate(STEPS.items()):
        says(page, "lesson-title", texts.step(step, "title"))
        says(page, "lesson-asked", texts.step(step, "question"))
        settle(page, server)
        says(page, "lesson-feedback", "" if isinstance(wrong, str) else texts.say("try"))
        answer(page, wrong)
        head = texts.say("wrong" if isinstance(wrong, str) else "notYet")
        says(page, "lesson-feedback", f"{head} {texts.step(step, reason)}")
        assert read(page, "lesson-progress") == texts.say(
            "progress", step=i + 1, of=len(STEPS), count=i
        )
        answer(page, right)
        if isinstance(right, str):
            said = f"{texts.say('right')} {texts.step(step, f'reasons.{right}')}"
        else:
            said = f"{texts.say('reached')} {texts.step(step, 'verdicts.met')}"
        says(page, "lesson-feedback", said)
        says(
            page,
            "lesson-progress",
            texts.say("progress", step=i + 1, of=len(STEPS), count=i + 1),
        )
        assert agrees(page, server)
        turn(page)
        if i + 1 < len(STEPS):
            focused = page.evaluate("() => document.activeElement.dataset.testid")
            assert focused == "lesson-title", "a reader goes on at the heading"
    expect(page.get_by_test_id("lesson")).to_be_hidden()
    settle(page, server)
    witness.assert_silence()


def test_the_pictures_stay_to_be_played_with_and_start_over_ends_it(page: Page, server: str):
    page.goto("/?scene=lesson&step=3")
    settle(page, server)
    start = collision_of(page)
    box = page.get_by_test_id("crosshair").bounding_box()
    page.mouse.click(box["x"] + 0.6 * box["width"], box["y"] + 0.7 * box["height"])
    settle(page, server)
    assert collision_of(page)["kappa"] > 2 * start["kappa"]
    page.get_by_test_id("contact-play").click()
    page.locator("[name='map'][value='switches']").check()
    expect(page.get_by_test_id("map")).to_have_attribute("aria-label", re.compile("switches"))
    page.get_by_test_id("lesson-again").click()
    settle(page, server)
    assert collision_of(page) == start
    assert "map=epsilon_t" in page.url


def test_a_goal_is_reached_where_one_lets_go_not_in_passing(page: Page, server: str):
    texts = Texts("en")
    page.goto("/?scene=lesson&step=3&lang=en")
    settle(page, server)
    slider = page.get_by_test_id("kappa-slider")
    box = slider.bounding_box()
    at = {
        kappa: (box["x"] + 9 + SHARES["kappa"](kappa) * (box["width"] - 18), box["y"] + 14)
        for kappa in (4.5, 10, 63)
    }
    page.mouse.move(*at[4.5])
    page.mouse.down()
    page.mouse.move(*at[63], steps=4)
    says(page, "lesson-feedback", texts.say("there"))
    page.mouse.move(*at[10], steps=4)
    page.mouse.up()
    settle(page, server)
    says(page, "lesson-feedback", f"{texts.say('notYet')} {texts.step('reversal', 'verdicts.few')}")


def test_every_step_has_an_address_and_the_browser_turns_the_pages(page: Page, server: str):
    texts = Texts("en")
    witness = Witness(page, server)
    page.goto("/?scene=lesson&step=4&lang=en")
    says(page, "lesson-title", texts.step("switching", "title"))
    settle(page, server)
    assert collision_of(page) == {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
    page.locator("[data-option='even']").click()
    # faster than what else would be one entry of the history
    for _ in range(3):
        next_by_mouse(page)
    says(page, "lesson-title", texts.step("stiff", "title"))
    assert "step=7" in page.url
    assert "scale=log" in page.url
    for step in ("gear", "coulomb", "switching"):
        page.go_back()
        says(page, "lesson-title", texts.step(step, "title"))
    settle(page, server)
    assert collision_of(page)["kappa"] == 63
    says(page, "lesson-feedback", f"{texts.say('right')} {texts.step('switching', 'reasons.even')}")
    page.go_forward()
    says(page, "lesson-title", texts.step("coulomb", "title"))
    settle(page, server)
    page.reload()
    says(page, "lesson-title", texts.step("coulomb", "title"))
    third = page.locator(".lesson-link").nth(2)
    assert "step=3" in third.get_attribute("href")
    page.goto(third.get_attribute("href"))
    says(page, "lesson-title", texts.step("reversal", "title"))
    settle(page, server)
    witness.assert_silence()


def test_the_lesson_is_entered_and_left_by_the_scenes(page: Page, server: str):
    page.goto("/?kappa=500")
    settle(page, server)
    scenes = page.get_by_test_id("scenes")
    scenes.get_by_text("Lesson").click()
    says(page, "lesson-title", Texts("en").step("spin", "title"))
    settle(page, server)
    assert collision_of(page)["kappa"] == 4.5
    scenes.get_by_text("Explorer").click()
    expect(page.get_by_test_id("lesson")).to_be_hidden()
    page.go_back()
    expect(page.get_by_test_id("lesson")).to_be_visible()
    page.go_back()
    expect(page.get_by_test_id("lesson")).to_be_hidden()
    settle(page, server)
    assert collision_of(page)["kappa"] == 500


def test_the_language_is_the_address_s_else_the_browser_s_else_english(
    browser: Browser, server: str
):
    cases = [
        ("de-AT", "", "de"),
        ("fr-FR", "", "en"),
        ("de-DE", "&lang=en", "en"),
        ("en-US", "&lang=de", "de"),
    ]
    for locale, query, language in cases:
        context = browser.new_context(base_url=server, locale=locale)
        page = context.new_page()
        page.goto(f"/?scene=lesson{query}")
        says(page, "lesson-title", Texts(language).step("spin", "title"))
        expect(page.get_by_test_id("lesson")).to_have_attribute("lang", language)
        context.close()


@pytest.mark.parametrize("hand", HANDS)
def test_the_language_can_be_switched_at_any_time(page: Page, server: str, hand: str):
    page.goto("/?scene=lesson&step=4&lang=en")
    says(page, "lesson-title", Texts("en").step("switching", "title"))
    page.locator("[data-option='odd']").click()
    if hand == "mouse":
        page.get_by_test_id("language").select_option("de")
    else:
        tab_to(page, "[data-testid='language']")
        page.keyboard.press("ArrowDown")
    german = Texts("de")
    says(page, "lesson-title", german.step("switching", "title"))
    said = f"{german.say('wrong')} {german.step('switching', 'reasons.odd')}"
    says(page, "lesson-feedback", said)
    expect(page.get_by_test_id("lesson")).to_have_attribute("lang", "de")
    assert "lang=de" in page.url
    page.go_back()
    says(page, "lesson-title", Texts("en").step("switching", "title"))
    settle(page, server)


def test_teachers_have_their_notes(page: Page, server: str):
    page.goto("/?scene=lesson&lang=de")
    texts = Texts("de")
    says(page, "lesson-title", texts.step("spin", "title"))
    expect(page.get_by_test_id("lesson-notes")).to_be_hidden()
    page.get_by_test_id("lesson-notes-switch").check()
    for i, step in enumerate(STEPS):
        says(page, "lesson-title", texts.step(step, "title"))
        notes = read(page, "lesson-notes")
        for key in ("aim", "answer", "misconception"):
            assert " ".join(texts.step(step, key).split()) in notes
        assert "Minuten" in notes
        if i + 1 < len(STEPS):
            next_by_mouse(page)
    assert "notes=shown" in page.url
    settle(page, server)


def test_the_lesson_costs_nothing_until_it_is_opened(page: Page, server: str):
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto("/")
    settle(page, server)
    page.wait_for_timeout(500)
    late = ("/vendor/", "/locales/", "lesson-scene")
    assert [url for url in asked if any(part in url for part in late)] == []
    page.get_by_test_id("scenes").get_by_text("Lesson").click()
    says(page, "lesson-title", Texts("en").step("spin", "title"))
    assert all(any(part in url for url in asked) for part in late)
    assert not any(url.endswith("de.json") for url in asked)


INJECTION = (
    "<script>window.broken = true</script><img src=x onerror='window.broken = true'>"
    "<a href='javascript:window.broken = true'>$t(lesson.next) {{constructor}} "
)


def changed(texts: dict, change: Callable[[str], str]) -> dict:
    return {
        key: changed(value, change) if isinstance(value, dict) else change(value)
        for key, value in texts.items()
    }


HEBREW = "כמה חזק הכדור מסתובב אחרי הפגיעה בקיר, ומדוע? "

BAD_TRANSLATIONS: dict[str, Callable[[str], str]] = {
    "endless words": lambda text: text + "W" * 300,
    "many words": lambda text: (text + " ") * 8,
    "empty": lambda _: "",
    "from right to left": lambda text: HEBREW + text,
    "injection": lambda text: INJECTION + text,
}


def translate(page: Page, body: str, status: int = 200) -> None:
    def answer(route: Route) -> None:
        route.fulfill(status=status, body=body, content_type="application/json")

    page.route("**/static/locales/de.json", answer)


def assert_nothing_overflows(page: Page) -> None:
    width, room = page.evaluate(
        "() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]"
    )
    assert width <= room
    beyond = page.evaluate("""() => [...document.querySelectorAll(".lesson *, .handout *")]
        .filter((e) => e.getClientRects().length > 0
            && (e.getBoundingClientRect().right > innerWidth + 1
                || e.getBoundingClientRect().left < -1))
        .map((e) => `${e.tagName} ${e.className}`)""")
    assert beyond == []


@pytest.mark.parametrize("width", [320, pytest.param(1440, marks=pytest.mark.verify)])
@pytest.mark.parametrize("kind", BAD_TRANSLATIONS)
def test_a_bad_translation_breaks_nothing(page: Page, server: str, kind: str, width: int):
    witness = Witness(page, server)
    dialogs: list[str] = []
    page.on("dialog", lambda dialog: (dialogs.append(dialog.message), dialog.dismiss()))
    good = json.loads((LOCALES / "en.json").read_text(encoding="utf-8"))
    translate(page, json.dumps(changed(good, BAD_TRANSLATIONS[kind])))
    page.set_viewport_size({"width": width, "height": 900})
    page.goto("/?scene=lesson&lang=de&notes=shown")
    expect(page.get_by_test_id("lesson-asked")).not_to_be_empty()
    page.locator("[data-option='zero']").click()
    assert_nothing_overflows(page)
    for step, (wrong, _, _) in list(STEPS.items())[1:]:
        next_by_mouse(page)
        settle(page, server)
        if isinstance(wrong, str):
            page.locator(f"[data-option='{wrong}']").click()
        assert_nothing_overflows(page)
        if kind == "empty":
            says(page, "lesson-title", Texts("en").step(step, "title"))
    page.get_by_test_id("lesson-handout").click()
    expect(page.get_by_test_id("handout")).to_be_visible()
    assert_nothing_overflows(page)
    strange = page.locator(":is(.lesson, .handout) :is(script, img, a[href^=javascript])")
    assert strange.count() == 0
    assert page.evaluate("() => window.broken") is None
    assert dialogs == []
    witness.assert_silence()


def test_what_is_not_translated_is_said_in_english(page: Page, server: str):
    witness = Witness(page, server)
    german = json.loads((LOCALES / "de.json").read_text(encoding="utf-8"))
    del german["lesson"]["next"]
    del german["lesson"]["steps"]["spin"]["text"]
    german["lesson"]["steps"]["spin"]["options"] = {"plus": {"of": "another shape"}}
    translate(page, json.dumps(german))
    page.goto("/?scene=lesson&lang=de")
    says(page, "lesson-title", Texts("de").step("spin", "title"))
    says(page, "lesson-next", Texts("en").say("next"))
    expect(page.locator(".lesson-text")).to_contain_text("Where two balls touch")
    expect(page.locator("[data-option='minus']")).to_contain_text("= −1")
    settle(page, server)
    witness.assert_silence()


def test_a_language_that_does_not_come_is_replaced_by_english(page: Page, server: str):
    translate(page, "{}", status=404)
    page.goto("/?scene=lesson&lang=de")
    says(page, "lesson-title", Texts("en").step("spin", "title"))
    expect(page.get_by_test_id("lesson")).to_have_attribute("lang", "en")
    settle(page, server)


@pytest.mark.parametrize("part", ["lesson-scene.js", "locales/*.json"])
def test_the_lesson_comes_once_the_server_is_back(page: Page, server: str, part: str):
    page.goto("/")
    settle(page, server)
    page.route(f"**/{part}", lambda route: route.abort())
    page.get_by_test_id("scenes").get_by_text("Lesson").click()
    expect(page.get_by_test_id("banner")).not_to_be_empty()
    page.unroute_all()
    eventually(lambda: says(page, "lesson-title", Texts("en").step("spin", "title")), page)
    expect(page.get_by_test_id("banner")).to_be_empty()


PLACES = {
    "wrong": ("/?scene=lesson&step=4", lambda page: page.locator("[data-option='odd']").click()),
    "reached": (
        "/?scene=lesson&step=6&lang=de&notes=shown",
        lambda page: by_keyboard(page, {"kappa": 0.96}),
    ),
    "hand-out": ("/?scene=lesson&handout=shown&notes=shown", lambda _: None),
}


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("scheme", ["light", pytest.param("dark", marks=pytest.mark.verify)])
@pytest.mark.parametrize("width", [390, pytest.param(820, marks=pytest.mark.verify), 1440])
def test_axe_finds_nothing_to_object_to(
    page: Page, server: str, width: int, scheme: str, place: str
):
    address, act = PLACES[place]
    page.set_viewport_size({"width": width, "height": 900})
    page.emulate_media(color_scheme=scheme)
    page.goto(address)
    expect(page.get_by_test_id("lesson-asked")).not_to_be_empty()
    if place == "hand-out":
        expect(page.get_by_test_id("handout")).to_be_visible()
    else:
        settle(page, server)
        act(page)
        expect(page.get_by_test_id("lesson-feedback")).not_to_have_text("")
        settle(page, server)
        if width == 390:
            # on a phone the controls stick to the bottom, over whatever is there
            page.get_by_test_id("lesson-again").evaluate("e => e.scrollIntoView({block: 'center'})")
    assert objections(page) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_hand_out_holds_all_steps_and_prints_on_a_few_sheets(page: Page, language: str):
    texts = Texts(language)
    page.goto(f"/?scene=lesson&lang={language}")
    page.get_by_test_id("lesson-handout").click()
    sheet = page.get_by_test_id("handout")
    expect(sheet).to_be_visible()
    assert "handout=shown" in page.url
    content = " ".join(sheet.inner_text().split())
    for i, step in enumerate(STEPS):
        for key in ("title", "text", "question"):
            assert " ".join(texts.step(step, key).split()) in content
        assert f"scene=lesson&step={i + 1}" in content
        for key in ("answer", "misconception"):
            assert texts.step(step, key)[:30] not in content
    page.emulate_media(media="print")
    for other in ("theme", "handout-print", "result", "force-trace", "lesson"):
        expect(page.get_by_test_id(other)).to_be_hidden()
    sheets = len(re.findall(rb"/Type\s*/Page\b", page.pdf(prefer_css_page_size=True)))
    assert 3 <= sheets <= 5
    page.emulate_media(media="screen")
    page.get_by_test_id("handout-close").click()
    expect(page.get_by_test_id("lesson")).to_be_visible()
    expect(page.get_by_test_id("lesson-handout")).to_be_focused()
