"""How much the collisions of a query are damped."""

import functools
from collections.abc import Iterator, Mapping

from restitution.bounds import Misfit, closed
from restitution.mechanics.contact import normal_restitution
from restitution.methods.options import Damping, NormalRestitution
from restitution.studies.collision.dampings import damping_told, told_twice
from restitution.wire.formats import Payload


@closed
class Damped:
    """How much all collisions of a request are damped: by η, or by ε_n in its place."""

    damping: Damping = 0.0
    normal_restitution: NormalRestitution | None = None

    @staticmethod
    def misfits(given: Mapping[str, str]) -> Iterator[Misfit]:
        """Yield that both are given."""
        yield from told_twice(given)

    @functools.cached_property
    def eta(self) -> float:
        """η as understood; to find that of an ε_n takes normal motions, so not before the work."""
        return damping_told(self.damping, self.normal_restitution)

    @property
    def is_damped(self) -> bool:
        """Whether η > 0, without finding it."""
        return self.damping > 0.0 or self.normal_restitution not in (None, 1.0)

    def found(self) -> Payload:
        """Return what an answer says of a damping that had to be found."""
        if self.normal_restitution is None:
            return {}
        return {"damping": self.eta, "epsilon_n": normal_restitution(self.eta)}
