"""A real browser for the tests of this folder."""

from __future__ import annotations

from typing import Any

import pytest
from set_up_browser import ARGUMENTS, chromium_of_machine


@pytest.fixture(scope="session")
def browser_type_launch_args(browser_type_launch_args: dict[str, Any]) -> dict[str, Any]:
    chosen = {**browser_type_launch_args, "args": ARGUMENTS}
    path = chromium_of_machine()
    # Without a path Playwright takes the one it has downloaded itself.
    return {**chosen, "executable_path": path} if path else chosen


@pytest.fixture(scope="session")
def base_url(server: str) -> str:
    """What `page.goto` adds its path to; the plugin's own fixture is one that pytest 9 warns of."""
    return server
