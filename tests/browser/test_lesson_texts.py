"""The lesson's texts: ill translated, for everybody to read, printed."""

import itertools
import re
from collections.abc import Callable

import pytest
from explorer import Witness, settle, visit
from lesson import (
    LANGUAGES,
    PREDICTIONS,
    STEPS,
    Texts,
    by_keyboard,
    next_by_mouse,
)
from page_words import change_words, changed
from playwright.sync_api import Page, expect
from rest import rest
from test_access import objections

from cases import every_day

pytestmark = pytest.mark.browser


INJECTION = (
    "<script>window.broken = true</script><img src=x onerror='window.broken = true'>"
    "<a href='javascript:window.broken = true'>$t(lesson.next) {{constructor}} "
)


HEBREW = "כמה חזק הכדור מסתובב אחרי הפגיעה בקיר, ומדוע? "

BAD_TRANSLATIONS: dict[str, Callable[[str], str]] = {
    "endless words": lambda text: text + "W" * 300,
    "many words": lambda text: (text + " ") * 8,
    "from right to left": lambda text: HEBREW + text,
    "injection": lambda text: INJECTION + text,
    "all at once": lambda text: HEBREW + INJECTION + (text + " ") * 8 + "W" * 300,
}


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


@pytest.mark.verify
@pytest.mark.own_page
@pytest.mark.parametrize("width", [320, 1440])
@pytest.mark.parametrize("kind", BAD_TRANSLATIONS)
def test_a_bad_translation_breaks_nothing(page: Page, server: str, kind: str, width: int):
    witness = Witness(page, server)
    dialogs: list[str] = []
    page.on("dialog", lambda dialog: (dialogs.append(dialog.message), dialog.dismiss()))
    ill = BAD_TRANSLATIONS[kind]
    change_words(
        page,
        lambda texts: {
            section: changed(own, ill) if section == "lesson" else own
            for section, own in texts.items()
        },
    )
    page.set_viewport_size({"width": width, "height": 900})
    page.goto("/?scene=lesson&lang=de&notes=shown")
    expect(page.get_by_test_id("lesson-asked")).not_to_be_empty()
    page.locator("[data-option='zero']").click()
    assert_nothing_overflows(page)
    for step, (wrong, _, _) in list(STEPS.items())[1:]:
        next_by_mouse(page)
        if step in PREDICTIONS:
            assert_nothing_overflows(page)
            page.get_by_test_id("predict-anyway").click()
        if isinstance(wrong, str):
            page.locator(f"[data-option='{wrong}']").click()
        assert_nothing_overflows(page)
    settle(page, server)
    page.get_by_test_id("lesson-handout").click()
    expect(page.get_by_test_id("handout")).to_be_visible()
    assert_nothing_overflows(page)
    strange = page.locator(":is(.lesson, .handout) :is(script, img, a[href^=javascript])")
    assert strange.count() == 0
    assert page.evaluate("() => window.broken") is None
    assert dialogs == []
    witness.assert_silence()


@pytest.mark.own_page
@pytest.mark.parametrize(
    "scene", every_day(["spheres"], of=["explorer", "spheres", "accuracy", "paper"])
)
def test_no_text_of_the_page_becomes_markup(page: Page, server: str, scene: str):
    witness = Witness(page, server)
    change_words(page, lambda texts: changed(texts, BAD_TRANSLATIONS["injection"]))
    page.goto(f"/?scene={scene}")
    expect(page).to_have_title(re.compile("<script>"))
    rest(page)
    assert page.locator("body :is(script, img, a[href^=javascript])").count() == 0
    assert page.evaluate("() => window.broken") is None
    witness.assert_silence()


def reach(page: Page) -> None:
    page.get_by_test_id("predict-anyway").click()
    by_keyboard(page, {"kappa": 0.96})


PLACES = {
    "wrong": ("/?scene=lesson&step=4", lambda page: page.locator("[data-option='odd']").click()),
    "covered": ("/?scene=lesson&step=6", None),
    "reached": (
        "/?scene=lesson&step=6&lang=de&notes=shown",
        reach,
    ),
    "hand-out": ("/?scene=lesson&handout=shown&notes=shown", None),
}
EVERY_DAY = [(1440, "dark", "wrong")]


@pytest.mark.parametrize(
    ("width", "scheme", "place"),
    every_day(EVERY_DAY, of=itertools.product((390, 820, 1440), ("light", "dark"), PLACES)),
)
def test_axe_finds_nothing_to_object_to(
    used_tab: Page, server: str, width: int, scheme: str, place: str
):
    address, act = PLACES[place]
    used_tab.set_viewport_size({"width": width, "height": 900})
    used_tab.emulate_media(color_scheme=scheme)
    visit(used_tab, address)
    rest(used_tab)
    expect(used_tab.locator(".lesson, .handout").filter(visible=True)).to_have_count(1)
    if act:
        act(used_tab)
        expect(used_tab.get_by_test_id("lesson-feedback")).not_to_have_text("")
        settle(used_tab, server)
        if width == 390:
            # on a phone the controls stick to the bottom, over whatever is there
            used_tab.get_by_test_id("lesson-again").evaluate(
                "e => e.scrollIntoView({block: 'center'})"
            )
    assert objections(used_tab) == []


@pytest.mark.parametrize("language", every_day(["de"], of=LANGUAGES))
def test_the_hand_out_holds_all_steps_and_prints_on_a_few_sheets(used_tab: Page, language: str):
    texts = Texts(language)
    visit(used_tab, f"/?scene=lesson&lang={language}")
    used_tab.get_by_test_id("lesson-handout").click()
    sheet = used_tab.get_by_test_id("handout")
    expect(sheet).to_be_visible()
    assert "handout=shown" in used_tab.url
    content = " ".join(sheet.inner_text().split())
    for i, step in enumerate(STEPS):
        for key in ("title", "text", "question"):
            assert " ".join(texts.step(step, key).split()) in content
        assert f"scene=lesson&step={i + 1}" in content
        for key in ("answer", "misconception"):
            assert texts.step(step, key)[:30] not in content
    used_tab.emulate_media(media="print")
    for other in ("theme", "handout-print", "result", "force-trace", "lesson"):
        expect(used_tab.get_by_test_id(other)).to_be_hidden()
    sheets = len(re.findall(rb"/Type\s*/Page\b", used_tab.pdf(prefer_css_page_size=True)))
    assert 3 <= sheets <= 5
    used_tab.emulate_media(media="screen")
    used_tab.get_by_test_id("handout-close").click()
    expect(used_tab.get_by_test_id("lesson")).to_be_visible()
    expect(used_tab.get_by_test_id("lesson-handout")).to_be_focused()
