"""Compile numerical kernels with numba and keep the machine code between runs."""

import contextlib
import hashlib
import os
import shutil
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


def _cache_folder() -> str:
    """Return the first folder of a short list in which files can be made.

    A folder before it that can only be read, as in an image, lends what it has: numba reads no
    cache that it could not write to, so the folder returned is given links to the files.
    """
    candidates = (
        os.environ.get("NUMBA_CACHE_DIR"),
        os.environ.get("XDG_CACHE_HOME"),
        Path.home() / ".cache",
        tempfile.gettempdir(),
    )
    lent: list[Path] = []
    for candidate in candidates:
        if not candidate:
            continue
        folder = Path(candidate, "restitution", MODEL_VERSION).absolute()
        try:
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                pass
        except OSError:
            if folder.is_dir():
                lent.append(folder)
            continue
        for other in lent:
            # another worker may have linked some of them: the rest are linked all the same
            with contextlib.suppress(shutil.Error):
                shutil.copytree(other, folder, copy_function=os.symlink, dirs_exist_ok=True)
        return str(folder)
    return ""


CACHE_FOLDER = _cache_folder()
if CACHE_FOLDER:
    numba.config.CACHE_DIR = CACHE_FOLDER  # type: ignore[attr-defined] # set up at run time


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
        cache=bool(CACHE_FOLDER),
        nogil=True,
        error_model="numpy",
        fastmath={"contract"},
        forceinline=always_inline,
    )
    result: Function = compiler(function)
    return result
