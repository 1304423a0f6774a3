"""Two shear buildings of three storeys that pound floor against floor, by OpenSees.

A route that shares nothing with this repository but the record: `pip install openseespy numpy`, then

    python studies/opensees/three-storey-pair.py [file]

writes three-storey-pair.csv (beside this script, or where told). Tests compare the numbers with the solver and the
second route.

Model: masses at the floors, a spring and a dashpot per storey, Rayleigh damping alpha M + beta K of the storeys, and at
each level a spring k max(0, u_left - u_right - gap). The ground moves as the first 10 s of the El Centro record, linear
between samples. Method: Newmark's of average acceleration; its error falls with the square of the step, between two
touches and, as a kink of the force costs each touch that much, on the whole. Peaks are those of parabolas through three
nodes. Dashpots are part of the materials, so that gap springs have none (rayleigh() finds the same numbers); the force of
the gap springs is compared with its formula at every node in contact.
"""

import csv
import pathlib
import sys

import openseespy.opensees as ops

HERE = pathlib.Path(__file__).resolve().parent
RECORD = HERE.parent / "records" / "el-centro-1940-ns-chopra.csv"
GROUND_STEP, G, DURATION = 0.02, 9.80665, 10.0
# From the ground up: masses [kg] and stiffnesses [N/m].
BUILDINGS = {
    "left": [(100e3, 60e6), (100e3, 50e6), (80e3, 40e6)],
    "right": [(250e3, 500e6), (250e3, 400e6), (200e3, 300e6)],
}
ALPHA, BETA = 0.3, 0.0015
GAP, GAP_STIFFNESS = 0.02, 2e8
STOREYS, SIDES = range(3), ("left", "right")
TIME_STEPS = (1e-3, 1e-4, 4e-5, 2e-5, 1e-5)


def ground():
    """Ground acceleration [m/s2]."""
    with RECORD.open() as file:
        lines = [line for line in file if not line.startswith("#")]
    return [G * float(row["acceleration_g"]) for row in csv.DictReader(lines)]


def node(side, storey):
    return 10 * (SIDES.index(side) + 1) + storey + 1


def build():
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for side in SIDES:
        below = node(side, -1)
        ops.node(below, 0.0)
        ops.fix(below, 1)
        for storey, (mass, stiffness) in enumerate(BUILDINGS[side]):
            floor = node(side, storey)
            ops.node(floor, 0.0)
            ops.mass(floor, mass)
            # Stress = k strain + beta k rate; the ground's dashpot has no stiffness.
            ops.uniaxialMaterial("Elastic", 100 + floor, stiffness, BETA * stiffness)
            ops.uniaxialMaterial("Elastic", 200 + floor, 0.0, ALPHA * mass)
            ops.element("zeroLength", 100 + floor, below, floor, "-mat", 100 + floor, "-dir", 1)
            ops.element("zeroLength", 200 + floor, node(side, -1), floor, "-mat", 200 + floor, "-dir", 1)
            below = floor
    for level in STOREYS:
        # Compression begins at a strain of -gap, and nothing yields.
        ops.uniaxialMaterial("ElasticPPGap", 300 + level, GAP_STIFFNESS, -1e20, -GAP)
        floors = node("left", level), node("right", level)
        ops.element("zeroLength", 300 + level, *floors, "-mat", 300 + level, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", GROUND_STEP, "-values", *ground())
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-14, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


class Peak:
    """Value of the largest magnitude; of the parabola through three nodes that follow each other."""

    def __init__(self):
        self.value, self.last = 0.0, [0.0, 0.0]

    def see(self, value):
        before, middle = self.last
        top = middle
        bend = before - 2.0 * middle + value
        if abs(middle) >= max(abs(before), abs(value)) and bend != 0.0:
            top = middle - (value - before) ** 2 / (8.0 * bend)
        if abs(top) > abs(self.value):
            self.value = top
        self.last = [middle, value]


def run(time_step):
    """Rows (quantity, building, storey, value) of the CSV."""
    build()
    displacements = {(side, storey): Peak() for side in SIDES for storey in STOREYS}
    forces, touches, touching = [Peak() for _ in STOREYS], [0, 0, 0], [False] * 3
    worst = 0.0
    for step in range(round(DURATION / time_step)):
        if ops.analyze(1, time_step) != 0:
            sys.exit(f"no equilibrium at t = {step * time_step} s")
        u = {floor: ops.nodeDisp(node(*floor), 1) for floor in displacements}
        for floor, peak in displacements.items():
            peak.see(u[floor])
        for level in STOREYS:
            deformation = u["left", level] - u["right", level] - GAP
            force = GAP_STIFFNESS * max(0.0, deformation)
            if deformation > 0.0 or touching[level]:
                stress = ops.eleResponse(300 + level, "material", 1, "stress")[0]
                worst = max(worst, abs(stress + force))
            forces[level].see(force)
            touches[level] += deformation > 0.0 and not touching[level]
            touching[level] = deformation > 0.0
    print(f"{time_step:g} s: gap springs are k max(0, u_l - u_r - gap) to {worst:.1e} N", flush=True)
    for side, storey in displacements:
        yield "peak displacement [m]", side, storey + 1, repr(displacements[side, storey].value)
    for level in STOREYS:
        yield "touches", "", level + 1, touches[level]
        yield "peak force [N]", "", level + 1, repr(forces[level].value)


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "three-storey-pair.csv"
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time_step_s", "quantity", "building", "storey", "value"])
        for time_step in TIME_STEPS:
            writer.writerows([f"{time_step:g}", *row] for row in run(time_step))
            file.flush()
