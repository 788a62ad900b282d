"""Whatever a terminal can show: every command's help and output, in words where it has to be."""

import functools
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from cases import every_day
from restitution.cli import main
from restitution.commands.terminal import in_words

PAGES = ["cp1252", "cp850", "cp437", "ascii"]
each_page = pytest.mark.parametrize("page", every_day(["cp1252"], of=PAGES))
BALL = ["--radius", ".02", "--density", "7850", "--youngs-modulus", "2e11", "--poisson-ratio", ".3"]
COLLIDE = ["collide", *BALL, "--friction", "0.4", "--tangential-velocity", "0.5"]
TABLE = ["table", "--kappa", "3", "6", "--kappa-count", "3", "--psi", "0.1", "2", "--psi-count"]
JSON = [["openapi"], [*COLLIDE, "--normal-velocity", "1", "--json"]]
TEXTS = [
    ["--help"],
    ["--version"],
    ["nonsense"],
    *([name, "--help"] for name in main.commands),
    [*COLLIDE, "--normal-velocity", "1"],
    [*COLLIDE, "--normal-velocity", "-1"],
    # far beyond what the model holds for, with its warnings
    [*COLLIDE, "--normal-velocity", "1000"],
    *([*TABLE, "3", "--format", form] for form in ("csv", "c", "python", "json")),
    [*TABLE, "ψ"],
    ["serve", "--host", "κ.invalid"],
    ["tradeoff", "--out", "nowhere/tradeoff.json"],
]

RUN = """
import json, sys
from restitution.cli import main

for words in json.loads(sys.argv[1]):
    try:
        main(words, prog_name="restitution")
    except SystemExit as end:
        sys.stdout.flush()
        sys.stderr.flush()
        for stream in (sys.stdout, sys.stderr):
            stream.buffer.write(f"\\0{end.code}\\0".encode())
            stream.flush()
"""


@functools.cache
def outputs(encoding: str) -> list[tuple[str, ...]]:
    return run(encoding, JSON + TEXTS)


def run(encoding: str, commands: list[list[str]]) -> list[tuple[str, ...]]:
    """Return standard output, status, standard error of each command, of one process for all."""
    done = subprocess.run(
        [sys.executable, "-c", RUN, json.dumps(commands)],
        env=os.environ | {"PYTHONIOENCODING": encoding},
        check=True,
        capture_output=True,
    )
    found = [stream.decode(encoding).split("\0")[:-1] for stream in (done.stdout, done.stderr)]
    return list(zip(found[0][::2], found[0][1::2], found[1][::2], strict=True))


@each_page
def test_output_is_that_of_any_other_terminal_in_signs_or_words(page):
    for words, found, expected in zip(TEXTS, texts(page), texts("utf-8"), strict=True):
        assert "Traceback" not in found[2], (words, found[2])
        assert tuple(map(in_words, found)) == tuple(map(in_words, expected)), words
        # which stands for what has no words
        assert "".join(found).count("?") == "".join(expected).count("?"), words


def texts(encoding):
    return outputs(encoding)[len(JSON) :]


@each_page
def test_json_is_the_same_value_and_can_be_shown(page):
    for found, expected in zip(outputs(page)[:2], outputs("utf-8")[:2], strict=True):
        assert json.loads(found[0]) == json.loads(expected[0])
        assert found[0].isascii()
    assert not outputs("utf-8")[0][0].isascii()


@pytest.mark.verify
def test_signs_that_a_page_has_are_kept():
    describe, count = ["table", "--help"], [*TABLE, "3", "--format", "csv"]
    assert "Write ε_t over κ and ψ" in run("utf-8", [describe])[0][0]
    assert "Write ε_t over kappa and psi" in run("cp437", [describe])[0][0]
    assert "3 × 3 entries" in run("cp850", [count])[0][2]
    described, counted = run("ascii", [describe, count])
    assert "Write epsilon_t over kappa and psi" in described[0]
    assert "3 x 3 entries" in counted[2]


def test_every_sign_of_the_program_has_words():
    sources = Path(sys.modules["restitution"].__file__).parent.rglob("*.py")
    signs = set("".join(path.read_text("utf-8") for path in sources))
    assert not {sign for sign in signs if "?" in in_words(sign) and sign != "?"}
