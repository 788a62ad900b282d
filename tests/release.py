"""A rehearsed release, and the numbers at the oldest versions: `make release-check`, `make lowest`.

Each line says what holds, what does not, and what was not looked at. Packages come from a registry.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import urllib.request
from hashlib import sha256
from pathlib import Path
from zipfile import ZipFile

from packaging.metadata import Metadata

from servers import free_port, kill_with_children, wait_until_ready

ROOT = Path(__file__).parents[1]
UV = Path(sys.executable).with_name("uv")
OLDEST = (3, 11)
NEWEST = (3, 14)
"""Pythons that there are; which of them the machine has is looked up."""

BALL = "--radius .02 --density 7850 --youngs-modulus 2.1e11 --poisson-ratio .3 --friction .4"
COLLIDE = f"collide {BALL} --normal-velocity 1 --tangential-velocity .5".split()
TABLE = ["table", "--kappa", "3", "6", "--kappa-count", "5", "--psi", ".1", "2"]
TABLE += ["--psi-count", "4"]

IMPORT = """
import json, sys, time
begin = time.process_time()
import restitution
print(json.dumps([time.process_time() - begin, len(sys.modules), restitution.__version__]))
"""

EXPLORE = """
import urllib.request, restitution
page = restitution.explore(kappa=63)
assert b"<title>" in urllib.request.urlopen(page.url).read()
"""

NUMERICS = ["tests/mechanics", "tests/methods", "tests/studies", "tests/validation"]
TOOLS = ["hypothesis", "mpmath", "psutil", "pytest", "pytest-timeout", "pytest-xdist", "pyyaml"]
TOOLS += ["python-flint"]

failed = []


def check(holds: bool, what: str) -> bool:
    """Print what must hold, and whether it does."""
    print(f"{'ok' if holds else 'FAILED':10}{what}", flush=True)
    failed.extend([] if holds else [what])
    return holds


def unchecked(what: str) -> None:
    print(f"{'unchecked':10}{what}", flush=True)


def run(*words: object, **more) -> subprocess.CompletedProcess[str]:
    """Run a command far from the checkout, without what this environment has."""
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run(
        [str(word) for word in words],
        check=False,
        capture_output=True,
        text=True,
        **({"cwd": "/", "env": clean} | more),
    )


def build(folder: Path) -> Path:
    """Build source archive and wheel, the latter from the former, and look at them."""
    sums = []
    for name in ("first", "second"):
        done = run(UV, "build", "--quiet", "--out-dir", folder / name, ROOT)
        if not check(done.returncode == 0, f"built {done.stderr[-500:]}".strip()):
            sys.exit(1)
        files = [path for path in (folder / name).iterdir() if path.name != ".gitignore"]
        sums.append({path.name: sha256(path.read_bytes()).hexdigest() for path in files})
    check(sums[0] == sums[1], f"built again with the same bytes: {', '.join(sums[0])}")
    (wheel,) = (folder / "first").glob("*.whl")
    with ZipFile(wheel) as archive:
        (name,) = (each for each in archive.namelist() if each.endswith(".dist-info/METADATA"))
        found = Metadata.from_email(archive.read(name), validate=True)
    check(f"restitution-{found.version}-" in wheel.name, f"metadata are valid, {found.version}")
    return wheel


def pythons() -> dict[tuple[int, int], str]:
    """Return an interpreter of each version that is here, on the path or among pyenv's."""
    root = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    places = [os.environ["PATH"], *map(str, sorted(root.glob("versions/*/bin")))]
    environment = os.environ | {"PATH": os.pathsep.join(places)}
    listing = [UV, "python", "list", "--only-installed", "--output-format", "json"]
    done = run(*listing, env=environment)
    found: dict[tuple[int, int], str] = {}
    for each in json.loads(done.stdout):
        version = each["version_parts"]["major"], each["version_parts"]["minor"]
        if each["implementation"] == "cpython" and version >= OLDEST:
            found.setdefault(version, each["path"])
    return found


def size_of(folder: Path) -> int:
    return sum(path.lstat().st_size for path in folder.rglob("*"))


def try_with(python: str, name: str, wheel: Path, folder: Path) -> None:
    """Install the wheel in a fresh environment and use all of it."""
    run(UV, "venv", "--quiet", "--python", python, folder)
    # with byte code, as pip installs
    options = ["--quiet", "--compile-bytecode", "--python", folder / "bin" / "python"]
    installed = run(UV, "pip", "install", *options, wheel)
    if not check(installed.returncode == 0, f"{name}: installed {installed.stderr[-500:]}".strip()):
        return
    print(f"{'':10}{size_of(folder) / 1e6:.0f} MB of environment", flush=True)
    own = {"env": os.environ | {"NUMBA_CACHE_DIR": str(folder / "cache"), "BROWSER": "true"}}
    own["env"].pop("PYTHONPATH", None)
    program = [folder / "bin" / "restitution"]
    seconds, modules, version = json.loads(run(folder / "bin" / "python", "-c", IMPORT).stdout)
    check(seconds <= 0.5, f"{name}: import takes {seconds:.2f} s of CPU, {modules} modules")
    done = run(*program, "--version")
    check(done.stdout == f"restitution {version}\n", f"{name}: {done.stdout.strip()}")
    done = run(*program, *COLLIDE, **own)
    check("epsilon_t" in done.stdout, f"{name}: collide: {done.stdout.partition(chr(10))[0]}")
    first = [line for line in done.stderr.splitlines() if "kernels are compiled" in line]
    check(len(first) == 1, f"{name}: the first use tells that it compiles")
    done = run(*program, *TABLE, **own)
    check(done.stdout.startswith("kappa,psi"), f"{name}: table: {done.stderr.splitlines()[-1]}")
    done = run(folder / "bin" / "python", "-c", EXPLORE, **own)
    check(done.returncode == 0, f"{name}: explore shows the page {done.stderr[-300:]}".strip())
    served(program, name, folder, own["env"])


def served(program: list[Path], name: str, folder: Path, environment: dict[str, str]) -> None:
    port, log = free_port(), folder / "log"
    with (
        log.open("wb") as output,
        subprocess.Popen(
            [*program, "serve", "--port", str(port)],
            cwd="/",
            env=environment,
            stdout=output,
            stderr=output,
        ) as process,
    ):
        try:
            wait_until_ready(f"http://127.0.0.1:{port}", process, log)
            for path in ("/", "/docs", "/redoc", "/guide/", "/assets/plotly.min.js"):
                with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}") as answer:
                    check(answer.status == 200, f"{name}: serves {path}")
        finally:
            kill_with_children(process)


def release() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        wheel = build(folder)
        found = pythons()
        for version, python in sorted(found.items()):
            try_with(python, "Python {}.{}".format(*version), wheel, folder / "environment")
            shutil.rmtree(folder / "environment")
        for minor in range(OLDEST[1], NEWEST[1] + 1):
            if (3, minor) not in found:
                unchecked(f"Python 3.{minor}: there is none here")
    done = subprocess.run([sys.executable, ROOT / "deploy" / "verify"], check=False)
    # it says itself that it found nothing to build with
    check(done.returncode in (0, 2), "the image, as far as its own lines say")


def lowest() -> None:
    """Run the tests of the numbers with the oldest versions that pyproject.toml allows."""
    with tempfile.TemporaryDirectory() as name:
        python = Path(name, "bin", "python")
        run(UV, "venv", "--quiet", "--python", sys.executable, name)
        install = [UV, "pip", "install", "--quiet", "--python", python]
        done = run(*install, "--resolution", "lowest-direct", f"{ROOT}[notebook]")
        locked = (ROOT / "requirements-dev.lock").read_text().splitlines()
        tools = [line.rstrip(" \\") for line in locked if line.partition("==")[0] in TOOLS]
        # what old test clients of Starlette take
        more = run(*install, *tools, "httpx")
        if not check(done.returncode == more.returncode == 0, done.stderr + more.stderr or "there"):
            return
        print(run(UV, "pip", "list", "--python", python).stdout)
        # old AnyIO's plugin uses what pytest warns of; a link is read by Node, which is not there
        options = ["-q", "-n", "2", "-p", "no:anyio", "-p", "no:cacheprovider"]
        options += ["-m", "not browser and not verify", "-k", "not every_link"]
        done = subprocess.run(
            [python, "-m", "pytest", *options, *NUMERICS],
            cwd=ROOT,
            env=os.environ | {"PYTHONPATH": str(ROOT / "backend")},
            check=False,
        )
        check(done.returncode == 0, "the numerics' tests at the lowest versions")


if __name__ == "__main__":
    {"release": release, "lowest": lowest}[sys.argv[1]]()
    print("fell short:" if failed else "nothing fell short", *failed, sep="\n  ")
    sys.exit(bool(failed))
