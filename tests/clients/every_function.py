"""What a scientist writes: every name of `import restitution`, in a line each, with its type.

mypy checks it strictly, as a user's own script; a test runs it.
"""

from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd
import xarray as xr

import restitution as rs
from restitution.paper import Item


def scaled() -> None:
    """Use collisions in scaled units, and what their results become."""
    curve: npt.NDArray[np.float64] = rs.epsilon_t(18.0, 1.4, np.linspace(0.1, 4.0, 5))
    assert curve.shape == (5,)
    bounce: rs.CollisionStudy = rs.collision(63, 1.4, 1.358, tolerance=1e-6)
    regimes: list[str] = [episode.regime for episode in bounce.episodes or []]
    assert len(regimes) == 9
    many: rs.BatchStudy = rs.collisions([18, 63], 1.4, 0.5, method="timestep", steps=100)
    assert many.error_bound.max() < 1
    course: rs.TraceStudy = rs.trace(63, 1.4, 1.358, samples=100)
    assert course["time"].size == 108
    line: rs.CutStudy = rs.cut(63, 1.4, rs.Axis(0.01, 4.0, 5))
    assert line.along == "gt_over_gn"
    plane: rs.GridStudy = rs.map(rs.Axis(0.1, 70.0, 8, "log"), 1.4, rs.Axis(0.0, 4.0, 6))
    frames: list[pd.DataFrame] = [found.to_pandas() for found in (many, course, line, plane)]
    assert [len(frame) for frame in frames] == [2, 108, 5, 48]
    data: xr.Dataset = plane.to_xarray()
    assert data.epsilon_t.attrs["symbol"] == "ε_t"
    way: rs.Options = rs.Options(method="ode", rtol=1e-6)
    assert way.method == "ode"
    preset: rs.Preset = rs.PRESETS["figure-4"]
    assert preset.kappa > 0


def real() -> None:
    """Use bodies in SI units."""
    shell: rs.Sphere = rs.Sphere(0.02, 2.1e11, 0.3, mass_kg=0.1, inertia=rs.Moment(2e-5))
    floor: rs.Wall = rs.Wall(youngs_modulus_pa=7e10, poisson_ratio=0.25)
    contact: rs.Contact = rs.Contact(shell, floor, 0.4, tangential_stiffness_n_per_m="mindlin")
    found: rs.ScalingStudy = contact.impact(normal_velocity_m_s=1, tangential_velocity_m_s=0.5)
    assert 0 < found.contact_duration_s < 1e-3
    speeds: rs.VelocityMap = contact.map(rs.Axis(1, 20, 4), rs.Axis(0, 10, 3), tolerance=1e-3)
    assert speeds.to_xarray().kappa.dims == ("normal_velocity_m_s",)
    told: tuple[rs.Velocities, rs.Impact, rs.SpeedAndAngle] = (
        rs.Velocities(1.0, 0.5),
        rs.Impact((0.5, 0, -1), (0, 0, 0), normal=(0, 0, 1)),
        rs.SpeedAndAngle(speed_m_s=3.9, angle_deg=30),
    )
    assert told[1].spin_1_rad_s == (0, 0, 0)
    rough: rs.WaltonStudy = rs.walton(beta_0=1)
    assert rough.kappa < min(rough.others)
    material: rs.Material = rs.MATERIALS["steel"]
    assert material.contact.friction_coefficient > 0


def reports() -> None:
    """Use tables, what methods cost and miss, and the paper's statements."""
    table: rs.RestitutionTable = rs.table(rs.Axis(3, 6, 20), rs.Axis(0.1, 2, 20), sign="reversed")
    assert table.epsilon_t.shape == (20, 20)
    ladder: rs.StepsStudy = rs.steps(1e-2, 63, 1.4, 1.358)
    assert ladder.needed["velocity_verlet"].worst == 32
    measured: rs.Measurement = rs.tradeoff("stiff")
    costs: list[float | None] = [row.microseconds_per_collision for row in measured.rows]
    assert len(costs) == len(pd.DataFrame(measured.rows))
    statements: tuple[Item, ...] = rs.paper_statements()
    assert {statement.verdict for statement in statements} <= {"holds", "corrected", "fails"}


def refused() -> None:
    """Meet the errors: all are of one kind."""
    errors: list[rs.RestitutionError] = []
    try:
        rs.epsilon_t(-1.0, 1.4, 0.5)
    except rs.ParameterError as error:
        errors.append(error)
        assert error.parameter == "kappa"
    try:
        rs.epsilon_t(1e12, 1.0, 1.0)
    except rs.CostError as error:
        errors.append(error)
    wrong: dict[str, Any] = {"kapa": 1.0}
    try:
        rs.epsilon_t(1.0, 1.4, 0.5, **wrong)
    except rs.UnknownParameterError as error:
        errors.append(error)
        assert error.meant == "kappa"
    assert len(errors) == 3


def shown(server: str) -> None:
    """Open the page of a service that runs."""
    page: rs.Page = rs.explore(server=server, kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358)
    assert page.url.startswith(server)
