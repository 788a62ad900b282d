"""Whatever is done to the page, in whatever order, leaves a page that works."""

import urllib.parse

import numpy as np
import pytest
from explorer import IMPACT_PARAMETERS, PARAMETERS, collision_of, settle, text, visit
from playwright.sync_api import BrowserContext, Error, Page, Route, expect

pytestmark = pytest.mark.browser

SEED = 2008

INJECTED = "window.broken = 1; alert(1)"
NONSENSE = [
    "",
    " ",
    "-1",
    "0",
    "NaN",
    "Infinity",
    "1e999",
    "1e308",
    "5e-324",
    "0x10",
    "1,5",
    "٣",
    "spring",
    "𝟛𝟜",
    "\u202e63",
    "7" * 5000,
    "../../etc/passwd",
    "'; DROP TABLE spheres; --",
    "%00",
    "{{7*7}}",
    f"<script>{INJECTED}</script>",
    f"<img src=x onerror='{INJECTED}'>",
    f'"><svg onload="{INJECTED}">',
    f"javascript:{INJECTED}",
    "__proto__",
]
KEYS = [
    *("ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End"),
    *("Tab", "Shift+Tab", "Enter", "Space", "Escape", "Backspace", "Delete"),
    *("a", "e", "1", "-", ".", "?", "Control+A", "Control+Z", "Alt+1", "Shift+ArrowUp"),
]
SIZES = [(320, 568), (390, 844), (568, 320), (820, 1180), (1440, 900), (1920, 1080), (3840, 2160)]
OPTIONS = ["map", "scale", "embed", "scene", "theme", "tolerance", "method", "__proto__", "x"]
OPTIONS += ["steps", "rtol", "integrator", "region", "statistic", "wanted_error"]
OPTIONS += ["alpha", "material", "inertia", "velocity_law", *IMPACT_PARAMETERS.values()]
OPTIONS += ["second", "normal_restitution", "density_kg_m3", "poisson_ratio", "radius_2_m"]

# What a browser says of a request that was cut off, or of WebGL without a graphics card, is no
# fault of the page.
BROWSERS_WORDS = ("Failed to load resource", "net::ERR_", "GL Driver Message")


class Monkey:
    """Does something at random to the page, and remembers what."""

    def __init__(self, page: Page, server: str, seed: int) -> None:
        self.page = page
        self.server = server
        self.rng = np.random.default_rng(seed)
        self.done: list[str] = []
        self.offline = False
        self.width, self.height = 1440, 900
        often = [self.move, self.click, self.drag, self.press, self.press, self.wheel, self.type]
        seldom = [self.edit_address, self.resize, self.toggle_network, self.travel, self.emulate]
        self.deeds = 4 * often + seldom

    def act(self) -> None:
        deed = self.deeds[self.rng.integers(len(self.deeds))]
        self.done.append(f"{deed.__name__}: {deed()}")
        self.come_home()

    def place(self) -> tuple[float, float]:
        return float(self.rng.uniform(0, self.width)), float(self.rng.uniform(0, self.height))

    def move(self) -> str:
        place = self.place()
        self.page.mouse.move(*place)
        return f"{place}"

    def click(self) -> str:
        place = self.place()
        button = str(self.rng.choice(["left", "left", "left", "middle", "right"]))
        self.page.mouse.click(*place, button=button, click_count=int(self.rng.integers(1, 4)))
        return f"{button} {place}"

    def drag(self) -> str:
        begin, end = self.place(), self.place()
        self.page.mouse.move(*begin)
        self.page.mouse.down()
        self.page.mouse.move(*end, steps=5)
        # now and then another thing happens before the button is let go
        if self.rng.random() < 0.2:
            self.press()
        self.page.mouse.up()
        return f"{begin} to {end}"

    def press(self) -> str:
        key = str(self.rng.choice(KEYS))
        for _ in range(self.rng.integers(1, 4)):
            self.page.keyboard.press(key)
        return key

    def wheel(self) -> str:
        x, y = self.rng.normal(0, 300, 2)
        self.page.mouse.wheel(float(x), float(y))
        return f"{x:.0f} {y:.0f}"

    def type(self) -> str:
        nonsense = NONSENSE[self.rng.integers(len(NONSENSE))]
        fields = self.page.locator("input[type=text]:visible, input[type=number]:visible").all()
        if fields:
            field = fields[self.rng.integers(len(fields))]
            field.evaluate("field => { field.focus(); field.select(); }")
        # one time in some thousand Chromium never answers its own command for this
        self.page.evaluate("text => document.execCommand('insertText', false, text)", nonsense)
        if self.rng.random() < 0.5:
            self.page.keyboard.press("Enter")
        return f"{nonsense[:40]!r}"

    def edit_address(self) -> str:
        self.connect()
        names = [*PARAMETERS.values(), *OPTIONS]
        chosen = self.rng.choice(names, int(self.rng.integers(1, 5)))
        query = urllib.parse.urlencode(
            [(name, NONSENSE[self.rng.integers(len(NONSENSE))][:500]) for name in chosen]
        )
        hash_ = f"#{self.rng.choice(NONSENSE)[:80]}" if self.rng.random() < 0.3 else ""
        try:
            self.page.goto(f"{self.server}/?{query}{hash_}", wait_until="commit")
        except Error as error:
            # a step back in the history may still be on its way
            if "interrupted by another navigation" not in str(error):
                raise
        return query[:200]

    def resize(self) -> str:
        self.width, self.height = SIZES[self.rng.integers(len(SIZES))]
        self.page.set_viewport_size({"width": self.width, "height": self.height})
        return f"{self.width}"

    def toggle_network(self) -> str:
        self.offline = not self.offline
        self.page.context.set_offline(self.offline)
        return "off" if self.offline else "on"

    def connect(self) -> None:
        """An address opened without a network is a page of the browser's, not ours."""
        self.offline = False
        self.page.context.set_offline(False)

    def travel(self) -> str:
        self.connect()
        back = bool(self.rng.random() < 0.6)
        # Playwright's own go_back fails now and then while an earlier address is still loading.
        self.page.evaluate(
            f"() => void setTimeout(() => history.{'back' if back else 'forward'}())"
        )
        self.page.wait_for_timeout(200)
        self.page.wait_for_load_state()
        return "back" if back else "forward"

    def emulate(self) -> str:
        scheme = str(self.rng.choice(["light", "dark", "no-preference"]))
        motion = str(self.rng.choice(["reduce", "no-preference"]))
        media = str(self.rng.choice(["screen", "screen", "print"]))
        self.page.emulate_media(color_scheme=scheme, reduced_motion=motion, media=media)
        return f"{scheme} {motion} {media}"

    def come_home(self) -> None:
        """Return from where a link or the history has led."""
        if (
            urllib.parse.urlsplit(self.page.url)[1:3]
            != urllib.parse.urlsplit(f"{self.server}/")[1:3]
        ):
            self.connect()
            self.page.goto(f"{self.server}/")


def keep_in(context: BrowserContext, server: str) -> list[str]:
    """Answer what leads elsewhere with nothing, and close what opens beside the page."""
    calls: list[str] = []

    def refuse(route: Route) -> None:
        if not route.request.is_navigation_request():
            calls.append(route.request.url)
        route.fulfill(status=204)

    context.route(lambda url: not url.startswith((server, "data:", "blob:")), refuse)
    return calls


@pytest.mark.own_page
@pytest.mark.parametrize(
    ("scene", "count", "seed"),
    [
        ("explorer", 6, SEED),
        pytest.param("explorer", 40, SEED, marks=pytest.mark.verify),
        pytest.param("spheres", 40, SEED, marks=pytest.mark.verify),
        pytest.param("explorer", 2000, SEED + 1, marks=pytest.mark.verify),
        pytest.param("spheres", 2000, SEED + 2, marks=pytest.mark.verify),
    ],
)
def test_a_monkey_leaves_a_page_that_works(
    page: Page, server: str, scene: str, count: int, seed: int
):
    words, dialogs = [], []
    page.on("pageerror", lambda error: words.append(f"{error} {error.stack}"))
    page.on(
        "console",
        lambda m: None if any(w in m.text for w in BROWSERS_WORDS) else words.append(m.text),
    )
    page.on("dialog", lambda dialog: (dialogs.append(dialog.message), dialog.dismiss()))
    page.on("popup", lambda popup: popup.close())
    # Chromium's preview of a print takes all input until a person closes it
    page.add_init_script("window.broken = 0; window.print = () => {}")
    calls = keep_in(page.context, server)
    page.goto(f"/?scene={scene}")
    settle(page, server)
    monkey = Monkey(page, server, seed)
    try:
        for _ in range(count):
            monkey.act()
            assert dialogs == []
            assert words == []
        assert_works(page, server, monkey)
    finally:
        print("\n".join(monkey.done[-25:]))
    assert page.evaluate("() => window.broken") == 0
    assert (calls, dialogs, words) == ([], [], [])


def assert_works(page: Page, server: str, monkey: Monkey) -> None:
    """Without loading it again, the page goes where it is sent and shows the truth there."""
    monkey.connect()
    page.emulate_media(color_scheme="light", reduced_motion="no-preference", media="screen")
    page.set_viewport_size({"width": 1440, "height": 900})
    expect(page.get_by_test_id("banner")).to_be_empty()
    visit(page, "/")
    settle(page, server)
    assert text(page, "switches") == "8"
    page.keyboard.press("Escape")
    for name, value in {"kappa": "18", "mu-over-alpha": "1", "gt-over-gn": "0.5"}.items():
        field = page.get_by_test_id(f"{name}-field")
        field.fill(value)
        field.press("Enter")
        settle(page, server)
    assert collision_of(page) == {"kappa": 18, "mu_over_alpha": 1, "gt_over_gn": 0.5}
    page.get_by_test_id("kappa-slider").press("ArrowRight")
    settle(page, server)
    assert collision_of(page)["kappa"] > 18
