"""The one place where a test waits: a limit of minutes, and no verdict on time."""

import time
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")

LIMIT_SECONDS = 300
"""Stops what hangs. Nothing that works comes near it, on no machine and beside no other work."""

REST_SECONDS = 0.05


def eventually(check: Callable[[], T], rest: Callable[[float], object] = time.sleep) -> T:
    """Return what `check` returns once it holds: its last failed assertion is the test's."""
    deadline = time.monotonic() + LIMIT_SECONDS
    while True:
        try:
            return check()
        except AssertionError:
            if time.monotonic() > deadline:
                raise
        rest(REST_SECONDS)
