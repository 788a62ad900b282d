"""``GET /table``: ε_t(κ, ψ) for other codes."""

import csv
import io

import numpy as np
import pytest

SMALL = {"kappa_min": 3, "kappa_max": 6, "kappa_count": 5, "psi_min": 0.1, "psi_max": 2,
         "psi_count": 4}  # fmt: skip


def test_default_table_is_that_of_the_default_map(service):
    response = service.affordable(lambda: service.get("/table", format="npz"))
    with np.load(io.BytesIO(response.content)) as arrays:
        assert arrays["epsilon_t"].shape == (150, 200)
        assert (arrays["kappa"][0], arrays["kappa"][-1]) == (0.1, 70.0)
        assert 0 < arrays["largest_error"] < 1
        assert arrays["error_basis"] == "proven"


def test_rows_are_collisions_with_kappa_fastest(service):
    rows = list(csv.DictReader(io.StringIO(service.get("/table", **SMALL).text)))
    assert len(rows) == 20
    assert [float(row["kappa"]) for row in rows[:5]] == [3.0, 3.75, 4.5, 5.25, 6.0]
    for row in rows[3:18:7]:
        parameters = {"kappa": row["kappa"], "mu_over_alpha": 1, "gt_over_gn": row["psi"]}
        exact = service.answer("/collision", **parameters)["epsilon_t"]
        assert float(row["epsilon_t"]) == pytest.approx(exact, abs=1e-9)


def test_signs_differ_and_nothing_else(service):
    paper, other = (
        list(csv.DictReader(io.StringIO(service.get("/table", **SMALL, sign=sign).text)))
        for sign in ("paper", "reversed")
    )
    for one, two in zip(paper, other, strict=True):
        assert float(one["epsilon_t"]) == -float(two["epsilon_t"])
        assert one["largest_error"] == two["largest_error"]


def test_grid_is_chosen_for_an_error(service):
    ranges = {name: SMALL[name] for name in SMALL if "count" not in name}
    row = next(csv.DictReader(io.StringIO(service.get("/table", **ranges, error=0.02).text)))
    assert float(row["largest_error"]) <= 0.02


@pytest.mark.parametrize("error", [0.1, 0.05])
def test_grid_for_an_error_over_the_default_ranges_is_within_the_budget(service, error):
    response = service.affordable(lambda: service.get("/table", error=error, format="npz"))
    with np.load(io.BytesIO(response.content)) as arrays:
        assert arrays["largest_error"] <= error
        assert (arrays["kappa_scale"], arrays["psi_scale"]) == ("log", "log")


def test_scales_that_an_error_implies_may_be_given(service):
    query = {"error": 0.1, "format": "c"}
    tags = [
        service.get("/table", **query, **scales).headers["etag"]
        for scales in ({}, {"kappa_scale": "log"}, {"kappa_scale": "log", "psi_scale": "log"})
    ]
    assert len(set(tags)) == 1
    text = service.get("/table", **query, kappa_min=3, kappa_max=4, psi_min=0).text
    assert "from 0 to 4 (linear)" in text


@pytest.mark.parametrize(("form", "words"), [("c", "#ifndef"), ("python", "def epsilon_t")])
def test_languages_are_texts_that_state_error_and_sign(service, form, words):
    response = service.get("/table", **SMALL, format=form)
    assert response.headers["content-type"] == "text/plain; charset=utf-8"
    assert words in response.text
    assert "Largest error of bilinear interpolation" in response.text
    assert "+1 smooth spheres" in response.text


def test_table_is_cached_by_its_etag(service):
    tag = service.get("/table", **SMALL).headers["etag"]
    assert service.get("/table", headers={"If-None-Match": tag}, **SMALL).status_code == 304
    assert service.get("/table", **SMALL, sign="reversed").headers["etag"] != tag


def test_damping_is_a_third_axis_with_kappa_fastest(service):
    third = {"damping_min": 0, "damping_max": 0.3, "damping_count": 3}
    rows = list(csv.DictReader(io.StringIO(service.get("/table", **SMALL, **third).text)))
    assert len(rows) == 60
    assert {float(row["damping"]) for row in rows[20:40]} == {0.15}
    for row in rows[3:60:11]:
        parameters = {"kappa": row["kappa"], "mu_over_alpha": 1, "gt_over_gn": row["psi"]}
        exact = service.answer("/collision", **parameters, damping=row["damping"])["epsilon_t"]
        assert float(row["epsilon_t"]) == pytest.approx(exact, abs=1e-9)
    response = service.get("/table", **SMALL, **third, format="npz")
    with np.load(io.BytesIO(response.content)) as arrays:
        assert arrays["epsilon_t"].shape == (3, 4, 5)
        assert arrays["damping"].tolist() == [0.0, 0.15, 0.3]
        assert arrays["damping_scale"] == "linear"


def test_grid_is_chosen_for_an_error_in_three_parameters(service):
    # the request of docs/event-driven.md
    ranges = {"kappa_min": 3, "kappa_max": 6, "psi_min": 0.05, "psi_max": 2, "damping_max": 0.5}
    response = service.get("/table", **ranges, error=0.1, format="npz")
    assert response.status_code == 200, response.text
    with np.load(io.BytesIO(response.content)) as arrays:
        assert arrays["largest_error"] <= 0.1
        assert arrays["damping"].size >= 4


def test_damping_may_be_one_number(service):
    response = service.get("/table", **SMALL, damping=0.3, format="npz")
    third = {"damping_min": 0, "damping_max": 0.3, "damping_count": 3}
    planes = service.get("/table", **SMALL, **third, format="npz")
    with np.load(io.BytesIO(response.content)) as one, np.load(io.BytesIO(planes.content)) as many:
        assert one["damping"] == 0.3
        assert np.array_equal(one["epsilon_t"], many["epsilon_t"][-1])


@pytest.mark.parametrize(("form", "words"), [("c", "double damping)"), ("python", ", damping)")])
def test_languages_take_the_damping(service, form, words):
    assert words in service.get("/table", **SMALL, damping_max=0.3, format=form).text
    assert words not in service.get("/table", **SMALL, damping=0.3, format=form).text


@pytest.mark.parametrize(
    ("parameters", "name", "words"),
    [
        ({"format": "json"}, "format", "csv, npz, c, python"),
        ({"sign": "plus"}, "sign", "paper or reversed"),
        ({"error": 0}, "error", "1e-12"),
        ({"error": 0.1, "kappa_count": 5}, "kappa_count", "left out"),
        ({"psi_min": 5}, "psi_min", "4.0"),
        ({"psi_min": 0, "psi_scale": "log"}, "psi_min", "log"),
        ({"kappa_min": 0}, "kappa_min", "> 0"),
        ({"kappa_count": 1}, "kappa_count", "≥ 2"),
        ({"damping_min": 1}, "damping_min", "damping_max"),
        ({"damping_count": 3}, "damping_count", "damping_max"),
        ({"damping_max": 1, "damping": 0.1}, "damping", "left out"),
        ({"damping_max": 1, "damping_min": 2}, "damping_max", "2.0"),
        ({"damping_max": 1, "damping_scale": "log"}, "damping_min", "log"),
        ({"damping_max": 1, "damping_count": 3, "error": 0.1}, "damping_count", "left out"),
        ({"damping_max": 1e31}, "damping_max", "1e+30"),
        ({"damping": -1}, "damping", "from 0"),
        ({"encoding": "base64"}, "encoding", "left out"),
    ],
)
def test_wrong_parameters_are_named(service, parameters, name, words):
    assert words in service.wrong("/table", **parameters)[name]["requirement"]


@pytest.mark.parametrize(
    "parameters",
    [{"kappa_count": 10**6}, {"kappa_count": 10**12, "psi_count": 10**12},
     {"kappa_min": 1e13, "kappa_max": 1e14, "psi_max": 1}, {"error": 1e-9},
     {"kappa_min": 5e-324, "kappa_max": 1.7e308, "psi_min": 5e-324, "psi_max": 1.7e308},
     {"damping_max": 1, "damping_count": 99}, {"damping_max": 1, "damping_count": 10**12},
     {"damping_max": 1e30, "damping_count": 10**5, "kappa_count": 2, "psi_count": 2},
     {"damping_max": 1e30, "error": 1e-6},
     {"kappa_min": 1e13, "kappa_max": 1e14, "psi_max": 1, "damping": 0.1}],
)  # fmt: skip
def test_costly_tables_are_413(service, parameters):
    problem = service.affordable(lambda: service.get("/table", **parameters), tries=True)
    assert any(c.isdigit() for c in service.problem(problem, 413)["detail"])
