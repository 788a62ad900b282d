"""``POST /scaling/map``: ε_t of real spheres over both velocities."""

import csv
import io

import numpy as np
import pytest

STEEL = {"radius_m": 0.02, "density_kg_m3": 7850, "youngs_modulus_pa": 2.1e11, "poisson_ratio": 0.3}
FIGURE_2 = {
    "body_1": STEEL,
    "body_2": STEEL,
    "friction_coefficient": 0.4,
    "tangential_stiffness_n_per_m": 1e12,
    "normal_velocity_m_s": {"min": 1, "max": 200, "count": 7},
    "tangential_velocity_m_s": {"min": 0.01, "max": 200, "count": 5, "scale": "log"},
}
SCALES = ("kappa", "damping", "time_scale_s", "length_scale_m", "contact_duration_s")


def mapped(service, body, **query):
    return service.read(service.post(body, path="/scaling/map", **query))


def wrong(service, body):
    errors = service.problem(service.post(body, path="/scaling/map"), 422)["errors"]
    return {entry["parameter"]: entry for entry in errors}


def test_cells_are_those_of_single_impacts(service):
    answer = mapped(service, FIGURE_2)
    assert np.shape(answer["epsilon_t"]) == np.shape(answer["switches"]) == (5, 7)
    for row, g_t in enumerate(answer["tangential_velocity_m_s"]):
        for column, g_n in enumerate(answer["normal_velocity_m_s"]):
            bodies = {key: FIGURE_2[key] for key in FIGURE_2 if "velocity" not in key}
            impact = {"normal_velocity_m_s": g_n, "tangential_velocity_m_s": g_t}
            single = service.read(service.post(bodies | {"impact": impact}, path="/scaling"))
            assert single["epsilon_t"] == answer["epsilon_t"][row][column]
            assert single["switches"] == answer["switches"][row][column]
            for name in SCALES:
                assert single[name] == answer[name][column], name
            assert single["mu_over_alpha"] == answer["mu_over_alpha"]


def test_schwager2008_figure_1_is_coulombs_law(service):
    answer = mapped(service, FIGURE_2 | {"quantities": ["coulomb"]})
    g_n, g_t = np.meshgrid(answer["normal_velocity_m_s"], answer["tangential_velocity_m_s"])
    assert answer["coulomb"] == pytest.approx(np.maximum(0, 1 - 2.8 * g_n / g_t), abs=1e-14)
    assert "epsilon_t" not in answer


def test_schwager2008_figure_2_is_near_coulombs_law_but_for_small_tangential_velocities(service):
    axes = {
        "normal_velocity_m_s": {"min": 1, "max": 200, "count": 40},
        "tangential_velocity_m_s": {"min": 1, "max": 200, "count": 40},
    }
    answer = mapped(service, FIGURE_2 | axes | {"quantities": ["epsilon_t", "coulomb"]})
    epsilon_t, coulomb = np.array(answer["epsilon_t"]), np.array(answer["coulomb"])
    # "ε_t resembles Coulomb's in a wide range"; negative values only for small g_t
    assert np.abs(epsilon_t - coulomb)[1:].max() < 0.02
    assert epsilon_t.min() < 0.0


def test_a_material_is_a_body_of_a_map_with_two_ranges(service):
    ranges = {key: FIGURE_2[key] for key in FIGURE_2 if "velocity" in key}
    for item in service.answer("/materials")["items"]:
        mapped(service, item | ranges)


def test_default_map_follows_nothing_at_the_tolerance_of_a_picture(service):
    body = FIGURE_2 | {"tolerance": 4e-3, "quantities": ["epsilon_t"]}
    body |= {
        "normal_velocity_m_s": {"min": 0.1, "max": 200},
        "tangential_velocity_m_s": {"min": 0, "max": 200},
    }
    answer = service.read(
        service.affordable(lambda: service.post(body, path="/scaling/map", encoding="base64"))
    )
    assert answer["epsilon_t"]["shape"] == "150,200"
    assert answer["tolerance_met"] is True


def test_table_form_has_the_normal_velocity_fastest(service):
    rows = list(
        csv.DictReader(io.StringIO(service.post(FIGURE_2, path="/scaling/map", format="csv").text))
    )
    answer = mapped(service, FIGURE_2)
    assert len(rows) == 35
    assert [float(r["normal_velocity_m_s"]) for r in rows[:7]] == answer["normal_velocity_m_s"]
    assert float(rows[8]["epsilon_t"]) == answer["epsilon_t"][1][1]


def test_everything_wrong_is_named_at_once(service):
    body = {
        "body_1": STEEL | {"radius_m": 0},
        "body_2": STEEL,
        "friction_coefficient": 0.4,
        "tangential_stiffness_n_per_m": "mindlin",
        "normal_velocity_m_s": {"min": 0, "max": 1, "count": 1, "scale": "cubic"},
        "tangential_velocity_m_s": {"min": 3, "max": 2, "step": 1},
        "quantities": ["epsilon"],
        "tolerance": 2,
        "kappa": 1,
    }
    assert wrong(service, body).keys() == {
        "body_1.radius_m", "normal_velocity_m_s.min", "normal_velocity_m_s.count",
        "normal_velocity_m_s.scale", "tangential_velocity_m_s.max", "tangential_velocity_m_s.step",
        "quantities", "tolerance", "kappa",
    }  # fmt: skip


@pytest.mark.parametrize("quantities", [[], "epsilon_t", [["epsilon_t"]], ["epsilon_t"] * 9, [1]])
def test_quantities_are_a_list_of_words(service, quantities):
    assert "quantities" in wrong(service, FIGURE_2 | {"quantities": quantities})


def test_damping_differs_from_column_to_column(service):
    body = FIGURE_2 | {"dissipative_constant_s": 1e-6}
    answer = service.read(service.post(body, path="/scaling/map"))
    damping = np.array(answer["damping"])
    # η ∝ g_n^{1/5}
    normal = np.array(answer["normal_velocity_m_s"])
    np.testing.assert_allclose(damping / damping[0], (normal / normal[0]) ** 0.2, rtol=1e-12)
    impact = {
        "normal_velocity_m_s": normal[1],
        "tangential_velocity_m_s": answer["tangential_velocity_m_s"][1],
    }
    one = {key: value for key, value in body.items() if "velocity" not in key} | {"impact": impact}
    study = service.read(service.post(one, path="/scaling"))
    assert answer["epsilon_t"][1][1] == pytest.approx(study["epsilon_t"], abs=1e-12)
    assert study["epsilon_n"] < 1.0


def test_missing_ranges_are_named(service):
    body = {key: FIGURE_2[key] for key in FIGURE_2 if "velocity" not in key}
    assert wrong(service, body).keys() == {"normal_velocity_m_s", "tangential_velocity_m_s"}


def test_too_many_cells_are_413(service):
    body = FIGURE_2 | {
        "normal_velocity_m_s": {"min": 1, "max": 2, "count": 10_000},
        "tangential_velocity_m_s": {"min": 1, "max": 2, "count": 101},
    }
    detail = service.problem(service.post(body, path="/scaling/map"), 413)["detail"]
    assert "1,000,000" in detail


@pytest.mark.parametrize("scale", ["linear", "log"])
@pytest.mark.parametrize(
    ("normal", "tangential"),
    [((5e-324, 1.7e308), (5e-324, 1.7e308)), ((5e-324, 1e-300), (1e-3, 1e3)),
     ((1e-100, 1e100), (1e-150, 1e150)), ((1e300, 1.7e308), (5e-324, 1e-300))],
)  # fmt: skip
def test_extreme_velocities_are_answered_or_refused_in_words(service, scale, normal, tangential):
    body = FIGURE_2 | {
        "normal_velocity_m_s": {"min": normal[0], "max": normal[1], "count": 4, "scale": scale},
        "tangential_velocity_m_s": {
            "min": tangential[0], "max": tangential[1], "count": 3, "scale": scale
        },
    }  # fmt: skip
    response = service.affordable(lambda: service.post(body, path="/scaling/map"))
    if response.status_code == 422:
        assert "double precision" in service.problem(response, 422)["detail"]
        return
    answer = service.read(response)
    assert np.all(np.abs(np.array(answer["epsilon_t"], float)) <= 1)
