"""Entry points of the WebAssembly module: the kernels of `mechanics` over addresses in its memory.

What is computed is computed there; here numbers are read from addresses and written to them. Each
entry is made twice, for the contact without damping and as `damped_…` for one that
`prepare_contact` has left in memory; for the former no address is looked at. What raises in Python
ends an entry with another status than 0. Nothing is assigned to slices or reshaped, for numba words
the errors of that with Python's strings.
"""

import math
from collections.abc import Callable
from typing import Any

import numba
import numpy as np
from numba import carray, types  # type: ignore[attr-defined]

from restitution.mechanics import motion
from restitution.mechanics.collision import (
    EPISODE,
    MOST_SWITCHES,
    _collide_in_lanes,
    _collide_one,
    collide_block,
    within_reach,
)
from restitution.mechanics.contact import (
    ELASTIC,
    LEAST_DAMPING,
    LEAST_LOAD,
    MOST_DAMPING,
    expected_switches,
)
from restitution.mechanics.damped.motion import TERMS, Viscoelastic
from restitution.mechanics.damped.preparing import MOST_STEPS, prepare
from restitution.mechanics.lanes.rows import LABELS, ROWS

NUMBER, COUNT = types.float64, types.int32
"""Counts are short enough for JavaScript's own numbers."""
NUMBERS, COUNTS = types.CPointer(NUMBER), types.CPointer(COUNT)
WHOLES = types.CPointer(types.int64)
SIGNS, TRUTHS = types.CPointer(types.int8), types.CPointer(types.boolean)

COLUMNS = 4
"""Of a piece of `Viscoelastic.pieces`."""

MOST_PIECES = 760
"""Of a contact in memory, after a first one that holds the other fields; the longest has 713."""

CURVES = 7
"""Rows of a trace: x, ẋ, P, u/u(0), z/u(0), F and the tangential energy over u(0)²."""

SUMMARY = 8
"""Numbers that `trace` writes beside its curves."""

kernel: Any = numba.njit(error_model="numpy")


@kernel
def elastic_at(_: Any) -> Any:
    """Return the contact without damping, which is nowhere in memory."""
    return ELASTIC


@kernel
def viscoelastic_at(address: Any) -> Any:
    """Return the contact that `prepare_contact` has written to an address."""
    whole = carray(address, (1 + MOST_PIECES, TERMS, COLUMNS))
    n = carray(address, (TERMS * COLUMNS,))
    return Viscoelastic(
        whole[1 : 1 + int(n[0])], int(n[1]), n[2], n[3], n[4], n[5], n[6], n[7], (n[8], n[9]),
        (n[10], n[11]), n[12], n[13], n[14], n[15], n[16], n[17], n[18], n[19], n[20], n[21],
        n[22] != 0.0, n[23], n[24],
    )  # fmt: skip


def prepare_contact(damping: float, address: Any) -> None:
    """Write the contact of an η > 0 to an address, as `contact.contact_of` keeps it."""
    if not 0.0 < damping <= MOST_DAMPING:
        raise ValueError("no such damping")
    c = prepare(max(damping, LEAST_DAMPING), MOST_STEPS)
    count = c.pieces.shape[0]
    if c.rising == 0 or count > MOST_PIECES:
        raise ValueError("the end of the contact was not found")
    least_load = c.least_load if damping >= LEAST_DAMPING else LEAST_LOAD
    begins_sliding = 1.0 if c.begins_sliding else 0.0
    # as `viscoelastic_at` reads them
    fields = (
        float(count), float(c.rising), c.a, c.b, c.unit, c.rising_end, c.falling_end, c.end_root,
        c.rising_inverse[0], c.rising_inverse[1], c.falling_inverse[0], c.falling_inverse[1],
        c.duration, c.impulse, c.last_rate, c.peak_time, c.peak, c.last_slope, c.valley,
        c.valley_value, c.ridge, c.ridge_value, begins_sliding, c.strongest, least_load,
    )  # fmt: skip
    head = carray(address, (TERMS * COLUMNS,))
    for i in range(len(fields)):
        head[i] = fields[i]
    whole = carray(address, (1 + MOST_PIECES, TERMS, COLUMNS))
    for i in range(count):
        for k in range(TERMS):
            for j in range(COLUMNS):
                whole[1 + i, k, j] = c.pieces[i, k, j]


@kernel
def require_parameters(kappa: float, psi: float) -> None:
    """Raise unless `collision.collide` takes them."""
    if not 0.0 < kappa < math.inf or not psi >= 0.0:
        raise ValueError("kappa must be positive and finite, psi 0 or more")


@kernel
def describe(contact: Any, properties: Any) -> None:
    """Write t_c, ε_n and the largest normal force."""
    out = carray(properties, (3,))
    out[0], out[1] = contact.duration / contact.unit, -contact.last_rate
    out[2] = contact.peak * contact.unit


@kernel
def collide(contact: Any, most_switches: float, kappa: float, psi: float, outcome: Any) -> None:
    """Follow one collision: write ε_t, switches, certainty, bound and expected switches."""
    require_parameters(kappa, psi)
    out = carray(outcome, (5,))
    nothing = np.empty(0, EPISODE)
    out[0], out[1], certain, out[3] = _collide_one(contact, most_switches, kappa, psi, nothing)
    out[2] = 1.0 if certain else 0.0
    out[4] = expected_switches(contact, kappa, psi)


@kernel
def collide_in_lanes(
    contact: Any,
    most_switches: float,
    count: int,
    kappa: Any,
    psi: Any,
    epsilon_t: Any,
    switches: Any,
    certain: Any,
    bound: Any,
    lanes: Any,
    labels: Any,
) -> None:
    """Fill the four arrays (count,) after κ and ψ, as `collision.collide` does."""
    kappas, psis = carray(kappa, (count,)), carray(psi, (count,))
    for i in range(count):
        require_parameters(kappas[i], psis[i])
    _collide_in_lanes(
        contact,
        most_switches,
        kappas,
        psis,
        carray(epsilon_t, (count,)),
        carray(switches, (count,)),
        carray(certain, (count,)),
        carray(bound, (count,)),
        carray(lanes, (ROWS,)),
        carray(labels, (LABELS,)),
    )


@kernel
def epsilon_in_lanes(
    contact: Any, kappa: float, psi: float, bound: float, followed: float, lanes: Any, labels: Any
) -> float:
    """Return ε_t as a list has it, to the last digit; `followed` where that is followed, too."""
    given = np.empty(3)
    given[0], given[1], given[2] = kappa, psi, bound
    epsilon_t, switches = np.empty(1), np.empty(1, np.int32)
    left = collide_block(
        contact, math.inf, 0, 1, given[:1], given[1:2], given[2:], carray(lanes, (ROWS,)),
        carray(labels, (LABELS,)), epsilon_t, switches,
    )  # fmt: skip
    found: float = followed if left else epsilon_t[0]
    return found


@kernel
def fill_without_spring(kappa: float, psi: float, duration: float, rows: Any, regime: Any) -> float:
    """Fill u/u(0), z/u(0), F and the regime for ψ = 0 or ∞; return the sensitivity to κ."""
    slides = psi > 0.0
    for i in range(regime.size):
        rows[3, i], rows[4, i] = 1.0 if slides else 0.0, 0.0
        rows[5, i] = rows[2, i] if slides else 0.0
        regime[i] = 1 if slides else 0
    phase = 0.0 if slides else math.sqrt(kappa) * duration
    return -0.5 * phase * math.sin(phase)


@kernel
def trace(
    contact: Any,
    most_switches: float,
    kappa: float,
    psi: float,
    samples: int,
    room: int,
    start: Any,
    direction: Any,
    time: Any,
    curves: Any,
    regime: Any,
    lanes: Any,
    labels: Any,
    summary: Any,
) -> None:
    """Write a collision over time, as `studies.collision.trace` has it.

    `start` and `direction` (room,) get the episodes, the arrays after them samples + switches
    columns, `summary` ε_t, switches, certainty, bound, reversals, both sensitivities and t_c.
    """
    require_parameters(kappa, psi)
    reached = within_reach(contact, psi)
    expected, bound = motion._foresee(contact, kappa, reached)
    if expected > most_switches or (bound >= 1.0 and reached < contact.impulse):
        raise ValueError("too stiff to be followed")
    duration = contact.duration / contact.unit
    episodes, passed, force = np.empty(room, EPISODE), np.empty(room), np.empty(room)
    epsilon, switches, certain = motion._follow(contact, kappa, psi, episodes, passed, force)
    if switches >= room:
        raise ValueError("more switches than there is room for")
    has_spring = 0.0 < psi < math.inf
    if not has_spring:
        switches, certain = 0, True
    episodes, force = episodes[: switches + 1], force[: switches + 1]
    starts, directions = carray(start, (switches + 1,)), carray(direction, (switches + 1,))
    for j in range(switches + 1):
        left = contact.duration - passed[j] if episodes[j]["falling"] else passed[j]
        starts[j] = left / contact.unit
        directions[j] = episodes[j]["side"] if episodes[j]["sliding"] else 0
    size = samples + switches
    instants = motion.instants(duration, samples, starts[1:])
    times = carray(time, (size,))
    for i in range(size):
        times[i] = instants[i]
    rows, regimes = carray(curves, (CURVES, size)), carray(regime, (size,))
    motion._normal_curves(contact, times, rows[:3])
    turns, by_psi, weaker = 0, 0.0, 1.0
    if has_spring:
        motion._tangential_curves(
            contact, kappa, reached, episodes, starts, times, rows[3:6], regimes
        )
        epsilon = epsilon_in_lanes(contact, kappa, psi, bound, epsilon, lanes, labels)
        turns = motion._reversals(kappa, episodes, starts, force, duration, epsilon * reached)
        by_kappa, by_psi = motion._sensitivity(kappa, reached, episodes, starts, force)
        by_psi -= epsilon
        # a collision weaker than the one that was followed has proportionally weaker forces
        weaker = min(1.0, psi / reached)
    else:
        by_kappa = fill_without_spring(kappa, psi, duration, rows, regimes)
        directions[0] = regimes[0]
    omega = math.sqrt(kappa)
    for i in range(size):
        rows[5, i] *= weaker
        stretch = omega * rows[4, i]
        rows[6, i] = 0.5 * (rows[3, i] * rows[3, i] + stretch * stretch)
    out = carray(summary, (SUMMARY,))
    out[0], out[1], out[2], out[3] = epsilon, switches, 1.0 if certain else 0.0, bound
    out[4], out[5], out[6], out[7] = turns, by_kappa, by_psi, duration


def over(contact_at: Any, function: Any) -> Callable[..., None]:
    """Return the entry that lets `function` have the contact at an address."""

    def entry(address: Any, *rest: Any) -> None:
        function(contact_at(address), *rest)

    return entry


SIGNATURES = {
    describe: (NUMBERS, NUMBERS),
    collide: (NUMBERS, *(NUMBER,) * 3, NUMBERS),
    collide_in_lanes: (
        *(NUMBERS, NUMBER, COUNT, NUMBERS, NUMBERS),
        *(NUMBERS, COUNTS, TRUTHS, NUMBERS, NUMBERS, WHOLES),
    ),
    trace: (
        *(NUMBERS, *(NUMBER,) * 3, COUNT, COUNT, NUMBERS, SIGNS),
        *(NUMBERS, NUMBERS, SIGNS, NUMBERS, WHOLES, NUMBERS),
    ),
}

ENTRIES: dict[str, tuple[Callable[..., None], tuple[Any, ...]]] = {
    "prepare_contact": (prepare_contact, (NUMBER, NUMBERS)),
    **{
        f"{prefix}{function.__name__}": (over(contact_at, function), signature)
        for prefix, contact_at in (("", elastic_at), ("damped_", viscoelastic_at))
        for function, signature in SIGNATURES.items()
    },
}
"""By the name that the module exports: the function and the types of its arguments."""

SIZES = {
    "contact": 8 * (1 + MOST_PIECES) * TERMS * COLUMNS,
    "labels": 8 * LABELS,
    "lanes": 8 * ROWS,
    "most_switches": MOST_SWITCHES,
    "pages": 40,
}
"""Of what the page gives the entries, in bytes; of its memory, in pages; most that is followed."""
