"""
Functions and classes for the package `pounding`.
"""

from _typeshed import SupportsGetItem, SupportsLenAndGetItem
from os import PathLike
from pathlib import Path
from typing import Any, SupportsFloat, SupportsIndex, final

__all__ = ["Array", "Assessment", "Ida", "Record", "Run", "Table", "advise", "assess", "certify", "check_scene", "effects", "ida", "laws", "opensees", "periods_between", "read_words", "required_gap", "run", "sketch_scene", "sweep", "visible", "words_of", "write_files"]

@final
class Array:
    """
    Numbers that do not change: `numpy.asarray` gives a read-only view of them.
    """
    @property
    def __array_interface__(self, /) -> Any:
        """
        Address, type and shape in NumPy's form. The memory lives as long as this object.
        """

@final
class Assessment:
    """
    An assessment of a row under a folder of records.
    """
    def answers(self, /) -> list[str]:
        """
        Whether the gaps are enough, in sentences.
        """
    def csv(self, /) -> str:
        """
        The table of `pounding assess --csv`, one row per number.
        """
    def facts(self, /) -> str:
        """
        All results, as the JSON of `pounding assess --json`.
        """
    def files(self, /) -> dict[str, bytes]:
        """
        The files of a report, by name.
        """
    def remarks(self, /) -> list[str]:
        """
        Remarks on records that are left out, or whose direction is unknown.
        """
    def sentences(self, /) -> list[str]:
        """
        The whole answer: the gaps, the proposals and the effects of touching.
        """
    def shaking(self, /) -> list[str]:
        """
        The motions in a few lines.
        """
    def unusual(self, /) -> list[str]:
        """
        Implausible values of the scene and of its records.
        """
    def warnings(self, /) -> list[str]:
        """
        Warnings about the results, and how much stronger all records were made to reach their target.
        """

@final
class Ida:
    """
    How often the states of a row are reached, as the answer of `pounding ida`.
    """
    def csv(self, /) -> str:
        """
        The table of `pounding ida --csv`, one row per run.
        """
    def facts(self, /) -> str:
        """
        All results, as the JSON of `pounding ida --json`.
        """
    def files(self, /) -> dict[str, bytes]:
        """
        The files of a folder of results, by name.
        """
    def refused(self, /) -> str | None:
        """
        Why the first state has no fragility or no frequency; `None` if it has.
        """
    def text(self, /) -> str:
        """
        The answer as `pounding ida` prints it.
        """

@final
class Record:
    """
    A ground motion with its source, used as the table `record` of a scene says.
    """
    def __eq__(self, other: object, /) -> bool: ...
    @property
    def acceleration(self, /) -> Array:
        """
        Ground acceleration as used [m/s²].
        """
    @property
    def duration(self, /) -> float:
        """
        Time of the last sample [s].
        """
    def facts(self, /) -> str:
        """
        Location and contents of the record, measures, unit and format, as JSON.
        """
    @property
    def kind(self, /) -> str:
        """
        Kind of the source: `file`, `samples` or `formula`.
        """
    @staticmethod
    def of_file(path: str | PathLike[str], words: str, raw: bytes | None = None) -> Record:
        """
        Reads a file. `raw` is its content if the file need not be opened. `words` is the table `record` as JSON.
        """
    @staticmethod
    def of_formula(words: str) -> Record:
        """
        Makes a motion from the formula that `words` name.
        """
    @staticmethod
    def of_samples(samples: bytes, time_step: SupportsFloat | SupportsIndex, words: str) -> Record:
        """
        Takes samples in m/s² as the bytes of 64-bit numbers, `time_step` s apart.
        """
    @property
    def path(self, /) -> Path | None:
        """
        The file; `None` for another kind of source.
        """
    @property
    def raw(self, /) -> bytes:
        """
        The bytes of the file, or of the given samples; empty for a formula.
        """
    @property
    def raw_time_step(self, /) -> float | None:
        """
        Time between the given samples [s]; `None` for a source other than `samples`.
        """
    @property
    def scale_factor(self, /) -> float:
        """
        Factor on the values of the source [–].
        """
    def spectrum(self, /, periods: SupportsGetItem[int, SupportsFloat | SupportsIndex], damping_ratios: SupportsGetItem[int, SupportsFloat | SupportsIndex]) -> Table:
        """
        Response spectra at some periods [s] for some damping ratios [–], one row per combination.
        """
    @property
    def time_step(self, /) -> float:
        """
        Time between two samples as used [s].
        """
    def used(self, /, words: str) -> Record:
        """
        The motion used in another way.
        """
    @property
    def words(self, /) -> str:
        """
        The table `record` as JSON.
        """

@final
class Run:
    """
    A run of a scene with its results.
    """
    def directions(self, /) -> tuple[list[str], list[str]]:
        """
        Sentences for both directions of shaking, the worse one first, and warnings about both. The other direction runs in this call.
        """
    @property
    def duration(self, /) -> float:
        """
        Duration of the run [s].
        """
    def files(self, /, both: bool) -> dict[str, bytes]:
        """
        The files of a report by name. `both` puts both directions of shaking on its first page.
        """
    def history(self, /, name: str) -> Array:
        """
        A history by its name, with one row per floor or pair and one column per instant.
        """
    @property
    def interval(self, /) -> float:
        """
        Time between two instants of a history [s].
        """
    def notices(self, /) -> list[str]:
        """
        Warnings about the numbers, the most harmful first.
        """
    def sentence(self, /) -> str:
        """
        A sentence on how often and how hard floors touch.
        """
    def sketch(self, /) -> str:
        """
        The row as SVG, with floors that touch in orange.
        """
    def summary(self, /) -> str:
        """
        All results, as the JSON of `pounding run --json`.
        """
    def table(self, /, name: str) -> Table:
        """
        The table `peaks`, `pairs`, `links` or `impacts`.
        """
    def unusual(self, /) -> list[str]:
        """
        Implausible values of the scene and of its record, one sentence per kind.
        """

@final
class Table:
    """
    A table that does not change. Every reader of the Arrow PyCapsule interface takes it, for example `polars.DataFrame(table)`.
    """
    def __arrow_c_stream__(self, /, requested_schema: Any | None = None) -> Any:
        """
        The table as an Arrow stream with one batch; the requested schema is ignored.
        """
    def __eq__(self, other: object, /) -> bool: ...
    def __len__(self, /) -> int:
        """
        Number of rows.
        """
    def column(self, /, name: str) -> Any:
        """
        A column by its name: an `Array` of numbers, or a list of flags or texts.
        """
    @property
    def columns(self, /) -> list[str]:
        """
        Names of the columns.
        """

def advise(text: str, path: str | PathLike[str], error: SupportsFloat | SupportsIndex, quantity: str, record: Record | None = None, progress: Any | None = None) -> str:
    """
    The cheapest method and time step for an accuracy, as the JSON of `pounding advise --json`.
    """

def assess(text: str, path: str | PathLike[str], folder: str | PathLike[str], scale: str, target: str | None = None, stiffness: SupportsLenAndGetItem[SupportsFloat | SupportsIndex] | None = None, code: str | None = None, progress: Any | None = None) -> Assessment:
    """
    Assesses a row under a folder of records, in both directions, by the exact method. `scale` is `scene`, `none` or a `scale_to` table as
    JSON. `target` is the name or the file of a spectrum.
    """

def certify(law: str, restitution: SupportsFloat | SupportsIndex, masses: SupportsLenAndGetItem[SupportsFloat | SupportsIndex], speed: SupportsFloat | SupportsIndex, stiffness: SupportsFloat | SupportsIndex | None = None, literature: bool = False, time_step: SupportsFloat | SupportsIndex | None = None, method: str | None = None) -> str:
    """
    Restitution that a contact law and the methods deliver in a free impact, as the JSON of `pounding certify --json`.
    """

def check_scene(text: str, path: str | PathLike[str]) -> str:
    """
    Reads and checks a scene under any record. Returns its words with all defaults, as JSON.
    """

def effects(text: str, path: str | PathLike[str], record: Record | None = None) -> str:
    """
    Effects of pounding on every storey, in both directions of shaking, as JSON.
    """

def ida(text: str, path: str | PathLike[str], folders: SupportsGetItem[int, str | PathLike[str]], intensities: SupportsGetItem[int, SupportsFloat | SupportsIndex], im: str | None, states: SupportsGetItem[int, str], gaps: SupportsGetItem[int, SupportsFloat | SupportsIndex], hazard: str | None = None, both: bool = False, progress: Any | None = None) -> Ida:
    """
    Finds how often a row reaches states. `folders` has one folder, whose records are scaled to every one of `intensities` [g] by the measure
    `im`, or without `im` a folder for each of them. `hazard` is the text of a CSV table.
    """

def laws() -> list[tuple[str, str, str]]:
    """
    The contact laws, each with its name, its force and the unit of its stiffness.
    """

def opensees(text: str, path: str | PathLike[str], record: Record | None = None, time_step: SupportsFloat | SupportsIndex | None = None, approximate: bool = False) -> str:
    """
    The scene as a script for OpenSeesPy.
    """

def periods_between(first: SupportsFloat | SupportsIndex, last: SupportsFloat | SupportsIndex, count: SupportsIndex) -> list[float]:
    """
    Periods from `first` to `last` [s], rising by a constant ratio.
    """

def read_words(path: str | PathLike[str]) -> str:
    """
    The text of a JSON or TOML file, read within the bounds of the program.
    """

def required_gap(text: str, path: str | PathLike[str], folder: str | PathLike[str], progress: Any | None = None) -> tuple[Table, list[str]]:
    """
    The gaps that a row needs under a folder of records, in both directions, one row per motion, direction and gap. Returns also the
    implausible values, and the remarks on records that are left out or whose direction is unknown.
    """

def run(text: str, path: str | PathLike[str], record: Record | None = None, measure: bool = True, full: bool = False, force: bool = False) -> Run:
    """
    Runs a scene with its histories. `measure` also runs the exact method, for the errors.

    `text` is the scene as JSON or TOML, `path` its file, and `record` replaces the record that it names.
    """

def sketch_scene(text: str, path: str | PathLike[str]) -> str:
    """
    The row of a scene as SVG.
    """

def sweep(text: str, path: str | PathLike[str], progress: Any | None = None) -> tuple[Table, list[str]]:
    """
    Runs a sweep with all cores. `text` is the sweep as JSON or TOML; `path` is its file, whose folder other files are named from.

    Calls `progress` with the number of finished runs and the number of all runs. Returns the table, the records that were left out with
    their reasons, the remarks on records whose direction is unknown, and the implausible values.
    """

def visible(text: str) -> str:
    """
    Text for people, in which letters that steer a terminal or the direction of writing are spelt.
    """

def words_of(text: str, path: str | PathLike[str]) -> str:
    """
    Converts a JSON or TOML text to JSON without checking its contents.
    """

def write_files(folder: str | PathLike[str], files: dict[str, SupportsGetItem[int, SupportsIndex]], overwrite: bool, inputs: SupportsGetItem[int, str | PathLike[str]]) -> None:
    """
    Writes a report into a folder; the report is whole and on disk when the function returns. Results of an earlier run are replaced, except
    files that were read. Other files are refused or kept.
    """
