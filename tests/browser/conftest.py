"""A real browser for the tests of this folder."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from playwright.sync_api import Browser, BrowserContext, expect
from rest import count_pending
from set_up_browser import ARGUMENTS, chromium_of_machine

from waiting import LIMIT_SECONDS

if TYPE_CHECKING:
    from collections.abc import Iterator

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
    browser: Browser, browser_context_args: dict[str, Any]
) -> Iterator[BrowserContext]:
    context = browser.new_context(**browser_context_args)
    count_pending(context)
    yield context
    context.close()


@pytest.fixture
def context(kept_context: BrowserContext) -> Iterator[BrowserContext]:
    """The context that all tests share: the page stores nothing, and its scripts stay compiled."""
    yield kept_context
    for page in kept_context.pages:
        page.close()
    kept_context.unroute_all()
    kept_context.set_offline(False)
