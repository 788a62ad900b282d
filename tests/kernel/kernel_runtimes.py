"""What the kernel of the page answers, in Node and in a real page of browsers."""

import json
import math
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from set_up_browser import ARGUMENTS, chromium_of_machine
from set_up_program import program_of_machine

TESTS = Path(__file__).parents[1]
IN_NODE = TESTS / "frontend" / "kernel" / "answer.js"
IN_PAGE = TESTS / "browser" / "kernel-in-page.js"

NODE = Path(sys.executable).with_name("node")

BROWSERS = {
    "chromium": ("chrome", chromium_of_machine(), *ARGUMENTS),
    "firefox": ("firefox", program_of_machine("firefox-esr")),
}
"""As Puppeteer calls them, their programs and arguments of these."""

AT_A_TIME = 1000
"""Calls that a page gets at once: some megabytes of answers."""

Calls = list[list[Any]]
"""Calls of frontend/kernel/kernel.js, each a name and its arguments."""

Answers = Callable[[Calls], list[Any]]


def answers_in_node(calls: Calls) -> list[Any]:
    done = subprocess.run(
        [NODE, IN_NODE], input=json.dumps(calls), capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)


@contextmanager
def page_of(browser: str, server: str) -> Iterator[Answers]:
    """Yield what a page of a server answers, as long as its browser is open."""
    kind, program, *arguments = BROWSERS[browser]
    command = [NODE, IN_PAGE, kind, program, f"{server}/", *arguments]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:

        def answers(calls: Calls) -> list[Any]:
            found = []
            for begin in range(0, len(calls), AT_A_TIME):
                print(json.dumps(calls[begin : begin + AT_A_TIME]), file=process.stdin, flush=True)
                line = process.stdout.readline()
                assert line, f"{browser} answers no more: it ended with {process.wait()}"
                found += json.loads(line)
            return found

        yield answers
        # which closes the browser, too
        process.stdin.close()


def collision(kappa: float, psi: float, damping: float = 0.0) -> dict[str, float]:
    """Return the parameters of a collision, of μ/α = 1 but where ψ is infinite."""
    given = {"mu_over_alpha": 1.0, "gt_over_gn": float(psi)}
    if psi == math.inf:
        given = {"mu_over_alpha": 0.0, "gt_over_gn": 1.0}
    return {"kappa": float(kappa), **given, "damping": float(damping)}


def column(found: list[dict[str, Any]], name: str) -> np.ndarray:
    return np.array([each[name] for each in found])


def random_states(count: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return κ, ψ and η; every other collision is undamped."""
    random = np.random.default_rng(seed)
    kappa = 10 ** random.uniform(-2, 4, count)
    psi = 10 ** random.uniform(-5, 0.8, count)
    damping = 10 ** random.uniform(-6, 3, count)
    damping[::2] = 0.0
    return kappa, psi, damping
