"""What tests do with the page: read its numbers, wait until it rests, ask the API beside it."""

import functools
import json
import math
import urllib.error
import urllib.parse
import urllib.request

from playwright.sync_api import Page, Request
from rest import eventually

PARAMETERS = {"kappa": "kappa", "mu-over-alpha": "mu_over_alpha", "gt-over-gn": "gt_over_gn"}

# What a visitor leaves behind who was here before, sent the hint away and chose to see everything.
ACQUAINTED = """
  if (location.protocol.startsWith("http")) {
    localStorage.setItem("restitution.face", "expert");
    localStorage.setItem("restitution.hint", "away");
  }
"""

# Runs before the page's own scripts: what a strict policy of a proxy does.
REFUSE_KERNEL = """
  WebAssembly.compile = () => Promise.reject(new WebAssembly.CompileError("refused"));
"""

USUAL = {"kappa": "63", "mu_over_alpha": "1.4", "gt_over_gn": "1.358"}
"""Where the page begins."""

IMPACT_PARAMETERS = {
    "normal-velocity-m-s": "normal_velocity_m_s",
    "tangential-velocity-m-s": "tangential_velocity_m_s",
    "radius-m": "radius_m",
    "youngs-modulus-pa": "youngs_modulus_pa",
    "friction-coefficient": "friction_coefficient",
    "tangential-stiffness-n-per-m": "tangential_stiffness_n_per_m",
    "dissipative-constant-s": "dissipative_constant_s",
}

ACCURACY = ("method", "tolerance", "steps", "integrator", "rtol")

SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


def text(page: Page, name: str) -> str:
    return page.get_by_test_id(name).inner_text()


def texts(page: Page, *names: str) -> dict[str, str]:
    """Several texts as they stand at one moment."""
    return page.evaluate(
        """(names) => Object.fromEntries(names.map((name) =>
          [name, document.querySelector(`[data-testid="${name}"]`).innerText]))""",
        names,
    )


def number(shown: str) -> float:
    """The number that a typeset one stands for; none where nothing is known yet, or shown."""
    if shown in {"–", ""}:
        return math.nan
    if "∞" in shown:
        return -math.inf if "−" in shown else math.inf
    plain = shown.replace("−", "-").replace("\u202f", "").replace(",", ".")
    mantissa, _, power = plain.partition("×")
    # read as one number: a product with a power of ten would round twice
    return float(f"{mantissa}e{power[2:].translate(SUPERSCRIPTS) or 0}")


def collision_of(page: Page) -> dict[str, float]:
    """The parameters that the address bar holds."""
    query = urllib.parse.parse_qs(urllib.parse.urlsplit(page.url).query)
    names = [*PARAMETERS.values(), *(["damping"] if "damping" in query else [])]
    assert query.keys() >= set(names), f"{page.url} does not hold the state"
    return {name: float(query[name][0]) for name in names}


def ask(server: str, call: str, **parameters: object) -> dict:
    query = urllib.parse.urlencode(parameters)
    return json.loads(answer_to(f"{server}/api/v1/{call}?{query}"))


@functools.lru_cache(maxsize=50)
def answer_to(url: str) -> bytes:
    """What a server says to a question, which it says again while the page is waited for."""
    with urllib.request.urlopen(url) as answer:
        return answer.read()


def post(server: str, call: str, body: dict) -> dict:
    request = urllib.request.Request(
        f"{server}/api/v1/{call}", json.dumps(body).encode(), {"Content-Type": "application/json"}
    )
    with urllib.request.urlopen(request) as answer:
        return json.load(answer)


def materials(server: str) -> dict[str, dict]:
    with urllib.request.urlopen(f"{server}/api/v1/materials") as answer:
        return {item["id"]: item for item in json.load(answer)["items"]}


def body_of(material: dict, **impact: float) -> dict:
    names = ["body_1", "body_2", "friction_coefficient", "tangential_stiffness_n_per_m"]
    chosen = {name: material[name] for name in [*names, "dissipative_constant_s"]}
    return chosen | {"impact": material["impact"] | impact}


def accuracy_of(page: Page) -> dict[str, str]:
    """How ε_t is to be got, as the address bar and the API name it; nothing for the usual way."""
    query = urllib.parse.parse_qs(urllib.parse.urlsplit(page.url).query)
    accuracy = {name: query[name][0] for name in ACCURACY if name in query}
    # over the velocities of real spheres, what is shown is the law's
    if query.get("scene") == ["spheres"] and query.get("velocity_law") == ["coulomb"]:
        accuracy["method"] = "coulomb"
    return accuracy


def agrees(page: Page, server: str) -> bool:
    """Whether the strip shows what the API answers to the address bar's collision."""
    answer = ask(server, "collision", **collision_of(page))
    shown = texts(page, "epsilon-t", "switches", "reversals", "summary", "accuracy-refusal")
    epsilon_t = answer["epsilon_t"]
    # where the method does not answer, the page says so, and the exact value stands in
    if accuracy_of(page) and not shown["accuracy-refusal"]:
        asked = {**collision_of(page), **accuracy_of(page), "quantities": "epsilon_t"}
        try:
            epsilon_t = ask(server, "collision", **asked)["epsilon_t"]
        except urllib.error.HTTPError:
            # the page is going to say so
            return False
    if page.get_by_test_id("result").get_attribute("data-stale") is not None:
        return False
    # the API's sentence is English, the page makes its own
    spoken = page.locator("html").get_attribute("lang")
    return (
        number(shown["epsilon-t"]) == float(f"{epsilon_t:.4g}")
        and shown["switches"] == str(answer["switches"])
        and shown["reversals"] == str(answer["reversals"])
        and (spoken != "en" or shown["summary"] == summary_of(answer))
    )


def summary_of(answer: dict) -> str:
    """The sentence as the page sets it: a number and its sign of percent stay in one line."""
    return answer["summary"].replace(" %", "\u202f%")


def strip_of(page: Page) -> dict[str, object]:
    words = ("switches", "reversals", "energy-lost", "summary")
    numbers = ("epsilon-t", "contact-duration", "psi")
    shown = texts(page, *words, *numbers)
    return shown | {name: number(shown[name]) for name in numbers}


def strip_for(answer: dict) -> dict[str, object]:
    psi = answer["parameters"]["psi"]
    return {
        "epsilon-t": four_digits(answer["epsilon_t"]),
        "switches": str(answer["switches"]),
        "reversals": str(answer["reversals"]),
        "energy-lost": percentage(0.0 if answer["limit"] else answer["energy"]["dissipated_share"]),
        "contact-duration": four_digits(answer["contact_duration"]),
        "psi": float("inf") if psi is None else four_digits(psi),
        "summary": summary_of(answer),
    }


def four_digits(value: float) -> float:
    return float(f"{value:.4g}")


def percentage(share: float) -> str:
    percent = 100 * share
    if share in {0.0, 1.0}:
        digits = f"{percent:.0f}"
    elif percent < 0.05:
        digits = "< 0.1"
    elif percent >= 99.95:
        digits = "> 99.9"
    else:
        digits = f"{percent:.1f}"
    return f"{digits}\u202f%"


def visit(page: Page, address: str) -> None:
    """Go to an address as the page's own links do, which hold the collision: nothing is loaded.

    Real spheres are: their collision is worked out, and only their own links know it. Another
    language is, too.
    """
    path, _, query = address.partition("?")
    whole = USUAL | dict(urllib.parse.parse_qsl(query))
    present = urllib.parse.parse_qs(urllib.parse.urlsplit(page.url).query)
    speaks_anew = present.get("lang", [None])[0] != whole.get("lang")
    if "scene=spheres" in address or speaks_anew:
        page.goto(address)
        return
    page.evaluate(
        """(address) => {
          history.pushState(null, "", address);
          dispatchEvent(new PopStateEvent("popstate"));
        }""",
        f"{path}?{urllib.parse.urlencode(whole)}",
    )


# Nobody moves any more, and the seconds until the controls of a presentation fade are over.
FADE = """() => {
  const later = window.setTimeout;
  window.setTimeout = (task) => later(task);
  dispatchEvent(new PointerEvent("pointermove"));
  window.setTimeout = later;
}"""


def settle(page: Page, server: str) -> None:
    """Wait until the page shows the truth about its own parameters."""

    def shows_truth() -> None:
        assert agrees(page, server), f"{page.url} shows ε_t = {text(page, 'epsilon-t')}"

    eventually(shows_truth, page)


def trace_of(page: Page, name: str) -> list[dict]:
    """The curves that Plotly has drawn, numbers as lists."""
    return page.get_by_test_id(name).evaluate(
        "plot => (plot.data ?? []).map((t) => ({x: [...(t.x ?? [])], y: [...(t.y ?? [])]}))"
    )


# Counts what Plotly itself draws, by the name of the picture.
COUNT_DRAWINGS = """() => {
  const direct = window.reactOfPlotly ??= Plotly.react;
  window.drawings = {};
  Plotly.react = (element, ...rest) => {
    const name = element.dataset.testid;
    drawings[name] = (drawings[name] ?? 0) + 1;
    return direct(element, ...rest);
  };
}"""


class Witness:
    """What a page says in its console, and whom it calls, with the queries in the order sent."""

    def __init__(self, page: Page, server: str) -> None:
        self.words: list[str] = []
        self.strangers: list[str] = []
        self.calls: list[tuple[str, dict[str, str]]] = []
        self.posted: list[tuple[str, dict]] = []
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
            call = address.path.removeprefix("/api/v1/")
            self.calls.append((call, query))
            if request.method == "POST":
                self.posted.append((call, request.post_data_json))

    def last(self, call: str) -> dict[str, str] | None:
        """The query of the last request to `/api/v1/<call>`."""
        return next((query for name, query in reversed(self.calls) if name == call), None)

    def assert_silence(self) -> None:
        assert self.words == []
        assert self.strangers == []
