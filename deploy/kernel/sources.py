"""What the kernel in the page is made of, as a fingerprint that the kernel carries."""

import hashlib
import re
from pathlib import Path

from kernel.module import about

ROOT = Path(__file__).parents[2]

MECHANICS = ROOT / "backend" / "restitution" / "mechanics"

LOCK = ROOT / "requirements.lock"

TOOLS = ("llvmlite", "numba")


def fingerprint(mechanics: Path = MECHANICS) -> str:
    """Return a short hash of the sources of mechanics, of this folder and of the locked tools."""
    digest = hashlib.sha256()
    for folder in (mechanics, Path(__file__).parent):
        for source in sorted([*folder.rglob("*.py"), *folder.rglob("*.ll")]):
            digest.update(source.relative_to(folder).as_posix().encode() + b"\0")
            digest.update(source.read_bytes())
    for tool in TOOLS:
        (locked,) = re.findall(rf"(?m)^{tool}==\S+", LOCK.read_text(encoding="utf-8"))
        digest.update(locked.encode())
    return digest.hexdigest()[:16]


def reason_to_refuse(kernel: Path, mechanics: Path = MECHANICS) -> str | None:
    """Return what is wrong with a kernel if it was made of other sources than there are."""
    if about(kernel.read_bytes()).get("made_of") == fingerprint(mechanics):
        return None
    return (
        f"{kernel.name} was made of other sources of mechanics or with other tools than there are "
        "now: run make kernel"
    )
