"""Compile numerical kernels with numba and keep the machine code between runs."""

import hashlib
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numba
from numba.core.caching import (
    CompileResultCacheImpl,
    FunctionCache,
    IndexDataCacheFile,
    UserProvidedCacheLocator,
)

from restitution.mechanics import cache

Function = TypeVar("Function", bound=Callable[..., Any])


def fingerprint(folder: Path) -> str:
    """Return a short hash of the Python sources below `folder`."""
    digest = hashlib.sha256(numba.__version__.encode())
    for source in sorted(folder.rglob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


MODEL_VERSION = fingerprint(Path(__file__).parent)
"""Changes with any source of the mechanics.

numba renews a cached kernel when its own file changes, not when a function that it calls in
another file does; a cache folder named after all sources cannot go stale.
"""


CACHE_FOLDER, _ABOUT_FOLDER = cache.find_folder(MODEL_VERSION)
"""Where what is derived from the sources is kept, "" if nowhere."""


class _Place(UserProvidedCacheLocator):
    """The folder of the kernels of a source; made when the first is kept."""

    def __init__(self, function: Callable[..., Any], source: str) -> None:
        self._py_file = source
        self._lineno = function.__code__.co_firstlineno
        self._cache_path = str(Path(CACHE_FOLDER, self.get_suitable_cache_subpath(source)))

    @classmethod
    def from_function(cls, function: Callable[..., Any], source: str) -> "_Place":
        return cls(function, source)

    def ensure_cache_path(self) -> None:
        """Do nothing: `cache.write` makes it, if that is possible."""

    def get_source_stamp(self) -> str:
        return MODEL_VERSION


class _Implementation(CompileResultCacheImpl):
    _locator_classes = [_Place]  # noqa: RUF012 - as numba has it


class _Files(IndexDataCacheFile):
    """Index and code of a kernel, which numba would unpickle and run whatever they hold."""

    def save(self, key: object, data: object) -> None:
        # with its key, for two processes may give one name to the code of two signatures
        super().save(key, (key, data))

    def load(self, key: object) -> object:
        found = super().load(key)
        if found and found[0] != key:
            event = f"{self._index_path} names the code of another kernel: made anew"
            cache.tell_once(f"read {self._cache_path}", event)
            return None
        return found[1] if found else None

    def _load_index(self) -> dict[object, str]:
        content = cache.read(Path(self._index_path))
        # written by this user or root: read whole, and from a folder of theirs
        return pickle.loads(content) if content else {}  # noqa: S301

    def _save_index(self, overloads: dict[object, str]) -> None:
        cache.write(Path(self._index_path), self._dump(overloads))

    def _load_data(self, name: str) -> object:
        content = cache.read(Path(self._data_path(name)))
        return pickle.loads(content) if content else None  # noqa: S301

    def _save_data(self, name: str, data: object) -> None:
        cache.write(Path(self._data_path(name)), self._dump(data))


class _KernelCache(FunctionCache):
    _impl_class = _Implementation

    def __init__(self, function: Callable[..., Any]) -> None:
        super().__init__(function)
        self._cache_file = _Files(self._cache_path, self._impl.filename_base, MODEL_VERSION)
        if not CACHE_FOLDER:
            self.disable()

    def load_overload(self, signature: object, context: object) -> object:
        # not when it is imported, for there is no log yet
        if _ABOUT_FOLDER:
            cache.tell_once("folder", _ABOUT_FOLDER)
        return super().load_overload(signature, context)


def compiled(function: Function) -> Function:
    """Compile `function` at its first call, without the interpreter lock.

    Multiplications and additions may be fused: it only removes roundings. Division by zero gives
    an infinity as in numpy, for the extremes of the parameters rely on it.
    """
    return _compiled(function, always_inline=False)


def inlined(function: Function) -> Function:
    """Compile `function` into each that calls it.

    What is called keeps a name in the machine code of its caller, and the first of that name in a
    process stands for all: where one was compiled by itself and one along with its caller, sums may
    be fused differently. A process that compiles would then answer with other last bits than one
    that loads what was compiled.
    """
    return _compiled(function, always_inline=True)


def _compiled(function: Function, *, always_inline: bool) -> Function:
    compiler: Any = numba.njit(
        nogil=True,
        error_model="numpy",
        fastmath={"contract"},
        forceinline=always_inline,
    )
    kernel: Any = compiler(function)
    # where `enable_caching` puts numba's own
    kernel._cache = _KernelCache(function)  # noqa: SLF001
    result: Function = kernel
    return result
