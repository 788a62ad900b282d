"""Everybody can use the page: rules that axe-core knows, and a keyboard alone."""

import itertools
from pathlib import Path

import pytest
from explorer import PARAMETERS, agrees, collision_of, settle, visit
from playwright.sync_api import Page, expect
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"

RULES = [
    "wcag2a",
    "wcag2aa",
    "wcag21a",
    "wcag21aa",
    "wcag22aa",
    "best-practice",
]

# Every state whose parts are not on the first view.
STATES = {
    "first": "/",
    "real spheres": "/?scene=spheres&material=alumina-on-glass",
    "speed and accuracy": "/?scene=accuracy&method=timestep",
    "the paper": "/?scene=paper",
    "compared, to be swept": "/?pins=4.5,1.4,4;18,0.8,0.9,0.3&sweep=kappa,1,100",
    "switches on logarithmic axes": "/?kappa=2000&map=switches&scale=log",
}

FOCUSED = """() => {
  const element = document.activeElement;
  // A radio button out of sight shows its focus on the label drawn in its place.
  const shown = [element, element.nextElementSibling, element.parentElement].filter(Boolean);
  const box = element.getBoundingClientRect();
  const labels = [...(element.labels ?? [])].map((label) => label.textContent.trim());
  return {
    name: element.dataset.testid ?? element.dataset.preset ?? element.id ?? "",
    tag: element.tagName.toLowerCase(),
    type: element.type ?? "",
    group: element.type === "radio" ? element.name : "",
    expanded: element.ariaExpanded ?? "",
    label: element.ariaLabel || labels.join() || element.textContent.trim(),
    seen: shown.some((each) => {
      const {outlineStyle, outlineWidth} = getComputedStyle(each);
      return outlineStyle !== "none" && parseFloat(outlineWidth) >= 2;
    }),
    onScreen: box.bottom > 0 && box.top < innerHeight,
    top: box.top + scrollY,
  };
}"""


# Of the paper's list, a part is looked at in test_paper_scene.py; dark colours are in
# test_presenting.py and test_lesson_texts.py.
EVERY_DAY = [(390, "light", "compared, to be swept")]


@pytest.mark.parametrize(
    ("width", "scheme", "state"),
    every_day(EVERY_DAY, of=itertools.product((390, 820, 1440), ("light", "dark"), STATES)),
)
def test_axe_finds_nothing_to_object_to(
    used_tab: Page, server: str, width: int, scheme: str, state: str
):
    used_tab.set_viewport_size({"width": width, "height": 900})
    used_tab.emulate_media(color_scheme=scheme)
    visit(used_tab, STATES[state])
    settle(used_tab, server)
    rest(used_tab)
    assert objections(used_tab) == []


@pytest.mark.parametrize("width", every_day([390], of=[390, 1440]))
def test_axe_finds_nothing_to_object_to_in_what_opens(tab: Page, server: str, width: int):
    """Menus and dialogs are not there, or not seen, until they are asked for."""
    tab.set_viewport_size({"width": width, "height": 900})
    opening = "summary:visible, button[aria-expanded]:visible, button[aria-haspopup]:visible"
    for i in range(tab.locator(opening).count()):
        visit(tab, "/")
        settle(tab, server)
        tab.locator(opening).nth(i).click()
        rest(tab)
        assert objections(tab) == []
        tab.keyboard.press("Escape")


@pytest.mark.verify
def test_axe_finds_nothing_to_object_to_at_no_such_address(page: Page, server: str):
    page.goto("/?kappa=spring")
    settle(page, server)
    expect(page.get_by_test_id("notice")).not_to_be_empty()
    assert objections(page) == []


def objections(page: Page) -> list[str]:
    # what Playwright evaluates is not held to the page's policy
    page.evaluate(AXE.read_text(encoding="utf-8"))
    options = {"runOnly": {"type": "tag", "values": RULES}, "resultTypes": ["violations"]}
    found = page.evaluate("(options) => axe.run(document, options)", options)
    assert len(found["passes"]) > 20
    return [
        f"{violation['id']}: {violation['help']}: {node['target']}: {node['failureSummary']}"
        for violation in found["violations"]
        for node in violation["nodes"]
    ]


def tour(page: Page) -> list[dict]:
    """What the Tab key comes to, one after the other, until it leaves the page or begins anew."""
    stops: list[dict] = []
    for _ in range(300):
        page.keyboard.press("Tab")
        stop = page.evaluate(FOCUSED)
        if stop["tag"] == "body" or stop in stops[:1]:
            break
        stops.append(stop | {"seen": stop["seen"] or looks_focused(page)})
    return stops


def looks_focused(page: Page) -> bool:
    """Whether the focus shows in the picture, as on the thumb of a slider."""
    element = page.evaluate_handle("() => document.activeElement").as_element()
    box = element.bounding_box()
    around = {"x": box["x"] - 4, "y": box["y"] - 4}
    clip = around | {"width": box["width"] + 8, "height": box["height"] + 8}
    focused = page.screenshot(clip=clip)
    element.evaluate("e => e.blur()")
    other = page.screenshot(clip=clip)
    # by script right after a key, so the browser shows it as for the keyboard
    element.evaluate("e => e.focus()")
    return focused != other


@pytest.mark.verify
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_tab_key_comes_to_every_control_in_order_and_shows_where_it_is(
    page: Page, server: str, scheme: str
):
    page.emulate_media(color_scheme=scheme)
    # in a tab that has been used the first key goes on from where that was
    page.goto("/")
    settle(page, server)
    stops = tour(page)
    assert "controls" in stops[0]["label"].lower(), "the first stop leads past the masthead"
    assert [stop for stop in stops if not stop["seen"]] == []
    assert [stop for stop in stops if not stop["onScreen"]] == []
    assert [stop for stop in stops if not stop["label"] and stop["tag"] != "body"] == []
    names = [stop["name"] for stop in stops]
    expected = [f"{name}-{part}" for name in PARAMETERS for part in ("field", "slider")]
    assert [name for name in names if name in expected] == expected
    presets = page.locator("[data-preset]").evaluate_all("all => all.map((b) => b.dataset.preset)")
    assert [name for name in names if name in presets] == presets
    assert {stop["group"] for stop in stops} >= {"map", "scale"}
    for element in page.locator("button:visible:enabled, summary:visible").all():
        label = element.evaluate(
            "e => e.ariaLabel || [...(e.labels ?? [])].map((l) => l.textContent.trim()).join()"
            " || e.textContent.trim()"
        )
        assert label in {stop["label"] for stop in stops}


@pytest.mark.verify
def test_every_control_works_by_keyboard_alone(page: Page, server: str):
    # away from where a reset has nothing to do
    page.goto("/?kappa=10&mu_over_alpha=1&gt_over_gn=1")
    settle(page, server)
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    seen: set[str] = set()
    kind = ""
    for _ in range(200):
        # a reset hands the focus on to the field
        if not kind.endswith("-reset"):
            page.keyboard.press("Tab")
        stop = page.evaluate(FOCUSED)
        kind = operate(page, stop)
        settle(page, server)
        assert agrees(page, server)
        if kind:
            seen.add(kind)
        if stop["tag"] == "body":
            break
    wanted = {f"{name}-{part}" for name in PARAMETERS for part in ("field", "slider", "reset")}
    assert wanted | {"preset", "map", "scale"} <= seen


def operate(page: Page, stop: dict) -> str:
    """Use what has the focus as its kind is used, and see the state follow."""
    before = collision_of(page), page.url
    name = stop["name"]
    parameter = next((p for p in PARAMETERS if name.startswith(p)), None)
    if parameter and name.endswith("slider"):
        page.keyboard.press("ArrowLeft")
        rest(page)
        assert collision_of(page)[PARAMETERS[parameter]] < before[0][PARAMETERS[parameter]]
    elif parameter and name.endswith("field"):
        page.keyboard.press("Control+A")
        page.keyboard.type("2.25")
        page.keyboard.press("Enter")
        rest(page)
        assert collision_of(page)[PARAMETERS[parameter]] == 2.25
    elif parameter and name.endswith("reset"):
        page.keyboard.press("Enter")
        rest(page)
        assert collision_of(page) != before[0]
    elif name in {"figure-1", "figure-2"}:
        # they lead into another scene, see test_paper_scene.py
        return ""
    elif stop["tag"] == "button" and is_preset(page):
        page.keyboard.press("Space")
        rest(page)
        assert page.evaluate("() => document.activeElement.ariaPressed") == "true"
        return "preset"
    elif stop["group"] in {"map", "scale"}:
        page.keyboard.press("ArrowRight")
        rest(page)
        assert page.url != before[1]
        return stop["group"]
    elif stop["expanded"]:
        page.keyboard.press("Enter")
        rest(page)
        assert page.evaluate("() => document.activeElement !== document.body")
        page.keyboard.press("Escape")
        rest(page)
        after = page.evaluate(FOCUSED)
        assert (after["label"], after["expanded"]) == (stop["label"], "false")
        return "opens"
    else:
        return ""
    return name


def is_preset(page: Page) -> bool:
    return page.evaluate("() => 'preset' in document.activeElement.dataset")
