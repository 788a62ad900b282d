"""Where sliding and sticking end: bracketed roots of closed forms.

Divided by m = μ/α the collision has two parameters, κ and ψ = (α/μ)(g_t/g_n): the spring z and
the surface velocity u of this module are the paper's divided by m. Sliding keeps z = s x^{3/2}/κ
and gives u = u₁ + s(ẋ − ẋ₁); sticking is a harmonic of frequency ω = √κ about z = 0.

Every instant is q, the root of the time to the nearer end of the contact (see `hertz`), with a
word on the half. What makes the brackets safe is derived in docs/model.md, "Events without
search"; with r = κ x^{3/2} + d²(x^{3/2})/dt²:

* Sliding ends where the reach R = κ(1 − ẋ) + d(x^{3/2})/dt has grown by κ times the slip rate.
  R' = r, so R is monotone for κ ≥ `MONOTONE_STIFFNESS`; below, it falls between mirror extrema.
* Where sticking begins, z and u are those of the cap: the instant and the side say everything.
  A spring that begins to stick in the decompression meets the cap next on the other side, after
  z = 0 and before its next extremum.
* One that begins to stick at t₀ in the compression meets the cap in the swing during which the
  cap falls below the spring's amplitude: while |z| grows, or while |z| falls, and this exactly
  if the spring would be beyond the cap at the mirror time t_c − t₀.
"""

import math
from typing import NamedTuple

from restitution.mechanics.compiled import compiled
from restitution.mechanics.hertz import (
    CONTACT_DURATION,
    HALF_CONTACT,
    HALF_CONTACT_ROOT,
    MAXIMUM_FORCE,
    normal_motion,
)
from restitution.mechanics.roots import (
    CONVERGED,
    MOST_STEPS,
    NEGLIGIBLE,
    ROUNDING,
    newton_within,
)

MONOTONE_STIFFNESS = 1.56845932888691
"""(21/10 x_max^{5/2} − 3/4)/x_max², rounded up: from here on r > 0 during the whole contact."""


FAINT = 1e-9
"""Force of a spring that the cap meets within the last thousandth of the contact."""

SLOW = 0.1
"""√κ of a spring that hardly moves while the cap falls through it."""

SOFTEST_EXTREMUM = 0.8327964596497018
"""q of the largest reach for κ → 0, where x^{5/2} = 5/14."""

LINEAR = 1e-30
"""Below it R is 1.5 q: the rest, about κq⁵, is below 1e-90 of it where collisions are followed."""


SLIDING_TO_THE_END, COMPRESSING, DECOMPRESSING = 0, 1, 2

NOWHERE = -1.0
"""Stands for a time that there is not."""


class Spring(NamedTuple):
    """The spring of one collision, in the units of the contact."""

    stiffness: float
    """κ."""
    omega: float
    """√κ, its frequency."""
    bend_begin: float
    """Time from which on a damped cap curves away from it in mid-contact, or `NOWHERE`."""
    bend_end: float
    """Time until which it does."""
    error: float
    """Bound on the rounding error of the surface velocity: two motions only approach each other."""


@compiled
def slip_extremum(kappa: float) -> float:
    """Return q where R has its maximum in the compression; κ below `MONOTONE_STIFFNESS`.

    There r = 0, that is κx² + 3/4 − (21/10) x^{5/2} = 0 in √x.
    """
    low, high = 0.0, HALF_CONTACT_ROOT
    q = SOFTEST_EXTREMUM + 0.11 * kappa
    for n in range(MOST_STEPS):
        root, loss = normal_motion(q)
        fourth = root * root * root * root
        value = kappa * fourth + 0.75 - 2.1 * root * fourth
        slope = (4.0 * kappa * fourth / root - 10.5 * fourth) * (1.0 - loss) * q / root
        if value > 0.0:
            low = q
        else:
            high = q
        q, found = newton_within(n, q, value, slope, low, high)
        if found:
            return q
    raise ArithmeticError("the largest reach of sliding was not found")


@compiled
def slip_reach(kappa: float, q: float) -> float:
    """Return R = κ(1 − |ẋ|) + |d(x^{3/2})/dt| at q."""
    root, loss = normal_motion(q)
    return kappa * loss + 1.5 * root * (1.0 - loss)


@compiled
def sliding_root(kappa: float, target: float, guess: float, high: float) -> float:
    """Return q in (0, high) where R(q) = `target`; R is monotone there."""
    if target < LINEAR:
        return min(target / 1.5, high)
    low = 0.0
    q = guess
    for n in range(MOST_STEPS):
        root, loss = normal_motion(q)
        rate = 1.0 - loss
        square = root * root
        fourth = square * square
        value = kappa * loss + 1.5 * root * rate - target
        slope = 2.0 * q * (kappa * fourth + 0.75 * rate * rate - 1.5 * root * fourth) / root
        if value > 0.0:
            high = q
        else:
            low = q
        q, found = newton_within(n, q, value, slope, low, high)
        if found:
            return q
    raise ArithmeticError("the end of sliding was not found")


@compiled
def velocity_to_stop(q: float, decompressing: bool) -> float:
    """Return what the cap can still take from the velocity in the rest of the contact, 1 + ẋ."""
    _, loss = normal_motion(q)
    return loss if decompressing else 2.0 - loss


@compiled
def next_sliding_end(kappa: float, q: float, decompressing: bool, lacking: float) -> float:
    """Return q where sliding ends that began at q and lacks the velocity `lacking` to go on."""
    high = q
    if kappa < MONOTONE_STIFFNESS:
        extremum = slip_extremum(kappa)
        high = min(q, extremum) if decompressing else extremum
    return sliding_root(kappa, kappa * lacking, high, high)


@compiled
def first_sliding_end(kappa: float, psi: float) -> tuple[int, float, bool]:
    """Return in which half the first sliding ends, q there, and whether that is beyond doubt."""
    load = kappa * psi
    threshold = 2.0 * kappa
    compressing = load < kappa
    high = HALF_CONTACT_ROOT
    certain = True
    if kappa < MONOTONE_STIFFNESS:
        high = slip_extremum(kappa)
        reach = slip_reach(kappa, high)
        threshold = max(threshold, reach)
        compressing = load < reach
        # where sliding all but ends in the compression, it jumps from there to the decompression
        certain = abs(load - reach) > 8.0 * ROUNDING * reach
    certain = certain and abs(load - threshold) > 8.0 * ROUNDING * threshold
    if not load < threshold:
        return SLIDING_TO_THE_END, 0.0, certain
    target = load if compressing else kappa * (2.0 - psi)
    guess = min(target / 1.5, (2.5 * target / kappa) ** 0.2, 0.999 * high)
    q = sliding_root(kappa, target, guess, high)
    return (COMPRESSING if compressing else DECOMPRESSING), q, certain


@compiled
def cap_fall(amplitude: float) -> float:
    """Return q where x^{3/2} has fallen to `amplitude`, `HALF_CONTACT_ROOT` if it is never so high.

    √x is concave in q and at most q, so Newton's method rises to the root from below; at the top,
    where the root is double, it still halves the distance.
    """
    cap_root: float = min(amplitude, MAXIMUM_FORCE) ** (1.0 / 3.0)
    q: float = cap_root
    for _ in range(MOST_STEPS):
        root, loss = normal_motion(q)
        step = (cap_root - root) * root / (q * (1.0 - loss))
        if not step > CONVERGED * q:
            return min(q + max(step, 0.0), HALF_CONTACT_ROOT)
        q += step
        if q >= HALF_CONTACT_ROOT:
            return HALF_CONTACT_ROOT
    raise ArithmeticError("the fall of the cap was not found")


@compiled
def decompression_bracket(
    kappa: float, t0: float, p0: float, amplitude: float, lead: float
) -> tuple[float, float, int, bool]:
    """Return q below and above the next cap, its side, and whether that is beyond doubt.

    The spring κz = `amplitude` cos(ω(t − t₀) − `lead`) began to stick at t₀ in the compression,
    with x^{3/2} = p₀; the cap is above it until the decompression.
    """
    omega = math.sqrt(kappa)
    fallen = cap_fall(amplitude)
    swing = round((omega * (CONTACT_DURATION - fallen * fallen - t0) - lead) / math.pi)
    if kappa >= MONOTONE_STIFFNESS:
        # Sticking 1: r > 0 keeps the spring within the cap in the swing in which it begins to stick
        swing = max(swing, 1)
    left = CONTACT_DURATION - t0 - (lead + swing * math.pi) / omega
    certain = True
    if left > 0.0:
        # docs/model.md, "Events without search", Sticking 2: while |z| falls
        root, _ = normal_motion(math.sqrt(min(left, HALF_CONTACT)))
        if root * root * root > amplitude:
            # The extremum stays within the cap. After it the cap is met if z = 0 comes too late,
            # or if the spring is beyond it at the mirror time.
            high = math.sqrt(min(left, HALF_CONTACT))
            mirror = omega * (CONTACT_DURATION - 2.0 * t0) - lead - swing * math.pi
            excess = amplitude * math.cos(min(mirror, math.pi)) - p0
            certain = abs(excess) > 8.0 * ROUNDING * (1.0 + omega) * amplitude
            side = 1 - 2 * (int(swing) & 1)
            if left <= 0.5 * math.pi / omega:
                return 0.0, high, side, certain
            if excess >= 0.0:
                return math.sqrt(t0), high, side, certain
            swing += 1
            left -= math.pi / omega
    # Sticking 3: while |z| grows
    side = 1 - 2 * (int(swing) & 1)
    low = math.sqrt(max(0.0, left))
    if omega * CONTACT_DURATION < 0.5 * math.pi:
        # a soft spring is not back at z = 0 in time, whatever rounding makes of `lead` / ω
        return low, HALF_CONTACT_ROOT, side, certain
    # rounding of a large phase can put z = 0 just behind the end of the contact
    high = math.sqrt(max(0.0, min(left + 0.5 * math.pi / omega, HALF_CONTACT)))
    return low, high, side, certain


@compiled
def sticking_end_after_compression(
    kappa: float, omega: float, q0: float, u0: float
) -> tuple[bool, float, int, float, bool]:
    """Return where a spring that began to stick while compressing, with z > 0, meets the cap.

    Returns
    -------
    decompressing : bool
        In which half.
    q : float
        Root of the time to the nearer end of the contact.
    side : int
        Sign of the spring there.
    u : float
        Surface velocity there.
    certain : bool
        False if rounding decides whether one more swing stays within the cap.
    """
    root, _ = normal_motion(q0)
    p0 = root * root * root
    v0 = omega * u0
    t0 = q0 * q0
    amplitude = math.hypot(p0, v0)
    lead = math.atan2(v0, p0)
    decompressing = True
    if kappa < MONOTONE_STIFFNESS and amplitude >= MAXIMUM_FORCE:
        # Sticking 5: the cap is below the amplitude throughout, met before the first extremum
        side, certain = 1, True
        peak = t0 + lead / omega
        middle = omega * (HALF_CONTACT - t0)
        high = HALF_CONTACT_ROOT
        decompressing = not (
            peak < HALF_CONTACT or p0 * math.cos(middle) + v0 * math.sin(middle) > MAXIMUM_FORCE
        )
        if decompressing:
            low = math.sqrt(max(0.0, CONTACT_DURATION - peak))
        else:
            low, high = slip_extremum(kappa), math.sqrt(min(peak, HALF_CONTACT))
    else:
        low, high, side, certain = decompression_bracket(kappa, t0, p0, amplitude, lead)
    q, u = cap_contact(omega, t0, p0, u0, decompressing, side, low, high)
    root, _ = normal_motion(q)
    # a spring that meets the cap next to z = 0 may, for all its rounded phase tells, be behind it;
    # a soft one has hardly left z = 0 when it meets it, and its small phase is as small in error
    phase = min(1.0 + omega, CONTACT_DURATION * omega)
    beyond_phase = root * root * root > 8.0 * ROUNDING * phase * amplitude
    return decompressing, q, side, u, certain and beyond_phase


@compiled
def cap_contact(
    omega: float,
    t0: float,
    p0: float,
    u0: float,
    decompressing: bool,
    side: int,
    low: float,
    high: float,
) -> tuple[float, float]:
    """Return q in (low, high) where `side` κz = x^{3/2}, and u there."""
    origin = CONTACT_DURATION - t0 if decompressing else -t0
    sense = -1.0 if decompressing else 1.0
    v0 = omega * u0
    q = high
    if decompressing and (omega < SLOW or p0 + v0 * min(omega, 1.0) < FAINT):
        # the force at the end of the contact is about that at the meeting, and q its cube root;
        # Newton's method would be long on its way from the middle of the contact
        last = side * (p0 * math.cos(omega * origin) + v0 * math.sin(omega * origin))
        q = min(max(low, max(last, 0.0) ** (1.0 / 3.0), 0.5 * NEGLIGIBLE), high)
    for n in range(MOST_STEPS):
        root, loss = normal_motion(q)
        angle = omega * (origin + sense * q * q)
        sine, cosine = math.sin(angle), math.cos(angle)
        value = root * root * root - side * (p0 * cosine + v0 * sine)
        spring_slope = 2.0 * sense * side * omega * (v0 * cosine - p0 * sine)
        slope = q * (3.0 * root * (1.0 - loss) - spring_slope)
        # the spring comes from below the cap: from larger q when decompressing
        if (value > 0.0) == decompressing:
            high = q
        else:
            low = q
        q, found = newton_within(n, q, value, slope, low, high)
        if found:
            angle = omega * (origin + sense * q * q)
            return q, u0 * math.cos(angle) - p0 / omega * math.sin(angle)
    raise ArithmeticError("the end of the first sticking was not found")


@compiled
def sticking_end_in_decompression(omega: float, q0: float, speed: float) -> tuple[float, float]:
    """Return q at the next cap, on the other side, and the velocity towards that side there.

    The spring began to stick at q₀ on the cap, at `speed` towards z = 0, at least that of the cap:
    κz is −`amplitude` sin(ω(t − t_zero)) times the side that it leaves.
    """
    root, _ = normal_motion(q0)
    p0 = root * root * root
    amplitude = math.hypot(p0, omega * speed)
    zero = max(0.0, q0 * q0 - math.atan2(p0, omega * speed) / omega)
    low = math.sqrt(max(0.0, zero - 0.5 * math.pi / omega))
    high = math.sqrt(zero)
    q = high
    for n in range(MOST_STEPS):
        root, loss = normal_motion(q)
        angle = omega * (zero - q * q)
        sine, cosine = math.sin(angle), math.cos(angle)
        value = root * root * root - amplitude * sine
        slope = q * (3.0 * root * (1.0 - loss) + 2.0 * omega * amplitude * cosine)
        if value > 0.0:
            high = q
        else:
            low = q
        q, found = newton_within(n, q, value, slope, low, high)
        if found:
            return q, math.hypot(p0 / omega, speed) * math.cos(omega * (zero - q * q))
    raise ArithmeticError("the end of sticking was not found")
