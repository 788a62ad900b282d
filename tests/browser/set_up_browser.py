"""Print the path of a Chromium that starts: the machine's, or Debian's, installed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

from playwright.sync_api import Error, sync_playwright

ARGUMENTS = [
    # Chromium's sandbox refuses root and most containers; the pages are our own.
    "--no-sandbox",
    "--disable-gpu",
    # Chromium's own calls home fail slowly where there is no network.
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    # A browser that is driven looks up where each function stands; V8 would read all of Plotly
    # again for that in every load, a second of work that nobody else's browser does.
    "--js-flags=--no-enable-lazy-source-positions",
]
NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""First the engine alone: without a browser's windows it takes 40 % less of the processor."""


def main() -> None:
    path = chromium_of_machine() or debian_package("chromium-headless-shell", "the tests' browser")
    if not path:
        sys.exit("no Chromium: install one, or set CHROMIUM to the path of one")
    if reason := why_not(path):
        sys.exit(f"{path} does not start: {reason}\nset CHROMIUM to the path of another")
    print(path)


def chromium_of_machine() -> str | None:
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)


def why_not(path: str) -> str:
    """Return why a browser does not run, in its own words; nothing if it does."""
    with sync_playwright() as playwright:
        try:
            playwright.chromium.launch(executable_path=path, args=ARGUMENTS).close()
        except Error as error:
            return str(error)
    return ""


def debian_package(name: str, purpose: str) -> str | None:
    """Install a package of Debian's if that can be done here; return the path of its program."""
    if os.geteuid() != 0 or not shutil.which("apt-get"):
        return None
    tell(f"installing Debian's {name}, {purpose}")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    install = ["apt-get", "install", "--yes", "--no-install-recommends", name]
    for command in (["apt-get", "update"], install):
        done = subprocess.run(command, capture_output=True, env=environment, check=False)
        if done.returncode != 0:
            # apt's own lines of failure begin so
            lines = done.stderr.decode(errors="replace").splitlines()
            tell(
                "\n  ".join(
                    [f"{' '.join(command[:2])} failed", *[x for x in lines if x[:2] == "E:"]]
                )
            )
            return None
    return shutil.which(name, path=PATH)


PATH = f"{os.environ.get('PATH', '')}:/usr/sbin"
"""Debian keeps servers where only root looks."""


def tell(text: str) -> None:
    print(text, file=sys.stderr)


if __name__ == "__main__":
    main()
