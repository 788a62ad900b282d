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

from restitution.mechanics import curves, motion
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
    _normal_curves,
)
from restitution.mechanics.damped.motion import TERMS, Viscoelastic
from restitution.mechanics.damped.preparing import MOST_STEPS, prepare
from restitution.mechanics.lanes.rows import LABELS, ROWS
from restitution.mechanics.limits import simple_laws
from restitution.mechanics.scaled_velocity import after_flight, psi_of

NUMBER, COUNT = types.float64, types.int32
"""Counts are short enough for JavaScript's own numbers."""
NUMBERS, COUNTS = types.CPointer(NUMBER), types.CPointer(COUNT)
WHOLES = types.CPointer(types.int64)
SIGNS, TRUTHS = types.CPointer(types.int8), types.CPointer(types.boolean)

POWERS = 4
"""Of a piece of `Viscoelastic.pieces`."""

MOST_PIECES = 760
"""Of a contact in memory, after a first one that holds the other fields; the longest has 713."""

COLUMNS = 7
"""Rows of a trace: those of `contact.normal_curves`, then those of `curves.tangential_columns`."""

OUTCOME = 9
"""Numbers that `write_outcome` writes."""

kernel: Any = numba.njit(error_model="numpy")


@kernel
def elastic_at(_: Any) -> Any:
    """Return the contact without damping, which is nowhere in memory."""
    return ELASTIC


@kernel
def viscoelastic_at(address: Any) -> Any:
    """Return the contact that `prepare_contact` has written to an address."""
    whole = carray(address, (1 + MOST_PIECES, TERMS, POWERS))
    n = carray(address, (TERMS * POWERS,))
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
    head = carray(address, (TERMS * POWERS,))
    for i in range(len(fields)):
        head[i] = fields[i]
    whole = carray(address, (1 + MOST_PIECES, TERMS, POWERS))
    for i in range(count):
        for k in range(TERMS):
            for j in range(POWERS):
                whole[1 + i, k, j] = c.pieces[i, k, j]


@kernel
def psi_within(kappa: float, mu_over_alpha: float, gt_over_gn: float) -> float:
    """Return ψ of parameters that the service takes, too; raise where it does not."""
    if not (0.0 < kappa < math.inf and 0.0 <= mu_over_alpha < math.inf):
        raise ValueError("kappa must be positive and finite, mu_over_alpha finite and 0 or more")
    if not 0.0 <= gt_over_gn < math.inf:
        raise ValueError("gt_over_gn must be finite and 0 or more")
    psi: float = psi_of(mu_over_alpha, gt_over_gn)
    return psi


@kernel
def write_outcome(
    contact: Any, kappa: float, psi: float, found: tuple[float, int, bool, float], out: Any
) -> None:
    """Write ε_t, switches, certainty, bound, ψ, t_c, ε_n, share of energy lost, Coulomb's ε_t."""
    out[0], out[1], certain, out[3] = found
    out[2] = 1.0 if certain else 0.0
    out[4], out[5], out[6] = psi, contact.duration / contact.unit, -contact.last_rate
    out[7] = motion.dissipated_share(out[0])
    out[8], _, _ = simple_laws(kappa, psi, -contact.last_rate, True)


@kernel
def collide(
    contact: Any,
    most_switches: float,
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    outcome: Any,
) -> None:
    """Follow one collision and write its outcome, as `write_outcome` does."""
    psi = psi_within(kappa, mu_over_alpha, gt_over_gn)
    nothing = np.empty(0, EPISODE)
    found = _collide_one(contact, most_switches, kappa, psi, nothing)
    write_outcome(contact, kappa, psi, found, carray(outcome, (OUTCOME,)))


@kernel
def collide_in_lanes(
    contact: Any,
    most_switches: float,
    count: int,
    kappa: Any,
    mu_over_alpha: float,
    gt_over_gn: Any,
    epsilon_t: Any,
    switches: Any,
    certain: Any,
    bound: Any,
    lanes: Any,
    labels: Any,
) -> None:
    """Fill the four arrays (count,) after g_t/g_n, as `collision.collide` does."""
    kappas, tangentials = carray(kappa, (count,)), carray(gt_over_gn, (count,))
    psis = np.empty(count)
    for i in range(count):
        psis[i] = psi_within(kappas[i], mu_over_alpha, tangentials[i])
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


def find_simple_laws(
    epsilon_n: float,
    damped: int,
    count: int,
    kappa: Any,
    mu_over_alpha: float,
    gt_over_gn: Any,
    coulomb: Any,
    stiff_bound: Any,
    stiff_asymptote: Any,
) -> None:
    """Fill the last three arrays (count,), as `limits.simple_laws` has them."""
    kappas, tangentials = carray(kappa, (count,)), carray(gt_over_gn, (count,))
    first, second = carray(coulomb, (count,)), carray(stiff_bound, (count,))
    third = carray(stiff_asymptote, (count,))
    for i in range(count):
        psi = psi_within(kappas[i], mu_over_alpha, tangentials[i])
        first[i], second[i], third[i] = simple_laws(kappas[i], psi, epsilon_n, damped != 0)


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
def trace(
    contact: Any,
    most_switches: float,
    kappa: float,
    mu_over_alpha: float,
    gt_over_gn: float,
    samples: int,
    room: int,
    start: Any,
    direction: Any,
    time: Any,
    columns: Any,
    regime: Any,
    lanes: Any,
    labels: Any,
    summary: Any,
) -> None:
    """Write a collision over time, as `studies.collision.trace` has it.

    `start` and `direction` (room,) get the episodes, the arrays after them samples + switches
    columns, `summary` what `collide` writes, reversals and the share of the contact until the first
    switch.
    """
    psi = psi_within(kappa, mu_over_alpha, gt_over_gn)
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
    instants = curves.instants(duration, samples, starts[1:])
    times = carray(time, (size,))
    for i in range(size):
        times[i] = instants[i]
    rows, regimes = carray(columns, (COLUMNS, size)), carray(regime, (size,))
    _normal_curves(contact, times, rows[:3])
    curves._tangential_columns(
        contact, kappa, mu_over_alpha, gt_over_gn, episodes, starts, times, rows[2], rows[3:],
        regimes,
    )  # fmt: skip
    turns = 0
    if has_spring:
        epsilon = epsilon_in_lanes(contact, kappa, psi, bound, epsilon, lanes, labels)
        turns = motion._reversals(kappa, episodes, starts, force, duration, epsilon * reached)
    else:
        directions[0] = regimes[0]
    out = carray(summary, (OUTCOME + 2,))
    write_outcome(contact, kappa, psi, (epsilon, switches, certain, bound), out)
    out[OUTCOME] = turns
    out[OUTCOME + 1] = starts[1] / duration if switches else 1.0


def bounce(
    alpha: float,
    mass_share: float,
    kappa: float,
    gt_over_gn: float,
    damping: float,
    epsilon_n: float,
    epsilon_t: float,
    found: Any,
) -> None:
    """Write a ball's impulse shares, and κ, g_t/g_n and η of its next collision."""
    out = carray(found, (5,))
    out[0], out[1] = motion.impulse_shares(alpha, mass_share)
    out[2], out[3], out[4] = after_flight(kappa, gt_over_gn, damping, epsilon_n, epsilon_t)


def over(contact_at: Any, function: Any) -> Callable[..., None]:
    """Return the entry that lets `function` have the contact at an address."""

    def entry(address: Any, *rest: Any) -> None:
        function(contact_at(address), *rest)

    return entry


SIGNATURES = {
    collide: (NUMBERS, *(NUMBER,) * 4, NUMBERS),
    collide_in_lanes: (
        *(NUMBERS, NUMBER, COUNT, NUMBERS, NUMBER, NUMBERS),
        *(NUMBERS, COUNTS, TRUTHS, NUMBERS, NUMBERS, WHOLES),
    ),
    trace: (
        *(NUMBERS, *(NUMBER,) * 4, COUNT, COUNT, NUMBERS, SIGNS),
        *(NUMBERS, NUMBERS, SIGNS, NUMBERS, WHOLES, NUMBERS),
    ),
}

ENTRIES: dict[str, tuple[Callable[..., None], tuple[Any, ...]]] = {
    "prepare_contact": (prepare_contact, (NUMBER, NUMBERS)),
    "bounce": (bounce, (*(NUMBER,) * 7, NUMBERS)),
    "find_simple_laws": (
        find_simple_laws,
        (NUMBER, COUNT, COUNT, NUMBERS, NUMBER, NUMBERS, NUMBERS, NUMBERS, NUMBERS),
    ),
    **{
        f"{prefix}{function.__name__}": (over(contact_at, function), signature)
        for prefix, contact_at in (("", elastic_at), ("damped_", viscoelastic_at))
        for function, signature in SIGNATURES.items()
    },
}
"""By the name that the module exports: the function and the types of its arguments."""

TOLD: dict[str, Any] = {
    "contact": 8 * (1 + MOST_PIECES) * TERMS * POWERS,
    "labels": 8 * LABELS,
    "lanes": 8 * ROWS,
    "mass_shares": motion.MASS_SHARES,
    "most_switches": MOST_SWITCHES,
    "pages": 120,
}
"""What the module says of itself: what the page gives the entries, in bytes; its memory, in pages;
what it takes."""
