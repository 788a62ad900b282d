"""Collisions for which the phase of the spring is special, to the last bit of κ."""

import math

import pytest

CONTACT_DURATION = 3.2180654597190430845
# half a unit of the last place of κ, and that of √κ t_c, move ε_t by less
ROUNDING = 1e-12


def neighbours(value, count=3):
    """Return the doubles next to `value`, `count` on either side, ascending."""
    below, above = [value], [value]
    for _ in range(count):
        below.append(math.nextafter(below[-1], 0.0))
        above.append(math.nextafter(above[-1], math.inf))
    return [*reversed(below[1:]), *above]


def whole_swings(half_swings):
    """Return κ for which that many half swings of the spring take the contact (model.md §4)."""
    return (half_swings * math.pi / CONTACT_DURATION) ** 2


@pytest.mark.parametrize(
    "psi",
    [
        1e-6,
        2.5e-8,
        1e-10,
        1e-18,
        1e-99,
        5e-324,
    ],
)
def test_epsilon_t_is_plus_or_minus_one_when_the_contact_takes_whole_half_swings(service, psi):
    half_swings = [n for n in range(1, 400) for _ in range(7)]
    kappas = [kappa for n in range(1, 400) for kappa in neighbours(whole_swings(n))]
    answer = service.collisions({"kappa": kappas, "mu_over_alpha": 1, "gt_over_gn": psi})
    for n, kappa, epsilon_t in zip(half_swings, kappas, answer["epsilon_t"], strict=True):
        # the correction of model.md §4, (ψκ^{5/4})^{2/3}
        correction = (psi * kappa**1.25) ** (2 / 3)
        assert abs(epsilon_t - (-1) ** n) <= ROUNDING + correction, (kappa, epsilon_t)


@pytest.mark.parametrize(
    ("kappa", "psi"),
    [
        (38312.34645557157, 1e-99),
        (182417.33729918956, 1e-320),
        (241606.6853497546, 1e-200),
        (343665.5670043276, 1e-320),
    ],
)
def test_epsilon_t_is_answered_when_the_contact_takes_an_odd_quarter_more(service, kappa, psi):
    answer = service.answer("/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=psi)
    assert abs(answer["epsilon_t"]) <= answer["error_bound"]
    assert 2 * CONTACT_DURATION * math.sqrt(kappa) / math.pi % 2 == pytest.approx(1.0, abs=1e-9)


# by tests/validation/high_precision.py: ε_t, switches; none nearer to grazing than 1e-6
@pytest.mark.parametrize(
    ("kappa", "psi", "epsilon_t", "switches"),
    [
        (54365.92026139493, 0.994685096404266, -4.368333192440437e-06, 238),
        (54365.92026139493, 0.9946850964042658, -4.368333192440508e-06, 238),
        (56677.46941170472, 0.9937816345459259, -2.79121968226817e-06, 242),
    ],
)
def test_switches_are_counted_when_sticking_begins_at_the_largest_compression(
    service, kappa, psi, epsilon_t, switches
):
    answer = service.answer("/collision", kappa=repr(kappa), mu_over_alpha=1, gt_over_gn=repr(psi))
    assert answer["switches"] == switches
    assert abs(answer["epsilon_t"] - epsilon_t) <= answer["error_bound"]


@pytest.mark.parametrize(
    ("kappa", "switches"),
    # For ψ → 0 there are 4 where sin and cos of √κ t_c (in 120 digits) differ in sign, else 2.
    [(1.31921e26, 4), (1.53978e27, 4), (1.57677e28, 4)],
)
def test_switches_are_not_certain_where_the_phase_is_lost(service, kappa, switches):
    answer = service.answer("/collision", kappa=kappa, mu_over_alpha=1, gt_over_gn=1e-80)
    assert answer["switches"] == switches or not answer["switches_certain"]
