"""How many steps per contact a wanted error takes: measured, on a ladder and about the answer."""

import itertools
from collections.abc import Iterable
from dataclasses import astuple, dataclass, fields

import numpy as np

from restitution.mechanics.collision import in_threads
from restitution.mechanics.contact import contact_duration
from restitution.mechanics.hertz import FloatArray
from restitution.mechanics.stepping import INTEGRATORS, step_collisions
from restitution.studies.accuracy.reference import Reference, exact_reference, reference
from restitution.studies.accuracy.scenes import SceneName
from restitution.studies.collision.parameters import CollisionParameters
from restitution.studies.tabular import Table, Tabular

LADDER = tuple(round(2.0 ** (half / 2)) for half in range(4, 33))
"""Steps per contact, 4 … 65,536, by factors of √2."""

COLLISIONS = 128
"""Of a region: with `REGION_PHASES`, a thousand contacts for each rung."""

REGION_PHASES = 8
SINGLE_PHASES = 32
"""Instants within a step at which contacts begin."""

RULE = 50.0
"""Of the rule N = 50 √κ."""

MOST_STEPS = 1_000_000
"""Up to which the rule is tried, as in ``GET /map``."""

ABOUT_AN_ANSWER = 120_000
"""Sum of the numbers of steps that are tried about an answer, half as many as those of the ladder.
So every one is tried from 256 to 512, one in seven from 724 to 1448, ten from 8192 on."""

TWINS = {"symplectic_euler": "velocity_verlet"}
"""Integrator → another one with the same ε_t: no force acts before or after a contact, so that
half a kick more or less at its ends is none. A test holds it; here it saves a third."""

Parts = list[tuple[float, Reference]]
"""Collisions by their η."""

Rung = tuple[str, int]
"""Integrator and steps per contact."""

PARTS = ("error_p95", "error_max")
"""Of a `Spread`, what is to be met."""


@dataclass(frozen=True)
class Spread:
    """Errors of ε_t over collisions and phases, None where they were not measured."""

    error_median: float | None = None
    error_p95: float | None = None
    error_max: float | None = None


@dataclass(frozen=True)
class Tried:
    """Numbers of steps that were tried about an answer: `count` of those from `first` to `last`.

    With `count` = `last` − `first` + 1 it is every one, otherwise they lie evenly in the logarithm.
    """

    first: int
    last: int
    count: int


@dataclass(frozen=True)
class Needed:
    """Steps per contact from which on an error is met by every number of steps that was tried.

    Attributes
    ----------
    p95, worst : int, or None
        The smallest of them, in 95 % of contacts and in all.
    reason : str, or None
        Why one of them is None.
    p95_tried, worst_tried : Tried, or None
        What was tried about each: from the rung of the ladder from which on all rungs meet the
        error to twice that. Beyond, the rungs alone were tried.
    """

    p95: int | None
    worst: int | None
    reason: str | None
    p95_tried: Tried | None
    worst_tried: Tried | None


@dataclass(frozen=True)
class StepsStudy(Tabular):
    """What time steps make of a collision or a region.

    Attributes
    ----------
    collisions, phases : int
        How many collisions, from how many instants within a step each.
    stability_limit : float
        √κ t_c/2, the steps per contact below which a swing of the spring gains energy; of a region
        for its stiffest collision.
    needed : dict
        Integrator → `p95` and `worst`, the steps from which on the error is met in 95 % of contacts
        and in all.
    rule_steps : tuple of float
        The fewest and the most steps by the rule 50 √κ.
    rule : dict
        Integrator → `error_median`, `error_p95` and `error_max` by that rule, if it asks for no
        more than a million steps.
    ladder : list of (integrator, steps, Spread)
        What was measured.

    Examples
    --------
    >>> import restitution as rs
    >>> errors = rs.steps(1e-2, 63, 1.4, 1.358).to_pandas().error_max
    >>> bool(errors["velocity_verlet", 32] <= 1e-2)
    True
    """

    collisions: int
    phases: int
    stability_limit: float
    needed: dict[str, Needed]
    rule_steps: tuple[float, float]
    rule: dict[str, Spread]
    ladder: list[tuple[str, int, Spread]]

    def table(self) -> Table:
        """Return the ladder over integrators and steps."""
        axes = {"integrator": np.array(list(INTEGRATORS)), "steps": np.array(LADDER)}
        errors = np.array([astuple(spread) for _, _, spread in self.ladder])
        return Table(
            axes,
            {
                error.name: column.reshape(len(INTEGRATORS), len(LADDER))
                for error, column in zip(fields(Spread), errors.T, strict=True)
            },
            remarks={
                "collisions": self.collisions,
                "phases": self.phases,
                "stability_limit": self.stability_limit,
            },
        )


def study_steps(error: float, where: CollisionParameters | SceneName) -> StepsStudy:
    """Return the steps per contact that keep |ε_t − exact| within `error`.

    Parameters
    ----------
    error : float
        Largest error wanted; the bound on the exact value's own counts, too.
    where : CollisionParameters or str
        One collision, or the name of one of `SCENES`.
    """
    if isinstance(where, str):
        truth, phases = reference(where, COLLISIONS), REGION_PHASES
    else:
        truth = exact_reference(
            np.array([where.kappa]), np.array([where.psi]), np.array([where.damping])
        )
        phases = SINGLE_PHASES
    parts = truth.by_damping()
    integrators = [name for name in INTEGRATORS if name not in TWINS]

    def measured(rungs: Iterable[Rung]) -> dict[Rung, Spread]:
        # the longest first, so that no thread is left with it at the end
        longest_first = sorted(rungs, key=lambda rung: -rung[1])
        return dict(
            in_threads(lambda rung: (rung, _spread(parts, rung[0], rung[1], phases)), longest_first)
        )

    spreads = measured(itertools.product(integrators, LADDER))
    about = {
        (integrator, part): _about(error, [spreads[integrator, n] for n in LADDER], part)
        for integrator in integrators
        for part in PARTS
    }
    closer = {(name, n) for (name, _), numbers in about.items() for n in numbers}
    spreads |= measured(closer - spreads.keys())
    by_rule = np.maximum(LADDER[0], np.ceil(RULE * np.sqrt(truth.kappa)))
    needed = {
        name: _needed(
            error,
            {n: spread for (other, n), spread in spreads.items() if other == name},
            {part: about[name, part] for part in PARTS},
        )
        for name in integrators
    }
    return StepsStudy(
        truth.kappa.size,
        phases,
        max(float(np.sqrt(part.kappa.max())) * contact_duration(eta) / 2.0 for eta, part in parts),
        {name: needed[TWINS.get(name, name)] for name in INTEGRATORS},
        (float(by_rule.min()), float(by_rule.max())),
        _by_rule(truth, by_rule, integrators),
        [(i, n, spreads[TWINS.get(i, i), n]) for i, n in itertools.product(INTEGRATORS, LADDER)],
    )


def _spread_of(errors: FloatArray) -> Spread:
    return Spread(*np.quantile(errors, (0.5, 0.95, 1.0)).tolist())


def _spread(parts: Parts, integrator: str, steps: int, phases: int) -> Spread:
    """Return the errors of one rung over collisions and phases."""
    errors = [
        _errors(part, eta, integrator, steps, phase / phases)
        for eta, part in parts
        for phase in range(phases)
    ]
    return _spread_of(np.concatenate(errors))


def _errors(
    truth: Reference, damping: float, integrator: str, steps: int, phase: float
) -> FloatArray:
    """Return the errors of collisions (N,) of one η."""
    stepped = step_collisions(truth.kappa, truth.psi, steps, integrator, phase, damping=damping)
    return np.abs(stepped.epsilon_t - truth.epsilon_t) + truth.error_bound


def _by_rule(truth: Reference, steps: FloatArray, integrators: list[str]) -> dict[str, Spread]:
    """Return the errors where each collision has steps of its own, from two phases."""
    if steps.max() > MOST_STEPS:
        return dict.fromkeys(INTEGRATORS, Spread())
    spreads = {}
    for integrator in integrators:
        errors = [
            _errors(
                truth.at(slice(i, i + 1)),
                float(truth.damping[i]),
                integrator,
                int(steps[i]),
                phase / REGION_PHASES,
            )
            for i in range(truth.kappa.size)
            for phase in (i % 4, i % 4 + 4)
        ]
        spreads[integrator] = _spread_of(np.concatenate(errors))
    return {name: spreads[TWINS.get(name, name)] for name in INTEGRATORS}


def _about(error: float, ladder: list[Spread], part: str) -> list[int]:
    """Return the numbers of steps to be tried from the rung on from which on all meet `error`.

    They end at a rung as well; none if no rung meets it.
    """
    met = [getattr(spread, part) <= error for spread in ladder]
    tail = len(list(itertools.takewhile(bool, reversed(met))))
    if not tail:
        return []
    rungs = LADDER[-tail:][:3]
    every = range(rungs[0], rungs[-1] + 1)
    if sum(every) <= ABOUT_AN_ANSWER:
        return [*every]
    count = max(2 * ABOUT_AN_ANSWER // (rungs[0] + rungs[-1]), 2)
    some = np.geomspace(rungs[0], rungs[-1], count).round().astype(int).tolist()
    return sorted({*some, *rungs})


def _needed(error: float, spreads: dict[int, Spread], about: dict[str, list[int]]) -> Needed:
    """Return from where on `error` is met, by what was measured of one integrator."""

    def first(part: str) -> int | None:
        failing = [n for n in about[part] if getattr(spreads[n], part) > error]
        return next((n for n in about[part] if n > max(failing, default=0)), None)

    reason = None
    if not about["error_max"]:
        top = spreads[LADDER[-1]]
        reason = (
            f"at {LADDER[-1]:,} steps per contact, the most that are tried, the error is still "
            f"{top.error_p95:.1e} at p95 and {top.error_max:.1e} at worst"
        )
    tried = [Tried(part[0], part[-1], len(part)) if part else None for part in about.values()]
    return Needed(first("error_p95"), first("error_max"), reason, *tried)
