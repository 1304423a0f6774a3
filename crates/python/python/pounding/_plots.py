"""Figures of tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._words import refused

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

__all__ = ["plot_required_gap", "plot_sweep"]


def plot_required_gap(table: pandas.DataFrame) -> Figure:
    """Draws the share of events that need more than a gap, a panel per gap.

    An event needs the largest width of its components and directions.

    Parameters
    ----------
    table
        The table of :meth:`Scene.required_gap`, or a part of its rows.
    """
    from ._figures import of_gaps

    both = table.groupby(["left", "right"], sort=False)
    widths = [(f"{left} – {right}", rows.groupby("event")["required_m"].max().tolist(), None) for (left, right), rows in both]
    return of_gaps(widths, "events")


def plot_sweep(table: pandas.DataFrame, x: str, y: str, *, by: str | None = None) -> Figure:
    """Draws a number of a sweep over a varied field: a dot per run; lines through the median and the 84 % fractile if values repeat.

    Parameters
    ----------
    table
        The table of :meth:`Scene.sweep`.
    x
        Column of the varied field, such as ``"contacts[*].gap_m"``.
    y
        Column of the number, such as ``"weak – stiff: peak_force_n"``.
    by
        Column whose values get a colour each.

    Raises
    ------
    Refused
        If the table has no such column, or no number in it.
    """
    from ._figures import of_sweep

    for place, column in (("x", x), ("y", y), ("by", by)):
        if column is not None and column not in table.columns:
            raise refused(place, f"`{column}`", f"are the columns of the table: {', '.join(map(str, table.columns))}")
    if table[y].dropna().empty:
        help = "take another column; impacts of a stereomechanical law have impulses and no force"
        raise refused("y", f"`{y}` without a number", "is a column with numbers", help)
    return of_sweep(table, x, y, by)
