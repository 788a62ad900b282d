"""Collisions without damping in high precision: slow, plain, and independent of the library.

Nothing of ``restitution`` is used here and no theorem about where a switch may lie: every
episode is walked through on a dense grid of times; a change of sign between two neighbours is
bracketed, and so is every minimum, for it may hide two changes of sign. Forty guard digits take
the place of care at double zeros and at both ends of the contact. Scaled as in Eqs. 17-24 of
Schwager, Becker & Pöschel (2008), spring and surface velocity divided by μ/α.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from functools import lru_cache
from heapq import merge
from typing import TYPE_CHECKING, Any, NamedTuple

from mpmath import mp, mpf

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    Watch = Callable[[Any], "Look"]

Real = Any  # mpmath ships no types
GUARD_DIGITS = 40
POINTS_PER_PERIOD = 32  # of the free spring
UNIFORM_POINTS = 512  # over the contact, at least
END_OCTAVES = 220  # enough for both ends of the contact where κψ > 1e-30
START_OCTAVES = 70  # and the start of an episode to 2**-70 of the grid's spacing there


@dataclass(frozen=True)
class HighPrecisionCollision:
    """What `collide` finds; times are scaled by β^{-2/5} g_n^{-1/5}."""

    epsilon_t: Real
    switches: int
    reversals: int
    nearest_grazing: Real
    switch_times: tuple[Real, ...]


class Look(NamedTuple):
    """The tangential motion at one instant: each gap with its rate; an episode ends at gap < 0."""

    gaps: tuple[tuple[Real, Real], ...]
    elongation: Real
    velocity: Real


class NormalMotion:
    """ẍ = -x^{3/2}, x(0) = 0, ẋ(0) = 1 at the working precision.

    x = t y(w) with w = t^{5/2} and, term by term, (1 + 5n/2)(5n/2) yₙ = -[y^{3/2}]ₙ₋₁; used up to
    the largest compression, where w is a sixth of the radius of convergence, and mirrored beyond.
    """

    def __init__(self) -> None:
        self.duration = (mpf(4) / 5) ** (mpf(3) / 5) * mp.beta(mpf(2) / 5, mpf(1) / 2)
        self._bits = mp.prec + 20
        with mp.workprec(self._bits + 20):
            half_w = (self.duration / 2) ** (mpf(5) / 2)
            y: list[Real] = [mpf(1)]  # the series in w / half_w, so that no power exceeds 1
            power: list[Real] = []
            while abs(y[-1]) > mp.ldexp(1, -self._bits):
                n = len(power)
                # J. C. P. Miller's recurrence for [y^{3/2}]ₙ.
                terms = ((5 * k - 2 * n) * y[k] * power[n - k] for k in range(1, n + 1))
                power.append(mp.fsum(terms) / (2 * n) if n else mpf(1))
                degree = mpf(5 * (n + 1)) / 2
                y.append(-half_w * power[n] / ((1 + degree) * degree))
            # Horner's scheme in integers is ten times as fast as in mpf.
            pairs = [(c, (1 + mpf(5 * n) / 2) * c) for n, c in enumerate(y)]
            self._terms = [[int(mp.ldexp(c, self._bits)) for c in pair] for pair in pairs[::-1]]

    def at(self, time: Real) -> tuple[Real, Real, Real, Real]:
        """Return ẋ, the cap x^{3/2}, and the cap's two derivatives at a time in [0, t_c]."""
        side = 1 if 2 * time <= self.duration else -1
        distance = time if side == 1 else self.duration - time
        if distance <= 0:
            return mpf(side), mpf(0), mpf(0), mp.inf
        share = 2 * distance / self.duration
        w = int(mp.ldexp(share**2 * mp.sqrt(share), self._bits))
        y = v = 0
        for y_term, v_term in self._terms:
            y = y_term + (y * w >> self._bits)
            v = v_term + (v * w >> self._bits)
        x = distance * mp.ldexp(mpf(y), -self._bits)
        x_rate = mp.ldexp(mpf(side * v), -self._bits)
        root = mp.sqrt(x)
        return x_rate, x * root, 1.5 * root * x_rate, 1.5 * (x_rate**2 / (2 * root) - x**2)


_normal_motion = lru_cache(maxsize=4)(lambda _precision: NormalMotion())


def _zero(look: Watch, index: int, part: int, low: Real, high: Real) -> Real:
    """Ridder's method between two times where a gap (part 0) or its rate (1) differs in sign."""

    def function(time: Real) -> Real:
        return look(time).gaps[index][part]

    at_low, at_high, newest = function(low), function(high), low
    while high - low > mp.ldexp(high, 12 - mp.prec):
        middle = (low + high) / 2
        at_middle = function(middle)
        shift = (middle - low) * at_middle / mp.sqrt(at_middle**2 - at_low * at_high)
        previous, newest = newest, middle + (shift if at_low > at_high else -shift)
        at_newest = function(newest)
        if at_newest == 0 or abs(newest - previous) <= mp.ldexp(newest, 12 - mp.prec):
            return newest
        if (at_middle > 0) != (at_newest > 0):
            (low, at_low), (high, at_high) = sorted([(middle, at_middle), (newest, at_newest)])
        elif (at_low > 0) != (at_newest > 0):
            high, at_high = newest, at_newest
        else:
            low, at_low = newest, at_newest
    return (low + high) / 2


class _Walk:
    """One collision, episode by episode."""

    def __init__(self, kappa: Real, psi: Real, octaves: int) -> None:
        self.kappa, self.psi, self.frequency = kappa, psi, mp.sqrt(kappa)
        self.reversals, self.nearest, self._direction = 0, mp.inf, 1
        self.motion = _normal_motion(mp.prec)
        duration = self.motion.duration
        periods = self.frequency * duration / (2 * mp.pi)
        count = max(UNIFORM_POINTS, int(POINTS_PER_PERIOD * periods))
        near = [duration * mp.ldexp(k, -n) for n in range(2, octaves) for k in (1, 1.4)]
        uniform = [duration * k / count for k in range(1, count)]
        self._grid = sorted({*near, *(duration - time for time in near), *uniform, duration})

    def _times_after(self, start: Real) -> Iterator[Real]:
        first = bisect_right(self._grid, start)
        span = self._grid[min(first + 1, len(self._grid) - 1)] - start
        near = (start + mp.ldexp(span, -octave) for octave in range(START_OCTAVES, 0, -1))
        return merge(near, self._grid[first:])

    def _sliding(self, sign: int, start: Real, velocity: Real) -> Watch:
        offset = velocity - sign * self.motion.at(start)[0]

        def look(time: Real) -> Look:
            x_rate, cap, cap_rate, cap_acceleration = self.motion.at(time)
            u = offset + sign * x_rate
            slack = sign * u - cap_rate / self.kappa, -cap - cap_acceleration / self.kappa
            return Look((slack,), sign * cap / self.kappa, u)

        return look

    def _sticking(self, start: Real, elongation: Real, velocity: Real) -> Watch:
        def look(time: Real) -> Look:
            _, cap, cap_rate, _ = self.motion.at(time)
            cos, sin = mp.cos_sin(self.frequency * (time - start))
            z = elongation * cos + velocity / self.frequency * sin
            u = velocity * cos - self.frequency * elongation * sin
            gaps = ((cap - s * self.kappa * z, cap_rate - s * self.kappa * u) for s in (1, -1))
            return Look(tuple(gaps), z, u)

        return look

    def _note(self, velocity: Real) -> None:
        if velocity * self._direction < 0:
            self.reversals, self._direction = self.reversals + 1, -self._direction

    def _episode_end(self, look: Watch, start: Real) -> tuple[Real, int] | None:
        """When the first gap closes after start, and which; None if none does before t_c."""
        times = self._times_after(start)
        seen = look(before := next(times))
        if min(seen.gaps)[0] <= 0:
            raise ArithmeticError(f"an episode ends where it starts, at {mp.nstr(start)}")
        for time in times:
            now, ends = look(time), []
            self._note(seen.velocity)
            for index, (gap, rate) in enumerate(now.gaps):
                high, least = time, gap
                if seen.gaps[index][1] < 0 < rate:
                    high, least = self._minimum(look, index, before, time)
                if least < 0:
                    ends.append((_zero(look, index, 0, before, high), index))
            if ends:
                end, index = min(ends)
                self._note(look(end).velocity)
                if now.gaps[index][1] <= 0:
                    self._overshoot(look, index, time, times)
                return end, index
            before, seen = time, now
        self._note(seen.velocity)
        self.nearest = min(self.nearest, seen.gaps[0][0])
        return None

    def _minimum(self, look: Watch, index: int, low: Real, high: Real) -> Any:
        """Where a gap has its minimum between two times, and how deep it is."""
        gap = look(time := _zero(look, index, 1, low, high)).gaps[index][0]
        self.nearest = min(self.nearest, abs(gap))
        return time, gap

    def _overshoot(self, look: Watch, index: int, before: Real, times: Iterator[Real]) -> None:
        """Note how far below zero the gap would have gone, had the episode not ended."""
        for time in times:
            gap, rate = look(time).gaps[index]
            if rate > 0:
                self._minimum(look, index, before, time)
            if rate > 0 or -gap > self.nearest:
                return
            before = time
        # Sticking cannot last to t_c, where the cap is zero: no grazing, however small the gap.
        if len(gaps := look(before).gaps) == 1:
            self.nearest = min(self.nearest, -gaps[0][0])

    def run(self) -> HighPrecisionCollision:
        """Slide, stick, slide, ... until the contact ends."""
        sign, start, velocity, switch_times = 1, mpf(0), self.psi, []
        while end := self._episode_end(look := self._sliding(sign, start, velocity), start):
            switch_times.append(start := end[0])
            look = self._sticking(start, look(start).elongation, look(start).velocity)
            end = self._episode_end(look, start)
            if end is None:
                raise ArithmeticError("the contact must end sliding: the cap is zero there")
            switch_times.append(start := end[0])
            sign, velocity = (1, -1)[end[1]], look(start).velocity
        epsilon_t = look(self.motion.duration).velocity / self.psi
        found = len(switch_times), self.reversals, self.nearest, tuple(switch_times)
        return HighPrecisionCollision(epsilon_t, *found)


def collide(
    kappa: str, psi: str, digits: int = 60, octaves: int = END_OCTAVES
) -> HighPrecisionCollision:
    """Follow one collision, undamped, from event to event.

    Parameters
    ----------
    kappa, psi
        κ of Eq. 24 and ψ = (α/μ)(g_t/g_n), both > 0, read as exact decimals.
    digits
        Digits wanted; forty more are carried.
    octaves
        Both ends of the contact are resolved down to 2**-octaves of its duration.

    Returns
    -------
    HighPrecisionCollision
        ``epsilon_t`` = u(t_c)/u(0), ``switches``, ``reversals`` (sign changes of u within the
        contact), ``switch_times``, and ``nearest_grazing``: the smallest |gap| at a minimum of a
        gap, x^{3/2} ∓ κz while sticking and s u - d/dt(x^{3/2}/κ) while sliding (t_c included),
        in scaled units. At a positive one an episode did not end (else two switches more); one
        that ended is continued to its next, negative minimum (else two switches fewer).
    """
    with mp.workdps(digits + GUARD_DIGITS):
        return _Walk(mpf(kappa), mpf(psi), octaves).run()
