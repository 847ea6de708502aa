/* Pull and volume of a McKibben muscle in closed form; see mckibben.h.
 * @{facts}
 *
 * F = c0 + c1 q + c2 phi(q), q = P/supply, phi = q^2; ci polynomials of the contraction.
 * V has the same potential: dF/dP = -dV/dL. Outside of the box everything continues along its tangent.
 */
#include "mckibben.h"
#include <math.h>

typedef mckibben_real real;
#define R(x) MCKIBBEN_R(x)
#ifdef MCKIBBEN_FLOAT
#define ROOT(x) sqrtf(x)
#define STEP R(1e-7)
#else
#define ROOT(x) sqrt(x)
#define STEP R(1e-14)
#endif

/* c, dc/de and the integral of c at a contraction e. */
typedef struct {
    real c[3], slope[3], integral[3];
} coefficients;

static void at_contraction(const mckibben_muscle *m, real e, coefficients *k)
{
    const real inside = e < m->low ? m->low : (e > m->high ? m->high : e);
    const real beyond = e - inside, s = inside < R(0) ? -inside : R(0);
    for (int i = 0; i < 3; i++) {
        real c = R(0), slope = R(0), integral = R(0);
        const real b0 = m->b[i][0], b1 = m->b[i][1];
        for (int j = 5; j >= 0; j--) {
            slope = slope * inside + c;
            c = c * inside + m->a[i][j];
            integral = integral * inside + m->a[i][j] / (real)(j + 1);
        }
        c += s * s * (b0 + b1 * s);
        slope -= s * (R(2) * b0 + R(3) * b1 * s);
        integral = integral * inside - s * s * s * (b0 / R(3) + b1 * s / R(4));
        k->integral[i] = integral + beyond * (c + R(0.5) * slope * beyond);
        k->c[i] = c + slope * beyond;
        k->slope[i] = slope;
    }
}

/* phi and dphi/dq. */
static real squared(real q, real *slope)
{
    *slope = q <= R(0) ? R(0) : (q <= R(1) ? R(2) * q : R(2));
    return q <= R(0) ? R(0) : (q <= R(1) ? q * q : R(2) * q - R(1));
}

static real two_sided(const mckibben_muscle *m, const real c[3], real pressure)
{
    real slope;
    const real q = pressure / m->supply, phi = squared(q, &slope);
    return c[0] + c[1] * q + c[2] * phi;
}

static unsigned outside(const mckibben_muscle *m, real pressure, real e)
{
    return (pressure >= R(0) && pressure <= m->supply ? 0u : MCKIBBEN_PRESSURE_OUTSIDE)
         | (e >= m->low && e <= m->high ? 0u : MCKIBBEN_CONTRACTION_OUTSIDE);
}

real mckibben_force(const mckibben_muscle *m, real pressure, real length, unsigned *status)
{
    coefficients k;
    const real e = R(1) - length / m->length;
    at_contraction(m, e, &k);
    const real force = two_sided(m, k.c, pressure);
    if (status)
        *status = outside(m, pressure, e) | (force <= R(0) ? MCKIBBEN_SLACK : 0u);
    return force <= R(0) ? R(0) : force;
}

real mckibben_stiffness(const mckibben_muscle *m, real pressure, real length)
{
    coefficients k;
    at_contraction(m, R(1) - length / m->length, &k);
    return two_sided(m, k.c, pressure) <= R(0) ? R(0) : -two_sided(m, k.slope, pressure) / m->length;
}

real mckibben_force_per_pressure(const mckibben_muscle *m, real pressure, real length)
{
    coefficients k;
    real slope;
    at_contraction(m, R(1) - length / m->length, &k);
    (void)squared(pressure / m->supply, &slope);
    return two_sided(m, k.c, pressure) <= R(0) ? R(0) : (k.c[1] + k.c[2] * slope) / m->supply;
}

real mckibben_contraction(const mckibben_muscle *m, real force, real pressure)
{
    coefficients k;
    real low = m->low, high = m->high, pull, slope, at;
    at_contraction(m, low, &k);
    pull = two_sided(m, k.c, pressure);
    slope = two_sided(m, k.slope, pressure);
    if (force >= pull)
        return slope < R(0) ? low + (force - pull) / slope : low;
    at_contraction(m, high, &k);
    pull = two_sided(m, k.c, pressure);
    slope = two_sided(m, k.slope, pressure);
    if (force <= pull)
        return slope < R(0) ? high + (force - pull) / slope : high;
    at = R(0.5) * (low + high);
    for (int i = 0; i < 60; i++) {
        real miss, next, step;
        at_contraction(m, at, &k);
        miss = two_sided(m, k.c, pressure) - force;
        slope = two_sided(m, k.slope, pressure);
        if (miss > R(0))
            low = at;
        else
            high = at;
        next = slope < R(0) || slope > R(0) ? at - miss / slope : low;
        if (!(next > low && next < high))
            next = R(0.5) * (low + high);
        step = next - at;
        at = next;
        if (step <= STEP && step >= -STEP)
            break;
    }
    return at;
}

real mckibben_volume(const mckibben_muscle *m, real pressure, real length)
{
    coefficients k;
    real slope;
    const real q = pressure / m->supply, phi = squared(q, &slope);
    at_contraction(m, R(1) - length / m->length, &k);
    if (two_sided(m, k.c, pressure) <= R(0)) /* slack: it hangs at its free contraction */
        at_contraction(m, mckibben_contraction(m, R(0), pressure), &k);
    return m->v[0] + m->v[1] * q + m->v[2] * phi + m->length / m->supply * (k.integral[1] + k.integral[2] * slope);
}

real mckibben_pressure(const mckibben_muscle *m, real force, real length, unsigned *status)
{
    coefficients k;
    unsigned ignored;
    const real e = R(1) - length / m->length;
    real missing, root, below, slope;
    if (!status)
        status = &ignored;
    at_contraction(m, e, &k);
    *status = outside(m, R(0), e);
    missing = force - k.c[0];
    if (missing <= R(0)) { /* it pulls as much without pressure */
        if (missing < R(0))
            *status |= MCKIBBEN_NO_ANSWER;
        return R(0);
    }
    root = k.c[1] * k.c[1] + R(4) * k.c[2] * missing;
    below = root > R(0) ? k.c[1] + ROOT(root) : R(0);
    if (below > R(0) && R(2) * missing <= below)
        return R(2) * missing / below * m->supply;
    slope = k.c[1] + R(2) * k.c[2];
    if (slope > R(0) && missing + k.c[2] >= slope) {
        *status |= MCKIBBEN_PRESSURE_OUTSIDE;
        return (missing + k.c[2]) / slope * m->supply;
    }
    *status |= MCKIBBEN_NO_ANSWER;
    return m->supply;
}

real mckibben_friction(const mckibben_muscle *m, real pressure, real velocity, real smoothing)
{
    const real q = pressure > R(0) ? pressure / m->supply : R(0);
    const real size = ROOT(velocity * velocity + smoothing * smoothing);
    return size > R(0) ? (m->friction[0] * ROOT(q) + m->friction[1] * q) * velocity / size : R(0);
}
