"""Conversion of Python values to the words of a sweep file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._errors import Refused
from ._record import Record


def spread(field: str, values: Any) -> dict[str, Any]:
    """An entry of ``vary``: values, or a spread in the words of a file."""
    if isinstance(values, Mapping):
        return {"field": field, **values}
    listed = values.tolist() if isinstance(values, np.ndarray) else values
    return {"field": field, "values": list(listed) if hasattr(listed, "__iter__") else [listed]}


def restitution_of(scene: Mapping[str, Any]) -> str:
    """The field of every coefficient of restitution."""
    laws = {name for contact in scene.get("contacts", []) for name in contact["law"]}
    if len(laws) != 1:
        found = ", ".join(sorted(laws)) or "none"
        message = (
            f"restitution: found the laws {found}, allowed is one law; name the fields in vary, such as "
            '"contacts[0].law.stereomechanical.restitution"'
        )
        raise Refused(message, "restitution", f"the laws {found}", "one law", "name the fields in vary")
    return f"contacts[*].law.{laws.pop()}.restitution"


def arrays_of(record: Record | None) -> list[Record]:
    """The record in a list if it is an array: a sweep reads it from a file."""
    is_array = record is not None and record._native.kind == "samples"
    return [record] if record is not None and is_array else []
