"""Numbers of switches in ball arithmetic: slow, plain, and independent of the library.

Nothing of ``restitution`` is used here and no theorem about where a switch may lie. The normal
motion is a chain of Taylor series in τ, dt = 2√x dτ, in which it is polynomial; sliding takes from
the surface velocity what it takes from the normal one, and sticking is a harmonic. An interval of
τ holds no end of an episode if the ball of a gap over it lies above zero; else it is halved, until
the gap is monotone in it. 77 digits are carried, three times as many where that is too few; all
but the remainders of the series, below 1e-70, are bounded by the balls. Scaled as in Eqs. 17-24
of Schwager, Becker & Pöschel (2008) with Eq. 1, spring and surface velocity divided by μ/α.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import lru_cache
from typing import Any, NamedTuple

from flint import arb, arb_poly, ctx

BITS = 256
MORE_BITS = 768
MOST_HALVINGS = 600

Real = Any  # python-flint ships no types


class UndecidedError(ArithmeticError):
    """Two of the balls overlap that must not: the collision lies on a border, or nearly so."""


class Point(NamedTuple):
    """The normal motion over a ball of τ."""

    root: Real  # √x
    rate: Real  # ẋ
    share: Real  # p/√x = x + ηẋ
    time: Real


class Gap(NamedTuple):
    """What an episode ends at when it falls through 0, and its derivatives in τ."""

    value: Real
    rate: Real
    bend: Real


class NormalMotion:
    """Eq. 1 from the touch to the end of the force, where x + ηẋ = 0 with ẋ < 0."""

    def __init__(self, damping: float) -> None:
        self.eta = arb(damping)
        self.step = arb(1) / (16 * int(1 + damping ** (1 / 3)))
        self._terms = 4 + ctx.prec // 4
        self._pieces: list[list[Any]] = []
        state = Point(arb(0), arb(1), self.eta, arb(0))
        while not state.rate < 0 or self._left(state) > 0:
            self._pieces.append(self._expanded(state))
            state = self.over(len(self._pieces) * self.step, len(self._pieces) - 1)
            # one of the columns follows from two others
            share = state.root * state.root + self.eta * state.rate
            state = state._replace(share=share)
        self.ends = [(i + 1) * self.step for i in range(len(self._pieces) - 1)]
        self.ends.append(self._end())

    def _expanded(self, state: Point) -> list[Any]:
        r, v, c, t = ([column] for column in state)
        forces, drives = [], []
        for k in range(self._terms):
            forces.append(_product(r, c, k))
            drives.append(v[k] - self.eta * forces[k])
            r.append(v[k] / (k + 1))
            v.append(-2 * _product(r, forces, k) / (k + 1))
            c.append(2 * _product(r, drives, k) / (k + 1))
            t.append(2 * r[k] / (k + 1))
        return [arb_poly(column) for column in (r, v, c, t)]

    def _left(self, point: Point) -> Real:
        """Positive before the end of the contact, where it has a simple zero."""
        return point.root - (-self.eta * point.rate).sqrt()

    def _end(self) -> Real:
        piece = len(self._pieces) - 1
        low, high = piece * self.step, (piece + 1) * self.step
        for _ in range(ctx.prec - 30):
            middle = ((low + high) / 2).mid()
            point = self.over(middle, piece)
            if point.rate < 0 and self._left(point) < 0:
                high = middle
            else:
                low = middle
        return low.union(high)

    def over(self, place: Real, piece: int) -> Point:
        """Return the motion at a place in τ or over a ball of them, within one piece."""
        distance = place - piece * self.step
        return Point(*(column(distance) for column in self._pieces[piece]))

    def cap(self, p: Point) -> Gap:
        """Return the force √x (x + ηẋ) and its derivatives in τ."""
        r, v, c, _ = p
        force = r * c
        dv, dc = -2 * r * force, 2 * r * (v - self.eta * force)
        square = r * r
        slope = v * (c + 2 * square) - 2 * self.eta * square * force
        outer = dv * (c + 2 * square) + v * (dc + 4 * r * v)
        return Gap(force, slope, outer - 2 * self.eta * square * (3 * v * c + r * dc))


def _product(a: list[Real], b: list[Real], k: int) -> Real:
    total = a[0] * b[k]
    for i in range(1, k + 1):
        total += a[i] * b[k - i]
    return total


class Episode(ABC):
    """From one switch to the next."""

    def __init__(self, motion: NormalMotion, kappa: Real) -> None:
        self.motion, self.kappa = motion, kappa

    @abstractmethod
    def gaps(self, p: Point) -> list[Gap]:
        """Return what the episode ends at, the spring's side 1 first."""

    @abstractmethod
    def spring(self, p: Point) -> tuple[Real, Real]:
        """Return κz and the surface velocity."""


class Sliding(Episode):
    """Ends where the slip rate s u − ṗ/κ falls through zero."""

    def __init__(
        self, motion: NormalMotion, kappa: Real, side: int, start: Point, velocity: Real
    ) -> None:
        super().__init__(motion, kappa)
        self.side, self._offset = side, velocity - side * start.rate

    def spring(self, p: Point) -> tuple[Real, Real]:
        """Return κz and the surface velocity."""
        return self.side * p.root * p.share, self._offset + self.side * p.rate

    def gaps(self, p: Point) -> list[Gap]:
        """Return twice the slip rate, which is finite at both ends of the contact."""
        r, v, c, _ = p
        force = r * c
        if self.motion.eta == 0:
            rise, bend = 3 * r * v, 3 * (v * v - 2 * r * r * force)
        else:
            cap = self.motion.cap(p)
            rise, bend = cap.rate / r, (cap.bend - cap.rate * v / r) / r
        _, velocity = self.spring(p)
        value = 2 * self.side * velocity - rise / self.kappa
        return [Gap(value, -4 * r * force - bend / self.kappa, arb.nan())]


class Sticking(Episode):
    """Ends where the spring's force passes the cap on either side."""

    def __init__(
        self, motion: NormalMotion, kappa: Real, start: Point, load: Real, velocity: Real
    ) -> None:
        super().__init__(motion, kappa)
        self._omega, self._since = kappa.sqrt(), start.time
        self._load, self._pull = load, self._omega * velocity

    def spring(self, p: Point) -> tuple[Real, Real]:
        """Return κz and the surface velocity."""
        sine, cosine = (self._omega * (p.time - self._since)).sin_cos()
        velocity = (self._pull * cosine - self._load * sine) / self._omega
        return self._load * cosine + self._pull * sine, velocity

    def gaps(self, p: Point) -> list[Gap]:
        """Return the distances of the spring's force from the cap on both sides."""
        load, velocity = self.spring(p)
        speed = 2 * self.kappa * velocity
        growth = p.root * speed
        bend = p.rate * speed - 4 * p.root * p.root * self.kappa * load
        cap = self.motion.cap(p)
        return [
            Gap(cap.value - s * load, cap.rate - s * growth, cap.bend - s * bend) for s in (1, -1)
        ]


class _Walk:
    """One collision, episode by episode."""

    def __init__(self, kappa: float, psi: float, damping: float) -> None:
        self.motion = _normal_motion(damping, ctx.prec)
        self.kappa, self.psi = arb(kappa), arb(psi)

    def run(self) -> tuple[int, Real]:
        motion = self.motion
        start = motion.over(arb(0), 0)
        episode: Episode
        if motion.eta == 0:
            episode = Sliding(motion, self.kappa, 1, start, self.psi)
        else:
            episode = Sticking(motion, self.kappa, start, arb(0), self.psi)
        switches, begin = 0, arb(0)
        while found := self._end(episode, begin):
            switches += 1
            place, piece, index = found
            here = motion.over(place, piece)
            load, velocity = episode.spring(here)
            if isinstance(episode, Sliding):
                side = episode.side
                episode = Sticking(motion, self.kappa, here, load, velocity)
                begin = self._leaving(episode, place, piece, side)
            else:
                episode = Sliding(motion, self.kappa, (1, -1)[index], here, velocity)
                begin = place
        _, velocity = episode.spring(motion.over(motion.ends[-1], len(motion.ends) - 1))
        return switches, velocity / self.psi

    def _end(self, episode: Episode, begin: Real) -> tuple[Real, int, int] | None:
        """Return where the episode ends, in which piece, and at which gap."""
        motion = self.motion
        for piece, end in enumerate(motion.ends):
            if end < begin:
                continue
            low = begin if piece == 0 or begin > motion.ends[piece - 1] else motion.ends[piece - 1]
            gaps = range(2 if isinstance(episode, Sticking) else 1)
            found = [
                (root, piece, index)
                for index in gaps
                if (root := self._first(episode, index, piece, low, end)) is not None
            ]
            if len(found) == 2 and not found[0][0] < found[1][0]:
                return found[1]
            if found:
                return found[0]
        if isinstance(episode, Sticking):
            raise UndecidedError("a spring that sticks until the end of the contact")
        return None

    def _leaving(self, sticking: Sticking, place: Real, piece: int, side: int) -> Real:
        """Return a place until which the spring is off the cap that it left at rest to it."""
        end = self.motion.ends[piece]
        index = 0 if side == 1 else 1
        width = end - place
        for _ in range(MOST_HALVINGS):
            width = width / 2
            high = (place + width).mid()
            if sticking.gaps(self.motion.over(place.union(high), piece))[index].bend > 0:
                return high
        raise UndecidedError("the cap is not left")

    def _first(
        self, episode: Episode, index: int, piece: int, low: Real, high: Real, depth: int = 0
    ) -> Real | None:
        """Return where a gap that is positive at `low` first falls through zero before `high`."""
        over = low.union(high)
        middle = over.mid()
        rate = self._falling(episode, index, piece, over)
        if rate is None:
            return None
        if rate < 0:
            at_high = episode.gaps(self.motion.over(high, piece))[index].value
            if at_high > 0:
                return None
            if at_high < 0:
                return self._root(episode, index, piece, low.mid(), high.mid())
        if depth == MOST_HALVINGS:
            raise UndecidedError("a gap that is zero at its minimum or at the end")
        first = self._first(episode, index, piece, low, middle, depth + 1)
        if first is None:
            return self._first(episode, index, piece, middle, high, depth + 1)
        return first

    def _falling(self, episode: Episode, index: int, piece: int, over: Real) -> Real | None:
        """Return the rate of a gap over a ball; None if in all of it it is positive or rises."""
        middle = over.mid()
        away = over - middle
        wide = episode.gaps(self.motion.over(over, piece))[index]
        here = episode.gaps(self.motion.over(middle, piece))[index]
        rate, least = wide.rate, here.value + wide.rate * away
        if isinstance(episode, Sticking):
            # a spring that has just left the cap is near it for long: second order
            rate = here.rate + wide.bend * away
            least = here.value + away * (here.rate + wide.bend * away / 2)
        return None if wide.value > 0 or least > 0 or rate > 0 else rate

    def _root(self, episode: Episode, index: int, piece: int, low: Real, high: Real) -> Real:
        """Return the ball of the zero of a gap that falls from `low` to `high`."""
        x = ((low + high) / 2).mid()
        for n in range(ctx.prec):
            gap = episode.gaps(self.motion.over(x, piece))[index]
            if gap.value > 0:
                low = x
            elif gap.value < 0:
                high = x
            else:
                break
            following = (x - gap.value / gap.rate).mid()
            if n > 60 or not low < following < high:
                following = ((low + high) / 2).mid()
            near = abs(following - x) < abs(x) * arb(2) ** (30 - ctx.prec)
            x = following
            if near:
                break
        # the mean value theorem bounds the distance of the root
        around = arb(x, abs(x) * arb(2) ** (50 - ctx.prec))
        rate = episode.gaps(self.motion.over(around, piece))[index].rate
        return x - episode.gaps(self.motion.over(x, piece))[index].value / rate


@lru_cache(maxsize=64)
def _normal_motion(damping: float, _precision: int) -> NormalMotion:
    return NormalMotion(damping)


def count(kappa: float, psi: float, damping: float = 0.0) -> tuple[int, Real]:
    """Return the number of switches and ε_t of the collision of three doubles.

    Parameters
    ----------
    kappa, psi, damping
        κ of Eq. 24 and ψ = (α/μ)(g_t/g_n), both > 0; η of Eq. 1.

    Raises
    ------
    UndecidedError
        If 231 digits cannot tell, as on a border.
    """
    parameters = float(kappa), float(psi), float(damping)
    try:
        with ctx.workprec(BITS):
            return _Walk(*parameters).run()
    except UndecidedError:
        with ctx.workprec(MORE_BITS):
            return _Walk(*parameters).run()
