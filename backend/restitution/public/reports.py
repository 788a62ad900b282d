"""Beyond collisions: tables for other codes, what methods cost and miss, the paper's statements."""

from typing import TYPE_CHECKING, Annotated

from annotated_types import Gt

from restitution.bounds import allowed
from restitution.errors import ParameterError
from restitution.methods.options import Damping, WantedError
from restitution.neighbours import naming_neighbours
from restitution.studies.accuracy.scenes import SceneName
from restitution.studies.accuracy.steps import StepsStudy, study_steps
from restitution.studies.accuracy.tradeoff import Measurement, stored_measurement
from restitution.studies.collision.axis import Axis, an_axis
from restitution.studies.collision.dampings import damping_told
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.spheres.walton import WaltonStudy, study_walton
from restitution.studies.tables.export import RestitutionTable, study_table_as_wanted
from restitution.studies.tables.grid import Sign

if TYPE_CHECKING:
    from restitution.paper import Item


@naming_neighbours
def table(
    kappa: Axis,
    psi: Axis,
    damping: float | Axis = 0.0,
    *,
    normal_restitution: float | None = None,
    error: float | None = None,
    sign: Sign = "paper",
    seconds: float = 60.0,
) -> RestitutionTable:
    """Return ε_t, a pure number, over κ and ψ, or κ, ψ and η, for interpolation elsewhere.

    As ``GET /table``.

    Parameters
    ----------
    kappa, psi : Axis
        κ > 0 of Eq. 24, n values, and ψ = (α/μ)(g_t/g_n) ≥ 0, k values.
    damping : float or Axis, optional
        η ≥ 0 of all entries, or a third axis of m values.
    normal_restitution : float, optional
        ε_n of all entries in place of η, 0 < ε_n ≤ 1.
    error : float, optional
        Largest error of interpolation wanted; the counts of the axes are then chosen for it.
    sign : ``"paper"`` or ``"reversed"``, optional
        +1 or −1 for smooth spheres.
    seconds : float, optional
        Time of one core that it may take.

    Returns
    -------
    RestitutionTable
        Its `epsilon_t` has shape (k, n) or (m, k, n); `largest_error` is that of interpolation.

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
    if not isinstance(damping, Axis):
        damping = allowed("damping", damping, Damping)
    told = damping_told(damping, normal_restitution)
    axes = an_axis("kappa", kappa), an_axis("psi", psi)
    wanted = allowed("error", error, WantedError | None)
    way = allowed("sign", sign, Sign)
    most = allowed("seconds", seconds, Annotated[float, Gt(0)])
    return study_table_as_wanted(wanted, *axes, way, told, seconds=most)


@naming_neighbours
def steps(
    error: float,
    kappa: float | None = None,
    mu_over_alpha: float | None = None,
    gt_over_gn: float | None = None,
    damping: float = 0.0,
    *,
    normal_restitution: float | None = None,
    region: SceneName | None = None,
) -> StepsStudy:
    """Return how many time steps per contact a wanted error takes.

    As ``GET /steps``: measured, not estimated.

    Parameters
    ----------
    error : float
        Largest error wanted in ε_t.
    kappa, mu_over_alpha, gt_over_gn, damping : float, optional
        One collision: κ > 0 of Eq. 24, μ/α ≥ 0, g_t/g_n ≥ 0 before, and η ≥ 0.
    normal_restitution : float, optional
        ε_n in place of η, 0 < ε_n ≤ 1.
    region : str, optional
        Or many: figure4, stiff, solids, damped or extremes.

    Returns
    -------
    StepsStudy
        The steps `needed` by each integrator, and the errors at all that were tried.

    Raises
    ------
    ParameterError
        If a parameter is out of range, or not one of both is given.

    Examples
    --------
    >>> steps(1e-2, 63, 1.4, 1.358).needed["velocity_verlet"].worst
    32
    """
    error = allowed("error", error, WantedError)
    region = allowed("region", region, SceneName | None)
    if kappa is not None and mu_over_alpha is not None and gt_over_gn is not None and not region:
        told = damping_told(damping, normal_restitution)
        return study_steps(error, CollisionParameters(kappa, mu_over_alpha, gt_over_gn, told))
    if region and kappa is mu_over_alpha is gt_over_gn is None:
        return study_steps(error, region)
    raise ParameterError("region", region, "given, or else kappa, mu_over_alpha and gt_over_gn")


@naming_neighbours
def walton(beta_0: float) -> WaltonStudy:
    """Return the smallest κ whose undamped collisions have a β₀ of Walton's model.

    As ``GET /walton``. For κ → β₀ see `ScalingStudy.walton_beta_0`.

    Parameters
    ----------
    beta_0 : float
        −ε_t for ψ → 0, a pure number: −1 smooth spheres, +1 gear wheels.

    Returns
    -------
    WaltonStudy
        κ of Eq. 24, from 0 to 0.953, and the next larger ones that have it as well: there is no
        end of them.

    Raises
    ------
    ParameterError
        If it is out of range.

    Examples
    --------
    >>> round(walton(1.0).kappa, 5)
    0.95304
    """
    return study_walton(beta_0)


@naming_neighbours
def tradeoff(scene: SceneName = "figure4") -> Measurement:
    """Return what every method costs, in µs per collision, and how far its ε_t is off, as stored.

    As ``GET /tradeoff``.

    Parameters
    ----------
    scene : str, optional
        figure4, stiff, solids, damped or extremes: collisions on which it was measured.

    Returns
    -------
    Measurement
        With the machine and the day; its `rows` are what pandas makes a frame of.

    Raises
    ------
    ParameterError
        If there is no such scene.

    Examples
    --------
    >>> exact = next(row for row in tradeoff("stiff").rows if row.method == "exact")
    >>> exact.error_max < 1e-9
    True
    """
    return stored_measurement(allowed("scene", scene, SceneName))


def paper_statements() -> "tuple[Item, ...]":
    """Return what the paper prints, what is computed now, and a verdict on each, as texts.

    As ``GET /paper``; it takes a second the first time.

    Returns
    -------
    tuple of Item
        Equations 1–30, Figs. 1–6, numbers and claims of SBP2008, of which pandas makes a frame.

    Examples
    --------
    >>> [item.verdict for item in paper_statements() if item.id == "equation-27"]
    ['corrected']
    """
    # fourteen modules that nobody else needs
    from restitution.paper import study_paper  # noqa: PLC0415

    return study_paper()
