"""Sticking in lanes, from the falling cap to the next one: κz is that of a free harmonic."""

import math

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import HALF_CONTACT_ROOT, FloatArray, normal_motion, polynomial
from restitution.mechanics.lanes.elementary import sine_and_cosine
from restitution.mechanics.lanes.rows import (
    BEGIN,
    DOUBT,
    FORCE,
    LOSS,
    OMEGA,
    PULL,
    ROOT,
    SIDE,
    TOWARDS,
    Q,
)
from restitution.mechanics.lanes.sliding import arrive
from restitution.mechanics.roots import SHORT, halley, is_last

PHASE_CONSTANT = (
    12.707659372350655,
    -77.47799254425561,
    164.25983476572432,
    -158.5014484199596,
    76.27874892576425,
    -25.843171735366035,
    10.718631693656373,
    -3.0253405398350095,
    3.131956899389598,
)
PHASE_LINEAR = (
    -208.75414513210808,
    755.3928020613184,
    -1100.2969161293101,
    823.8200065521431,
    -338.4899020118468,
    76.3391682279499,
    -8.482822304510172,
    0.6963430942154121,
    0.020046450065066796,
)
PHASE_SQUARE = (
    234.12265174444397,
    -779.5277207488886,
    1049.0749973170336,
    -737.9030196902683,
    293.2353213347836,
    -66.12798637429442,
    7.922232186220811,
    -0.3463168804251525,
    -0.01098533688073533,
)
PHASE_CUBE = (
    -69.47903498943201,
    217.49259954307885,
    -274.9036397759563,
    183.07995268157828,
    -69.69571344556843,
    15.410554409212512,
    -1.968468323959825,
    0.12936685400713296,
    0.0015759563386229017,
)
"""Of `guessed_phase`, in powers of its m, the highest first: `tests/mechanics/fit_guesses.py`."""


@compiled
def stick_in_decompression(count: int, lanes: FloatArray) -> None:
    """Move `count` lanes from the cap to the next one, on the other side, after z = 0.

    docs/model.md, "Events without search", Sticking 4.
    """
    for i in range(count):
        omega, q, root = lanes[OMEGA + i], lanes[Q + i], lanes[ROOT + i]
        left = q * q
        # seen from the side to which the spring goes
        lanes[FORCE + i] = -root * root * root
        lanes[PULL + i] = 1.5 * root * (1.0 - lanes[LOSS + i]) / omega
        lanes[BEGIN + i] = left
        lanes[SIDE + i] = -lanes[SIDE + i]
        phase = guessed_phase(omega * left, left * left * q)
        lanes[Q + i] = q * math.sqrt(max(0.03, 1.0 - phase / (omega * left)))
    for i in range(count):
        q = lanes[Q + i]
        root, loss = normal_motion(q)
        spring, moving = spring_after(i, lanes, lanes[BEGIN + i] - q * q)
        step, _ = step_to_cap(lanes[OMEGA + i], q, root, loss, spring, moving)
        lanes[Q + i] = min(max(q - step, 0.5 * q), HALF_CONTACT_ROOT)
    for i in range(count):
        q = lanes[Q + i]
        root, loss = normal_motion(q)
        spring, moving = spring_after(i, lanes, lanes[BEGIN + i] - q * q)
        step, change = step_to_cap(lanes[OMEGA + i], q, root, loss, spring, moving)
        meet_cap(i, lanes, q, step, change, spring, moving)
        arrive(i, lanes, q, root, loss, step)


@compiled
def spring_after(i: int, lanes: FloatArray, time: float) -> tuple[float, float]:
    """Return κz and κu/ω of lane i after it has stuck for a time."""
    sine, cosine = sine_and_cosine(lanes[OMEGA + i] * time)
    force, pull = lanes[FORCE + i], lanes[PULL + i]
    return force * cosine + pull * sine, pull * cosine - force * sine


@compiled
def step_to_cap(
    omega: float, q: float, root: float, loss: float, spring: float, moving: float
) -> tuple[float, float]:
    """Return `halley` for x^{3/2} = κz in the decompression; `moving` is κu/ω."""
    rate = 1.0 - loss
    square = root * root
    value = square * root - spring
    # derivatives by the time that is left, of which dt = 2q dq makes those by q
    growth = 1.5 * root * rate + omega * moving
    bend = 0.75 * rate * rate / root - 1.5 * square * square + omega * omega * spring
    return halley(value, 2.0 * q * growth, 2.0 * growth + 4.0 * q * q * bend)


@compiled
def meet_cap(
    i: int,
    lanes: FloatArray,
    q: float,
    step: float,
    change: float,
    spring: float,
    moving: float,
) -> None:
    """Give lane i the velocity at q − `step`, by Taylor's series from κz and κu/ω at q."""
    omega = lanes[OMEGA + i]
    phase = omega * (2.0 * q - step) * step
    lanes[TOWARDS + i] = (moving - phase * (spring + 0.5 * phase * moving)) / omega
    is_there = is_last(q, step, change) and abs(phase) <= SHORT
    lanes[DOUBT + i] += 0.0 if is_there else 1.0


@compiled
def guessed_phase(phase: float, fifth: float) -> float:
    """Return about the phase √κ Δt for which a spring sticks that begins so on the falling cap.

    `phase` is √κ times the time that is left, `fifth` its root to the fifth power. A fit to
    `switching.sticking_end_in_decompression` for κ = 0.1 … 10⁵.
    """
    m = 1.0 / math.sqrt(1.0 + phase)
    constant, linear = polynomial(PHASE_CONSTANT, m), polynomial(PHASE_LINEAR, m)
    square, cube = polynomial(PHASE_SQUARE, m), polynomial(PHASE_CUBE, m)
    return phase / (phase + 3.0) * (constant + fifth * (linear + fifth * (square + fifth * cube)))
