"""Which cases of a test are for every day, and which are left to `make verify`."""

from collections.abc import Collection, Iterable
from typing import Any

import pytest


def every_day(chosen: Collection[object], of: Iterable[object]) -> list[Any]:
    """Return the cases of a parametrized test: those that are not chosen are verified alone."""
    return [case if case in chosen else left_to_verify(case) for case in of]


def left_to_verify(case: object) -> Any:
    """Return a case for `make verify`; a tuple is one of several arguments."""
    values = case if isinstance(case, tuple) else (case,)
    return pytest.param(*values, marks=pytest.mark.verify)
