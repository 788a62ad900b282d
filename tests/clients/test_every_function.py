"""The script of a user: complete, run as it stands, and told by docstrings how it goes."""

import ast
import inspect
import re
import subprocess
import sys
import webbrowser
from importlib.resources import files
from pathlib import Path

import every_function
import pytest

import restitution

SCRIPT = Path(every_function.__file__)
DATA = {"MATERIALS", "PRESETS"}
MADE = sorted(set(restitution.__all__) - DATA)


def test_script_uses_every_public_name():
    used = {
        node.attr
        for node in ast.walk(ast.parse(SCRIPT.read_text()))
        if isinstance(node, ast.Attribute) and ast.unparse(node.value) == "rs"
    }
    assert used == set(restitution.__all__)


def test_every_public_name_is_in_all_and_no_other():
    public = {
        name
        for name, value in vars(restitution).items()
        if not name.startswith("_") and not inspect.ismodule(value)
    }
    assert public == set(restitution.__all__)


@pytest.mark.parametrize("part", ["scaled", "real", "reports", "refused"])
def test_script_runs(part):
    getattr(every_function, part)()


def test_script_opens_the_page(monkeypatch):
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    every_function.shown("http://there:1")
    assert len(opened) == 1


def test_types_of_the_package_are_there_for_a_user():
    assert files("restitution").joinpath("py.typed").is_file()


@pytest.mark.verify
def test_checker_finds_a_wrong_use_in_a_script(tmp_path):
    """What `make check` says of the script itself would mean nothing if all were Any."""
    wrong = SCRIPT.read_text().replace("curve: npt.NDArray[np.float64]", "curve: str", 1)
    wrong = wrong.replace("measured: rs.Measurement", "measured: rs.StepsStudy", 1)
    script = tmp_path / "script.py"
    script.write_text(wrong)
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--no-incremental", script],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
    )
    lines = wrong.splitlines()
    found = [int(line) for line in re.findall(r"script.py:(\d+): error", done.stdout)]
    marked = [
        n for n in sorted(set(found)) if re.search(r"curve: str|rs\.StepsStudy =", lines[n - 1])
    ]
    assert len(marked) == 2, done.stdout


@pytest.mark.parametrize("name", MADE)
def test_docstring_has_an_example(name):
    assert re.search(r"^\s*>>> ", inspect.getdoc(getattr(restitution, name)) or "", re.MULTILINE)


FUNCTIONS = [name for name in MADE if inspect.isfunction(getattr(restitution, name))]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_docstring_says_what_is_taken_returned_and_refused(name):
    function = getattr(restitution, name)
    text = inspect.getdoc(function)
    assert text.startswith("Return ")
    parameters = inspect.signature(function).parameters
    said = text.partition("Parameters\n----------\n")[2].partition("\n\n")[0]
    # every name stands before the colon of a line, alone or with others
    named = re.findall(r"\w+", " ".join(re.findall(r"^(\S.*?)(?: :|$)", said, re.MULTILINE)))
    assert set(parameters) <= set(named)
    headings = {"Returns", "Raises"} if parameters else {"Returns"}
    assert headings <= set(re.findall(r"^(\w+)\n-{3,}$", text, re.MULTILINE))
