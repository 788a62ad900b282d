"""How much each collision is damped, by η or by ε_n; sorted, for one η is followed at a time."""

from collections.abc import Iterator, Mapping
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

from restitution.bounds import Misfit, allowed, interval, requirement
from restitution.errors import CostError, ParameterError, require
from restitution.mechanics.contact import damping_of
from restitution.mechanics.hertz import FloatArray
from restitution.methods.options import UNDAMPED, Damping, NormalRestitution
from restitution.studies.collision.parameters import numbers

Told = TypeVar("Told")

MOST_DAMPINGS = 2000
"""Different η > 0 in one request: at 0.05 ms each, 1.2 ms at worst, two seconds at most."""


MOST_RESTITUTIONS = MOST_DAMPINGS // 4
"""Different ε_n in one request: three normal motions to find the η of each, and its own."""


def told_twice(
    given: Mapping[str, Any], damping: str = "damping", restitution: str = "normal_restitution"
) -> Iterator[Misfit]:
    """Yield that a damping is told in two ways."""
    if damping in given and restitution in given:
        yield restitution, f"left out, as {damping} is given"


def no_way_with(given: Mapping[str, Any], restitution: npt.ArrayLike) -> Iterator[Misfit]:
    """Yield that a method is asked for that knows no damping, before that of ε_n is found."""
    reason = UNDAMPED.get(str(given.get("method")))
    if reason and np.any(np.not_equal(restitution, 1.0)):
        yield "method", f"another one with normal_restitution below 1: {reason}"


def damping_told(damping: Told, normal_restitution: float | None) -> Told | float:
    """Return η, or an axis of it, or the η of ε_n where this is given.

    Raises
    ------
    ParameterError
        If both are given, or ε_n is out of range.
    CostError
        If there are too many different ε_n.

    Examples
    --------
    >>> round(damping_told(0.0, 0.9), 8), damping_told(0.1, None)
    (0.09283811, 0.1)
    """
    if normal_restitution is None:
        return damping
    restitution = allowed("normal_restitution", normal_restitution, NormalRestitution)
    return float(dampings_told(damping, restitution))


def dampings_told(damping: Any, normal_restitution: npt.ArrayLike | None) -> npt.NDArray[Any]:
    """Return the same of arrays of any shape."""
    if normal_restitution is None:
        return numbers("damping", damping, Damping)
    restitutions = numbers("normal_restitution", normal_restitution, NormalRestitution)
    low, high = interval(NormalRestitution)
    fit = (restitutions >= low) & (restitutions <= high)
    require("normal_restitution", restitutions, fit, requirement(NormalRestitution))
    # 0 is what there is if nothing is given
    given = ("damping", "normal_restitution") if np.any(damping) else ()
    for name, words in told_twice(dict.fromkeys(given)):
        raise ParameterError(name, normal_restitution, words)
    different, place = np.unique(restitutions, return_inverse=True)
    if different.size > MOST_RESTITUTIONS:
        raise CostError(
            f"{different.size:,} different values of normal_restitution in one request are more "
            f"than {MOST_RESTITUTIONS:,}, the limit: it takes several normal motions to find the "
            "damping of each"
        )
    found = np.array([damping_of(each) for each in different.tolist()])
    return found[place].reshape(restitutions.shape)


def refuse_more_dampings(count: int) -> None:
    """Raise `CostError` for more than `MOST_DAMPINGS` different η."""
    if count > MOST_DAMPINGS:
        raise CostError(
            f"{count:,} different values of damping in one request are more than "
            f"{MOST_DAMPINGS:,}, the limit: each needs a normal motion of its own"
        )


def by_damping(damping: FloatArray) -> list[tuple[float, npt.NDArray[np.intp]]]:
    """Return each different η of `damping` (N,), rising, with the places that have it, rising.

    Examples
    --------
    >>> [(eta, places.tolist()) for eta, places in by_damping(np.array([0.3, 0.0, 0.3]))]
    [(0.0, [1]), (0.3, [0, 2])]
    """
    different, group = np.unique(damping, return_inverse=True)
    order = np.argsort(group, kind="stable")
    parts = np.split(order, np.cumsum(np.bincount(group))[:-1])
    return list(zip(different.tolist(), parts, strict=True))
