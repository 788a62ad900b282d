"""Print the path of an nginx: the machine's, or Debian's, installed; or nothing."""

from __future__ import annotations

import os
import shutil

from set_up_browser import PATH, debian_package, tell


def main() -> None:
    found = nginx_of_machine() or debian_package("nginx", "the proxy in its tests")
    if not found:
        tell("no nginx: its tests are skipped; install one, or set NGINX to the path of one")
    print(found or "")


def nginx_of_machine() -> str | None:
    return os.environ.get("NGINX") or shutil.which("nginx", path=PATH)


if __name__ == "__main__":
    main()
