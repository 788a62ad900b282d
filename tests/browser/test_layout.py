"""No label lies on another, wraps or is cut off: at every width, with a wide and a narrow font."""

from collections.abc import Iterable
from pathlib import Path

import pytest
from playwright.sync_api import Page
from rest import eventually, rest
from whole_page import open_scene

from cases import every_day

pytestmark = pytest.mark.browser

SIZES = {320: 640, 390: 844, 820: 1180, 1280: 720, 1440: 900, 1920: 1080}

# Over a text DejaVu Sans is 11 % wider than our own, Liberation Sans Narrow 20 % narrower: so are
# these, on a machine that has neither.
FONTS = {"own": 100, "wide": 112, "narrow": 80}

# The longest that stands in each place.
LONGEST = {
    "epsilon-t": "−1.888\u202f×\u202f10⁻⁴",
    "switches": "49988",
    "reversals": "49988",
    "energy-lost": ">\u202f99.9\u202f%",
    "contact-duration": "3.218",
    "psi": "4.188\u202f×\u202f10⁻³⁰⁰",
    "epsilon-n": "8.888\u202f×\u202f10⁻¹⁶",
}

STATES = {
    "explorer": "kappa=2500000&mu_over_alpha=1.412&gt_over_gn=1.3579&damping=1.5&alpha=0.285714",
    "undamped": "kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358&map=switches&scale=log&energy=shown",
    "compared": "kappa=30&pins=2500000,1.412,1.3579,1.5;4.5,1.4,4;18,0.8,0.9",
    "real spheres": "scene=spheres",
    "real spheres, unfolded": "scene=spheres&normal_restitution=0.9&radius_2_m=0.01",
    "lesson": "scene=lesson&step=9&lang=de&notes=shown",
    "speed and accuracy": "scene=accuracy&method=timestep&steps=10000&integrator=symplectic_euler",
    "paper": "scene=paper&paper_verdict=fails",
    "whole paper": "scene=paper",
    "hand-out": "scene=lesson&lang=de&handout=shown&notes=shown",
}

# The page's own files under another name: Plotly measures a text anew only if its style is another.
SET_FONT = """async ([name, percent]) => {
  document.getElementById("font-of-test")?.remove();
  const style = document.createElement("style");
  style.id = "font-of-test";
  const own = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
    .filter((rule) => rule.cssText.includes("woff2"));
  const faces = own.map((rule) => {
    const share = parseFloat(rule.style.getPropertyValue("size-adjust") || "100%");
    return rule.cssText.replace(/size-adjust:[^;]+;/, "").replace("Inter with STIX", name)
      .replace(/url\\("([^"]+)/, (_, file) => `url("${new URL(file, rule.parentStyleSheet.href)}`)
      .replace(/}$/, `size-adjust: ${share * percent / 100}%; }`);
  });
  style.textContent = faces.join("") + `:root { --sans: "${name}"; --math: "${name}"; }`
    // On a phone they lie over what is scrolled beneath them.
    + ".controls { position: static !important; }";
  document.head.append(style);
  await Promise.all(["", "italic "].map((slant) => document.fonts.load(`${slant}16px "${name}"`)));
}"""

# Pictures that have not yet the size of their place and the font of the page.
LATE = """([name, width]) => {
  const isLate = (plot) => {
    const svg = plot.querySelector(".main-svg");
    const {width, height} = plot.getBoundingClientRect();
    return svg && plot.checkVisibility() && width > 0
      && (Math.abs(svg.width.baseVal.value - width) > 1
        || Math.abs(svg.height.baseVal.value - height) > 1
        || !plot.querySelector("text")?.style.fontFamily.includes(name));
  };
  const late = [...document.querySelectorAll(".plot")].filter(isLate);
  return [...(innerWidth === width ? [] : ["window"]), ...late.map((plot) => plot.dataset.testid)];
}"""

WRITE = """(texts) => {
  for (const [name, text] of Object.entries(texts)) {
    const place = document.querySelector(`[data-testid=${name}]`);
    place.textContent = text;
    place.toggleAttribute("data-long", text.includes("×"));
  }
}"""

FAULTS = Path(__file__).with_name("faults.js").read_text(encoding="utf-8")


# Each width once, the narrow ones with what is wide: that is what overlaps.
EVERY_DAY = {"wide": [320, 820, 1280], "own": [390, 1440], "narrow": [1920]}
EVERYTHING = dict.fromkeys(FONTS, SIZES)


# The whole list has eleven thousand elements.
@pytest.mark.parametrize("state", every_day(["explorer"], of=STATES))
@pytest.mark.parametrize(
    "looks", [EVERY_DAY, pytest.param(EVERYTHING, marks=pytest.mark.verify)], ids=["some", "all"]
)
def test_boxes_keep_apart_in_every_font_and_at_every_width(
    page: Page, server: str, state: str, looks: dict[str, Iterable[int]]
):
    page.set_viewport_size({"width": 1440, "height": 900})
    open_scene(page, server, STATES[state])
    page.evaluate(WRITE, LONGEST)
    faults = []
    for font, widths in looks.items():
        page.evaluate(SET_FONT, [font, FONTS[font]])
        for width in widths:
            page.set_viewport_size({"width": width, "height": SIZES[width]})
            eventually(lambda look=[font, width]: is_drawn(page, look), page)
            rest(page)
            faults += [f"{state}, {width} px, {font}: {each}" for each in page.evaluate(FAULTS)]
    assert not faults, "\n".join(faults)


def is_drawn(page: Page, look: list[str | int]) -> None:
    assert page.evaluate(LATE, look) == []
