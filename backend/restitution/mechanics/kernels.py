"""Machine code from numba, kept between runs; imported when the first kernel is called."""

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import CompileResultCacheImpl, FunctionCache, IndexDataCacheFile
from numba.core.compiler_lock import global_compiler_lock
from numba.extending import overload

from restitution.mechanics import cache
from restitution.mechanics.compiled import ABOUT_FOLDER, CACHE_FOLDER, MODEL_VERSION

FIRST_USE = (
    "kernels are compiled for this processor: about 10 s for a first collision, a minute for all, "
    f"once, for they are kept in {CACHE_FOLDER}"
)


class _Place:
    """The folder of the kernels of a source, as numba asks for it; made when the first is kept."""

    def __init__(self, function: Callable[..., Any], source: str) -> None:
        # numba names them in its warnings
        self._py_file = source
        self._lineno = function.__code__.co_firstlineno
        # named after the sources already, wherever they lie
        self._cache_path = str(Path(CACHE_FOLDER, "kernels"))

    @classmethod
    def from_function(cls, function: Callable[..., Any], source: str) -> "_Place":
        return cls(function, source)

    def ensure_cache_path(self) -> None:
        """Do nothing: `cache.write` makes it, if that is possible."""

    def get_cache_path(self) -> str:
        return self._cache_path

    def get_source_stamp(self) -> str:
        return MODEL_VERSION

    def get_disambiguator(self) -> str:
        return str(self._lineno)


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
        if ABOUT_FOLDER:
            cache.tell_once("folder", ABOUT_FOLDER)
        found = super().load_overload(signature, context)
        # of damaged ones it is told already that they are made anew
        if found is None and CACHE_FOLDER and not cache.was_told(f"read {self._cache_path}"):
            cache.tell_once("first use", FIRST_USE)
        return found


def _compile_in_columns(kernel: Any) -> None:
    """Let LLVM look for operations side by side when it compiles `kernel`."""
    compile_alone = kernel._compiler.compile  # noqa: SLF001

    config: Any = numba.config

    def compile_in_columns(*given: Any) -> Any:
        # numba knows it as a choice for all kernels alone
        with global_compiler_lock:
            before, config.SLP_VECTORIZE = config.SLP_VECTORIZE, 1
            try:
                return compile_alone(*given)
            finally:
                config.SLP_VECTORIZE = before

    kernel._compiler.compile = compile_in_columns  # noqa: SLF001


def compile_lazily(function: Callable[..., Any], is_in_columns: bool) -> Any:
    """Return what compiles `function` for each kind of arguments, or loads what was compiled.

    `is_in_columns` as in `compiled.compiled_in_columns`.
    """
    compiler: Any = numba.njit(nogil=True, error_model="numpy")
    kernel: Any = compiler(function)
    # where `enable_caching` puts numba's own
    kernel._cache = _KernelCache(function)  # noqa: SLF001
    # without a compiler, where NUMBA_DISABLE_JIT leaves Python alone
    if is_in_columns and hasattr(kernel, "_compiler"):
        _compile_in_columns(kernel)
    return kernel


def choose_by_type(name: Callable[..., Any], first: type, kernel: Any, other: Any) -> None:
    """Let `name` in a kernel be `kernel` where its first argument is a `first`, else `other`."""

    @overload(name, strict=False, inline="always")
    def choose(argument: Any, *_: Any) -> Any:
        function: Any = kernel if argument.instance_class is first else other
        return function.py_func
