"""SUNDIALS' CVODE by its own C functions, from the libraries that scikit-sundae brings.

Right-hand side, event functions and the loop from event to event are compiled by numba and call the C functions directly: a run never
enters Python, as if it were written in C. State, phases and events are those of scipy_ivp.py; extremes are roots after which a run
goes on without a restart. `adams` iterates on fixed points, `bdf` by Newton's method with a dense matrix of differences.
"""

import ctypes
import glob
import math
import os

import numpy as np
import scipy_ivp
import sksundae
from numba import carray, cfunc, njit, types
from numba.core import cgutils
from numba.extending import intrinsic

# An integer instead of a pointer keeps addresses in numba plain numbers.
ADDRESS, REAL, INT = ctypes.c_size_t, ctypes.c_double, ctypes.c_int
HOME = os.path.join(os.path.dirname(os.path.dirname(sksundae.__file__)), "scikit_sundae.libs")
ADAMS, BDF, NORMAL, ROOT_RETURN = 1, 2, 1, 2
MOST_STEPS, MOST_ROOTS = 100_000_000, 10_000
ABSOLUTE = scipy_ivp.ABSOLUTE


def library(name):
    (path,) = glob.glob(os.path.join(HOME, f"libsundials_{name}-*"))
    return ctypes.CDLL(path, mode=ctypes.RTLD_GLOBAL)


def function(home, name, result, *arguments):
    found = getattr(home, name)
    found.restype, found.argtypes = result, arguments
    return found


CORE, VECTOR, MATRIX, DENSE, CV = (
    library(name) for name in ("core", "nvecserial", "sunmatrixdense", "sunlinsoldense", "cvode")
)
create_context = function(CORE, "SUNContext_Create", INT, INT, ADDRESS)
n_vector = function(VECTOR, "N_VMake_Serial", ADDRESS, INT, ADDRESS, ADDRESS)
dense_matrix = function(MATRIX, "SUNDenseMatrix", ADDRESS, INT, INT, ADDRESS)
dense_solver = function(DENSE, "SUNLinSol_Dense", ADDRESS, ADDRESS, ADDRESS, ADDRESS)
fixed_point = function(CV, "SUNNonlinSol_FixedPoint", ADDRESS, ADDRESS, INT, ADDRESS)
create = function(CV, "CVodeCreate", ADDRESS, INT, ADDRESS)
init = function(CV, "CVodeInit", INT, ADDRESS, ADDRESS, REAL, ADDRESS)
root_init = function(CV, "CVodeRootInit", INT, ADDRESS, INT, ADDRESS)
set_user_data = function(CV, "CVodeSetUserData", INT, ADDRESS, ADDRESS)
set_max_steps = function(CV, "CVodeSetMaxNumSteps", INT, ADDRESS, ctypes.c_long)
set_stop = function(CV, "CVodeSetStopTime", INT, ADDRESS, REAL)
set_nonlinear = function(CV, "CVodeSetNonlinearSolver", INT, ADDRESS, ADDRESS)
set_linear = function(CV, "CVodeSetLinearSolver", INT, ADDRESS, ADDRESS, ADDRESS)
no_warnings = function(CV, "CVodeSetNoInactiveRootWarn", INT, ADDRESS)
# Those that the compiled loop calls.
tolerances = function(CV, "CVodeSStolerances", INT, ADDRESS, REAL, REAL)
reinit = function(CV, "CVodeReInit", INT, ADDRESS, REAL, ADDRESS)
directions = function(CV, "CVodeSetRootDirection", INT, ADDRESS, ADDRESS)
advance = function(CV, "CVode", INT, ADDRESS, REAL, ADDRESS, ADDRESS, INT)
root_info = function(CV, "CVodeGetRootInfo", INT, ADDRESS, ADDRESS)
POINTER = ctypes.c_void_p
values = function(CORE, "N_VGetArrayPointer", POINTER, POINTER)



@intrinsic
def pointer(typing_context, address):
    """The address as what `carray` takes."""

    def generate(context, builder, signature, arguments):
        return builder.inttoptr(arguments[0], cgutils.voidptr_t)

    return types.voidptr(address), generate


@njit
def numbers(vector):
    return carray(pointer(values(vector)), 5, np.float64)


# User data: ten numbers of the scene (scipy_ivp.py), phase, step of the ground, its number of samples, samples.
PHASE, STEP, COUNT, GROUND = 10, 11, 12, 13


@cfunc(types.int32(types.float64, types.voidptr, types.voidptr, types.voidptr))
def right_hand_side(t, state, slopes, data):
    y, out, p = numbers(state), numbers(slopes), carray(data, GROUND, np.float64)
    count = int(p[COUNT])
    ground = carray(data, GROUND + count, np.float64)
    place = t / p[STEP]
    index = min(int(place), count - 2)
    low, high = ground[GROUND + index], ground[GROUND + index + 1]
    acceleration = low + (place - index) * (high - low)
    push = 0.0
    phase = int(p[PHASE])
    if phase > 0:
        over = max(y[0] - y[2] - p[6], 0.0)
        root = math.sqrt(over)
        push = p[7] * over * root
        if phase == 1:
            push += 2.0 * p[8] * math.sqrt(p[7] * root * p[9]) * (y[1] - y[3])
    out[0], out[2] = y[1], y[3]
    out[1] = -acceleration - (p[2] * y[0] + p[4] * y[1] + push) / p[0]
    out[3] = -acceleration - (p[3] * y[2] + p[5] * y[3] - push) / p[1]
    out[4] = push
    return 0


@cfunc(types.int32(types.float64, types.voidptr, types.voidptr, types.voidptr))
def roots(t, state, out, data):
    y, g, p = numbers(state), carray(out, 4, np.float64), carray(data, GROUND, np.float64)
    phase = int(p[PHASE])
    # Those that mean nothing in a phase are held away from zero.
    g[0] = 1.0 if phase == 1 else y[0] - y[2] - p[6]
    g[1] = 1.0 if phase == 0 else y[1] - y[3]
    g[2], g[3] = y[1], y[3]
    return 0


@njit
def drive(memory, vector, y, data, pairs, tolerance, law, duration, found):
    """Runs a scene. `pairs` keeps, by address, the instant, the directions and the flags of roots."""
    time, wanted, flags = pairs
    phase = 0
    y[:] = 0.0
    data[PHASE] = 0.0
    peak1 = peak2 = 0.0
    time[0] = 0.0
    tolerances(memory, tolerance, ABSOLUTE * tolerance)
    wanted[0], wanted[1], wanted[2], wanted[3] = 1, 1, 0, 0
    directions(memory, wanted.ctypes.data)
    reinit(memory, 0.0, vector)
    set_stop(memory, duration)
    for _ in range(MOST_ROOTS):
        told = advance(memory, duration, vector, time.ctypes.data, NORMAL)
        if told < 0:
            return told
        peak1, peak2 = max(peak1, abs(y[0])), max(peak2, abs(y[2]))
        if told != ROOT_RETURN:
            found[0], found[1], found[2] = peak1, peak2, y[4]
            return 0
        root_info(memory, flags.ctypes.data)
        if flags[0] == 0 and flags[1] == 0:
            continue
        if phase == 0 and law == 0:
            jump = (1.0 + data[7]) * data[9] * (y[1] - y[3])
            y[1] -= jump / data[0]
            y[3] += jump / data[1]
            y[4] += jump
        elif phase == 0:
            phase = 1
        elif phase == 1:
            phase = 2
        else:
            phase = 0 if flags[0] != 0 else 1
        data[PHASE] = phase
        # A gap closes upwards and opens downwards; an approach ends downwards and begins upwards.
        wanted[0] = 1 if phase == 0 else -1
        wanted[1] = -1 if phase == 1 else 1
        directions(memory, wanted.ctypes.data)
        reinit(memory, time[0], vector)
        set_stop(memory, duration)
    return -1


class Solver:
    """CVODE with its memory, made once for a method."""

    def __init__(self, method, study):
        context = ctypes.c_size_t()
        create_context(0, ctypes.addressof(context))
        context = context.value
        self.y = np.zeros(5)
        self.data = np.concatenate([np.zeros(GROUND), study.ground])
        self.data[STEP], self.data[COUNT] = study.ground_step, len(study.ground)
        self.vector = n_vector(5, self.y.ctypes.data, context)
        self.memory = create(ADAMS if method == "adams" else BDF, context)
        init(self.memory, right_hand_side.address, 0.0, self.vector)
        tolerances(self.memory, 1e-3, 1e-6)
        set_user_data(self.memory, self.data.ctypes.data)
        set_max_steps(self.memory, MOST_STEPS)
        root_init(self.memory, 4, roots.address)
        no_warnings(self.memory)
        if method == "adams":
            set_nonlinear(self.memory, fixed_point(self.vector, 0, context))
        else:
            matrix = dense_matrix(5, 5, context)
            set_linear(self.memory, dense_solver(self.vector, matrix, context), matrix)
        self.pairs = np.zeros(1), np.zeros(4, np.int32), np.zeros(4, np.int32)

    def solve(self, tolerance, study, law, scene, found):
        reduced = scene[0] * scene[1] / (scene[0] + scene[1])
        self.data[:10] = [*scene, law.a, law.b, reduced]
        told = drive(
            self.memory, self.vector, self.y, self.data, self.pairs, tolerance, law.kind, study.duration, found
        )
        if told < 0:
            found[:] = scipy_ivp.NOTHING


SOLVERS = {}


def prepared(method, tolerance, study, law):
    if method not in SOLVERS:
        SOLVERS[method] = Solver(method, study)
    solver = SOLVERS[method]
    found = np.empty((len(law.scenes), 3))

    def run():
        for scene, out in zip(law.scenes, found):
            solver.solve(tolerance, study, law, scene, out)
        return found

    def warm():
        solver.solve(max(tolerance, 1e-3), study, law, law.scenes[0], found[0])

    return run, warm
