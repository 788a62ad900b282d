"""What the lesson asks and says, and the hands that walk it."""

import json
import math
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page
from rest import eventually

LOCALES = Path(__file__).parents[2] / "frontend" / "locales"
LANGUAGES = sorted(file.stem for file in LOCALES.glob("*.json"))

SYMBOLS = {
    "epsilon_t": "εt",
    "epsilon_n": "εn",
    "kappa": "κ",
    "mu_over_alpha": "μ/α",
    "gt_over_gn": "gt/gn",
    "damping": "η",
    "psi": "ψ",
    "mu": "μ",
    "gt": "gt",
}

Answer = str | dict[str, float]

# Each step with an answer that is wrong, what is said to it, and one that is right: an option, or
# values of controls; `accuracy` is a notch between fast and exact.
STEPS: dict[str, tuple[Answer, str, Answer]] = {
    "spin": ("plus", "reasons.plus", "minus"),
    "stop": ({"gt-over-gn": 3.5}, "verdicts.forward", {"gt-over-gn": 2.8}),
    "reversal": ({"kappa": 10}, "verdicts.few", {"kappa": 63}),
    "switching": ("any", "reasons.any", "even"),
    "coulomb": ({"gt-over-gn": 2}, "verdicts.sticks", {"gt-over-gn": 3.2}),
    "gear": ({"kappa": 2}, "verdicts.backward", {"kappa": 0.96}),
    "stiff": ("root", "reasons.root", "power"),
    "collapse": ({"mu-over-alpha": 2.8}, "verdicts.apart", {"gt-over-gn": 1.4}),
    "damping": ({"kappa": 30}, "verdicts.even", {"damping": 0.2}),
    "timestep": ({"accuracy": 0}, "verdicts.sign", {"accuracy": 6}),
}

# How a goal is left again, where the wrong answer of before does not do it.
LEAVES: dict[str, Answer] = {"collapse": {"gt-over-gn": 2.4}, "damping": {"damping": 0}}

# What is predicted before the pictures are shown: an ε_t, or a sketch.
PREDICTIONS: dict[str, float | str] = {
    "stop": -0.5,
    "reversal": "swings",
    "coulomb": 0,
    "gear": -0.75,
}

# Where the thumb stands for a value, as a share of the slider.
SHARES: dict[str, Callable[[float], float]] = {
    "kappa": lambda value: math.log10(value / 0.1) / 4,
    "mu-over-alpha": lambda value: value / 4,
    "gt-over-gn": lambda value: math.sqrt(value / 4),
    "damping": lambda value: math.sqrt(value / 1.5),
    "accuracy": lambda notch: notch / 17,
}


class Texts:
    """What the lesson says in a language, as it is to be read on the page."""

    def __init__(self, language: str) -> None:
        content = (LOCALES / f"{language}.json").read_text(encoding="utf-8")
        self._texts = json.loads(content)["lesson"]

    def say(self, key: str, **values: object) -> str:
        found = self._texts
        for name in key.split("."):
            found = found[name]
        known = SYMBOLS | {name: str(value) for name, value in values.items()}
        return re.sub(r"{{(\w+)}}", lambda match: known[match[1]], found)

    def step(self, step: str, key: str) -> str:
        return self.say(f"steps.{step}.{key}")


def read(page: Page, name: str) -> str:
    """A text of the page in letters alone, however it breaks its lines."""
    return " ".join(page.get_by_test_id(name).inner_text().split())


def says(page: Page, name: str, wanted: str) -> None:
    def check() -> None:
        assert read(page, name) == " ".join(wanted.split())

    eventually(check, page)


def by_mouse(page: Page, answer: Answer) -> None:
    if isinstance(answer, str):
        page.locator(f"[data-option='{answer}']").click()
        return
    for name, value in answer.items():
        slider = page.get_by_test_id(f"{name}-slider")
        slider.scroll_into_view_if_needed()
        box = slider.bounding_box()
        thumb = 9 if name != "accuracy" else 8
        width = box["width"] - 2 * thumb
        now = slider.evaluate("s => (s.value - s.min) / (s.max - s.min)")
        y = box["y"] + box["height"] / 2
        page.mouse.move(box["x"] + thumb + now * width, y)
        page.mouse.down()
        page.mouse.move(box["x"] + thumb + SHARES[name](value) * width, y, steps=4)
        page.mouse.up()


def tab_to(page: Page, selector: str) -> None:
    for _ in range(120):
        if page.evaluate("(wanted) => document.activeElement.matches(wanted)", selector):
            return
        page.keyboard.press("Tab")
    pytest.fail(f"the Tab key does not come to {selector}")


def by_keyboard(page: Page, answer: Answer) -> None:
    if isinstance(answer, str):
        tab_to(page, f"[data-option='{answer}']")
        page.keyboard.press("Enter")
        return
    for name, value in answer.items():
        if name == "accuracy":
            tab_to(page, "[data-testid='accuracy-slider']")
            page.keyboard.press("Home")
            for _ in range(int(value)):
                page.keyboard.press("ArrowRight")
        else:
            tab_to(page, f"[data-testid='{name}-field']")
            page.keyboard.press("Control+A")
            page.keyboard.type(str(value))
            page.keyboard.press("Enter")


def predict_by_mouse(page: Page, guess: float | str) -> None:
    if isinstance(guess, str):
        page.locator(f"[data-sketch='{guess}']").click()
        return
    handle = page.get_by_test_id("predict-handle")
    box = handle.bounding_box()
    share = (guess + 1) / 2
    handle.click(position={"x": 9 + share * (box["width"] - 18), "y": box["height"] / 2})
    page.get_by_test_id("predict-commit").click()


def predict_by_keyboard(page: Page, guess: float | str) -> None:
    if isinstance(guess, str):
        tab_to(page, f"[data-sketch='{guess}']")
    else:
        tab_to(page, "[data-testid='predict-handle']")
        page.keyboard.press("Home")
        for _ in range(round((guess + 1) / 0.05)):
            page.keyboard.press("ArrowRight")
        tab_to(page, "[data-testid='predict-commit']")
    page.keyboard.press("Enter")


PREDICTING = {"mouse": predict_by_mouse, "keyboard": predict_by_keyboard}


def next_by_mouse(page: Page) -> None:
    page.get_by_test_id("lesson-next").click()


def next_by_keyboard(page: Page) -> None:
    tab_to(page, "[data-testid='lesson-next']")
    page.keyboard.press("Enter")


HANDS = {"mouse": (by_mouse, next_by_mouse), "keyboard": (by_keyboard, next_by_keyboard)}
