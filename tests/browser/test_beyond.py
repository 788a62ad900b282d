"""What lies beyond an axis is told with its value, and marked nowhere as if it were there."""

import pytest
from explorer import number, settle, text, visit
from playwright.sync_api import Locator, Page, expect
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

# The picture, an address beyond its axes, what it says, and the lines of its mark that stay.
BEYOND = [
    ("crosshair", "gt_over_gn=1000", "g_t/g_n = 1000 ↑", [".crosshair-x"]),
    ("crosshair", "kappa=20000", "κ = 20000 →", [".crosshair-y"]),
    ("crosshair", "kappa=20000&gt_over_gn=1000", "κ = 20000, g_t/g_n = 1000 ↗", []),
    ("crosshair", "gt_over_gn=1000&map_y=psi", "ψ = 714.3 ↑", [".crosshair-x"]),
    ("cut-mark", "gt_over_gn=1000", "g_t/g_n = 1000: ε_t = 0.9972 →", []),
    ("error-crosshair", "scene=accuracy&kappa=20000", "κ = 20000 →", [".crosshair-y"]),
    ("place-mark", "scene=spheres&friction_coefficient=0", "ψ = ∞ ↑", []),
]


def words(mark: Locator) -> str:
    return mark.locator(".beyond").evaluate("""(element) => [...element.childNodes].map((node) =>
      (node.nodeName === "SUB" ? "_" : "") + node.textContent).join("")""")


@pytest.mark.parametrize(("name", "query", "told", "lines"), every_day(BEYOND[2:3], of=BEYOND))
def test_what_lies_beyond_an_axis_is_told_there_and_not_marked(
    used_tab: Page, server: str, name: str, query: str, told: str, lines: list[str]
):
    visit(used_tab, f"/?{query}")
    settle(used_tab, server)
    rest(used_tab)
    mark = used_tab.get_by_test_id(name)
    expect(mark.locator(".beyond")).to_be_visible()
    assert words(mark) == told
    for part in (".crosshair-ring", ".cut-ring", ".crosshair-x", ".crosshair-y", ".cut-line"):
        for each in mark.locator(part).all():
            assert each.is_visible() == (part in lines)


def test_a_mark_on_the_axes_says_nothing(tab: Page):
    rest(tab)
    for name in ("crosshair", "cut-mark"):
        expect(tab.get_by_test_id(name).locator(".beyond")).to_be_hidden()


# Rings at the corners of their pictures: what of them another element's edge cuts off.
CLIPPED = """(name) => {
  const ring = document.querySelector(`[data-testid=${name}] :is(.crosshair-ring, .cut-ring)`);
  const box = ring.getBoundingClientRect();
  const cut = [];
  for (let parent = ring.parentElement; parent; parent = parent.parentElement) {
    const clips = getComputedStyle(parent).overflow !== "visible";
    const frame = parent.getBoundingClientRect();
    const sides = [box.left - frame.left, frame.right - box.right,
                   box.top - frame.top, frame.bottom - box.bottom];
    if (clips && Math.min(...sides) < 0) cut.push(parent.className);
  }
  return cut;
}"""


@pytest.mark.verify
@pytest.mark.parametrize("query", ["kappa=0.1&gt_over_gn=0.01", "kappa=70&gt_over_gn=4"])
def test_a_ring_at_an_edge_is_whole(used_tab: Page, server: str, query: str):
    visit(used_tab, f"/?{query}")
    settle(used_tab, server)
    rest(used_tab)
    for name in ("crosshair", "cut-mark"):
        assert used_tab.evaluate(CLIPPED, name) == []


def test_a_method_that_leaves_the_gauge_is_told_at_its_end(used_tab: Page, server: str):
    visit(used_tab, "/?kappa=1000&method=timestep&steps=10&integrator=forward_euler&gt_over_gn=0.1")
    settle(used_tab, server)
    rest(used_tab)
    epsilon = number(text(used_tab, "epsilon-t"))
    assert abs(epsilon) > 1.1
    mark = used_tab.get_by_test_id("gauge-mark")
    assert mark.get_attribute("data-beyond") == ("1" if epsilon > 0 else "-1")
    assert mark.evaluate("e => e.style.getPropertyValue('--place')") == (
        "1" if epsilon > 0 else "0"
    )


def test_coulombs_map_is_shown_over_coulombs_result(used_tab: Page, server: str):
    impact = "normal_velocity_m_s=20&tangential_velocity_m_s=100"
    visit(used_tab, f"/?scene=spheres&material=steel&velocity_law=coulomb&{impact}")
    settle(used_tab, server)
    rest(used_tab)
    # 1 − 2μ/α · g_n/g_t, Eq. 16
    assert text(used_tab, "epsilon-t") == "0.4400"
    ring = used_tab.get_by_test_id("sphere-cut").evaluate(
        "plot => plot.data.find(({name}) => name === 'present impact').y[0]"
    )
    assert ring == pytest.approx(0.44, abs=1e-3)
    assert used_tab.get_by_test_id("method").input_value() == "coulomb"
    used_tab.get_by_test_id("velocity-law").locator("[value=epsilon_t]").check()
    settle(used_tab, server)
    assert used_tab.get_by_test_id("method").input_value() == "auto"
    used_tab.get_by_test_id("method").select_option("coulomb")
    settle(used_tab, server)
    assert "velocity_law=coulomb" in used_tab.url
