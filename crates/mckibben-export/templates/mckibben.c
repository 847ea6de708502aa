/* Pull and volume of a McKibben muscle in closed form; see mckibben.h.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
 *
 * F = c0 + c1 q + c2 phi0(q) + c3 phi1(q) + c4 phi2(q), q = P/supply, phik = max(q - knot, 0)^2; c: cubic splines in the contraction.
 * V has the same potential: dF/dP = -dV/dL.
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

#define N MCKIBBEN_FUNCTIONS

/* Where the functions of the pressure of second degree begin; the last part ends at the supply. */
static const real knots[4] = {R(0), R(0.15), R(0.45), R(1)};

/* c and dc/de at a contraction, the functions of the pressure and their slopes; n, t and h: the part between two nodes, the place in it, and how
 * long it is. */
typedef struct {
    real c[N], slope[N], phi[N], by_q[N];
    real t, h, beyond;
    int n;
} coefficients;

/* The nearest number from `low` to `high`; `low` of what is not a number. */
static real within(real value, real low, real high) { return value > high ? high : (value >= low ? value : low); }

static void at_contraction(const mckibben_muscle *m, real e, coefficients *k)
{
    const real inside = within(e, m->node[0], m->node[m->nodes - 1]);
    int n = 0;
    while (n < m->nodes - 2 && inside >= m->node[n + 1])
        n++;
    const real h = m->node[n + 1] - m->node[n], t = (inside - m->node[n]) / h, s = R(1) - t;
    const real v[4] = {(R(1) + R(2) * t) * s * s, h * t * s * s, t * t * (R(3) - R(2) * t), -h * t * t * s};
    const real d[4] = {R(-6) * t * s / h, s * (R(1) - R(3) * t), R(6) * t * s / h, t * (R(3) * t - R(2))};
    k->n = n;
    k->t = t;
    k->h = h;
    k->beyond = m->beyond && e - e <= R(0) ? e - inside : R(0);
    for (int i = 0; i < N; i++) {
        const real *a = &m->a[i][n], *b = &m->b[i][n];
        k->slope[i] = d[0] * a[0] + d[1] * b[0] + d[2] * a[1] + d[3] * b[1];
        k->c[i] = v[0] * a[0] + v[1] * b[0] + v[2] * a[1] + v[3] * b[1] + k->slope[i] * k->beyond;
    }
}

/* The integral of a c from the lower end of the box. */
static real integral(const mckibben_muscle *m, const coefficients *k, int i)
{
    real sum = k->beyond * (k->c[i] - R(0.5) * k->slope[i] * k->beyond);
    for (int n = 0; n <= k->n; n++) {
        const real *a = &m->a[i][n], *b = &m->b[i][n];
        const real t = n < k->n ? R(1) : k->t, h = n < k->n ? m->node[n + 1] - m->node[n] : k->h, s3 = t * t * t, s4 = t * t * t * t;
        sum += h * (t - s3 + R(0.5) * s4) * a[0] + h * h * (R(0.5) * t * t - R(2) / R(3) * s3 + R(0.25) * s4) * b[0] + h * (s3 - R(0.5) * s4) * a[1]
             + h * h * (R(0.25) * s4 - s3 / R(3)) * b[1];
    }
    return sum;
}

/* The functions of the pressure, and their slopes. */
static void functions(real q, real phi[N], real slope[N])
{
    phi[0] = slope[1] = R(1);
    phi[1] = q;
    slope[0] = R(0);
    for (int i = 2; i < N; i++) {
        const real knot = knots[i - 2], width = R(1) - knot;
        const real t = q <= knot ? R(0) : (q <= R(1) ? q - knot : width);
        phi[i] = t * (t + (q > R(1) ? R(2) * (q - R(1)) : R(0)));
        slope[i] = R(2) * t;
    }
}

static real sum_of(const real c[N], const real phi[N])
{
    real sum = R(0);
    for (int i = 0; i < N; i++)
        sum += c[i] * phi[i];
    return sum;
}

static real contraction_of(const mckibben_muscle *m, real length) { return R(1) - (length - m->cord) / m->length; }

static unsigned outside(const mckibben_muscle *m, real pressure, real e)
{
    return (pressure >= R(0) && pressure <= m->supply ? 0u : MCKIBBEN_PRESSURE_OUTSIDE)
         | (e >= m->node[0] && e <= m->node[m->nodes - 1] ? 0u : MCKIBBEN_CONTRACTION_OUTSIDE);
}

/* The pull, negative where the muscle would have to push. */
static real two_sided(const mckibben_muscle *m, real pressure, real e, coefficients *k, unsigned *status)
{
    const real q = pressure / m->supply;
    real pull;
    functions(m->beyond && q - q <= R(0) ? q : within(q, R(0), R(1)), k->phi, k->by_q);
    at_contraction(m, e, k);
    pull = sum_of(k->c, k->phi);
    if (status)
        *status = outside(m, pressure, e) | (pull <= R(0) ? MCKIBBEN_SLACK : 0u);
    return pull;
}

real mckibben_force(const mckibben_muscle *m, real pressure, real length, unsigned *status)
{
    coefficients k;
    const real force = two_sided(m, pressure, contraction_of(m, length), &k, status);
    return force <= R(0) ? R(0) : force;
}

real mckibben_stiffness(const mckibben_muscle *m, real pressure, real length, unsigned *status)
{
    coefficients k;
    return two_sided(m, pressure, contraction_of(m, length), &k, status) <= R(0) ? R(0) : -sum_of(k.slope, k.phi) / m->length;
}

real mckibben_force_per_pressure(const mckibben_muscle *m, real pressure, real length, unsigned *status)
{
    coefficients k;
    return two_sided(m, pressure, contraction_of(m, length), &k, status) <= R(0) ? R(0) : sum_of(k.c, k.by_q) / m->supply;
}

real mckibben_contraction(const mckibben_muscle *m, real force, real pressure, unsigned *status)
{
    coefficients k;
    real low = m->node[0], high = m->node[m->nodes - 1], next = R(0.5) * (low + high), at, miss, slope;
    unsigned found = outside(m, pressure, low) | (force >= R(0) ? 0u : MCKIBBEN_NO_ANSWER);
    int i = 0;
    if (force < R(0))
        force = R(0);
    do {
        at = next;
        miss = two_sided(m, pressure, at, &k, 0) - force;
        slope = sum_of(k.slope, k.phi);
        if (miss > R(0))
            low = at;
        else
            high = at;
        next = at - miss / (slope < R(0) ? slope : R(-1));
        if (!(next > low && next < high))
            next = R(0.5) * (low + high);
    } while (++i < 60 && (next - at > STEP || at - next > STEP));
    if (!(miss <= R(-1e-3) * slope && miss >= R(1e-3) * slope)) /* an end of the box, and more than a thousandth from the answer */
        found |= MCKIBBEN_NO_ANSWER;
    if (m->beyond && slope < R(0))
        next = at - miss / slope;
    if (status)
        *status = found;
    return next;
}

real mckibben_volume(const mckibben_muscle *m, real pressure, real length, unsigned *status)
{
    coefficients k;
    const int slack = m->a[0][0] < R(0); /* without pressure, at the lower end of the box: its volume is nowhere that of a longer muscle */
    const real e = contraction_of(m, length), low = m->node[0];
    real sum = R(0), free, pull = two_sided(m, pressure, e, &k, status);
    if (slack && e < low)
        pull = two_sided(m, pressure, low, &k, 0);
    if (pull <= R(0)) { /* slack: it hangs at its free contraction */
        free = mckibben_contraction(m, R(0), pressure, 0);
        at_contraction(m, slack && free < low ? low : free, &k);
    }
    for (int i = 1; i < N; i++)
        sum += integral(m, &k, i) * k.by_q[i];
    return sum_of(m->v, k.phi) + m->length / m->supply * sum;
}

real mckibben_pressure(const mckibben_muscle *m, real force, real length, unsigned *status)
{
    coefficients k;
    unsigned ignored;
    const real e = contraction_of(m, length);
    real pull, slope, curve = R(0);
    if (!status)
        status = &ignored;
    at_contraction(m, e, &k);
    pull = k.c[0];
    slope = k.c[1];
    *status = outside(m, R(0), e) | (force >= R(0) && force >= pull ? 0u : MCKIBBEN_NO_ANSWER);
    if ((*status & MCKIBBEN_NO_ANSWER) || force <= pull) /* also what is not a number */
        return R(0);
    for (int i = 0; i < 3; i++) { /* between two knots the pull is of second degree in the pressure */
        const real width = knots[i + 1] - knots[i], missing = force > pull ? force - pull : R(0);
        real root, below;
        curve += k.c[i + 2];
        root = slope * slope + R(4) * curve * missing;
        below = root > R(0) ? slope + ROOT(root) : R(0);
        if (below > R(0) && R(2) * missing < below * width)
            return (knots[i] + R(2) * missing / below) * m->supply;
        pull += width * (slope + curve * width);
        slope += R(2) * curve * width;
    }
    if (!(force <= R(1.000001) * pull)) /* within a millionth the supply gives its own pull */
        *status |= MCKIBBEN_NO_ANSWER;
    return m->supply;
}

real mckibben_friction(const mckibben_muscle *m, real pressure, real length, real velocity, real smoothing, unsigned *status)
{
    coefficients k;
    const real pull = two_sided(m, pressure, contraction_of(m, length), &k, status);
    const real size = ROOT(velocity * velocity + smoothing * smoothing);
    const real share = size > R(0) && size - size <= R(0) ? velocity / size : R(0);
    const real moving = pull + mckibben_friction_limit(m, pressure, length) * share;
    return (moving > R(0) ? moving : R(0)) - (pull > R(0) ? pull : R(0));
}
