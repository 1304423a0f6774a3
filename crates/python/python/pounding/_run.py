"""Runs of scenes."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _pounding
from ._errors import PoundingWarning
from ._tables import Floats, frame, view
from ._words import visible, warn

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

    from ._record import Record
    from ._scene import Scene

__all__ = ["Run"]


#: Drifts of a ground storey, with the displacements that they equal.
_ON_THE_GROUND = {
    "peak_drift_m": "peak_displacement_m",
    "peak_drift_time_s": "peak_displacement_time_s",
    "residual_drift_at_end_m": "residual_displacement_at_end_m",
}


class Run:
    """The results of a run. They do not change.

    Arrays have one row per instant of :attr:`time`. They have one column per floor, in the order of :attr:`peaks`, or per pair of
    floors, in the order of :attr:`pairs`.
    """

    __slots__ = ("_native", "_options", "_record", "_summary", "scene")

    def __init__(
        self, native: _pounding.Run, scene: Scene, record: Record | None, options: dict[str, bool]
    ) -> None:
        self._native = native
        self._record = record
        self._options = options
        self._summary: dict[str, Any] | None = None
        #: The scene that ran.
        self.scene = scene

    @property
    def summary(self) -> dict[str, Any]:
        """Every number of the run, as ``pounding run --json`` prints them; names end with units."""
        if self._summary is None:
            self._summary = json.loads(self._native.summary())
        return dict(self._summary)

    @property
    def warnings(self) -> list[str]:
        """Warnings about the numbers: implausible values first, then the others, the most harmful first."""
        return [visible(one) for one in [*self.unusual, *self._native.notices()]]

    @property
    def unusual(self) -> list[str]:
        """Implausible values of the scene and of its record, one sentence per kind."""
        return self._native.unusual()

    def _warn(self) -> None:
        for notice in self.warnings:
            warn(notice, stacklevel=3)

    def table(self, name: str) -> _pounding.Table:
        """The table ``"peaks"``, ``"pairs"``, ``"links"`` or ``"impacts"`` for every reader of Arrow, for example ``polars.DataFrame(…)``."""
        return self._native.table(name)

    @property
    def peaks(self) -> pandas.DataFrame:
        """One row per floor and wall; names of columns end with SI units.

        The drift of a ground storey is the displacement of its floor; the table of a file leaves it out.
        """
        found = frame(self.table("peaks"))
        for drift, displacement in _ON_THE_GROUND.items():
            if drift in found.columns:
                found[drift] = found[drift].fillna(found[displacement].where(found["storey"] == 1))
        return found

    @property
    def pairs(self) -> pandas.DataFrame:
        """One row per pair of floors that face each other; names of columns end with SI units."""
        return frame(self.table("pairs"))

    @property
    def links(self) -> pandas.DataFrame:
        """One row per link, in the order of the scene; names of columns end with SI units."""
        return frame(self.table("links"))

    @property
    def impacts(self) -> pandas.DataFrame:
        """One row per collision, in the order of their starts; names of columns end with SI units."""
        return frame(self.table("impacts"))

    def history(self, name: str) -> Floats:
        """A history by its name in ``history.csv``, without the floor or pair: ``displacement_m``, ``velocity_m_per_s``,
        ``absolute_acceleration_m_per_s2``, ``shear_force_n``, ``storey_drift_m``, ``pounding_force_n`` or ``opening_m``."""
        rows: Floats = view(self._native.history(name))
        return rows.T

    @property
    def time(self) -> Floats:
        """Instants of the histories [s]."""
        return np.arange(len(self.displacement), dtype=np.float64) * self._native.interval

    @property
    def displacement(self) -> Floats:
        """Displacement of every floor relative to the ground, positive to the right [m]."""
        return self.history("displacement_m")

    @property
    def velocity(self) -> Floats:
        """Velocity of every floor relative to the ground [m/s]."""
        return self.history("velocity_m_per_s")

    @property
    def acceleration(self) -> Floats:
        """Acceleration of every floor including that of the ground [m/s²]. Impulses have no acceleration and are left out."""
        return self.history("absolute_acceleration_m_per_s2")

    @property
    def shear_force(self) -> Floats:
        """Shear force of the storey below every floor [N]."""
        return self.history("shear_force_n")

    @property
    def drift(self) -> Floats:
        """Displacement of every floor relative to the one below [m]."""
        return self.history("storey_drift_m")

    @property
    def opening(self) -> Floats:
        """Open width of the gap of every pair [m]; negative while floors overlap."""
        return self.history("opening_m")

    @property
    def pounding_force(self) -> Floats:
        """Pounding force of every pair [N], ≥ 0; 0 for laws that act by impulses."""
        return self.history("pounding_force_n")

    @property
    def sentence(self) -> str:
        """A sentence on how often and how hard floors touch."""
        return visible(self._native.sentence())

    def directions(self) -> list[str]:
        """Sentences for both directions of shaking, the worse one for the buildings first. The other direction runs in this call.

        Further warnings of the other direction become Python warnings of the class :class:`PoundingWarning`.
        """
        sentences, notices = self._native.directions()
        for notice in notices:
            if visible(notice) not in self.warnings:
                warn(notice, stacklevel=2)
        return [visible(one) for one in sentences]

    def plot(self) -> Figure:
        """Draws the run by matplotlib: displacements over time of up to six floors, of more floors the peak drifts over the height, and the
        gaps over time.
        """
        from ._figures import of_run

        return of_run(self)

    def report(
        self, folder: str | os.PathLike[str], *, both: bool = True, overwrite: bool = False
    ) -> Path:
        """Writes a report: ``report.html``, ``summary.json``, ``history.csv``, ``impacts.csv`` and figures.

        Parameters
        ----------
        folder
            Folder of the report; created if it is missing.
        both
            Also describe the reversed shaking, which runs in this call.
        overwrite
            Write also into a folder with other files, which stay. A report of an earlier run is always replaced.

        Returns
        -------
        pathlib.Path
            Path of the page.
        """
        return written(self._native.files(both), folder, overwrite, self._inputs())

    def _inputs(self) -> list[Path]:
        """Files that were read, which a report must not overwrite."""
        scene = Path(self.scene._path)
        found = [scene]
        if self._record is not None:
            found.append(self._record.path or scene)
        elif "file" in (words := self.scene.to_dict().get("record", {})):
            found.append(scene.parent / words["file"])
        return [path for path in found if path.is_file()]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Run) and self.summary == other.summary

    def __hash__(self) -> int:
        return hash(self._native.summary())

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.scene, self._record, self._options)

    def __repr__(self) -> str:
        unusual = "".join(f"Unusual: {one}\n" for one in self.unusual)
        return f"{unusual}{self._line()}"

    def _line(self) -> str:
        return f"Run of {self.summary['scene']['name']!r}, {self._native.duration:g} s: {self.sentence}"

    def _repr_html_(self) -> str:
        unusual = "".join(f"<li>Unusual: {escape(one)}</li>" for one in self.unusual)
        notices = "".join(f"<li>{escape(notice)}</li>" for notice in self._native.notices())
        return f"<ul>{unusual}</ul><p>{escape(self._line())}</p>{self._native.sketch()}<ul>{notices}</ul>"


def written(
    files: Mapping[str, bytes], folder: str | os.PathLike[str], overwrite: bool, inputs: Sequence[Path] = ()
) -> Path:
    """Writes a report into a folder; returns the path of its page."""
    target = Path(folder)
    _pounding.write_files(target, dict(files), overwrite, list(inputs))
    return target / "report.html"


def _again(scene: Scene, record: Record | None, options: dict[str, bool]) -> Run:
    """Runs a pickled scene and record again: every run gives equal bits."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", PoundingWarning)
        return scene.run(record, **options)
