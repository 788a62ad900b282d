"""One way down the house: api → wire → studies → methods → mechanics; panels → figures, state."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
BACKEND = ROOT / "backend" / "restitution"
FRONTEND = ROOT / "frontend"

NUMBERS = {"mechanics", "errors", "interruption"}
STUDIES = {"studies", "methods", "bounds", "quantities"} | NUMBERS
MAY_IMPORT = {
    "mechanics": NUMBERS,
    "methods": {"methods", "bounds", "quantities"} | NUMBERS,
    "studies": STUDIES,
    "paper": {"paper"} | STUDIES,
    "export": {"export"} | STUDIES,
    "wire": {"wire", "export", "paper"} | STUDIES,
    "api": {"api", "wire", "paper"} | STUDIES,
    "public": {"public", "api", "paper"} | STUDIES,
}

LIBRARIES_OF_MECHANICS = {"numpy", "scipy", "numba"}

MODULES_MAY_IMPORT = {
    "figures": {"figures", "format"},
    "format": {"format"},
    "state": {"state", "api", "format"},
    "api": {"api"},
    "panels": {"panels", "figures", "state", "format", "api"},
}

FROM = re.compile(r"^(?:import|export)[^;]*? from [\"']([^\"']+)", re.MULTILINE)


def imports(source: Path) -> set[str]:
    names = set()
    for node in ast.walk(ast.parse(source.read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module or "")
    return names


@pytest.mark.parametrize("room", MAY_IMPORT)
def test_rooms_of_the_backend_only_look_down(room):
    for source in (BACKEND / room).rglob("*.py"):
        own = {name.split(".")[1] for name in imports(source) if name.startswith("restitution.")}
        assert own <= MAY_IMPORT[room], source


def test_mechanics_knows_nothing_but_numbers():
    import sys  # noqa: PLC0415 - only this test asks for the standard library's names

    for source in (BACKEND / "mechanics").rglob("*.py"):
        roots = {name.split(".")[0] for name in imports(source)} - {"restitution"}
        assert roots - sys.stdlib_module_names <= LIBRARIES_OF_MECHANICS, source


def test_only_what_serves_knows_http():
    for room in MAY_IMPORT.keys() - {"api"}:
        for source in (BACKEND / room).rglob("*.py"):
            roots = {name.split(".")[0] for name in imports(source)}
            assert not roots & {"fastapi", "starlette", "uvicorn"}, source


def test_only_the_border_reads_with_pydantic():
    for room in ("mechanics", "methods", "studies", "paper", "export"):
        for source in (BACKEND / room).rglob("*.py"):
            roots = {name.split(".")[0] for name in imports(source)}
            assert not roots & {"pydantic", "pydantic_core"}, source


def test_backend_describes_no_plot():
    for source in BACKEND.rglob("*.py"):
        assert "plotly.graph_objects" not in imports(source), source


@pytest.mark.parametrize("room", MODULES_MAY_IMPORT)
def test_rooms_of_the_frontend_only_look_down(room):
    for source in (FRONTEND / room).rglob("*.js"):
        for target in FROM.findall(source.read_text()):
            assert target.startswith("."), f"{source} imports {target} from elsewhere"
            other = (source.parent / target).resolve().relative_to(FRONTEND).parts[0]
            assert other in MODULES_MAY_IMPORT[room], f"{source} imports {target}"


def test_only_the_client_fetches():
    for source in FRONTEND.rglob("*.js"):
        if source.relative_to(FRONTEND).as_posix() != "api/client.js":
            assert not re.search(r"\bfetch\(|XMLHttpRequest|sendBeacon", source.read_text()), source


def test_only_panels_touch_the_page():
    for room in ("figures", "format"):
        for source in (FRONTEND / room).rglob("*.js"):
            assert not re.search(r"\bdocument\.|\bwindow\.|\bPlotly\.", source.read_text()), source


def test_the_page_loads_nothing_from_elsewhere():
    for source in [*FRONTEND.rglob("*.js"), *FRONTEND.rglob("*.css"), *FRONTEND.rglob("*.html")]:
        found = re.findall(r"https?://[^\s\"')]+", source.read_text())
        allowed = ("http://www.w3.org/", "https://doi.org/")
        assert all(url.startswith(allowed) for url in found), (source, found)
