"""Speed against accuracy: the scenes, the measurement, and what is stored of it."""

import json

import numpy as np
import pytest

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import collide
from restitution.methods import planner
from restitution.studies.accuracy import candidates as every
from restitution.studies.accuracy.candidates import UNDAMPED, Candidate, candidates
from restitution.studies.accuracy.reference import KNOWN, reference
from restitution.studies.accuracy.report import tradeoff_report
from restitution.studies.accuracy.scenes import SCENES
from restitution.studies.accuracy.tradeoff import (
    Row,
    load_tradeoff,
    machine,
    measure,
    store_rows,
    store_tradeoff,
    study_tradeoff,
)

ROW = {
    "method",
    "options",
    "microseconds_per_collision",
    "error_median",
    "error_p95",
    "error_max",
    "wrong_sign",
    "wrong_switches",
}
BOUNDS = {
    "figure4": ((0.1, 70), (0.01 / 1.4, 4 / 1.4)),
    "stiff": ((1e3, 1e6), (0.01 / 1.4, 4 / 1.4)),
    "solids": ((3.5, 5.5), (0.01 / 1.4, 4 / 1.4)),
    "damped": ((0.1, 70), (0.01 / 1.4, 4 / 1.4)),
    "extremes": ((1e-300, 1e300), (1e-300, 1e300)),
}


def by(method, **options):
    return next(c for c in candidates() if c.method == method and c.options == options)


@pytest.mark.parametrize("name", SCENES)
def test_sample_fills_its_scene_evenly(name):
    kappa, psi, _ = SCENES[name].sample(1000)
    scene = SCENES[name]
    for values, (low, high), stretch in zip(
        (kappa, psi), BOUNDS[name], (scene.kappa, scene.psi), strict=True
    ):
        assert low <= values.min()
        assert values.max() <= high
        # a tenth of the distribution holds a tenth of the sample
        edges = stretch(np.linspace(0, 1, 11))
        counts, _ = np.histogram(values, edges)
        assert np.all(np.abs(counts - 100) <= 5), name


def test_dampings_share_the_sample_evenly():
    kappa, psi, damping = SCENES["damped"].sample(7000)
    different, counts = np.unique(damping, return_counts=True)
    assert tuple(different) == SCENES["damped"].dampings
    assert np.all(counts == 1000)
    for eta in different:
        # none of them has a corner of the region for itself
        for values, (low, high) in zip((kappa, psi), BOUNDS["damped"], strict=True):
            shares = (values[damping == eta] - low) / (high - low)
            assert np.mean(shares) == pytest.approx(0.5, abs=0.01)


@pytest.mark.parametrize("scene", ["figure4", "damped"])
def test_reference_is_known_and_exact(scene):
    truth = reference(scene, 500)
    assert truth.kappa.size == 500
    for eta, part in truth.by_damping():
        exact = collide(part.kappa, part.psi, eta, 1000.0)
        np.testing.assert_array_equal(part.epsilon_t, exact.epsilon_t)
        np.testing.assert_array_equal(part.switches, exact.switches)
    assert np.all(reference("extremes", 500).error_bound <= KNOWN)


def test_every_method_takes_part_with_every_knob():
    found = candidates()
    assert {c.method for c in found} == {"auto", *planner.METHODS}
    integrators = {c.options["integrator"] for c in found if c.method == "timestep"}
    assert integrators == {"velocity_verlet", "symplectic_euler", "forward_euler"}
    assert {c.options.get("spring") for c in found if c.method == "ode"} == {None, "held", "free"}


def test_those_made_without_damping_stay_away_from_it():
    assert {c.method for c in candidates()} - {
        c.method for c in candidates(damped=True)
    } == UNDAMPED.keys()
    one = np.array([18.0]), np.array([0.5])
    for candidate in candidates():
        if candidate.method in UNDAMPED:
            with pytest.raises(ParameterError):
                candidate.run(*one, 0.1)
        else:
            assert np.all(np.isfinite(candidate.run(*one, 0.1)[0]))


@pytest.mark.parametrize("knobs", [{"integrator": "velocity_verlet", "steps": 50}, {"rtol": 1e-6}])
def test_row_of_damped_collisions_has_the_errors_with_each_damping(knobs):
    truth = reference("damped", 35)
    candidate = by("ode" if "rtol" in knobs else "timestep", **knobs)
    row = measure(candidate, truth)
    errors = []
    for eta, part in truth.by_damping():
        epsilon_t, _ = candidate.run(part.kappa, part.psi, eta)
        errors.append(np.abs(epsilon_t - part.epsilon_t) + part.error_bound)
    assert row.error_max == np.max(errors)
    assert row.error_median == np.median(errors)
    assert row.collisions == 35
    assert row.microseconds_per_collision > 0.0


def test_row_has_the_errors_of_its_method():
    truth = reference("figure4", 800)
    candidate = by("timestep", integrator="velocity_verlet", steps=50)
    row = measure(candidate, truth)
    stepped, _ = candidate.run(truth.kappa, truth.psi, 0.0)
    error = np.abs(stepped - truth.epsilon_t)
    assert row.error_max == pytest.approx(error.max(), abs=1e-12)
    assert row.error_median == pytest.approx(np.median(error), abs=1e-12)
    assert 1e-4 < row.error_median < row.error_p95 < row.error_max < 0.3
    assert row.wrong_sign == np.mean(stepped * truth.epsilon_t < 0) > 0
    assert 0.0 < row.wrong_switches < 0.2
    assert row.microseconds_per_collision > 0.0
    assert row.unanswered == 0.0


def test_the_exact_method_has_no_error_but_its_bound():
    truth = reference("solids", 100)
    row = measure(by("exact"), truth)
    assert row.error_max == truth.error_bound.max()
    assert row.wrong_sign == row.wrong_switches == 0.0


def test_wrong_signs_and_refusals_are_counted():
    def opposite(kappa, psi, _damping):
        if np.any(kappa > 35.0):
            raise CostError("too stiff")
        return -collide(kappa, psi).epsilon_t, None

    truth = reference("figure4", 200)
    row = measure(Candidate("opposite", {}, opposite), truth)
    assert row.wrong_sign == 1.0
    assert row.wrong_switches is None
    assert row.unanswered == pytest.approx(np.mean(truth.kappa > 35.0))
    assert (
        measure(Candidate("opposite", {}, opposite, slow=True), truth).unanswered == row.unanswered
    )


@pytest.mark.parametrize("slow", [True, False])
def test_a_method_that_refuses_everything_has_no_figures(slow):
    def refuse(*collisions):
        raise CostError(f"never any of {len(collisions[0])}")

    row = measure(Candidate("never", {}, refuse, slow=slow), reference("solids", 20))
    assert row == Row("never", {}, 20, 1.0)


@pytest.fixture
def few_collisions(monkeypatch):
    monkeypatch.setattr(every, "COLLISIONS", 50)


@pytest.mark.usefixtures("few_collisions", "few_steps")
def test_study_tells_its_progress_and_can_be_left():
    few = [by("exact"), by("coulomb"), by("stiff")]
    seen = [(progress, len(m.rows)) for progress, m in study_tradeoff("solids", few)]
    assert seen == [(0.0, 0), (pytest.approx(1 / 3), 1), (pytest.approx(2 / 3), 2), (1.0, 3)]


@pytest.mark.usefixtures("few_collisions", "few_steps")
def test_storing_a_scene_leaves_the_others(tmp_path):
    target = tmp_path / "tradeoff.json"
    for scene in ("solids", "figure4"):
        *_, (_, measurement) = study_tradeoff(scene, [by("coulomb")])
        store_tradeoff(measurement, target)
    stored = load_tradeoff(target)
    assert list(stored) == ["figure4", "solids"]
    assert stored["solids"]["rows"][0]["method"] == "coulomb"


@pytest.mark.usefixtures("few_collisions", "few_steps")
def test_rows_of_another_program_join_and_the_report_tells_so(tmp_path):
    target = tmp_path / "tradeoff.json"
    few = [by("coulomb"), by("timestep", integrator="velocity_verlet", steps=50)]
    *_, (_, measurement) = study_tradeoff("solids", few)
    store_tradeoff(measurement, target)
    assert "No other program took part" in tradeoff_report(load_tradeoff(target))
    for count in (20, 50):
        store_rows("solids", [Row("lammps", {"steps": count}, 1, 1.0)], target)
    rows = load_tradeoff(target)["solids"]["rows"]
    assert [row["method"] for row in rows] == ["coulomb", "timestep", "lammps"]
    assert rows[-1]["options"] == {"steps": 50}
    report = tradeoff_report(load_tradeoff(target))
    assert "No other program took part" not in report
    assert "| `lammps` | steps 50 | – | – | – | – | – | – | 100 % |" in report


def test_report_finds_the_cheapest_route_that_keeps_the_error():
    def row(method, microseconds, error, unanswered=0.0, **options):
        figures = (microseconds, error / 10, error / 2, error, 0.0, None)
        return vars(Row(method, options, 10, unanswered, *figures))

    rows = [
        row("coulomb", 0.001, 0.5),
        row("exact", 0.5, 1e-14),
        row("quick", 0.1, 9e-4),
        row("choosy", 0.01, 1e-9, unanswered=0.1),
        row("timestep", 0.6, 0.2, integrator="velocity_verlet", steps=50),
        row("timestep", 9.0, 5e-4, integrator="velocity_verlet", steps=1000),
        row("timestep", 90.0, 5e-5, integrator="velocity_verlet", steps=5000),
    ]
    stored = load_tradeoff()["solids"] | {"rows": rows}
    line = next(x for x in tradeoff_report({"solids": stored}).splitlines() if "| solids |" in x)
    assert line == "| solids | `quick` | 0.1 | 0.0009 | 0.6 | 0.2 | 6 | 220 | 1,000 | 9 |"
    only_coarse = {"solids": stored | {"rows": [rows[0], rows[4]]}}
    assert "| solids | none | – |" in tradeoff_report(only_coarse)


def test_machine_is_described_without_a_name_or_a_place():
    import socket  # noqa: PLC0415 - only here

    text = machine()
    assert "numba" in text
    assert "cores" in text
    assert socket.gethostname() not in text
    assert "/" not in text


@pytest.mark.parametrize("scene", SCENES)
def test_stored_measurement_has_the_shape_of_the_contract(scene):
    kept = load_tradeoff()[scene]
    assert {"scene", "measured_at", "machine", "model_version", "rows"} <= kept.keys()
    assert kept["scene"] == scene
    # a method that is new is measured with the next `make tradeoff`
    assert {row["method"] for row in kept["rows"]} >= {
        each.method for each in candidates(damped=scene == "damped")
    }
    for row in kept["rows"]:
        assert row.keys() >= ROW
        assert (row["error_max"] is None) is (row["unanswered"] == 1.0)
    # NaN and Infinity are no JSON
    json.dumps(kept, allow_nan=False)


def test_stored_measurement_shows_that_time_steps_are_of_first_order_with_damping():
    def order(scene):
        medians = [
            next(
                row["error_median"] for row in load_tradeoff()[scene]["rows"] if row["options"] == o
            )
            for o in ({"integrator": "velocity_verlet", "steps": n} for n in (1000, 20_000))
        ]
        return np.log(medians[0] / medians[1]) / np.log(20)

    assert order("figure4") == pytest.approx(2.0, abs=0.1)
    assert order("damped") == pytest.approx(1.0, abs=0.1)


def test_stored_measurement_shows_what_it_must():
    rows = {
        (row["method"], *row["options"].values()): row for row in load_tradeoff()["figure4"]["rows"]
    }
    verlet = [rows["timestep", "velocity_verlet", n]["error_p95"] for n in every.STEPS]
    assert sorted(verlet, reverse=True) == verlet
    # forward Euler gains energy; without events the solver pays, or errs
    assert rows["timestep", "forward_euler", 50]["error_max"] > 1.0
    located, held = rows["ode", 1e-6], rows["ode", 1e-6, "held"]
    assert held["microseconds_per_collision"] > 2 * located["microseconds_per_collision"]
    assert rows["ode", 1e-6, "free"]["error_p95"] > 0.1
    assert rows[("exact",)]["error_max"] < 1e-12
