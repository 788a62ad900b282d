"""The command line: one impact in SI units, tables for other codes."""

import csv
import io
import json

import pytest
from click.testing import CliRunner

from restitution.bounds import annotations
from restitution.cli import main
from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import TOLD_BY
from restitution.wire.impact_options import OPTIONS
from steel import PAIR, SPHERE
from steel import TOLD as STEEL

BODY = {
    **PAIR,
    "body_2": {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25},
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


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
def test_collide_reads_what_an_editor_wrote(encoding, tmp_path):
    file = tmp_path / "impact.json"
    file.write_text(json.dumps(BODY), encoding=encoding)
    assert "epsilon_t" in run("collide", str(file)).stdout
    assert "epsilon_t" in run("collide", "-", given=file.read_bytes()).stdout


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_collide_names_an_encoding_that_it_does_not_read(encoding, tmp_path):
    file = tmp_path / "impact.json"
    file.write_text(json.dumps(BODY), encoding=encoding)
    done = run("collide", str(file))
    assert (done.exit_code, done.stdout) == (1, "")
    assert f"must be JSON in UTF-8, this is {encoding.upper()}" in done.stderr


def test_collide_prints_lines_with_numbers_convention_and_motion():
    done = run("collide", "-", given=json.dumps(BODY))
    for word in ("epsilon_t", "kappa", "velocity_1_m_s", "spin_2_rad_s", "+1 smooth spheres"):
        assert word in done.stdout


def test_collide_on_a_wall_has_twice_the_effective_mass():
    single = ["--normal-velocity", "1", "--json"]
    pair = json.loads(run("collide", *STEEL, *single).stdout)
    wall = json.loads(run("collide", *STEEL, *single, "--wall").stdout)
    assert wall["effective_mass_kg"] == pytest.approx(2 * pair["effective_mass_kg"])


IMPACT = ["--normal-velocity", "1", "--tangential-velocity", "0.5"]


def body_of(*arguments, given=None):
    """What a command asks for, as its answer: that of the same body to the service."""
    return json.loads(run("collide", *arguments, "--json", given=given).stdout)


OTHER = {"radius_m": 0.01, "mass_kg": 0.05, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25}
EVERYTHING = [
    (["--normal-restitution", "0.9"], {"normal_restitution": 0.9}),
    (["--normal-restitution", "0.9", "--at-normal-velocity", "2"],
     {"normal_restitution": 0.9, "at_normal_velocity_m_s": 2}),
    (["--dissipative-constant", "1e-6"], {"dissipative_constant_s": 1e-6}),
    (["--inertia", "hollow"], {"body_1": SPHERE | {"inertia": "hollow"},
                               "body_2": SPHERE | {"inertia": "hollow"}}),
    (["--moment", "3e-5", "--yield-stress", "1e9"],
     {f"body_{i}": SPHERE | {"inertia": {"moment_kg_m2": 3e-5}, "yield_stress_pa": 1e9}
      for i in (1, 2)}),
    (["--radius-2", "0.01", "--mass-2", "0.05", "--youngs-modulus-2", "7e10",
      "--poisson-ratio-2", "0.25"], {"body_2": OTHER}),
    (["--wall", "--youngs-modulus-2", "7e10", "--poisson-ratio-2", "0.25"],
     {"body_2": {"wall": True, "youngs_modulus_pa": 7e10, "poisson_ratio": 0.25}}),
    (["--stiffness", "1e8"], {"tangential_stiffness_n_per_m": 1e8}),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "change"), EVERYTHING)
def test_collide_takes_by_options_all_that_the_service_takes(service, arguments, change):
    answer = service.read(service.post(PAIR | change, path="/scaling"))
    assert body_of(*STEEL, *IMPACT, *arguments) == answer


@pytest.mark.parametrize(
    ("arguments", "impact"),
    [
        (["--speed", "3.9", "--angle", "30"], {"speed_m_s": 3.9, "angle_deg": 30}),
        (["--velocity-1", "1", "0", "-2", "--velocity-2", "0", "-.5", "0", "--normal", "0", "0",
          "2", "--spin-1", "3", "-2", "1", "--spin-2", "0", "0", "1e1"],
         {"velocity_1_m_s": [1, 0, -2], "velocity_2_m_s": [0, -0.5, 0], "normal": [0, 0, 2],
          "spin_1_rad_s": [3, -2, 1], "spin_2_rad_s": [0, 0, 10]}),
    ],
)  # fmt: skip
def test_collide_takes_impacts_of_every_kind_also_over_a_file(service, arguments, impact):
    equal = BODY | {"body_2": SPHERE, "impact": impact}
    answer = service.read(service.post(equal, path="/scaling"))
    assert body_of(*STEEL, *arguments) == answer
    file = equal | {"impact": {"normal_velocity_m_s": 1, "tangential_velocity_m_s": 0}}
    assert body_of("-", *arguments, given=json.dumps(file)) == answer


def test_collide_takes_options_in_place_of_what_a_file_has(service):
    file = BODY | {"dissipative_constant_s": 1e-6}
    other = SPHERE | {"mass_kg": 0.3}
    del other["density_kg_m3"]
    body = BODY | {"body_1": other, "normal_restitution": 0.9, "friction_coefficient": 0.2}
    answer = service.read(service.post(body, path="/scaling"))
    options = ["--mass", "0.3", "--normal-restitution", "0.9", "--friction", "0.2"]
    assert body_of("-", *options, given=json.dumps(file)) == answer


def test_collide_has_an_option_for_every_member_of_a_body():
    members = {
        *(f"body_{i}.{member}" for i in (1, 2) for member in annotations(Sphere)),
        *(member for member in annotations(Contact)),
        *(f"impact.{member}" for kind in TOLD_BY for member in annotations(kind)),
    }
    told = {".".join(option.path) for option in OPTIONS}
    assert members - told == {"body_1", "body_2", "body_1.wall", "body_2.wall"}
    assert len({option.name for option in OPTIONS}) == len(OPTIONS)


REFUSED = [
    (["--radius", "2 cm"], {"body_1": SPHERE | {"radius_m": "2 cm"}}),
    (["--friction", "-1", "--wall"], {"friction_coefficient": -1.0}),
    (["--normal-restitution", "0.9", "--dissipative-constant", "0"],
     {"normal_restitution": 0.9, "dissipative_constant_s": 0.0}),
    (["--speed", "1", "--angle", "90"], {"impact": {"speed_m_s": 1.0, "angle_deg": 90.0}}),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "change"), REFUSED)
def test_collide_refuses_in_the_words_of_the_service(service, arguments, change):
    detail = service.problem(service.post(BODY | change, path="/scaling"), 422)["detail"]
    for option in (option for option in OPTIONS if option.name in arguments):
        detail = detail.replace(".".join(option.path), option.name)
    done = run("collide", "-", *arguments, given=json.dumps(BODY))
    assert done.exit_code != 0
    assert done.stderr.removeprefix("Error: ").strip().split("\n") == detail.split("; ")


def test_walton_prints_the_smallest_kappa_and_says_that_there_are_others():
    done = run("walton", "1")
    assert "0.95303" in done.stdout
    assert "others have it as well" in done.stdout
    assert run("walton", "-0.4").stdout.startswith("kappa      0.1297")
    assert "beta_0 must be from -1 to 1, got 2.0" in run("walton", "2").stderr


@pytest.mark.parametrize(
    ("arguments", "given", "words"),
    [
        ([], None, "--radius"),
        (["-"], "{", "not JSON"),
        (["-"], "[]", "JSON object"),
        (["-"], '{"body_1": {"radius_m": 0}}', "body_1.radius_m must be finite and > 0, got 0"),
        (["-"], json.dumps(BODY | {"impact": {**BODY["impact"], "velocity_1_m_s": [0, 0, 1]}}),
         "approach"),
        ([*STEEL, "--normal-velocity", "-1"], None, "--normal-velocity must be finite and > 0"),
        ([*STEEL, "--normal-velocity", "nan"], None, "--normal-velocity must be finite and > 0"),
        (["--radius", "0,02"], None, "--radius must be finite and > 0, with a decimal point"),
        (["--radius", "1"], None, "--density is missing; it must be finite and > 0, unless --mass"),
        (["--radius", "1"], None, "with --speed and --angle, or with --velocity-1"),
        ([*STEEL, "--speed", "1"], None, "--angle is missing"),
        (["-", "--radius", "-1"], '{"body_1": {}}', "--radius must be finite and > 0, got -1.0"),
        (["-", "--radius", "1"], '{"body_1": {}}', "body_1.poisson_ratio is missing"),
        (["-"], "", "the body is empty"),
        (["nowhere.json"], None, "nowhere.json"),
    ],
)  # fmt: skip
def test_collide_refuses_in_words(arguments, given, words):
    done = run("collide", *arguments, given=given)
    assert done.exit_code != 0
    assert words in done.stderr
    assert "Traceback" not in done.output


def test_collide_refuses_the_second_body_only_for_what_is_said_of_it():
    lines = run("collide", "--radius", "-1", "--poisson-ratio-2", "3").stderr.splitlines()
    assert [line for line in lines if "radius" in line] == [
        "Error: --radius must be finite and > 0, got -1.0"
    ]
    assert "--poisson-ratio-2 must be > -1 and ≤ 0.5, got 3.0" in lines
    assert "--poisson-ratio is missing; it must be > -1 and ≤ 0.5" in lines
    assert not [line for line in lines if "body_" in line]


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
        (["--epsilon-n", "0.9"], "Did you mean '--normal-restitution'?"),
        (["--sep", "tab"], "Did you mean '--separator'?"),
        (["--out", "/nowhere/table"], "there is no folder /nowhere"),
        (["--out", "/"], "/ is a folder"),
    ],
)
def test_table_refuses_in_words(arguments, words):
    done = run("table", *arguments)
    assert done.exit_code != 0
    assert words in done.stderr
    assert "Traceback" not in done.output
