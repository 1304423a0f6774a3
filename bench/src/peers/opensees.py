"""OpenSees: Newmark's method of average acceleration with Krylov–Newton iterations, all steps in one call of `analyze`.

Its fastest way of those tried: plain Newton fails between towers at 5 ms and more, as the tangent of the contact material has the wrong
sign; a norm of displacements takes a second iteration in every step; dampers against the ground would be an element each.

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


def structures(law, scene):
    """Two structures; nodes of their tops, and contacts."""
    m1, m2, k1, k2, c1, c2, gap = map(float, scene)
    for place, (mass, stiffness, damping) in enumerate(((m1, k1, c1), (m2, k2, c2))):
        ground, node, column = 2 * place + 1, 2 * place + 2, place + 1
        grounded(ground)
        floor(node, mass)
        # Stress = k strain + c rate.
        ops.uniaxialMaterial("Elastic", column, stiffness, damping)
        ops.element("zeroLength", column, ground, node, "-mat", column, "-dir", 1)
    contact(3, law, (2, 4), (m1, m2), gap)
    return (2, 4), (3,)


def towers(law, scene):
    """Two towers of bilinear storeys; nodes of their tops, and contacts of the levels that face each other."""
    tops, tag = [], 0
    for first, storeys in zip((100, 200), scene["towers"]):
        grounded(first)
        mass, _, ground_damping, *_ = storeys[-1]
        alpha = ground_damping / mass
        for node, (mass, damping, _, stiffness, yields, hardening) in enumerate(storeys, first + 1):
            floor(node, mass)
            tag += 2
            # That of the lowest storey has both.
            damping -= alpha * mass if node == first + 1 else 0.0
            ops.uniaxialMaterial("Steel01", tag, yields, stiffness, hardening)
            ops.uniaxialMaterial("Elastic", tag + 1, 0.0, damping)
            ops.element("zeroLength", tag, node - 1, node, "-mat", tag, tag + 1, "-dir", 1, 1)
        ops.region(first, "-nodeOnly", *range(first + 1, node + 1), "-rayleigh", alpha, 0.0, 0.0, 0.0)
        tops.append(node)
    left, right = scene["towers"]
    contacts = range(301, 301 + min(len(left), len(right)))
    for level, place in enumerate(contacts):
        nodes = 101 + level, 201 + level
        contact(place, law, nodes, (left[level][0], right[level][0]), scene["gap"])
    return tops, contacts


def grounded(node):
    ops.node(node, 0.0)
    ops.fix(node, 1)


def floor(node, mass):
    ops.node(node, 0.0)
    ops.mass(node, mass)


def contact(tag, law, nodes, masses, gap):
    reduced = masses[0] * masses[1] / sum(masses)
    ops.uniaxialMaterial("JankowskiImpact", tag, law.a, law.b, reduced, -gap, 1.5)
    ops.element("zeroLength", tag, *nodes, "-mat", tag, "-dir", 1)


def build(dt, study, law, scene):
    """Nodes of both tops, and contacts."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    built = (towers if isinstance(scene, dict) else structures)(law, scene)
    ops.timeSeries("Path", 1, "-dt", study.ground_step, "-values", *study.ground.tolist())
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    # Forces of 1e-4 N, or what rounding leaves of them in short steps.
    ops.test("NormUnbalance", 1e-4 * max(1.0, (5e-4 / dt) ** 2), 100)
    ops.algorithm("KrylovNewton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    # It would begin with an acceleration of zero, an error of the size of a step.
    for node in ops.getNodeTags():
        if ops.nodeMass(node, 1) > 0.0:
            ops.setNodeAccel(node, 1, -float(study.ground[0]), "-commit")
    return built


def timed(dt, study, law, scene):
    tops, _ = build(dt, study, law, scene)
    ops.recorder("EnvelopeNode", "-file", PEAKS, "-precision", 16, "-node", *tops, "-dof", 1, "disp")
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
    _, contacts = build(dt, study, law, scene)
    total = before = 0.0
    for _ in range(round(study.duration / dt)):
        if ops.analyze(1, dt) != 0:
            return math.nan
        force = -sum(ops.eleResponse(place, "material", 1, "stress")[0] for place in contacts)
        total += 0.5 * dt * (before + force)
        before = force
    return total


IMPULSES = {}


def measured(_, dt, study, law):
    """Seconds of a scene, and what was found; impulses are summed once."""
    ops.logFile(os.devnull, "-noEcho")
    runs = [timed(dt, study, law, scene) for scene in law.scenes]
    if (law.name, dt) not in IMPULSES:
        IMPULSES[law.name, dt] = [impulse(dt, study, law, scene) for scene in law.scenes]
    found = [(*peaks, total) for (_, peaks), total in zip(runs, IMPULSES[law.name, dt])]
    return sum(seconds for seconds, _ in runs) / len(runs), found
