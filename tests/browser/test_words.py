"""Every word on the page is from the locales, and each is there when its scene is."""

import re

import pytest
from page_words import change_words, changed
from playwright.sync_api import Page
from rest import rest

from cases import every_day

pytestmark = pytest.mark.browser

SCENES = {
    "explorer": "face=expert&energy=shown&damping=0.2",
    "plain": "face=plain",
    "second bounce": "bounce=wall_twice&map=switches",
    "real spheres": "scene=spheres&normal_restitution=0.9&radius_2_m=0.01&material=steel-on-steel",
    "speed and accuracy": "scene=accuracy&method=timestep",
    "paper": "scene=paper",
    "hand-out": "scene=lesson&handout=shown&notes=shown",
    "panel": "embed=force",
    **{f"lesson, step {step}": f"scene=lesson&step={step}&notes=shown" for step in range(1, 11)},
}

# Names that are the same in all languages.
NAMES = r"https?://\S+|CSV|JSON|PNG|SVG|LAMMPS|YADE|LIGGGHTS|MercuryDPM|MFIX|log"

# What is to be read or heard, but for code, names, and what the service says in English.
SAID = """() => {
  document.querySelectorAll("details").forEach((e) => { e.open = true; });
  const said = [];
  const note = (e, text) => {
    const isOurs = !e.closest("body [lang=en], code, pre, .credit, h1, noscript,"
      + "[data-testid=language], [data-testid=tradeoff-source]");
    if (text && isOurs && e.checkVisibility({visibilityProperty: true})) said.push(text.trim());
  };
  for (const e of document.querySelectorAll("body, body *:not(script, style, template)")) {
    for (const name of ["aria-label", "title", "alt", "placeholder"]) note(e, e.getAttribute(name));
    for (const node of e.childNodes) if (node.nodeType === 3) note(e, node.data);
  }
  return said;
}"""

WORD = re.compile(r"[A-Za-z]{3,}")


def marked(text: str) -> str:
    """Return a text whose letters carry a mark; what is put into it by name does not."""
    parts = re.split(r"({{\w+}})", text)
    return "".join(
        part if part.startswith("{{") else re.sub(r"[A-Za-z]", "\\g<0>\u0325", part)
        for part in parts
    )


@pytest.mark.parametrize("scene", every_day(["real spheres"], of=SCENES))
def test_every_word_is_from_the_locales(page: Page, scene: str):
    change_words(page, lambda texts: changed(texts, marked))
    page.goto(f"/?{SCENES[scene]}")
    rest(page)
    said = page.evaluate(SAID)
    assert len(said) > 5
    assert [text for text in said if WORD.search(re.sub(NAMES, "", text))] == []
