"""Long work that nobody waits for any more stops: at its next pause, some milliseconds later."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from restitution.errors import RestitutionError

_STOP: ContextVar[threading.Event | None] = ContextVar("stop", default=None)


class InterruptionError(RestitutionError):
    """The work was called off before it was done."""


@contextmanager
def interruptible(stop: threading.Event) -> Iterator[None]:
    """Let the work in this block end with `InterruptionError` once `stop` is set."""
    token = _STOP.set(stop)
    try:
        yield
    finally:
        _STOP.reset(token)


def pause() -> None:
    """Raise `InterruptionError` if the work of this thread was called off."""
    if (stop := _STOP.get()) is not None and stop.is_set():
        raise InterruptionError("called off")
