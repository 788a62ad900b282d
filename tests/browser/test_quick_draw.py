"""What a drag moves by hand lies where Plotly draws it afterwards."""

from collections.abc import Iterator
from itertools import chain

import numpy as np
import pytest
from explorer import COUNT_DRAWINGS, settle, visit
from playwright.sync_api import Page
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

MARKS = """(plot) => {
  const numbers = (text) => (text ?? "").match(/-?[\\d.]+(?:e-?\\d+)?/g)?.map(Number) ?? [];
  const all = (selector) => [...plot.querySelectorAll(selector)];
  const fill = (element) => {
    const {fill, fillOpacity} = getComputedStyle(element);
    const [red, green, blue, alpha = 1] = numbers(fill);
    return [red, green, blue, alpha * Number(fillOpacity)];
  };
  // a space stands for none
  const words = all(".barlayer g.point > text").filter((text) => text.textContent.trim());
  return {
    lines: all(".js-line").map((line) => numbers(line.getAttribute("d"))),
    points: all("path.point").map((point) => numbers(point.getAttribute("transform"))),
    numbers: all("g.textpoint text").map((text) =>
      [text.textContent, Number(text.getAttribute("x")), Number(text.getAttribute("y"))]),
    bars: all(".barlayer g.point > path").map((bar) => numbers(bar.getAttribute("d"))),
    fills: all(".barlayer g.point > path").map(fill),
    words: words.map((text) => text.textContent),
    ticks: ["x", "y"].flatMap((name) =>
      all(`.${name}axislayer-above > path, .${name}axislayer-above text`).map((tick) =>
        numbers(tick.getAttribute("transform")))),
    tickWords: all(".xaxislayer-above text, .yaxislayer-above text").map(
      (tick) => tick.textContent),
    zero: all("path.yzl").map((line) => numbers(line.getAttribute("transform"))),
    wordPlaces: words.map((text) =>
      numbers(text.getAttribute("transform"))[0]),
  };
}"""

# Both round to a hundredth of a pixel, by ways of their own.
PIXELS = 0.025


def marks(page: Page, name: str) -> dict[str, list]:
    return page.get_by_test_id(name).evaluate(MARKS)


@pytest.mark.parametrize("name", every_day(["force-trace"], of=["force-trace", "velocity"]))
@pytest.mark.parametrize(
    ("slider", "shares"),
    [
        ("kappa", (0.3, 0.55, 0.7)),
        ("damping", (0.2, 0.3)),
        pytest.param("gt-over-gn", (0.2, 0.3, 0.35, 0.45, 0.6), marks=pytest.mark.verify),
        pytest.param("mu-over-alpha", (0.2, 0.8), marks=pytest.mark.verify),
    ],
)
def test_marks_moved_while_dragging_are_those_that_plotly_draws(
    used_tab: Page, server: str, name: str, slider: str, shares: tuple[float, ...]
):
    visit(used_tab, "/")
    settle(used_tab, server)
    used_tab.evaluate(COUNT_DRAWINGS)
    box = used_tab.get_by_test_id(f"{slider}-slider").bounding_box()
    y = box["y"] + box["height"] / 2
    moved_by_hand = 0
    for share in shares:
        used_tab.evaluate("window.drawings = {}")
        used_tab.mouse.move(box["x"] + (share - 0.05) * box["width"], y)
        used_tab.mouse.down()
        rest(used_tab)
        used_tab.evaluate("window.drawings = {}")
        used_tab.mouse.move(box["x"] + share * box["width"], y, steps=3)
        rest(used_tab)
        dragged = marks(used_tab, name)
        is_by_hand = not used_tab.evaluate("(name) => window.drawings[name]", name)
        moved_by_hand += is_by_hand
        used_tab.mouse.up()
        rest(used_tab)
        assert used_tab.evaluate("(name) => window.drawings[name]", name)
        drawn = marks(used_tab, name)
        for kind, values in drawn.items():
            assert len(dragged[kind]) == len(values), kind
            for moved, wanted in zip(dragged[kind], values, strict=True):
                assert moved == pytest.approx(wanted, abs=PIXELS), kind
    # An axis that changes is Plotly's to draw, but that is the exception.
    assert moved_by_hand > 0


BOTH = """async (plot) => {
  const read = READ;
  const other = document.body.appendChild(document.createElement("div"));
  await Plotly.newPlot(other, structuredClone(plot.data), plot.layout, {staticPlot: true});
  const both = [await read(plot), await read(other)];
  Plotly.purge(other);
  other.remove();
  return both;
}"""

IMAGE = """async (plot) => {
  const image = plot.querySelector(".heatmaplayer image");
  const {x, y, width, height, style} = image;
  const decoded = new Image();
  decoded.src = image.href.baseVal;
  await decoded.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [decoded.naturalWidth, decoded.naturalHeight];
  const context = canvas.getContext("2d");
  context.drawImage(decoded, 0, 0);
  return {
    place: [x, y, width, height].map(({baseVal}) => baseVal.value),
    rendering: style.imageRendering,
    size: [canvas.width, canvas.height],
    pixels: [...context.getImageData(0, 0, canvas.width, canvas.height).data],
  };
}"""


def both(page: Page, name: str, read: str) -> list[dict[str, list]]:
    """Read what is on the page, and the same drawn by Plotly in a place of its own."""
    return page.get_by_test_id(name).evaluate(BOTH.replace("READ", read))


def drag_by_hand(page: Page, server: str, address: str, name: str) -> Iterator[float]:
    """Yield where a drag of μ/α is, at which the plot was not drawn by Plotly."""
    visit(page, address)
    settle(page, server)
    rest(page)
    page.evaluate(COUNT_DRAWINGS)
    box = page.get_by_test_id("mu-over-alpha-slider").bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + 0.4 * box["width"], y)
    page.mouse.down()
    for share in (0.5, 0.55, 0.65, 0.6):
        page.evaluate("window.drawings = {}")
        page.mouse.move(box["x"] + share * box["width"], y, steps=3)
        rest(page)
        assert not page.evaluate("(name) => window.drawings[name]", name), share
        yield share
    page.mouse.up()
    rest(page)
    assert page.evaluate("(name) => window.drawings[name]", name)


# the smooth one after the one in squares, in the same place
@pytest.mark.parametrize("quantity", ["switches", "epsilon_t"])
@pytest.mark.parametrize("scale", every_day(["linear"], of=["linear", "log"]))
def test_a_map_painted_while_dragging_is_that_which_plotly_paints(
    used_tab: Page, server: str, quantity: str, scale: str
):
    painted = set()
    for _ in drag_by_hand(used_tab, server, f"/?map={quantity}&scale={scale}", "map"):
        by_hand, by_plotly = both(used_tab, "map", IMAGE)
        assert by_hand["place"] == pytest.approx(by_plotly["place"], abs=PIXELS)
        assert by_hand["rendering"] == by_plotly["rendering"]
        assert by_hand["size"] == by_plotly["size"] == [80, 60]
        # halves are rounded up, or to the even one
        assert np.abs(np.subtract(by_hand["pixels"], by_plotly["pixels"])).max() <= 1
        painted.add(bytes(by_hand["pixels"]))
    assert len(painted) == 4


@pytest.mark.parametrize("options", ["cut_y=log", "scale=log", "cut_x=kappa"])
def test_a_cut_moved_while_dragging_is_that_which_plotly_draws(
    used_tab: Page, server: str, options: str
):
    seen = set()
    for _ in drag_by_hand(used_tab, server, f"/?{options}", "cut"):
        by_hand, by_plotly = both(used_tab, "cut", MARKS)
        for kind in ("bars", "points", "numbers", "ticks"):
            for moved, wanted in zip(by_hand[kind], by_plotly[kind], strict=True):
                assert moved == pytest.approx(wanted, abs=PIXELS), kind
        # Plotly has a path for each piece of a line
        moved, wanted = ([*chain(*marks["lines"])] for marks in (by_hand, by_plotly))
        assert moved == pytest.approx(wanted, abs=PIXELS)
        seen.add(str(moved))
    assert len(seen) == 4
