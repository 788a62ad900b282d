"""What a disk, a killed program or somebody's mistake makes of a file."""

import random
from pathlib import Path


def change_a_bit(content: bytes, place: int) -> bytes:
    return content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :]


DAMAGES = {
    "truncated": lambda content: content[: len(content) // 2],
    "emptied": lambda _: b"",
    "random": lambda content: random.Random(2008).randbytes(len(content)),
    "one bit": lambda content: change_a_bit(content, len(content) // 2),
    "longer": lambda content: content + b"\0",
}


def damage(file: Path, how: str) -> None:
    file.write_bytes(DAMAGES[how](file.read_bytes()))


def files(folder: Path, suffix: str = "") -> list[Path]:
    return sorted(file for file in folder.rglob(f"*{suffix}") if file.is_file())
