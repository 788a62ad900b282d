"""Numerical kernels: compiled by numba when they are first called, which loads numba as well."""

import functools
import hashlib
import threading
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any, TypeVar

from restitution.mechanics import cache

Function = TypeVar("Function", bound=Callable[..., Any])


def fingerprint(folder: Path) -> str:
    """Return a short hash of the Python sources below `folder`."""
    digest = hashlib.sha256(version("numba").encode())
    for source in sorted(folder.rglob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


MODEL_VERSION = fingerprint(Path(__file__).parent)
"""Changes with any source of the mechanics.

numba renews a cached kernel when its own file changes, not when a function that it calls in
another file does; a cache folder named after all sources cannot go stale.
"""


CACHE_FOLDER, ABOUT_FOLDER = cache.find_folder(MODEL_VERSION)
"""Where what is derived from the sources is kept, "" if nowhere; what is to be told of it."""

_choices: list[Callable[[], None]] = []
"""What is to be done before another kernel is compiled."""

_choosing = threading.Lock()


class _Kernel:
    """A function that numba compiles when Python, or a kernel that is compiled, calls it."""

    _machine: Any = None

    def __init__(self, function: Callable[..., Any], is_in_columns: bool) -> None:
        functools.update_wrapper(self, function)
        self.py_func = function
        self._is_in_columns = is_in_columns

    def _made(self) -> Any:
        # a third of a second that an import need not take
        from restitution.mechanics import kernels  # noqa: PLC0415

        with _choosing:
            while _choices:
                _choices.pop()()
        made = kernels.compile_lazily(self.py_func, self._is_in_columns)
        # of several threads the first: it compiles for all
        return vars(self).setdefault("_machine", made)

    def __call__(self, *given: Any) -> Any:
        return (self._machine or self._made())(*given)

    @property
    def _numba_type_(self) -> Any:
        """What numba takes it for where another kernel calls it."""
        return (self._machine or self._made())._numba_type_


def compiled(function: Function) -> Function:
    """Compile `function` at its first call, without the interpreter lock.

    Nothing of fastmath, so that each operation is rounded as it is written. Were multiplications
    and additions fused, a function compiled into its caller could be fused in another way than by
    itself, and a process that compiles would answer with other last bits than one that loads.
    Division by zero gives an infinity as in numpy, for the extremes of the parameters rely on it.
    """
    kernel: Any = _Kernel(function, False)
    result: Function = kernel
    return result


def compiled_in_columns(function: Function) -> Function:
    """Compile as `compiled` does, for a processor to do at once what is written side by side.

    For functions that do the same with several columns. Elsewhere it pairs what belongs to
    different steps, and loops over lanes become three times slower.
    """
    kernel: Any = _Kernel(function, True)
    result: Function = kernel
    return result


def chosen_by_type(
    name: Callable[..., Any], first: type, kernel: Callable[..., Any], other: Callable[..., Any]
) -> None:
    """Let `name` in a kernel be `kernel` where its first argument is a `first`, else `other`."""

    def choose() -> None:
        from restitution.mechanics import kernels  # noqa: PLC0415 - as above

        kernels.choose_by_type(name, first, kernel, other)

    _choices.append(choose)
