"""Collisions with their exact results, against which methods are judged."""

from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

from restitution.mechanics.hertz import FloatArray
from restitution.methods import planner
from restitution.methods.options import Options
from restitution.studies.accuracy.scenes import SCENES, SceneName
from restitution.studies.collision.dampings import by_damping

KNOWN = 1e-9
"""Error bound up to which the reference counts as known."""


@dataclass(frozen=True)
class Reference:
    """Collisions and what is known of them; arrays (N,)."""

    kappa: FloatArray
    psi: FloatArray
    damping: FloatArray
    epsilon_t: FloatArray
    error_bound: FloatArray
    switches: npt.NDArray[np.int32]
    switches_certain: npt.NDArray[np.bool_]

    def at(self, which: slice | npt.NDArray[np.intp]) -> "Reference":
        """Return some of them."""
        return Reference(*(getattr(self, part.name)[which] for part in fields(self)))

    def by_damping(self) -> "list[tuple[float, Reference]]":
        """Return each different η with those that have it."""
        return [(eta, self.at(places)) for eta, places in by_damping(self.damping)]


def reference(scene: SceneName, count: int) -> Reference:
    """Return the first `count` collisions of a scene whose result is known to `KNOWN`."""
    truth = exact_reference(*SCENES[scene].sample(3 * count))
    return truth.at(np.flatnonzero(truth.error_bound <= KNOWN)[:count])


def exact_reference(kappa: FloatArray, psi: FloatArray, damping: FloatArray) -> Reference:
    """Return what is known of collisions (N,): the exact result, or 0 within a bound."""
    result = [np.empty(kappa.size, kind) for kind in (float, float, np.int32, np.bool_)]
    for eta, places in by_damping(damping):
        answer = planner.solve(
            kappa[places], psi[places], ("epsilon_t", "switches"), Options(damping=eta)
        )
        assert answer.switches is not None
        assert answer.switches_certain is not None
        parts = answer.epsilon_t, answer.error_bound, answer.switches, answer.switches_certain
        for whole, part in zip(result, parts, strict=True):
            whole[places] = part
    return Reference(kappa, psi, damping, *result)
