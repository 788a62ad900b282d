"""Results as frames of pandas and data sets of xarray, both of the extra `notebook`."""

import abc
import contextlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from restitution.errors import MissingExtraError
from restitution.quantities import QUANTITIES

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

Columns = Mapping[str, npt.NDArray[Any]]
"""Name, one of `QUANTITIES` → values along the last of the axes, as many as it has dimensions."""


@dataclass(frozen=True)
class Table:
    """Columns over one or more axes, the last of which runs fastest.

    Attributes
    ----------
    axes : mapping of str to ndarray
        Each of shape (n,).
    columns : mapping of str to ndarray
        What was found, over all axes.
    given : mapping of str to ndarray
        What it was found for: one number, or one for each value of the last axes.
    remarks : mapping of str to str or float
        What holds for the whole table.
    """

    axes: Columns
    columns: Columns
    given: Columns = field(default_factory=dict)
    remarks: Mapping[str, str | float] = field(default_factory=dict)


class Tabular(abc.ABC):
    """A result that has columns."""

    @abc.abstractmethod
    def table(self) -> Table:
        """Return the columns with their axes."""

    def to_pandas(self) -> "pd.DataFrame":
        """Return the columns as a frame, indexed by the axes; of several axes in long form.

        Returns
        -------
        DataFrame
            Its `attrs` hold ``units``, ``symbols`` and ``long_names`` of index and columns, the
            parameters that are one number for all rows, and remarks as the convention of signs.

        Raises
        ------
        MissingExtraError
            If pandas is not installed: it is in the extra ``notebook``.
        """
        with _of_the_notebook():
            import pandas as pd  # noqa: PLC0415 - of an extra
        table = self.table()
        edges = list(table.axes.values())
        shape = tuple(values.size for values in edges)
        columns = {name: values for name, values in table.given.items() if values.ndim}
        columns |= table.columns
        frame = pd.DataFrame(
            {name: np.broadcast_to(values, shape).ravel() for name, values in columns.items()},
            index=pd.MultiIndex.from_product(edges, names=list(table.axes))
            if len(edges) > 1
            else pd.Index(edges[0], name=next(iter(table.axes))),
        )
        described = {name: QUANTITIES[name] for name in (*table.axes, *table.given, *table.columns)}
        remarks: dict[Any, Any] = {
            "units": {name: what.unit for name, what in described.items() if what.unit},
            "symbols": {name: what.symbol for name, what in described.items() if what.symbol},
            "long_names": {name: what.text for name, what in described.items()},
            **{name: values.item() for name, values in table.given.items() if not values.ndim},
            **table.remarks,
        }
        frame.attrs = remarks
        return frame

    def to_xarray(self) -> "xr.Dataset":
        """Return the columns as a data set over the axes.

        Returns
        -------
        Dataset
            Axes and given parameters are coordinates; `attrs` of each variable hold ``units``,
            ``symbol`` and ``long_name``, those of the data set remarks as the convention of signs.

        Raises
        ------
        MissingExtraError
            If xarray is not installed: it is in the extra ``notebook``.
        """
        with _of_the_notebook():
            import xarray as xr  # noqa: PLC0415 - of an extra
        table = self.table()
        names = tuple(table.axes)

        def variables(columns: Columns) -> dict[str, Any]:
            return {
                # copies, for a data set may be written to
                name: (names[len(names) - values.ndim :], values.copy(), _attributes(name))
                for name, values in columns.items()
            }

        edges = {name: ((name,), values, _attributes(name)) for name, values in table.axes.items()}
        return xr.Dataset(
            variables(table.columns), edges | variables(table.given), dict(table.remarks)
        )


def _attributes(name: str) -> dict[str, str]:
    """Return what is said of a quantity, by the keys that xarray labels its plots with."""
    quantity = QUANTITIES[name]
    said = {"long_name": quantity.text, "units": quantity.unit, "symbol": quantity.symbol}
    return {key: text for key, text in said.items() if text}


@contextlib.contextmanager
def _of_the_notebook() -> Iterator[None]:
    """Say which extra has what is not there."""
    try:
        yield
    except ImportError as missing:
        raise MissingExtraError(missing.name, "notebook") from missing
