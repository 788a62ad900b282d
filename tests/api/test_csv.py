"""CSV where it is opened: separators, decimal marks, units, and no cell that is a formula."""

import csv
import io
import re
import shlex
import subprocess
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from document import ALWAYS_ON, OPERATIONS, body_of, parameters_of, query_of

from cases import every_day
from restitution.cli import main
from restitution.wire.formats import CsvOptions, csv_blocks

pytestmark = pytest.mark.usefixtures("few_steps")

DOCUMENT = Path(__file__).parents[2].joinpath("docs", "csv.md").read_text()
WITH_CSV = [
    name
    for name in ALWAYS_ON
    if "csv" in parameters_of(name).get("format", {"schema": {}})["schema"].get("enum", [])
]
SIGNS = {"comma": ",", "semicolon": ";", "tab": "\t"}
EVERY_WRITING = [
    ("semicolon", "point"), ("tab", "point"), ("semicolon", "comma"), ("tab", "comma"),
]  # fmt: skip
EVERYTHING = {
    "cut": "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote,error,largest_switches",
    "map": "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote,error",
}

every_call = pytest.mark.parametrize("name", WITH_CSV)


def ask(service, name, **more):
    method, path, _ = OPERATIONS[name]
    query = query_of(name) | {"format": "csv"} | more
    if name in EVERYTHING:
        query["quantities"] = EVERYTHING[name]
    return service.client.request(method, path, params=query, json=body_of(name))


def rows(text, separator=","):
    return list(csv.reader(io.StringIO(text, newline=""), delimiter=separator))


def is_number(text, name=None):
    """Return whether a cell is a number; what the paper says are words, a section like 4.2, too."""
    return name != "paper" and bool(re.fullmatch(r"-?\d+(\.\d+)?(e[+-]?\d+)?", text))


def test_csv_is_answered_by_every_call_with_columns():
    assert {"collision", "trace", "cut", "map", "collisions", "scaling", "velocity_map", "table",
            "tradeoff", "steps", "paper"} <= set(WITH_CSV)  # fmt: skip


@every_call
@pytest.mark.parametrize(
    ("separator", "decimal"), every_day([("semicolon", "comma")], of=EVERY_WRITING)
)
def test_every_writing_has_the_same_cells(service, name, separator, decimal):
    plain = rows(ask(service, name).text)
    written = rows(ask(service, name, separator=separator, decimal=decimal).text, SIGNS[separator])
    assert written[0] == plain[0]
    for row, others in zip(plain, written, strict=True):
        for cell, other in zip(row, others, strict=True):
            has_mark = is_number(cell, name) and decimal == "comma"
            expected = cell.replace(".", ",") if has_mark else cell
            assert other == expected


@every_call
@pytest.mark.parametrize("given", [{}, {"separator": "comma"}], ids=str)
def test_a_comma_is_not_separator_and_decimal_mark_at_once(service, name, given):
    response = ask(service, name, decimal="comma", **given)
    (entry,) = service.problem(response, 422)["errors"]
    assert entry == {
        "parameter": "separator",
        "value": given.get("separator"),
        "requirement": "semicolon or tab where `decimal` is comma",
    }


@every_call
def test_a_line_says_unit_of_each_column_and_the_convention(service, name):
    text = ask(service, name, header="units").text
    first, names, *rest = rows(text)
    assert first[0].startswith("# ")
    assert [names, *rest] == rows(ask(service, name).text)
    units = dict(zip(names, [first[0][2:], *first[1:-1]], strict=True))
    for column, cells in zip(names, zip(*rest, strict=True), strict=True):
        there = [cell for cell in cells if cell]
        is_numeric = all(is_number(cell, name) for cell in there)
        assert bool(units[column]) is is_numeric or not there, column
    assert first[-1].startswith("epsilon_t = ")


@pytest.mark.parametrize(
    ("name", "column", "unit"),
    [
        ("trace", "time", "t_scale"),
        ("trace", "tangential_velocity", "g_n"),
        ("collision", "contact_duration", "t_scale"),
        ("collision", "energy.final", "α m_eff g_n²"),
        ("collision", "energy.dissipated_share", "1"),
        ("collision", "summary", ""),
        ("scaling", "maximum_normal_force_n", "N"),
        ("scaling", "after.spin_1_rad_s.z", "rad/s"),
        ("tradeoff", "microseconds_per_collision", "µs"),
    ],
)
def test_units_are_those_of_the_quantities(service, name, column, unit):
    first, names, *_ = rows(ask(service, name, header="units").text)
    assert first[names.index(column)].removeprefix("# ") == unit


def test_the_convention_of_a_table_is_that_of_its_sign(service):
    small = {"kappa_count": 3, "psi_count": 3, "header": "units"}
    for sign, words in (("paper", "+1 smooth spheres"), ("reversed", "-1 smooth spheres")):
        assert words in rows(service.get("/table", **small, sign=sign).text)[0][-1]


DANGEROUS = ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\r=1", "−1", "＝1+1", "＋1", "－1", "＠A1"]


@pytest.mark.parametrize("text", DANGEROUS)
@pytest.mark.parametrize("kind", [list, np.array])
def test_a_text_that_begins_as_a_formula_is_no_formula(text, kind):
    table = {"words": kind([text, "a" + text]), "number": np.array([-1.5, 2.0])}
    found = rows(b"".join(csv_blocks(table, CsvOptions())).decode())
    assert found == [["words", "number"], ["'" + text, "-1.5"], ["a" + text, "2.0"]]


@every_call
def test_no_cell_is_a_formula(service, name):
    for header in ("names", "units"):
        for row in rows(ask(service, name, header=header).text):
            for cell in row:
                assert is_number(cell) or not re.match(r"[=+\-@\t\r−]", cell), cell


@pytest.mark.parametrize("text", ["a;b", 'a"b', "a\nb", "a\rb", "a\tb", "a,b"])
@pytest.mark.parametrize("separator", SIGNS)
def test_any_text_is_read_back(text, separator):
    written = b"".join(csv_blocks({"words": [text], "n": [1]}, CsvOptions(separator=separator)))
    assert rows(written.decode(), SIGNS[separator]) == [["words", "n"], [text, "1"]]


def test_options_of_csv_change_no_other_form_and_are_not_echoed(service):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
    options = {"separator": "tab", "decimal": "comma", "header": "units"}
    assert service.answer("/collision", **collision, **options) == service.answer(
        "/collision", **collision
    )


def test_the_command_writes_what_the_service_answers(service):
    small = {"kappa_min": 3, "kappa_max": 6, "kappa_count": 3, "psi_count": 3}
    options = {"separator": "semicolon", "decimal": "comma", "header": "units"}
    words = ["--kappa", "3", "6", "--kappa-count", "3", "--psi-count", "3"]
    words += [word for name, value in options.items() for word in (f"--{name}", value)]
    done = CliRunner().invoke(main, ["table", *words])
    assert done.stdout == service.get("/table", **small, **options).text
    assert ";0,0" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--decimal", "comma"], "semicolon or tab where `decimal` is comma"),
        (["--separator", "tab", "--store", "table.zarr"], "--separator is of no use with --store"),
    ],
)
def test_the_command_refuses_in_words(arguments, words):
    done = CliRunner().invoke(main, ["table", *arguments])
    assert done.exit_code != 0
    assert words in done.stderr


def test_examples_for_pandas_run_as_they_stand(server):
    (example,) = re.findall(r"```python\n(.*?)```", DOCUMENT, re.DOTALL)
    names: dict = {}
    exec(example.replace("http://127.0.0.1:8000", server), names)  # noqa: S102 - the example is ours
    assert len(names["plain"]) == 408


def test_commands_of_the_document_run_as_they_stand(server, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    curl, table = re.findall(r"^    (curl .*|restitution .*)$", DOCUMENT, re.MULTILINE)
    words = shlex.split(curl.replace("http://127.0.0.1:8000", server))
    answer = subprocess.run([*words, "--silent", "--fail"], capture_output=True, check=True)
    assert answer.stdout.decode().startswith("# t_scale;ξ_scale;")
    assert CliRunner().invoke(main, shlex.split(table)[1:]).exit_code == 0
    assert (tmp_path / "table.csv").read_text().startswith("# 1;1;1;1;;epsilon_t = ")
