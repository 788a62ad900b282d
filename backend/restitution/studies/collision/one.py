"""One collision: what came out and how it went."""

import contextlib
import functools
import itertools
import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import Annotated, NamedTuple, cast

import numpy as np
from annotated_types import Ge, Le

from restitution.bounds import Meaning, OrNothing, allowed, chosen
from restitution.errors import CostError
from restitution.mechanics import limits
from restitution.mechanics.collision import TOO_STIFF
from restitution.mechanics.contact import contact_duration, normal_restitution
from restitution.mechanics.motion import Motion, dissipated_share, motion, reversals, sensitivity
from restitution.methods import planner
from restitution.methods.answer import Answer, AnsweringMethod, EpsilonT, ErrorBound, ToleranceMet
from restitution.methods.options import Options
from restitution.quantities import QUANTITIES as QUANTITY
from restitution.studies.collision.parameters import CONVENTION, CollisionParameters, Convention
from restitution.studies.collision.summary import summarise

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

EpisodeLimit = Annotated[int, Ge(0), Le(10_000)]

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
    """u²/2 + κz²/2 with u = g_t/g_n, before and after; the share lost is 1 − ε_t²."""

    initial: Annotated[float, OrNothing()]
    final: Annotated[float, OrNothing()]
    dissipated: Annotated[float, OrNothing()]
    dissipated_share: float


@dataclass(frozen=True)
class Estimates:
    """Simple laws for the same collision; NaN where they say nothing."""

    coulomb: float
    stiff_bound: Annotated[float, OrNothing()]
    stiff_asymptote: Annotated[float, OrNothing()]


@dataclass(frozen=True)
class Sensitivity:
    """∂ε_t/∂ln κ at fixed ψ and ∂ε_t/∂ln ψ at fixed κ."""

    kappa: float
    psi: float


@dataclass(frozen=True)
class CollisionStudy:
    """The result of one collision; None where the method cannot give a quantity.

    Attributes
    ----------
    parameters : CollisionParameters
        κ, μ/α, g_t/g_n, η, and ψ.
    epsilon_t, epsilon_n : float
        Coefficients of tangential and normal restitution.
    switches, reversals : int
        Changes between sliding and sticking; sign changes of g_t(t) within the contact.
    switches_certain : bool
        False where double precision cannot tell.
    contact_duration : float
        t_c in units of t_scale.
    episodes : list of Episode
        The first `episode_limit` of them; `episodes_truncated` where there are more.
    first_episode_share : float
        Share of the contact until the first switch; None where the collision was not followed.
    energy : Energy
        Of the tangential motion, in units of α m_eff g_n².
    estimates : Estimates
        Simple laws for the same collision.
    sensitivity : Sensitivity
        ∂ε_t/∂ln κ and ∂ε_t/∂ln ψ.
    summary : str
        The collision in a sentence.
    limit : bool
        Whether this is the limit ψ → 0, as g_t = 0.
    method : str
        The one that answered.
    error_bound : float
        Bound on the absolute error of ε_t; `tolerance_met` where it is within the tolerance.
    convention : str
        Sign and point of reference of every number.

    Examples
    --------
    >>> import restitution as rs
    >>> rs.collision(63, 1.4, 1.358).energy.dissipated_share > 0.999
    True
    """

    parameters: CollisionParameters
    epsilon_t: EpsilonT
    epsilon_n: Annotated[float, QUANTITY["epsilon_n"]]
    switches: Annotated[int | None, QUANTITY["switches"]]
    switches_certain: Annotated[bool | None, Meaning("false where double precision cannot tell")]
    reversals: Annotated[int | None, Meaning("sign changes of g_t(t) within the contact")]
    contact_duration: Annotated[float, Meaning("t_c in units of t_scale")]
    episodes: list[Episode] | None
    episodes_truncated: bool
    first_episode_share: Annotated[float | None, QUANTITY["first_episode_share"]]
    energy: Energy | None
    estimates: Estimates | None
    sensitivity: Sensitivity | None
    summary: Annotated[str | None, Meaning("the collision in a sentence")]
    limit: Annotated[bool, Meaning("whether this is the limit ψ → 0, as g_t = 0")]
    method: Annotated[AnsweringMethod, Meaning("the one that answered")]
    error_bound: ErrorBound
    tolerance_met: ToleranceMet
    convention: Convention


@functools.lru_cache(maxsize=8)
def followed_motion(parameters: CollisionParameters) -> Motion | None:
    """Return the episodes of a collision; None for those that have no spring: ψ = 0 or ∞."""
    psi = parameters.psi
    if not 0.0 < psi < math.inf:
        return None
    return motion(parameters.kappa, psi, damping=parameters.damping)


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
        κ, μ/α, g_t/g_n, η.
    options : Options, optional
        Method and tolerance; η is that of the parameters.
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
    if options.damping != parameters.damping:
        options = replace(options, damping=parameters.damping)
    wanted = frozenset(chosen("quantities", quantities, QUANTITIES))
    episode_limit = allowed("episode_limit", episode_limit, EpisodeLimit)
    psi = parameters.psi
    outcome = _outcome(parameters, wanted, options)
    epsilon_t = outcome.epsilon_t
    course = None
    if outcome.method == "exact" and wanted & FROM_EPISODES:
        course = _course(parameters, 0 if "episodes" not in wanted else episode_limit)
    return CollisionStudy(
        parameters=parameters,
        epsilon_t=epsilon_t,
        epsilon_n=normal_restitution(parameters.damping),
        switches=outcome.switches if "switches" in wanted else None,
        switches_certain=outcome.switches_certain,
        reversals=course.reversals if course and "reversals" in wanted else None,
        contact_duration=contact_duration(parameters.damping),
        episodes=course.episodes if course and "episodes" in wanted else None,
        episodes_truncated=bool(course and course.count > episode_limit),
        first_episode_share=course.first_share if course else None,
        energy=_energy(parameters.gt_over_gn, epsilon_t) if "energy" in wanted else None,
        estimates=estimates(parameters.kappa, psi, parameters.damping)
        if "estimates" in wanted
        else None,
        # where the bound is 1 double precision does not hold the phase, nor any derivative
        sensitivity=(
            course.sensitivity
            if course and "sensitivity" in wanted and outcome.error_bound < 1.0
            else None
        ),
        summary=_summary(outcome, course, parameters) if "summary" in wanted else None,
        limit=psi == 0.0,
        method=outcome.method,
        error_bound=outcome.error_bound,
        tolerance_met=outcome.error_bound <= options.tolerance,
        convention=CONVENTION,
    )


class _Outcome(NamedTuple):
    """What a method gives for one collision; None where it does not count switches."""

    epsilon_t: float
    error_bound: float
    method: AnsweringMethod
    switches: int | None
    switches_certain: bool | None


def _outcome(parameters: CollisionParameters, wanted: frozenset[str], options: Options) -> _Outcome:
    """Return the outcome by the planner's choice; what is followed anyway is solved by that."""
    if wanted & FROM_EPISODES and planner.is_exact(wanted, options):
        # what is too stiff to be followed is the planner's to answer or to refuse
        with contextlib.suppress(CostError):
            if path := followed_motion(parameters):
                return _Outcome(
                    path.epsilon_t,
                    path.error_bound,
                    "exact",
                    path.switches,
                    path.switches_certain,
                )
    answer = planner.solve(
        np.array([parameters.kappa]), np.array([parameters.psi]), wanted, options
    )
    switches, certain = _counted(answer)
    named = cast("AnsweringMethod", str(answer.method[0]))
    return _Outcome(
        float(answer.epsilon_t[0]), float(answer.error_bound[0]), named, switches, certain
    )


def _counted(answer: Answer) -> tuple[int | None, bool | None]:
    """Return the switches and whether they are certain; None where they were not counted."""
    if answer.switches is None or answer.switches_certain is None:
        return None, None
    switches = int(answer.switches[0])
    return (None, None) if switches == TOO_STIFF else (switches, bool(answer.switches_certain[0]))


@dataclass(frozen=True)
class _Course:
    """What the episodes tell."""

    count: int
    first_share: float
    reversals: int
    sensitivity: Sensitivity
    episodes: list[Episode]


def _course(parameters: CollisionParameters, episode_limit: int) -> _Course:
    """Return how the collision goes, with its first `episode_limit` episodes."""
    path = followed_motion(parameters)
    duration = contact_duration(parameters.damping)
    if path is None:
        resting = parameters.psi == 0.0
        only = Episode("sticking" if resting else "sliding", 0.0, duration, int(not resting))
        phase = np.sqrt(parameters.kappa) * duration if resting else 0.0
        slope = Sensitivity(float(-0.5 * phase * np.sin(phase)), 0.0)
        return _Course(1, 1.0, 0, slope, [only][:episode_limit])
    starts = path.start.tolist()
    ends = [*starts[1:], duration]
    listed = zip(starts, ends, path.direction.tolist(), strict=True)
    return _Course(
        len(starts),
        ends[0] / duration,
        reversals(path),
        Sensitivity(*sensitivity(path)),
        [
            Episode("sliding" if direction else "sticking", start, end, direction)
            for start, end, direction in itertools.islice(listed, episode_limit)
        ],
    )


def _summary(outcome: _Outcome, course: _Course | None, parameters: CollisionParameters) -> str:
    epsilon_t, bound, resting = outcome.epsilon_t, outcome.error_bound, parameters.psi == 0.0
    if course is None:
        return summarise(epsilon_t, bound, None, 0.0, 0, resting=resting)
    switches, share = course.count - 1, course.first_share
    return summarise(epsilon_t, bound, switches, share, course.reversals, resting=resting)


def _energy(gt_over_gn: float, epsilon_t: float) -> Energy:
    lost = dissipated_share(epsilon_t)
    try:
        initial = 0.5 * gt_over_gn**2
    except OverflowError:
        initial = math.inf
    return Energy(initial, epsilon_t * epsilon_t * initial, lost * initial, lost)


def estimates(kappa: float, psi: float, damping: float = 0.0) -> Estimates:
    """Return Coulomb's law and, for η = 0, both stiff limits for one collision."""
    epsilon_n = normal_restitution(damping)
    return Estimates(*limits.simple_laws(kappa, psi, epsilon_n, damping > 0.0))
