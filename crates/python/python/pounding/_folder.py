"""A row under many records."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _pounding
from ._record import Record, read

if TYPE_CHECKING:
    import pandas

__all__ = ["Assessment"]


@contextlib.contextmanager
def folder_of(records: str | os.PathLike[str] | Iterable[Record]) -> Iterator[Path]:
    """The folder of records; of records at hand one that is there as long as it is asked."""
    if isinstance(records, (str, os.PathLike)):
        yield Path(os.fspath(records))
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
    """A name for each, by which components of one event are known; of those that have the same one, with a number before it.

    Two components of one file get the ends that components of one event have.
    """
    own = [Path(record.name).name for record in records]
    names = []
    for number, (record, name) in enumerate(zip(records, own)):
        alike = [other for other, its in zip(records, own) if its == name]
        components = [other.words.get("component") for other in alike]
        stem, ending = os.path.splitext(name)
        if len(alike) == 1:
            names.append(name)
        elif len(alike) == 2 and None not in components and components[0] != components[1]:
            names.append(f"{stem}-H{components.index(record.words['component']) + 1}{ending}")
        else:
            names.append(f"{own[:number].count(name) + 1:0{len(str(len(alike)))}}-{name}")
    return names


def _is_used(record: Record) -> bool:
    """Whether a file is used in another way than it stands."""
    return bool(set(record.words) - {"file"})


def _write(record: Record, path: Path) -> None:
    """Samples to the last bit; the reader finds the time step from the times."""
    rows = ["time_s,acceleration_m_per_s2"]
    rows += [f"{time!r},{one!r}" for time, one in zip(record.time.tolist(), record.acceleration.tolist())]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")


class Assessment:
    """What was found of a row under many records."""

    __slots__ = ("_facts", "_native")

    def __init__(self, native: _pounding.Assessment) -> None:
        self._native = native
        self._facts: dict[str, Any] | None = None

    @property
    def facts(self) -> dict[str, Any]:
        """Everything, as ``pounding assess --json`` prints it; units stand in the names."""
        if self._facts is None:
            self._facts = json.loads(self._native.facts())
        return dict(self._facts)

    @property
    def answers(self) -> list[str]:
        """The answer in sentences: whether the gaps are enough, what is proposed, and what touching does."""
        return self._native.answers()

    @property
    def motions(self) -> list[str]:
        """The motions in a few lines: how many, of how many events, how scaled."""
        return self._native.shaking()

    @property
    def warnings(self) -> list[str]:
        """What to know before believing it; then records that are left out, or whose direction nothing tells."""
        return [*self._native.warnings(), *self._native.remarks()]

    @property
    def table(self) -> pandas.DataFrame:
        """A row for each number of each run, as ``pounding assess --csv`` prints them; SI units in ``quantity``."""
        import pandas

        rows = list(csv.DictReader(io.StringIO(self._native.csv())))
        found = pandas.DataFrame(rows)
        found["value"] = [float(value) if value else float("nan") for value in found["value"]]
        found["scale_factor"] = [float(value) for value in found["scale_factor"]]
        found["reversed"] = found["reversed"] == "true"
        return found

    def report(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes ``report.html``, ``assess.csv``, ``assess.json`` and figures; returns the page."""
        from ._run import written

        return written(self._native.files(), folder, overwrite)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Assessment) and self.facts == other.facts

    def __hash__(self) -> int:
        return hash(self._native.facts())

    def __repr__(self) -> str:
        parts = [("Answer", self.answers), ("Motions", self.motions), ("Warnings", self.warnings)]
        return "\n".join(line for title, lines in parts if lines for line in [title, *(f"  {one}" for one in lines)])

    def _repr_html_(self) -> str:
        answers = "".join(f"<p>{escape(answer)}</p>" for answer in [*self.answers, "; ".join(self.motions)])
        notices = "".join(f"<li>{escape(notice)}</li>" for notice in self.warnings)
        return f"{answers}<ul>{notices}</ul>"
