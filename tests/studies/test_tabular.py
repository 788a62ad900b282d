"""Results as frames and data sets: the same numbers, with units that are said once."""

import subprocess
import sys

import numpy as np
import pytest

import restitution as rs
from restitution.quantities import QUANTITIES
from restitution.studies.collision.many import LISTED
from restitution.studies.collision.many import QUANTITIES as EVERY

STEEL = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)

UNITS = {
    "_rad_s": "rad/s",
    "_m_s": "m/s",
    "_n_per_m": "N/m",
    "_kg": "kg",
    "_pa": "Pa",
    "_s": "s",
    "_m": "m",
}
"""As names end in them, the longest first."""

RESULTS = {
    "collisions": lambda: rs.collisions([18, 63, 7], 1.4, 0.4, [0, 0.1, 0], quantities=LISTED),
    "trace": lambda: rs.trace(63, 1.4, 1.358),
    "cut": lambda: rs.cut(rs.Axis(1, 60, 7), 1.4, 0.5, quantities=EVERY),
    "map": lambda: rs.map(rs.Axis(1, 60, 6), 1.4, rs.Axis(0, 4, 5), damping=0.1),
    "table": lambda: rs.table(rs.Axis(3, 6, 5), rs.Axis(0.1, 2, 4)),
    "deep table": lambda: rs.table(rs.Axis(3, 6, 5), rs.Axis(0.1, 2, 4), rs.Axis(0.1, 0.2, 3)),
    "steps": lambda: rs.steps(1e-2, 63, 1.4, 1.358),
    "velocities": lambda: rs.Contact(STEEL, STEEL, 0.4, "mindlin", 1e-5).map(
        rs.Axis(1, 20, 4), rs.Axis(0, 10, 3)
    ),
}

AXES = {
    "collisions": {"collision": 3},
    "trace": {"time": 408},
    "cut": {"kappa": 7},
    "map": {"gt_over_gn": 5, "kappa": 6},
    "table": {"psi": 4, "kappa": 5},
    "deep table": {"damping": 3, "psi": 4, "kappa": 5},
    "steps": {"integrator": 3, "steps": 29},
    "velocities": {"tangential_velocity_m_s": 3, "normal_velocity_m_s": 4},
}


@pytest.fixture(params=RESULTS, scope="module")
def result(request):
    return request.param, RESULTS[request.param]()


def test_data_set_runs_over_the_axes_of_the_result(result):
    name, found = result
    data = found.to_xarray()
    assert dict(data.sizes) == AXES[name]
    for variable in data.data_vars.values():
        assert variable.dims == tuple(AXES[name])


def test_frame_has_the_rows_that_xarray_makes_of_the_data_set(result):
    _, found = result
    frame, data = found.to_pandas(), found.to_xarray()
    several = [name for name, values in data.coords.items() if values.ndim]
    again = data.reset_coords([*(set(several) - set(data.dims))]).to_dataframe()
    assert list(frame.index) == list(again.index)
    assert list(frame.index.names) == list(again.index.names)
    for name in frame:
        assert frame[name].to_list() == again[name].to_list(), name
    # what is one number for all rows stands beside the frame
    assert set(again) - set(frame) == {n for n in data.coords if n not in several}
    assert all(frame.attrs[name] == again[name].iloc[0] for name in set(again) - set(frame))


def test_every_variable_says_what_it_is_and_in_which_unit(result):
    _, found = result
    frame, data = found.to_pandas(), found.to_xarray()
    for name, variable in data.variables.items():
        said = variable.attrs
        assert said["long_name"] == frame.attrs["long_names"][name]
        assert said.get("units") == frame.attrs["units"].get(name)
        assert said.get("symbol") == frame.attrs["symbols"].get(name)
        assert ("units" in said) == (variable.dtype.kind in "fi"), name


def test_what_is_written_to_a_data_set_is_not_written_to_the_result():
    found = rs.map(rs.Axis(1, 60, 6), 1.4, rs.Axis(0, 4, 5))
    data = found.to_xarray()
    data["epsilon_t"][:] = 7.0
    data["damping"][()] = 7.0
    assert found.batch.columns["epsilon_t"].max() <= 1
    assert found.to_xarray().damping == 0


def test_collisions_keep_the_parameters_that_they_were_told():
    kappa = np.array([18.0, 63.0])
    found = rs.collisions(kappa, 1.4, [0.4])
    kappa[:] = 0
    frame = found.to_pandas()
    assert frame.kappa.to_list() == [18, 63]
    assert frame.mu_over_alpha.to_list() == [1.4, 1.4]
    assert frame.gt_over_gn.to_list() == [0.4, 0.4]
    assert frame.damping.to_list() == [0, 0]


def test_map_is_read_by_its_parameters():
    plane = rs.map(rs.Axis(1, 60, 60), 1.4, rs.Axis(0.5, 4, 8)).to_xarray()
    one = plane.sel(kappa=18, gt_over_gn=2.5)
    assert float(one.epsilon_t) == pytest.approx(float(rs.epsilon_t(18, 1.4, 2.5)), abs=1e-13)
    assert int(one.switches) == rs.collision(18, 1.4, 2.5).switches


def test_trace_is_indexed_by_time_whether_or_not_that_was_asked_for():
    frame = rs.trace(63, 1.4, 1.358, columns=("normal_force",)).to_pandas()
    assert list(frame) == ["normal_force"]
    assert frame.index.name == "time"
    assert frame.index[-1] == rs.collision(63, 1.4, 1.358).contact_duration


def test_table_of_the_other_sign_does_not_claim_that_of_the_paper():
    edges = rs.Axis(3, 6, 5), rs.Axis(0.1, 2, 4)
    paper, other = (rs.table(*edges, sign=sign).to_xarray() for sign in ("paper", "reversed"))
    assert (paper.sign, other.sign) == ("paper", "reversed")
    assert "convention" not in paper.attrs | other.attrs
    np.testing.assert_array_equal(paper.epsilon_t, -other.epsilon_t)


def test_name_that_ends_in_a_unit_has_that_unit():
    ending = {
        name: unit
        for name in QUANTITIES
        for unit in [next((unit for end, unit in UNITS.items() if name.endswith(end)), None)]
        if unit
    }
    assert len(ending) == 18
    assert {name: QUANTITIES[name].unit for name in ending} == ending


@pytest.mark.parametrize(("package", "form"), [("pandas", "to_pandas"), ("xarray", "to_xarray")])
def test_form_says_which_extra_it_takes_when_that_is_missing(package, form, monkeypatch):
    found = rs.collisions(18, 1.4, 0.4)
    # as import has it of what is not there
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ImportError, match=rf"no {package} here: pip install 'restitution\[note"):
        getattr(found, form)()


def test_import_leaves_alone_what_only_some_need():
    heavy = "pandas xarray IPython matplotlib plotly fastapi uvicorn pydantic restitution.paper"
    code = f"import sys, restitution; print([n for n in {heavy.split()} if n in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"
