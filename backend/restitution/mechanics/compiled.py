"""Compile numerical kernels with numba and keep the machine code between runs."""

import hashlib
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import numba

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


def _writable_cache_folder() -> str:
    """Return the first folder of a short list in which files can be made."""
    candidates = (
        os.environ.get("NUMBA_CACHE_DIR"),
        os.environ.get("XDG_CACHE_HOME"),
        Path.home() / ".cache",
        tempfile.gettempdir(),
    )
    for candidate in candidates:
        if not candidate:
            continue
        folder = Path(candidate, "restitution", MODEL_VERSION)
        try:
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                return str(folder)
        except OSError:
            continue
    return ""


CACHE_FOLDER = _writable_cache_folder()
if CACHE_FOLDER:
    numba.config.CACHE_DIR = CACHE_FOLDER  # type: ignore[attr-defined] # set up at run time


def compiled(function: Function) -> Function:
    """Compile `function` at its first call, without the interpreter lock.

    Multiplications and additions may be fused: it only removes roundings. Division by zero gives
    an infinity as in numpy, for the extremes of the parameters rely on it.
    """
    compiler: Any = numba.njit(
        cache=bool(CACHE_FOLDER), nogil=True, error_model="numpy", fastmath={"contract"}
    )
    result: Function = compiler(function)
    return result
