"""Files that are derived and kept between runs: checked when read, made anew, or done without.

Some hold machine code that is run. So nobody but this user and root may write them, and what was
not written whole is not read.
"""

import contextlib
import hashlib
import logging
import os
import stat
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

LOGGER = logging.getLogger(__name__)

DIGEST_BYTES = hashlib.sha256().digest_size

LONGEST_WRITING = 3600
"""Seconds after which a partial file was left by a writer that was killed."""

_told: set[str] = set()


def tell_once(subject: str, event: str) -> None:
    """Log an event, the first time that it is about this subject: one kernel speaks for sixty."""
    if subject not in _told:
        _told.add(subject)
        LOGGER.warning(event)


def was_told(subject: str) -> bool:
    """Return whether `tell_once` was asked to log an event about this subject."""
    return subject in _told


def _who_else_may_write(found: os.stat_result) -> str:
    """Return in words who may write a file or folder beside this user and root, "" if nobody."""
    if stat.S_ISLNK(found.st_mode):
        return "it is a link"
    if found.st_uid not in (0, os.geteuid()):
        return f"it belongs to user {found.st_uid}"
    if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        return f"others may write to it (mode {stat.S_IMODE(found.st_mode):04o})"
    return ""


def read(file: Path) -> bytes | None:
    """Return what `write` wrote to `file`, None if that is not there as it was written."""
    try:
        with file.open("rb") as stream:
            found = os.fstat(stream.fileno())
            content = stream.read(max(0, found.st_size - DIGEST_BYTES))
            digest = stream.read()
    except FileNotFoundError:
        return None
    except OSError as error:
        wrong = f"cannot be read ({error.strerror})"
    else:
        if others := _who_else_may_write(found):
            wrong = f"is not trusted, {others}"
        elif hashlib.sha256(content).digest() == digest:
            return content
        else:
            wrong = "is damaged"
    event = f"{file} {wrong}: made anew, and others beside it without a further word"
    tell_once(f"read {file.parent}", event)
    return None


def write(file: Path, content: bytes) -> None:
    """Keep `content` in `file` if that is possible; whole or not at all, for others may look."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        _remove_partial(file)
        handle, partial = tempfile.mkstemp(dir=file.parent, prefix=f"{file.name}.")
        try:
            with os.fdopen(handle, "wb") as stream:
                stream.writelines((content, hashlib.sha256(content).digest()))
            Path(partial).replace(file)
        finally:
            Path(partial).unlink(missing_ok=True)
    except OSError as error:
        tell_once(
            f"write {file.parent}",
            f"nothing can be kept in {file.parent} ({error.strerror}): made anew at each start",
        )


def _remove_partial(file: Path) -> None:
    """Remove what writers of `file` left that were killed."""
    for partial in file.parent.glob(f"{file.name}.*"):
        # another process may do the same
        with contextlib.suppress(FileNotFoundError):
            if time.time() - partial.stat().st_mtime > LONGEST_WRITING:
                partial.unlink()


def _places() -> Iterator[Path]:
    """Yield where a cache may be, the best first."""
    for name in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME"):
        if place := os.environ.get(name):
            yield Path(place, "restitution")
    # either may be nowhere
    with contextlib.suppress(RuntimeError):
        yield Path.home() / ".cache" / "restitution"
    with contextlib.suppress(OSError):
        yield Path(tempfile.gettempdir(), f"restitution-{os.geteuid()}")


def find_folder(name: str) -> tuple[str, str]:
    """Return a folder `name` in which this user alone makes files, and what is to be told of it.

    The first of a short list in which files can be made, "" if there is none. A folder before it
    that can only be read, as in an image, lends what it has: the one returned is given links.
    """
    lent: list[Path] = []
    distrusted: list[str] = []
    unfit: list[str] = []
    for place in _places():
        folder = (place / name).absolute()
        try:
            folder.mkdir(mode=stat.S_IRWXU, parents=True, exist_ok=True)
            if others := _who_else_may_write(folder.lstat()):
                distrusted.append(f"{folder}: {others}")
                continue
            lent.append(folder)
            with tempfile.TemporaryFile(dir=folder):
                pass
        except OSError as error:
            unfit.append(f"{folder}: {error.strerror}")
            continue
        for other in lent[:-1]:
            _link(other, folder)
        event = f"the cache is in {folder}, not in {'; '.join(distrusted)}"
        return str(folder), event if distrusted else ""
    reasons = "; ".join(distrusted + unfit) or "there is neither a home nor a temporary folder"
    return "", f"nothing is kept, each start compiles for a minute: {reasons}"


def _link(lent: Path, folder: Path) -> None:
    """Link to each file below `lent` that `folder` has not, as far as that is possible."""
    for file in lent.rglob("*"):
        link = folder / file.relative_to(lent)
        # another worker may have made it
        with contextlib.suppress(OSError):
            if file.is_file():
                link.parent.mkdir(parents=True, exist_ok=True)
                link.symlink_to(file)
