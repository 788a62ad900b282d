"""The methods by name and `auto`: what they give, what they cannot, and how far they are off."""

import math

import pytest

HIGHEST_CAP = 1.25**0.6
BY_NAME = ("exact", "coulomb", "pragmatic", "stiff", "table", "timestep", "ode")
# soft to stiff, gripping to sliding
POINTS = [
    (0.2, 3.0),
    (0.95, 0.01),
    (5.0, 0.5),
    (18.0, 1.9),
    (63.0, 0.97),
    (400.0, 0.3),
    (18.0, 2.5),
]


def ask(service, kappa, psi, **more):
    return service.answer("/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=psi, **more)


@pytest.mark.parametrize("method", BY_NAME)
@pytest.mark.parametrize(("kappa", "psi"), POINTS)
def test_error_bound_holds_against_the_exact_value(service, method, kappa, psi):
    exact = ask(service, kappa, psi, method="exact")
    answer = ask(service, kappa, psi, method=method)
    assert answer["method"] == method
    assert -1 <= answer["epsilon_t"] <= 1
    distance = abs(answer["epsilon_t"] - exact["epsilon_t"])
    assert distance <= answer["error_bound"] + exact["error_bound"]
    assert answer["tolerance_met"] is (answer["error_bound"] <= 1e-10)


@pytest.mark.parametrize("method", ["coulomb", "pragmatic", "timestep", "ode"])
@pytest.mark.parametrize(("kappa", "psi"), POINTS)
def test_error_bound_of_measured_methods_is_the_distance_and_the_exact_ones_own(
    service, method, kappa, psi
):
    exact = ask(service, kappa, psi, method="exact")
    answer = ask(service, kappa, psi, method=method)
    distance = abs(answer["epsilon_t"] - exact["epsilon_t"])
    assert answer["error_bound"] == pytest.approx(distance + exact["error_bound"], rel=1e-12, abs=0)


@pytest.mark.parametrize(("kappa", "psi"), POINTS)
def test_coulomb_is_cut_off_at_zero(service, kappa, psi):
    answer = ask(service, kappa, psi, method="coulomb", floor=0.5)
    assert answer["epsilon_t"] == pytest.approx(max(0.0, 1 - 2 / psi), abs=1e-15)


@pytest.mark.parametrize("floor", [-1.0, -0.25, 0.0, 0.7, 1.0])
@pytest.mark.parametrize(("kappa", "psi"), POINTS)
def test_pragmatic_is_cut_off_at_its_floor(service, kappa, psi, floor):
    answer = ask(service, kappa, psi, method="pragmatic", floor=floor)
    assert answer["epsilon_t"] == pytest.approx(max(floor, 1 - 2 / psi), abs=1e-15)
    assert answer["parameters"]["floor"] == floor


@pytest.mark.parametrize(("kappa", "psi"), [(0.05, 0.3), (1.5, 1.0), (18.0, 1.9), (2000.0, 0.3)])
def test_stiff_is_zero_within_its_bound(service, kappa, psi):
    answer = ask(service, kappa, psi, method="stiff")
    assert answer["epsilon_t"] == 0.0
    bound = min(1.0, HIGHEST_CAP / (psi * math.sqrt(kappa)))
    assert answer["error_bound"] == pytest.approx(bound, rel=1e-14, abs=0)


# ψ*(κ) of model.md §4, from both sides of its last digit
@pytest.mark.parametrize(("kappa", "threshold"), [(0.5, 2.24847), (0.2, 5.32449), (0.1, 10.478)])
def test_stiff_slides_from_the_threshold_on(service, kappa, threshold):
    above = ask(service, kappa, threshold * 1.0001, method="stiff")
    assert above["epsilon_t"] == pytest.approx(1 - 2 / (threshold * 1.0001), rel=1e-14, abs=0)
    assert above["error_bound"] <= 1e-14
    below = ask(service, kappa, threshold * 0.9999, method="stiff")
    assert below["epsilon_t"] == 0.0
    assert below["error_bound"] == 1.0


@pytest.mark.parametrize("method", ["coulomb", "pragmatic", "stiff", "table"])
@pytest.mark.parametrize("psi", [0.3, 2.5])
def test_simple_laws_give_null_for_what_they_cannot_know(service, method, psi):
    answer = ask(service, 18.0, psi, method=method)
    unknown = ("switches", "switches_certain", "reversals", "episodes", "sensitivity")
    assert {name: answer[name] for name in unknown} == dict.fromkeys(unknown)
    assert answer["energy"]["final"] == pytest.approx(answer["epsilon_t"] ** 2 * psi**2 / 2)
    assert answer["estimates"]["coulomb"] == pytest.approx(max(0.0, 1 - 2 / psi), abs=1e-15)
    assert answer["summary"]


def test_switches_are_null_in_every_call_when_the_method_cannot_count(service):
    cut = service.answer(
        "/cut", along="kappa", mu_over_alpha=1, gt_over_gn=0.5, count=3, method="coulomb"
    )
    assert cut["switches"] == [None] * 3
    grid = service.answer(
        "/map", mu_over_alpha=1, kappa_count=2, gt_over_gn_count=3, method="pragmatic"
    )
    assert grid["switches"] == [[None] * 2] * 3
    many = service.collisions(
        {"kappa": [1, 2], "mu_over_alpha": 1, "gt_over_gn": 0.5, "method": "stiff"}
    )
    assert many["switches"] == [None] * 2


def test_a_method_that_does_not_exist_is_refused_with_those_that_do(service):
    asked = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4, "method": "magic"}
    entry = service.wrong("/collision", **asked)["method"]
    assert entry["value"] == "magic"
    assert all(name in entry["requirement"] for name in ("auto", *BY_NAME))


@pytest.mark.parametrize(
    "option",
    [
        {"steps": 4},
        {"steps": 1_000_000},
        {"integrator": "forward_euler"},
        {"phase": 1},
        {"rtol": 1e-13},
        {"rtol": 0.1},
        {"floor": -1},
    ],
    ids=str,
)
def test_options_of_other_methods_have_no_effect(service, option):
    plain = ask(service, 18.0, 0.4, method="exact")
    answer = ask(service, 18.0, 0.4, method="exact", **option)
    assert {**answer, "parameters": None} == {**plain, "parameters": None}


@pytest.mark.parametrize(
    "option",
    [
        {"steps": 3},
        {"steps": 1_000_001},
        {"steps": 50.5},
        {"integrator": "leapfrog"},
        {"phase": 1.01},
        {"phase": -0.01},
        {"rtol": 0.11},
        {"rtol": 9e-14},
        {"floor": 1.01},
        {"tolerance": 9e-14},
        {"tolerance": 1.01},
    ],
    ids=str,
)
def test_options_of_other_methods_are_checked(service, option):
    collision = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
    ((name, value),) = option.items()
    wrong = service.wrong("/collision", **collision, method="exact", **option)
    assert wrong.keys() == {name}
    assert wrong[name]["value"] == str(value)
    in_body = service.wrong_body({**collision, "method": "exact", **option})
    assert in_body.keys() == {name}
    assert in_body[name]["value"] == value


@pytest.mark.parametrize("tolerance", [1e-13, 1e-10, 1e-3, 0.3, 1])
@pytest.mark.parametrize(("kappa", "psi"), [*POINTS, (1e4, 0.01), (1e6, 1.0)])
def test_auto_is_within_its_tolerance_or_says_that_it_is_not(service, tolerance, kappa, psi):
    exact = ask(service, kappa, psi, method="exact")
    for quantities in ("epsilon_t", "epsilon_t,switches,reversals,episodes,sensitivity"):
        answer = ask(service, kappa, psi, tolerance=tolerance, quantities=quantities)
        assert answer["tolerance_met"] is (answer["error_bound"] <= tolerance)
        distance = abs(answer["epsilon_t"] - exact["epsilon_t"])
        assert distance <= answer["error_bound"] + exact["error_bound"]
        # never worse than the best there is
        assert answer["error_bound"] <= max(tolerance, exact["error_bound"])


def test_auto_is_cheap_when_the_tolerance_allows(service):
    assert ask(service, 2000.0, 1.0, tolerance=0.05, quantities="epsilon_t")["method"] == "stiff"
    assert ask(service, 2000.0, 1.0, tolerance=1e-4, quantities="epsilon_t")["method"] == "exact"
    assert ask(service, 18.0, 2.5, quantities="epsilon_t")["method"] == "stiff"


@pytest.mark.parametrize("quantity", ["switches", "reversals", "episodes", "sensitivity"])
def test_auto_delivers_what_only_the_exact_method_can(service, quantity):
    answer = ask(service, 2000.0, 1.0, tolerance=1, quantities=quantity)
    assert answer[quantity] is not None
    assert answer["method"] == "exact"


@pytest.mark.parametrize(
    ("kappa", "psi"),
    [(0.0099, 1.0), (1001.0, 1.0), (18.0, 0.0009), (18.0, 1001.0), (1e300, 1e-300)],
)
def test_table_is_refused_outside_its_range_with_what_is_allowed(service, kappa, psi):
    collision = {"mu_over_alpha": 1, "method": "table"}
    refusals = [
        service.wrong("/collision", kappa=kappa, gt_over_gn=psi, **collision),
        service.wrong(
            "/cut", along="kappa", minimum=1, maximum=kappa, count=2, gt_over_gn=psi, **collision
        )
        if kappa > 1
        else service.wrong("/collision", kappa=kappa, gt_over_gn=psi, **collision),
        service.wrong_body({"kappa": [1.0, kappa], "gt_over_gn": [1.0, psi], **collision}),
    ]
    for wrong in refusals:
        assert wrong.keys() == {"method"}
        assert wrong["method"]["value"] == "table"
        allowed = "kappa from 0.01 to 1000 and psi = gt_over_gn/mu_over_alpha from 0.001 to 1000"
        assert allowed in wrong["method"]["requirement"]


def test_table_holds_the_limits_of_no_velocity_and_no_friction(service):
    assert ask(service, 18.0, 0.0, method="table")["epsilon_t"] == pytest.approx(
        math.cos(math.sqrt(18.0) * 3.2180654597190431), abs=1e-13
    )
    free = service.answer("/collision", kappa=18, mu_over_alpha=0, gt_over_gn=1, method="table")
    assert free["epsilon_t"] == 1.0


def test_map_for_the_screen_reads_the_table_and_says_so(service):
    grid = {"mu_over_alpha": 1.4, "quantities": "epsilon_t", "tolerance": 4e-3}
    answer = service.answer("/map", **grid)
    assert answer["method"] == "mixed"
    assert answer["tolerance_met"] is True
    assert 1e-6 < answer["error_bound"] <= 4e-3
    grid["quantities"] = "epsilon_t,error"
    by_name = service.answer("/map", **grid, method="table")
    assert by_name["method"] == "table"
    worst = max(abs(error) for row in by_name["error"] for error in row)
    assert 1e-9 < worst <= by_name["error_bound"] <= 4e-3


def test_method_of_a_map_is_mixed_when_several_answered(service):
    grid = {"mu_over_alpha": 1, "quantities": "epsilon_t", "tolerance": 0.3}
    answer = service.answer("/map", **grid)
    assert answer["method"] == "mixed"
    assert 1e-10 < answer["error_bound"] <= 0.3
    assert answer["tolerance_met"] is True


def test_auto_answers_with_its_true_bound_when_none_can(service):
    answer = ask(service, 1e32, 1e-39)
    assert answer["tolerance_met"] is False
    assert answer["error_bound"] == pytest.approx(0.448484, rel=1e-5, abs=0)
    assert abs(answer["epsilon_t"]) <= answer["error_bound"]
    assert answer["switches"] is None


@pytest.mark.parametrize("method", ["auto", "coulomb", "stiff"])
def test_error_is_null_where_the_exact_value_is_unknown(service, method):
    # |ε_t| may be anything up to 1 here
    cut = {"along": "kappa", "gt_over_gn": 1e-37, "minimum": 18, "maximum": 1e29, "count": 2}
    answer = service.answer(
        "/cut", mu_over_alpha=1, method=method, quantities="epsilon_t,error", **cut
    )
    assert answer["error_bound"] == 1.0
    assert answer["error"][1] is None


@pytest.mark.parametrize(
    ("kappa", "psi", "method"), [(1e32, 1e-39, "auto"), (18, 0.3, "stiff"), (18, 0.3, "coulomb")]
)
def test_summary_claims_no_more_than_the_error_bound_allows(service, kappa, psi, method):
    answer = ask(service, kappa, psi, method=method)
    assert answer["error_bound"] > 0.3
    assert "almost nothing" not in answer["summary"].lower()


@pytest.mark.parametrize(
    ("path", "more"),
    [
        ("/collision", {"kappa": 1e20, "gt_over_gn": 1}),
        ("/trace", {"kappa": 1e20, "gt_over_gn": 1}),
        ("/cut", {"along": "gt_over_gn", "kappa": 1e20}),
        ("/map", {"kappa_max": 1e20}),
    ],
)
def test_exact_by_name_is_refused_beyond_its_budget_with_cost_and_limit(service, path, more):
    problem = service.refused(path, 413, mu_over_alpha=1, method="exact", **more)
    cost = [word for word in problem["detail"].split() if any(c.isdigit() for c in word)]
    assert len(cost) >= 2, problem["detail"]
