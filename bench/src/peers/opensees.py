"""OpenSees: Newmark's method of average acceleration with Newton's iterations, all steps in one call of `analyze`.

Its material JankowskiImpact is the nonlinear viscoelastic element. It has no impact with restitution, so that those scenes are not
run. Only `analyze` is timed, with the recorder of the largest displacements; impulses are summed in another run, step by step,
and cost it nothing.
"""

import ctypes
import importlib.util
import math
import os
import time

# The package brings the libraries that it needs, but its loader finds one of them for itself alone.
HOME = importlib.util.find_spec("openseespylinux")
for name in ("libquadmath.so.0", "libgfortran.so.4", "libblas.so.3"):
    if HOME:
        ctypes.CDLL(os.path.join(HOME.submodule_search_locations[0], "lib", name), mode=ctypes.RTLD_GLOBAL)

import openseespy.opensees as ops  # noqa: E402  (after the libraries)

HERE = os.path.dirname(os.path.abspath(__file__))
PEAKS = os.path.join(HERE, "opensees-peaks.out")


def build(study, law, scene):
    m1, m2, k1, k2, c1, c2, gap = scene
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for place, (mass, stiffness, damping) in enumerate(((m1, k1, c1), (m2, k2, c2))):
        ground, node, column = 2 * place + 1, 2 * place + 2, place + 1
        ops.node(ground, 0.0)
        ops.node(node, 0.0)
        ops.fix(ground, 1)
        ops.mass(node, float(mass))
        # Stress = k strain + c rate.
        ops.uniaxialMaterial("Elastic", column, float(stiffness), float(damping))
        ops.element("zeroLength", column, ground, node, "-mat", column, "-dir", 1)
    reduced = m1 * m2 / (m1 + m2)
    ops.uniaxialMaterial("JankowskiImpact", 3, law.a, law.b, float(reduced), -float(gap), 1.5)
    ops.element("zeroLength", 3, 2, 4, "-mat", 3, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", study.ground_step, "-values", *study.ground.tolist())
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-13, 100)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    # It would begin with an acceleration of zero, an error of the size of a step.
    for node in (2, 4):
        ops.setNodeAccel(node, 1, -float(study.ground[0]), "-commit")


def timed(dt, study, law, scene):
    build(study, law, scene)
    ops.recorder("EnvelopeNode", "-file", PEAKS, "-precision", 16, "-node", 2, 4, "-dof", 1, "disp")
    steps = round(study.duration / dt)
    start = time.process_time()
    failed = ops.analyze(steps, dt) != 0
    seconds = time.process_time() - start
    ops.wipe()
    if failed:  # no equilibrium
        return seconds, [math.nan, math.nan]
    with open(PEAKS, encoding="utf-8") as file:
        largest = file.read().split()[-2:]
    return seconds, [abs(float(value)) for value in largest]


def impulse(dt, study, law, scene):
    build(study, law, scene)
    total = before = 0.0
    for _ in range(round(study.duration / dt)):
        if ops.analyze(1, dt) != 0:
            return math.nan
        force = -ops.eleResponse(3, "material", 1, "stress")[0]
        total += 0.5 * dt * (before + force)
        before = force
    return total


IMPULSES = {}


def measured(_, dt, study, law):
    """Seconds of a scene, and what was found; impulses are summed once."""
    ops.logFile(os.devnull, "-noEcho")
    runs = [timed(dt, study, law, scene) for scene in law.scenes]
    if dt not in IMPULSES:
        IMPULSES[dt] = [impulse(dt, study, law, scene) for scene in law.scenes]
    found = [(*peaks, total) for (_, peaks), total in zip(runs, IMPULSES[dt])]
    return sum(seconds for seconds, _ in runs) / len(runs), found
