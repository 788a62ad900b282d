"""Print the path of an nginx: the machine's, or Debian's; nothing where there is none."""

from __future__ import annotations

import os
import shutil

from set_up_browser import run, tell

PATH = f"{os.environ.get('PATH', '')}:/usr/sbin"
"""Debian keeps it where only root looks."""


def main() -> None:
    found = nginx_of_machine()
    if not found and os.geteuid() == 0 and shutil.which("apt-get"):
        tell("installing Debian's nginx")
        run("apt-get update", ["apt-get", "update"])
        run("apt-get install", ["apt-get", "install", "--yes", "--no-install-recommends", "nginx"])
        found = nginx_of_machine()
    if not found:
        tell("no nginx: its tests are skipped; install one, or set NGINX to the path of one")
    print(found or "")


def nginx_of_machine() -> str | None:
    return os.environ.get("NGINX") or shutil.which("nginx", path=PATH)


if __name__ == "__main__":
    main()
