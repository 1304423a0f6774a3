"""A row under many records."""

from __future__ import annotations

import contextlib
import csv
import io
import itertools
import json
import os
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _pounding
from ._record import Record, read
from ._words import present, visible

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

__all__ = ["Assessment", "Ida"]


@contextlib.contextmanager
def folder_of(records: str | os.PathLike[str] | Iterable[Record]) -> Iterator[Path]:
    """The folder of records. Records in memory are written to a temporary folder."""
    if isinstance(records, (str, os.PathLike)):
        yield present(Path(os.fspath(records)))
    else:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            given = [records] if isinstance(records, Record) else records
            all_of_them = [one if isinstance(one, Record) else read(one) for one in given]
            for record, own in zip(all_of_them, _names(all_of_them)):
                if record._native.kind == "file" and not _is_used(record):
                    (folder / own).write_bytes(record._native.raw)
                else:
                    _write(record, folder / own)
            yield folder


def _names(records: Sequence[Record]) -> list[str]:
    """File names of records: their own names, which identify components of one event, with a number in front if a name is taken."""
    names: list[str] = []
    taken: set[str] = set()
    for record in records:
        own = Path(record.name).name.lstrip(".") or "record"
        free = (name for number in itertools.count(1) if (name := f"{number}-{own}").lower() not in taken)
        names.append(own if own.lower() not in taken else next(free))
        taken.add(names[-1].lower())
    return names


def _is_used(record: Record) -> bool:
    """Whether a file is processed or scaled when it is used."""
    return bool(set(record.words) - {"file"})


def _write(record: Record, path: Path) -> None:
    """Writes the samples to the last bit; readers find the time step from the times."""
    rows = ["time_s,acceleration_m_per_s2"]
    rows += [f"{time!r},{one!r}" for time, one in zip(record.time.tolist(), record.acceleration.tolist())]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")


class Assessment:
    """The results of a row under many records."""

    __slots__ = ("_facts", "_native")

    def __init__(self, native: _pounding.Assessment) -> None:
        self._native = native
        self._facts: dict[str, Any] | None = None

    @property
    def facts(self) -> dict[str, Any]:
        """All results, as ``pounding assess --json`` prints them; names end with units."""
        if self._facts is None:
            self._facts = json.loads(self._native.facts())
        return dict(self._facts)

    @property
    def unusual(self) -> list[str]:
        """Implausible values of the scene and of its records, one sentence per kind: look at them first."""
        return self._native.unusual()

    @property
    def answers(self) -> list[str]:
        """Whether the gaps are enough, in sentences."""
        return [visible(one) for one in self._native.answers()]

    @property
    def sentences(self) -> list[str]:
        """The whole answer: whether the gaps are enough, the proposals, and the effects of touching."""
        return [visible(one) for one in self._native.sentences()]

    @property
    def motions(self) -> list[str]:
        """The motions in a few lines: their number, the number of events, and the scaling."""
        return [visible(one) for one in self._native.shaking()]

    @property
    def warnings(self) -> list[str]:
        """Warnings about the results."""
        return [visible(one) for one in self._native.warnings()]

    @property
    def remarks(self) -> list[str]:
        """Remarks on records that are left out, or whose direction is unknown."""
        return [visible(one) for one in self._native.remarks()]

    @property
    def table(self) -> pandas.DataFrame:
        """One row per number of each run, as ``pounding assess --csv`` prints them; ``quantity`` ends with the SI unit."""
        import pandas

        rows = list(csv.DictReader(io.StringIO(self._native.csv())))
        found = pandas.DataFrame(rows)
        found["value"] = [float(value) if value else float("nan") for value in found["value"]]
        found["scale_factor"] = [float(value) for value in found["scale_factor"]]
        found["reversed"] = found["reversed"] == "true"
        return found

    def plot(self) -> Figure:
        """Draws the share of the events that need more than a gap while the buildings stand alone, a panel per gap."""
        from ._figures import of_gaps

        gaps = [
            (f"{gap['left']} – {gap['right']}", gap["required_sorted_m"], gap["gap_m"]) for gap in self.facts["gaps"]
        ]
        return of_gaps(gaps, "events")

    def report(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes ``report.html``, ``assess.csv``, ``assess.json`` and figures. Returns the path of the page."""
        from ._run import written

        return written(self._native.files(), folder, overwrite)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Assessment) and self.facts == other.facts

    def __hash__(self) -> int:
        return hash(self._native.facts())

    def __repr__(self) -> str:
        parts = [
            ("Unusual", self.unusual),
            ("Answer", self.sentences),
            ("Motions", self.motions),
            ("Warnings", self.warnings),
            ("Records", self.remarks),
        ]
        return "\n".join(line for title, lines in parts if lines for line in [title, *(f"  {one}" for one in lines)])

    def _repr_html_(self) -> str:
        unusual = "".join(f"<li>Unusual: {escape(one)}</li>" for one in self.unusual)
        answers = "".join(f"<p>{escape(answer)}</p>" for answer in [*self.sentences, "; ".join(self.motions)])
        notices = "".join(f"<li>{escape(notice)}</li>" for notice in [*self.warnings, *self.remarks])
        return f"<ul>{unusual}</ul>{answers}<ul>{notices}</ul>"


class Ida:
    """How often the states of a row are reached."""

    __slots__ = ("_facts", "_native")

    def __init__(self, native: _pounding.Ida) -> None:
        self._native = native
        self._facts: dict[str, Any] | None = None

    @property
    def facts(self) -> dict[str, Any]:
        """All results, as ``pounding ida --json`` prints them; names end with units."""
        if self._facts is None:
            self._facts = json.loads(self._native.facts())
        return dict(self._facts)

    @property
    def states(self) -> pandas.DataFrame:
        """One row per state: median and dispersion of its fragility, and its annual frequency, with bounds."""
        return self._frame("states")

    @property
    def by_gap(self) -> pandas.DataFrame:
        """The same numbers of touching, one row per width of all gaps."""
        return self._frame("by_gap")

    @property
    def stripes(self) -> pandas.DataFrame:
        """One row per state and intensity: how many events reach it, and what the fragility says."""
        return self._frame("stripes")

    @property
    def table(self) -> pandas.DataFrame:
        """One row per run, as ``pounding ida --csv`` prints them."""
        import pandas

        return pandas.read_csv(io.StringIO(self._native.csv()), float_precision="round_trip")

    @property
    def warnings(self) -> list[str]:
        """Why there is no fragility or frequency of the first state, and faults that the answer may have."""
        refused = self._native.refused()
        return [visible(one) for one in [*([refused] if refused else []), *self.facts["warnings"]]]

    def report(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes ``ida.txt``, ``ida.csv``, ``ida.json``, ``stripes.csv`` and figures. Returns the path of the text."""
        from ._run import written

        return written(self._native.files(), folder, overwrite).with_name("ida.txt")

    def _frame(self, fact: str) -> pandas.DataFrame:
        import pandas

        return pandas.DataFrame(self.facts[fact])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Ida) and self.facts == other.facts

    def __hash__(self) -> int:
        return hash(self._native.facts())

    def __repr__(self) -> str:
        return self._native.text()
