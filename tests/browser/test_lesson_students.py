"""The lesson as students take it, with care and without; what it hides until they guess."""

import pytest
from explorer import Witness, ask, settle, visit
from lesson import (
    HANDS,
    LANGUAGES,
    LEAVES,
    PREDICTING,
    PREDICTIONS,
    STEPS,
    Answer,
    Texts,
    by_keyboard,
    next_by_mouse,
    predict_by_keyboard,
    read,
    says,
    tab_to,
)
from playwright.sync_api import Page, Route, expect
from rest import eventually, rest
from test_access import objections

pytestmark = pytest.mark.browser


def says_of_answer(page: Page, texts: Texts, head: str, key: str) -> None:
    says(page, "lesson-feedback", f"{texts.say(head)} {key}")


def reaches_leaves_and_reaches_again(
    page: Page, server: str, texts: Texts, step: str, hand: str
) -> None:
    """What is said is true of the present answer, whatever was true before."""
    answer, _ = HANDS[hand]
    wrong, reason, right = STEPS[step]
    is_choice = isinstance(right, str)
    good = (
        ("right", texts.step(step, f"reasons.{right}"))
        if is_choice
        else ("reached", texts.step(step, "verdicts.met"))
    )
    away: Answer = LEAVES.get(step, wrong)
    because = texts.step(step, reason)
    not_yet = ("wrong" if is_choice else "notYet", because)
    no_longer = ("wrong" if is_choice else "noLonger", because)
    for given, (head, said) in (
        (wrong, not_yet),
        (right, good),
        (away, no_longer),
        (right, good),
    ):
        answer(page, given)
        says_of_answer(page, texts, head, said)
        settle(page, server)


# The whole walks are long; every day, one of each kind of step.
SOME = ("spin", "collapse")


@pytest.mark.parametrize(
    ("language", "steps"),
    [
        ("de", SOME),
        *(pytest.param(language, tuple(STEPS), marks=pytest.mark.verify) for language in LANGUAGES),
    ],
)
def test_a_careful_student_reaches_every_goal_leaves_it_and_reaches_it_again(
    page: Page, server: str, language: str, steps: tuple[str, ...]
):
    witness = Witness(page, server)
    texts = Texts(language)
    page.goto(f"/?scene=lesson&lang={language}")
    came = {}
    for i, step in enumerate(STEPS):
        hand = ("mouse", "keyboard")[i % 2]
        says(page, "lesson-title", texts.step(step, "title"))
        if step in PREDICTIONS:
            says(page, "predict-asked", texts.step(step, "predict"))
            PREDICTING[hand](page, PREDICTIONS[step])
            expect(page.get_by_test_id("lesson-asked")).to_be_focused()
            settle(page, server)
            came[step] = read(page, "lesson-guess")
        if step in steps:
            says(page, "lesson-asked", texts.step(step, "question"))
            settle(page, server)
            reaches_leaves_and_reaches_again(page, server, texts, step, hand)
        if i + 1 < len(STEPS):
            HANDS[hand][1](page)
    says(
        page,
        "lesson-progress",
        texts.say("progress", step=len(STEPS), of=len(STEPS), count=len(steps)),
    )
    pairs = page.locator(".pair")
    expect(pairs).to_have_count(len(PREDICTIONS))
    for pair, step in zip(pairs.all(), PREDICTIONS, strict=True):
        thought, reality = (line.inner_text() for line in pair.locator("b").all())
        recalled = texts.say("predict.recall", guess=thought, came=reality)
        assert came[step] == " ".join(recalled.split())
        if step != "reversal":
            mark = float(thought.replace("−", "-").replace(",", "."))
            assert mark == pytest.approx(PREDICTIONS[step], abs=0.06)
    witness.assert_silence()


@pytest.mark.verify
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_careless_student_gets_through_and_is_told_of_no_guess(
    page: Page, server: str, language: str
):
    witness = Witness(page, server)
    texts = Texts(language)
    page.goto(f"/?scene=lesson&lang={language}")
    for i, (step, (wrong, reason, _)) in enumerate(STEPS.items()):
        says(page, "lesson-title", texts.step(step, "title"))
        if step in PREDICTIONS:
            page.get_by_test_id("predict-anyway").click()
            expect(page.get_by_test_id("lesson-guess")).to_be_hidden()
        if isinstance(wrong, str):
            page.locator(f"[data-option='{wrong}']").click()
            says_of_answer(page, texts, "wrong", texts.step(step, reason))
        if i + 1 < len(STEPS):
            next_by_mouse(page)
    says(page, "lesson-progress", texts.say("progress", step=len(STEPS), of=len(STEPS), count=0))
    thought = page.locator(".pair").evaluate_all(
        "(all) => all.map((p) => p.querySelector('b').innerText)"
    )
    assert thought == [texts.say("predict.none")] * len(PREDICTIONS)
    settle(page, server)
    witness.assert_silence()


@pytest.mark.verify
def test_what_was_reached_once_stays_marked_and_is_not_said_of_another_collision(
    page: Page, server: str
):
    texts = Texts("en")
    page.goto("/?scene=lesson&step=6&lang=en")
    page.get_by_test_id("predict-anyway").click()
    settle(page, server)
    by_keyboard(page, {"kappa": 0.96})
    says_of_answer(page, texts, "reached", texts.step("gear", "verdicts.met"))
    by_keyboard(page, {"kappa": 0.3})
    says_of_answer(page, texts, "noLonger", texts.step("gear", "verdicts.backward"))
    sixth = page.locator(".lesson-link").nth(5)
    expect(sixth).to_have_attribute("data-done", "")
    page.get_by_test_id("lesson-again").click()
    says(page, "lesson-feedback", texts.say("try"))
    expect(sixth).to_have_attribute("data-done", "")


# What of the page is told of a collision, and where it may be read.
TOLD = "#controls, [data-panel]"


# What a screen reader is given: the names and values of the browser's own tree.
def heard(page: Page) -> str:
    nodes = page.context.new_cdp_session(page).send("Accessibility.getFullAXTree")["nodes"]
    shown = [node for node in nodes if not node["ignored"]]
    parts = [node.get(key, {}).get("value", "") for node in shown for key in ("name", "value")]
    return " ".join(str(part) for part in parts)


@pytest.mark.own_page
def test_nothing_of_the_answer_can_be_read_before_a_guess(page: Page, server: str):
    page.goto("/?scene=lesson&step=2&lang=en")
    expect(page.get_by_test_id("predict")).to_be_visible()
    rest(page)
    assert "Before you look" in heard(page)
    assert "0.3" not in heard(page)
    assert "Slides during" not in heard(page)
    assert "switches" not in heard(page)
    for name in ("epsilon-t", "summary", "gauge-mark"):
        expect(page.get_by_test_id(name)).to_be_hidden()
    expect(page.get_by_test_id("lesson-answers")).to_be_hidden()
    for _ in range(40):
        page.keyboard.press("Tab")
        assert not page.evaluate(f"() => document.activeElement.closest('{TOLD}')")
    assert page.locator(".force .plot").evaluate("e => getComputedStyle(e).filter") != "none"
    predict_by_keyboard(page, 0.3)
    settle(page, server)
    says(
        page,
        "lesson-guess",
        Texts("en").say("predict.recall", guess="0.3", came="0.3"),
    )
    mark = page.locator(".gauge-guess")
    expect(mark).to_be_visible()
    there, now = mark.bounding_box(), page.get_by_test_id("gauge-mark").bounding_box()
    middle = there["x"] + there["width"] / 2
    assert middle == pytest.approx(now["x"] + now["width"] / 2, abs=1)
    assert "0.3000" in heard(page)
    assert "Slides during" in heard(page)
    tab_to(page, "[data-testid='kappa-field']")


@pytest.mark.own_page
def test_the_pictures_are_covered_before_the_lesson_is_here(page: Page, server: str):
    held: list[Route] = []

    def hold(route: Route) -> None:
        held.append(route)

    page.route("**/scenes/lesson/scene.js", hold)
    page.goto("/?scene=lesson&step=2")
    eventually(lambda: expect(page.get_by_test_id("epsilon-t")).not_to_have_text("–"), page)
    expect(page.get_by_test_id("epsilon-t")).to_be_hidden()
    expect(page.get_by_test_id("summary")).to_be_hidden()
    held[0].continue_()
    expect(page.get_by_test_id("predict")).to_be_visible()
    page.get_by_test_id("predict-anyway").click()
    settle(page, server)


@pytest.mark.verify
def test_the_glass_goes_with_the_lesson_and_comes_with_it(used_tab: Page, server: str):
    visit(used_tab, "/?scene=lesson&step=6&kappa=4.5&gt_over_gn=0.2")
    expect(used_tab.get_by_test_id("predict")).to_be_visible()
    used_tab.get_by_test_id("scenes").locator("a").first.click()
    settle(used_tab, server)
    assert used_tab.locator("[inert]").count() == 0
    used_tab.go_back()
    expect(used_tab.get_by_test_id("predict")).to_be_visible()
    used_tab.get_by_test_id("predict-anyway").click()
    settle(used_tab, server)
    assert used_tab.locator("[inert]").count() == 0


@pytest.mark.verify
def test_the_last_step_lays_its_steps_over_the_exact_force(used_tab: Page, server: str):
    visit(used_tab, "/?scene=lesson&step=10&kappa=63&gt_over_gn=0.2")
    expect(used_tab.get_by_test_id("overlay")).to_be_visible()

    def shows(steps: int) -> None:
        curves = used_tab.get_by_test_id("overlay").evaluate(
            "plot => Object.fromEntries((plot.data ?? []).map((t) => [t.name, [...t.y]]))"
        )
        collision = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 0.2}
        exact = ask(server, "trace", **collision, samples=300)
        stepped = ask(server, "trace", **collision, method="timestep", steps=steps, samples=2)
        assert curves["exact force"] == exact["tangential_force_over_mu"]
        assert curves["force in time steps"] == stepped["method_tangential_force_over_mu"]

    eventually(lambda: shows(20), used_tab)
    by_keyboard(used_tab, {"accuracy": 4})
    eventually(lambda: shows(70), used_tab)


@pytest.mark.verify
@pytest.mark.parametrize(
    ("width", "scheme"),
    [(390, "light"), (390, "dark"), (1280, "light"), (1280, "dark")],
)
@pytest.mark.parametrize("step", [2, 3])
def test_axe_finds_nothing_to_object_to_in_a_prediction(
    used_tab: Page, width: int, scheme: str, step: int
):
    used_tab.set_viewport_size({"width": width, "height": 844})
    used_tab.emulate_media(color_scheme=scheme)
    gt = {2: 4, 3: 1.5}[step]
    visit(used_tab, f"/?scene=lesson&step={step}&kappa=4.5&gt_over_gn={gt}")
    expect(used_tab.get_by_test_id("predict")).to_be_visible()
    assert objections(used_tab) == []
