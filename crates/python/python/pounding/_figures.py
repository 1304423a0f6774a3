"""Figures for notebooks."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

if TYPE_CHECKING:
    import pandas

    from ._run import Run

#: More curves over time than these cannot be told from each other.
_MOST = 6
#: Pairs whose gaps are shown beside the profiles of buildings.
_MOST_PAIRS = 4


class Picture(Figure):
    """A figure outside the state of pyplot that notebooks still show."""

    def _repr_png_(self) -> bytes:
        into = io.BytesIO()
        self.savefig(into, format="png")
        return into.getvalue()


def _outside(axes: Any) -> None:
    """The legend at the right of the axes, where it hides nothing."""
    axes.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0)


def of_run(run: Run) -> Figure:
    """Displacements over time of a few floors, or of many floors the peak drifts over the height; below, the gaps."""
    peaks = run.peaks
    moving = peaks[peaks["period_s"].notna()] if "period_s" in peaks else peaks
    few = len(peaks) <= _MOST
    pairs = _closest(run)
    figure = Picture(figsize=(9, 5 if few else 7), layout="constrained")
    rows = figure.subplots(2 if len(pairs) else 1, 1, squeeze=False, height_ratios=[1.0, 1.0][: 2 if len(pairs) else 1])
    above = rows[0][0]
    if few:
        for name, column in zip(peaks["name"], run.displacement.T):
            above.plot(run.time, 1e3 * column, linewidth=0.8, label=name)
        above.set_xlabel("time [s]")
        above.set_ylabel("displacement [mm]")
    else:
        for building, storeys in moving.groupby("building", sort=False):
            drift = 1e3 * storeys["peak_drift_m"].fillna(storeys["peak_displacement_m"]).abs()
            above.plot(drift, storeys["storey"], marker="o", markersize=4, linewidth=1.0, label=building)
        above.set_xlim(left=0.0)
        above.set_xlabel("peak storey drift [mm]")
        above.set_ylabel("storey")
        above.yaxis.get_major_locator().set_params(integer=True)
    _outside(above)
    if len(pairs):
        below = rows[1][0]
        opening = run.opening
        for index in pairs.index:
            name = f"{pairs.loc[index, 'left']} – {pairs.loc[index, 'right']}"
            below.plot(run.time, 1e3 * opening[:, index], linewidth=0.8, label=name)
        left_out = len(run.pairs) - len(pairs)
        if left_out:
            below.set_title(f"the {len(pairs)} pairs that come closest; {left_out} others are left out", fontsize="small", loc="left")
        below.axhline(0.0, color="black", linewidth=0.5)
        below.set_xlabel("time [s]")
        below.set_ylabel("open width of the gap [mm]")
        _outside(below)
    return figure


def _closest(run: Run) -> pandas.DataFrame:
    """The pairs that are drawn: all of a few, else those that overlap most or come closest."""
    pairs = run.pairs
    if len(pairs) <= _MOST:
        return pairs
    return pairs.sort_values("least_opening_m").head(_MOST_PAIRS).sort_index()


def of_gaps(gaps: Sequence[tuple[str, Sequence[float], float | None]], what: str) -> Figure:
    """The share of cases that need more than a width, for gaps with a name, needed widths [m] and a width [m]."""
    figure = Picture(figsize=(8, 1.2 + 2.3 * max(len(gaps), 1)), layout="constrained")
    for axes, (name, needed, own) in zip(figure.subplots(max(len(gaps), 1), 1, squeeze=False)[:, 0], gaps):
        widths = sorted(1e3 * one for one in needed)
        shares = [100.0 * (len(widths) - index) / len(widths) for index in range(len(widths))]
        end = 1.05 * max([*widths, 1e3 * (own or 0.0)])
        axes.step([0.0, *widths, end], [100.0, *shares, 0.0], where="pre", linewidth=1.0)
        if own is not None:
            axes.axvline(1e3 * own, color="black", linestyle="--", linewidth=0.8, label=f"gap of the scene, {1e3 * own:g} mm")
            _outside(axes)
        axes.set_title(name, fontsize="medium", loc="left")
        axes.set(xlim=(0.0, end), ylim=(0.0, 102.0), xlabel="gap [mm]", ylabel=f"{what} that need more [%]")
    return figure


def of_sweep(table: pandas.DataFrame, x: str, y: str, by: str | None) -> Figure:
    """A number of a sweep over a varied field."""
    figure = Picture(figsize=(8, 4.5), layout="constrained")
    axes = figure.subplots()
    groups = [("", table)] if by is None else [(f"{value}: ", rows) for value, rows in table.groupby(by, sort=True)]
    for index, (name, rows) in enumerate(groups):
        colour = f"C{index % 10}"
        known = rows[[x, y]].dropna()
        axes.plot(known[x], known[y], ".", color=colour, alpha=0.35, markersize=4, label=f"{name}runs")
        repeated = known.groupby(x)[y]
        if len(known) > len(repeated) > 1:
            axes.plot(repeated.median(), color=colour, linewidth=1.4, label=f"{name}median")
            axes.plot(repeated.quantile(0.84), color=colour, linewidth=1.0, linestyle="--", label=f"{name}84 % fractile")
    axes.set(xlabel=x, ylabel=y)
    figure.legend(title=by, fontsize="small", title_fontsize="small", loc="outside lower left", ncols=3)
    return figure
