"""Print the path of a proxy by name: the machine's, or Debian's, installed; or nothing."""

from __future__ import annotations

import os
import shutil
import sys

from set_up_browser import PATH, debian_package, tell


def main() -> None:
    name = sys.argv[1]
    found = proxy_of_machine(name) or debian_package(name, "a proxy in its tests")
    if not found:
        tell(f"no {name}: its tests are skipped; install one, or set {name.upper()} to its path")
    print(found or "")


def proxy_of_machine(name: str) -> str | None:
    """Return the path of nginx, apache2 or traefik."""
    return os.environ.get(name.upper()) or shutil.which(name, path=PATH)


if __name__ == "__main__":
    main()
