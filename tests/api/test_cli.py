"""The command line: one impact in SI units, tables for other codes."""

import csv
import io
import json

import pytest
from click.testing import CliRunner

from restitution.cli import main

STEEL = [
    "--radius", "0.02", "--density", "7850", "--youngs-modulus", "2.1e11",
    "--poisson-ratio", "0.3", "--friction", "0.4",
]  # fmt: skip
SPHERE = {
    "radius_m": 0.02,
    "density_kg_m3": 7850,
    "youngs_modulus_pa": 2.1e11,
    "poisson_ratio": 0.3,
}
BODY = {
    "body_1": SPHERE,
    "body_2": {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25},
    "friction_coefficient": 0.4,
    "tangential_stiffness_n_per_m": "mindlin",
    "impact": {"velocity_1_m_s": [1, 0, -2], "velocity_2_m_s": [0, 0, 0], "normal": [0, 0, 1]},
}


def run(*arguments, given=None):
    done = CliRunner().invoke(main, list(arguments), input=given)
    assert done.exception is None or isinstance(done.exception, SystemExit), done.exception
    return done


def test_collide_of_options_is_figure_2():
    velocities = ["--normal-velocity", "20", "--tangential-velocity", "5", "--stiffness", "1e12"]
    done = run("collide", *STEEL, *velocities, "--json")
    study = json.loads(done.stdout)
    assert round(study["kappa"]) == 11225
    assert study["after"] is None


def test_collide_reads_what_the_service_reads(service, tmp_path):
    file = tmp_path / "impact.json"
    file.write_text(json.dumps(BODY))
    answer = service.read(service.post(BODY, path="/scaling"))
    assert json.loads(run("collide", str(file), "--json").stdout) == answer
    assert json.loads(run("collide", "-", "--json", given=json.dumps(BODY)).stdout) == answer


def test_collide_prints_lines_with_numbers_convention_and_motion():
    done = run("collide", "-", given=json.dumps(BODY))
    for word in ("epsilon_t", "kappa", "velocity_1_m_s", "spin_2_rad_s", "+1 smooth spheres"):
        assert word in done.stdout


def test_collide_on_a_wall_has_twice_the_effective_mass():
    single = ["--normal-velocity", "1", "--json"]
    pair = json.loads(run("collide", *STEEL, *single).stdout)
    wall = json.loads(run("collide", *STEEL, *single, "--wall").stdout)
    assert wall["effective_mass_kg"] == pytest.approx(2 * pair["effective_mass_kg"])


@pytest.mark.parametrize(
    ("arguments", "given", "words"),
    [
        ([], None, "--radius"),
        (["-"], "{", "not JSON"),
        (["-"], "[]", "JSON object"),
        (["-"], '{"body_1": {"radius_m": 0}}', "body_1.radius_m must be finite and > 0, got 0"),
        (["-"], json.dumps(BODY | {"impact": {**BODY["impact"], "velocity_1_m_s": [0, 0, 1]}}),
         "approach"),
        ([*STEEL, "--normal-velocity", "-1"], None, "impact.normal_velocity_m_s"),
        ([*STEEL, "--normal-velocity", "nan"], None, "impact.normal_velocity_m_s"),
        (["nowhere.json"], None, "nowhere.json"),
    ],
)  # fmt: skip
def test_collide_refuses_in_words(arguments, given, words):
    done = run("collide", *arguments, given=given)
    assert done.exit_code != 0
    assert words in done.stderr
    assert "Traceback" not in done.output


def test_table_is_that_of_the_service(service):
    small = {"kappa_min": 3, "kappa_max": 6, "kappa_count": 5, "psi_min": 0.1, "psi_max": 2}
    answer = service.get("/table", **small, psi_count=4, format="c")
    kappa = ["--kappa", "3", "6", "--kappa-count", "5"]
    psi = ["--psi", "0.1", "2", "--psi-count", "4"]
    done = run("table", *kappa, *psi, "--format", "c")
    assert done.stdout == answer.text
    assert "5 × 4 entries, error at most" in done.stderr


def test_table_takes_a_normal_restitution(service):
    small = {"kappa_count": "3", "psi_count": "2", "normal_restitution": "0.9"}
    words = [
        word for name, value in small.items() for word in (f"--{name.replace('_', '-')}", value)
    ]
    assert (
        run("table", *words, "--format", "c").stdout
        == service.get("/table", **small, format="c").text
    )


def test_table_goes_to_a_file(tmp_path):
    file = tmp_path / "table.csv"
    run("table", "--kappa", "3", "6", "--psi", "0.1", "2", "--error", "0.05", "--out", str(file))
    row = next(csv.DictReader(io.StringIO(file.read_text())))
    assert float(row["largest_error"]) <= 0.05


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--error", "0.1", "--kappa-count", "5"], "left out, as `error` is given"),
        (["--kappa", "6", "3"], "kappa_max must be greater"),
        (["--psi", "0", "1", "--psi-scale", "log"], "psi_min must be > 0"),
        (["--error", "1e-9", "--seconds", "0.2"], "s of one core"),
        (["--error", "0"], "error"),
        (["--damping", "0", "1", "--normal-restitution", "0.9"], "as damping_max is given"),
        (["--kappa", "nan", "3"], "kappa"),
        (["--seconds", "nan"], "must be finite and > 0, got nan"),
        (["--seconds", "0"], "must be finite and > 0, got 0"),
    ],
)
def test_table_refuses_in_words(arguments, words):
    done = run("table", *arguments)
    assert done.exit_code != 0
    assert words in done.stderr
    assert "Traceback" not in done.output
