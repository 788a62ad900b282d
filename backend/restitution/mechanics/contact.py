"""What a contact is asked, with damping or without: the answers are in `elastic`, `viscoelastic`.

Eq. 1, scaled as in `hertz`: ẍ + x^{3/2} + η √x ẋ = 0 with x(0) = 0, ẋ(0) = 1 and
η = (3/2) A β^{2/5} g_n^{1/5}. The contact ends when the *force* is zero, x + ηẋ = 0 with ẋ < 0
(delayed recovery of the shape). An older convention ends it at x = 0, which lets the spheres
attract each other at last: ε_n is smaller, by (4/15) ε_n^{3/2} η^{5/2} for weak damping, and t_c
longer, by η. At η = .1 they are .89215 and 3.25729 then, not .89286 and 3.15726; at η = 1 .3312
and 3.828, not .3939 and 2.752.
"""

import functools
import math
from collections.abc import Callable
from typing import Concatenate, ParamSpec, TypeVar

import numpy as np
import numpy.typing as npt

from restitution.errors import ParameterError
from restitution.mechanics import elastic, viscoelastic
from restitution.mechanics.compiled import chosen_by_type, compiled
from restitution.mechanics.damped import sliding
from restitution.mechanics.damped.motion import Viscoelastic, damped_motion, rate_at
from restitution.mechanics.damped.preparing import MOST_STEPS, prepare
from restitution.mechanics.elastic import Elastic
from restitution.mechanics.hertz import MAXIMUM_COMPRESSION, FloatArray

Contact = Elastic | Viscoelastic

Parameters = ParamSpec("Parameters")
Answer = TypeVar("Answer")

ELASTIC = Elastic()

MOST_DAMPING = 1e30
"""Largest η that is followed: from 1e10 on less than 1e-16 of the velocity is left (ε_n)."""

LEAST_DAMPING = 1e-100
"""η below which it is followed as this one: ε_t is the same to the last digit."""

LEAST_LOAD = 1e-49
"""κψ above which the count is, too: the first sticking ends where it is about 2√η."""

LEAST_RESTITUTION = 1.5e-50
"""Smallest ε_n whose η is found; that of `MOST_DAMPING` is 1.31e-50."""

WEAK_LOSS, STRONG_LOSS = 0.692, 0.8503
"""Of ε_n^{-3/5} − 1 over η, the limits: just below that for η → 0, just above that for η → ∞."""

HALVINGS = 60
"""Of a bracket: of the largest compression, where it is flat anyway, and at most of an η."""


def by_contact(
    undamped: Callable[Concatenate[Elastic, Parameters], Answer],
    damped: Callable[Concatenate[Viscoelastic, Parameters], Answer],
) -> Callable[Concatenate[Contact, Parameters], Answer]:
    """Return the function that is one or the other by the type of the contact.

    In kernels the choice is made when they are compiled, so that it costs nothing.
    """

    def chosen(contact: Contact, /, *rest: Parameters.args, **named: Parameters.kwargs) -> Answer:
        if isinstance(contact, Elastic):
            return undamped(contact, *rest, **named)
        return damped(contact, *rest, **named)

    chosen_by_type(chosen, Elastic, undamped, damped)
    return chosen


spring_in = by_contact(elastic.spring_in, viscoelastic.spring_in)
sliding_end = by_contact(elastic.sliding_end, sliding.sliding_end)
sticking_end = by_contact(elastic.sticking_end, viscoelastic.sticking_end)
expected_switches = by_contact(elastic.expected_switches, viscoelastic.expected_switches)
stiffest_within = by_contact(elastic.stiffest_within, viscoelastic.stiffest_within)
rounding_bound = by_contact(elastic.rounding_bound, viscoelastic.rounding_bound)
energy_bound = by_contact(elastic.energy_bound, viscoelastic.energy_bound)
at_place = by_contact(elastic.at_place, viscoelastic.at_place)
at_time = by_contact(elastic.at_time, viscoelastic.at_time)


@functools.lru_cache(maxsize=64)
def _kept(damping: float) -> Viscoelastic:
    contact = prepare(max(damping, LEAST_DAMPING), MOST_STEPS)
    if contact.rising == 0:
        raise ArithmeticError(f"the end of the contact was not found for damping = {damping!r}")
    return contact if damping >= LEAST_DAMPING else contact._replace(least_load=LEAST_LOAD)


def contact_of(damping: float) -> Contact:
    """Return the contact of one η ≥ 0, prepared in less than 1 ms of CPU and kept.

    Raises
    ------
    ParameterError
        Unless 0 ≤ η ≤ `MOST_DAMPING`.

    Examples
    --------
    >>> round(-contact_of(0.1).last_rate, 8)
    0.89285888
    """
    if damping == 0.0:
        return ELASTIC
    if not 0.0 < damping <= MOST_DAMPING:
        requirement = f"from 0 to {MOST_DAMPING:g}, up to which the contact is followed"
        raise ParameterError("damping", damping, requirement)
    return _kept(float(damping))


def normal_restitution(damping: float) -> float:
    """Return ε_n, the coefficient of normal restitution; 1 for η = 0."""
    return -contact_of(damping).last_rate


@functools.lru_cache(maxsize=64)
def damping_of(normal_restitution: float) -> float:
    """Return the η ≥ 0 of a contact whose ε_n is known.

    Parameters
    ----------
    normal_restitution : float
        ε_n from `LEAST_RESTITUTION` to 1.

    Returns
    -------
    float
        Whose ε_n, as `normal_restitution` has it, is the given one within 4e-15, and within 5e-14
        of itself. So η is off by up to 4e-15 near ε_n = 1, and by 3e-14 of itself near 0.

    Notes
    -----
    ε_n falls from 1 − 1.1534η to 1.3104 η^{-5/3}, so that ε_n^{-3/5} − 1 is between 0.692 η and
    0.8503 η: that is the bracket. It takes up to three normal motions.

    Examples
    --------
    >>> round(damping_of(0.9), 8), damping_of(1.0)
    (0.09283811, 0.0)
    """
    if normal_restitution == 1.0:
        return 0.0
    wanted = _loss(normal_restitution)
    low, high = wanted / STRONG_LOSS, wanted / WEAK_LOSS
    # between the limits, within some thousandths over all η
    share = 1.0 / (1.0 + 1.79 * (0.75 / wanted) ** 0.8)
    slope = WEAK_LOSS + (STRONG_LOSS - WEAK_LOSS) * share
    damping: float = wanted / slope
    last: tuple[float, float] | None = None
    for _ in range(HALVINGS):
        excess = _loss(-prepare(damping, MOST_STEPS).last_rate) - wanted
        low, high = (low, damping) if excess > 0.0 else (damping, high)
        if last and last[0] != damping:
            slope = (excess - last[1]) / (damping - last[0])
        better = damping - excess / slope
        if not low <= better <= high:
            better = 0.5 * (low + high)
        # what such a step leaves is its square, or rounding
        done = abs(better - damping) <= 1e-8 * damping + 4e-15
        damping, last = better, (damping, excess)
        if done:
            break
    return damping


def _loss(normal_restitution: float) -> float:
    """Return ε_n^{-3/5} − 1, about 0.7 to 0.85 η."""
    return math.expm1(-0.6 * math.log(normal_restitution))


def contact_duration(damping: float) -> float:
    """Return t_c of one η ≥ 0, scaled by t_scale."""
    contact = contact_of(damping)
    return contact.duration / contact.unit


def largest_force(damping: float) -> float:
    """Return the largest normal force of one η ≥ 0, scaled."""
    contact = contact_of(damping)
    return contact.peak * contact.unit


def largest_compression(damping: float) -> float:
    """Return the largest compression of one η ≥ 0, scaled.

    It comes after the largest force: damping takes from the force what the spheres slow down.

    Examples
    --------
    >>> round(largest_compression(0.0), 6), round(largest_compression(0.1), 6)
    (1.093362, 1.045597)
    """
    contact = contact_of(damping)
    if isinstance(contact, Elastic):
        return MAXIMUM_COMPRESSION
    low, high = 0.0, contact.falling_end
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        _, _, loss, _ = damped_motion(contact, True, middle)
        if rate_at(contact, True, loss) < 0.0:
            low = middle
        else:
            high = middle
    root, _, _, _ = damped_motion(contact, True, high)
    return root * root / contact.unit


@compiled
def _normal_curves(contact: Contact, time: FloatArray, curves: FloatArray) -> None:
    """Fill the rows x, ẋ, P of `curves` (3, N) at the times `time` (N,)."""
    for i in range(time.size):
        now = at_time(contact, time[i])
        curves[0, i] = now.root * now.root / contact.unit
        curves[1, i] = contact.last_rate + now.loss if now.falling else 1.0 - now.loss
        curves[2, i] = now.root * now.cap * contact.unit


def normal_curves(time: npt.ArrayLike, damping: float = 0.0) -> FloatArray:
    """Return compression, its rate and the normal force during a contact.

    Parameters
    ----------
    time : array_like, shape (...)
        Time since the first touch, scaled by t_scale; 0 … t_c.
    damping : float, optional
        η.

    Returns
    -------
    ndarray, shape (3, ...)
        x, ẋ and F_n, scaled by ξ_scale, g_n and m_eff ξ_scale / t_scale².

    Examples
    --------
    >>> x, rate, _ = normal_curves(0.5 * contact_duration(0.0))
    >>> bool(abs(x - 1.25**0.4) < 1e-15), bool(abs(rate) < 1e-15)
    (True, True)
    """
    contact = contact_of(damping)
    moments = np.asarray(time, dtype=np.float64)
    flat = np.ascontiguousarray(moments.ravel())
    if not np.all((flat >= 0) & (flat <= contact.duration / contact.unit)):
        raise AssertionError("a contact lasts from 0 to its duration")
    curves = np.empty((3, flat.size))
    _normal_curves(contact, flat, curves)
    return curves.reshape(3, *moments.shape)
