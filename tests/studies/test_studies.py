"""What scenes show: consistency between the views of one collision."""

import urllib.parse

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import restitution
from restitution.errors import CostError, ParameterError
from restitution.methods.options import Options
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.cut import study_cut
from restitution.studies.collision.grid import study_grid
from restitution.studies.collision.many import study_batch
from restitution.studies.collision.one import QUANTITIES, study_collision
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.presets import PRESETS
from restitution.studies.collision.trace import study_trace
from restitution.studies.spheres.bodies import Sphere
from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Velocities


def test_trace_ends_with_epsilon_t_and_obeys_newton():
    parameters = CollisionParameters(63.0, 1.4, 1.358)
    study = study_trace(parameters, samples=4001)
    velocity, time = study.columns["tangential_velocity"], study.columns["time"]
    force = study.columns["tangential_force_over_mu"]
    assert velocity[-1] / velocity[0] == pytest.approx(study.collision.epsilon_t, abs=1e-14)
    step = np.diff(time)
    impulse = 1.4 * np.cumsum(0.5 * step * (force[1:] + force[:-1]))
    np.testing.assert_allclose(velocity[1:] - velocity[0], impulse, atol=1e-4)


def test_trace_has_a_row_for_each_sample_and_switch():
    study = study_trace(CollisionParameters(63.0, 1.4, 1.358), samples=10)
    assert study.columns["time"].size == 10 + study.collision.switches
    at = np.searchsorted(study.columns["time"], study.switch_times)
    assert list(study.columns["regime"][at]) == [0, -1, 0, 1, 0, -1, 0, 1]


def test_trace_computes_the_columns_asked_for():
    study = study_trace(CollisionParameters(18.0, 1.4, 0.5), columns=("normal_force", "time"))
    assert list(study.columns) == ["time", "normal_force"]


@pytest.mark.parametrize(
    ("friction", "tangential", "velocity", "force"), [(0.0, 0.7, 0.7, -1), (1.0, 0.0, 0.0, 0)]
)
def test_trace_without_friction_or_without_slip_is_trivial(friction, tangential, velocity, force):
    study = study_trace(CollisionParameters(18.0, friction, tangential), samples=5)
    np.testing.assert_array_equal(study.columns["tangential_velocity"], velocity)
    np.testing.assert_array_equal(
        study.columns["tangential_force_over_mu"], force * study.columns["normal_force"]
    )
    assert study.switch_times.size == 0


@given(
    st.floats(0, exclude_min=True, allow_infinity=False),
    st.floats(0, exclude_min=True, allow_infinity=False),
    st.one_of(st.just(0.0), st.floats(1e-300, 1.5)),
)
def test_collision_with_its_episodes_is_that_without(kappa, gt_over_gn, damping):
    """The first is solved by the motion that has the episodes, the second as one of many."""
    parameters = CollisionParameters(kappa, 1.0, gt_over_gn, damping)
    named = ("epsilon_t", "error_bound", "switches", "switches_certain", "method", "tolerance_met")
    one, other = (
        [getattr(study_collision(parameters, quantities=wanted), name) for name in named]
        for wanted in (QUANTITIES, ("epsilon_t", "switches"))
    )
    assert one == other


def test_trace_of_too_many_switches_is_refused():
    with pytest.raises(CostError, match="a trace shows at most 20,000"):
        study_trace(CollisionParameters(1e9, 1.0, 1.0))


def test_cut_and_map_and_batch_agree():
    axis = Axis(0.1, 4.0, 7)
    cut = study_cut(axis, 1.4, kappa=18.0)
    grid = study_grid(Axis(18.0, 70.0, 2), axis, 1.4)
    batch = study_batch(18.0, 1.4, axis.values(positive=False))
    column = grid.batch.columns["epsilon_t"].reshape(7, 2)[:, 0]
    np.testing.assert_array_equal(column, cut.batch.columns["epsilon_t"])
    np.testing.assert_array_equal(column, batch.columns["epsilon_t"])


def test_error_column_is_the_signed_distance_to_the_exact_method():
    batch = study_batch(18.0, 1.4, [0.5, 4.0], ("epsilon_t", "error"), Options(method="coulomb"))
    exact = restitution.epsilon_t(18.0, 1.4, [0.5, 4.0])
    np.testing.assert_array_equal(batch.columns["error"], batch.columns["epsilon_t"] - exact)


def test_axes_reach_their_ends_exactly():
    for scale in ("linear", "log"):
        values = Axis(5e-324, 1.7976931348623157e308, 9, scale).values(positive=True)
        assert values[0] == 5e-324
        assert values[-1] == 1.7976931348623157e308
        assert np.all(np.isfinite(values))


def test_empty_axes_are_refused():
    with pytest.raises(ParameterError, match="kappa_max must be greater than kappa_min"):
        Axis(2.0, 1.0, 5, "linear", "kappa_").values(positive=True)
    with pytest.raises(ParameterError, match="on a log scale"):
        Axis(0.0, 1.0, 5, "log").values(positive=False)


@pytest.mark.parametrize(
    ("parameters", "sentence"),
    [
        (
            (18.0, 1.4, 3.5),
            "Slides during the whole contact; 20 % of",
        ),
        ((1.0, 1.0, 0.0), "There is no tangential motion"),
        ((1e32, 1.0, 1.0), "Almost nothing of the tangential velocity is left."),
        (
            (0.953, 1.4, 1e-9),
            "turns round once and slides to the end; the surfaces",
        ),
    ],
)
def test_summary_says_what_happens(parameters, sentence):
    assert sentence in study_collision(CollisionParameters(*parameters)).summary


def test_presets_show_what_their_names_promise():
    studies = {
        p.id: study_collision(CollisionParameters(p.kappa, p.mu_over_alpha, p.gt_over_gn))
        for p in PRESETS.values()
    }
    letters = [studies[f"figure-5-{letter}"].switches for letter in "abcdefghijklmno"]
    assert letters == [0, 2, 4, 6, 8, 6, 8, 6, 4, 6, 4, 2, 4, 2, 2]
    assert studies["pure-sliding"].switches == 0
    assert studies["gear-wheel"].epsilon_t < -0.99
    assert abs(studies["stiff-limit"].epsilon_t) < 1e-3
    assert studies["figure-6"].switches == 6


def test_readme_example_takes_two_lines():
    assert restitution.epsilon_t(18, 1.4, 0.5).shape == ()
    assert restitution.trace(18, 1.4, 0.5)["tangential_velocity"].size == 404


def test_figures_are_presets_with_a_caption_and_an_address():
    figures = [preset for preset in PRESETS.values() if preset.id.startswith("figure-")]
    assert {preset.id[:8] for preset in figures} == {f"figure-{i}" for i in range(1, 7)}
    assert all(preset.caption for preset in figures)
    for preset in PRESETS.values():
        options = dict(urllib.parse.parse_qsl(preset.link.removeprefix("?"), strict_parsing=True))
        for name in ("kappa", "mu_over_alpha", "gt_over_gn"):
            assert float(options[name]) == getattr(preset, name), preset.id


def test_presets_of_steel_are_its_collisions():
    steel = Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
    for name, speed, sideways in (
        ("figure-1", 100, 100),
        ("figure-2", 100, 0.05),
        ("steel", 1, 0.5),
    ):
        study = study_scaling(Contact(steel, steel, 0.4, 1e12), Velocities(speed, sideways))
        preset = PRESETS[name]
        assert preset.kappa == pytest.approx(study.kappa, rel=2e-5)  # rounded for the eye
        assert preset.mu_over_alpha == pytest.approx(study.mu_over_alpha)
        assert preset.gt_over_gn == study.gt_over_gn
