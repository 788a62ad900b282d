"""Print the path of a Chromium that starts: the machine's, Playwright's own, or Debian's."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from playwright.sync_api import Error, sync_playwright

if TYPE_CHECKING:
    from collections.abc import Iterator

ARGUMENTS = [
    # Chromium's sandbox refuses root and most containers; the pages are our own.
    "--no-sandbox",
    "--disable-gpu",
    # Chromium's own calls home fail slowly where there is no network.
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]
NAMES = ("chromium", "chromium-browser", "google-chrome")
# Enough for 200 MB on a slow line; a network that swallows the request must not hold up the rest.
DOWNLOAD_SECONDS = 240


def main() -> None:
    for path in candidates():
        if starts(path):
            print(path)
            return
        tell(f"{path} does not start")
    sys.exit("no Chromium: install one, or set CHROMIUM to the path of one")


def candidates() -> Iterator[str]:
    machine = chromium_of_machine()
    if machine:
        yield machine
    # A browser asked for by name is not exchanged for another in silence.
    if "CHROMIUM" in os.environ:
        return
    own = playwright_path()
    if not own.exists():
        tell("downloading Playwright's Chromium")
        run(
            "Playwright's download",
            [sys.executable, "-m", "playwright", "install", "--no-shell", "chromium"],
        )
    if own.exists():
        yield str(own)
    if os.geteuid() == 0 and shutil.which("apt-get"):
        tell("installing Debian's Chromium")
        run("apt-get update", ["apt-get", "update"])
        run(
            "apt-get install",
            ["apt-get", "install", "--yes", "--no-install-recommends", "chromium"],
        )
        debian = shutil.which("chromium")
        if debian:
            yield debian


def chromium_of_machine() -> str | None:
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)


def playwright_path() -> Path:
    with sync_playwright() as playwright:
        return Path(playwright.chromium.executable_path)


def starts(path: str) -> bool:
    """Tell whether the browser runs; a download without its system libraries does not."""
    with sync_playwright() as playwright:
        try:
            playwright.chromium.launch(executable_path=path, args=ARGUMENTS).close()
        except Error:
            return False
    return True


def run(what: str, command: list[str]) -> None:
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    try:
        subprocess.run(
            command, check=True, capture_output=True, env=environment, timeout=DOWNLOAD_SECONDS
        )
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
        lines = (error.stderr or b"").decode(errors="replace").splitlines()
        # Playwright's lines begin with "Error:", apt's with "E:".
        reasons = [line for line in lines if line.startswith("E")][:2]
        tell("\n  ".join([f"{what} failed", *reasons]))


def tell(text: str) -> None:
    print(text, file=sys.stderr)


if __name__ == "__main__":
    main()
