"""From LLVM's relocatable object to a module that a browser takes.

The object is one already, but for exports: LLVM has given every function its index and all data
their addresses. Data are zeros, as memory is when it begins, and are left out; so are symbols and
relocations. A custom section says in JSON what the page has to know of the module.
"""

import json
from collections.abc import Iterable, Mapping
from typing import NamedTuple

MAGIC = b"\0asm\1\0\0\0"

CUSTOM, TYPE, IMPORT, FUNCTION, EXPORT, CODE, DATA, DATA_COUNT = 0, 1, 2, 3, 7, 10, 11, 12
"""Kinds of sections; others would be tables, start functions and the like."""

ORDER = (TYPE, IMPORT, FUNCTION, EXPORT, DATA_COUNT, CODE, DATA)

FOR_A_LINKER = {"linking", "reloc.CODE", "target_features"}
"""Custom sections of the object."""

SEGMENTS, SYMBOLS = 5, 8
"""Parts of its section `linking`."""

OF_FUNCTION, OF_DATA, OF_GLOBAL = 0, 1, 2
"""Kinds of symbols."""

ELSEWHERE, NAMED = 0x10, 0x40
"""Flags of a symbol: it is imported; under another name than its own."""

CONSTANT = 0x41
"""Of an address."""

ABOUT = "restitution"
"""Name of the section for the page."""


class UnknownObjectError(Exception):
    """Something in an object that nobody has looked at yet."""


def number(value: int) -> bytes:
    """Return an unsigned number as WebAssembly writes it, seven bits a byte."""
    written = bytearray()
    while True:
        value, low = value >> 7, value & 127
        written.append(low | (128 if value else 0))
        if not value:
            return bytes(written)


def sized(content: bytes) -> bytes:
    """Return bytes with their number before them."""
    return number(len(content)) + content


class Reader:
    """Reads what stands in an object, one after the other."""

    def __init__(self, content: bytes) -> None:
        self.content = content
        self.at = 0

    def __bool__(self) -> bool:
        return self.at < len(self.content)

    def byte(self) -> int:
        """Return the next byte."""
        self.at += 1
        return self.content[self.at - 1]

    def take(self, count: int) -> bytes:
        """Return the next bytes."""
        self.at += count
        return self.content[self.at - count : self.at]

    def number(self) -> int:
        """Return an unsigned number, written seven bits a byte."""
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def part(self) -> bytes:
        """Return bytes whose number stands before them."""
        return self.take(self.number())

    def name(self) -> str:
        """Return a text."""
        return self.part().decode()

    def rest(self) -> bytes:
        """Return what has not been read."""
        return self.content[self.at :]


class Segment(NamedTuple):
    """What memory begins with at an address."""

    address: int
    content: bytes


def sections_of(content: bytes) -> tuple[dict[int, bytes], dict[str, bytes]]:
    """Return the sections of an object by their kind, those with a name by that."""
    reader = Reader(content)
    if reader.take(len(MAGIC)) != MAGIC:
        raise UnknownObjectError("it is not WebAssembly of version 1")
    sections: dict[int, bytes] = {}
    named: dict[str, bytes] = {}
    while reader:
        kind, part = reader.byte(), Reader(reader.part())
        if kind == CUSTOM:
            name = part.name()
            named[name] = part.rest()
        elif kind in ORDER and kind not in sections:
            sections[kind] = part.rest()
        else:
            raise UnknownObjectError(f"section {kind} is not known, or there twice")
    if named.keys() - FOR_A_LINKER:
        raise UnknownObjectError(f"sections {sorted(named)} are not all known")
    return sections, named


def require_imports(section: bytes, allowed: frozenset[str]) -> None:
    """Raise unless nothing is imported but memory, stack pointer and the functions allowed."""
    reader = Reader(section)
    for _ in range(reader.number()):
        module, name, kind = reader.name(), reader.name(), reader.byte()
        is_memory = (kind, name) == (2, "__linear_memory") and reader.byte() == 0
        if is_memory or (kind == 0 and name in allowed):
            # at least so many pages; the function's type
            reader.number()
        elif (kind, name) == (3, "__stack_pointer"):
            reader.take(2)
        else:
            raise UnknownObjectError(f"{module}.{name} would be imported")


def segments_of(section: bytes) -> list[Segment]:
    """Return what memory begins with."""
    reader = Reader(section)
    segments = []
    for _ in range(reader.number()):
        if reader.number() != 0 or reader.byte() != CONSTANT:
            raise UnknownObjectError("a segment is not at a fixed address")
        address = reader.number()
        reader.byte()
        segments.append(Segment(address, reader.part()))
    return segments


class Symbols(NamedTuple):
    """What has a name in an object."""

    functions: dict[str, int]
    """Their indices."""
    data: dict[str, Segment]
    """Their addresses; the contents are zeros."""


def symbols_of(linking: bytes, segments: list[Segment]) -> Symbols:
    """Return what has a name."""
    reader = Reader(linking)
    if reader.number() != 2:
        raise UnknownObjectError("symbols are written in another version")
    found = Symbols({}, {})
    while reader:
        kind, part = reader.byte(), Reader(reader.part())
        if kind not in (SEGMENTS, SYMBOLS):
            raise UnknownObjectError(f"part {kind} of the symbols is not known")
        for _ in range(part.number() if kind == SYMBOLS else 0):
            _read_symbol(part, segments, found)
    return found


def _read_symbol(part: Reader, segments: list[Segment], found: Symbols) -> None:
    what, flags = part.byte(), part.number()
    is_here = not flags & ELSEWHERE
    if what == OF_FUNCTION:
        index = part.number()
        if is_here or flags & NAMED:
            found.functions[part.name()] = index
    elif what == OF_DATA and is_here:
        name, segment, offset, size = part.name(), part.number(), part.number(), part.number()
        found.data[name] = Segment(segments[segment].address + offset, bytes(size))
    elif what == OF_GLOBAL and not is_here:
        part.number()
    else:
        raise UnknownObjectError(f"a symbol of kind {what} with flags {flags:#x} is not known")


def section(kind: int, content: bytes) -> bytes:
    """Return a section as it stands in a module."""
    return bytes([kind]) + sized(content)


def module_of(
    content: bytes, exports: Iterable[str], imports: frozenset[str], told: Mapping[str, object]
) -> bytes:
    """Return the module of an object.

    Parameters
    ----------
    content : bytes
        The object; its stack is at address 0.
    exports : iterable of str
        The functions that are exported, by their names.
    imports : frozenset of str
        The functions that may be imported.
    told : mapping
        What the page has to know beside `stack` and `free`: where the stack begins, which grows
        down, and from which address on memory is free.
    """
    sections, named = sections_of(content)
    require_imports(sections[IMPORT], imports)
    segments = segments_of(sections.pop(DATA))
    symbols = symbols_of(named["linking"], segments)
    stack = symbols.data["stack"]
    if stack.address != 0:
        raise UnknownObjectError("the stack would run into what is below it")
    names = list(exports)
    lines = (sized(name.encode()) + b"\0" + number(symbols.functions[name]) for name in names)
    sections[EXPORT] = number(len(names)) + b"".join(lines)
    kept = [each for each in segments if any(each.content)]
    if kept:
        raise UnknownObjectError(f"memory would begin with {len(kept)} segments other than zeros")
    del sections[DATA_COUNT]
    free = max(each.address + len(each.content) for each in segments)
    said = dict(told) | {"stack": len(stack.content), "free": -(-free // 16) * 16}
    text = json.dumps(said, separators=(",", ":"), sort_keys=True).encode()
    body = b"".join(section(kind, sections[kind]) for kind in ORDER if kind in sections)
    return MAGIC + body + section(CUSTOM, sized(ABOUT.encode()) + text)


def about(module: bytes) -> dict[str, object]:
    """Return what a module says of itself; nothing if it does not."""
    reader = Reader(module[len(MAGIC) :])
    while reader:
        kind, part = reader.byte(), Reader(reader.part())
        if kind == CUSTOM and part.name() == ABOUT:
            said: dict[str, object] = json.loads(part.rest())
            return said
    return {}
