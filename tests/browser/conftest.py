"""A real browser for the tests of this folder."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from explorer import settle, visit
from playwright.sync_api import Browser, BrowserContext, Page, expect
from rest import count_pending
from set_up_browser import ARGUMENTS, chromium_of_machine

from waiting import LIMIT_SECONDS

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator

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
def open_context(
    browser: Browser, browser_context_args: dict[str, Any]
) -> Iterator[Callable[[], BrowserContext]]:
    contexts = []

    def open_one() -> BrowserContext:
        contexts.append(browser.new_context(**browser_context_args))
        count_pending(contexts[-1])
        return contexts[-1]

    yield open_one
    for context in contexts:
        context.close()


@pytest.fixture(scope="session")
def kept_context(open_context: Callable[[], BrowserContext]) -> BrowserContext:
    return open_context()


@pytest.fixture
def context(kept_context: BrowserContext) -> Iterator[BrowserContext]:
    """The context that all tests share: the page stores nothing, and its scripts stay compiled."""
    yield kept_context
    for page in kept_context.pages:
        page.close()
    kept_context.unroute_all()
    kept_context.set_offline(False)


FAILED = pytest.StashKey[bool]()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, Any]:
    report = yield
    item.stash[FAILED] = item.stash.get(FAILED, False) or report.failed
    return report


@pytest.fixture(scope="session")
def kept_tab(open_context: Callable[[], BrowserContext]) -> Page:
    page = open_context().new_page()
    page.goto("/")
    return page


@pytest.fixture
def tab(kept_tab: Page, server: str, request: pytest.FixtureRequest) -> Iterator[Page]:
    """The page at its usual state in a tab that stays open, for tests that load nothing anew."""
    visit(kept_tab, "/")
    settle(kept_tab, server)
    yield kept_tab
    kept_tab.unroute_all()
    kept_tab.keyboard.press("Escape")
    kept_tab.emulate_media(media="screen", color_scheme="light", reduced_motion="reduce")
    kept_tab.set_viewport_size({"width": 1280, "height": 720})
    kept_tab.evaluate("() => { document.activeElement.blur(); scrollTo(0, 0); }")
    if request.node.stash.get(FAILED, False):
        kept_tab.goto("/")
