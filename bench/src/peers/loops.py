"""Loops of a few lines in numba: what somebody writes by hand for two elastic structures and one pair.

Numbers of a scene: masses, stiffnesses and dampings of both, gap. `ground` has the acceleration at every node, and for the
Runge-Kutta method half way between nodes as well. Law: 0 is impact with restitution, a = e; 1 is the nonlinear viscoelastic
element, a = beta, b = xi. Impacts make velocities jump after the step that finds the gap closed. Every loop runs all scenes in one
call and leaves peak displacements and impulses.
"""

import numpy as np
from numba import njit

import exchange


@njit
def pounding_force(overlap, rate, stiffness, ratio, reduced):
    if overlap <= 0.0:
        return 0.0
    root = np.sqrt(overlap)
    force = stiffness * overlap * root
    if rate > 0.0:
        force += 2.0 * ratio * np.sqrt(stiffness * root * reduced) * rate
    return force


@njit
def central_difference(scenes, ground, dt, law, a, b, found):
    for scene in range(len(scenes)):
        m1, m2, k1, k2, c1, c2, gap = scenes[scene]
        reduced = m1 * m2 / (m1 + m2)
        i1, i2 = 1.0 / m1, 1.0 / m2
        inertia = 1.0 / (dt * dt)
        h1, h2 = 0.5 * c1 * i1 / dt, 0.5 * c2 * i2 / dt
        solve1, solve2 = 1.0 / (inertia + h1), 1.0 / (inertia + h2)
        carry1, carry2 = inertia - h1, inertia - h2
        u1 = u2 = peak1 = peak2 = impulse = before = 0.0
        d1 = d2 = 0.5 * dt * dt * ground[0]
        for acceleration in ground:
            overlap = u1 - u2 - gap
            peak1, peak2 = max(peak1, abs(u1)), max(peak2, abs(u2))
            force = 0.0
            if law == 1 and overlap > 0.0:
                force = pounding_force(overlap, (d1 - d2) / dt, a, b, reduced)
            if law == 1:
                impulse += 0.5 * dt * (before + force)
                before = force
            n1 = solve1 * (carry1 * d1 - acceleration - i1 * (k1 * u1 + force))
            n2 = solve2 * (carry2 * d2 - acceleration - i2 * (k2 * u2 - force))
            if law == 0 and overlap >= 0.0:
                v1, v2 = (n1 + d1) / (2.0 * dt), (n2 + d2) / (2.0 * dt)
                if v1 > v2:
                    jump = (1.0 + a) * reduced * (v1 - v2)
                    impulse += jump
                    v1, v2 = v1 - jump * i1, v2 + jump * i2
                    n1 = dt * (v1 - 0.5 * dt * (i1 * (c1 * v1 + k1 * u1) + acceleration))
                    n2 = dt * (v2 - 0.5 * dt * (i2 * (c2 * v2 + k2 * u2) + acceleration))
            d1, d2 = n1, n2
            u1, u2 = u1 + d1, u2 + d2
        found[scene] = peak1, peak2, impulse


@njit
def velocity_verlet(scenes, ground, dt, law, a, b, found):
    for scene in range(len(scenes)):
        m1, m2, k1, k2, c1, c2, gap = scenes[scene]
        reduced = m1 * m2 / (m1 + m2)
        i1, i2 = 1.0 / m1, 1.0 / m2
        # Damping half-implicit, so that the limit of the time step is that without damping.
        s1, s2 = 1.0 / (1.0 + 0.5 * dt * c1 * i1), 1.0 / (1.0 + 0.5 * dt * c2 * i2)
        u1 = u2 = v1 = v2 = peak1 = peak2 = impulse = force = 0.0
        a1 = a2 = -ground[0]
        for node in range(1, len(ground)):
            u1 += dt * (v1 + 0.5 * dt * a1)
            u2 += dt * (v2 + 0.5 * dt * a2)
            peak1, peak2 = max(peak1, abs(u1)), max(peak2, abs(u2))
            overlap = u1 - u2 - gap
            if law == 1:
                before = force
                rate = v1 - v2 + dt * (a1 - a2)
                force = pounding_force(overlap, rate, a, b, reduced)
                impulse += 0.5 * dt * (before + force)
            half1, half2 = v1 + 0.5 * dt * a1, v2 + 0.5 * dt * a2
            a1 = s1 * (-ground[node] - i1 * (k1 * u1 + c1 * half1 + force))
            a2 = s2 * (-ground[node] - i2 * (k2 * u2 + c2 * half2 - force))
            v1, v2 = half1 + 0.5 * dt * a1, half2 + 0.5 * dt * a2
            if law == 0 and overlap >= 0.0 and v1 > v2:
                jump = (1.0 + a) * reduced * (v1 - v2)
                impulse += jump
                v1, v2 = v1 - jump * i1, v2 + jump * i2
                a1 = -ground[node] - i1 * (k1 * u1 + c1 * v1)
                a2 = -ground[node] - i2 * (k2 * u2 + c2 * v2)
        found[scene] = peak1, peak2, impulse


@njit
def rk4(scenes, ground, dt, law, a, b, found):
    for scene in range(len(scenes)):
        m1, m2, k1, k2, c1, c2, gap = scenes[scene]
        reduced = m1 * m2 / (m1 + m2)
        i1, i2 = 1.0 / m1, 1.0 / m2
        u1 = u2 = v1 = v2 = peak1 = peak2 = impulse = 0.0
        for node in range((len(ground) - 1) // 2):
            su1 = su2 = sv1 = sv2 = sf = 0.0
            p1, p2, q1, q2 = u1, u2, v1, v2
            for stage in range(4):
                acceleration = ground[2 * node + (stage + 1) // 2]
                force = 0.0
                if law == 1:
                    force = pounding_force(p1 - p2 - gap, q1 - q2, a, b, reduced)
                a1 = -acceleration - i1 * (k1 * p1 + c1 * q1 + force)
                a2 = -acceleration - i2 * (k2 * p2 + c2 * q2 - force)
                weight = 1.0 if stage == 0 or stage == 3 else 2.0
                su1, su2 = su1 + weight * q1, su2 + weight * q2
                sv1, sv2 = sv1 + weight * a1, sv2 + weight * a2
                sf += weight * force
                part = 0.5 * dt if stage < 2 else dt
                p1, p2 = u1 + part * q1, u2 + part * q2
                q1, q2 = v1 + part * a1, v2 + part * a2
            u1, u2 = u1 + dt / 6.0 * su1, u2 + dt / 6.0 * su2
            v1, v2 = v1 + dt / 6.0 * sv1, v2 + dt / 6.0 * sv2
            impulse += dt / 6.0 * sf
            peak1, peak2 = max(peak1, abs(u1)), max(peak2, abs(u2))
            if law == 0 and u1 - u2 - gap >= 0.0 and v1 > v2:
                jump = (1.0 + a) * reduced * (v1 - v2)
                impulse += jump
                v1, v2 = v1 - jump * i1, v2 + jump * i2
        found[scene] = peak1, peak2, impulse


METHODS = {
    "central_difference": (central_difference, 1),
    "velocity_verlet": (velocity_verlet, 1),
    "rk4": (rk4, 2),
}


def prepared(method, dt, study, law):
    """A function without arguments that runs all scenes; the ground is sampled beforehand."""
    loop, per_step = METHODS[method]
    ground = exchange.sampled(study, dt / per_step)
    found = np.empty((len(law.scenes), 3))

    def run():
        loop(law.scenes, ground, dt, law.kind, law.a, law.b, found)
        return found

    return run, run
