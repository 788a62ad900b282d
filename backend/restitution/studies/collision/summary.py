"""One sentence about a collision, as a screen reader says it."""

import math

_TIMES = {1: "once", 2: "twice"}

_LAST_WORD = 0.995
"""|ε_t| from which on the outcome is called that of smooth spheres or of gear wheels."""


_COARSE = 0.005
"""Error of ε_t from which on a percentage cannot be told."""


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %" if share >= 0.01 else "less than 1 %"


def _outcome(epsilon_t: float, error_bound: float) -> str:
    if error_bound > _COARSE:
        most = abs(epsilon_t) + error_bound
        if most >= 1.0:
            return "how much of the tangential velocity is left is not known"
        return f"at most {math.ceil(100 * most)} % of the tangential velocity is left"
    if epsilon_t >= _LAST_WORD:
        return "the surfaces part as fast as they met, like smooth spheres"
    if epsilon_t <= -_LAST_WORD:
        return "the surfaces part in reverse, like gear wheels"
    kept = _percent(abs(epsilon_t))
    if abs(epsilon_t) < 0.001:
        return "almost nothing of the tangential velocity is left"
    return f"{kept} of the tangential velocity is left" + (", reversed" if epsilon_t < 0 else "")


def summarise(
    epsilon_t: float,
    error_bound: float,
    switches: int | None,
    first_slide: float,
    turns: int,
    *,
    resting: bool,
) -> str:
    """Return how the collision went and what is left.

    Parameters
    ----------
    epsilon_t : float
        Coefficient of tangential restitution.
    error_bound : float
        Bound on its error.
    switches : int, or None
        Changes of regime; None if they were not counted.
    first_slide : float
        Share of the contact until the first switch; before it an odd number of switches sticks.
    turns : int
        Sign changes of the surface velocity.
    resting : bool
        True for g_t = 0.
    """
    if resting:
        return (
            "There is no tangential motion; ε_t is the limit of ever smaller tangential velocity."
        )
    outcome = _outcome(epsilon_t, error_bound)
    if switches is None:
        return f"{outcome[0].upper()}{outcome[1:]}."
    if switches == 0:
        return f"Slides during the whole contact; {outcome}."
    if switches % 2:
        # with damping
        story, again = f"Sticks {_percent(first_slide)} of the contact", switches // 2
    else:
        story, again = f"Slides {_percent(first_slide)} of the contact, sticks", switches // 2 - 1
    if again:
        story += f", slips and sticks {_TIMES.get(again, f'{again} times')} more"
    if turns:
        story += f", turns round {_TIMES.get(turns, f'{turns} times')}"
    return f"{story} and slides to the end; {outcome}."
