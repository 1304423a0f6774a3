

def build():
    """The row in OpenSees: node 2i + 1 is the ground under structure i, 2i + 2 its mass."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for i, one in enumerate(STRUCTURES):
        ground, mass = 2 * i + 1, 2 * i + 2
        ops.node(ground, 0.0)
        ops.node(mass, 0.0)
        ops.fix(ground, 1)
        if one is None:  # a wall moves with the ground
            ops.fix(mass, 1)
            continue
        ops.mass(mass, one["mass"])
        column, dashpot = 10 * i + 1, 10 * i + 2
        if one["yield_force"] is None:
            ops.uniaxialMaterial("Elastic", column, one["stiffness"])
        else:
            yields = one["yield_force"] / one["stiffness"]
            ops.uniaxialMaterial("ElasticPP", column, one["stiffness"], yields)
        # No stiffness, and a stress of c times the rate: exactly the damping of the scene.
        ops.uniaxialMaterial("Elastic", dashpot, 0.0, one["damping"])
        for tag in (column, dashpot):
            ops.element("zeroLength", tag, ground, mass, "-mat", tag, "-dir", 1)
    for i, contact in enumerate(CONTACTS):
        tag, (kind, *parameters) = 10 * i + 3, contact["material"]
        ops.uniaxialMaterial(kind, tag, *parameters)
        ops.element("zeroLength", tag, 2 * i + 2, 2 * i + 4, "-mat", tag, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", GROUND_STEP, "-values", *GROUND)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)


def start():
    """The state at t = 0. OpenSees would begin with an acceleration of zero, an error of the size of a step."""
    for i, one in enumerate(STRUCTURES):
        if one is None:
            continue
        force = one["stiffness"] * one["displacement"]
        if one["yield_force"] is not None:
            force = max(-one["yield_force"], min(one["yield_force"], force))
        force += one["damping"] * one["velocity"]
        mass = 2 * i + 2
        ops.setNodeDisp(mass, 1, one["displacement"], "-commit")
        ops.setNodeVel(mass, 1, one["velocity"], "-commit")
        ops.setNodeAccel(mass, 1, -GROUND[0] - force / one["mass"], "-commit")


def run(time_step):
    """Newmark's method of average acceleration with Newton's iterations; the numbers that pounding prints."""
    build()
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-13, 100)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    start()
    structures, contacts = range(len(STRUCTURES)), range(len(CONTACTS))
    found = {
        "displacement": [0.0 for _ in structures],
        "touches": [0 for _ in contacts],
        "first": [None for _ in contacts],
        "force": [None for _ in contacts],
    }

    def displacements():
        return [ops.nodeDisp(2 * i + 2, 1) for i in structures]

    def overlaps(u):
        return [u[i] - u[i + 1] - CONTACTS[i]["gap"] for i in contacts]

    before = overlaps(displacements())
    for step in range(round(DURATION / time_step)):
        if ops.analyze(1, time_step) != 0:
            sys.exit(f"no equilibrium at t = {step * time_step} s; take a smaller time step")
        u = displacements()
        for i in structures:
            if abs(u[i]) > abs(found["displacement"][i]):
                found["displacement"][i] = u[i]
        after = overlaps(u)
        for i in contacts:
            if after[i] <= 0.0:
                continue
            if before[i] <= 0.0:
                found["touches"][i] += 1
                if found["first"][i] is None:
                    part = -before[i] / (after[i] - before[i])
                    found["first"][i] = (step + part) * time_step
            force = -ops.eleResponse(10 * i + 3, "material", 1, "stress")[0]
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
        print(f"{what + ' ' + unit:38} {number(ours):>14} {number(exact):>14} {difference:>10}")

    print(f"{SCENE}: OpenSees {ops.version()}, time step {time_step:g} s, {DURATION:g} s")
    print(f"{'':38} {'OpenSees':>14} {'exact':>14} {'difference':>10}")
    for i, one in enumerate(STRUCTURES):
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
