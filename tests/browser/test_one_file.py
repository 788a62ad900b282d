"""The page as one file, opened from a folder: every scene that it offers, in every language."""

import json
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect
from rest import count_pending, rest
from scenes_of_file import OFFERED, SERVED

from cases import every_day
from restitution.api.one_file import one_file
from restitution.api.settings import Settings

pytestmark = pytest.mark.browser

FRONTEND = Settings().frontend_directory
LANGUAGES = sorted(path.stem for path in (FRONTEND / "locales").glob("*.json"))


def visit(page: Page, address: str) -> None:
    """Open the file and wait until all is drawn that is to be seen."""
    page.goto(address)
    # no timer or frame tells that it comes
    page.wait_for_function("() => 'Plotly' in globalThis")
    rest(page)


def words(language: str) -> dict:
    return json.loads((FRONTEND / "locales" / f"{language}.json").read_text("utf-8"))


class Silence:
    """What pages of a context say, and whom they ask."""

    def __init__(self, context: BrowserContext, address: str) -> None:
        self.words: list[str] = []
        self.asked: list[str] = []
        self._address = address
        context.on("console", lambda message: self.words.append(message.text))
        context.on("weberror", lambda error: self.words.append(str(error.error)))
        context.on("request", lambda request: self.note(request.url))

    def note(self, url: str) -> None:
        if not url.startswith("data:") and url.partition("?")[0] != self._address:
            self.asked.append(url)

    def assert_kept(self) -> None:
        assert (self.words, self.asked) == ([], [])


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> str:
    file = tmp_path_factory.mktemp("stick") / "restitution.html"
    file.write_text(one_file(FRONTEND), "utf-8")
    return file.as_uri()


@pytest.fixture
def offline(browser: Browser) -> Iterator[BrowserContext]:
    with browser.new_context(reduced_motion="reduce", locale="en", offline=True) as context:
        count_pending(context)
        yield context


@pytest.fixture
def silence(offline: BrowserContext, address: str) -> Silence:
    return Silence(offline, address)


@pytest.fixture
def page(offline: BrowserContext) -> Page:
    return offline.new_page()


@pytest.mark.parametrize("language", every_day(["fr"], of=LANGUAGES))
def test_every_scene_that_it_offers_is_whole_and_silent(
    page: Page, silence: Silence, address: str, language: str
):
    lost = words(language)["server"]["lost"].partition("}}")[2]
    for name, query in OFFERED.items():
        visit(page, f"{address}?{query}&lang={language}")
        assert page.evaluate("document.documentElement.lang") == language
        text = page.locator("body").inner_text()
        assert lost not in text, name
        assert page.locator("main [data-say]:visible").count() == 0, name
        wide = page.evaluate("document.documentElement.scrollWidth - innerWidth")
        assert wide <= 0, name
        # of the folder that one's own file is in nobody else learns
        assert "file:" not in text, name
        if "result" in text or name != "hand-out":
            assert page.get_by_test_id("epsilon-t").text_content() not in {"–", ""}, name
        silence.assert_kept()


@pytest.mark.parametrize("language", every_day(["de"], of=LANGUAGES))
def test_what_needs_a_server_says_so_in_the_language_of_the_page(
    page: Page, silence: Silence, address: str, language: str
):
    needed = words(language)["oneFile"]["needed"]
    visit(page, f"{address}?lang={language}")
    for scene in SERVED:
        page.get_by_test_id("scenes").get_by_text(words(language)["page"]["scenes"][scene]).click()
        rest(page)
        expect(page.locator("main > :visible")).to_have_count(1)
        expect(page.get_by_test_id("needs-server").locator("p:visible")).to_have_text(needed)
    visit(page, f"{address}?lang={language}&face=expert")
    page.get_by_test_id("method").select_option("timestep")
    expect(page.get_by_test_id("accuracy-refusal")).to_have_text(needed)
    page.get_by_test_id("method").select_option("exact")
    expect(page.get_by_test_id("accuracy-refusal")).to_have_text("")
    page.get_by_test_id("embed").click()
    expect(page.get_by_test_id("notice")).to_have_text(needed)
    silence.assert_kept()


def test_the_step_of_the_lesson_that_takes_time_steps_is_not_judged_without_them(
    page: Page, silence: Silence, address: str
):
    visit(page, f"{address}?scene=lesson&step=10")
    needed = words("en")["oneFile"]["needed"]
    expect(page.locator(".overlay .reason")).to_have_text(needed)
    expect(page.locator(".lesson-question")).to_have_attribute("data-verdict", "open")
    silence.assert_kept()


def test_a_language_is_changed_and_the_collision_stays(page: Page, silence: Silence, address: str):
    visit(page, address)
    page.get_by_test_id("kappa-field").fill("18")
    page.get_by_test_id("kappa-field").press("Enter")
    page.get_by_test_id("language").select_option("es")
    expect(page.locator("html")).to_have_attribute("lang", "es")
    expect(page.get_by_test_id("kappa-field")).to_have_value("18")
    page.go_back()
    silence.assert_kept()


@pytest.mark.parametrize(("locale", "language"), [("de-CH", "de"), ("ja-JP", "en")])
def test_it_speaks_the_language_of_the_reader_where_it_has_it(
    browser: Browser, address: str, locale: str, language: str
):
    with browser.new_context(locale=locale) as context:
        page = context.new_page()
        page.goto(address)
        expect(page.locator("html")).to_have_attribute("lang", language)
        expect(page.get_by_test_id("share")).to_have_text(words(language)["page"]["share"])


def test_pictures_are_saved_and_data_are_the_servers(page: Page, silence: Silence, address: str):
    visit(page, address)
    menu = page.locator("#menu-force")
    for name in ("SVG", "PNG"):
        page.get_by_test_id("menu-force").click()
        with page.expect_download() as saving:
            menu.get_by_text(name, exact=True).click()
        if name == "SVG":
            svg = saving.value.path().read_text("utf-8")
            assert "font/woff2;base64," in svg
    page.get_by_test_id("menu-force").click()
    menu.get_by_text("CSV", exact=True).click()
    expect(page.get_by_test_id("notice")).to_have_text(words("en")["oneFile"]["needed"])
    page.keyboard.press("Escape")
    with page.expect_download() as saving:
        page.get_by_test_id("save-all").click()
    assert saving.value.suggested_filename.endswith(".zip")
    silence.words = [word for word in silence.words if "blob:" not in word]
    silence.assert_kept()


def test_a_request_is_shown_as_a_server_at_hand_takes_it(page: Page, address: str):
    visit(page, address)
    page.get_by_test_id("menu-force").click()
    page.locator("#menu-force").get_by_text(words("en")["menu"]["request"]).click()
    expect(page.get_by_test_id("sheet")).to_contain_text("http://127.0.0.1:8000/api/v1/trace?")


@pytest.mark.parametrize("sandbox", ["allow-scripts", None])
def test_in_the_frame_of_a_course_it_changes_its_language_too(
    page: Page, silence: Silence, sandbox: str | None
):
    """As an LMS shows an upload: the address is none that could be changed."""
    page.goto("about:blank")
    page.evaluate(
        """([text, sandbox]) => {
          const frame = document.createElement("iframe");
          if (sandbox) frame.sandbox = sandbox;
          frame.width = 1200;
          frame.height = 700;
          frame.srcdoc = text;
          document.body.append(frame);
        }""",
        [one_file(FRONTEND), sandbox],
    )
    frame = page.frame_locator("iframe")
    expect(frame.get_by_test_id("epsilon-t")).to_have_text("0.01435")
    frame.get_by_test_id("kappa-field").fill("18")
    frame.get_by_test_id("kappa-field").press("Enter")
    frame.get_by_test_id("language").select_option("fr")
    expect(frame.locator("html")).to_have_attribute("lang", "fr")
    expect(frame.get_by_test_id("kappa-field")).to_have_value("18")
    frame.get_by_test_id("share").click()
    silence.assert_kept()


def test_the_page_of_a_server_hands_it_out_where_frames_are_written(tab: Page):
    tab.get_by_test_id("embed").click()
    with tab.expect_download() as saving:
        tab.get_by_test_id("builder").get_by_text(words("en")["embedding"]["oneFile"]).click()
    assert saving.value.suggested_filename == "restitution.html"
    assert saving.value.path().read_text("utf-8") == one_file(FRONTEND)
