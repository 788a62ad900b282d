"""A real browser for the tests of this folder."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from explorer import ACQUAINTED, settle, visit
from playwright.sync_api import Browser, BrowserContext, BrowserType, Page, expect
from rest import count_pending, rest
from set_up_browser import ARGUMENTS, chromium_of_machine

from waiting import LIMIT_SECONDS

if TYPE_CHECKING:
    from collections.abc import Generator, Iterator

expect.set_options(timeout=1000 * LIMIT_SECONDS)


@pytest.fixture(scope="session")
def browser_type_launch_args(browser_type_launch_args: dict[str, Any]) -> dict[str, Any]:
    return {**browser_type_launch_args, "args": ARGUMENTS, "executable_path": chromium_of_machine()}


@pytest.fixture(scope="session")
def browser_context_args(browser_context_args: dict[str, Any]) -> dict[str, Any]:
    # What plays by itself would be waited for in each test; one of them looks at it.
    return {**browser_context_args, "reduced_motion": "reduce"}


@pytest.fixture(scope="session")
def base_url(server: str) -> str:
    """What `page.goto` adds its path to; the plugin's own fixture is one that pytest 9 warns of."""
    return server


@pytest.fixture(scope="session")
def kept_context(
    browser_type: BrowserType,
    browser_type_launch_args: dict[str, Any],
    browser_context_args: dict[str, Any],
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[BrowserContext]:
    """The context that all tests share: the page stores nothing, and its scripts stay compiled.

    They do so for a browser with a folder of its own alone: a load takes half the work.
    """
    folder = tmp_path_factory.mktemp("profile")
    options = browser_type_launch_args | browser_context_args
    with browser_type.launch_persistent_context(folder, **options) as context:
        count_pending(context)
        context.add_init_script(ACQUAINTED)
        yield context


@pytest.fixture
def context(kept_context: BrowserContext) -> Iterator[BrowserContext]:
    before = kept_context.pages
    yield kept_context
    for page in kept_context.pages:
        if page not in before:
            page.close()
    kept_context.unroute_all()
    kept_context.set_offline(False)


@pytest.fixture(scope="session")
def kept_page(kept_context: BrowserContext) -> Page:
    return kept_context.new_page()


@pytest.fixture
def page(
    context: BrowserContext,
    kept_page: Page,
    request: pytest.FixtureRequest,
    monkeypatch: pytest.MonkeyPatch,
) -> Iterator[Page]:
    """A page of which nothing is loaded, in a tab that other tests had before.

    What Chromium has compiled there serves again: the first load takes half of what it takes in a
    new tab. Tests whose scripts, listeners or slow network would stay are marked `own_page`.
    """
    if request.node.get_closest_marker("own_page"):
        yield context.new_page()
        return
    monkeypatch.setattr(kept_page, "add_init_script", refuse_script)
    yield kept_page
    # an answer that is late would let the lesson remember it all again
    kept_page.evaluate("() => { Storage.prototype.setItem = () => {}; }")
    leave_as_found(kept_page)
    kept_page.goto("about:blank")


@pytest.fixture
def stranger(browser: Browser) -> Iterator[Page]:
    """A page of somebody who has not seen the service before, nor its proxy's certificate."""
    with browser.new_context(ignore_https_errors=True, reduced_motion="reduce") as context:
        count_pending(context)
        yield context.new_page()


def refuse_script(*_: str) -> None:
    raise AssertionError("mark this test own_page: its script would stay")


def leave_as_found(page: Page) -> None:
    page.unroute_all()
    page.keyboard.press("Escape")
    # what was laid out for paper
    page.evaluate("() => dispatchEvent(new Event('afterprint'))")
    # and what the lesson was answered
    page.evaluate("() => sessionStorage.clear()")
    page.emulate_media(media="screen", color_scheme="light", reduced_motion="reduce")
    page.set_viewport_size({"width": 1280, "height": 720})


FAILED = pytest.StashKey[bool]()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, Any]:
    report = yield
    item.stash[FAILED] = item.stash.get(FAILED, False) or report.failed
    return report


@pytest.fixture(scope="session")
def kept_tab(kept_context: BrowserContext) -> Page:
    page = kept_context.new_page()
    page.goto("/")
    return page


@pytest.fixture
def tab(used_tab: Page, server: str) -> Page:
    """The page at its usual state in a tab that stays open, for tests that load nothing anew."""
    visit(used_tab, "/")
    settle(used_tab, server)
    return used_tab


@pytest.fixture
def used_tab(kept_tab: Page, request: pytest.FixtureRequest) -> Iterator[Page]:
    """The same tab where the last test left it, for a test that goes to an address of its own."""
    # what the last test began is none of the next one's
    rest(kept_tab)
    yield kept_tab
    leave_as_found(kept_tab)
    kept_tab.evaluate(
        "() => { document.activeElement.blur(); scrollTo(0, 0); sessionStorage.clear(); }"
    )
    if request.node.stash.get(FAILED, False):
        kept_tab.goto("/")
