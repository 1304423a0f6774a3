"""Conversion of the library's tables to pandas."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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


#: Responses of a floor in the answer about effects: name there, name of columns, unit.
_EFFECTS = (
    ("peak_drift_m", "drift", "m"),
    ("peak_shear_force_n", "shear_force", "n"),
    ("peak_acceleration_m_per_s2", "acceleration", "m_per_s2"),
)


def effect_row(floor: Mapping[str, Any], is_reversed: bool, buildings: Sequence[str]) -> dict[str, Any]:
    """A floor of the answer about effects as a row of a table."""
    building, found, level = str(floor["name"]).rpartition(", floor ")
    is_level = bool(found) and building in buildings and level.isdecimal()
    row: dict[str, Any] = {
        "building": building if is_level else floor["name"],
        "storey": int(level) if is_level else 1,
        "name": floor["name"],
        "reversed": is_reversed,
    }

    def known(name: str, number: Mapping[str, Any] | None) -> None:
        for end, key in (("", "value"), ("_low", "low"), ("_high", "high")):
            row[f"{name}{end}"] = None if number is None else number[key]

    for name in ("collisions", "impulse_n_s", "largest_impulse_n_s"):
        known(name, floor[name])
    for key, name, unit in _EFFECTS:
        effect = floor.get(key)
        row[f"peak_{name}_alone_{unit}"] = effect and effect["alone"]
        row[key] = effect and effect["beside"]
        known(f"{name}_amplification", effect and effect["amplification"])
    return row
