

def travels():
    """Whether the ground motion reaches some floors later than others."""
    return any(ARRIVALS)


def node_of(floor):
    """Node 1, 2, ... is the ground of each arrival; a wall is its ground, and each floor has a node behind them."""
    return GROUND_OF[floor] + 1 if FLOORS[floor] is None else len(ARRIVALS) + floor + 1


def ground_motion(arrival, times):
    """Displacement, velocity and acceleration of the ground at these rising times: exact between samples."""
    step, last = GROUND_STEP, len(GROUND) - 1
    displacement, velocity, at = 0.0, 0.0, 0
    moved, speeds, accelerations = [], [], []

    def after(t):
        a = GROUND[at] if at < last else 0.0
        slope = (GROUND[at + 1] - a) / step if at < last else 0.0
        return (
            displacement + t * (velocity + t * (a / 2 + t * slope / 6)),
            velocity + t * (a + t * slope / 2),
            a + t * slope,
        )

    for time in times:
        while at < last and time - arrival >= (at + 1) * step:
            displacement, velocity, _ = after(step)
            at += 1
        u, v, a = after(time - arrival - at * step) if time >= arrival else (0.0, 0.0, 0.0)
        moved.append(u)
        speeds.append(v)
        accelerations.append(a)
    return moved, speeds, accelerations


def shake(time_step):
    """One acceleration under all floors, or the motion of every ground: then displacements are no longer relative to it."""
    if not travels():
        ops.timeSeries("Path", 1, "-dt", GROUND_STEP, "-values", *GROUND)
        ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
        return
    times = [step * time_step for step in range(round(DURATION / time_step) + 2)]
    ops.pattern("MultipleSupport", 1)
    for i, arrival in enumerate(ARRIVALS):
        series = [3 * i + 1, 3 * i + 2, 3 * i + 3]
        for tag, values in zip(series, ground_motion(arrival, times)):
            ops.timeSeries("Path", tag, "-dt", time_step, "-values", *values)
        displacement, velocity, acceleration = series
        ops.groundMotion(i + 1, "Plain", "-disp", displacement, "-vel", velocity, "-accel", acceleration)
        ops.imposedMotion(i + 1, 1, i + 1)


def build(time_step):
    """The row in OpenSees."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for i in range(len(ARRIVALS)):
        ops.node(i + 1, 0.0)
        if not travels():
            ops.fix(i + 1, 1)
    for i, one in enumerate(FLOORS):
        if one is None:
            continue
        floor, ground = node_of(i), GROUND_OF[i] + 1
        ops.node(floor, 0.0)
        ops.mass(floor, one["mass"])
        below = ground if one["below"] is None else node_of(one["below"])
        kind, *parameters = one["column"]
        ops.uniaxialMaterial(kind, 10 * i + 1, *parameters)
        # No stiffness, and a stress of c times the rate: exactly the damping of the scene.
        ops.uniaxialMaterial("Elastic", 10 * i + 2, 0.0, one["damping"])
        ops.uniaxialMaterial("Elastic", 10 * i + 3, 0.0, one["ground_damping"])
        for tag, start in ((1, below), (2, below), (3, ground)):
            if tag < 3 or one["ground_damping"] > 0.0:
                ops.element("zeroLength", 10 * i + tag, start, floor, "-mat", 10 * i + tag, "-dir", 1)
    for i, contact in enumerate(CONTACTS):
        tag, (kind, *parameters) = 10 * (len(FLOORS) + i), contact["material"]
        ops.uniaxialMaterial(kind, tag, *parameters)
        left, right = (node_of(floor) for floor in contact["floors"])
        ops.element("zeroLength", tag, left, right, "-mat", tag, "-dir", 1)
    tag = 10 * (len(FLOORS) + len(CONTACTS))
    for link in LINKS:
        left, right = (GROUND_OF[floor] + 1 if on_ground else node_of(floor) for floor, on_ground in link["ends"])
        for kind, *parameters in link["materials"]:
            tag += 1
            ops.uniaxialMaterial(kind, tag, *parameters)
            ops.element("zeroLength", tag, left, right, "-mat", tag, "-dir", 1)
    shake(time_step)


def start():
    """The state at t = 0. OpenSees would begin with an acceleration of zero, an error of the size of a step."""

    def storey(one):
        displacement, velocity, force = one["start"]
        below = 0.0 if one["below"] is None else FLOORS[one["below"]]["start"][1]
        return force + one["damping"] * (velocity - below)

    for i, one in enumerate(FLOORS):
        if one is None:
            continue
        displacement, velocity, _ = one["start"]
        above = sum(storey(other) for other in FLOORS if other is not None and other["below"] == i)
        force = above - storey(one) - one["ground_damping"] * velocity
        ground = 0.0 if travels() else GROUND[0]
        ops.setNodeDisp(node_of(i), 1, displacement, "-commit")
        ops.setNodeVel(node_of(i), 1, velocity, "-commit")
        ops.setNodeAccel(node_of(i), 1, force / one["mass"] - ground, "-commit")


def run(time_step):
    """Newmark's method of average acceleration with Newton's iterations; the numbers that pounding prints."""
    build(time_step)
    ops.constraints("Transformation")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-13, 100)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    start()
    floors, contacts = range(len(FLOORS)), range(len(CONTACTS))
    found = {
        "displacement": [0.0 for _ in floors],
        "touches": [0 for _ in contacts],
        "first": [None for _ in contacts],
        "force": [None for _ in contacts],
    }

    def displacements():
        return [ops.nodeDisp(node_of(i), 1) for i in floors]

    def overlaps(u):
        sides = [contact["floors"] for contact in CONTACTS]
        return [u[left] - u[right] - CONTACTS[i]["gap"] for i, (left, right) in enumerate(sides)]

    before = overlaps(displacements())
    for step in range(round(DURATION / time_step)):
        if ops.analyze(1, time_step) != 0:
            sys.exit(f"no equilibrium at t = {step * time_step} s; take a smaller time step")
        u = displacements()
        for i in floors:
            over_ground = u[i] - ops.nodeDisp(GROUND_OF[i] + 1, 1) if travels() else u[i]
            if abs(over_ground) > abs(found["displacement"][i]):
                found["displacement"][i] = over_ground
        after = overlaps(u)
        for i in contacts:
            if after[i] <= 0.0:
                continue
            if before[i] <= 0.0:
                found["touches"][i] += 1
                if found["first"][i] is None:
                    part = -before[i] / (after[i] - before[i])
                    found["first"][i] = (step + part) * time_step
            force = -ops.eleResponse(10 * (len(FLOORS) + i), "material", 1, "stress")[0]
            found["force"][i] = max(force, found["force"][i] or 0.0)
        before = after
    return found


def report(found, time_step):
    """Prints what OpenSees finds, what the exact method found, and the relative difference."""

    def line(what, unit, ours, exact):
        def number(value):
            return "-" if value is None else f"{value:.9g}"

        difference = ""
        if None not in (ours, exact) and exact != 0:
            difference = f"{(ours - exact) / abs(exact):.1e}"
        print(f"{what + ' ' + unit:48} {number(ours):>14} {number(exact):>14} {difference:>10}")

    print(f"{SCENE}: OpenSees {ops.version()}, time step {time_step:g} s, {DURATION:g} s")
    print(f"{'':48} {'OpenSees':>14} {'exact':>14} {'difference':>10}")
    for i, one in enumerate(FLOORS):
        if one is not None:
            found_one, exact = found["displacement"][i], EXACT["displacement"][i]
            line(f"{one['name']}: peak displacement", "[m]", found_one, exact)
    for i, contact in enumerate(CONTACTS):
        for key, what, unit in (
            ("touches", "number of touches", ""),
            ("first", "first touch", "[s]"),
            ("force", "peak contact force", "[N]"),
        ):
            line(f"{contact['name']}: {what}", unit, found[key][i], EXACT[key][i])
        if contact["note"] is not None:
            print(f"{contact['name']}: {contact['material'][0]} is {contact['note']}")


if __name__ == "__main__":
    step = float(sys.argv[1]) if len(sys.argv) > 1 else TIME_STEP
    # The impact materials report every touch; what stops a run is said above.
    ops.logFile(os.devnull, "-noEcho")
    report(run(step), step)
