"""Functions that need no row."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from . import _pounding
from ._run import Run

if TYPE_CHECKING:
    import pandas

__all__ = ["certify", "compare", "laws"]


def certify(
    law: str,
    *,
    restitution: float,
    masses: tuple[float, float],
    speed: float,
    stiffness: float | None = None,
    calibration: str = "exact",
    time_step: float | None = None,
    method: str | None = None,
) -> dict[str, Any]:
    """Restitution that a contact law, and the methods, deliver in a free impact.

    Parameters
    ----------
    law
        Name of the law, from :func:`laws`.
    restitution
        Requested coefficient of restitution [–].
    masses
        Masses of the neighbours [kg].
    speed
        Approach speed [m/s].
    stiffness
        Impact stiffness [N/m] or [N/m^1.5]; 9.35e7 or 2.75e9 by default.
    calibration
        How the damping is chosen: ``"exact"`` or ``"literature"``.
    time_step
        Time step of the methods [s]; by default no method is tried.
    method
        The method; all by default.

    Returns
    -------
    dict
        The numbers of ``pounding certify --json``; names end with units.
    """
    literature = {"exact": False, "literature": True}
    if calibration not in literature:
        from ._errors import Refused

        message = f"calibration: found `{calibration}`, allowed are `exact`, `literature`"
        raise Refused(message, "calibration", f"`{calibration}`", "`exact`, `literature`")
    found: dict[str, Any] = json.loads(
        _pounding.certify(
            law,
            restitution,
            list(masses),
            speed,
            stiffness,
            literature[calibration],
            time_step,
            method,
        )
    )
    return found


def laws() -> pandas.DataFrame:
    """The contact laws, each with its name, its force and the unit of its impact stiffness."""
    import pandas

    return pandas.DataFrame(_pounding.laws(), columns=["law", "force", "stiffness_unit"])


def compare(runs: Sequence[Run], names: Sequence[str] | None = None) -> pandas.DataFrame:
    """A table of several runs: one column per run, one row per number of a floor or a pair. Places in the row identify floors and pairs.

    Parameters
    ----------
    runs
        Runs of scenes.
    names
        Names of the columns; by default those of the scenes, numbered if two are equal.
    """
    import pandas

    if names is None:
        own = [run.scene.name for run in runs]
        names = own if len(set(own)) == len(own) else [f"{name} ({n})" for n, name in enumerate(own, 1)]
    columns = {}
    for name, run in zip(names, runs):
        floors = run.peaks.drop(columns=["building", "name"]).melt(["structure", "storey"], var_name="quantity")
        floors.insert(0, "of", "structure")
        floors = floors.rename(columns={"structure": "place", "storey": "level"})
        pairs = run.pairs.drop(columns=["left", "right", "law"])
        pairs = pairs.melt(["contact", "level"], var_name="quantity")
        pairs.insert(0, "of", "gap")
        pairs = pairs.rename(columns={"contact": "place"})
        both = pandas.concat([floors, pairs] if len(pairs) else [floors])
        columns[name] = both.set_index(["of", "place", "level", "quantity"])["value"].astype(float)
    return pandas.DataFrame(columns)
