"""Damped collisions in high precision: slow, plain, and independent of the library.

Nothing of ``restitution`` is used here, no closed form and no theorem about where a switch may lie:
normal motion, spring and surface velocity are integrated together by Taylor series of order 34 in
45-digit arithmetic, in τ with dt = 2√x dτ, in which everything is polynomial. Each step is walked
through on a grid that is dense near both its ends; a change of sign of a gap between two neighbours
is bracketed, and so is every minimum. Scaled as in Eqs. 17-24 of Schwager, Becker & Pöschel (2008)
with Eq. 1, spring and surface velocity divided by μ/α.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from mpmath import mp, mpf

Real = Any  # mpmath ships no types
DIGITS = 45
ORDER = 34
GRID = 12
START_OCTAVES = 90  # the start of the contact is resolved down to 2**-90 of a step
OCTAVES = 36  # that of an episode, where a gap has a double zero, to 2**-36


class DampedCollision(NamedTuple):
    """What `collide` finds; times are scaled by β^{-2/5} g_n^{-1/5}."""

    epsilon_t: Real
    epsilon_n: Real
    duration: Real
    switches: int
    nearest_grazing: Real
    switch_times: tuple[Real, ...]


def _product(a: list[Real], b: list[Real], k: int) -> Real:
    return mp.fdot(a[: k + 1], b[k::-1])


class _Step:
    """The series of one step: r = √x, v, t, and the tangential motion in one regime."""

    def __init__(self, kappa: Real, eta: Real, state: dict[str, Real], side: int) -> None:
        r, v, t, y, u = ([state[name]] for name in "rvtyu")
        square, cap_share, cap, pull, load = [], [], [], [], []
        for k in range(ORDER):
            square.append(_product(r, r, k))
            cap_share.append(square[k] + eta * v[k])
            cap.append(_product(r, cap_share, k))
            n = k + 1
            v.append(-2 * _product(square, cap_share, k) / n)
            r.append(v[k] / n)
            t.append(2 * r[k] / n)
            # ẏ = κu and u̇ = −y while sticking; y = side · cap while sliding
            if side:
                y[k] = side * cap[k]
                load.append(y[k])
                y.append(mpf(0))
            else:
                pull.append(kappa * u[k])
                y.append(2 * _product(r, pull, k) / n)
                load.append(y[k])
            u.append(-2 * _product(r, load, k) / n)
        if side:
            y[ORDER] = side * _product(r, [*cap_share, mpf(0)], ORDER)
        cap.append(mpf(0))
        self.series = {"r": r, "v": v, "t": t, "y": y, "u": u, "p": cap}
        if side:
            # 2r (s u − ṗ/κ), finite at r = 0
            rate = [(k + 1) * cap[k + 1] for k in range(ORDER)]
            slack = [2 * side * _product(r, u, k) - rate[k] / kappa for k in range(ORDER - 1)]
            self.gaps = [slack]
        else:
            self.gaps = [[cap[k] - s * y[k] for k in range(ORDER)] for s in (1, -1)]

    def at(self, distance: Real) -> dict[str, Real]:
        """Return the state at a distance in τ."""
        return {
            name: mp.polyval(terms[ORDER - 1 :: -1], distance)
            for name, terms in self.series.items()
        }

    def gap(self, index: int, distance: Real, derivative: int = 0) -> Real:
        """Return a gap or its derivative; an episode ends where a gap falls through 0."""
        terms = self.gaps[index]
        for _ in range(derivative):
            terms = [(k + 1) * c for k, c in enumerate(terms[1:])]
        return mp.polyval(terms[::-1], distance)


def _root(function: Any, low: Real, high: Real) -> Real:
    """Halving, then the secant: `function` differs in sign at both."""
    below = function(low) > 0
    for _ in range(40):
        middle = (low + high) / 2
        if (function(middle) > 0) == below:
            low = middle
        else:
            high = middle
    a, b, fa, fb = low, high, function(low), function(high)
    for _ in range(12):
        if fa == fb or b == a:
            break
        a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
        fb = function(b)
        if abs(b - a) < mpf(10) ** (8 - DIGITS) * abs(b):
            break
    return b


class _Walk:
    """One collision, step by step."""

    def __init__(self, kappa: Real, psi: Real, eta: Real) -> None:
        self.kappa, self.eta = kappa, eta
        self.nearest = mp.inf
        self.psi = psi
        self.step = min(1 / (20 * (1 + mp.cbrt(eta))), 1 / (5 * mp.sqrt(kappa)))
        zero = mpf(0)
        self.state = {"r": zero, "v": mpf(1), "t": zero, "y": zero, "u": psi, "p": zero}

    def _end_of_contact(self, step: _Step) -> Real | None:
        """The distance at which the force vanishes, x + ηẋ = 0 with ẋ < 0; None if not in it."""

        def left(distance: Real) -> Real:
            state = step.at(distance)
            return state["r"] - mp.sqrt(-self.eta * state["v"]) if state["v"] < 0 else mpf(1)

        return _root(left, mpf(0), self.step) if left(self.step) <= 0 else None

    def _first_event(self, step: _Step, length: Real, fresh: bool) -> tuple[Real, int] | None:
        """The first closing of a gap within `length`, and which."""
        grid = [length * k / GRID for k in range(1, GRID + 1)]
        octaves = START_OCTAVES if self.state["t"] == 0 else OCTAVES
        near = [length * mp.ldexp(1, -k) for k in range(octaves, 3, -1)] if fresh else [mpf(0)]
        before = None
        for distance in near + grid:
            found = []
            for index in range(len(step.gaps)):
                gap, rate = step.gap(index, distance), step.gap(index, distance, 1)
                if before is None:
                    continue
                if gap < 0:
                    found.append(
                        (_root(lambda d, i=index: step.gap(i, d), before, distance), index)
                    )
                elif step.gap(index, before, 1) < 0 < rate:
                    low = _root(lambda d, i=index: step.gap(i, d, 1), before, distance)
                    least = step.gap(index, low)
                    self.nearest = min(self.nearest, abs(least))
                    if least < 0:
                        closes = _root(lambda d, i=index: step.gap(i, d), before, low)
                        found.append((closes, index))
            if found:
                return min(found)
            before = distance
        return None

    def walk(self) -> DampedCollision:
        """Follow the collision to its end."""
        side, fresh, times = 0, True, []
        while True:
            step = _Step(self.kappa, self.eta, self.state, side)
            end = self._end_of_contact(step)
            length = self.step if end is None else end
            event = self._first_event(step, length, fresh)
            fresh = event is not None
            if event is not None:
                self._overshoot(step, event, length)
                self.state = step.at(event[0])
                times.append(self.state["t"])
                side = 0 if side else (1, -1)[event[1]]
            else:
                self.state = step.at(length)
                if end is not None:
                    if side:
                        self.nearest = min(self.nearest, abs(step.gap(0, length)))
                    epsilon_n, duration = -self.state["v"], self.state["t"]
                    return DampedCollision(
                        self.state["u"] / self.psi, epsilon_n, duration, len(times),
                        self.nearest, tuple(times),
                    )  # fmt: skip

    def _overshoot(self, step: _Step, event: tuple[Real, int], length: Real) -> None:
        """Note how far the gap would have gone on, at most to the end of the step."""
        distance, index = event
        if step.gap(index, length, 1) > 0 > step.gap(index, distance, 1):
            low = _root(lambda d: step.gap(index, d, 1), distance, length)
            self.nearest = min(self.nearest, abs(step.gap(index, low)))


def collide(kappa: str, psi: str, eta: str) -> DampedCollision:
    """Return the collision of three decimal strings."""
    with mp.workdps(DIGITS):
        return _Walk(mpf(kappa), mpf(psi), mpf(eta)).walk()
