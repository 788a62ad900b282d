"""A large table in a Zarr store, whose chunks are made one by one and in any order.

Beside the entries `epsilon_t` and their coordinates there is `interpolation_error`, for each chunk
the largest error found and the bound on it, written after the chunk: it is there if its error is.
Zarr writes each of them under another name first, so that they are whole or not there at all. What
a disk does to them later is seen when they are read, for every reader of zstd compares its
checksum.
"""

import contextlib
import logging
import math
import shutil
import uuid
from pathlib import Path
from typing import Any

import numpy as np
import zarr
import zarr.errors
from zarr.codecs import ZstdCodec

from restitution.errors import ParameterError, RestitutionError
from restitution.export.layout import SIGNS
from restitution.mechanics.hertz import FloatArray
from restitution.studies.tables.export import tabulated
from restitution.studies.tables.grid import Sign, TableGrid, grid_from, provenance
from restitution.studies.tables.largest_error import LargestError

CHUNK_ENTRIES = 2**17
"""Of a chunk at most: 1 MB, and seconds of work that a killed run loses."""

CHECKED = ZstdCodec(checksum=True)

Index = tuple[int, ...]

LOGGER = logging.getLogger(__name__)


def chunk_shape(shape: tuple[int, ...], entries: int = CHUNK_ENTRIES) -> tuple[int, ...]:
    """Return the shape of chunks of at most about so many entries, as cubic as `shape` allows.

    Along every axis the chunks are of nearly one size.

    Examples
    --------
    >>> chunk_shape((10, 1000, 1000))
    (10, 112, 112)
    """
    sides = dict.fromkeys(range(len(shape)), 1)
    room = float(entries)
    for left, axis in enumerate(sorted(sides, key=shape.__getitem__)):
        side = min(shape[axis], max(1, int(room ** (1.0 / (len(shape) - left)))))
        room /= side
        sides[axis] = math.ceil(shape[axis] / math.ceil(shape[axis] / side))
    return tuple(sides.values())


def open_store(
    path: Path, grid: TableGrid, sign: Sign, entries_per_chunk: int = CHUNK_ENTRIES
) -> None:
    """Make sure that `path` holds a store for the table on a grid, finished or not.

    Coordinates that are damaged are written anew.

    Raises
    ------
    ParameterError
        If there is something else, or a table of other parameters or another model.
    """
    wanted = provenance(grid, sign)
    if not path.exists():
        _create(path, grid, wanted, chunk_shape(grid.shape, entries_per_chunk))
        return
    held = _attributes(path)
    for name, value in _flat(wanted).items():
        found = _flat(held).get(name)
        if found != value:
            requirement = (
                f"a new path, or that of a table with {name} = {value!r}; the one there "
                f"has {found!r}"
            )
            raise ParameterError("store", str(path), requirement)
    for name, values in _coordinates(grid).items():
        array = _array(path, name)
        found = _read(array, ...)
        # logarithms of another processor may end in other digits
        if found is None or not np.allclose(found, values, rtol=1e-12, atol=0.0):
            LOGGER.warning("%s of %s is damaged: written anew", name, path)
            array[...] = values


def missing_chunks(path: Path) -> tuple[list[Index], int]:
    """Return the places of the chunks that are not there or damaged, and the number of all chunks.

    Those that are there are read: 0.25 s of CPU for 10⁷ entries.
    """
    entries, errors = _array(path, "epsilon_t"), _array(path, "interpolation_error")
    missing, damaged = list[Index](), list[Index]()
    for index in np.ndindex(errors.shape[:-1]):
        error = _read(errors, index)
        if error is not None and np.isnan(error).all():
            missing.append(index)
            continue
        values = None if error is None else _read(entries.blocks, index)
        # a file that is gone is read as NaN
        if values is None or np.isnan(values).any():
            damaged.append(index)
    if damaged:
        words = "%d of %d chunks in %s are damaged, as that at %s: computed anew"
        LOGGER.warning(words, len(damaged), entries.nchunks, path, damaged[0])
    return missing + damaged, entries.nchunks


def write_chunk(path: str, index: Index) -> None:
    """Compute one chunk of the store at `path` and write it.

    Everything else is read from the store: this is what a worker does.

    Raises
    ------
    RestitutionError
        If this is another version of the model than the one that made the store.
    """
    attributes = _attributes(Path(path))
    grid, sign = grid_from(attributes), attributes["sign"]
    if (mine := provenance(grid, sign)["model_version"]) != attributes["model_version"]:
        raise RestitutionError(
            f"a worker has version {mine} of the model and {path} was made by "
            f"{attributes['model_version']}: install the same restitution everywhere"
        )
    entries = _array(Path(path), "epsilon_t")
    begins = [i * side for i, side in zip(index, entries.chunks, strict=True)]
    ends = [
        min(begin + side, count)
        for begin, side, count in zip(begins, entries.chunks, grid.shape, strict=True)
    ]
    # one layer more: the cells towards the next chunk are judged here
    reached = [slice(begin, end + 1) for begin, end in zip(begins, ends, strict=True)]
    within = tuple(slice(end - begin) for begin, end in zip(begins, ends, strict=True))
    one_damping = [slice(None)] * (3 - len(reached))
    found, largest = tabulated(grid.nodes().part(*one_damping, *reached), sign)
    values = found.reshape(found.shape[len(one_damping) :])
    entries[tuple(map(slice, begins, ends))] = values[within]
    # a chunk that is but the last layer of the table has no cells: those before it have them
    known = (0.0, 0.0) if 1 in values.shape else (largest.found, largest.bound)
    _array(Path(path), "interpolation_error")[index] = known


def finish(path: Path) -> LargestError:
    """State the largest error in the store, whose chunks are all there, and return it."""
    group = zarr.open_group(path, mode="r+")
    found, bound = np.asarray(_array(path, "interpolation_error")[...]).reshape(-1, 2).max(0)
    in_three = "damping" in grid_from(dict(group.attrs)).axes
    largest = LargestError(float(found), float(bound), in_three)
    group.attrs.update(largest_error=largest.stated, error_basis=largest.basis)
    # what writers left that were killed
    for partial in path.rglob("*.partial"):
        partial.unlink(missing_ok=True)
    return largest


def _create(
    path: Path, grid: TableGrid, attributes: dict[str, Any], chunks: tuple[int, ...]
) -> None:
    """Make an empty store, whole or not at all."""
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        group = zarr.create_group(
            partial, attributes={**attributes, "convention": SIGNS[attributes["sign"]]}
        )
        for name, values in _coordinates(grid).items():
            group.create_array(name, data=values, compressors=CHECKED, dimension_names=[name])
        group.create_array(
            "epsilon_t",
            shape=grid.shape,
            chunks=chunks,
            dtype="f8",
            compressors=CHECKED,
            fill_value=math.nan,
            dimension_names=list(grid.axes),
        )
        group.create_array(
            "interpolation_error",
            shape=(*map(math.ceil, np.divide(grid.shape, chunks)), 2),
            chunks=(*(1 for _ in chunks), 2),
            dtype="f8",
            compressors=CHECKED,
            fill_value=math.nan,
            dimension_names=[*(f"{name}_chunk" for name in grid.axes), "found_and_bound"],
        )
        partial.rename(path)
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def _attributes(path: Path) -> dict[str, Any]:
    with contextlib.suppress(FileNotFoundError, NotADirectoryError, ValueError):
        attributes = dict(zarr.open_group(path, mode="r").attrs)
        if "model_version" in attributes:
            return attributes
    raise ParameterError("store", str(path), "a new path, or that of a table in a Zarr store")


def _array(path: Path, name: str) -> "zarr.Array[Any]":
    with contextlib.suppress(KeyError, ValueError, TypeError):
        array = zarr.open_group(path, mode="r+")[name]
        if isinstance(array, zarr.Array):
            return array
    raise ParameterError("store", str(path), f"a new path, for {name} of the one there is damaged")


def _read(source: Any, where: Any) -> FloatArray | None:
    """Return what an array or its blocks hold somewhere, None if that is damaged."""
    try:
        return np.asarray(source[where])
    except (RuntimeError, ValueError):
        return None


def _coordinates(grid: TableGrid) -> dict[str, FloatArray]:
    """Return the values along each axis by name; refuses what is wrong with an axis."""
    values = grid.nodes().values[-len(grid.axes) :]
    return dict(zip(grid.axes, values, strict=True))


def _flat(attributes: dict[str, Any], prefix: str = "") -> dict[str, Any]:
    """Return attributes by names with spaces, as `kappa minimum`."""
    flat: dict[str, Any] = {}
    for name, value in attributes.items():
        if isinstance(value, dict):
            flat |= _flat(value, "" if name == "axes" else f"{prefix}{name} ")
        else:
            flat[prefix + name.replace("_", " ")] = value
    return flat
