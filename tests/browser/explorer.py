"""What tests do with the page: read its numbers, wait until it rests, ask the API beside it."""

import json
import math
import time
import urllib.parse
import urllib.request
from collections.abc import Callable
from typing import TypeVar

from playwright.sync_api import Page, Request

T = TypeVar("T")

SETTLED_SECONDS = 10

PARAMETERS = {"kappa": "kappa", "mu-over-alpha": "mu_over_alpha", "gt-over-gn": "gt_over_gn"}

ACCURACY = ("method", "tolerance", "steps", "integrator", "rtol")

SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


def text(page: Page, name: str) -> str:
    return page.get_by_test_id(name).inner_text()


def number(shown: str) -> float:
    """The number that a typeset one stands for; none where nothing is known yet."""
    if shown == "–":
        return math.nan
    if "∞" in shown:
        return -math.inf if "−" in shown else math.inf
    mantissa, _, power = shown.replace("−", "-").replace("\u202f", "").partition("×")
    # read as one number: a product with a power of ten would round twice
    return float(f"{mantissa}e{power[2:].translate(SUPERSCRIPTS) or 0}")


def collision_of(page: Page) -> dict[str, float]:
    """The parameters that the address bar holds."""
    query = urllib.parse.parse_qs(urllib.parse.urlsplit(page.url).query)
    names = [*PARAMETERS.values(), *(["damping"] if "damping" in query else [])]
    return {name: float(query[name][0]) for name in names}


def ask(server: str, call: str, **parameters: object) -> dict:
    query = urllib.parse.urlencode(parameters)
    with urllib.request.urlopen(f"{server}/api/v1/{call}?{query}") as answer:
        return json.load(answer)


def accuracy_of(page: Page) -> dict[str, str]:
    """How ε_t is to be got, as the address bar and the API name it; nothing for the usual way."""
    query = urllib.parse.parse_qs(urllib.parse.urlsplit(page.url).query)
    return {name: query[name][0] for name in ACCURACY if name in query}


def agrees(page: Page, server: str) -> bool:
    """Whether the strip shows what the API answers to the address bar's collision."""
    answer = ask(server, "collision", **collision_of(page))
    epsilon_t = answer["epsilon_t"]
    # where the method does not answer, the page says so, and the exact value stands in
    if accuracy_of(page) and not text(page, "accuracy-refusal"):
        asked = {**collision_of(page), **accuracy_of(page), "quantities": "epsilon_t"}
        epsilon_t = ask(server, "collision", **asked)["epsilon_t"]
    return (
        number(text(page, "epsilon-t")) == float(f"{epsilon_t:.4g}")
        and text(page, "switches") == str(answer["switches"])
        and text(page, "reversals") == str(answer["reversals"])
        and text(page, "summary") == answer["summary"]
    )


def settle(page: Page, server: str) -> None:
    """Wait until the page shows the truth about its own parameters."""
    deadline = time.monotonic() + SETTLED_SECONDS
    while not agrees(page, server):
        assert time.monotonic() < deadline, f"{page.url} shows ε_t = {text(page, 'epsilon-t')}"
        page.wait_for_timeout(50)


def trace_of(page: Page, name: str) -> list[dict]:
    """The curves that Plotly has drawn, numbers as lists."""
    return page.get_by_test_id(name).evaluate(
        "plot => plot.data.map((t) => ({x: [...(t.x ?? [])], y: [...(t.y ?? [])]}))"
    )


def eventually(check: Callable[[], T], page: Page, seconds: float = SETTLED_SECONDS) -> T:
    """What a check returns once it holds: its last failure is the test's."""
    deadline = time.monotonic() + seconds
    while True:
        try:
            return check()
        except AssertionError:
            if time.monotonic() > deadline:
                raise
        page.wait_for_timeout(50)


class Witness:
    """What a page says in its console, and whom it calls, with the queries in the order sent."""

    def __init__(self, page: Page, server: str) -> None:
        self.words: list[str] = []
        self.strangers: list[str] = []
        self.calls: list[tuple[str, dict[str, str]]] = []
        self._server = server
        page.on("console", lambda message: self.words.append(message.text))
        page.on("pageerror", lambda error: self.words.append(str(error)))
        page.on("request", self._note)

    def _note(self, request: Request) -> None:
        if not request.url.startswith((self._server, "data:", "blob:")):
            self.strangers.append(request.url)
        address = urllib.parse.urlsplit(request.url)
        if address.path.startswith("/api/v1/"):
            query = dict(urllib.parse.parse_qsl(address.query))
            self.calls.append((address.path.removeprefix("/api/v1/"), query))

    def last(self, call: str) -> dict[str, str] | None:
        """The query of the last request to `/api/v1/<call>`."""
        return next((query for name, query in reversed(self.calls) if name == call), None)

    def assert_silence(self) -> None:
        assert self.words == []
        assert self.strangers == []
