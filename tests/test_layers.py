"""One way down the house: api → wire → studies → methods → mechanics.

That of the page is held by tests/frontend/layers.test.js.
"""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
BACKEND = ROOT / "backend" / "restitution"

NUMBERS = {"mechanics", "errors", "interruption"}
STUDIES = {"studies", "methods", "bounds", "neighbours", "quantities"} | NUMBERS
MAY_IMPORT = {
    "mechanics": NUMBERS,
    "methods": {"methods", "bounds", "quantities"} | NUMBERS,
    "studies": STUDIES,
    "paper": {"paper"} | STUDIES,
    "export": {"export"} | STUDIES,
    "wire": {"wire", "export", "paper"} | STUDIES,
    "api": {"api", "wire", "paper"} | STUDIES,
    "commands": {"commands", "wire"} | STUDIES,
    "public": {"public", "api", "paper"} | STUDIES,
}

LIBRARIES_OF_MECHANICS = {"numpy", "scipy", "numba"}


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


def test_no_module_and_no_room_is_more_than_one_takes_in():
    for source in BACKEND.rglob("*.py"):
        assert len(source.read_text().splitlines()) <= 400, source
    for room in [BACKEND, *BACKEND.rglob("*/")]:
        entries = [each for each in room.iterdir() if each.name != "__pycache__"]
        assert len(entries) <= 20, room
