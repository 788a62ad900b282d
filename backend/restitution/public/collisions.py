"""Scaled collisions: one, many, over time, along a line, over a plane."""

from collections.abc import Collection
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from restitution.bounds import annotations
from restitution.errors import ParameterError
from restitution.methods.options import Options
from restitution.neighbours import naming_neighbours
from restitution.studies.collision.axis import Axis, an_axis
from restitution.studies.collision.cut import CutStudy, study_cut
from restitution.studies.collision.dampings import damping_told, dampings_told
from restitution.studies.collision.grid import GridStudy, study_grid
from restitution.studies.collision.many import LISTED, BatchStudy, study_batch
from restitution.studies.collision.one import QUANTITIES, CollisionStudy, study_collision
from restitution.studies.collision.parameters import (
    CollisionParameters,
    check,
    common_shape,
    numbers_of,
)
from restitution.studies.collision.trace import COLUMNS, TraceStudy, study_trace

WAY = annotations(Options)
"""Of `Options`, as any of these functions may be told them."""


@naming_neighbours
def epsilon_t(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike = 0.0,
    *,
    normal_restitution: npt.ArrayLike | None = None,
) -> npt.NDArray[np.float64]:
    """Return the exact coefficient of tangential restitution ε_t, a pure number.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn : array_like
        κ > 0 of Eq. 24, μ/α ≥ 0, and g_t/g_n ≥ 0 before the collision; broadcast together.
    damping : array_like, optional
        η = (3/2) A β^{2/5} g_n^{1/5} ≥ 0; broadcast as well.
    normal_restitution : array_like, optional
        ε_n in its place, 0 < ε_n ≤ 1.

    Returns
    -------
    ndarray
        ε_t = g_t(t_c)/g_t(0) (Eq. 7), of the common shape: +1 smooth spheres, −1 gear wheels.
        For g_t = 0 the limit, cos(√κ t_c).

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If a collision is too stiff to be followed.

    Notes
    -----
    `collisions` states how far each can be off: at most 4e-15 (1 + √κ), with damping
    1.3e-14 (1 + √κ). SBP2008, solved as docs/model.md describes.

    Examples
    --------
    >>> epsilon_t(18.0, 1.4, [2.8, 5.6, 11.2])
    array([0.  , 0.5 , 0.75])
    """
    dampings = dampings_told(damping, normal_restitution)
    given = numbers_of(kappa, mu_over_alpha, gt_over_gn, dampings)
    # before they are made flat, so that an element is told by its place
    check(**given)
    shape = common_shape(given)
    flat = (np.broadcast_to(values, shape).ravel() for values in given.values())
    found = collisions(*flat, quantities=("epsilon_t",), method="exact")
    return np.asarray(found.columns["epsilon_t"].reshape(shape))


@partial(naming_neighbours, others=WAY)
def collision(
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    damping: float = 0.0,
    *,
    normal_restitution: float | None = None,
    quantities: Collection[str] = QUANTITIES,
    episode_limit: int = 200,
    **options: Any,
) -> CollisionStudy:
    """Return what comes out of one collision and how it goes, in scaled units.

    As ``GET /collision``.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn, damping : float
        κ > 0 of Eq. 24, μ/α ≥ 0, g_t/g_n ≥ 0 before, and η ≥ 0.
    normal_restitution : float, optional
        ε_n in place of η, 0 < ε_n ≤ 1.
    quantities : collection of str, optional
        Of epsilon_t, epsilon_n, switches, reversals, episodes, energy, estimates, sensitivity,
        summary; the others are None.
    episode_limit : int, optional
        Largest number of episodes listed, up to 10,000.
    **options
        As of `Options`: method, tolerance, steps, …

    Returns
    -------
    CollisionStudy
        ε_t with a bound on its error; times in units of t_scale, energies of α m_eff g_n².

    Raises
    ------
    ParameterError
        If a parameter or an option is out of range.
    CostError
        If the method asked for would cost too much.

    Examples
    --------
    >>> bounce = collision(63, 1.4, 1.358)
    >>> round(bounce.epsilon_t, 6), [episode.regime for episode in bounce.episodes[:3]]
    (0.014347, ['sliding', 'sticking', 'sliding'])
    """
    told = damping_told(damping, normal_restitution)
    parameters = CollisionParameters(kappa, mu_over_alpha, gt_over_gn, told)
    return study_collision(parameters, Options(**options), quantities, episode_limit)


@partial(naming_neighbours, others=WAY)
def collisions(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike = 0.0,
    *,
    normal_restitution: npt.ArrayLike | None = None,
    quantities: Collection[str] = LISTED,
    **options: Any,
) -> BatchStudy:
    """Return many collisions as columns of pure numbers.

    As ``POST /collisions``.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn, damping : array_like, shape () or (N,)
        κ > 0 of Eq. 24, μ/α ≥ 0, g_t/g_n ≥ 0 before, and η ≥ 0; broadcast together.
    normal_restitution : array_like, shape () or (N,), optional
        ε_n in place of η, 0 < ε_n ≤ 1; up to 500 different ones.
    quantities : collection of str, optional
        epsilon_t, epsilon_n, switches; also coulomb, stiff_bound, stiff_asymptote,
        largest_switches, and error, that of the method that answered.
    **options
        As of `Options`: method, tolerance, steps, …

    Returns
    -------
    BatchStudy
        Its `columns` and, for each collision, method and `error_bound` have shape (N,), of which
        `to_pandas` makes a frame.

    Raises
    ------
    ParameterError
        If a parameter or an option is out of range.
    CostError
        If the method asked for would cost too much.

    Examples
    --------
    >>> collisions([18, 63], 1.4, [0.4, 1.358]).columns["switches"]
    array([4, 8], dtype=int32)
    """
    dampings = dampings_told(damping, normal_restitution)
    return study_batch(kappa, mu_over_alpha, gt_over_gn, quantities, Options(**options), dampings)


@partial(naming_neighbours, others=WAY)
def trace(
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    damping: float = 0.0,
    *,
    normal_restitution: float | None = None,
    samples: int = 400,
    columns: Collection[str] = COLUMNS,
    **options: Any,
) -> TraceStudy:
    """Return forces, velocities and the spring over the time of one contact, in scaled units.

    As ``GET /trace``.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn, damping : float
        κ > 0 of Eq. 24, μ/α ≥ 0, g_t/g_n ≥ 0 before, and η ≥ 0.
    normal_restitution : float, optional
        ε_n in place of η, 0 < ε_n ≤ 1.
    samples : int, optional
        Uniform instants from 0 to t_c, 2 to 20,000; those of the switches are added.
    columns : collection of str, optional
        Of time t in t_scale; compression x in ξ_scale; compression_rate ẋ in g_n; normal_force
        F_n and tangential_force_over_mu F_t/μ in m_eff ξ_scale/t_scale², with the signs of Eqs. 10
        and 11; tangential_velocity in g_n; spring_elongation z in ξ_scale; regime, 0 sticking or
        the sign of z; tangential_energy.
    **options
        As of `Options`: method, tolerance, steps, …

    Returns
    -------
    TraceStudy
        A column by its name has shape (samples + switches,); `to_pandas` makes a frame of them.

    Raises
    ------
    ParameterError
        If a parameter or an option is out of range.
    CostError
        If there are too many switches for a picture.

    Examples
    --------
    >>> trace(63, 1.4, 1.358)["time"].shape
    (408,)
    """
    told = damping_told(damping, normal_restitution)
    parameters = CollisionParameters(kappa, mu_over_alpha, gt_over_gn, told)
    return study_trace(parameters, Options(**options), samples, columns)


@partial(naming_neighbours, others=WAY)
def cut(
    kappa: float | Axis,
    mu_over_alpha: float,
    gt_over_gn: float | Axis,
    *,
    normal_restitution: float | None = None,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    **options: Any,
) -> CutStudy:
    """Return collisions along κ or g_t/g_n, as pure numbers.

    As ``GET /cut``.

    Parameters
    ----------
    kappa, gt_over_gn : float or Axis
        κ > 0 of Eq. 24 and g_t/g_n ≥ 0 before; the one that varies is an axis.
    mu_over_alpha : float
        μ/α ≥ 0.
    normal_restitution : float, optional
        ε_n in place of the damping, 0 < ε_n ≤ 1.
    quantities : collection of str, optional
        As of `collisions`.
    **options
        As of `Options`: damping, method, tolerance, …

    Returns
    -------
    CutStudy
        Values of the axis and the columns of its `batch`, of shape (count,).

    Raises
    ------
    ParameterError
        If a parameter or an option is out of range, or not one of the two is an axis.
    CostError
        If the method asked for would cost too much.

    Examples
    --------
    >>> cut(63, 1.4, Axis(0.01, 4, 5)).batch.columns["switches"]
    array([4, 6, 6, 0, 0], dtype=int32)
    """
    way = _way(options, normal_restitution)
    if isinstance(kappa, Axis) and not isinstance(gt_over_gn, Axis):
        return study_cut(
            kappa, mu_over_alpha, gt_over_gn=gt_over_gn, quantities=quantities, options=way
        )
    if isinstance(gt_over_gn, Axis) and not isinstance(kappa, Axis):
        return study_cut(gt_over_gn, mu_over_alpha, kappa=kappa, quantities=quantities, options=way)
    raise ParameterError("kappa", kappa, "an Axis, or else gt_over_gn, but not both")


@partial(naming_neighbours, others=WAY)
def map(  # noqa: A001 - the name of the call
    kappa: Axis,
    mu_over_alpha: float,
    gt_over_gn: Axis,
    *,
    normal_restitution: float | None = None,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    **options: Any,
) -> GridStudy:
    """Return collisions over κ and g_t/g_n, as pure numbers.

    As ``GET /map``.

    Parameters
    ----------
    kappa, gt_over_gn : Axis
        Along which κ > 0 of Eq. 24, n values, and g_t/g_n ≥ 0 before, k values, run.
    mu_over_alpha : float
        μ/α ≥ 0.
    normal_restitution : float, optional
        ε_n in place of the damping, 0 < ε_n ≤ 1.
    quantities : collection of str, optional
        As of `collisions`.
    **options
        As of `Options`: damping, method, tolerance, …

    Returns
    -------
    GridStudy
        The columns of its `batch` have shape (k n,), κ fastest; `to_xarray` makes a data set
        over (gt_over_gn, kappa) of them.

    Raises
    ------
    ParameterError
        If a parameter or an option is out of range.
    CostError
        If the method asked for would cost too much.

    Examples
    --------
    >>> found = map(Axis(1, 60, 6), 1.4, Axis(0.1, 4, 5), tolerance=1e-3)
    >>> found.batch.columns["epsilon_t"].reshape(5, 6).shape
    (5, 6)
    """
    way = _way(options, normal_restitution)
    edges = an_axis("kappa", kappa), an_axis("gt_over_gn", gt_over_gn)
    return study_grid(*edges, mu_over_alpha, quantities, way)


def _way(options: dict[str, Any], normal_restitution: float | None) -> Options:
    """Return the options of a cut or map, whose damping is among them, or told by ε_n."""
    told = damping_told(options.get("damping", 0.0), normal_restitution)
    return Options(**options | {"damping": told})
