"""Any user on any disk: the package is imported, computes and serves, whatever can be written to.

A namespace of mounts of its own makes a machine whose disks are read-only but for some folders.
Nobody in particular may read all of it, for the tests' Python may lie in somebody's home.
"""

import itertools
import os
import subprocess
import sys
import urllib.request
from pathlib import Path
from typing import NamedTuple

import pytest

from servers import free_port, kill_with_children, wait_until_ready

CONFINE = r"""
set -e
for folder in /tmp /var/tmp /root; do
    mount --bind "$folder" "$folder"
    mount -o remount,bind,ro "$folder"
done
while [ "$1" != -- ]; do
    mount --bind "$1" "$1"
    mount -o remount,bind,rw "$1"
    shift
done
shift
exec "$@"
"""
READING = "+dac_read_search"
MAY_READ = f"--inh-caps=-all,{READING} --ambient-caps=-all,{READING} --bounding-set=-all,{READING}"

COMPUTE = """
import restitution
from restitution.mechanics.compiled import CACHE_FOLDER
from restitution.mechanics.scaled_velocity import psi_of
print(psi_of(1.4, 0.7), CACHE_FOLDER)
"""


class Machine(NamedTuple):
    """Whose process it is, and what it finds."""

    user: int
    home: str
    temporary: str
    cache: str

    def command(self, folder: Path, *words: object) -> list[str]:
        """Return what runs `words` there."""
        paths = {
            "HOME": {"writable": folder / "home", "read-only": folder / "other"}.get(self.home),
            "TMPDIR": folder / "temporary" if self.temporary == "usable" else None,
            "NUMBA_CACHE_DIR": folder / "cache" if self.cache == "set" else None,
        }
        given = {name: path for name, path in paths.items() if path}
        for path in given.values():
            path.mkdir(exist_ok=True)
            os.chown(path, self.user, self.user)
        writable = [path for path in given.values() if path.name != "other"]
        become = ["setpriv", f"--reuid={self.user}", f"--regid={self.user}", "--clear-groups"]
        clean = ["env", "-i", f"PATH={os.defpath}", *(f"{n}={path}" for n, path in given.items())]
        unshared = ["unshare", "--mount", "sh", "-c", CONFINE, "sh", *writable, "--"]
        whole = [*unshared, *become, *MAY_READ.split(), *clean, sys.executable, *words]
        return [str(word) for word in whole]

    def place(self, folder: Path) -> str:
        """Return where its kernels are kept."""
        if self.cache == "set":
            return str(folder / "cache" / "restitution")
        if self.home == "writable":
            return str(folder / "home" / ".cache" / "restitution")
        if self.temporary == "usable":
            return str(folder / "temporary" / f"restitution-{self.user}")
        return ""


MACHINES = [
    Machine(*each)
    for each in itertools.product(
        (0, 54321), ("writable", "read-only", "none"), ("usable", "none"), ("set", "none")
    )
]


def may_unshare() -> bool:
    if os.geteuid() != 0:
        return False
    trial = ["unshare", "--mount", "setpriv", "--reuid=54321", *MAY_READ.split(), "true"]
    return subprocess.run(trial, check=False, capture_output=True).returncode == 0


pytestmark = pytest.mark.skipif(
    not may_unshare(), reason="only root, who may mount, can be another user on other disks"
)


@pytest.mark.verify
@pytest.mark.parametrize(Machine._fields, MACHINES)
def test_whoever_it_is_computes_and_serves(user, home, temporary, cache, tmp_path):
    machine = Machine(user, home, temporary, cache)
    # as the home of pytest's folders is its user's alone
    for folder in (tmp_path, *tmp_path.parents[:2]):
        folder.chmod(0o755)
    done = subprocess.run(
        machine.command(tmp_path, "-c", COMPUTE),
        cwd="/tmp",  # noqa: S108 - which is read-only there
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    found, _, place = done.stdout.strip().partition(" ")
    assert (float(found), str(Path(place).parent) if place else "") == (
        0.5,
        machine.place(tmp_path),
    )
    port, log = free_port(), tmp_path / "log"
    command = machine.command(tmp_path, "-m", "restitution", "serve", "--port", port)
    with (
        log.open("wb") as output,
        subprocess.Popen(
            command,
            cwd="/tmp",  # noqa: S108 - the same
            stdout=output,
            stderr=subprocess.STDOUT,
        ) as process,
    ):
        try:
            wait_until_ready(f"http://127.0.0.1:{port}", process, log)
            asked = f"http://127.0.0.1:{port}/api/v1/collision?kappa=18&mu_over_alpha=1.4&gt_over_gn=5.6"
            with urllib.request.urlopen(asked) as answer:
                assert b'"epsilon_t":0.5,' in answer.read()
        finally:
            kill_with_children(process)
    print(*machine, "imports, computes, serves; kernels", "kept" if place else "compiled each time")
