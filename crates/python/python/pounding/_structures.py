"""Structures and contacts of a row in the words of a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Union

from . import _pounding
from ._errors import Refused
from ._words import AT_REST, STRUCTURE, table_of, to_json, words

__all__ = ["building", "sdof", "wall"]

#: A structure in the words of a file.
Structure = dict[str, Any]
#: A contact law: its name, or its name with its parameters.
Law = Union[str, Mapping[str, Any]]


def _damping(damping: float | Mapping[str, Any]) -> dict[str, Any]:
    return dict(damping) if isinstance(damping, Mapping) else {"ratio": damping}


def sdof(
    *,
    mass: float,
    period: float | None = None,
    stiffness: float | None = None,
    damping: float | Mapping[str, Any] = 0.05,
    name: str | None = None,
    yield_force: float | None = None,
    yield_displacement: float | None = None,
    yield_drift_ratio: float | None = None,
    hardening_ratio: float | None = None,
    bouc_wen: Mapping[str, Any] | None = None,
    height: float | None = None,
    drift_capacity_ratio: float | None = None,
    shear_capacity: float | None = None,
    isolation_layer: bool | None = None,
    column_capacity: float | None = None,
    columns: int | None = None,
    gravity_load: float | None = None,
    slab_depth: float | None = None,
    initial_displacement: float | None = None,
    initial_velocity: float | None = None,
) -> Structure:
    """A structure of one storey.

    Parameters
    ----------
    mass
        Mass [kg], > 0.
    period
        Natural period [s], > 0; or ``stiffness``.
    stiffness
        Elastic stiffness [N/m], > 0; or ``period``.
    damping
        Damping ratio [–], or the table of a file.
    name
        Name for tables; by default ``structure 1`` and so on from the left.
    yield_force
        Yield force [N]. Without any of the three yield settings columns stay elastic.
    yield_displacement
        Displacement at which columns yield [m].
    yield_drift_ratio
        Displacement at which columns yield, over ``height`` [–].
    hardening_ratio
        Stiffness after yielding over elastic stiffness [–], 0 to less than 1.
    bouc_wen
        Parameters of smooth yielding, as in a file.
    height
        Height of the mass over the ground [m].
    drift_capacity_ratio
        Displacement that the columns bear, over ``height`` [–]; by default that of ductile construction.
    shear_capacity
        Shear force that the columns bear [N]; by default it is not judged.
    isolation_layer
        Whether the structure stands on isolators, which have no limits of columns.
    column_capacity
        Shear force that one column bears when a slab of the neighbour hits it [N]; by default it is not judged.
    columns
        Number of equal columns: the one that a slab hits bends under a linear spring; by default none does.
    gravity_load
        Weight that acts on the leaning structure (P-Δ) [N]; by default none. It needs ``height``.
    slab_depth
        Depth of the slab below ``height`` [m]: slabs whose depths overlap meet as floors.
    initial_displacement, initial_velocity
        State at t = 0 [m], [m/s].
    """
    given = dict(locals())
    given["damping"] = _damping(damping)
    return {"sdof": words(given, STRUCTURE)}


def building(
    storeys: Sequence[Mapping[str, Any]],
    *,
    period: float | None = None,
    damping: float | Mapping[str, Any] = 0.05,
    name: str | None = None,
    **fields: Any,
) -> Structure:
    """A building of several storeys.

    Parameters
    ----------
    storeys
        From the ground up: dicts with ``mass`` [kg], ``stiffness`` [N/m], ``height`` [m], ``yield_force`` [N],
        ``yield_displacement`` [m], ``yield_drift_ratio`` [–], ``hardening_ratio`` [–],
        ``drift_capacity_ratio`` [–], ``shear_capacity`` [N], ``isolation_layer``,
        ``isolator`` (a table as in a file), ``isolator_damping`` [N·s/m], ``displacement_capacity`` [m],
        ``column_capacity`` [N], ``columns``, ``gravity_load`` [N], ``slab_depth`` [m], ``repeat`` (number of equal storeys).
    period
        First natural period [s], which determines the stiffness of equal storeys; or ``stiffness`` of each storey.
    damping
        Damping ratio [–] in the first two modes, or the table of a file.
    name
        Name for tables.
    **fields
        Other fields of a building in a file.
    """
    given = {
        "name": name,
        "period": period,
        "damping": _damping(damping),
        **fields,
        "storeys": [
            words(table_of(storey, f"storeys[{index}]", '{"mass": 3e5, "stiffness": 2e8}'), STRUCTURE)
            for index, storey in enumerate(storeys)
        ],
    }
    return with_known_fields({"building": words(given, STRUCTURE)})


def with_known_fields(made: Structure) -> Structure:
    """The structure, unless a field is misspelt: then it is refused in the words of the program, before it stands in a row."""
    ((kind, fields),) = made.items()
    alone = {"name": "row", "record": AT_REST, "structures": [{kind: {**fields, "name": fields.get("name", "structure")}}]}
    try:
        _pounding.check_scene(to_json(alone), Path("scene.json"))
    except Refused as refused:
        if (refused.found or "").startswith("the field "):
            prefix = f"structures[0].{kind}."
            place = (refused.place or "").removeprefix(prefix)
            said = str(refused).replace(prefix, "", 1)
            raise Refused(said, place, refused.found, refused.allowed, refused.help) from None
    return made


def wall() -> Structure:
    """A fixed wall, which moves with the ground."""
    return {"wall": {}}


def law_of(law: Law | None, restitution: float | None) -> Any:
    if law is None and restitution is None:
        # The contact that ``pounding init`` writes.
        return {"nonlinear_viscoelastic": {"impact_stiffness_n_per_m1_5": 2.75e9, "restitution": 0.65}}
    if law is None:
        return {"stereomechanical": {"restitution": restitution}}
    if isinstance(law, str) and restitution is not None:
        law = {law: {}}
    if isinstance(law, str):
        return law
    if restitution is None:
        return law
    law = table_of(law, "law", '{"hertz_damp": {"impact_stiffness_n_per_m1_5": 2.75e9}}')
    for name, parameters in law.items():
        if "restitution" in table_of(parameters, f"law.{name}", '{"impact_stiffness_n_per_m1_5": 2.75e9}'):
            found, allowed = f"one in {name} and restitution={restitution}", "one of them"
            raise Refused(f"restitution: found {found}, allowed is {allowed}", "restitution", found, allowed)
    return {name: {**parameters, "restitution": restitution} for name, parameters in law.items()}


def for_each(value: Any, n: int, what: str) -> list[Any]:
    if isinstance(value, (str, Mapping)) or not hasattr(value, "__len__"):
        return [value] * n
    if len(value) != n:
        message = f"{what}: found {len(value)}, allowed are {n}, one between each structure and its right neighbour, or one for all"
        raise Refused(message, what, str(len(value)), str(n))
    return list(value)
