"""`normal_restitution` in place of `damping`: the same answers, refusals in words, its costs."""

import pytest

from restitution.mechanics.contact import damping_of
from work import counted

COLLISION = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 1.358}
CALLS = {
    "/collision": COLLISION,
    "/trace": COLLISION | {"samples": 20},
    "/cut": {"along": "kappa", "mu_over_alpha": 1.4, "gt_over_gn": 0.4, "count": 5},
    "/map": {"mu_over_alpha": 1.4, "kappa_count": 4, "gt_over_gn_count": 3},
    "/steps": COLLISION | {"error": 0.05},
}


@pytest.mark.parametrize("path", CALLS)
def test_answer_is_that_of_the_damping_which_it_echoes(service, path):
    answer = service.answer(path, **CALLS[path], normal_restitution=0.9)
    damping = answer.get("parameters", answer)["damping"]
    assert damping == pytest.approx(0.09283811, abs=5e-9)
    same = service.answer(path, **CALLS[path], damping=repr(damping))
    assert {name: answer[name] for name in same} == same
    if path != "/steps":
        assert answer["epsilon_n"] == pytest.approx(0.9, rel=0, abs=4e-15)


def test_table_is_that_of_the_damping_found(service):
    small = {"kappa_count": 3, "psi_count": 3, "format": "python"}
    one = service.get("/table", **small, normal_restitution=0.9)
    assert one.status_code == 200
    assert one.text == service.get("/table", **small, damping=repr(damping_of(0.9))).text


def test_lists_may_have_one_for_each_collision(service):
    body = {"kappa": [18, 63, 63, 5], "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
    restitutions = [1.0, 0.9, 0.5, 0.9]
    answer = service.collisions(body | {"normal_restitution": restitutions})
    assert answer["damping"] == [damping_of(each) for each in restitutions]
    same = service.collisions(body | {"damping": answer["damping"]})
    assert "damping" not in same
    assert {name: answer[name] for name in same} == same
    one = service.collisions(body | {"normal_restitution": 0.9})
    assert one["damping"] == [damping_of(0.9)] * 4


def test_one_is_no_damping(service):
    plain = service.answer("/collision", **COLLISION)
    assert service.answer("/collision", **COLLISION, normal_restitution=1) == plain


@pytest.mark.parametrize("path", [*CALLS, "/table"])
def test_both_at_once_are_refused_in_words(service, path):
    wrong = service.wrong(path, **CALLS.get(path, {}), damping=0, normal_restitution=0.9)
    assert wrong.keys() == {"normal_restitution"}
    assert wrong["normal_restitution"]["requirement"] == "left out, as damping is given"


def test_both_at_once_are_refused_in_lists_and_beside_an_axis(service):
    body = COLLISION | {"damping": [0.1], "normal_restitution": [0.9], "kappa": -1}
    wrong = service.wrong_body(body)
    assert wrong.keys() == {"kappa", "normal_restitution"}
    assert "as damping is given" in wrong["normal_restitution"]["requirement"]
    wrong = service.wrong("/table", damping_max=1, normal_restitution=0.9)
    assert wrong["normal_restitution"]["requirement"] == "left out, as damping_max is given"


@pytest.mark.parametrize("value", ["0", "-0.5", "1.0000001", "1e-60", "NaN", "90 %"])
def test_restitution_out_of_range_is_refused_in_words(service, value):
    for path, given in CALLS.items():
        wrong = service.wrong(path, **given, normal_restitution=value)
        assert wrong["normal_restitution"]["requirement"] == "from 1.5e-50 to 1"
    wrong = service.wrong_body(COLLISION | {"normal_restitution": [0.9, 2.0]})
    assert wrong["normal_restitution[1]"]["requirement"] == "from 1.5e-50 to 1"


@pytest.mark.parametrize("method", ["stiff", "table"])
def test_methods_without_damping_refuse_it_before_it_is_found(service, method):
    given = COLLISION | {"method": method, "normal_restitution": 0.9}
    send = {
        "/collision": lambda: service.get("/collision", **given),
        "/collisions": lambda: service.post(given),
    }
    for path, ask in send.items():
        (error,) = service.problem(service.affordable(ask), 422)["errors"]
        assert "normal_restitution below 1: the " in error["requirement"], path
    assert service.answer("/collision", **given | {"normal_restitution": 1})["method"] == method


def test_steps_of_a_region_have_a_damping_of_their_own(service):
    wrong = service.wrong("/steps", region="damped", normal_restitution=0.9)
    assert "region" in wrong["normal_restitution"]["requirement"]


def test_many_collisions_of_one_restitution_cost_few_normal_motions(service):
    damping_of.cache_clear()
    given = CALLS["/map"] | {"kappa_count": 100, "gt_over_gn_count": 100, "tolerance": 0.1}
    with counted() as work:
        response = service.affordable(
            lambda: service.get("/map", **given, normal_restitution=0.3217)
        )
    assert response.status_code == 200
    # up to three to find it, and its own
    assert work["dampings"] <= 4


def test_lists_of_many_different_restitutions_are_refused_before_any_work(service):
    many = [0.1 + 1e-4 * n for n in range(501)]
    body = COLLISION | {"normal_restitution": many}
    response = service.affordable(lambda: service.post(body))
    assert "501" in service.problem(response, 413)["detail"]
    assert "500" in service.problem(response, 413)["detail"]
    assert service.post(COLLISION | {"normal_restitution": many[1:]}).status_code == 200


def test_what_is_refused_or_known_takes_no_normal_motion(service):
    damping_of.cache_clear()
    tag = service.get("/collision", **COLLISION, normal_restitution=0.7654).headers["etag"]
    damping_of.cache_clear()
    with counted() as work:
        known = service.get(
            "/collision", {"If-None-Match": tag}, **COLLISION, normal_restitution=0.7654
        )
        wrong = service.get("/cut", along="kappa", mu_over_alpha=-1, normal_restitution=0.7654)
        large = service.get("/table", kappa_count=10**6, normal_restitution=0.7654)
    assert [known.status_code, wrong.status_code, large.status_code] == [304, 422, 413]
    assert not work["dampings"]
