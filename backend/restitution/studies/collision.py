"""One collision: what came out and how it went."""

import functools
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from restitution.mechanics import limits
from restitution.mechanics.collision import TOO_STIFF
from restitution.mechanics.hertz import CONTACT_DURATION
from restitution.mechanics.motion import Motion, motion, reversals, sensitivity
from restitution.methods import planner
from restitution.methods.answer import Options
from restitution.studies.parameters import CONVENTION, CollisionParameters
from restitution.studies.summary import summarise

QUANTITIES = (
    "epsilon_t",
    "epsilon_n",
    "switches",
    "reversals",
    "episodes",
    "energy",
    "estimates",
    "sensitivity",
    "summary",
)

FROM_EPISODES = frozenset({"reversals", "episodes", "sensitivity", "summary"})


@dataclass(frozen=True)
class Episode:
    """A stretch of the contact without a change of regime; times scaled by t_scale."""

    regime: str
    start: float
    end: float
    direction: int


@dataclass(frozen=True)
class Energy:
    """u²/2 + κz²/2 with u = g_t/g_n, before and after."""

    initial: float
    final: float
    dissipated: float


@dataclass(frozen=True)
class Estimates:
    """Simple laws for the same collision; NaN where they say nothing."""

    coulomb: float
    stiff_bound: float
    stiff_asymptote: float


@dataclass(frozen=True)
class Sensitivity:
    """∂ε_t/∂ln κ at fixed ψ and ∂ε_t/∂ln ψ at fixed κ."""

    kappa: float
    psi: float


@dataclass(frozen=True)
class CollisionStudy:
    """The result of one collision; None where the method cannot give a quantity.

    Attributes are those of ``GET /collision``; see docs/model.md.
    """

    parameters: CollisionParameters
    epsilon_t: float
    epsilon_n: float
    switches: int | None
    switches_certain: bool | None
    reversals: int | None
    contact_duration: float
    episodes: list[Episode] | None
    episodes_truncated: bool
    energy: Energy | None
    estimates: Estimates | None
    sensitivity: Sensitivity | None
    summary: str | None
    limit: bool
    method: str
    error_bound: float
    tolerance_met: bool
    convention: str


@functools.lru_cache(maxsize=8)
def followed_motion(parameters: CollisionParameters) -> Motion | None:
    """Return the episodes of a collision; None for those that have no spring: ψ = 0 or ∞."""
    psi = parameters.psi
    return motion(parameters.kappa, psi) if 0.0 < psi < np.inf else None


def study_collision(
    parameters: CollisionParameters,
    options: Options | None = None,
    quantities: Collection[str] = QUANTITIES,
    episode_limit: int = 200,
) -> CollisionStudy:
    """Return one collision with the `quantities` asked for.

    Parameters
    ----------
    parameters : CollisionParameters
        κ, μ/α, g_t/g_n.
    options : Options, optional
        Method and tolerance.
    quantities : collection of str, optional
        Of `QUANTITIES`; the others are None.
    episode_limit : int, optional
        Largest number of episodes listed.

    Examples
    --------
    >>> study_collision(CollisionParameters(63.0, 1.4, 1.358)).switches
    8
    """
    options = options or Options()
    wanted = frozenset(quantities)
    psi = parameters.psi
    kappas, psis = np.array([parameters.kappa]), np.array([psi])
    answer = planner.solve(kappas, psis, wanted, options)
    epsilon_t = float(answer.epsilon_t[0])
    method = str(answer.method[0])
    counted = answer.switches is not None and answer.switches[0] != TOO_STIFF
    exactly = method == "exact"
    resting = psi == 0.0
    path = followed_motion(parameters) if exactly and wanted & FROM_EPISODES else None
    episodes = _episodes(path, resting=resting) if exactly and wanted & FROM_EPISODES else None
    turns = reversals(path) if path else 0
    return CollisionStudy(
        parameters=parameters,
        epsilon_t=epsilon_t,
        epsilon_n=1.0,
        switches=int(answer.switches[0]) if counted and "switches" in wanted else None,  # type: ignore[index]
        switches_certain=bool(answer.switches_certain[0]) if counted else None,  # type: ignore[index]
        reversals=turns if exactly and "reversals" in wanted else None,
        contact_duration=CONTACT_DURATION,
        episodes=episodes[:episode_limit]
        if episodes is not None and "episodes" in wanted
        else None,
        episodes_truncated=episodes is not None and len(episodes) > episode_limit,
        energy=_energy(parameters.gt_over_gn, epsilon_t) if "energy" in wanted else None,
        estimates=estimates(parameters.kappa, psi) if "estimates" in wanted else None,
        sensitivity=(
            _sensitivity(path, parameters.kappa, psi)
            if exactly and "sensitivity" in wanted
            else None
        ),
        summary=(
            summarise(epsilon_t, episodes, turns, resting=resting) if "summary" in wanted else None
        ),
        limit=resting,
        method=method,
        error_bound=float(answer.error_bound[0]),
        tolerance_met=bool(answer.error_bound[0] <= options.tolerance),
        convention=CONVENTION,
    )


def _episodes(path: Motion | None, *, resting: bool) -> list[Episode]:
    if path is None:
        if resting:
            return [Episode("sticking", 0.0, CONTACT_DURATION, 0)]
        return [Episode("sliding", 0.0, CONTACT_DURATION, 1)]
    return [
        Episode("sliding" if direction else "sticking", float(start), float(end), int(direction))
        for start, end, direction in zip(path.start, path.end, path.direction, strict=True)
    ]


def _energy(gt_over_gn: float, epsilon_t: float) -> Energy:
    with np.errstate(over="ignore", under="ignore"):
        initial = 0.5 * np.float64(gt_over_gn) ** 2
        kept = epsilon_t * epsilon_t
        return Energy(float(initial), float(kept * initial), float((1.0 - kept) * initial))


def estimates(kappa: float, psi: float) -> Estimates:
    """Return Coulomb's law and both stiff limits for one collision."""
    with np.errstate(divide="ignore", over="ignore"):
        return Estimates(
            float(limits.coulomb_restitution(psi)),
            float(limits.stiff_bound(kappa, psi)),
            float(limits.stiff_asymptote(kappa, psi)),
        )


def _sensitivity(path: Motion | None, kappa: float, psi: float) -> Sensitivity:
    if path is not None:
        return Sensitivity(*sensitivity(path))
    if psi > 0.0:
        return Sensitivity(0.0, 0.0)
    phase = np.sqrt(kappa) * CONTACT_DURATION
    return Sensitivity(float(-0.5 * phase * np.sin(phase)), 0.0)
