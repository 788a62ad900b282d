"""The lesson: walked by mouse and by keyboard in both languages, cited, switched, looked up."""

import re

import pytest
from explorer import Witness, agrees, collision_of, settle
from lesson import (
    HANDS,
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

pytestmark = pytest.mark.browser


@pytest.mark.parametrize(
    ("language", "hand"),
    [
        ("en", "mouse"),
        ("de", "keyboard"),
        pytest.param("en", "keyboard", marks=pytest.mark.verify),
        pytest.param("de", "mouse", marks=pytest.mark.verify),
    ],
)
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
    rest(page)
    late = ("/vendor/", "/locales/", "lesson-scene")
    assert [url for url in asked if any(part in url for part in late)] == []
    page.get_by_test_id("scenes").get_by_text("Lesson").click()
    says(page, "lesson-title", Texts("en").step("spin", "title"))
    assert all(any(part in url for url in asked) for part in late)
    assert not any(url.endswith("de.json") for url in asked)


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
