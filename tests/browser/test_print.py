"""On paper each scene is one A4 page, whole."""

import re

import pytest
from explorer import visit
from playwright.sync_api import Page
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

SCENES = {
    "explorer": "",
    "plain": "face=plain",
    "plain, compared": "face=plain&kappa=30&pins=63,1.4,1.358;4.5,1.4,4",
    "switches": "map=switches&gt_over_gn=0.3&energy=shown",
    "damped": "damping=0.3",
    "compared": "kappa=30&pins=63,1.4,1.358;4.5,1.4,4;18,0.8,0.9,0.3",
    "real spheres": "scene=spheres&material=alumina-on-glass",
    "real spheres, unfolded": "scene=spheres&normal_restitution=0.9&radius_2_m=0.01",
    "speed and accuracy": "scene=accuracy&method=timestep",
    **{f"lesson, step {step}": f"scene=lesson&step={step}&lang=de" for step in range(1, 11)},
    "lesson, expert": "scene=lesson&step=10&face=expert",
}
SIZES = [(390, 844), (1280, 720), (1920, 1080)]

A4 = {842, 595}
"""Width and height in points."""

# What of the page as it is laid out for paper is cut off or lies on something else.
FAULTS = """() => {
  const seen = [...document.querySelectorAll("body *")].filter((e) => e.checkVisibility());
  const page = document.body.getBoundingClientRect();
  const isText = (e) => [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim());
  const ownBox = (e) => {
    const range = document.createRange();
    range.selectNodeContents(e);
    return range.getBoundingClientRect();
  };
  const faults = [];
  const panels = [".result", ".compare", ".side", ".lesson", ".plot-panel"].flatMap((s) =>
    seen.filter((e) => e.matches(s)));
  for (const panel of panels) {
    const name = panel.className;
    const frame = panel.getBoundingClientRect();
    const isBeyond = frame.bottom > page.bottom + 1 || frame.right > page.right + 1;
    if (isBeyond) faults.push(`${name} is beyond the page`);
    for (const e of panel.querySelectorAll("*")) {
      if (!e.checkVisibility() || e.closest("svg, .unseen") || !isText(e)) continue;
      const box = ownBox(e);
      if (box.bottom > frame.bottom + 2) faults.push(`${name}: ${e.textContent} is cut`);
    }
  }
  for (const plot of seen.filter((e) => e.matches(".plot"))) {
    const [place, svg] = [plot, plot.querySelector(".main-svg")].map((e) =>
      e?.getBoundingClientRect());
    if (!svg || place.height < 60) faults.push(`${plot.dataset.testid} is ${place.height} high`);
    else if (Math.abs(svg.width - place.width) > 1 || Math.abs(svg.height - place.height) > 1)
      faults.push(`${plot.dataset.testid} is not drawn for paper`);
  }
  for (const one of panels) for (const other of panels) {
    const [a, b] = [one, other].map((e) => e.getBoundingClientRect());
    if (one !== other && a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1
      && b.top < a.bottom - 1) faults.push(`${one.className} lies on ${other.className}`);
  }
  return faults;
}"""


@pytest.mark.parametrize(
    "scene",
    every_day(["lesson, step 4"], of=SCENES),
)
@pytest.mark.parametrize(("width", "height"), every_day([(1280, 720)], of=SIZES))
def test_a_scene_is_one_page_of_a4(used_tab: Page, scene: str, width: int, height: int):
    used_tab.set_viewport_size({"width": width, "height": height})
    used_tab.emulate_media(color_scheme="dark")
    visit(used_tab, f"/?{SCENES[scene]}")
    rest(used_tab)
    pdf = used_tab.pdf(prefer_css_page_size=True)
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) == 1
    box = re.search(rb"/MediaBox\s*\[([\d. ]+)\]", pdf)
    assert {round(float(number)) for number in box[1].split()[2:]} == A4


@pytest.mark.parametrize("scene", every_day(["explorer"], of=SCENES))
def test_on_paper_nothing_is_cut_off_and_pictures_fill_their_places(used_tab: Page, scene: str):
    visit(used_tab, f"/?{SCENES[scene]}")
    rest(used_tab)
    used_tab.evaluate("() => dispatchEvent(new Event('beforeprint'))")
    used_tab.emulate_media(media="print")
    try:
        assert used_tab.evaluate(FAULTS) == []
    finally:
        used_tab.evaluate("() => dispatchEvent(new Event('afterprint'))")


# Where the parts of the page are when it is laid out for paper.
PLACES = """() => [...document.querySelectorAll(".result, .side, .lesson, .plot-panel, .plot")]
  .filter((e) => e.checkVisibility())
  .map((e) => [e, Object.values(e.getBoundingClientRect().toJSON())])
  .map(([e, box]) => [e.className, ...box.map(Math.round)])"""


@pytest.mark.parametrize("scene", every_day(["explorer"], of=SCENES))
def test_paper_is_laid_out_alike_from_every_window(used_tab: Page, scene: str):
    visit(used_tab, f"/?{SCENES[scene]}")
    rest(used_tab)
    used_tab.evaluate("() => dispatchEvent(new Event('beforeprint'))")
    try:
        places = []
        for width, height in [*SIZES, (1047, 718)]:
            used_tab.set_viewport_size({"width": width, "height": height})
            places.append(used_tab.evaluate(PLACES))
        assert all(each == places[0] for each in places)
    finally:
        used_tab.evaluate("() => dispatchEvent(new Event('afterprint'))")


# Each picture as it is drawn: where its parts are, and in which colours.
DRAWN = """() => [...document.querySelectorAll(".plot")].filter((e) => e.checkVisibility())
  .map((e) => [...e.querySelectorAll("path, text")].map((part) =>
    [part.getAttribute("d") ?? part.textContent, part.getAttribute("style")]))"""


def test_after_printing_the_page_is_as_before(tab: Page):
    tab.emulate_media(color_scheme="dark")
    rest(tab)
    before = tab.evaluate(PLACES), tab.evaluate(DRAWN)
    tab.pdf(prefer_css_page_size=True)
    rest(tab)
    assert (tab.evaluate(PLACES), tab.evaluate(DRAWN)) == before
