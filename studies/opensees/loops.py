"""Loops of OpenSees' Steel01 and BoucWen materials under a prescribed drift.

A route that shares nothing with this repository: `pip install openseespy`, then

    python studies/opensees/loops.py [file]

writes loops.csv (beside this script, or where told): forces [N] at drifts [m]. crates/solver/tests/all/opensees_loops.rs
compares them with the columns of the solver.

Columns: k = 100 kN/m, f_y = 1 kN, a = 0.1. BoucWen has z in units of drift where Ao = 1; its gamma and beta are those of
f = a k d + (1 - a) k z, dz = (1 - |z k/f_y|^n (gamma + beta sgn(z dd))) dd, times (k/f_y)^n. It follows z by implicit Euler
steps, each a part of the drift between two lines of the table: its error falls with their number, so that every force is
found with N, 2N and 4N steps and freed from the first two terms of the error by Richardson's extrapolation. Steel01
needs no more than the corners, and takes the same steps.
"""

import csv
import math
import pathlib
import sys

import openseespy.opensees as ops

STIFFNESS, YIELD_FORCE, HARDENING = 1e5, 1e3, 0.1
STEPS = 1000
# Name: exponent n, beta; gamma = 1 - beta.
BOUC_WEN = {
    "bouc_wen_n1_b0.5": (1, 0.5),
    "bouc_wen_n1_b0.7": (1, 0.7),
    "bouc_wen_n2_b0.5": (2, 0.5),
    "bouc_wen_n5_b0.3": (5, 0.3),
}


def drifts():
    """Reversals of growing and falling size in mm, 40 drifts each way; the yield displacement is 10 mm."""
    corners = [0.0, 6.0, -4.0, 15.0, -12.0, 30.0, -30.0, 22.0, 3.0, 17.0, -25.0, 5.0, 0.0]
    for start, end in zip(corners, corners[1:]):
        for part in range(1, 41):
            yield (start + (end - start) * part / 40) / 1000.0


def follow(define, steps):
    """Forces at the drifts, in so many steps from one to the next."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    define()
    ops.testUniaxialMaterial(1)
    before, forces = 0.0, []
    for drift in drifts():
        for step in range(1, steps + 1):
            ops.setStrain(before + (drift - before) * step / steps)
        before = drift
        forces.append(ops.getStress())
    return forces


def steel01():
    ops.uniaxialMaterial("Steel01", 1, YIELD_FORCE, STIFFNESS, HARDENING)


def bouc_wen(exponent, beta):
    unit = (STIFFNESS / YIELD_FORCE) ** exponent
    factors = ((1.0 - beta) * unit, beta * unit, 1.0, 0.0, 0.0, 0.0)
    # The last two: tolerance of the local Newton iteration for z [m], and its most rounds.
    ops.uniaxialMaterial("BoucWen", 1, HARDENING, STIFFNESS, float(exponent), *factors, 1e-16, 50)


def extrapolated(define):
    coarse, middle, fine = (follow(define, STEPS * factor) for factor in (1, 2, 4))
    worst = 0.0
    for one, two, three in zip(coarse, middle, fine):
        first, second = 2.0 * two - one, 2.0 * three - two
        force = second + (second - first) / 3.0
        worst = max(worst, abs(force - second))
        yield force
    print(f"second term of the error up to {worst:.1e} N", flush=True)


if __name__ == "__main__":
    beside = pathlib.Path(__file__).resolve().parent / "loops.csv"
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else beside
    table = {"drift_m": list(drifts()), "steel01": follow(steel01, 1)}
    for name, (exponent, beta) in BOUC_WEN.items():
        table[name] = list(extrapolated(lambda: bouc_wen(exponent, beta)))
        assert all(map(math.isfinite, table[name])), name
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(table)
        writer.writerows([repr(value) for value in line] for line in zip(*table.values()))
