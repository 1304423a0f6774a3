"""
Functions and classes below the package `pounding`.
"""

from _typeshed import SupportsGetItem, SupportsLenAndGetItem
from os import PathLike
from pathlib import Path
from typing import Any, SupportsFloat, SupportsIndex, final

__all__ = ["Array", "Assessment", "Record", "Run", "Table", "advise", "assess", "certify", "check_scene", "effects", "laws", "opensees", "periods_between", "read_words", "required_gap", "run", "sketch_scene", "sweep", "visible", "words_of", "write_files"]

@final
class Array:
    """
    Numbers that do not change: `numpy.asarray` gives a view of them, which may only be read.
    """
    @property
    def __array_interface__(self, /) -> Any:
        """
        Address, type and shape, as NumPy asks for them; the memory lives as long as this object.
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
        The table of `pounding assess --csv`, a row for each number.
        """
    def facts(self, /) -> str:
        """
        Everything, as the JSON of `pounding assess --json`.
        """
    def files(self, /) -> dict[str, bytes]:
        """
        The files of a report, by name.
        """
    def remarks(self, /) -> list[str]:
        """
        What is said of records that are left out, or whose direction nothing tells.
        """
    def sentences(self, /) -> list[str]:
        """
        The answer in full: the gaps, what is proposed, what touching does.
        """
    def shaking(self, /) -> list[str]:
        """
        The motions in a few lines.
        """
    def unusual(self, /) -> list[str]:
        """
        What looks wrong in the scene and in its records.
        """
    def warnings(self, /) -> list[str]:
        """
        What to know before believing them.
        """

@final
class Record:
    """
    A ground motion: where it comes from, and how it is used, in the words of the table `record` of a scene.
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
        What was read and where, measures, unit and format, as JSON.
        """
    @property
    def kind(self, /) -> str:
        """
        `file`, `samples` or `formula`.
        """
    @staticmethod
    def of_file(path: str | PathLike[str], words: str, raw: bytes | None = None) -> Record:
        """
        Reads a file; `raw` is what it holds, where it need not be opened. `words` is the table `record` as JSON.
        """
    @staticmethod
    def of_formula(words: str) -> Record:
        """
        Makes a motion from the formula that `words` name.
        """
    @staticmethod
    def of_samples(samples: bytes, time_step: SupportsFloat | SupportsIndex, words: str) -> Record:
        """
        Takes samples in m/s², as the bytes of numbers of 64 bits, `time_step` s apart.
        """
    @property
    def path(self, /) -> Path | None:
        """
        The file; `None` of another kind.
        """
    @property
    def raw(self, /) -> bytes:
        """
        The bytes of the file, or of the samples as they were given; empty of a formula.
        """
    @property
    def raw_time_step(self, /) -> float | None:
        """
        Time between the samples that were given [s]; `None` of another kind than `samples`.
        """
    @property
    def scale_factor(self, /) -> float:
        """
        What its source was multiplied by [–].
        """
    def spectrum(self, /, periods: SupportsGetItem[int, SupportsFloat | SupportsIndex], damping_ratios: SupportsGetItem[int, SupportsFloat | SupportsIndex]) -> Table:
        """
        Response spectra at some periods [s], for some damping ratios [–]: a row for each of both.
        """
    @property
    def time_step(self, /) -> float:
        """
        Time between two samples as used [s].
        """
    def used(self, /, words: str) -> Record:
        """
        The same motion, used in another way.
        """
    @property
    def words(self, /) -> str:
        """
        The table `record` as JSON.
        """

@final
class Run:
    """
    What a run of a scene leaves behind.
    """
    def directions(self, /) -> tuple[list[str], list[str]]:
        """
        The same of both directions of shaking, the worse one first, and what to know of both; the other direction runs now.
        """
    @property
    def duration(self, /) -> float:
        """
        Duration of the run [s].
        """
    def files(self, /, both: bool) -> dict[str, bytes]:
        """
        The files of a report, by name; with both directions of shaking on its first page where `both` is set.
        """
    def history(self, /, name: str) -> Array:
        """
        A history by its name: a row for each floor or pair, a column for each instant.
        """
    @property
    def interval(self, /) -> float:
        """
        Time between two instants of the histories [s].
        """
    def notices(self, /) -> list[str]:
        """
        What to know before believing the numbers, the most harmful first.
        """
    def sentence(self, /) -> str:
        """
        How often floors touch and how hard, in a sentence.
        """
    def sketch(self, /) -> str:
        """
        The row as SVG, floors that touch in orange.
        """
    def summary(self, /) -> str:
        """
        Everything that came out, as the JSON that `pounding run --json` prints.
        """
    def table(self, /, name: str) -> Table:
        """
        The table `peaks`, `pairs` or `impacts`.
        """
    def unusual(self, /) -> list[str]:
        """
        What looks wrong in the scene and in its record, a sentence for each kind.
        """

@final
class Table:
    """
    A table that does not change; every reader of the Arrow PyCapsule interface takes it, such as `polars.DataFrame(table)`.
    """
    def __arrow_c_stream__(self, /, requested_schema: Any | None = None) -> Any:
        """
        The table as a stream of Arrow with one batch, whatever schema is asked for.
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

def assess(text: str, path: str | PathLike[str], folder: str | PathLike[str], scale: str, target: str | None = None, stiffness: SupportsLenAndGetItem[SupportsFloat | SupportsIndex] = ..., progress: Any | None = None) -> Assessment:
    """
    Assesses a row under a folder of records, in both directions, by the exact method; `scale` is `scene`, `none` or the table `scale_to` of a
    record as JSON, `target` a spectrum by its name or file.
    """

def certify(law: str, restitution: SupportsFloat | SupportsIndex, masses: SupportsLenAndGetItem[SupportsFloat | SupportsIndex], speed: SupportsFloat | SupportsIndex, stiffness: SupportsFloat | SupportsIndex | None = None, literature: bool = False, time_step: SupportsFloat | SupportsIndex | None = None, method: str | None = None) -> str:
    """
    What a contact law and methods deliver to a free impact, as the JSON of `pounding certify --json`.
    """

def check_scene(text: str, path: str | PathLike[str]) -> str:
    """
    Reads and checks a scene, whatever shakes it; returns its words with all defaults, as JSON.
    """

def effects(text: str, path: str | PathLike[str], record: Record | None = None) -> str:
    """
    What pounding does to every storey, in both directions of shaking, as JSON.
    """

def laws() -> list[tuple[str, str, str]]:
    """
    The contact laws: name, force, and unit of the stiffness, of each.
    """

def opensees(text: str, path: str | PathLike[str], record: Record | None = None, time_step: SupportsFloat | SupportsIndex | None = None, approximate: bool = False) -> str:
    """
    The scene as a script for OpenSeesPy.
    """

def periods_between(first: SupportsFloat | SupportsIndex, last: SupportsFloat | SupportsIndex, count: SupportsIndex) -> list[float]:
    """
    Periods from one to another [s], in equal ratios.
    """

def read_words(path: str | PathLike[str]) -> str:
    """
    The text of a JSON or TOML file, read within the bounds of the program.
    """

def required_gap(text: str, path: str | PathLike[str], folder: str | PathLike[str], progress: Any | None = None) -> tuple[Table, list[str]]:
    """
    Which gaps a row needs under a folder of records, in both directions: a row for each motion, direction and gap; and what looks wrong,
    and what is said of records that are left out, or whose direction nothing tells.
    """

def run(text: str, path: str | PathLike[str], record: Record | None = None, measure: bool = True, full: bool = False, force: bool = False) -> Run:
    """
    Runs a scene, with its histories; `measure` also runs the exact method and compares.

    `text` is the scene as JSON or TOML, `path` its file, `record` shakes it in place of the record that it names.
    """

def sketch_scene(text: str, path: str | PathLike[str]) -> str:
    """
    The row of a scene as SVG.
    """

def sweep(text: str, path: str | PathLike[str], progress: Any | None = None) -> tuple[Table, list[str]]:
    """
    Runs a sweep, in the words of its file as JSON or TOML, with all cores; `path` is its file, from whose folder others are named.

    `progress` is called with the number of runs that are done, and of all. Returns the table, the records that were left out with their
    reasons, what is said of those whose direction nothing tells, and what looks wrong.
    """

def visible(text: str) -> str:
    """
    Text for people: letters that steer a terminal, or the direction of writing, are spelt.
    """

def words_of(text: str, path: str | PathLike[str]) -> str:
    """
    The words of a JSON or TOML file as JSON, whatever they say.
    """

def write_files(folder: str | PathLike[str], files: dict[str, SupportsGetItem[int, SupportsIndex]], overwrite: bool, inputs: SupportsGetItem[int, str | PathLike[str]]) -> None:
    """
    Writes a report into a folder: whole and on disk when this returns. One that holds other things is refused, or they stay; results of an
    earlier run are replaced, but for files that were read.
    """
