"""Rows of structures."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from . import _pounding
from ._errors import Refused
from ._progress import Progress, shown
from ._record import Record, read
from ._run import Run
from ._tables import frame
from ._structures import Law, for_each, law_of
from ._sweep import arrays_of, restitution_of, spread
from ._words import refused, table_of, to_json, visible, warn, words

if TYPE_CHECKING:
    import pandas

    from ._folder import Assessment

__all__ = ["Scene", "row", "scene"]

#: A record, or the path of one.
Shaking = Record | str | os.PathLike[str]


def record_of(given: Shaking) -> Record:
    """The record itself; a path is read."""
    return given if isinstance(given, Record) else read(given)


#: What shakes a row that names no record, until one is given.
_NOBODY = {"generated": {"half_sine": {"amplitude_m_per_s2": 0.0, "duration_s": 1.0, "time_step_s": 0.5}}}


def row(
    *structures: Mapping[str, Any],
    gap: float | Sequence[float] | None = None,
    restitution: float | None = None,
    law: Law | Sequence[Law] | None = None,
    levels: Sequence[int] | None = None,
    arrivals: Sequence[float] | None = None,
    method: str | Mapping[str, Any] | None = None,
    duration: float | None = None,
    name: str = "row",
) -> Scene:
    """A row of structures, from left to right.

    Parameters
    ----------
    *structures
        Of :func:`sdof`, :func:`building`, :func:`wall`, or dicts in the words of a file.
    gap
        Width of the gap at rest [m], ≥ 0: one for all, or one between each structure and its right neighbour. Without it they stand
        apart and never touch.
    restitution
        Coefficient of restitution [–], 0 to 1; 0.65 where neither it nor a law is given.
    law
        Contact law: a name, ``{"nonlinear_viscoelastic": {"impact_stiffness_n_per_m1_5": 2.75e9}}``, or one for each gap. Without it
        ``stereomechanical``, impulses that need a restitution alone. :func:`laws` lists all.
    levels
        Levels at which floors can touch, from 1; without it all that face each other.
    arrivals
        When the ground motion arrives at each structure [s].
    method
        ``"exact"`` where not given; ``{"accuracy": 0.01}`` finds a cheaper one, ``{"velocity_verlet": {"time_step_s": 1e-4}}`` names it.
    duration
        Duration of runs [s]; without it that of the record and two of the longest periods.
    name
        Name for tables and reports.

    Raises
    ------
    Refused
        Names the field, what stands there, what may, and what to do.
    """
    named = []
    for index, structure in enumerate(structures, 1):
        if not isinstance(structure, Mapping):
            found, allowed = type(structure).__name__, "structures one by one"
            message = f"structures[{index - 1}]: found {found}, allowed are {allowed}: row(sdof(…), building(…), gap=…)"
            raise Refused(message, f"structures[{index - 1}]", found, allowed)
        place = f"structures[{index - 1}]"
        if len(structure) != 1:
            raise refused(place, f"a dict of {len(structure)} entries", "is one with one", "make it with sdof(…), building(…) or wall()")
        kind, fields = next(iter(structure.items()))
        fields = table_of(fields, f"{place}.{kind}", '{"mass_kg": 1e5, "period_s": 1.0}')
        if kind != "wall":
            fields = {"name": f"structure {index}", **fields}
        named.append({kind: fields})
    given: dict[str, Any] = {"name": name, "structures": named}
    if gap is not None:
        n = max(len(named) - 1, 0)
        laws = [law_of(one, restitution) for one in for_each(law, n, "law")]
        gaps = for_each(gap, n, "gap")
        contacts = [{"gap_m": gap, "law": law} for gap, law in zip(gaps, laws)]
        if levels is not None:
            contacts = [{**contact, "levels": list(levels)} for contact in contacts]
        given["contacts"] = contacts
    if arrivals is not None:
        given["arrivals_s"] = list(arrivals)
    if method is not None:
        given["method"] = method
    if duration is not None:
        given["duration_s"] = duration
    return Scene(to_json({**given, "record": _NOBODY}), "scene.json", None, False)


def scene(source: str | os.PathLike[str] | Mapping[str, Any]) -> Scene:
    """A scene of a file, or of a dict in the words of a file.

    Parameters
    ----------
    source
        A TOML or JSON file, from whose folder its record is named; or a dict, whose record is named from here.
    """
    if isinstance(source, Mapping):
        own = "record" in source
        given = source if own else {**source, "record": _NOBODY}
        return Scene(to_json(given), "scene.json", None, own)
    path = os.fspath(source)
    return Scene(_pounding.read_words(Path(path)), path, None, True)


class Scene:
    """A row of structures, with what lies between neighbours, a method, and perhaps a record. It does not change.

    Made by :func:`row` or :func:`scene`.
    """

    __slots__ = ("_own", "_path", "_record", "_text")

    def __init__(self, text: str, path: str, record: Record | None, own: bool) -> None:
        self._text = text
        self._path = path
        self._record = record
        self._own = own
        _pounding.check_scene(text, Path(path))

    def to_dict(self) -> dict[str, Any]:
        """The scene in the words of a file; units stand in the names of the fields."""
        found: dict[str, Any] = json.loads(_pounding.words_of(self._text, Path(self._path)))
        if self._record is not None:
            found["record"] = self._record.words
        elif not self._own:
            del found["record"]
        return found

    @property
    def name(self) -> str:
        """Its name."""
        return str(self.to_dict()["name"])

    def replace(self, **fields: Any) -> Scene:
        """The same with other fields of a file, such as ``method="exact"``, ``duration_s=20.0`` or ``name="b"``; ``gap=0.05`` [m] is that of
        every contact.
        """
        changed = {**self.to_dict(), **fields}
        if "gap" in fields:
            contacts = changed.get("contacts", [])
            gaps = for_each(changed.pop("gap"), len(contacts), "gap")
            changed["contacts"] = [{**contact, "gap_m": gap} for contact, gap in zip(contacts, gaps)]
        own = self._own or "record" in fields
        record = None if "record" in fields else self._record
        if not own and record is None:
            changed["record"] = _NOBODY
        return Scene(to_json(changed), self._path, record, own)

    def under(self, record: Shaking) -> Scene:
        """The same with a record of its own."""
        record = record_of(record)
        return Scene(to_json({**self.to_dict(), "record": record.words}), self._path, record, True)

    def _given(self, record: Shaking | None) -> tuple[str, Path, _pounding.Record | None]:
        record = self._record if record is None else record_of(record)
        if record is not None:
            words_of_it = self.to_dict()
            return to_json({**words_of_it, "record": record.words}), Path(self._path), record._native
        if not self._own:
            message = "record: found none, allowed is one: run(record), or scene.under(record)"
            raise Refused(message, "record", "none", "one", "run(record), or scene.under(record)")
        return self._text, Path(self._path), None

    def run(
        self,
        record: Shaking | None = None,
        *,
        errors: bool = True,
        full: bool = False,
        force: bool = False,
    ) -> Run:
        """Runs the scene; the exact method where it names no other.

        Warnings of the run are warnings of Python, of the class :class:`PoundingWarning`. Ctrl-C stops it.

        Parameters
        ----------
        record
            What shakes it, a record or the path of one; without it the record of the scene.
        errors
            Of a method with steps, also run the exact one and say how far the numbers are from it.
        full
            Model what the scene does not require, too: the same numbers at more cost.
        force
            Take what is refused, with a warning.

        Raises
        ------
        Refused
            Names the place, what stands there, what may, and what to do.
        """
        shaken_by = None if record is None else record_of(record)
        text, path, native = self._given(shaken_by)
        options = {"errors": errors, "full": full, "force": force}
        run = Run(_pounding.run(text, path, native, errors, full, force), self, shaken_by, options)
        run._warn()
        return run

    def effects(self, record: Shaking | None = None) -> dict[str, Any]:
        """What pounding does to every storey against the same building alone, in both directions of shaking, by 24 exact runs.

        Units stand in the names.
        """
        text, path, native = self._given(record)
        found: dict[str, Any] = json.loads(_pounding.effects(text, path, native))
        return found

    def advise(
        self,
        error: float = 0.01,
        quantity: str = "all",
        *,
        record: Shaking | None = None,
        progress: Progress | bool = False,
    ) -> dict[str, Any]:
        """The cheapest method and time step for an accuracy.

        Parameters
        ----------
        error
            Largest relative error [–], more than 0 and less than 1.
        quantity
            Of what: ``momentum``, ``displacement``, ``acceleration``, ``force``, ``impulse``, ``time`` or ``all``.
        record
            What shakes it; without it the record of the scene.
        progress
            Called with the numbers of runs that are done, and of all; ``True`` shows a line.

        Returns
        -------
        dict
            What ``pounding advise --json`` prints; ``found["use"]["method"]`` is a method for :func:`row`.
        """
        text, path, native = self._given(record)
        found: dict[str, Any] = json.loads(
            _pounding.advise(text, path, error, quantity, native, shown(progress))
        )
        return found

    def assess(
        self,
        records: str | os.PathLike[str] | Iterable[Record],
        *,
        scale: str | Mapping[str, Any] = "scene",
        target: str | os.PathLike[str] | None = None,
        stiffness: tuple[float, float] = (0.1, 10.0),
        progress: Progress | bool = False,
    ) -> Assessment:
        """Says under many records whether the gaps are enough, and what touching does: both directions, exact method.

        What is unusual, what harms the answer, and what is said of records that are left out, are warnings of the class :class:`PoundingWarning`.

        Parameters
        ----------
        records
            A folder, or records of :func:`read`, :func:`record` or :func:`formula`.
        scale
            ``"scene"`` as the scene scales its own, ``"none"``, ``{"pga_g": 0.3}`` [g], or
            ``{"sa": {"period_s": 0.8, "damping_ratio": 0.05, "sa_g": 0.5}}``.
        target
            A spectrum to scale to: ``"ec8:a_g=0.25g,ground=C"``, ``"asce7:s_ds=1,s_d1=0.6,t_l=8"``, or a CSV file of periods [s] and
            accelerations [g].
        stiffness
            Range of the stiffness of impacts, as factors on that of the scene [–].
        progress
            Called with the numbers of runs that are done, and of all; ``True`` shows a line.
        """
        from ._folder import Assessment, folder_of

        scale = scale if isinstance(scale, str) else to_json(scale)
        spectrum = None if target is None else os.fspath(target)
        with folder_of(records) as folder:
            native = _pounding.assess(
                self._text, Path(self._path), folder, scale, spectrum, list(stiffness), shown(progress)
            )
        found = Assessment(native)
        for one in [*found.unusual, *found.warnings, *found.remarks]:
            warn(one, stacklevel=2)
        return found

    def required_gap(
        self,
        records: str | os.PathLike[str] | Iterable[Record],
        *,
        progress: Progress | bool = False,
    ) -> pandas.DataFrame:
        """Which gaps nothing closes, under every record in both directions, by the exact method.

        The gaps and laws of the scene do not matter. A row for each motion, direction and gap: its event, what is needed [m], when
        [s], the peaks of both neighbours alone [m], and what the rules of codes ask for [m]. What is unusual and records that are left out are warnings.

        Parameters
        ----------
        records
            A folder, or records of :func:`read`, :func:`record` or :func:`formula`.
        progress
            Called with the numbers of runs that are done, and of all; ``True`` shows a line.
        """
        from ._folder import folder_of

        with folder_of(records) as folder:
            table, said = _pounding.required_gap(self._text, Path(self._path), folder, shown(progress))
        for one in said:
            warn(one, stacklevel=2)
        return frame(table)

    def sweep(
        self,
        vary: Mapping[str, Any] | None = None,
        *,
        gap: ArrayLike | None = None,
        restitution: ArrayLike | None = None,
        record: Shaking | None = None,
        records: str | os.PathLike[str] | Iterable[Record] | None = None,
        directions: str | None = None,
        samples: Mapping[str, Any] | None = None,
        outputs: Mapping[str, Sequence[str]] | None = None,
        verdict: bool = True,
        summary: Mapping[str, Any] | None = None,
        budget: Mapping[str, Any] | None = None,
        progress: Progress | bool = False,
    ) -> pandas.DataFrame:
        """Runs the scene with all combinations of some values, with all cores; the last that varies is fastest.

        Parameters
        ----------
        vary
            Values of fields in the words of a file, such as ``{"structures[0].sdof.period_s": [0.5, 1.0]}``; a dict as a value is a spread
            of a sweep file, such as ``{"normal": {"mean": 1e5, "standard_deviation": 1e4}}``, with ``samples``.
        gap
            Values of every gap [m].
        restitution
            Values of every coefficient of restitution [–].
        record
            What shakes it, without ``records``; without both the record of the scene.
        records
            A folder of records, or records.
        directions
            ``"as_recorded"``, ``"reversed"`` or ``"both"``.
        samples
            ``{"count": 1024, "seed": 1, "method": "sobol"}``.
        outputs
            ``{"structures": ["peak_displacement_m"], "pairs": ["peak_force_n"]}``: which numbers.
        verdict
            Whether each run is held to the laws of mechanics.
        summary
            Sums the runs up instead of keeping a row of each: ``{"by": ["gap"], "exceedance": {"peak_force_n": [1e7]}}``, or ``{}`` for the
            default statistics over all runs. ``by`` names columns, those of ``gap`` and ``restitution`` by these words.
        budget
            What every run may cost.
        progress
            Called with the numbers of runs that are done, and of all; ``True`` shows a line.

        Returns
        -------
        pandas.DataFrame
            A row for each run, with the reason in the last column where it failed; with ``summary`` a row for each statistic. SI units in the
            names.
        """
        return frame(
            self.sweep_table(
                vary,
                gap=gap,
                restitution=restitution,
                record=record,
                records=records,
                directions=directions,
                samples=samples,
                outputs=outputs,
                verdict=verdict,
                summary=summary,
                budget=budget,
                progress=progress,
            )
        )

    def sweep_table(
        self,
        vary: Mapping[str, Any] | None = None,
        *,
        gap: ArrayLike | None = None,
        restitution: ArrayLike | None = None,
        record: Shaking | None = None,
        records: str | os.PathLike[str] | Iterable[Record] | None = None,
        directions: str | None = None,
        samples: Mapping[str, Any] | None = None,
        outputs: Mapping[str, Sequence[str]] | None = None,
        verdict: bool = True,
        summary: Mapping[str, Any] | None = None,
        budget: Mapping[str, Any] | None = None,
        progress: Progress | bool = False,
    ) -> _pounding.Table:
        """The same as :meth:`sweep`, as an Arrow table."""
        from ._folder import folder_of

        if record is not None and records is not None:
            raise Refused("record: found one beside records, allowed is one of the two", "record", "records", "one of the two")
        record = None if record is None else record_of(record)
        scene, base = self._for_sweep(record, records is not None)
        fields = dict(table_of(vary or {}, "vary", '{"structures[0].sdof.period_s": [0.5, 1.0]}'))
        named = {"gap": "contacts[*].gap_m"}
        if gap is not None:
            fields[named["gap"]] = gap
        if restitution is not None:
            named["restitution"] = restitution_of(scene)
            fields[named["restitution"]] = restitution
        if summary is not None:
            summary = table_of(summary, "summary", '{"by": ["gap"]}, or {}')
            by = summary.get("by")
            if isinstance(by, (list, tuple)):
                summary = {**summary, "by": [named.get(field, field) if isinstance(field, str) else field for field in by]}
        given: dict[str, Any] = {
            "scene": scene,
            "vary": [spread(field, values) for field, values in fields.items()],
            "verdict": verdict,
            **words(
                {
                    "directions": directions,
                    "samples": samples,
                    "outputs": outputs,
                    "summary": summary,
                    "budget": budget,
                },
                {},
            ),
        }
        with contextlib.ExitStack() as stack:
            if records is not None:
                folder = stack.enter_context(folder_of(records))
                given["records"] = str(folder.resolve())
            elif arrays := arrays_of(record or self._record):
                (only,) = stack.enter_context(folder_of(arrays)).iterdir()
                scene["record"] = {"file": str(only)}
            native, remarks = _pounding.sweep(to_json(given), base, shown(progress))
        for one in remarks:
            warn(one, stacklevel=3)
        return native

    def _for_sweep(self, record: Record | None, replaced: bool) -> tuple[dict[str, Any], Path]:
        """The words of the scene with its record, and the file from whose folder they are named."""
        scene = self.to_dict()
        base = Path(self._path).resolve()
        if record is not None:
            scene["record"] = record.words
            base = Path.cwd() / "sweep.json"
        elif not self._own:
            if not replaced:
                self._given(None)
            scene["record"] = _NOBODY
        return scene, base.with_name("sweep.json")

    def to_opensees(
        self,
        record: Record | None = None,
        *,
        time_step: float | None = None,
        approximate: bool = False,
    ) -> str:
        """The scene as a script for OpenSeesPy, with the numbers of the exact method beside it.

        Parameters
        ----------
        record
            What shakes it; without it the record of the scene.
        time_step
            Time step of OpenSees [s]; without it a fine one.
        approximate
            Take a material that pulls for Kelvin–Voigt contacts.
        """
        text, path, native = self._given(record)
        return _pounding.opensees(text, path, native, time_step, approximate)

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Scene)
            and self.to_dict() == other.to_dict()
            and self._record == other._record
        )

    def __hash__(self) -> int:
        return hash(json.dumps(self.to_dict(), sort_keys=True))

    def __reduce__(self) -> tuple[Any, ...]:
        return Scene, (self._text, self._path, self._record, self._own)

    def __repr__(self) -> str:
        words_of_it = self.to_dict()
        names = [
            fields["name"] if kind != "wall" else "wall"
            for structure in words_of_it["structures"]
            for kind, fields in ([(structure, {})] if isinstance(structure, str) else structure.items())
        ]
        gaps = [contact["gap_m"] for contact in words_of_it.get("contacts", [])]
        between = f", gaps {', '.join(f'{gap:g}' for gap in gaps)} m" if gaps else ", apart"
        return visible(f"Scene {words_of_it['name']!r}: {' – '.join(names)}{between}")

    def _repr_html_(self) -> str:
        from html import escape

        return f"<p>{escape(repr(self))}</p>{_pounding.sketch_scene(self._text, Path(self._path))}"
