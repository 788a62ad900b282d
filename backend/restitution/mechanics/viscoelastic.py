"""The damped Hertz contact: what one η makes of the normal motion.

Eq. 1 with A > 0, scaled as in `hertz`: ẍ + x^{3/2} + η √x ẋ = 0 with x(0) = 0, ẋ(0) = 1 and
η = (3/2) A β^{2/5} g_n^{1/5}. The contact ends when the *force* is zero, x + ηẋ = 0 with ẋ < 0
(delayed recovery of the shape). An older convention ends it at x = 0, which lets the spheres
attract each other at last: ε_n is smaller, by (4/15) ε_n^{3/2} η^{5/2} for weak damping, and t_c
longer, by η. At η = .1 they are .89215 and 3.25729 then, not .89286 and 3.15726; at η = 1 .3312
and 3.828, not .3939 and 2.752.
"""

import functools

from restitution.errors import ParameterError
from restitution.mechanics.damped_normal_motion import (
    MOST_STEPS,
    Contact,
    damped_motion,
    prepare,
    rate_at,
)
from restitution.mechanics.hertz import CONTACT_DURATION, MAXIMUM_COMPRESSION, MAXIMUM_FORCE

MOST_DAMPING = 1e30
"""Largest η that is followed: from 1e10 on less than 1e-16 of the velocity is left (ε_n)."""

HALVINGS = 60
"""Of the bracket of the largest compression, where it is flat anyway."""


@functools.lru_cache(maxsize=64)
def _kept(damping: float) -> Contact:
    contact = prepare(damping, MOST_STEPS)
    if contact.rising == 0:
        raise ArithmeticError(f"the end of the contact was not found for damping = {damping!r}")
    return contact


def normal_contact(damping: float) -> Contact:
    """Return the normal motion of one η, prepared in less than 1 ms of CPU and kept.

    Raises
    ------
    ParameterError
        Unless 0 < η ≤ `MOST_DAMPING`.

    Examples
    --------
    >>> round(-normal_contact(0.1).last_rate, 8)
    0.89285888
    """
    if not 0.0 < damping <= MOST_DAMPING:
        requirement = f"> 0 and at most {MOST_DAMPING:g}, up to which the contact is followed"
        raise ParameterError("damping", damping, requirement)
    return _kept(float(damping))


def normal_restitution(damping: float) -> float:
    """Return ε_n, the coefficient of normal restitution; 1 for η = 0."""
    return -normal_contact(damping).last_rate if damping else 1.0


def contact_duration(damping: float) -> float:
    """Return t_c of one η ≥ 0, scaled by t_scale."""
    if not damping:
        return CONTACT_DURATION
    contact = normal_contact(damping)
    return contact.duration / contact.unit


def largest_force(damping: float) -> float:
    """Return the largest normal force of one η ≥ 0, scaled."""
    if not damping:
        return MAXIMUM_FORCE
    contact = normal_contact(damping)
    return contact.peak * contact.unit


def largest_compression(damping: float) -> float:
    """Return the largest compression of one η ≥ 0, scaled.

    It comes after the largest force: damping takes from the force what the spheres slow down.

    Examples
    --------
    >>> round(largest_compression(0.0), 6), round(largest_compression(0.1), 6)
    (1.093362, 1.045597)
    """
    if not damping:
        return MAXIMUM_COMPRESSION
    contact = normal_contact(damping)
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
