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
from ._tables import effect_row, frame
from ._structures import Law, for_each, law_of
from ._sweep import arrays_of, restitution_of, spread
from ._words import AT_REST, present, refused, table_of, to_json, visible, warn, words

if TYPE_CHECKING:
    import pandas

    from ._folder import Assessment, Ida

__all__ = ["Scene", "row", "scene"]

#: A record, or the path of one.
Shaking = Record | str | os.PathLike[str]


def record_of(given: Shaking) -> Record:
    """The given record, or the record read from a path."""
    return given if isinstance(given, Record) else read(given)


def row(
    *structures: Mapping[str, Any],
    gap: float | Sequence[float] | None = None,
    restitution: float | None = None,
    law: Law | Sequence[Law] | None = None,
    levels: Sequence[int] | None = None,
    heights: Sequence[float] | None = None,
    column_shape: str | None = None,
    seat_width: float | Sequence[float] | None = None,
    links: Sequence[Mapping[str, Any]] | None = None,
    p_delta: str | None = None,
    collapse_drift_ratio: float | None = None,
    floors: str | None = None,
    property: str | Sequence[str] | None = None,
    arrivals: Sequence[float] | None = None,
    method: str | Mapping[str, Any] | None = None,
    duration: float | None = None,
    name: str = "row",
) -> Scene:
    """Makes a row of structures, from left to right.

    Parameters
    ----------
    *structures
        Results of :func:`sdof`, :func:`building` and :func:`wall`, or dicts in the words of a file.
    gap
        Width of the gap at rest [m], ≥ 0: one for all, or one between each structure and its right neighbour. By default the
        structures never touch.
    restitution
        Coefficient of restitution [–], 0 to 1. Without a law it makes touches impulses.
    law
        Contact law, or one for each gap: a table such as ``{"kelvin_voigt": {"impact_stiffness_n_per_m": 2.25e9}}``, or a name such as
        ``"stereomechanical"``, whose impulses need only a restitution. Without law and restitution, contact is that of ``pounding init``:
        ``nonlinear_viscoelastic`` with 2.75e9 N/m^1.5 and 0.65. :func:`laws` lists all.
    levels
        Levels at which floors can touch, from 1, and no columns; by default slabs meet what stands at their height.
    heights
        Heights at which slabs can touch floors and columns [m]; by default all.
    column_shape
        ``"fixed"``, the default, or ``"straight"``: shape of columns where slabs hit them.
    seat_width
        Width of the seat of the right floor on the left one [m]: one for all gaps, or one for each.
    links
        Springs, dampers and restrainers between floors, as dicts in the words of a file: ``{"between": [{"structure": 1}, {"structure": 2}],
        "law": {"dashpot": {"damping_n_s_per_m": 1e6}}}``.
    p_delta
        ``"from_masses"``: the weight of the masses acts on leaning storeys; heights are needed.
    collapse_drift_ratio
        Drift over the height of a storey at which it counts as collapsed under gravity, which ends the run; 0.2 by default.
    floors
        ``"level"`` if storeys of one number are at one height. Needed where a building of several storeys faces another structure and
        heights are not given.
    property
        ``"same"`` or ``"other"``, the default: owners of the ground on both sides of a gap, for rules of codes; one for all, or one for
        each gap.
    arrivals
        Time at which the ground motion arrives at each structure [s].
    method
        The default is ``"exact"``. ``{"accuracy": 0.01}`` finds a cheaper one, ``{"velocity_verlet": {"time_step_s": 1e-4}}`` names one.
    duration
        Duration of runs [s]; by default that of the record plus two of the longest periods.
    name
        Name for tables and reports.

    Raises
    ------
    Refused
        With the field, the value found, the values allowed, and the remedy.
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
        if heights is not None:
            contacts = [{**contact, "heights_m": list(heights)} for contact in contacts]
        if column_shape is not None:
            contacts = [{**contact, "column_shape": column_shape} for contact in contacts]
        if seat_width is not None:
            contacts = [{**contact, "seat_width_m": own} for contact, own in zip(contacts, for_each(seat_width, n, "seat_width"))]
        if property is not None:
            contacts = [{**contact, "property": own} for contact, own in zip(contacts, for_each(property, n, "property"))]
        given["contacts"] = contacts
    if links is not None:
        given["links"] = list(links)
    if floors is not None:
        given["floors"] = floors
    if p_delta is not None:
        given["p_delta"] = p_delta
    if collapse_drift_ratio is not None:
        given["collapse_drift_ratio"] = collapse_drift_ratio
    if arrivals is not None:
        given["arrivals_s"] = list(arrivals)
    if method is not None:
        given["method"] = method
    if duration is not None:
        given["duration_s"] = duration
    return Scene(to_json({**given, "record": AT_REST}), "scene.json", None, False)


def scene(source: str | os.PathLike[str] | Mapping[str, Any]) -> Scene:
    """Makes a scene from a file, or from a dict in the words of a file.

    Parameters
    ----------
    source
        A TOML or JSON file, whose record is relative to its folder; or a dict, whose record is relative to the current folder.
    """
    if isinstance(source, Mapping):
        own = "record" in source
        given = source if own else {**source, "record": AT_REST}
        return Scene(to_json(given), "scene.json", None, own)
    path = os.fspath(source)
    return Scene(_pounding.read_words(Path(path)), path, None, True)


class Scene:
    """A row of structures with contacts, a method, and perhaps a record. It does not change.

    :func:`row` and :func:`scene` make it.
    """

    __slots__ = ("_own", "_path", "_record", "_text")

    def __init__(self, text: str, path: str, record: Record | None, own: bool) -> None:
        self._text = text
        self._path = path
        self._record = record
        self._own = own
        _pounding.check_scene(text, Path(path))

    def to_dict(self) -> dict[str, Any]:
        """The scene in the words of a file; names of fields end with units."""
        found: dict[str, Any] = json.loads(_pounding.words_of(self._text, Path(self._path)))
        if self._record is not None:
            found["record"] = self._record.words
        elif not self._own:
            del found["record"]
        return found

    @property
    def name(self) -> str:
        """Name of the scene."""
        return str(self.to_dict()["name"])

    def replace(self, **fields: Any) -> Scene:
        """The scene with other fields of a file, such as ``method="exact"``, ``duration_s=20.0`` or ``name="b"``. ``gap=0.05`` [m] sets
        every gap.
        """
        changed = {**self.to_dict(), **fields}
        if "gap" in fields:
            contacts = changed.get("contacts", [])
            gaps = for_each(changed.pop("gap"), len(contacts), "gap")
            changed["contacts"] = [{**contact, "gap_m": gap} for contact, gap in zip(contacts, gaps)]
        own = self._own or "record" in fields
        record = None if "record" in fields else self._record
        if not own and record is None:
            changed["record"] = AT_REST
        return Scene(to_json(changed), self._path, record, own)

    def under(self, record: Shaking) -> Scene:
        """The scene with another record."""
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
        """Runs the scene, by the exact method unless it names another one.

        Warnings of the run become Python warnings of the class :class:`PoundingWarning`. Ctrl-C stops the run.

        Parameters
        ----------
        record
            A record or its path; by default the record of the scene.
        errors
            For a method with a time step: run the exact method too and measure the errors.
        full
            Model features that the scene does not need, too: equal numbers at more cost.
        force
            Run with a warning instead of refusing.

        Raises
        ------
        Refused
            With the place, the value found, the values allowed, and the remedy.
        """
        shaken_by = None if record is None else record_of(record)
        text, path, native = self._given(shaken_by)
        options = {"errors": errors, "full": full, "force": force}
        run = Run(_pounding.run(text, path, native, errors, full, force), self, shaken_by, options)
        run._warn()
        return run

    def effects(self, record: Shaking | None = None) -> pandas.DataFrame:
        """Effects of pounding on every storey, against the building without neighbours, in both directions of shaking, by 24 exact runs.

        The table has one row per direction and floor: its responses alone and beside the neighbours, and how many times larger they
        become. ``…_low`` and ``…_high`` are the least and the largest value when the record is made one per cent weaker, stronger, faster
        or slower. Names of columns end with SI units.
        """
        import pandas

        text, path, native = self._given(record)
        found: dict[str, Any] = json.loads(_pounding.effects(text, path, native))
        made_of = [one for one in self.to_dict()["structures"] if isinstance(one, dict)]
        buildings = [one["building"]["name"] for one in made_of if "building" in one]
        both = [(key == "reversed", one) for key in ("as_given", "reversed") for one in found[key]]
        return pandas.DataFrame([effect_row(one, is_reversed, buildings) for is_reversed, one in both])

    def advise(
        self,
        accuracy: float = 0.01,
        quantity: str = "all",
        *,
        record: Shaking | None = None,
        progress: Progress | bool = False,
    ) -> dict[str, Any]:
        """The cheapest method and time step for an accuracy.

        Parameters
        ----------
        accuracy
            Largest relative error [–], more than 0 and less than 1.
        quantity
            Quantities whose error counts: ``momentum``, ``displacement``, ``acceleration``, ``force``, ``impulse``, ``time`` or ``all``.
        record
            The record; by default that of the scene.
        progress
            Called with the number of finished runs and the number of all runs; ``True`` shows a line.

        Returns
        -------
        dict
            The numbers of ``pounding advise --json``; ``found["use"]["method"]`` is a method for :func:`row`.
        """
        text, path, native = self._given(record)
        found: dict[str, Any] = json.loads(
            _pounding.advise(text, path, accuracy, quantity, native, shown(progress))
        )
        return found

    def assess(
        self,
        records: str | os.PathLike[str] | Iterable[Record],
        *,
        scale: str | Mapping[str, Any] = "scene",
        target: str | os.PathLike[str] | None = None,
        stiffness: tuple[float, float] | None = None,
        code: str | None = None,
        progress: Progress | bool = False,
    ) -> Assessment:
        """Tests whether the gaps are enough under many records, and the effects of touching: both directions, exact method.

        Implausible values, warnings, and remarks on records that are left out become Python warnings of the class :class:`PoundingWarning`.

        Parameters
        ----------
        records
            A folder, or records from :func:`read`, :func:`record` or :func:`formula`.
        scale
            ``"scene"`` for the scaling of the scene's own record, ``"none"``, ``{"pga_g": 0.3}`` [g], or
            ``{"sa": {"period_s": 0.8, "damping_ratio": 0.05, "sa_g": 0.5}}``.
        target
            A spectrum to scale to: ``"ec8:a_g=0.25g,ground=C"``, ``"asce7:s_ds=1,s_d1=0.6,t_l=8"``, or a CSV file of periods [s] and
            accelerations [g]. If the mean spectrum of the records has less than 90 % of it somewhere, all are made stronger by one factor
            until it has; a warning gives the factor.
        stiffness
            Range of the impact stiffness, as factors on that of the scene [–]; by default from 0.1 to the stiffness of two slabs.
        code
            Code whose gap is told in a sentence: ``"en-1998-1"``, ``"asce-7-16"``, ``"ntc-2018"``, ``"tbdy-2018"``, ``"e-030"`` or
            ``"gb-50011"``; by default that of the target.
        progress
            Called with the number of finished runs and the number of all runs; ``True`` shows a line.
        """
        from ._folder import Assessment, folder_of

        scale = scale if isinstance(scale, str) else to_json(scale)
        spectrum = None if target is None else os.fspath(target)
        if isinstance(target, os.PathLike) or (spectrum or "").lower().endswith(".csv"):
            present(Path(str(spectrum)))
        with folder_of(records) as folder:
            native = _pounding.assess(
                self._text, Path(self._path), folder, scale, spectrum, None if stiffness is None else list(stiffness), code, shown(progress)
            )
        found = Assessment(native)
        for one in [*found.unusual, *found.warnings, *found.remarks]:
            warn(one, stacklevel=2)
        return found

    def ida(
        self,
        records: str | os.PathLike[str] | Iterable[Record] | Mapping[float, str | os.PathLike[str]],
        *,
        im: str | None = None,
        stripes: Sequence[float] | None = None,
        states: str | Sequence[str] = "touch",
        gaps: Sequence[float] = (),
        hazard: str | os.PathLike[str] | Iterable[Sequence[float]] | None = None,
        both: bool = False,
        progress: Progress | bool = False,
    ) -> Ida:
        """Finds how often the row is pounded, drifts or is pushed too far, as ``pounding ida`` does.

        Warnings become Python warnings of the class :class:`PoundingWarning`, also the reason if there is no fragility.

        Parameters
        ----------
        records
            A folder or records, each of which is scaled to every intensity, or for each intensity [g] a folder of records as strong as in
            their files.
        im
            How the intensity of records is measured: ``"pga"``, ``"sa(0.8)"``, ``"sa_avg(0.2..2)"``, or ``"T1"``, the spectral acceleration
            at the longest first period of the row. Required with a hazard curve, else by default ``"T1"``.
        stripes
            Intensities [g]; by default 16 from 0.05 to 2 in equal ratios.
        states
            What is counted: ``"touch"``, ``"touch=2"`` (the second gap), ``"drift=0.01"``, ``"force=5e6"`` [N], ``"shear=5e6"`` [N],
            ``"collapse"``.
        gaps
            Widths of all gaps [m] for which touching is told, too.
        hazard
            Hazard curve of the site for the measure of ``im``: a CSV file, or pairs of intensity [g] and mean annual frequency [1/year].
        both
            Whether every record shakes in both directions.
        progress
            Called with the number of finished runs and the number of all runs; ``True`` shows a line.
        """
        from ._folder import Ida, folder_of

        with contextlib.ExitStack() as opened:
            if isinstance(records, Mapping):
                if im is not None or stripes is not None:
                    raise refused("records", "folders for intensities, with im or stripes", "are folders for intensities alone")
                intensities = [float(one) for one in records]
                folders = [present(Path(os.fspath(one))) for one in records.values()]
            else:
                if im is None and hazard is not None:
                    raise refused("im", "nothing", 'is the measure of the hazard curve, such as "sa(0.8)"')
                im = im or "T1"
                intensities = list(_pounding.periods_between(0.05, 2.0, 16) if stripes is None else stripes)
                folders = [opened.enter_context(folder_of(records))]
            if isinstance(hazard, (str, os.PathLike)):
                curve: str | None = present(Path(os.fspath(hazard))).read_text(encoding="utf-8")
            else:
                curve = None if hazard is None else "".join(f"{float(x)!r},{float(y)!r}\n" for x, y in hazard)
            named = [states] if isinstance(states, str) else list(states)
            native = _pounding.ida(
                self._text, Path(self._path), folders, intensities, im, named, list(gaps), curve, both, shown(progress)
            )
        found = Ida(native)
        for one in found.warnings:
            warn(one, stacklevel=2)
        return found

    def required_gap(
        self,
        records: str | os.PathLike[str] | Iterable[Record],
        *,
        progress: Progress | bool = False,
    ) -> pandas.DataFrame:
        """Gaps that never close, under every record in both directions, by the exact method.

        The gaps and laws of the scene are ignored. The table has one row per motion, direction and gap: its event, the required
        width [m], the time of the largest closing [s], the peaks of both neighbours alone [m], and the widths by all design rules [m];
        a rule of heights is empty unless the scene gives them.
        Implausible values and records that are left out become Python warnings.

        Parameters
        ----------
        records
            A folder, or records from :func:`read`, :func:`record` or :func:`formula`.
        progress
            Called with the number of finished runs and the number of all runs; ``True`` shows a line.
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
        """Runs the scene with all combinations of some values, on all cores; the last field varies fastest.

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
            The record, instead of ``records``; by default that of the scene.
        records
            A folder of records, or records.
        directions
            ``"as_given"``, ``"reversed"`` or ``"both"``.
        samples
            ``{"count": 1024, "seed": 1, "method": "sobol"}``.
        outputs
            Numbers in the table: ``{"structures": ["peak_displacement_m"], "pairs": ["peak_force_n"]}``.
        verdict
            Whether each run is checked against the laws of mechanics.
        summary
            Summarises the runs instead of keeping one row per run: ``{"by": ["gap"], "exceedance": {"peak_force_n": [1e7]}}``, or ``{}`` for the
            default statistics over all runs. ``by`` names columns; ``gap`` and ``restitution`` are allowed names.
        budget
            Budget of every run, as in a file.
        progress
            Called with the number of finished runs and the number of all runs; ``True`` shows a line.

        Returns
        -------
        pandas.DataFrame
            One row per run, with the reason in the last column if it failed; with ``summary`` one row per statistic. Names of columns end
            with SI units.
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
        """Runs a sweep as :meth:`sweep` does; returns an Arrow table."""
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
        """The words of the scene with its record, and the path whose folder file names are relative to."""
        scene = self.to_dict()
        base = Path(self._path).resolve()
        if record is not None:
            scene["record"] = record.words
            base = Path.cwd() / "sweep.json"
        elif not self._own:
            if not replaced:
                self._given(None)
            scene["record"] = AT_REST
        return scene, base.with_name("sweep.json")

    def to_opensees(
        self,
        record: Record | None = None,
        *,
        time_step: float | None = None,
        approximate: bool = False,
    ) -> str:
        """The scene as a script for OpenSeesPy, which also lists the numbers of the exact method.

        Parameters
        ----------
        record
            The record; by default that of the scene.
        time_step
            Time step of OpenSees [s]; by default a fine one.
        approximate
            Allow a material that can pull for Kelvin–Voigt contacts.
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
