"""Run what is too long for every day; print what was done, how long it took, and what it found.

Each part is a process of its own and none keeps the next from running. Figures are what a test
prints.
"""

import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "build" / "verify"

OUTCOMES = {0: "passed", 2: "skipped"}
"""Of deploy/verify; the last where there is no engine."""

# Playwright leaves an event loop running, in which no other can begin.
RUNS = {
    "without a browser": ["-m", "verify and not browser"],
    "with many more random examples": [
        *("-m", "hypothesis and not verify and not browser"),
        "--hypothesis-profile=many",
    ],
    "in a browser": ["-m", "verify and browser"],
}


class Row(NamedTuple):
    """Something that was verified."""

    name: str
    seconds: float
    outcome: str
    figures: list[str]


def main() -> None:
    FOLDER.mkdir(parents=True, exist_ok=True)
    rows = []
    for name, chosen in RUNS.items():
        print(f"\n{name}", flush=True)
        rows += tests(name, chosen)
    print("\nthe image", flush=True)
    rows.append(image())
    show(rows)
    sys.exit(any(row.outcome == "failed" for row in rows))


def tests(name: str, chosen: list[str]) -> list[Row]:
    """Run the chosen tests; return a row for each, and one where the run itself failed."""
    results = FOLDER / f"{name.replace(' ', '-')}.xml"
    results.unlink(missing_ok=True)
    options = [f"--junitxml={results}", "-o", "junit_logging=system-out", "--timeout=3600"]
    begin = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "--verbose", *chosen, *options], cwd=ROOT, check=False
    )
    if not results.exists():
        reason = [f"pytest ended with {done.returncode}"]
        return [Row(name, time.monotonic() - begin, "failed", reason)]
    # written by the run above, not by a stranger
    return [row_of(case) for case in ET.parse(results).iter("testcase")]  # noqa: S314


def row_of(case: ET.Element) -> Row:
    outcome = "passed"
    figures = (case.findtext("system-out") or "").splitlines()
    for kind in ("failure", "error", "skipped"):
        if (found := case.find(kind)) is not None:
            outcome = "skipped" if kind == "skipped" else "failed"
            figures = (found.get("message") or "").splitlines()[:3]
    place = case.get("classname", "").removeprefix("tests.")
    return Row(f"{place} {case.get('name')}", float(case.get("time", 0)), outcome, figures)


def image() -> Row:
    """Build and verify the image where there is an engine for it."""
    begin = time.monotonic()
    done = subprocess.run([sys.executable, ROOT / "deploy" / "verify"], cwd=ROOT, check=False)
    outcome = OUTCOMES.get(done.returncode, "failed")
    return Row("deploy/verify", time.monotonic() - begin, outcome, ["its own table stands above"])


def show(rows: list[Row]) -> None:
    width = max(len(row.name) for row in rows)
    print(f"\n{'':{width}s}{'seconds':>9s}  outcome")
    for row in rows:
        print(f"{row.name:{width}s}{row.seconds:9.1f}  {row.outcome}")
        # what pytest puts around a test's own words
        figures = [line for line in row.figures if line.strip() and not line.startswith("---")]
        print("".join(f"    {line}\n" for line in figures), end="")
    total = sum(row.seconds for row in rows)
    counts = {kind: sum(row.outcome == kind for row in rows) for kind in ("passed", "skipped")}
    print(f"\n{counts['passed']} passed in {total / 60:.0f} min, {counts['skipped']} skipped")
    short = [row.name for row in rows if row.outcome == "failed"]
    print(
        "\n".join(["fell short:", *(f"  {name}" for name in short)])
        if short
        else "nothing fell short"
    )


if __name__ == "__main__":
    main()
