"""The states of the page in which everything is shown, and when each of them is complete."""

from explorer import agrees
from playwright.sync_api import Page
from rest import eventually

SCENES = {
    "explorer": "",
    "real spheres": "scene=spheres",
    "lesson": "scene=lesson&step=7&lang=de&notes=shown",
    "speed and accuracy": "scene=accuracy",
    "paper": "scene=paper&paper_verdict=fails",
    "whole paper": "scene=paper",
    "hand-out": "scene=lesson&lang=de&handout=shown&notes=shown",
}

# Where on the page every picture and control is.
PLACES = """() => Object.fromEntries(
  [...document.querySelectorAll("[data-panel], .parameter")].map((part) => {
    const {x, y, width, height} = part.getBoundingClientRect();
    return [part.dataset.panel ?? part.dataset.parameter, [x, y + scrollY, width, height]];
  }))"""

# Whatever is to be drawn is drawn, with the fonts that are to be there.
IS_COMPLETE = """() => {
  const shown = (e) => e.checkVisibility({visibilityProperty: true}) && e.clientWidth > 0;
  const plots = [...document.querySelectorAll(".plot")].filter(shown);
  const isDrawn = (plot) => plot.querySelector("text, canvas");
  const text = document.querySelector("[data-testid=handout]:not([hidden]), .statement");
  return document.fonts.status === "loaded"
    && (plots.length > 0 ? plots.every(isDrawn) : text !== null)
    && !document.querySelector("[data-stale]");
}"""


def open_scene(page: Page, server: str, query: str) -> None:
    """Open the page at an address and return once it shows all that it is going to."""
    page.goto(f"/?{query}", wait_until="load")

    def is_complete() -> None:
        assert page.evaluate(IS_COMPLETE), query
        # its numbers are those of the address
        assert "scene=" in query or agrees(page, server), query

    eventually(is_complete, page)
