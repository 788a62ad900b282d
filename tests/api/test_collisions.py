"""POST /collisions: numbers, lists and typed arrays in, lists in the same order out."""

import base64

import numpy as np
import pytest

KEYS = {"epsilon_t", "epsilon_n", "switches", "method", "error_bound", "tolerance_met"}
THREE = {"kappa": [5, 18.0, 63], "mu_over_alpha": 1.4, "gt_over_gn": [0.1, 1, 4.5]}


def typed(values, dtype="f8", **more):
    data = base64.b64encode(np.asarray(values, f"<{dtype}").tobytes()).decode()
    return {"dtype": dtype, "bdata": data, "shape": str(len(values)), **more}


def test_lists_come_in_the_order_of_the_parameters(service):
    answer = service.collisions(THREE)
    assert answer.keys() == KEYS
    assert {len(column) for column in answer.values()} == {3}
    for i in range(3):
        alone = service.answer(
            "/collision",
            kappa=THREE["kappa"][i],
            mu_over_alpha=1.4,
            gt_over_gn=THREE["gt_over_gn"][i],
        )
        assert {name: column[i] for name, column in answer.items()} == {
            name: alone[name] for name in KEYS
        }


def test_numbers_give_lists_of_length_one(service):
    answer = service.collisions({"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4})
    assert answer.keys() == KEYS
    assert all(isinstance(column, list) and len(column) == 1 for column in answer.values())


@pytest.mark.parametrize("dtype", ["f8", "f4", "i4"])
def test_typed_arrays_are_as_good_as_lists(service, dtype):
    numbers = {"kappa": [5, 18, 63], "mu_over_alpha": [1, 2, 1], "gt_over_gn": [1, 0, 3]}
    packed = {name: typed(values, dtype) for name, values in numbers.items()}
    assert service.collisions(packed) == service.collisions(numbers)


def test_typed_arrays_lists_and_numbers_mix(service):
    mixed = {"kappa": typed([5, 18, 63]), "mu_over_alpha": 1.4, "gt_over_gn": [0.1, 1, 4.5]}
    assert service.collisions({**mixed, "damping": [0, 0, 0]}) == service.collisions(THREE)


def test_what_was_answered_typed_can_be_asked_again(service):
    cut = service.answer(
        "/cut", along="kappa", mu_over_alpha=1.4, gt_over_gn=0.4, encoding="base64"
    )
    body = {"kappa": cut["values"], "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
    assert service.collisions(body, encoding="base64")["epsilon_t"] == cut["epsilon_t"]


def test_options_apply_to_all(service):
    answer = service.collisions({**THREE, "method": "pragmatic", "floor": 0.25, "tolerance": 0.9})
    assert answer["epsilon_t"] == [0.25, 0.25, pytest.approx(1 - 2 * 1.4 / 4.5)]
    assert answer["method"] == ["pragmatic"] * 3
    assert answer["tolerance_met"] == [bound <= 0.9 for bound in answer["error_bound"]]
    assert answer["switches"] == [None] * 3


def test_method_is_told_for_each_when_auto_chooses(service):
    body = {"kappa": [2000, 5], "mu_over_alpha": 1, "gt_over_gn": 1, "tolerance": 0.1}
    answer = service.collisions({**body, "quantities": ["epsilon_t"]})
    assert answer["method"] == ["stiff", "exact"]
    assert answer["tolerance_met"] == [True, True]
    assert answer["error_bound"][0] > 1e-4 > answer["error_bound"][1]


@pytest.mark.parametrize("quantity", ["epsilon_t", "epsilon_n", "switches"])
def test_quantities_asked_for_are_all_that_comes(service, quantity):
    answer = service.collisions({**THREE, "quantities": [quantity]})
    assert answer.keys() == {quantity, "method", "error_bound", "tolerance_met"}
    assert answer[quantity] == service.collisions(THREE)[quantity]


def test_no_collisions_have_no_results(service):
    answer = service.collisions({"kappa": [], "mu_over_alpha": 1, "gt_over_gn": 1})
    assert answer == {name: [] for name in KEYS}


def test_a_million_collisions_are_answered(service):
    million = np.linspace(2.0, 3.0, 1_000_000)
    body = {"kappa": 18, "mu_over_alpha": 1, "gt_over_gn": typed(million)}
    answer = service.collisions({**body, "quantities": ["epsilon_t"]}, encoding="base64")
    epsilon_t = np.frombuffer(base64.b64decode(answer["epsilon_t"]["bdata"]), "<f8")
    np.testing.assert_allclose(epsilon_t, 1 - 2 / million, rtol=0, atol=1e-15)


@pytest.mark.parametrize("as_list", [True, False])
def test_a_million_and_one_are_refused_with_the_limit(service, as_list):
    million = [1.0] * 1_000_001
    body = {"kappa": 18, "mu_over_alpha": 1, "gt_over_gn": million if as_list else typed(million)}
    problem = service.problem(service.post(body), 413)
    assert "1,000,000" in problem["detail"]
    assert "1,000,001" in problem["detail"]


def test_exact_by_name_is_refused_beyond_its_budget_with_cost_and_limit(service):
    body = {"kappa": 1e20, "mu_over_alpha": 1, "gt_over_gn": 1, "method": "exact"}
    detail = service.problem(service.post(body), 413)["detail"]
    assert len([word for word in detail.split() if any(c.isdigit() for c in word)]) >= 2


@pytest.mark.parametrize(
    ("change", "wrong"),
    [
        ({"kappa": [5, -18.0, 63]}, {"kappa[1]": -18}),
        ({"kappa": [5, 0, "63"]}, {"kappa[1]": 0, "kappa[2]": "63"}),
        ({"kappa": [5, 18, None]}, {"kappa[2]": None}),
        ({"kappa": [5, [18], 63]}, {"kappa[1]": "[18]"}),
        ({"kappa": [True, 18, 63]}, {"kappa[0]": True}),
        (
            {"mu_over_alpha": [1, 1, -1], "kappa": [0, 1, 2]},
            {"kappa[0]": 0, "mu_over_alpha[2]": -1},
        ),
        ({"kappa": typed([5.0, np.nan, -np.inf])}, {"kappa[1]": "NaN", "kappa[2]": "-Infinity"}),
        ({"damping": [0, 0, -0.5]}, {"damping[2]": -0.5}),
        ({"damping": [0, 1e31, -0.5]}, {"damping[1]": 1e31, "damping[2]": -0.5}),
        ({"damping": -0.5}, {"damping": -0.5}),
        ({"quantities": ["epsilon_t", "reversals"]}, {"quantities[1]": "reversals"}),
        ({"quantities": []}, {"quantities": "[]"}),
        ({"quantities": "epsilon_t"}, {"quantities": "epsilon_t"}),
        ({"method": "guess"}, {"method": "guess"}),
        ({"method": None}, {"method": None}),
        ({"tolerance": "0.1"}, {"tolerance": "0.1"}),
        ({"tolerance": True}, {"tolerance": True}),
        ({"steps": "50"}, {"steps": "50"}),
        ({"steps": 50.5}, {"steps": 50.5}),
        ({"friction": 0.4}, {"friction": 0.4}),
        ({"format": "csv"}, {"format": "csv"}),
        ({"kappa": None}, {"kappa": None}),
        ({"tolerance": 2, "kappa": -1, "x": 1}, {"tolerance": 2, "kappa": -1, "x": 1}),
    ],
    ids=str,
)
def test_all_that_is_wrong_is_named_with_the_value_received(service, change, wrong):
    errors = service.wrong_body({**THREE, **change})
    assert {name: entry["value"] for name, entry in errors.items()} == wrong


def test_missing_parameters_are_all_named(service):
    errors = service.wrong_body({})
    assert {name: entry["value"] for name, entry in errors.items()} == {
        "kappa": None,
        "mu_over_alpha": None,
        "gt_over_gn": None,
    }


def test_lists_of_different_lengths_are_all_named(service):
    errors = service.wrong_body(
        {"kappa": [1, 2, 3], "mu_over_alpha": typed([1, 2]), "gt_over_gn": 1, "damping": [0]}
    )
    assert errors.keys() == {"kappa", "mu_over_alpha", "damping"}


@pytest.mark.parametrize(
    "array",
    [
        typed([5, 18, 63], shape="4"),
        typed([5, 18, 63], shape="3,1"),
        typed([5, 18, 63], shape=[3]),
        typed([5, 18, 63], shape={"n": 3}),
        typed([5, 18, 63], dtype="f8") | {"dtype": "f16"},
        typed([5, 18, 63]) | {"dtype": "O"},
        typed([5, 18, 63]) | {"dtype": ["f8"]},
        typed([5, 18, 63]) | {"dtype": None},
        typed([5, 18, 63]) | {"bdata": "AAAA"},
        typed([5, 18, 63]) | {"bdata": "not base 64!"},
        typed([5, 18, 63]) | {"bdata": "κ"},
        typed([5, 18, 63]) | {"bdata": "!" + typed([5, 18, 63])["bdata"]},
        typed([5, 18, 63]) | {"bdata": 17},
        typed([5, 18, 63]) | {"bdata": [1]},
        typed([5, 18, 63]) | {"bdata": None},
        typed([5, 18, 63], order="C"),
        {"dtype": "f8", "shape": "3"},
        {"dtype": "f8"},
        {"shape": "3", "bdata": ""},
        {},
    ],
    ids=str,
)
def test_typed_arrays_that_are_none_are_refused(service, array):
    assert service.wrong_body({**THREE, "kappa": array}).keys() == {"kappa"}


@pytest.mark.parametrize("body", [b'{"kappa":1,"kappa":2,"mu_over_alpha":1,"gt_over_gn":1}'])
def test_repeated_keys_are_refused(service, body):
    assert service.wrong_body(body).keys() == {"kappa"}
