"""What the texts of the lesson state as numbers is what the service answers."""

import pytest

STOPPED = 0.02
GEAR_WHEEL = -0.99


def test_friction_takes_twice_mu_over_alpha_and_no_more(service):
    start = {"kappa": 4.5, "mu_over_alpha": 1.4}
    for gt in (2.8, 3, 4):
        answer = service.answer("/collision", gt_over_gn=gt, **start)
        assert answer["switches"] == 0
        assert gt * (1 - answer["epsilon_t"]) == pytest.approx(2 * 1.4, rel=1e-12)
    below = service.answer("/collision", gt_over_gn=2.6, **start)
    assert below["epsilon_t"] < -STOPPED


def test_three_turns_take_a_kappa_of_35(service):
    turns = {
        kappa: service.answer("/collision", kappa=kappa, mu_over_alpha=1.4, gt_over_gn=1.5)
        for kappa in (34, 35, 36, 50, 63)
    }
    assert {kappa: answer["reversals"] >= 3 for kappa, answer in turns.items()} == {
        34: False,
        35: True,
        36: True,
        50: True,
        63: True,
    }


def test_a_smaller_impact_turns_round_more_often_but_at_kappa_4_5_no_more_than_twice(service):
    def turns(kappa):
        impacts = (1.5, 1, 0.5, 0.2, 0.1, 0.05, 0.01)
        answers = (
            service.answer("/collision", kappa=kappa, mu_over_alpha=1.4, gt_over_gn=gt)
            for gt in impacts
        )
        return [answer["reversals"] for answer in answers]

    for kappa in (4.5, 10, 20, 34):
        counts = turns(kappa)
        assert counts == sorted(counts)
        assert counts[-1] > counts[0]
    assert max(turns(4.5)) == 2
    assert max(turns(10)) == 3


def test_a_smaller_impact_sticks_from_sooner_on(service):
    first = [
        service.answer("/collision", kappa=20, mu_over_alpha=1.4, gt_over_gn=gt)["episodes"][0]
        for gt in (1.5, 1, 0.5, 0.1)
    ]
    ends = [episode["end"] for episode in first]
    assert ends == sorted(ends, reverse=True)


def test_the_force_follows_the_cap_while_sliding_and_is_below_it_while_sticking(service):
    trace = service.answer("/trace", kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358)
    for regime, normal, tangential in zip(
        trace["regime"],
        trace["normal_force"],
        trace["tangential_force_over_mu"],
        strict=True,
    ):
        if regime == 0:
            assert abs(tangential) <= normal + 1e-12
        else:
            assert abs(tangential) == pytest.approx(normal, abs=1e-12)


def test_what_is_to_be_predicted_is_what_comes(service):
    def of(kappa, gt):
        return service.answer("/collision", kappa=kappa, mu_over_alpha=1.4, gt_over_gn=gt)

    assert of(4.5, 4)["epsilon_t"] == pytest.approx(0.3)
    assert of(4.5, 1.5)["reversals"] == 1
    assert of(10, 1)["estimates"]["coulomb"] == 0
    assert of(10, 1)["epsilon_t"] > 0.2
    assert of(4.5, 0.2)["epsilon_t"] > 0.9


def test_the_stiff_limit_falls_316_times_from_kappa_10_to_1000_along_the_cut(service):
    cut = service.answer(
        "/cut",
        along="kappa",
        mu_over_alpha=1.4,
        gt_over_gn=1,
        minimum=10,
        maximum=1000,
        count=3,
        scale="log",
        quantities="stiff_asymptote,stiff_bound",
    )
    first, _, last = cut["stiff_asymptote"]
    assert first / last == pytest.approx(100**1.25, rel=1e-12)
    assert cut["stiff_bound"][0] / cut["stiff_bound"][2] == pytest.approx(10, rel=1e-12)
    assert all(a < b for a, b in zip(cut["stiff_asymptote"], cut["stiff_bound"], strict=True))


@pytest.mark.parametrize(("mu", "gt"), [(1.4, 2.8), (0.5, 1)])
def test_coulombs_law_is_exact_from_psi_2_on(service, mu, gt):
    exact = service.answer("/collision", kappa=10, mu_over_alpha=mu, gt_over_gn=gt)
    assert (exact["switches"], exact["epsilon_t"]) == (0, exact["estimates"]["coulomb"])
    sticks = service.answer("/collision", kappa=10, mu_over_alpha=mu, gt_over_gn=0.99 * gt)
    assert sticks["switches"] > 0


def test_the_gear_wheel_lies_between_kappa_0_90_and_1_07(service):
    def epsilon_t(kappa):
        answer = service.answer("/collision", kappa=kappa, mu_over_alpha=1.4, gt_over_gn=0.2)
        return answer["epsilon_t"]

    assert all(epsilon_t(kappa) <= GEAR_WHEEL for kappa in (0.90, 0.95, 1, 1.07))
    assert all(epsilon_t(kappa) > GEAR_WHEEL for kappa in (0.89, 1.08))
    assert epsilon_t(4.5) > 0.9, "where the step starts"


def test_the_largest_epsilon_t_falls_300_times_for_a_spring_100_times_as_stiff(service):
    def largest(kappa):
        axis = {"minimum": 0.01, "maximum": 1.99, "count": 20_000, "scale": "log"}
        cut = service.answer(
            "/cut", along="gt_over_gn", kappa=kappa, mu_over_alpha=1, quantities="epsilon_t", **axis
        )
        return max(
            abs(epsilon_t) * psi
            for epsilon_t, psi in zip(cut["epsilon_t"], cut["values"], strict=True)
        )

    assert largest(100) / largest(10_000) == pytest.approx(300, rel=0.06)


def test_the_same_psi_is_the_same_bounce(service):
    keys = ("epsilon_t", "switches", "contact_duration", "reversals")
    one = service.answer("/collision", kappa=18, mu_over_alpha=1.4, gt_over_gn=0.7)
    other = service.answer("/collision", kappa=18, mu_over_alpha=2.8, gt_over_gn=1.4)
    assert [one[key] for key in keys] == [other[key] for key in keys]


def test_the_first_sticking_of_a_damped_bounce_is_as_short_as_is_said(service):
    answer = service.answer("/collision", kappa=18, mu_over_alpha=1.4, gt_over_gn=0.7, damping=0.3)
    first = answer["episodes"][0]
    assert first["regime"] == "sticking"
    assert first["end"] == pytest.approx((0.3 / (18 * 0.5)) ** 2, rel=0.02)
    assert answer["switches"] % 2 == 1


def test_150_time_steps_are_enough_and_20_have_the_wrong_sign(service):
    def stepped(steps):
        collision = {"kappa": 63, "mu_over_alpha": 1.4, "gt_over_gn": 0.2}
        return service.answer("/collision", method="timestep", steps=steps, **collision)

    exact = service.answer("/collision", kappa=63, mu_over_alpha=1.4, gt_over_gn=0.2)
    assert stepped(20)["epsilon_t"] * exact["epsilon_t"] < 0
    assert stepped(100)["error_bound"] > 1e-3 >= stepped(150)["error_bound"]
    assert stepped(70)["error_bound"] > stepped(50)["error_bound"]
    assert stepped(209)["error_bound"] > 1e-3
    enough = [*range(210, 420), 500, 700, 1000, 2000, 5000]
    assert max(stepped(steps)["error_bound"] for steps in enough) < 1e-3
