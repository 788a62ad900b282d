"""GET /cut and /map: axes, order of the arrays, columns, against single collisions."""

import math

import numpy as np
import pytest

QUANTITIES = ("epsilon_t", "switches", "coulomb", "stiff_bound", "stiff_asymptote", "error")
ALL = ",".join(QUANTITIES)


def single(service, kappa, mu_over_alpha, gt_over_gn, **more):
    return service.answer(
        "/collision",
        kappa=repr(kappa),
        mu_over_alpha=mu_over_alpha,
        gt_over_gn=repr(gt_over_gn),
        **more,
    )


def test_cut_along_velocity_has_its_defaults(service):
    answer = service.answer("/cut", along="gt_over_gn", kappa=18, mu_over_alpha=1.4)
    assert answer["along"] == "gt_over_gn"
    assert answer["values"] == pytest.approx(np.linspace(0.01, 4, 400), rel=1e-15, abs=0)
    assert answer.keys() == {
        "along",
        "values",
        "epsilon_t",
        "switches",
        "method",
        "error_bound",
        "tolerance_met",
    }
    assert len(answer["epsilon_t"]) == len(answer["switches"]) == 400
    assert answer["method"] == "exact"
    assert answer["tolerance_met"] is True
    assert 0 <= answer["error_bound"] <= 1e-10


def test_cut_along_stiffness_has_its_defaults(service):
    answer = service.answer("/cut", along="kappa", gt_over_gn=0.4, mu_over_alpha=1.4)
    assert answer["along"] == "kappa"
    assert answer["values"] == pytest.approx(np.linspace(0.1, 70, 400), rel=1e-15, abs=0)


@pytest.mark.parametrize("method", ["auto", "exact", "coulomb", "pragmatic", "stiff"])
@pytest.mark.parametrize("along", ["kappa", "gt_over_gn"])
def test_cut_is_made_of_single_collisions(service, along, method):
    fixed = {"kappa": 30.0, "gt_over_gn": 0.7}
    del fixed[along]
    answer = service.answer(
        "/cut",
        along=along,
        mu_over_alpha=0.5,
        minimum=0.02,
        maximum=40,
        scale="log",
        count=9,
        method=method,
        floor=0.1,
        quantities=ALL,
        **fixed,
    )
    assert answer["values"] == pytest.approx(np.geomspace(0.02, 40, 9), rel=1e-14, abs=0)
    assert [answer["values"][0], answer["values"][-1]] == [0.02, 40]
    bounds = []
    for i, value in enumerate(answer["values"]):
        point = {**fixed, along: value, "mu_over_alpha": 0.5}
        alone = single(service, **point, method=method, floor=0.1)
        exact = single(service, **point)["epsilon_t"]
        found = {name: answer[name][i] for name in QUANTITIES}
        assert found == {
            "epsilon_t": alone["epsilon_t"],
            "switches": alone["switches"],
            **alone["estimates"],
            "error": alone["epsilon_t"] - exact,
        }
        bounds.append(alone["error_bound"])
    assert answer["error_bound"] == max(bounds)
    assert answer["tolerance_met"] is (max(bounds) <= 1e-10)
    assert answer["method"] == ("exact" if method == "auto" else method)


def test_map_has_its_defaults(service):
    answer = service.answer("/map", mu_over_alpha=1.4)
    assert answer["kappa"] == pytest.approx(np.linspace(0.1, 70, 200), rel=1e-15, abs=0)
    assert answer["gt_over_gn"] == pytest.approx(np.linspace(0.01, 4, 150), rel=1e-15, abs=0)
    for name in ("epsilon_t", "switches"):
        assert np.array(answer[name]).shape == (150, 200), name
    assert answer.keys() == {
        "kappa",
        "gt_over_gn",
        "epsilon_t",
        "switches",
        "method",
        "error_bound",
        "tolerance_met",
    }


def test_map_is_indexed_by_velocity_then_stiffness(service):
    answer = service.answer(
        "/map",
        mu_over_alpha=1.4,
        kappa_min=0.3,
        kappa_max=90,
        kappa_count=4,
        kappa_scale="log",
        gt_over_gn_min=0.05,
        gt_over_gn_max=3.5,
        gt_over_gn_count=3,
        quantities=ALL,
    )
    for j, gt_over_gn in enumerate(answer["gt_over_gn"]):
        for i, kappa in enumerate(answer["kappa"]):
            alone = single(service, kappa, 1.4, gt_over_gn)
            assert {name: answer[name][j][i] for name in QUANTITIES} == {
                "epsilon_t": alone["epsilon_t"],
                "switches": alone["switches"],
                **alone["estimates"],
                "error": 0.0,
            }


def test_map_has_its_scales(service):
    answer = service.answer(
        "/map",
        mu_over_alpha=1.4,
        kappa_count=5,
        kappa_scale="log",
        gt_over_gn_count=6,
        gt_over_gn_scale="log",
    )
    assert answer["kappa"] == pytest.approx(np.geomspace(0.1, 70, 5), rel=1e-14, abs=0)
    assert answer["gt_over_gn"] == pytest.approx(np.geomspace(0.01, 4, 6), rel=1e-14, abs=0)


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_quantities_asked_for_are_all_that_comes(service, quantity):
    few = {"mu_over_alpha": 1.4, "kappa_count": 3, "gt_over_gn_count": 2}
    everything = service.answer("/map", **few, quantities=ALL)
    answer = service.answer("/map", **few, quantities=quantity)
    assert answer[quantity] == everything[quantity]
    assert set(QUANTITIES) & answer.keys() == {quantity}


@pytest.mark.parametrize("method", ["coulomb", "pragmatic", "stiff"])
def test_error_is_signed_and_within_the_bound(service, method):
    grid = {"mu_over_alpha": 1, "kappa_count": 20, "gt_over_gn_count": 15}
    exact = np.array(service.answer("/map", **grid, method="exact")["epsilon_t"])
    answer = service.answer("/map", **grid, method=method, quantities="epsilon_t,error")
    error = np.array(answer["error"])
    assert error == pytest.approx(np.array(answer["epsilon_t"]) - exact, abs=1e-15)
    assert error.min() < 0 < error.max()
    assert np.abs(error).max() <= answer["error_bound"]


def test_switches_of_the_figure_5_row_are_those_of_the_paper(service):
    # model.md §5: borders between the sixteen ranges of ψ at κ = 63
    borders = [2, 1.8168, 1.4745, 1.0394, 0.7761, 0.6058, 0.5656, 0.3804, 0.2762, 0.2294]
    borders += [0.1175, 0.0936, 0.0452, 0.0189, 0.0069]
    middles = [math.sqrt(a * b) for a, b in zip([3, *borders], [*borders, 0.004], strict=True)]
    answer = service.collisions({"kappa": 63, "mu_over_alpha": 1, "gt_over_gn": middles})
    assert answer["switches"] == [0, 2, 4, 6, 8, 6, 8, 6, 4, 6, 4, 2, 4, 2, 4, 2]


@pytest.mark.parametrize(
    ("more", "parameter"),
    [
        ({"along": "kappa", "kappa": 18, "gt_over_gn": 1}, "kappa"),
        ({"along": "gt_over_gn", "kappa": 18, "gt_over_gn": 1}, "gt_over_gn"),
        ({"along": "kappa"}, "gt_over_gn"),
        ({"along": "gt_over_gn"}, "kappa"),
        ({"along": "mu_over_alpha", "kappa": 18, "gt_over_gn": 1}, "along"),
        ({"kappa": 18}, "along"),
        ({"along": "gt_over_gn", "kappa": 18, "count": 1}, "count"),
        ({"along": "gt_over_gn", "kappa": 18, "count": 100_001}, "count"),
        ({"along": "gt_over_gn", "kappa": 18, "minimum": 0, "scale": "log"}, "minimum"),
        ({"along": "kappa", "gt_over_gn": 1, "minimum": 0}, "minimum"),
        ({"along": "gt_over_gn", "kappa": 18, "minimum": -1}, "minimum"),
        ({"along": "gt_over_gn", "kappa": 18, "minimum": 3, "maximum": 1}, "maximum"),
        ({"along": "gt_over_gn", "kappa": 18, "minimum": 5}, "minimum"),
        ({"along": "gt_over_gn", "kappa": 18, "scale": "quadratic"}, "scale"),
        ({"along": "gt_over_gn", "kappa": 18, "quantities": "reversals"}, "quantities"),
        ({"along": "gt_over_gn", "kappa": 18, "samples": 10}, "samples"),
    ],
    ids=str,
)
def test_cut_is_refused_by_the_name_of_what_is_wrong(service, more, parameter):
    wrong = service.wrong("/cut", mu_over_alpha=1.4, **more)
    assert wrong.keys() == {parameter}
    given = more.get(parameter)
    assert wrong[parameter]["value"] == (None if given is None else str(given))


@pytest.mark.parametrize(
    ("more", "parameters"),
    [
        ({"kappa_min": 0}, {"kappa_min"}),
        ({"kappa_min": 0, "kappa_scale": "log"}, {"kappa_min"}),
        ({"gt_over_gn_min": 0, "gt_over_gn_scale": "log"}, {"gt_over_gn_min"}),
        ({"kappa_count": 1}, {"kappa_count"}),
        ({"kappa_min": 80, "kappa_max": 70}, {"kappa_max"}),
        ({"kappa_min": 80, "kappa_max": 70, "gt_over_gn_min": 3, "gt_over_gn_max": 1},
         {"kappa_max", "gt_over_gn_max"}),
        ({"kappa_min": 80, "kappa_max": 70, "method": "guess"}, {"kappa_max", "method"}),
        ({"kappa": 18}, {"kappa"}),
        ({"gt_over_gn": 18, "episode_limit": 4}, {"gt_over_gn", "episode_limit"}),
    ],
    # a set is written in another order by each process
    ids=lambda value: "" if isinstance(value, set) else str(value),
)  # fmt: skip
def test_map_is_refused_by_the_names_of_all_that_is_wrong(service, more, parameters):
    wrong = service.wrong("/map", mu_over_alpha=1.4, **more)
    assert wrong.keys() == parameters
    assert {name: entry["value"] for name, entry in wrong.items()} == {
        name: str(more[name]) for name in parameters
    }


def test_largest_switches_bounds_the_counts_of_stiff_springs_closely(service):
    answer = service.answer(
        "/map",
        mu_over_alpha=1,
        kappa_min=1000,
        kappa_max=10_000,
        kappa_count=5,
        gt_over_gn_min=0.02,
        gt_over_gn_max=1.999,
        gt_over_gn_count=400,
        quantities="switches,largest_switches",
    )
    law = np.array(answer["largest_switches"])
    # √κ t_c/π; counts are even, so within 2 of it
    assert law[0] == pytest.approx(1.0243420 * np.sqrt(answer["kappa"]), rel=1e-6)
    assert np.max(answer["switches"], axis=0) == pytest.approx(law[0], abs=2)
    damped = service.answer(
        "/cut", along="kappa", mu_over_alpha=1, gt_over_gn=1, damping=0.1, count=2,
        quantities="largest_switches",
    )  # fmt: skip
    assert damped["largest_switches"] == [None, None]
