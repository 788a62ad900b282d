"""The lesson: walked by mouse and by keyboard in its languages, cited, switched, looked up."""

import itertools
import re

import pytest
from explorer import Witness, agrees, collision_of, settle, trace_of, visit
from lesson import (
    HANDS,
    LANGUAGES,
    PREDICTIONS,
    SHARES,
    STEPS,
    Texts,
    next_by_mouse,
    read,
    says,
    tab_to,
)
from playwright.sync_api import Browser, Page, expect
from rest import eventually, rest

from cases import every_day, left_to_verify

pytestmark = pytest.mark.browser


# An answer of each kind: an option, a goal of each slider. The goals themselves are judged by
# tests/frontend/state/lesson.test.js.
SOME = ("spin", "stop", "switching", "gear", "damping", "timestep")


@pytest.mark.parametrize(
    ("language", "hands", "answered"),
    [
        left_to_verify(("de", ("mouse", "keyboard"), SOME)),
        *(
            left_to_verify((language, hands, tuple(STEPS)))
            for language, hands in zip(
                LANGUAGES, itertools.cycle((("mouse", "keyboard"), ("keyboard", "mouse")))
            )
        ),
    ],
)
def test_the_lesson_can_be_walked(
    page: Page, server: str, language: str, hands: tuple[str, str], answered: tuple[str, ...]
):
    """One hand gives the wrong answers, the other the right ones; the pages are turned in turn."""
    witness = Witness(page, server)
    texts = Texts(language)
    (err, turn), (answer, turn_next) = (HANDS[hand] for hand in hands)
    page.goto(f"/?scene=lesson&lang={language}")
    done = 0
    for i, (step, (wrong, reason, right)) in enumerate(STEPS.items()):
        says(page, "lesson-title", texts.step(step, "title"))
        if step in PREDICTIONS:
            says(page, "predict-asked", texts.step(step, "predict"))
            page.get_by_test_id("predict-anyway").click()
        says(page, "lesson-asked", texts.step(step, "question"))
        if step not in answered:
            turn(page)
            continue
        settle(page, server)
        says(page, "lesson-feedback", "" if isinstance(wrong, str) else texts.say("try"))
        err(page, wrong)
        head = texts.say("wrong" if isinstance(wrong, str) else "notYet")
        says(page, "lesson-feedback", f"{head} {texts.step(step, reason)}")
        progress = texts.say("progress", step=i + 1, of=len(STEPS), count=done)
        assert read(page, "lesson-progress") == " ".join(progress.split())
        done += 1
        answer(page, right)
        if isinstance(right, str):
            said = f"{texts.say('right')} {texts.step(step, f'reasons.{right}')}"
        else:
            said = f"{texts.say('reached')} {texts.step(step, 'verdicts.met')}"
        says(page, "lesson-feedback", said)
        says(
            page,
            "lesson-progress",
            texts.say("progress", step=i + 1, of=len(STEPS), count=done),
        )
        assert agrees(page, server)
        (turn, turn_next)[i % 2](page)
        if i + 1 < len(STEPS):
            focused = page.evaluate("() => document.activeElement.dataset.testid")
            assert focused == "lesson-title", "a reader goes on at the heading"
    expect(page.get_by_test_id("lesson")).to_be_hidden()
    settle(page, server)
    witness.assert_silence()


@pytest.mark.verify
def test_the_pictures_stay_to_be_played_with_and_start_over_ends_it(page: Page, server: str):
    page.goto("/?scene=lesson&step=3")
    page.get_by_test_id("predict-anyway").click()
    settle(page, server)
    rest(page)
    start = collision_of(page)
    box = page.get_by_test_id("crosshair").bounding_box()
    page.mouse.click(box["x"] + 0.6 * box["width"], box["y"] + 0.7 * box["height"])
    settle(page, server)
    assert collision_of(page)["kappa"] > 2 * start["kappa"]
    page.get_by_test_id("bounce-play").click()
    page.locator("[name='map'][value='switches']").check()
    expect(page.get_by_test_id("map")).to_have_attribute("aria-label", re.compile("switches"))
    page.get_by_test_id("lesson-again").click()
    settle(page, server)
    assert collision_of(page) == start
    assert "map=epsilon_t" in page.url


def test_a_goal_is_reached_where_one_lets_go_not_in_passing(page: Page, server: str):
    texts = Texts("en")
    page.goto("/?scene=lesson&step=3&lang=en")
    page.get_by_test_id("predict-anyway").click()
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


@pytest.mark.verify
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
    rest(page)
    page.reload()
    says(page, "lesson-title", texts.step("coulomb", "title"))
    third = page.locator(".lesson-link").nth(2)
    assert "step=3" in third.get_attribute("href")
    page.goto(third.get_attribute("href"))
    says(page, "lesson-title", texts.step("reversal", "title"))
    page.get_by_test_id("predict-anyway").click()
    settle(page, server)
    witness.assert_silence()


@pytest.mark.verify
def test_the_lesson_is_entered_and_left_by_the_scenes(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=500")
    settle(used_tab, server)
    scenes = used_tab.get_by_test_id("scenes")
    scenes.get_by_text("Lesson").click()
    says(used_tab, "lesson-title", Texts("en").step("spin", "title"))
    settle(used_tab, server)
    assert collision_of(used_tab)["kappa"] == 4.5
    scenes.get_by_text("Explorer").click()
    expect(used_tab.get_by_test_id("lesson")).to_be_hidden()
    used_tab.go_back()
    expect(used_tab.get_by_test_id("lesson")).to_be_visible()
    used_tab.go_back()
    expect(used_tab.get_by_test_id("lesson")).to_be_hidden()
    settle(used_tab, server)
    assert collision_of(used_tab)["kappa"] == 500


@pytest.mark.verify
def test_a_reader_of_german_is_taught_in_german(browser: Browser, server: str):
    """Which language is chosen of several: tests/frontend/state/language.test.js."""
    with browser.new_context(base_url=server, locale="de-AT") as context:
        page = context.new_page()
        page.goto("/?scene=lesson")
        says(page, "lesson-title", Texts("de").step("spin", "title"))
        expect(page.locator("html")).to_have_attribute("lang", "de")


@pytest.mark.parametrize("hand", every_day(["keyboard"], of=HANDS))
def test_the_language_can_be_switched_at_any_time(used_tab: Page, server: str, hand: str):
    visit(used_tab, "/?scene=lesson&step=4&lang=en")
    says(used_tab, "lesson-title", Texts("en").step("switching", "title"))
    used_tab.locator("[data-option='odd']").click()
    if hand == "mouse":
        used_tab.get_by_test_id("language").select_option("de")
    else:
        tab_to(used_tab, "[data-testid='language']")
        used_tab.keyboard.type("Deutsch")
    german = Texts("de")
    says(used_tab, "lesson-title", german.step("switching", "title"))
    said = f"{german.say('wrong')} {german.step('switching', 'reasons.odd')}"
    says(used_tab, "lesson-feedback", said)
    expect(used_tab.locator("html")).to_have_attribute("lang", "de")
    assert "lang=de" in used_tab.url
    used_tab.go_back()
    says(used_tab, "lesson-title", Texts("en").step("switching", "title"))
    settle(used_tab, server)


@pytest.mark.verify
def test_another_language_waits_for_the_server_and_loses_no_picture(page: Page, server: str):
    page.goto("/?lang=en")
    settle(page, server)
    page.route("**/api/**", lambda route: route.abort())
    page.get_by_test_id("language").select_option("de")
    expect(page.get_by_test_id("banner")).not_to_be_empty()
    expect(page.get_by_test_id("language")).to_have_value("en")
    expect(page.locator("html")).to_have_attribute("lang", "en")
    assert trace_of(page, "force-trace")
    page.unroute_all()
    expect(page.get_by_test_id("banner")).to_be_empty()
    page.get_by_test_id("language").select_option("de")
    expect(page.locator("html")).to_have_attribute("lang", "de")
    settle(page, server)


@pytest.mark.verify
def test_teachers_have_their_notes(used_tab: Page, server: str):
    visit(used_tab, "/?scene=lesson&lang=de")
    texts = Texts("de")
    says(used_tab, "lesson-title", texts.step("spin", "title"))
    expect(used_tab.get_by_test_id("lesson-notes")).to_be_hidden()
    used_tab.get_by_test_id("lesson-notes-switch").check()
    for i, step in enumerate(STEPS):
        says(used_tab, "lesson-title", texts.step(step, "title"))
        notes = read(used_tab, "lesson-notes")
        for key in ("aim", "answer", "misconception"):
            assert " ".join(texts.step(step, key).split()) in notes
        assert "Minuten" in notes
        if i + 1 < len(STEPS):
            next_by_mouse(used_tab)
    assert "notes=shown" in used_tab.url
    settle(used_tab, server)


@pytest.mark.verify
def test_the_lesson_costs_nothing_until_it_is_opened(page: Page, server: str):
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto("/")
    settle(page, server)
    rest(page)
    assert not any("lesson/lesson.js" in url for url in asked)
    page.get_by_test_id("scenes").get_by_text("Lesson").click()
    says(page, "lesson-title", Texts("en").step("spin", "title"))
    assert any("lesson/lesson.js" in url for url in asked)
    assert not any("/locales/" in url for url in asked)


@pytest.mark.parametrize("part", every_day(["desk.css"], of=["lesson.js", "desk.css"]))
def test_the_lesson_comes_once_the_server_is_back(page: Page, server: str, part: str):
    page.goto("/")
    settle(page, server)
    page.route(f"**/lesson/{part}", lambda route: route.abort())
    page.get_by_test_id("scenes").get_by_text("Lesson").click()
    expect(page.get_by_test_id("banner")).not_to_be_empty()
    page.unroute_all()
    eventually(lambda: says(page, "lesson-title", Texts("en").step("spin", "title")), page)
    expect(page.get_by_test_id("banner")).to_be_empty()
    rules = page.evaluate("""() => [...document.querySelectorAll("link[data-comes-with=lesson]")]
        .map((link) => link.sheet?.cssRules.length ?? 0)""")
    assert len(rules) == 5
    assert min(rules) > 0
