"""Coefficient of tangential restitution of frictional viscoelastic spheres.

What the service computes, in Python: the same names, the same bounds, the same numbers. Scaled
collisions are told by κ (Eq. 24, with α in it), μ/α, g_t/g_n at the point of contact and, with
damping, η = (3/2) A β^{2/5} g_n^{1/5}; collisions of real bodies by `Contact`, in SI units.
ε_t = g_t(t_c)/g_t(0): +1 for smooth spheres, −1 for gear wheels.

>>> import restitution as rs
>>> float(rs.epsilon_t(kappa=18, mu_over_alpha=1.4, gt_over_gn=5.6))
0.5
>>> rs.collision(kappa=63, mu_over_alpha=1.4, gt_over_gn=1.358).switches
8
>>> steel = rs.Sphere(0.02, 2.1e11, 0.3, density_kg_m3=7850)
>>> contact = rs.Contact(steel, steel, 0.4, "mindlin")
>>> round(contact.impact(normal_velocity_m_s=1.0, tangential_velocity_m_s=0.5).kappa, 3)
4.521
"""

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from restitution.errors import CostError, ParameterError, RestitutionError
from restitution.methods.answer import Options
from restitution.studies.accuracy.scenes import SceneName
from restitution.studies.accuracy.steps import StepsStudy, study_steps
from restitution.studies.accuracy.tradeoff import load_tradeoff
from restitution.studies.collision.axis import Axis
from restitution.studies.collision.cut import CutStudy, study_cut
from restitution.studies.collision.grid import GridStudy, study_grid
from restitution.studies.collision.many import LISTED, BatchStudy, study_batch
from restitution.studies.collision.one import QUANTITIES, CollisionStudy, study_collision
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.collision.presets import PRESETS
from restitution.studies.collision.trace import COLUMNS, TraceStudy, study_trace
from restitution.studies.spheres.bodies import Moment, Sphere, Wall
from restitution.studies.spheres.contact import Contact
from restitution.studies.spheres.impact import Impact, Velocities
from restitution.studies.spheres.materials import MATERIALS
from restitution.studies.tables.export import RestitutionTable, study_table_as_wanted
from restitution.studies.tables.grid import Sign

if TYPE_CHECKING:
    from restitution.paper import Item

__all__ = [
    "MATERIALS",
    "PRESETS",
    "Axis",
    "Contact",
    "CostError",
    "Impact",
    "Moment",
    "Options",
    "ParameterError",
    "RestitutionError",
    "Sphere",
    "Velocities",
    "Wall",
    "collision",
    "collisions",
    "cut",
    "epsilon_t",
    "map",
    "paper_statements",
    "steps",
    "table",
    "trace",
    "tradeoff",
]


def epsilon_t(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike = 0.0,
) -> npt.NDArray[np.float64]:
    """Return the exact coefficient of tangential restitution.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn : array_like
        κ of Eq. 24, μ/α, and g_t/g_n before the collision; broadcast together.
    damping : array_like, optional
        η = (3/2) A β^{2/5} g_n^{1/5}; broadcast as well.

    Returns
    -------
    ndarray
        ε_t, of the common shape: +1 smooth spheres, −1 gear wheels.

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If a collision is too stiff to be followed.
    """
    given = np.broadcast_arrays(kappa, mu_over_alpha, gt_over_gn, damping)
    found = collisions(
        *(values.ravel() for values in given), quantities=("epsilon_t",), method="exact"
    )
    return np.asarray(found.columns["epsilon_t"].reshape(given[0].shape))


def collision(
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    damping: float = 0.0,
    *,
    quantities: Collection[str] = QUANTITIES,
    episode_limit: int = 200,
    **options: Any,
) -> CollisionStudy:
    """Return what comes out of one collision and how it goes, as ``GET /collision``.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn, damping : float
        κ of Eq. 24, μ/α, g_t/g_n before, and η.
    quantities : collection of str, optional
        Of `studies.collision.one.QUANTITIES`; the others are None.
    episode_limit : int, optional
        Largest number of episodes listed.
    **options
        As of `Options`: method, tolerance, steps, …

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
    parameters = CollisionParameters(kappa, mu_over_alpha, gt_over_gn, damping)
    return study_collision(parameters, Options(**options), quantities, episode_limit)


def collisions(
    kappa: npt.ArrayLike,
    mu_over_alpha: npt.ArrayLike,
    gt_over_gn: npt.ArrayLike,
    damping: npt.ArrayLike = 0.0,
    *,
    quantities: Collection[str] = LISTED,
    **options: Any,
) -> BatchStudy:
    """Return many collisions as columns, as ``POST /collisions``.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn, damping : array_like, shape () or (N,)
        κ of Eq. 24, μ/α, g_t/g_n before, and η; broadcast together.
    quantities : collection of str, optional
        epsilon_t, epsilon_n, switches; also coulomb, stiff_bound, stiff_asymptote,
        largest_switches, and error, that of the method that answered.
    **options
        As of `Options`: method, tolerance, steps, …

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
    return study_batch(kappa, mu_over_alpha, gt_over_gn, quantities, Options(**options), damping)


def trace(
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    damping: float = 0.0,
    *,
    samples: int = 400,
    columns: Collection[str] = COLUMNS,
    **options: Any,
) -> TraceStudy:
    """Return forces, velocities and the spring over the time of one contact, as ``GET /trace``.

    Parameters
    ----------
    kappa, mu_over_alpha, gt_over_gn, damping : float
        κ of Eq. 24, μ/α, g_t/g_n before, and η.
    samples : int, optional
        Uniform instants, at least 2; those of the switches are added.
    columns : collection of str, optional
        Of `studies.collision.trace.COLUMNS`, each of shape (samples + switches,).
    **options
        As of `Options`: method, tolerance, steps, …

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
    parameters = CollisionParameters(kappa, mu_over_alpha, gt_over_gn, damping)
    return study_trace(parameters, Options(**options), samples, columns)


def cut(
    kappa: float | Axis,
    mu_over_alpha: float,
    gt_over_gn: float | Axis,
    *,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    **options: Any,
) -> CutStudy:
    """Return collisions along κ or g_t/g_n, the one that is an `Axis`, as ``GET /cut``.

    Parameters
    ----------
    kappa, gt_over_gn : float or Axis
        κ of Eq. 24 and g_t/g_n before; one of them an axis.
    mu_over_alpha : float
        μ/α.
    quantities : collection of str, optional
        As of `collisions`.
    **options
        As of `Options`: damping, method, tolerance, …

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
    way = Options(**options)
    if isinstance(kappa, Axis) and not isinstance(gt_over_gn, Axis):
        return study_cut(
            kappa, mu_over_alpha, gt_over_gn=gt_over_gn, quantities=quantities, options=way
        )
    if isinstance(gt_over_gn, Axis) and not isinstance(kappa, Axis):
        return study_cut(gt_over_gn, mu_over_alpha, kappa=kappa, quantities=quantities, options=way)
    raise ParameterError("kappa", kappa, "an Axis, or else gt_over_gn, but not both")


def map(  # noqa: A001 - the name of the call
    kappa: Axis,
    mu_over_alpha: float,
    gt_over_gn: Axis,
    *,
    quantities: Collection[str] = ("epsilon_t", "switches"),
    **options: Any,
) -> GridStudy:
    """Return collisions over κ and g_t/g_n, as ``GET /map``.

    Parameters
    ----------
    kappa, gt_over_gn : Axis
        Along which κ of Eq. 24 and g_t/g_n before run.
    mu_over_alpha : float
        μ/α.
    quantities : collection of str, optional
        As of `collisions`.
    **options
        As of `Options`: damping, method, tolerance, …

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
    return study_grid(kappa, gt_over_gn, mu_over_alpha, quantities, Options(**options))


def table(
    kappa: Axis,
    psi: Axis,
    damping: float | Axis = 0.0,
    *,
    error: float | None = None,
    sign: Sign = "paper",
    seconds: float = 60.0,
) -> RestitutionTable:
    """Return ε_t over κ and ψ, or κ, ψ and η, for interpolation elsewhere, as ``GET /table``.

    Parameters
    ----------
    kappa, psi : Axis
        κ of Eq. 24 and ψ = (α/μ)(g_t/g_n).
    damping : float or Axis, optional
        η of all entries, or a third axis.
    error : float, optional
        Largest error of interpolation wanted; the counts of the axes are then chosen for it.
    sign : ``"paper"`` or ``"reversed"``, optional
        +1 or −1 for smooth spheres.
    seconds : float, optional
        Time of one core that it may take.

    Raises
    ------
    ParameterError
        If a parameter is out of range.
    CostError
        If it takes longer than that.

    Examples
    --------
    >>> table(Axis(3, 6, 20), Axis(0.1, 2, 20)).epsilon_t.shape
    (20, 20)
    """
    return study_table_as_wanted(error, kappa, psi, sign, damping, seconds=seconds)


def steps(
    error: float,
    kappa: float | None = None,
    mu_over_alpha: float | None = None,
    gt_over_gn: float | None = None,
    damping: float = 0.0,
    *,
    region: SceneName | None = None,
) -> StepsStudy:
    """Return how many time steps per contact a wanted error takes, as ``GET /steps``.

    Parameters
    ----------
    error : float
        Largest error wanted in ε_t.
    kappa, mu_over_alpha, gt_over_gn, damping : float, optional
        One collision.
    region : str, optional
        Or many: figure4, stiff, solids, damped or extremes.

    Raises
    ------
    ParameterError
        If a parameter is out of range, or not one of both is given.

    Examples
    --------
    >>> steps(1e-2, 63, 1.4, 1.358).needed["velocity_verlet"].worst
    32
    """
    if kappa is not None and mu_over_alpha is not None and gt_over_gn is not None and not region:
        return study_steps(error, CollisionParameters(kappa, mu_over_alpha, gt_over_gn, damping))
    if region and kappa is mu_over_alpha is gt_over_gn is None:
        return study_steps(error, region)
    raise ParameterError("region", region, "given, or else kappa, mu_over_alpha and gt_over_gn")


def tradeoff(scene: SceneName = "figure4") -> dict[str, Any]:
    """Return what every method costs and how far it is off, as measured, as ``GET /tradeoff``.

    >>> tradeoff("stiff")["scene"]
    'stiff'
    """
    stored: dict[str, Any] = load_tradeoff()[scene]
    return stored


def paper_statements() -> "tuple[Item, ...]":
    """Return what the paper prints, what is computed now, and a verdict, as ``GET /paper``.

    It takes a second the first time.
    """
    # fourteen modules that nobody else needs
    from restitution.paper import study_paper  # noqa: PLC0415

    return study_paper()
