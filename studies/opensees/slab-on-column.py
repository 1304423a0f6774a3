"""A slab that pounds a column of its neighbour between two floors, by OpenSees.

A route that shares nothing with this repository but the record: `pip install openseespy`, then

    python studies/opensees/slab-on-column.py [file]

writes slab-on-column.csv (beside this script, or where told). A test compares the numbers with the exact run of
slab-on-column.toml.

Model: floors that move sideways only, on columns of elastic beams whose ends do not turn, EI = k H^3/12 of a storey. Of the
eight columns of the storey that is hit, seven are one such beam. The eighth consists of two half-columns, which meet at a node
without mass that moves and turns. A gap spring joins this node and the slab. Dashpots alpha m to the ground and beta k in
every storey, none in the half-columns. The ground moves as the first 6 s of the El Centro record, linear between samples.
Method: Newmark's of average acceleration. Peaks are those of parabolas through three nodes. OpenSees warns of elements of
zero length between floors: they are dashpots, of which only the sideways motion counts.
"""

import csv
import importlib
import pathlib
import sys

import openseespy.opensees as ops

HERE = pathlib.Path(__file__).resolve().parent
PAIR = importlib.import_module("three-storey-pair")
DURATION = 6.0
SLAB = (3e5, 1.2e7)
# From the ground up: masses [kg] and stiffnesses [N/m].
FLOORS = [(2e5, 2e8), (2e5, 1.6e8), (1.5e5, 1.2e8)]
HEIGHT, HIT, COLUMNS, PART = 3.0, 1, 8, 0.6
ALPHA, BETA = 0.3, 0.0015
GAP, GAP_STIFFNESS = 0.02, 2e8
GROUND, SLAB_GROUND, SLAB_NODE, COLUMN_NODE = 10, 20, 21, 30
TIME_STEPS = (1e-3, 1e-4, 2e-5)


def beam(tag, below, above, stiffness):
    """Columns, or a part of their length, whose sideways stiffness over the whole storey is this one."""
    # Area and E are 1: the area does not matter, because no node moves up or down.
    ops.element("elasticBeamColumn", tag, below, above, 1.0, 1.0, stiffness * HEIGHT**3 / 12.0, 1)


def dashpot(tag, one, other, coefficient):
    ops.uniaxialMaterial("Elastic", tag, 0.0, coefficient)
    ops.element("zeroLength", tag, one, other, "-mat", tag, "-dir", 1)


def moving(tag, height, mass):
    ops.node(tag, 0.0, height)
    ops.fix(tag, 0, 1, 1)
    ops.mass(tag, mass, 0.0, 0.0)


def build():
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    for ground in (GROUND, SLAB_GROUND):
        ops.node(ground, 0.0, 0.0)
        ops.fix(ground, 1, 1, 1)
    mass, stiffness = SLAB
    at = (HIT + PART) * HEIGHT
    moving(SLAB_NODE, at, mass)
    ops.uniaxialMaterial("Elastic", 1, stiffness, BETA * stiffness + ALPHA * mass)
    ops.element("zeroLength", 1, SLAB_GROUND, SLAB_NODE, "-mat", 1, "-dir", 1)
    for storey, (mass, stiffness) in enumerate(FLOORS):
        floor, below = GROUND + storey + 1, GROUND + storey
        moving(floor, (storey + 1) * HEIGHT, mass)
        whole = (COLUMNS - 1) / COLUMNS if storey == HIT else 1.0
        beam(100 + storey, below, floor, whole * stiffness)
        dashpot(200 + storey, below, floor, BETA * stiffness)
        dashpot(300 + storey, GROUND, floor, ALPHA * mass)
    ops.node(COLUMN_NODE, 0.0, at)
    ops.fix(COLUMN_NODE, 0, 1, 0)
    own = FLOORS[HIT][1] / COLUMNS
    beam(400, GROUND + HIT, COLUMN_NODE, own)
    beam(401, COLUMN_NODE, GROUND + HIT + 1, own)
    # Compression begins at a strain of -gap, and nothing yields.
    ops.uniaxialMaterial("ElasticPPGap", 500, GAP_STIFFNESS, -1e20, -GAP)
    ops.element("zeroLength", 500, SLAB_NODE, COLUMN_NODE, "-mat", 500, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", PAIR.GROUND_STEP, "-values", *PAIR.ground())
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-14, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def run(time_step):
    """Rows (quantity, place, value) of the CSV: floors by their heights, as in the row of the scene."""
    build()
    nodes = [*(GROUND + storey + 1 for storey in range(len(FLOORS)))]
    nodes.insert(HIT, SLAB_NODE)
    peaks, force, touches, touching = [PAIR.Peak() for _ in nodes], PAIR.Peak(), 0, False
    for step in range(round(DURATION / time_step)):
        if ops.analyze(1, time_step) != 0:
            sys.exit(f"no equilibrium at t = {step * time_step} s")
        for node, peak in zip(nodes, peaks):
            peak.see(ops.nodeDisp(node, 1))
        deformation = ops.nodeDisp(SLAB_NODE, 1) - ops.nodeDisp(COLUMN_NODE, 1) - GAP
        force.see(GAP_STIFFNESS * max(0.0, deformation))
        touches += deformation > 0.0 and not touching
        touching = deformation > 0.0
    for place, peak in enumerate(peaks):
        yield "displacement", place, repr(peak.value)
    yield "touches", 0, touches
    yield "force", 0, repr(force.value)


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "slab-on-column.csv"
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time_step_s", "quantity", "place", "value"])
        for time_step in TIME_STEPS:
            writer.writerows([f"{time_step:g}", *row] for row in run(time_step))
            file.flush()
