"""One sentence about a collision, as a screen reader says it."""

from collections.abc import Sequence
from typing import Protocol

from restitution.mechanics.hertz import CONTACT_DURATION


class _Episode(Protocol):
    @property
    def end(self) -> float: ...


_TIMES = {1: "once", 2: "twice"}

_LAST_WORD = 0.995
"""|ε_t| from which on the outcome is called that of smooth spheres or of gear wheels."""


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %" if share >= 0.01 else "less than 1 %"


def _outcome(epsilon_t: float) -> str:
    if epsilon_t >= _LAST_WORD:
        return "the surfaces part as fast as they met, like smooth spheres"
    if epsilon_t <= -_LAST_WORD:
        return "the surfaces part in reverse, like gear wheels"
    kept = _percent(abs(epsilon_t))
    if abs(epsilon_t) < 0.001:
        return "almost nothing of the tangential velocity is left"
    return f"{kept} of the tangential velocity is left" + (", reversed" if epsilon_t < 0 else "")


def summarise(
    epsilon_t: float, episodes: Sequence[_Episode] | None, turns: int, *, resting: bool
) -> str:
    """Return how the collision went and what is left.

    Parameters
    ----------
    epsilon_t : float
        Coefficient of tangential restitution.
    episodes : sequence, or None
        Episodes with regime, start and end; None if they were not computed.
    turns : int
        Sign changes of the surface velocity.
    resting : bool
        True for g_t = 0.
    """
    if resting:
        return (
            "There is no tangential motion; ε_t is the limit of ever smaller tangential velocity."
        )
    outcome = _outcome(epsilon_t)
    if episodes is None:
        return f"{outcome[0].upper()}{outcome[1:]}."
    if len(episodes) == 1:
        return f"Slides during the whole contact; {outcome}."
    first = _percent(episodes[0].end / CONTACT_DURATION)
    story = f"Slides {first} of the contact, sticks"
    again = (len(episodes) - 3) // 2
    if again:
        story += f", slips and sticks {_TIMES.get(again, f'{again} times')} more"
    if turns:
        story += f", turns round {_TIMES.get(turns, f'{turns} times')}"
    return f"{story} and slides to the end; {outcome}."
