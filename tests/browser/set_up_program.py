"""Print the path of a program of the tests: the machine's, or Debian's, installed; or nothing."""

from __future__ import annotations

import os
import shutil
import sys

from set_up_browser import PATH, debian_package, tell


def main() -> None:
    name = sys.argv[1]
    found = program_of_machine(name) or debian_package(name, "a program of the tests")
    if not found:
        tell(f"no {name}: its tests are skipped; install one, or set {variable(name)} to its path")
    print(found or "")


def program_of_machine(name: str) -> str | None:
    """Return the path of nginx, apache2, traefik, firefox-esr or yade."""
    return os.environ.get(variable(name)) or shutil.which(name, path=PATH)


def variable(name: str) -> str:
    return name.upper().replace("-", "_")


if __name__ == "__main__":
    main()
