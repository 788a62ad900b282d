"""No test reads a clock: what is slow on a busy machine is not wrong there.

Times are measured by `make bench` and `make times`. Tests assert counts, orders and numbers, and
wait in `waiting.eventually`, whose limit is minutes.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
ROOT = TESTS.parent

MAY_READ_CLOCKS = {
    "tests/waiting.py": "the one place that waits",
    "tests/bench/": "measures, and judges nothing",
    "tests/verify.py": "says how long each check took",
    "tests/export/test_ten_million.py": "prints CPU over wall time, and judges by bytes and memory",
    "tests/test_clocks.py": "names them",
}

MAY_REST = {
    "tests/browser/rest.py": "lets Playwright's events happen between two looks",
    "tests/browser/test_monkey.py": "gives the history time to travel, and asserts nothing of it",
}
"""Where a page may be left alone for a while: `wait_for_timeout`."""

CLOCKS = re.compile(
    r"\bperformance\s*\.\s*now\b|\bDate\s*\.\s*now\b|\bnew Date\(\)|\bhrtime\b|timers/promises"
)
"""Of JavaScript, in files and in texts that a browser is given."""

LEAST_SECONDS = 60
"""Of a limit: it stops what hangs."""

WAITS = {"wait", "join", "result", "acquire", "poll", "wait_for", "timeout"}
"""Calls whose first argument is, or may be, a time-out."""


def number(node: ast.AST | None, constants: dict[str, float]) -> float | None:
    """Return the value of a number, or of a name that the module gives to one."""
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return None if isinstance(node.value, bool) else float(node.value)
    return constants.get(node.id) if isinstance(node, ast.Name) else None


def constants_of(tree: ast.Module) -> dict[str, float]:
    """Return name → number of the module."""
    return {
        target.id: value
        for node in tree.body
        if isinstance(node, ast.Assign) and (value := number(node.value, {})) is not None
        for target in node.targets
        if isinstance(target, ast.Name)
    }


def of_call(node: ast.Call, constants: dict[str, float], unit: float) -> Iterator[str]:
    """Yield what is wrong with a call; time-outs are in seconds divided by `unit`."""
    called = node.func
    name = called.attr if isinstance(called, ast.Attribute) else getattr(called, "id", "")
    owner = getattr(getattr(called, "value", None), "id", "")
    limits = [number(word.value, constants) for word in node.keywords if word.arg == "timeout"]
    if name in WAITS or (owner, name) == ("asyncio", "wait"):
        limits += [number(argument, constants) for argument in node.args]
    if any(limit is not None and 0 < limit * unit < LEAST_SECONDS for limit in limits):
        yield f"{name}: a limit of seconds"
    if owner == "asyncio" and name in {"wait_for", "timeout", "timeout_at"}:
        yield f"asyncio.{name}"
    if owner == "asyncio" and name == "sleep" and number(node.args[0], constants) != 0:
        yield "asyncio.sleep"
    if name in {"now", "utcnow", "today"} and owner in {"datetime", "date"}:
        yield f"{owner}.{name}"


def of_python(text: str, path: str) -> Iterator[tuple[int, str]]:
    """Yield line and kind of what depends on time in a module of Python."""
    tree = ast.parse(text)
    constants = constants_of(tree)
    # Playwright has milliseconds
    unit = 1e-3 if path.startswith("tests/browser/") else 1.0
    for node in ast.walk(tree):
        found: list[str] = []
        if isinstance(node, ast.Import):
            found = [n.name for n in node.names if n.name in {"time", "timeit"}]
        elif isinstance(node, ast.ImportFrom):
            found = [f"from {node.module}"] if node.module in {"time", "timeit"} else []
        elif isinstance(node, ast.Call):
            found = [*of_call(node, constants, unit)]
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            found = CLOCKS.findall(node.value)
        elif isinstance(node, ast.Attribute) and node.attr == "wait_for_timeout":
            found = [] if path in MAY_REST else ["wait_for_timeout"]
        for kind in found:
            yield node.lineno, kind


def of_javascript(text: str) -> Iterator[tuple[int, str]]:
    """Yield line and kind of what reads a clock in a module of JavaScript."""
    for line, content in enumerate(text.splitlines(), 1):
        for kind in CLOCKS.findall(content):
            yield line, kind


def test_no_test_reads_a_clock_or_waits_for_seconds():
    found = []
    for source in sorted([*TESTS.rglob("*.py"), *TESTS.rglob("*.js")]):
        path = source.relative_to(ROOT).as_posix()
        if path.startswith(tuple(MAY_READ_CLOCKS)):
            continue
        text = source.read_text(encoding="utf-8")
        places = of_python(text, path) if source.suffix == ".py" else of_javascript(text)
        found += [f"{path}:{line}: {kind}" for line, kind in places]
    assert not found, "\n".join(found)


def test_places_that_may_exist():
    for path in (*MAY_READ_CLOCKS, *MAY_REST):
        assert (ROOT / path).exists(), path


@pytest.mark.parametrize(
    "text",
    [
        "import time",
        "import os, time",
        "from time import perf_counter as now",
        "import timeit",
        "from datetime import datetime\ndatetime.now()",
        "urlopen(url, timeout=5)",
        "SOON = 30\nurlopen(url, timeout=SOON)",
        "expect(page).to_be_visible(timeout=20)",
        "event.wait(10)",
        "thread.join(0.5)",
        "future.result(2)",
        "await asyncio.wait_for(task, 2.0)",
        "await asyncio.sleep(0.2)",
        "page.wait_for_timeout(300)",
        "page.evaluate('() => performance.now() - begun')",
        "SCRIPT = '''\n  const begun = Date.now();\n'''",
    ],
)
def test_every_way_to_depend_on_time_is_found(text):
    assert [*of_python(text, "tests/test_example.py")]


def test_milliseconds_of_playwright_are_told_from_seconds():
    text = "expect(page).to_be_visible(timeout=20_000)"
    assert [*of_python(text, "tests/browser/test_example.py")]
    assert not [*of_python(text.replace("20_000", "300_000"), "tests/browser/test_example.py")]


@pytest.mark.parametrize(
    "text",
    [
        "subprocess.run(command, timeout=120)",
        "event.wait()",
        "event.wait(LIMIT_SECONDS)",
        "await asyncio.sleep(0)",
        "' '.join(names)",
        "study_table(kappa, psi, seconds=10)",
        "answer['time']",
    ],
)
def test_what_does_not_depend_on_time_is_let_be(text):
    assert not [*of_python(text, "tests/test_example.py")]


def test_clocks_of_javascript_are_found():
    assert [*of_javascript("const begun = performance.now();\n")] == [(1, "performance.now")]
    assert not [*of_javascript("context.mock.timers.tick(1000);\n")]
