"""How many steps per contact a wanted error takes: measured on a ladder of step counts."""

import itertools
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

TWINS = {"symplectic_euler": "velocity_verlet"}
"""Integrator → another one with the same ε_t: no force acts before or after a contact, so that
half a kick more or less at its ends is none. A test holds it; here it saves a third."""

Parts = list[tuple[float, Reference]]
"""Collisions by their η."""


@dataclass(frozen=True)
class Spread:
    """Errors of ε_t over collisions and phases, None where they were not measured."""

    error_median: float | None = None
    error_p95: float | None = None
    error_max: float | None = None


@dataclass(frozen=True)
class Needed:
    """Steps per contact from which on an error is met.

    Attributes
    ----------
    p95, worst : int, or None
        The smallest rung that meets the error, as do all above it, in 95 % of contacts and in all.
    reason : str, or None
        Why one of them is None.
    """

    p95: int | None
    worst: int | None
    reason: str | None


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
        Integrator → `Needed`.
    rule_steps : tuple of float
        The fewest and the most steps by the rule 50 √κ.
    rule : dict
        Integrator → `Spread` of the errors by that rule, if it asks for no more than `MOST_STEPS`.
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
    rungs = list(itertools.product(integrators, LADDER))
    # the longest first, so that no thread is left with it at the end
    spreads = dict(
        in_threads(
            lambda rung: (rung, _spread(parts, rung[0], rung[1], phases)),
            sorted(rungs, key=lambda rung: -rung[1]),
        )
    )
    by_rule = np.maximum(LADDER[0], np.ceil(RULE * np.sqrt(truth.kappa)))
    ladder = [
        (i, n, spreads[TWINS.get(i, i), n]) for i, n in itertools.product(INTEGRATORS, LADDER)
    ]
    return StepsStudy(
        truth.kappa.size,
        phases,
        max(float(np.sqrt(part.kappa.max())) * contact_duration(eta) / 2.0 for eta, part in parts),
        {
            i: _needed(error, [spread for name, _, spread in ladder if name == i])
            for i in INTEGRATORS
        },
        (float(by_rule.min()), float(by_rule.max())),
        _by_rule(truth, by_rule, integrators),
        ladder,
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


def _needed(error: float, ladder: list[Spread]) -> Needed:
    p95 = _first(error, [spread.error_p95 for spread in ladder])
    worst = _first(error, [spread.error_max for spread in ladder])
    reason = None
    if worst is None:
        reason = (
            f"at {LADDER[-1]:,} steps per contact, the most that are tried, the error is still "
            f"{ladder[-1].error_p95:.1e} at p95 and {ladder[-1].error_max:.1e} at worst"
        )
    return Needed(p95, worst, reason)


def _first(error: float, measured: list[float | None]) -> int | None:
    """Return the first rung from which on all meet `error`."""
    met = [value is not None and value <= error for value in measured]
    tail = list(itertools.takewhile(bool, reversed(met)))
    return LADDER[-len(tail)] if tail else None
