"""Ground motions."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _pounding
from ._tables import Floats, frame, view
from ._words import FORMULA, RECORD, numbers, to_json, visible, words

if TYPE_CHECKING:
    import pandas

__all__ = ["Record", "formula", "read", "record"]


class Record:
    """A ground motion as it shakes a row: read, processed, scaled.

    :func:`read` makes it from a file, :func:`record` from an array, :func:`formula` from a formula. It does not change;
    :meth:`using` returns another one.
    """

    __slots__ = ("_facts", "_native")

    def __init__(self, native: _pounding.Record) -> None:
        self._native = native
        self._facts: dict[str, Any] | None = None

    @property
    def facts(self) -> dict[str, Any]:
        """The values read with their lines, and measures of the motion as used; names end with units."""
        if self._facts is None:
            self._facts = json.loads(self._native.facts())
        return dict(self._facts)

    @property
    def words(self) -> dict[str, Any]:
        """The table ``record`` of a scene with this record."""
        found: dict[str, Any] = json.loads(self._native.words)
        return found

    @property
    def acceleration(self) -> Floats:
        """Ground acceleration as used [m/s²]: a read-only view without a copy."""
        return view(self._native.acceleration)

    @property
    def time(self) -> Floats:
        """Instants of the samples [s]."""
        return np.arange(len(self.acceleration), dtype=np.float64) * self.dt

    @property
    def dt(self) -> float:
        """Time between two samples [s]."""
        return self._native.time_step

    @property
    def duration(self) -> float:
        """Time of the last sample [s]."""
        return self._native.duration

    @property
    def unit(self) -> str:
        """Unit of the values in the file, as :func:`read` takes it; ``"m_per_s2"`` for an array or a formula.

        :attr:`acceleration` is always in m/s².
        """
        return str(self.facts["unit"] or "m_per_s2")

    @property
    def pga(self) -> float:
        """Peak ground acceleration as used, the largest magnitude [m/s²]."""
        return float(self.facts["pga_m_per_s2"])

    @property
    def scale_factor(self) -> float:
        """Product of all scale factors on the values of the source [–]."""
        return self._native.scale_factor

    @property
    def path(self) -> Path | None:
        """The file; ``None`` for an array or a formula."""
        path = self._native.path
        return None if path is None else Path(path)

    @property
    def name(self) -> str:
        """Name of the file, or of the formula."""
        generated = self.words.get("generated")
        if generated:
            return str(next(iter(generated)))
        return os.path.basename(str(self.words["file"]))

    def using(
        self,
        *,
        scale: float | None = None,
        reversed: bool | None = None,
        scale_to: Mapping[str, Any] | None = None,
        detrend: str | None = None,
        band_pass: Mapping[str, Any] | None = None,
        interpolation: str | None = None,
        resample: float | None = None,
        gravity: float | None = None,
    ) -> Record:
        """The motion used in another way; settings that are not given stay.

        Parameters
        ----------
        scale
            Factor on the acceleration [–], after ``scale_to``.
        reversed
            Whether the direction of shaking is reversed.
        scale_to
            ``{"pga_g": 0.3}`` [g], or ``{"sa": {"period_s": 0.8, "damping_ratio": 0.05, "sa_g": 0.5}}``.
        detrend
            ``"constant"`` or ``"linear"``: the line to subtract.
        band_pass
            ``{"low_hz": 0.1, "high_hz": 25.0, "order": 4}`` [Hz].
        interpolation
            The motion between samples: ``"linear"`` or ``"band_limited"``.
        resample
            New time step [s].
        gravity
            Value of one g [m/s²]; 9.80665 by default.
        """
        given = locals()
        del given["self"]
        used = {**self.words, **words(given, RECORD)}
        return Record(self._native.used(to_json(used)))

    def spectrum(
        self, periods: ArrayLike | None = None, damping: float | Sequence[float] = 0.05
    ) -> pandas.DataFrame:
        """Response spectra, exact for an acceleration that is linear between samples.

        Parameters
        ----------
        periods
            Natural periods [s], 0 for the ground itself; by default 100 from 0.02 s to 10 s, rising by a constant ratio.
        damping
            Damping ratio or ratios [–].
        """
        return frame(self.spectrum_table(periods, damping))

    def spectrum_table(
        self, periods: ArrayLike | None = None, damping: float | Sequence[float] = 0.05
    ) -> _pounding.Table:
        """Response spectra as in :meth:`spectrum`, as an Arrow table."""
        if periods is None:
            periods = np.array(_pounding.periods_between(0.02, 10.0, 100))
        periods = numbers(periods, "periods", or_one=True)
        ratios = numbers(damping, "damping", or_one=True)
        return self._native.spectrum(periods.tolist(), ratios.tolist())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self._native == other._native

    def __hash__(self) -> int:
        return hash((self._native.words, self.dt, len(self.acceleration)))

    def __reduce__(self) -> tuple[Any, ...]:
        native = self._native
        state = (native.kind, native.path, native.raw, native.raw_time_step, native.words)
        return _remade, state

    def __repr__(self) -> str:
        facts = self.facts
        lines = [
            f"Record {self.name}: {facts['n_samples']} samples, dt {self.dt:g} s, peak {facts['peak_m_per_s2']:.4g} m/s² "
            f"at {facts['pga_time_s']:g} s"
        ]
        for one in facts["readings"]:
            where = f" (line {one['line']})" if "line" in one else ""
            lines.append(f"  {one['what']}: {one['found']}{where}")
        if self.scale_factor != 1.0:
            lines.append(f"  multiplied by {self.scale_factor:.6g}")
        return visible("\n".join(lines))


def _remade(
    kind: str, path: Path | None, raw: bytes, time_step: float | None, words_of_it: str
) -> Record:
    if kind == "file" and path is not None:
        return Record(_pounding.Record.of_file(path, words_of_it, raw))
    if kind == "samples" and time_step is not None:
        return Record(_pounding.Record.of_samples(raw, time_step, words_of_it))
    return Record(_pounding.Record.of_formula(words_of_it))


def read(
    path: str | os.PathLike[str],
    *,
    unit: str | None = None,
    time_step: float | None = None,
    component: str | int | None = None,
    per_count: float | None = None,
    acceleration: bool | None = None,
    scale: float | None = None,
    reversed: bool | None = None,
    scale_to: Mapping[str, Any] | None = None,
    detrend: str | None = None,
    band_pass: Mapping[str, Any] | None = None,
    interpolation: str | None = None,
    resample: float | None = None,
    gravity: float | None = None,
) -> Record:
    """Reads a record file; its contents determine its format.

    Parameters
    ----------
    path
        The file: AT2, COSMOS, SMC, CSMIP, ESM, K-NET, SAC, miniSEED, CSV, columns and others.
    unit
        Unit of the values, if the file does not say: ``"g"``, ``"m_per_s2"``, ``"cm_per_s2"``, ``"mm_per_s2"``, ``"mg"``,
        ``"g_per_10"``.
    time_step
        Time between samples [s], if the file does not say.
    component
        Component of a file with several, by its name or its number from 1.
    per_count
        Value of one count of the file, in ``unit``.
    acceleration
        Declares that the file holds accelerations although it looks like velocities.
    scale, reversed, scale_to, detrend, band_pass, interpolation, resample, gravity
        As in :meth:`Record.using`.

    Raises
    ------
    Refused
        With the value found, the values allowed, and the remedy.
    """
    given = locals()
    name = os.fspath(given.pop("path"))
    table = {"file": name, **words(given, RECORD)}
    return Record(_pounding.Record.of_file(Path(name), to_json(table)))


def record(acceleration: ArrayLike, dt: float, *, name: str = "array") -> Record:
    """Makes a record from an array.

    Parameters
    ----------
    acceleration
        Ground acceleration at t = 0, dt, 2 dt, … [m/s²]: real numbers in one dimension without a mask.
    dt
        Time between two samples [s], > 0.
    name
        Name for tables and reports.

    Raises
    ------
    Refused
        With the value found and the remedy.
    """
    samples = numbers(acceleration, "acceleration", wants_floats=True)
    return Record(_pounding.Record.of_samples(samples.tobytes(), float(dt), to_json({"file": name})))


def formula(kind: str, **keywords: Any) -> Record:
    """A ground motion from a formula.

    Parameters
    ----------
    kind
        ``"harmonic"`` (amplitude [m/s²], frequency [Hz], phase [rad], ramp_periods, duration [s], time_step [s]),
        ``"ricker"`` (amplitude, frequency, time_step),
        ``"half_sine"`` (amplitude, duration, time_step), or
        ``"stochastic"`` (ground ``"firm"``, ``"medium"`` or ``"soft"``, pga [m/s²], strong_from [s], strong_until [s],
        decay [1/s], cutoff [Hz], duration [s], time_step [s], seed).
    **keywords
        Settings of the formula.

    Examples
    --------
    >>> pulse = formula("ricker", amplitude=3.0, frequency=1.0, time_step=0.01)
    >>> pulse.dt
    0.01
    """
    table = {"generated": {kind: words(keywords, FORMULA)}}
    return Record(_pounding.Record.of_formula(to_json(table)))
