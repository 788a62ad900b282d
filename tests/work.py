"""The work that a call does, counted: other work on the machine does not change it."""

import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest

from restitution.api.admission import Admission
from restitution.api.routes.table import MOST_SECONDS
from restitution.mechanics import (
    collision,
    contact,
    curves,
    limits,
    motion,
    stepping,
)
from restitution.methods import exact, ode, planner, table, timestep
from restitution.studies.tables import entries

MOST_EVALUATIONS = ode.STEPS_TO_EVALUATIONS * ode.MOST_STEPS


class Work(Counter[str]):
    """How often each kind of work was done.

    ``switches``: followed, those with damping as many as they cost. ``steps``: time steps of
    collisions. ``evaluations``: of the general solver's equations. ``reads``: of the table.
    ``points``: of closed forms and curves. ``dampings``: normal motions that were prepared.
    ``tables``: nanoseconds for the collisions of tables, which have a limit of seconds.
    ``quick``, ``long``: requests in either line.
    """

    @property
    def of_numbers(self) -> int:
        """All of it, without the requests: 0 where a refusal came before any work."""
        return self.total() - self["quick"] - self["long"]

    @property
    def seconds(self) -> float:
        """What the cost model has for following switches and for steps of one collision alone."""
        steps = planner.SECONDS_FOR_A_STEP * self["steps"]
        return exact.SECONDS_FOR_A_SWITCH * self["switches"] + steps

    def assert_affordable(self) -> None:
        """Hold it to the budget of the line in which the request waited."""
        if self["quick"]:
            assert not self["long"]
            # with its episodes a collision is followed by `motion`, and once more by a method
            assert self.seconds <= 2 * planner.QUICK_SECONDS, self
            assert not self["evaluations"], self
            assert not self["reads"], self
        if self["tables"]:
            assert 1e-9 * self["tables"] <= MOST_SECONDS, self
        else:
            assert self["switches"] <= exact.MOST_SWITCHES_PER_REQUEST, self
        assert self["steps"] <= timestep.MOST_STEPS, self
        assert self["evaluations"] <= MOST_EVALUATIONS, self


def _switches(of: contact.Contact, counts: Any) -> int:
    """Return those of collisions, of which each is looked at."""
    dearer = 1 if of is contact.ELASTIC else int(exact.DEARER_BY_DAMPING)
    return dearer * (int(np.maximum(counts, 0).sum()) + np.size(counts))


def _nanoseconds(given: Any, found: collision.Collision) -> int:
    return round(1e9 * entries.seconds_for_collisions(*given, found.switches).sum())


KERNELS: list[tuple[Any, str, str, Callable[[tuple[Any, ...], Any], int]]] = [
    (collision, "_collide_in_lanes", "switches", lambda given, _: _switches(given[0], given[5])),
    (motion, "_follow", "switches", lambda given, found: _switches(given[0], found[1])),
    (curves, "_tangential_columns", "points", lambda given, _: given[6].size),
    (stepping, "_step_each", "steps", lambda given, _: given[0].size * given[4]),
    (stepping, "_record", "steps", lambda _, found: found),
    (table, "look_up", "reads", lambda given, _: given[0].size),
    (limits, "_broadcast", "points", lambda _, found: found.size),
    (contact, "prepare", "dampings", lambda *_: 1),
    (entries, "collide", "tables", _nanoseconds),
]
"""Module, name by which Python calls what does the work there, its kind, how much of it."""


def _counted(
    kernel: Callable[..., Any], note: Callable[[int], None], much: Callable[..., int]
) -> Callable[..., Any]:
    def call(*given: Any) -> Any:
        found = kernel(*given)
        note(much(given, found))
        return found

    return call


@contextmanager
def counted() -> Iterator[Work]:
    """Count the work that is done in the block, in whatever thread."""
    notes: list[tuple[str, int]] = []
    work = Work()

    class Contact(ode._Contact):
        def __init__(self, *given: Any) -> None:
            super().__init__(*given)
            contacts.append(self)

    contacts: list[Contact] = []

    def through(line: str, original: Callable[..., Any]) -> Callable[..., Any]:
        def admit(*given: Any) -> Any:
            notes.append((line, 1))
            return original(*given)

        return admit

    with pytest.MonkeyPatch.context() as patch:
        for module, name, kind, much in KERNELS:
            kernel = getattr(module, name)
            # appending is one step for all threads
            note = lambda n, kind=kind: notes.append((kind, n))  # noqa: E731 - bound to its kind
            patch.setattr(module, name, _counted(kernel, note, much))
        patch.setattr(ode, "_Contact", Contact)
        patch.setattr(Admission, "quickly", through("quick", Admission.quickly))
        patch.setattr(Admission, "in_thread", through("long", Admission.in_thread))
        try:
            yield work
        finally:
            for kind, n in notes:
                work[kind] += n
            for contact in contacts:
                work["evaluations"] += contact.evaluations


def calls_of(run: Callable[[], object]) -> int:
    """Return how many functions `run` calls in this thread, of Python and of its library."""
    count = 0

    def note(_: object, event: str, __: object) -> None:
        nonlocal count
        count += event in {"call", "c_call"}

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        run()
    finally:
        sys.setprofile(before)
    return count
