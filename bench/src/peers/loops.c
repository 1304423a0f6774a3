/* The central difference loop of loops.py in C: same arithmetic, same arguments. */

#include <math.h>
#include <stddef.h>

void central_difference(const double *scenes, size_t n_scenes, const double *ground, size_t n, double dt, int law,
                        double a, double b, double *found)
{
    for (size_t scene = 0; scene < n_scenes; scene++) {
        const double *s = scenes + 7 * scene;
        const double m1 = s[0], m2 = s[1], k1 = s[2], k2 = s[3], c1 = s[4], c2 = s[5], gap = s[6];
        const double reduced = m1 * m2 / (m1 + m2), i1 = 1.0 / m1, i2 = 1.0 / m2;
        const double inertia = 1.0 / (dt * dt), h1 = 0.5 * c1 * i1 / dt, h2 = 0.5 * c2 * i2 / dt;
        const double solve1 = 1.0 / (inertia + h1), solve2 = 1.0 / (inertia + h2);
        const double carry1 = inertia - h1, carry2 = inertia - h2;
        double u1 = 0.0, u2 = 0.0, peak1 = 0.0, peak2 = 0.0, impulse = 0.0, before = 0.0;
        double d1 = 0.5 * dt * dt * ground[0], d2 = d1;
        for (size_t node = 0; node < n; node++) {
            const double acceleration = ground[node], overlap = u1 - u2 - gap;
            const double size1 = fabs(u1), size2 = fabs(u2);
            peak1 = size1 > peak1 ? size1 : peak1;
            peak2 = size2 > peak2 ? size2 : peak2;
            double force = 0.0;
            if (law == 1) {
                if (overlap > 0.0) {
                    const double root = sqrt(overlap), rate = (d1 - d2) / dt;
                    force = a * overlap * root;
                    if (rate > 0.0)
                        force += 2.0 * b * sqrt(a * root * reduced) * rate;
                }
                impulse += 0.5 * dt * (before + force);
                before = force;
            }
            double n1 = solve1 * (carry1 * d1 - acceleration - i1 * (k1 * u1 + force));
            double n2 = solve2 * (carry2 * d2 - acceleration - i2 * (k2 * u2 - force));
            if (law == 0 && overlap >= 0.0) {
                double v1 = (n1 + d1) / (2.0 * dt), v2 = (n2 + d2) / (2.0 * dt);
                if (v1 > v2) {
                    const double jump = (1.0 + a) * reduced * (v1 - v2);
                    impulse += jump;
                    v1 -= jump * i1;
                    v2 += jump * i2;
                    n1 = dt * (v1 - 0.5 * dt * (i1 * (c1 * v1 + k1 * u1) + acceleration));
                    n2 = dt * (v2 - 0.5 * dt * (i2 * (c2 * v2 + k2 * u2) + acceleration));
                }
            }
            d1 = n1;
            d2 = n2;
            u1 += d1;
            u2 += d2;
        }
        found[3 * scene] = peak1;
        found[3 * scene + 1] = peak2;
        found[3 * scene + 2] = impulse;
    }
}
