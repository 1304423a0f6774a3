"""Earthquake-induced structural pounding: how adjacent buildings collide in an earthquake.

>>> import pounding
>>> pulse = pounding.formula("ricker", amplitude=3.0, frequency=1.0, time_step=0.01)
>>> weak = pounding.sdof(mass=75e3, period=1.2, damping=0.05)
>>> stiff = pounding.sdof(mass=3e6, period=0.3, damping=0.05)
>>> run = pounding.row(weak, stiff, gap=0.03, restitution=0.65).run(pulse)
>>> len(run.impacts) > 0
True

Units are SI everywhere: kg, m, s, N, m/s². Names of columns end with their unit.
"""

from ._answers import certify, compare, laws
from ._errors import PoundingWarning, Refused
from ._folder import Assessment, Ida
from ._plots import plot_required_gap, plot_sweep
from ._record import Record, formula, read, record
from ._run import Run
from ._scene import Scene, row, scene
from ._structures import building, sdof, wall

__all__ = [
    "Assessment",
    "Ida",
    "PoundingWarning",
    "Record",
    "Refused",
    "Run",
    "Scene",
    "building",
    "certify",
    "compare",
    "formula",
    "laws",
    "plot_required_gap",
    "plot_sweep",
    "read",
    "record",
    "row",
    "scene",
    "sdof",
    "wall",
]
