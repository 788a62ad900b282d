"""Tables for other codes: their errors are what they say."""

import numpy as np
import pytest
from scipy.interpolate import interpn

from restitution.errors import CostError, ParameterError
from restitution.mechanics.collision import collide
from restitution.methods.options import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.many import study_batch
from restitution.studies.tables.cost import refuse_costly
from restitution.studies.tables.entries import seconds_for_motion
from restitution.studies.tables.export import study_table, study_table_within
from restitution.studies.tables.grid import DIGITS, TableGrid
from work import counted

SOLIDS = Axis(3.5, 5.7, 60, "log"), Axis(0.05, 2.0, 60, "log")
FIGURE_4 = Axis(0.6, 70.0, 90, "log"), Axis(0.01, 2.0, 90, "log")
LINEAR = Axis(1.0, 30.0, 80), Axis(0.0, 2.0, 80)
GRIDS = pytest.mark.parametrize("axes", [SOLIDS, FIGURE_4, LINEAR], ids=["solids", "fig4", "lin"])
DAMPED = Axis(3.0, 9.0, 24, "log"), Axis(0.05, 2.0, 30, "log"), Axis(0.0, 0.4, 8)
STRONG = Axis(0.5, 20.0, 24, "log"), Axis(0.0, 3.0, 24), Axis(1e-3, 5.0, 12, "log")
THREE = pytest.mark.parametrize(
    "axes", [DAMPED, pytest.param(STRONG, marks=pytest.mark.verify)], ids=["damped", "strong"]
)


def in_three(axes, sign="paper"):
    return study_table(*axes[:2], sign, axes[2], seconds=30)


def interpolated(table, kappa, psi):
    """Bilinear interpolation written anew, by numpy.interp along one axis after the other."""

    def coordinate(axis, values):
        return np.log(values) if axis.scale == "log" else values

    columns = coordinate(table.kappa, table.kappa.values(positive=True))
    rows = coordinate(table.psi, table.psi.values(positive=False))
    x, y = coordinate(table.kappa, kappa), coordinate(table.psi, psi)
    place = np.interp(y, rows, np.arange(rows.size))
    below = np.minimum(place.astype(int), rows.size - 2)
    share = place - below
    column = np.interp(x, columns, np.arange(columns.size))
    left = np.minimum(column.astype(int), columns.size - 2)
    part = column - left
    e = table.epsilon_t
    return (1 - share) * ((1 - part) * e[below, left] + part * e[below, left + 1]) + share * (
        (1 - part) * e[below + 1, left] + part * e[below + 1, left + 1]
    )


@GRIDS
def test_entries_are_exact_to_their_decimals(axes):
    table = study_table(*axes, "paper", seconds=10)
    truth = collide(axes[0].values(positive=True), axes[1].values(positive=False)[:, None])
    assert np.abs(table.epsilon_t - truth.epsilon_t).max() <= 0.51 * 10.0**-DIGITS
    assert table.epsilon_t.shape == (axes[1].count, axes[0].count)


@GRIDS
def test_proven_error_holds_at_points_that_it_was_not_made_from(axes):
    table = study_table(*axes, "paper", seconds=10)
    rng = np.random.default_rng(5)
    cells = 100_000

    def within(axis):
        low, high = axis.minimum, axis.maximum
        share = rng.random(cells)
        if axis.scale == "log":
            return low * (high / low) ** share
        return low + (high - low) * share

    kappa, psi = within(axes[0]), within(axes[1])
    error = np.abs(interpolated(table, kappa, psi) - collide(kappa, psi).epsilon_t).max()
    assert table.error_basis == "proven"
    assert error <= table.largest_error
    # of what is found the bound is 3 times as much at most
    assert table.largest_error <= 3.0 * error


def test_sampled_error_of_a_fine_grid_holds_at_denser_samples():
    axes = Axis(3.0, 6.0, 160, "log"), Axis(0.05, 2.0, 160, "log")
    table = study_table(*axes, "paper", seconds=10)
    shares = (np.arange(8) + 0.5) / 8
    edges = [np.log(axis.values(positive=True)) for axis in axes]
    dense = [np.exp((e[:-1, None] + shares * np.diff(e)[:, None]).ravel()) for e in edges]
    kappa, psi = (values.ravel() for values in np.meshgrid(*dense))
    error = np.abs(interpolated(table, kappa, psi) - collide(kappa, psi).epsilon_t).max()
    assert table.error_basis == "sampled"
    assert error <= table.largest_error <= 2.5 * error


def exact(kappa, psi, damping):
    """Return ε_t by the way that lists of collisions take."""
    batch = study_batch(kappa, 1.0, psi, ("epsilon_t",), Options(method="exact"), damping)
    return batch.columns["epsilon_t"]


@THREE
def test_entries_in_three_parameters_are_exact_with_kappa_fastest(axes):
    table = in_three(axes)
    kappas, psis, etas = (axis.values(positive=False) for axis in axes)
    assert table.epsilon_t.shape == (etas.size, psis.size, kappas.size)
    eta, psi, kappa = np.meshgrid(etas, psis, kappas, indexing="ij")
    truth = exact(kappa.ravel(), psi.ravel(), eta.ravel()).reshape(eta.shape)
    assert np.abs(table.epsilon_t - truth).max() <= 0.51 * 10.0**-DIGITS


@THREE
def test_error_in_three_parameters_holds_at_points_that_it_was_not_made_from(axes):
    table = in_three(axes)
    kappas, psis, etas = (axis.values(positive=False) for axis in axes)
    rng = np.random.default_rng(7)

    def coordinate(axis, values):
        return np.log(values) if axis.scale == "log" else values

    low, high = (np.log(axes[2].minimum), np.log(axes[2].maximum)) if axes[2].scale == "log" else (
        axes[2].minimum, axes[2].maximum)  # fmt: skip
    # few η, each of which takes a normal motion, with many κ and ψ
    places = rng.uniform(low, high, 60)
    worst = 0.0
    for place in places:
        eta = np.exp(place) if axes[2].scale == "log" else place
        kappa = np.exp(rng.uniform(np.log(kappas[0]), np.log(kappas[-1]), 1000))
        psi = rng.uniform(psis[0], psis[-1], 1000)
        found = interpn(
            (coordinate(axes[2], etas), coordinate(axes[1], psis), coordinate(axes[0], kappas)),
            table.epsilon_t,
            np.column_stack(
                [np.full(1000, place), coordinate(axes[1], psi), coordinate(axes[0], kappa)]
            ),
        )
        worst = max(worst, np.abs(found - exact(kappa, psi, eta)).max())
    assert worst <= table.largest_error
    # 60,000 points miss some of the worst one
    assert table.largest_error <= 3.0 * worst


def test_one_damping_for_all_entries_is_a_plane_of_three_parameters():
    plane = study_table(*DAMPED[:2], "paper", 0.4, seconds=10)
    table = in_three(DAMPED)
    assert np.array_equal(plane.epsilon_t, table.epsilon_t[-1])
    assert np.isnan(plane.slides_above)
    undamped = study_table(*DAMPED[:2], "paper", seconds=10)
    assert np.array_equal(undamped.epsilon_t, table.epsilon_t[0])
    assert undamped.slides_above == 2.0


def test_grid_in_three_parameters_chosen_for_an_error_keeps_it():
    table = study_table_within(0.05, *SOLIDS, "paper", Axis(0.0, 0.3, 2), seconds=30)
    assert 0.01 <= table.largest_error <= 0.05
    assert table.damping.count < table.psi.count


@pytest.mark.parametrize("error", [0.1, 0.03, 0.01])
def test_grid_chosen_for_an_error_keeps_it(error):
    table = study_table_within(error, *SOLIDS, "paper", seconds=10)
    assert 0.2 * error <= table.largest_error <= error


def test_reversed_sign_is_the_negative():
    paper = study_table(*LINEAR, "paper", seconds=10)
    other = study_table(*LINEAR, "reversed", seconds=10)
    assert np.array_equal(other.epsilon_t, -paper.epsilon_t)
    assert other.largest_error == paper.largest_error


def test_sliding_is_closed_only_where_it_holds_for_every_kappa():
    assert study_table(*SOLIDS, "paper", seconds=10).slides_above == 2.0
    # ψ* is 2.248 at κ = 0.5
    soft = Axis(0.5, 5.0, 16), Axis(0.1, 2.2, 16)
    assert np.isnan(study_table(*soft, "paper", seconds=10).slides_above)
    beyond = Axis(0.5, 5.0, 16), Axis(0.1, 2.3, 16)
    assert study_table(*beyond, "paper", seconds=10).slides_above == 2.3


@pytest.mark.parametrize(
    ("axes", "words"),
    [
        ((Axis(1.0, 2.0, 10**9), Axis(0.1, 2.0, 10**9)), "1,000,000,000"),
        ((Axis(1e11, 1e12, 10), Axis(0.1, 1.0, 10)), "50,000"),
        ((Axis(1.0, 2.0, 2), Axis(0.1, 2.0, 2), Axis(0.0, 1.0, 10**6)), "1,000,000 would"),
        ((Axis(1e11, 1e12, 10), Axis(0.1, 1.0, 10), Axis(0.0, 1.0, 3)), "50,000"),
    ],
)
def test_costly_tables_are_refused_before_any_work(axes, words):
    with pytest.raises(CostError, match=words):
        study_table(*axes[:2], "paper", *axes[2:], seconds=1.0)


@pytest.mark.parametrize(
    "grid",
    [
        # too soft for lanes
        TableGrid(Axis(2e-4, 0.04, 150), Axis(0.051, 0.052, 100), 0.0),
        TableGrid(Axis(1.0, 70.0, 100), Axis(0.01, 4.0, 100), 0.0),
        TableGrid(Axis(2.0, 3000.0, 18, "log"), Axis(0.8, 4e4, 60, "log"), Axis(0.0, 0.06, 14)),
        TableGrid(Axis(200.0, 2000.0, 5), Axis(0.2, 4000.0, 19, "log"), Axis(0.0, 1e25, 20)),
    ],
)
def test_a_table_takes_no_more_than_is_expected(grid):
    expected = refuse_costly(grid, grid.nodes(), 10.0).table
    with counted() as work:
        study_table(grid.kappa, grid.psi, "paper", grid.damping, seconds=10.0)
    most = grid.damping.maximum if isinstance(grid.damping, Axis) else grid.damping
    assert 1e-9 * work["tables"] + seconds_for_motion(most) * work["dampings"] <= expected


@pytest.mark.parametrize("damping", [-0.1, 1e31, Axis(-1.0, 1.0, 3), Axis(0.5, 0.1, 3)])
def test_damping_out_of_range_is_refused(damping):
    with pytest.raises(ParameterError):
        study_table(*SOLIDS, "paper", damping, seconds=10)


def test_unreachable_error_says_how_far_it_got():
    with pytest.raises(CostError, match="at most so far"):
        study_table_within(1e-6, *FIGURE_4, "paper", seconds=0.3)


def test_an_error_far_out_of_reach_is_refused_before_the_budget_is_spent():
    seconds = 30.0
    with counted() as work, pytest.raises(CostError, match="1e-12 takes about"):
        study_table_within(1e-12, *FIGURE_4, "paper", seconds=seconds)
    assert work.seconds < seconds / 6
