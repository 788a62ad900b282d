"""The table: no answer outside its own bound, wherever one looks; its file; what it refuses."""

import io
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from restitution.errors import ParameterError
from restitution.mechanics.collision import collide
from restitution.mechanics.limits import FROM_TWO_ON, sliding_threshold, weak_limit
from restitution.mechanics.patches import FLOOR, SPAN, UNDIVIDED
from restitution.methods import table
from restitution.methods.options import Options
from samples import borders, log_uniform

LOWEST, HIGHEST = np.array([table.KAPPA_RANGE, table.PSI_RANGE]).T


def everywhere(rng, count):
    return log_uniform(rng, *table.KAPPA_RANGE, count), log_uniform(rng, *table.PSI_RANGE, count)


def figure_4(rng, count):
    return rng.uniform(0.1, 70.0, count), rng.uniform(0.01, 4.0, count) / 1.4


def next_to_two(rng, count):
    return log_uniform(rng, *table.KAPPA_RANGE, count), 2.0 - 10 ** rng.uniform(-15, 0, count)


def next_to_pure_sliding(rng, count):
    kappa = log_uniform(rng, table.KAPPA_RANGE[0], 1.0, count)
    return kappa, sliding_threshold(kappa) * (1.0 + rng.normal(size=count) * 0.03)


def next_to_borders(rng, count):
    """Points at 1e-12 … 1e-2 of ψ from a change of the number of switches, found by halving."""
    kappa = log_uniform(rng, 1.0, table.KAPPA_RANGE[1], count)
    low = log_uniform(rng, table.PSI_RANGE[0], 1.9, count)
    high = np.minimum(1.999, low * 1.1)
    kappa, low, _ = borders(kappa, low, high, 45)
    away = 10 ** rng.uniform(-12, -2, low.size) * rng.choice([-1, 1], low.size)
    return kappa, np.clip(low * (1.0 + away), *table.PSI_RANGE)


def next_to_patch_edges(rng, count):
    """Points on and beside the dyadic numbers that bound patches."""
    kappa, psi = (
        (1.0 + rng.integers(0, 256, count) / 256) * 2.0 ** rng.integers(-7, 10, count)
        for _ in range(2)
    )
    psi = np.where(rng.random(count) < 0.5, psi, 2.0 - (psi % 1.0 - FLOOR) / SPAN)
    kappa, psi = (a * (1.0 + 1e-15 * rng.integers(-2, 3, count)) for a in (kappa, psi))
    return np.clip(kappa, *table.KAPPA_RANGE), np.clip(psi, *table.PSI_RANGE)


SAMPLES = [
    everywhere,
    figure_4,
    next_to_two,
    next_to_pure_sliding,
    next_to_borders,
    next_to_patch_edges,
]


def errors(kappa, psi):
    """Return the errors of the table beyond the exact method's own, and their bounds."""
    answer = table.solve(kappa, psi, Options(method="table"))
    truth = collide(kappa, psi)
    assert np.all(np.abs(answer.epsilon_t) <= 1.0)
    return np.abs(answer.epsilon_t - truth.epsilon_t) - truth.error_bound, answer.error_bound


@pytest.mark.parametrize("sample", SAMPLES)
def test_no_answer_leaves_its_own_bound(sample):
    error, bound = errors(*sample(np.random.default_rng(7), 20_000))
    assert np.all(error <= bound)
    assert bound.max() <= table.table().bounds.max()


@pytest.mark.verify
@pytest.mark.parametrize("sample", SAMPLES)
def test_no_answer_of_millions_leaves_its_own_bound(sample):
    for seed in range(10):
        error, bound = errors(*sample(np.random.default_rng(seed), 1_000_000))
        assert np.all(error <= bound)


@pytest.mark.verify
def test_no_answer_leaves_its_own_bound_in_the_patches_with_the_largest():
    """Sixteen unseen points in each of the patches that a million points find worst."""
    rng = np.random.default_rng(16)
    kappa, psi = everywhere(rng, 4_000_000)
    _, bound = table.read(kappa, psi)
    worst = np.repeat(np.argsort(bound)[-50_000:], 16)
    kappa, psi = (a[worst] * (1.0 + 1e-3 * rng.normal(size=worst.size)) for a in (kappa, psi))
    error, bound = errors(np.clip(kappa, *table.KAPPA_RANGE), np.clip(psi, *table.PSI_RANGE))
    assert np.all(error <= bound)


@pytest.mark.parametrize("sample", [everywhere, figure_4])
def test_error_is_below_a_ten_thousandth_in_99_of_100_cases(sample):
    error, bound = errors(*sample(np.random.default_rng(99), 50_000))
    assert np.quantile(error, 0.99) < 1e-5
    assert np.quantile(bound, 0.99) < 1e-4


def test_certified_worst_case_is_what_the_documents_say():
    assert 2e-3 < table.table().bounds.max() <= 2.5e-3


def test_bound_would_notice_a_wrong_patch(monkeypatch):
    whole = table.table()
    wrong = whole.patches.copy()
    wrong[:, 0] += 3e-3
    monkeypatch.setattr(table, "_loaded", [table.Table(whole.division, wrong, whole.bounds)])
    error, bound = errors(*figure_4(np.random.default_rng(0), 2_000))
    assert np.mean(error > bound) > 0.5


@pytest.mark.parametrize("kappa", [LOWEST[0], 0.5, FROM_TWO_ON, 0.5701023, 1.0, HIGHEST[0]])
@pytest.mark.parametrize(
    "psi", [LOWEST[1], 1.0, np.nextafter(1, 0), 2.0, np.nextafter(2, 0), 2.2, 114.0, HIGHEST[1]]
)
def test_corners_belong_to_the_table(kappa, psi):
    error, bound = errors(np.array([kappa]), np.array([psi]))
    assert error[0] <= bound[0] < 1e-3


def test_limits_are_closed_forms():
    kappa = np.array([0.01, 18.0, 1000.0])
    weak = table.solve(kappa, np.zeros(3), Options(method="table"))
    np.testing.assert_array_equal(weak.epsilon_t, weak_limit(kappa))
    free = table.solve(kappa, np.full(3, np.inf), Options(method="table"))
    np.testing.assert_array_equal(free.epsilon_t, 1.0)
    assert np.all(weak.error_bound < 1e-12)
    assert np.all(free.error_bound < 1e-12)


@pytest.mark.parametrize(
    ("kappa", "psi"), [(9.9e-3, 1.0), (1001.0, 1.0), (1.0, 9e-4), (1.0, 1001.0), (2e-3, 0.0)]
)
def test_what_lies_outside_is_refused_with_what_is_allowed(kappa, psi):
    with pytest.raises(ParameterError, match=r"0\.01 to 1000 .* 0\.001 to 1000") as refusal:
        table.solve(np.array([1.0, kappa]), np.array([1.0, psi]), Options(method="table"))
    assert refusal.value.parameter == "method"
    assert f"kappa = {kappa:g}, psi = {psi:g}" in refusal.value.requirement


@pytest.fixture
def nothing_loaded(monkeypatch, tmp_path):
    """An empty cache, and builds that are counted and cost nothing."""
    builds = []
    small = table.Table(
        np.zeros(UNDIVIDED, np.int32), np.ones((1, 16), np.float32), np.ones(1, np.float32)
    )

    def build():
        builds.append(1)
        return small

    monkeypatch.setattr(table, "_loaded", [])
    monkeypatch.setattr(table, "CACHE_FOLDER", str(tmp_path))
    monkeypatch.setattr(table, "build", build)
    return builds


def test_table_is_built_once_and_kept(nothing_loaded, tmp_path):
    first = table.table()
    assert table.table() is first
    table._loaded.clear()
    again = table.table()
    for name, array in vars(first).items():
        np.testing.assert_array_equal(getattr(again, name), array)
    assert len(nothing_loaded) == 1
    assert [file.suffix for file in tmp_path.iterdir()] == [".npz"]


def another_table(_):
    """Return a file that numpy reads, with what no table has."""
    content = io.BytesIO()
    np.savez(content, division=np.zeros(3), patches=np.ones((1, 7)), bounds=np.ones(1))
    return content.getvalue()


@pytest.mark.parametrize(
    "damage",
    [
        lambda b: b[: len(b) // 2],
        lambda _: b"",
        lambda b: b[:900] + b"?" + b[901:],
        another_table,
    ],
)
def test_damaged_file_is_replaced(nothing_loaded, damage):
    table.table()
    whole = table._file().read_bytes()
    table._file().write_bytes(damage(whole))
    table._loaded.clear()
    table.table()
    assert len(nothing_loaded) == 2
    assert table._file().read_bytes() == whole


def test_table_is_built_once_however_many_ask(nothing_loaded):
    with ThreadPoolExecutor(8) as pool:
        tables = list(pool.map(lambda _: table.table(), range(64)))
    assert len(nothing_loaded) == 1
    assert all(found is tables[0] for found in tables)


def test_table_does_without_a_folder(nothing_loaded, monkeypatch, tmp_path):
    monkeypatch.setattr(table, "CACHE_FOLDER", "")
    assert table.table().bounds.size == 1
    monkeypatch.setattr(table, "CACHE_FOLDER", str(tmp_path / "gone"))
    table._loaded.clear()
    assert table.table().bounds.size == 1
    assert len(nothing_loaded) == 2
