"""SciPy's solve_ivp from event to event; right-hand sides and event functions compiled by numba.

State: displacement and velocity of both structures, and the impulse of the pair. Phases: 0 apart, 1 approaching in contact, 2 parting
in contact. A phase ends at an event, so that the right-hand side is smooth in it but for the corners of the record, which the step
control has to find: a restart at all 500 of them would cost more. Extremes of the displacements are events too (velocities
change sign), the only way to know them as exactly as the solution.
"""

import numpy as np
from numba import njit
from scipy.integrate import solve_ivp

ABSOLUTE = 1e-2  # Absolute over relative tolerance: displacements are centimetres, velocities decimetres per second.


@njit
def force(y, p, phase):
    overlap = max(y[0] - y[2] - p[6], 0.0)
    root = np.sqrt(overlap)
    spring = p[7] * overlap * root
    if phase == 2:
        return spring
    return spring + 2.0 * p[8] * np.sqrt(p[7] * root * p[9]) * (y[1] - y[3])


@njit
def slope(t, y, p, phase, ground, step):
    place = t / step
    index = min(int(place), len(ground) - 2)
    part = place - index
    acceleration = ground[index] + part * (ground[index + 1] - ground[index])
    push = force(y, p, phase) if phase > 0 else 0.0
    out = np.empty(5)
    out[0], out[2] = y[1], y[3]
    out[1] = -acceleration - (p[2] * y[0] + p[4] * y[1] + push) / p[0]
    out[3] = -acceleration - (p[3] * y[2] + p[5] * y[3] - push) / p[1]
    out[4] = push
    return out


@njit
def overlap(t, y, p, phase, ground, step):
    return y[0] - y[2] - p[6]


@njit
def rate(t, y, p, phase, ground, step):
    return y[1] - y[3]


@njit
def left(t, y, p, phase, ground, step):
    return y[1]


@njit
def right(t, y, p, phase, ground, step):
    return y[3]


def event(function, direction=0.0, terminal=False):
    def called(*arguments):
        return function(*arguments)

    called.direction, called.terminal = direction, terminal
    return called


EXTREMES = [event(left), event(right)]
TOUCH, PART = event(overlap, 1.0, True), event(overlap, -1.0, True)
TURN, RETURN = event(rate, -1.0, True), event(rate, 1.0, True)
EVENTS = [[TOUCH], [TURN], [PART, RETURN]]
# A scene has some tens of phases. With a loose tolerance a root may be found again where a phase began, for ever.
MOST_PHASES = 1000
NOTHING = (np.nan, np.nan, np.nan)


def solve(method, tolerance, study, law, scene):
    p = np.array([*scene, law.a, law.b, scene[0] * scene[1] / (scene[0] + scene[1])])
    t, y, phase = 0.0, np.zeros(5), 0
    peaks = np.zeros(2)
    for _ in range(MOST_PHASES):
        events = EVENTS[phase] + EXTREMES
        solution = solve_ivp(
            slope, (t, study.duration), y, method, events=events, rtol=tolerance, atol=ABSOLUTE * tolerance,
            args=(p, phase, study.ground, study.ground_step),
        )
        if solution.status < 0:
            return NOTHING
        for extreme in solution.y_events[-2:]:
            if len(extreme):
                peaks = np.maximum(peaks, np.abs(extreme[:, 0:3:2]).max(axis=0))
        t, y = solution.t[-1], solution.y[:, -1].copy()
        peaks = np.maximum(peaks, np.abs(y[0:3:2]))
        if solution.status == 0:
            return (*peaks, y[4])
        if phase == 0 and law.kind == 0:
            jump = (1.0 + law.a) * p[9] * (y[1] - y[3])
            y += np.array([0.0, -jump / p[0], 0.0, jump / p[1], jump])
        elif phase == 0:
            phase = 1
        elif phase == 1:
            phase = 2
        else:
            phase = 0 if len(solution.t_events[0]) else 1
    return NOTHING


def prepared(method, tolerance, study, law):
    def run():
        return [solve(method, tolerance, study, law, scene) for scene in law.scenes]

    return run, lambda: solve(method, max(tolerance, 1e-3), study, law, law.scenes[0])
