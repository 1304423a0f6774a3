"""From Python's keywords to the words of a file."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

#: Keywords of a structure, and its fields in a file, where they differ.
STRUCTURE = {
    "mass": "mass_kg",
    "stiffness": "stiffness_n_per_m",
    "period": "period_s",
    "height": "height_m",
    "yield_force": "yield_force_n",
    "yield_displacement": "yield_displacement_m",
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


def words(keywords: Mapping[str, Any], fields: Mapping[str, str]) -> dict[str, Any]:
    """Keywords that were given, under the names of a file."""
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


def to_json(value: object) -> str:
    """As JSON, in which a number reads back to the same bits; NumPy's numbers are numbers."""
    try:
        return json.dumps(value, default=_plain, allow_nan=False, ensure_ascii=False)
    except ValueError as error:
        from ._errors import Refused

        message = "found a number that is not finite, allowed are finite numbers"
        raise Refused(message, None, "a number that is not finite", "finite numbers") from error
