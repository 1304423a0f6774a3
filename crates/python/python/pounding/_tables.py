"""Conversion of the library's tables to pandas."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _pounding

if TYPE_CHECKING:
    import pandas

Floats = NDArray[np.float64]


def view(array: _pounding.Array) -> NDArray[Any]:
    """A read-only view of the library's memory."""
    found: NDArray[Any] = np.asarray(array)
    return found


def frame(table: _pounding.Table) -> pandas.DataFrame:
    """Converts a table to a DataFrame.

    Raises
    ------
    ImportError
        If pandas is not installed; polars and pyarrow read the table itself.
    """
    try:
        import pandas
    except ImportError as error:
        raise ImportError(
            "pandas is not installed: pip install pandas, or give the Arrow table to polars or pyarrow "
            "(run.table('impacts'))"
        ) from error

    def column(name: str) -> Any:
        found = table.column(name)
        return view(found) if isinstance(found, _pounding.Array) else found

    return pandas.DataFrame({name: column(name) for name in table.columns}, columns=table.columns)
