"""Where the kernel of the page runs: in Node every day, in real browsers for `make verify`."""

from collections.abc import Iterator

import pytest
from kernel_runtimes import BROWSERS, Answers, answers_in_node, page_of

VERIFIED = (pytest.mark.browser, pytest.mark.verify)
HAS_FIREFOX = pytest.mark.skipif(
    not BROWSERS["firefox"][1], reason="there is no Firefox: `make verify` installs one"
)

RUNTIMES = [
    "node",
    pytest.param("chromium", marks=VERIFIED),
    pytest.param("firefox", marks=[*VERIFIED, HAS_FIREFOX]),
]


@pytest.fixture(scope="session", params=RUNTIMES)
def answers(request: pytest.FixtureRequest) -> Iterator[Answers]:
    """What calls of the kernel give."""
    if request.param == "node":
        yield answers_in_node
        return
    with page_of(request.param, request.getfixturevalue("server")) as in_page:
        yield in_page
