"""docs/numerics.md holds: its tables, and what it says of errors, slopes and counts."""

import math
import re

import make_numerics
import pytest
from high_precision import collide
from make_collisions import exact
from make_numerics import NEIGHBOURS, UNIT

from cases import every_day


@pytest.fixture(scope="module")
def rows():
    return make_numerics.measured(make_numerics.read())


@pytest.fixture(scope="module")
def tables(rows):
    return make_numerics.tables(rows)


def number(cell):
    return 0.0 if cell == "·" else float(cell)


@pytest.mark.parametrize("name", ["Neighbours", "Switches"])
def test_counts_are_those_of_the_document(tables, name):
    # an uncertain count is a guess, and another processor may guess otherwise
    printed, fresh = (
        re.sub(r"\d+ \?", "?", text) for text in (make_numerics.printed(name), tables[name])
    )
    assert fresh == printed


@pytest.mark.parametrize("name", ["Errors", "Condition"])
def test_powers_of_ten_are_those_of_the_document(tables, name):
    here, there = tables[name].splitlines(), make_numerics.printed(name).splitlines()
    assert here[:2] == there[:2]
    assert len(here) == len(there)
    for ours, printed in zip(here[2:], there[2:], strict=True):
        for cell, before in zip(ours.split(" | ")[1:], printed.split(" | ")[1:], strict=True):
            cell, before = cell.strip(" |"), before.strip(" |")  # noqa: PLW2901
            if cell in "–?" or before in "–?":
                assert cell == before, printed
            else:
                # another processor rounds otherwise: next to a power of ten by one power
                assert abs(number(cell) - number(before)) <= 1, printed


def cells(line):
    return line.strip("| ").split(" | ")


def test_pairs_are_those_of_the_document(tables):
    fresh, printed = tables["Pairs"].splitlines(), make_numerics.printed("Pairs").splitlines()
    assert fresh[:2] == printed[:2]
    for line, before in zip(fresh[2:], printed[2:], strict=True):
        kappa, psi, epsilon_t, lost, bound, *slopes, switches, method, truth = cells(line)
        known = cells(before)
        assert [kappa, psi, bound, switches, method, truth] == [*known[:2], known[4], *known[7:]]
        if slopes == ["–", "–"]:
            assert cells(line) == known
            continue
        assert abs(number(lost) - number(known[3])) <= 1
        rounding = 2 * float(bound)
        value = pytest.approx(float(known[2]), rel=1e-5, abs=rounding)
        assert float(epsilon_t) == value
        # slopes are printed with three digits, and go with the phase √κ t
        rounding *= 1 + math.sqrt(float(kappa))
        for slope, slope_before in zip(slopes, known[5:7], strict=True):
            assert float(slope) == pytest.approx(float(slope_before), rel=1e-2, abs=rounding)


def test_no_error_exceeds_its_bound(rows):
    for pair, (truth, ours, error) in rows.items():
        known = 0.0 if truth.made == "bound" and ours.switches is None else truth.uncertainty
        assert error <= ours.error_bound + known, pair


def test_known_errors_are_a_fifth_of_their_bounds_at_most(rows):
    followed = [row for row in rows.values() if row.truth.made != "bound"]
    assert len(followed) == 170
    assert max(row.error / row.ours.error_bound for row in followed) < 0.2


def test_answers_are_right_to_the_last_digit_where_the_document_says_so(rows):
    told = [
        (pair, row)
        for pair, row in rows.items()
        if (pair[0] <= 1 or pair[1] >= 2 or pair[1] * math.sqrt(pair[0]) >= 0.9)
        and row.truth.made != "bound"
    ]
    assert len(told) > 140
    for pair, row in told:
        assert row.error <= UNIT, pair


def test_slopes_are_the_difference_quotients_of_high_precision(rows):
    compared = 0
    for pair, (truth, ours, _) in rows.items():
        if truth.slopes is None or ours.sensitivity is None:
            continue
        # ∂ε_t/∂ln κ is a phase, √κ t, times what a phase does
        phase = 1 + math.sqrt(pair[0])
        by_kappa, by_psi = truth.slopes
        allowed = 0.5 * ours.error_bound * phase
        assert ours.sensitivity.kappa == pytest.approx(by_kappa, rel=0, abs=allowed), pair
        assert ours.sensitivity.psi == pytest.approx(by_psi, rel=0, abs=ours.error_bound), pair
        compared += 1
    assert compared > 160


def test_slopes_stay_within_their_limits(rows):
    for (kappa, psi), (_, ours, _) in rows.items():
        if ours.sensitivity:
            assert abs(ours.sensitivity.psi) <= 2
            amplitude = min(1.0, 1.25**0.6 / psi / math.sqrt(kappa))
            assert abs(ours.sensitivity.kappa) <= 1.61 * math.sqrt(kappa) * amplitude


def test_certain_counts_are_right(rows):
    certain = [
        (pair, row)
        for pair, row in rows.items()
        if row.ours.switches_certain and row.truth.switches is not None
    ]
    assert len(certain) == 161
    for pair, row in certain:
        assert row.ours.switches == row.truth.switches, pair


# of the references alone, without the library
@pytest.mark.verify
def test_limits_of_the_document_are_those_of_the_walk():
    # a limit and the walk meet where both hold: 70 digits are enough for ψ = 1e-50
    free, soft = make_numerics.truth(63.0, 1e-50), make_numerics.truth(1e-32, 1.0)
    assert (free.made, soft.made) == ("free", "soft")
    for known in (free, soft):
        walk = make_numerics.walked(known.kappa, known.psi)
        assert walk.switches == known.switches
        assert walk.error(float(known.epsilon_t)) <= 1e-16
        assert known.slopes == pytest.approx(walk.slopes, rel=1e-12, abs=1e-30)


@pytest.mark.parametrize(
    ("kappa", "psi", "here", "there"), every_day(NEIGHBOURS[:1], of=NEIGHBOURS[:4])
)
def test_neighbouring_doubles_have_different_true_counts(kappa, psi, here, there):
    following = math.nextafter(psi, math.inf)
    assert collide(exact(kappa), exact(psi), digits=30).switches == here
    assert collide(exact(kappa), exact(following), digits=30).switches == there


@pytest.mark.parametrize(("kappa", "psi", "here", "there"), NEIGHBOURS)
def test_no_count_beside_a_border_is_wrong_and_certain(kappa, psi, here, there):
    at = psi
    for true in (here, there):
        away = math.inf if true == there else -math.inf
        for _ in range(100):
            found = make_numerics.studied(kappa, at)
            assert found.switches == true or not found.switches_certain, at
            at = math.nextafter(at, away)
        at = math.nextafter(psi, math.inf)
