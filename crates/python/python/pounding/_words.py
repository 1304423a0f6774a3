"""Conversion of Python keywords to the words of a file."""

from __future__ import annotations

import json
import os
import re
import sys
import warnings
from collections.abc import Mapping
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _pounding
from ._errors import PoundingWarning, Refused

#: Keywords of a structure whose fields in a file have other names.
STRUCTURE = {
    "mass": "mass_kg",
    "stiffness": "stiffness_n_per_m",
    "period": "period_s",
    "height": "height_m",
    "yield_force": "yield_force_n",
    "yield_displacement": "yield_displacement_m",
    "shear_capacity": "shear_capacity_n",
    "column_capacity": "column_capacity_n",
    "gravity_load": "gravity_load_n",
    "isolator_damping": "isolator_damping_n_s_per_m",
    "displacement_capacity": "displacement_capacity_m",
    "slab_depth": "slab_depth_m",
    "initial_displacement": "initial_displacement_m",
    "initial_velocity": "initial_velocity_m_per_s",
}

#: Keywords of a record.
RECORD = {
    "time_step": "time_step_s",
    "gravity": "gravity_m_per_s2",
    "resample": "resample_s",
}

#: Keywords of a formula.
FORMULA = {
    "amplitude": "amplitude_m_per_s2",
    "frequency": "frequency_hz",
    "phase": "phase_rad",
    "duration": "duration_s",
    "time_step": "time_step_s",
    "pga": "pga_m_per_s2",
    "strong_from": "strong_from_s",
    "strong_until": "strong_until_s",
    "decay": "decay_per_s",
    "cutoff": "cutoff_hz",
}

#: The record of a row without one: a ground at rest.
AT_REST = {"generated": {"half_sine": {"amplitude_m_per_s2": 0.0, "duration_s": 1.0, "time_step_s": 0.5}}}


def words(keywords: Mapping[str, Any], fields: Mapping[str, str]) -> dict[str, Any]:
    """The keywords with a value, under their names in a file."""
    given = {key: value for key, value in keywords.items() if value is not None}
    return {fields.get(key, key): value for key, value in given.items()}


def _plain(value: object) -> object:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(f"found {value!r}, allowed are numbers, texts, lists and dicts")


def refused(place: str | None, found: str, allowed: str, help: str | None = None) -> Refused:
    """A refusal in the words of the program."""
    begin = f"{place}: " if place else ""
    end = f"; {help}" if help else ""
    own = allowed.removeprefix("is ").removeprefix("are ")
    return Refused(f"{begin}found {found}, allowed {allowed}{end}", place, found, own, help)


def visible(text: str) -> str:
    """Text for people, in which letters that steer a terminal or the direction of writing are spelt."""
    return _pounding.visible(text)


def warn(text: str, stacklevel: int) -> None:
    """Warns the caller that is ``stacklevel`` calls above this function.

    Warnings of one line of code that differ in their numbers alone, as those of the runs of a loop, are shown once.
    """
    text = visible(text)
    caller = sys._getframe(stacklevel)
    kind = re.sub(r"\d+(\.\d+)?", "#", text)
    place = ("pounding", caller.f_code.co_filename, caller.f_lineno)
    # Python empties this registry if filters change, and IPython before a cell runs. An equal text is left to Python.
    shown = caller.f_globals.get("__warningregistry__", {}).get(place, {})
    if shown.get(kind, text) != text and _once(text, caller):
        return
    warnings.warn(text, PoundingWarning, stacklevel=stacklevel + 1)
    caller.f_globals.setdefault("__warningregistry__", {}).setdefault(place, {}).setdefault(kind, text)


def _once(text: str, caller: FrameType) -> bool:
    """Whether the filters show equal warnings of a line of code once."""
    module = str(caller.f_globals.get("__name__", ""))
    for action, message, category, of_module, line in warnings.filters:
        says = message is None or re.match(message, text)
        is_there = (of_module is None or re.match(of_module, module)) and line in (0, caller.f_lineno)
        if issubclass(PoundingWarning, category) and says and is_there:
            return action in ("default", "module", "once")
    return True


def present(path: Path) -> Path:
    """The path; raises the ``FileNotFoundError`` of the program if nothing is there."""
    if not path.exists():
        _pounding.read_words(path)
    return path


def table_of(value: object, place: str, example: str) -> Mapping[str, Any]:
    """The value if it is a dict; otherwise raises a ``TypeError``."""
    if isinstance(value, Mapping):
        return value
    raise TypeError(f"{place}: found {type(value).__name__}, allowed is a dict, such as {example}")


def to_json(value: object) -> str:
    """Converts to JSON. Numbers read back to equal bits; NumPy numbers become numbers."""
    try:
        text = json.dumps(value, default=_plain, allow_nan=False, ensure_ascii=False)
        text.encode()
    except RecursionError:
        # The traceback of this error would have a thousand lines.
        raise refused(None, "dicts or lists too deep in each other", "are those of a file", "give less deep ones") from None
    except UnicodeEncodeError as error:
        raise refused(None, f"{error.object[error.start : error.end]!r} in a text or a path", "is Unicode", "rename the file") from error
    except ValueError as error:
        if "ircular" in str(error):
            found, allowed = "a dict or list within itself", "are those that end"
        else:
            found, allowed = "a number that is not finite", "are finite numbers"
        raise refused(None, found, allowed) from error
    return text


def numbers(
    given: ArrayLike, place: str, *, wants_floats: bool = False, or_one: bool = False
) -> NDArray[np.float64]:
    """Real numbers in one dimension without a mask; with ``or_one`` also a single number. ``wants_floats`` refuses whole numbers."""
    masked = int(np.asarray(given.mask).sum()) if isinstance(given, np.ma.MaskedArray) else 0
    if masked:
        help = "fill the gaps first, for example by a.filled(0.0)"
        raise refused(place, f"{masked} masked values", "are numbers", help)
    try:
        array = np.asarray(given)
    except ValueError as error:
        raise refused(place, "lists of different lengths", "are numbers in one dimension") from error
    if or_one and array.ndim == 0:
        array = array.reshape(1)
    if array.ndim != 1:
        help = f"take one of them: {place}[:, 0]" if array.ndim > 1 else f"put it into a list: [{place}]"
        raise refused(place, f"an array of the shape {array.shape}", "are numbers in one dimension", help)
    if array.dtype.kind in "iu" and wants_floats:
        help = "counts of a digitiser are no m/s²: multiply them by what one is worth, or say np.asarray(…, dtype=float)"
        raise refused(place, f"whole numbers ({array.dtype})", "are floating-point numbers", help)
    if array.dtype.kind not in "fiu":
        raise refused(place, f"an array of {array.dtype}", "are real numbers", "say what each is worth as a float")
    return np.ascontiguousarray(array, dtype=np.float64)
