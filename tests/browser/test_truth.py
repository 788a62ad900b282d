"""Whatever collision is asked for, by whatever control, the page shows the API's plain answer."""

import re

import numpy as np
import pytest
from explorer import (
    PARAMETERS,
    SUPERSCRIPTS,
    Witness,
    ask,
    collision_of,
    settle,
    strip_for,
    strip_of,
    trace_of,
    visit,
)
from playwright.sync_api import Page
from rest import eventually

pytestmark = pytest.mark.browser

SEED = 20080927

OPTIONS = {
    "map": ["epsilon_t", "switches"],
    "scale": ["linear", "log"],
    "map_x": ["kappa", "alpha_kappa"],
    "map_y": ["gt_over_gn", "psi"],
}

# The pixels of the first line of a trace's SVG group, and where the plot's axes put its numbers.
DRAWN_LINES = """plot => {
  // where the axes are shown to end: a drag moves their ticks by hand
  const {xaxis: {range: [left, right]}, yaxis: {range: [bottom, top]}} = plot.layout;
  const {xaxis: {_length: width}, yaxis: {_length: height}} = plot._fullLayout;
  const groups = plot.querySelectorAll(".scatterlayer > .trace");
  const traces = plot.data.filter((trace) => trace.type !== "bar" && trace.type !== "heatmap");
  return traces.flatMap((trace, i) => trace.mode !== "lines" ? [] : [{
    path: groups[i]?.querySelector(".js-line")?.getAttribute("d") ?? "",
    x: [...trace.x].map((x) => (width * (x - left)) / (right - left)),
    y: [...trace.y].map((y) => (height * (top - y)) / (top - bottom)),
  }]);
}"""

# The cell of the map under the middle of the crosshair's ring.
CELL = """([map, ring]) => {
  const {xaxis, yaxis} = map._fullLayout;
  const box = map.getBoundingClientRect();
  const middle = ring.getBoundingClientRect();
  const cells = map.data.find((trace) => trace.z);
  const x = xaxis.p2l(middle.x + middle.width / 2 - box.x - xaxis._offset);
  const y = yaxis.p2l(middle.y + middle.height / 2 - box.y - yaxis._offset);
  const nearest = (index, count) => Math.min(count - 1, Math.max(0, Math.round(index)));
  const column = nearest((x - cells.x0) / cells.dx, cells.z[0].length);
  const row = nearest((y - cells.y0) / cells.dy, cells.z.length);
  return {x, y, column, row, z: cells.z[row][column]};
}"""


@pytest.mark.parametrize("count", [2, pytest.param(100, marks=pytest.mark.verify)])
def test_every_view_shows_the_answer_to_a_state_in_the_address(page: Page, server: str, count: int):
    rng = np.random.default_rng(SEED)
    witness = Witness(page, server)
    for turn in range(count):
        wanted = random_collision(rng)
        options = {name: str(rng.choice(choices)) for name, choices in OPTIONS.items()}
        query = [f"{k}={v!r}" for k, v in wanted.items()] + [f"{k}={v}" for k, v in options.items()]
        address = "/?" + "&".join(query)
        # loaded now and then, else gone to as by the page's links
        if turn % 4 == 0:
            page.goto(address)
        else:
            visit(page, address)
        eventually(lambda: assert_truth(page, server, witness), page)
        assert collision_of(page) == wanted
    witness.assert_silence()


@pytest.mark.parametrize("count", [2, pytest.param(100, marks=pytest.mark.verify)])
def test_every_view_shows_the_answer_to_a_state_set_by_a_control(
    page: Page, server: str, count: int
):
    rng = np.random.default_rng(SEED + 1)
    witness = Witness(page, server)
    page.goto("/")
    settle(page, server)
    controls = [by_slider, by_field, by_keys, by_preset, on_map, by_option]
    for turn in range(count):
        controls[turn % len(controls)](page, rng)
        eventually(lambda: assert_truth(page, server, witness), page)
    witness.assert_silence()


def random_collision(rng: np.random.Generator) -> dict[str, float]:
    kappa = float(f"{10 ** rng.uniform(-1, 3.3):.6g}")
    mu_over_alpha = float(f"{rng.uniform(0.02, 4):.4g}")
    gt_over_gn = float(f"{4 * rng.uniform(0.05, 1.05) ** 2:.17g}")
    return {"kappa": kappa, "mu_over_alpha": mu_over_alpha, "gt_over_gn": gt_over_gn}


def by_slider(page: Page, rng: np.random.Generator) -> None:
    name = rng.choice(list(PARAMETERS))
    page.get_by_test_id(f"{name}-slider").fill(str(rng.integers(1, 1001)))


def by_field(page: Page, rng: np.random.Generator) -> None:
    name = str(rng.choice(list(PARAMETERS)))
    field = page.get_by_test_id(f"{name}-field")
    field.fill(repr(random_collision(rng)[PARAMETERS[name]]))
    field.press("Enter")


def by_keys(page: Page, rng: np.random.Generator) -> None:
    slider = page.get_by_test_id(f"{rng.choice(list(PARAMETERS))}-slider")
    slider.focus()
    key = rng.choice(["ArrowUp", "ArrowDown", "PageUp", "PageDown"])
    for _ in range(rng.integers(1, 8)):
        page.keyboard.press(key)


def by_preset(page: Page, rng: np.random.Generator) -> None:
    choices = page.get_by_test_id("presets").locator("[data-preset]")
    choices.nth(int(rng.integers(choices.count()))).click()


def on_map(page: Page, rng: np.random.Generator) -> None:
    box = page.get_by_test_id("crosshair").bounding_box()
    x, y = rng.uniform(0.05, 0.95, 2)
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    page.mouse.down()
    page.mouse.move(box["x"] + x * box["width"], box["y"] + y * box["height"], steps=4)
    page.mouse.up()


def by_option(page: Page, rng: np.random.Generator) -> None:
    name = str(rng.choice(list(OPTIONS)))
    page.locator(f"[name={name}]:not(:checked)").check(force=True)


def assert_truth(page: Page, server: str, witness: Witness) -> None:
    asked = collision_of(page)
    answer = ask(server, "collision", **asked)
    assert strip_of(page) == strip_for(answer)
    for name, key in PARAMETERS.items():
        shown = float(page.get_by_test_id(f"{name}-field").input_value())
        assert shown == pytest.approx(asked[key], rel=5e-6)
    assert_traces(page, server, witness, asked)
    there = on_axes(page, asked)
    assert_cell(page, server, witness, there)
    assert_cut(page, server, witness, there)


def on_axes(page: Page, asked: dict[str, float]) -> dict[str, float]:
    """The same collision as map and cut ask for it: over ψ, that of μ/α = 1."""
    if not page.locator("[name=map_y][value=psi]").is_checked():
        return asked
    return asked | {
        "mu_over_alpha": 1.0,
        "gt_over_gn": asked["gt_over_gn"] / asked["mu_over_alpha"],
    }


def assert_traces(page: Page, server: str, witness: Witness, asked: dict[str, float]) -> None:
    """Every number of both pictures is one of the plain answer to the same question."""
    query = witness.last("trace")
    assert query is not None
    assert {key: float(query[key]) for key in asked} == asked
    plain = {k: v for k, v in query.items() if k not in {"encoding", "quantities"}}
    assert_pictured(page, ask(server, "trace", **plain))


def assert_pictured(page: Page, answer: dict, tolerance: float = 0.0) -> None:
    """The numbers of both pictures are those of an answer, or so near to them."""

    def is_among(column: list[float] | np.ndarray, name: str) -> bool:
        curves = [curve["y"] for curve in trace_of(page, name)]
        wanted = np.asarray(column)
        return any(
            len(curve) == wanted.size
            and np.max(np.abs(np.array(curve, float) - wanted)) <= tolerance * np.max(wanted)
            for curve in curves
        )

    normal = answer["normal_force"]
    tangential = np.array(answer["tangential_force_over_mu"])
    assert is_among(enlargement(page) * tangential, "force-trace")
    assert is_among(normal + [-y for y in reversed(normal)], "force-trace") or is_among(
        normal, "force-trace"
    )
    assert is_among(answer["tangential_velocity"], "velocity")
    for name in ("force-trace", "velocity"):
        assert_drawn(page, name)


def enlargement(page: Page) -> float:
    """The factor by which a small tangential force is drawn larger, as it is written beside it."""
    notes = page.get_by_test_id("force-trace").evaluate(
        "plot => plot.data.find(({name}) => name === 'enlargement').text"
    )
    power = re.fullmatch(r".*×\s*10(\S+)", notes[0])
    return float(f"1e{power[1].translate(SUPERSCRIPTS)}") if power else 1.0


def assert_drawn(page: Page, name: str) -> None:
    """The pixels are where the plot's axes put its numbers, to the two digits of an SVG path."""
    lines = page.get_by_test_id(name).evaluate(DRAWN_LINES)
    assert lines
    for line in lines:
        points = [point.split(",") for point in line["path"].lstrip("M").split("L")]
        drawn = np.array(points, dtype=float)
        np.testing.assert_allclose(drawn, np.transpose([line["x"], line["y"]]), atol=0.02)


def assert_cell(page: Page, server: str, witness: Witness, asked: dict[str, float]) -> None:
    """The cell under the crosshair is the nearest, and holds the answer to its own collision."""
    query = witness.last("map")
    assert query is not None
    assert float(query["mu_over_alpha"]) == asked["mu_over_alpha"]
    if page.get_by_test_id("crosshair").locator(".beyond").is_visible():
        return
    handles = [
        page.get_by_test_id("map").element_handle(),
        page.locator("[data-testid=crosshair] .crosshair-ring").element_handle(),
    ]
    cell = page.evaluate(CELL, handles)
    kappas, velocities = axis(query, "kappa"), axis(query, "gt_over_gn")
    there = {"kappa": kappas[cell["column"]], "gt_over_gn": velocities[cell["row"]]}
    for key, values in (("kappa", kappas), ("gt_over_gn", velocities)):
        # half a cell, and a pixel's rounding
        near = np.clip(asked[key], values[0], values[-1])
        along = np.log if query["kappa_scale"] == "log" else np.asarray
        step = np.diff(along(values))[0]
        assert abs(along(near) - along(there[key])) < 0.75 * step
    shown = page.locator("[name=map]:checked").get_attribute("value")
    answer = ask(server, "collision", **(asked | there))
    assert cell["z"] == pytest.approx(answer[shown], abs=1e-9)


def axis(query: dict[str, str], name: str) -> np.ndarray:
    low, high = float(query[f"{name}_min"]), float(query[f"{name}_max"])
    space = np.geomspace if query[f"{name}_scale"] == "log" else np.linspace
    return space(low, high, int(query[f"{name}_count"]))


def assert_cut(page: Page, server: str, witness: Witness, asked: dict[str, float]) -> None:
    query = witness.last("cut")
    assert query is not None
    assert float(query["mu_over_alpha"]) == asked["mu_over_alpha"]
    answer = ask(server, "cut", **{k: v for k, v in query.items() if k != "encoding"})
    assert float(query["kappa"]) == asked["kappa"]
    curves = [curve["y"] for curve in trace_of(page, "cut")]
    assert answer["epsilon_t"] in curves
