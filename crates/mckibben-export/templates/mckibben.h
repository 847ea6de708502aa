/* McKibben muscles and joints in closed form: pull, volume and their inverses, friction with memory, torque. C99; no heap; of the C library only sqrt,
 * of joints sin and cos.
 * Made by mckibben @{version}; the same for all muscles and joints.
 *
 * Units: Pa (gauge), m, N, m3. All numbers are float with -DMCKIBBEN_FLOAT, and on an Arm core whose floating-point unit has single precision alone
 * (Cortex-M4F): there double is computed by software. Otherwise, and with -DMCKIBBEN_DOUBLE, they are double.
 * Licence: MIT OR Apache-2.0.
 */
#ifndef MCKIBBEN_H
#define MCKIBBEN_H

#include <math.h>

#ifdef __cplusplus
extern "C" {
#endif

#if !defined(MCKIBBEN_FLOAT) && !defined(MCKIBBEN_DOUBLE) && defined(__ARM_FP)
#if !(__ARM_FP & 8) /* no unit of double precision */
#define MCKIBBEN_FLOAT
#endif
#endif
#ifdef MCKIBBEN_FLOAT
typedef float mckibben_real;
#else
typedef double mckibben_real;
#endif
#define MCKIBBEN_R(x) ((mckibben_real)(x))
#ifdef MCKIBBEN_FLOAT
#define MCKIBBEN_MATH(name) name##f
#else
#define MCKIBBEN_MATH(name) name
#endif

/* Outside of the box each answer is that of its nearest point; what is not a number counts as the lower end. */
/* What a status says: a sum of these. */
#define MCKIBBEN_OK 0u
#define MCKIBBEN_SLACK 1u               /* the muscle would have to push: it is slack */
#define MCKIBBEN_PRESSURE_OUTSIDE 2u    /* outside of the box, or not a number */
#define MCKIBBEN_CONTRACTION_OUTSIDE 4u
#define MCKIBBEN_NO_ANSWER 8u           /* nothing in the box gives this pull: the answer is the nearest end of the box */
#define MCKIBBEN_ANGLE_OUTSIDE 16u      /* of a joint: outside of its range */

/* Functions of the pressure, and the largest number of nodes. */
#define MCKIBBEN_FUNCTIONS 5
#define MCKIBBEN_NODES 10

typedef struct {
    mckibben_real length; /* L0, at rest, m */
    mckibben_real cord;   /* m: a rope or rod between the muscle and what it pulls; the `length` of each function is that of both */
    mckibben_real supply; /* upper end of the box, Pa */
    mckibben_real allowed, least_burst; /* Pa: no pressure in use is above the first; the second 0 where it is not known */
    int nodes;            /* how many there are; the first and the last are the ends of the box */
    mckibben_real node[MCKIBBEN_NODES];                  /* contractions 1 - L/L0 */
    mckibben_real a[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES]; /* N; functions of the contraction, at the nodes */
    mckibben_real b[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES]; /* N; their slopes */
    mckibben_real v[MCKIBBEN_FUNCTIONS];                 /* m3 */
    mckibben_real friction[7]; /* half the hysteresis is (f0 + f1 e + f2 e^2) sqrt(q) + (f3 + f4 e + f5 e^2) q in N, e the contraction; it builds up over f6 in m */
    int beyond; /* for simulators: 1 continues pull and volume outside of the box along their tangents, with one potential; 0 does not */
} mckibben_muscle;

/* Each says by `status`, which may be 0, whether its answer can be used. */
/* Pull F in N at a pressure and a length. */
mckibben_real mckibben_force(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length, unsigned *status);
/* dF/dL at constant pressure, N/m. */
mckibben_real mckibben_stiffness(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length, unsigned *status);
/* dF/dP at constant length, m2. */
mckibben_real mckibben_force_per_pressure(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length, unsigned *status);
/* Volume of the cavity, m3. */
mckibben_real mckibben_volume(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length, unsigned *status);
/* Pressure at which the muscle pulls with `force` at a length; closed form. 0 where it pulls more without pressure, where it would have to push, and of what
 * is not a number. */
mckibben_real mckibben_pressure(const mckibben_muscle *m, mckibben_real force, mckibben_real length, unsigned *status);
/* Contraction 1 - L/L0 at which the muscle pulls with `force` at a pressure; the lower end of the box of what is not a number. */
mckibben_real mckibben_contraction(const mckibben_muscle *m, mckibben_real force, mckibben_real pressure, unsigned *status);
/* What friction adds to the pull while the length changes by `velocity` in m/s (positive: longer); smooth at rest over `smoothing` in m/s, 0 at one that is not finite. With it
 * the muscle pulls or is slack: it never pushes. */
mckibben_real mckibben_friction(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length, mckibben_real velocity, mckibben_real smoothing,
                                unsigned *status);

/* The muscle with its pull and its friction multiplied, to explore their uncertainty: all coefficients, so that pull and volume keep one potential. */
static inline mckibben_muscle mckibben_scaled(const mckibben_muscle *m, mckibben_real force_factor, mckibben_real friction_factor)
{
    mckibben_muscle scaled = *m;
    for (int i = 0; i < MCKIBBEN_FUNCTIONS; i++) {
        for (int j = 0; j < MCKIBBEN_NODES; j++) {
            scaled.a[i][j] *= force_factor;
            scaled.b[i][j] *= force_factor;
        }
    }
    for (int i = 0; i < 6; i++)
        scaled.friction[i] *= friction_factor;
    return scaled;
}

/* Half the hysteresis at a pressure and a length, N. */
static inline mckibben_real mckibben_friction_limit(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length)
{
    const mckibben_real *f = m->friction, low = m->node[0], high = m->node[m->nodes - 1];
    mckibben_real q = pressure / m->supply, e = MCKIBBEN_R(1) - (length - m->cord) / m->length, half;
    q = q > MCKIBBEN_R(0) ? q : MCKIBBEN_R(0);
    q = q > MCKIBBEN_R(1) && !(m->beyond && q - q <= MCKIBBEN_R(0)) ? MCKIBBEN_R(1) : q;
    e = e > high ? high : (e >= low ? e : low);
    half = (f[0] + e * (f[1] + e * f[2])) * (mckibben_real)sqrt((double)q) + (f[3] + e * (f[4] + e * f[5])) * q;
    return half > MCKIBBEN_R(0) ? half : MCKIBBEN_R(0);
}

/* Pressure at which the muscle pulls with `force` at a length while it shortens (branch -1), while it lengthens (1), or in the mean of both (0):
 * 40 halvings. The supply and MCKIBBEN_NO_ANSWER where the supply is too low for it; `status` may be 0. */
static inline mckibben_real mckibben_pressure_on(const mckibben_muscle *m, mckibben_real force, mckibben_real length, int branch, unsigned *status)
{
    unsigned found;
    const mckibben_real mean = mckibben_pressure(m, force, length, &found);
    mckibben_real low = MCKIBBEN_R(0), high = m->supply, middle = high;
    /* Without pressure there is no friction: what has no answer there has none on a branch. */
    if (branch == 0 || ((found & MCKIBBEN_NO_ANSWER) && mean <= MCKIBBEN_R(0))) {
        high = mean;
    } else {
        found |= MCKIBBEN_NO_ANSWER;
        for (int i = 0; i < 41; i++, middle = MCKIBBEN_R(0.5) * (low + high)) {
            const mckibben_real friction = mckibben_friction(m, middle, length, (mckibben_real)branch, MCKIBBEN_R(0), 0);
            if (mckibben_force(m, middle, length, 0) + friction < force) {
                low = middle;
            } else {
                high = middle;
                found &= ~MCKIBBEN_NO_ANSWER;
            }
        }
    }
    if (status)
        *status = found;
    return high;
}

/* Friction with memory.
 *
 * Elements that stick and slip in parallel, all of one stiffness 2 Fm/f2, their yields spread evenly (Iwan):
 *
 *     friction = integral of s(w) from w = 0 to 1,   |s(w)| <= 2 w Fc,   ds = (2 Fm/f6) dL where an element sticks
 *
 * Fc is half the hysteresis at the pressure and length of now, Fm the largest so far, f6 the length over which friction builds up. An element slips where its
 * limit is reached, by its way or because Fc falls; its stiffness does not fall. So no closed cycle of length and pressure gives work. Minor loops
 * close, at any speed.
 */

/* s(w) is a chain of straight lines, whose ends are remembered; of more ends that of the least bend is forgotten, and at once where there is none. */
#define MCKIBBEN_ENDS 32
#ifdef MCKIBBEN_FLOAT
#define MCKIBBEN_STRAIGHT MCKIBBEN_R(1e-7)
#else
#define MCKIBBEN_STRAIGHT MCKIBBEN_R(1e-12)
#endif
typedef struct {
    mckibben_real at, largest;                                /* length, m; Fm, N */
    mckibben_real w[MCKIBBEN_ENDS + 1], s[MCKIBBEN_ENDS + 1]; /* by rising w from 0 to 1; N */
    int ends;
} mckibben_memory;

/* Begins at a length, with nothing that slides. */
static inline void mckibben_rest(mckibben_memory *memory, mckibben_real length)
{
    for (int i = 0; i <= MCKIBBEN_ENDS; i++)
        memory->w[i] = memory->s[i] = MCKIBBEN_R(0);
    memory->at = length;
    memory->largest = MCKIBBEN_R(0);
    memory->w[1] = MCKIBBEN_R(1);
    memory->ends = 2;
}

/* Twice by how much the friction changes where an end between two lines is left out. */
static inline mckibben_real mckibben_bend(const mckibben_memory *memory, int i)
{
    const mckibben_real *w = memory->w, *s = memory->s;
    const mckibben_real bend = (w[i] - w[i - 1]) * (s[i + 1] - s[i]) - (w[i + 1] - w[i]) * (s[i] - s[i - 1]);
    return bend < MCKIBBEN_R(0) ? -bend : bend;
}

static inline void mckibben_leave_out(mckibben_memory *memory, int i)
{
    for (memory->ends--; i < memory->ends; i++) {
        memory->w[i] = memory->w[i + 1];
        memory->s[i] = memory->s[i + 1];
    }
}

/* The next end of a line, within the limits -most w and most w. */
static inline void mckibben_line_to(mckibben_memory *memory, mckibben_real w, mckibben_real s, mckibben_real most)
{
    const int before = memory->ends - 1;
    int least = 1;
    s = s > -most * w ? s : -most * w;
    memory->w[memory->ends] = w;
    memory->s[memory->ends++] = s < most * w ? s : most * w;
    if (before > 0 && mckibben_bend(memory, before) <= MCKIBBEN_STRAIGHT * memory->largest)
        mckibben_leave_out(memory, before);
    if (memory->ends <= MCKIBBEN_ENDS)
        return;
    for (int i = 2; i < MCKIBBEN_ENDS; i++)
        least = mckibben_bend(memory, i) < mckibben_bend(memory, least) ? i : least;
    mckibben_leave_out(memory, least);
}

/* After each step: the muscle went to a pressure and a length without a turn on the way, and may turn there. It stays where one is not a number. */
static inline void mckibben_moved(const mckibben_muscle *m, mckibben_memory *memory, mckibben_real pressure, mckibben_real length, unsigned *status)
{
    const mckibben_real most = MCKIBBEN_R(2) * mckibben_friction_limit(m, pressure, length), largest = MCKIBBEN_R(0.5) * most;
    mckibben_real stretch;
    mckibben_memory next;
    if (status)
        (void)mckibben_force(m, pressure, length, status);
    if (!(pressure - pressure == MCKIBBEN_R(0) && length - length == MCKIBBEN_R(0)))
        return;
    mckibben_rest(&next, length);
    next.ends = 1;
    next.largest = largest > memory->largest ? largest : memory->largest;
    stretch = MCKIBBEN_R(2) * next.largest / m->friction[6] * (length - memory->at);
    for (int i = 1; i < memory->ends; i++) {
        const mckibben_real v = memory->w[i - 1], r = memory->s[i - 1] + stretch, w = memory->w[i], s = memory->s[i] + stretch;
        mckibben_real cut[2] = {MCKIBBEN_R(0), MCKIBBEN_R(0)}; /* shares of the line at which it crosses a limit */
        for (int k = 0; k < 2; k++) {
            const mckibben_real limit = k ? -most : most, from = r - limit * v, to = s - limit * w;
            if (from * to < MCKIBBEN_R(0))
                cut[k] = from / (from - to);
        }
        for (int k = 0; k < 2; k++) {
            const mckibben_real share = cut[cut[0] > cut[1] ? 1 - k : k];
            if (share > MCKIBBEN_R(0))
                mckibben_line_to(&next, v + share * (w - v), r + share * (s - r), most);
        }
        mckibben_line_to(&next, w, s, most);
    }
    *memory = next;
}

/* What friction adds to the pull at a pressure and a length to which the muscle goes without a turn: positive where it has become longer; with it
 * the muscle never pushes. */
static inline mckibben_real mckibben_friction_after(const mckibben_muscle *m, const mckibben_memory *memory, mckibben_real pressure, mckibben_real length,
                                                    unsigned *status)
{
    const mckibben_real limit = mckibben_friction_limit(m, pressure, length);
    mckibben_real friction = MCKIBBEN_R(0), share, rest;
    mckibben_memory next = *memory;
    mckibben_moved(m, &next, pressure, length, 0);
    for (int i = 1; i < next.ends; i++)
        friction += MCKIBBEN_R(0.5) * (next.w[i] - next.w[i - 1]) * (next.s[i] + next.s[i - 1]);
    share = limit > MCKIBBEN_R(0) ? friction / limit : MCKIBBEN_R(0);
    rest = MCKIBBEN_R(1) - share * share; /* a velocity and a smoothing that make this share */
    return mckibben_friction(m, pressure, length, share, rest > MCKIBBEN_R(0) ? (mckibben_real)sqrt((double)rest) : MCKIBBEN_R(0), status);
}

/* A joint of one or two muscles.
 *
 * Units: rad, N m, Pa (gauge), m. Angles are counterclockwise from the neutral angle. The torque is what muscles, spring and weight exert on the
 * surroundings together; p has the pressure of each muscle. A status is the sum of those of the muscles, and of MCKIBBEN_ANGLE_OUTSIDE.
 */

#define MCKIBBEN_PULLS 24          /* pulls among which a stiffness is looked for */

/* A pulley (below zero: wound on the other side), or, where its radius is 0, a straight line between a point of the fixed link and one of the moving link. */
typedef struct {
    mckibben_real radius, origin_x, origin_y, insertion_x, insertion_y; /* m, from the axis at the neutral angle */
} mckibben_path;

typedef struct {
    int muscles; /* 1 or 2 */
    const mckibben_muscle *muscle[2];
    mckibben_path path[3];    /* of the muscles, and of a spring on a rope */
    mckibben_real rope[2];    /* a spring on a rope pulls with rope[0] + rope[1] length, N and N/m, never below 0 */
    mckibben_real torsion[2]; /* a torsion spring turns with -(torsion[0] + torsion[1] angle), N m and N m/rad */
    mckibben_real weight[2];  /* the weight turns with -weight[0] cos(angle + weight[1]), N m and rad */
    mckibben_real range[2];   /* of the angle, rad */
} mckibben_joint;

/* Length of a path, m (of a pulley from that at the neutral angle), its arm -d length/d angle, and the slope of the arm. */
static inline mckibben_real mckibben_path_length(const mckibben_path *path, mckibben_real angle, mckibben_real *arm, mckibben_real *slope)
{
    const mckibben_real s = MCKIBBEN_MATH(sin)(angle), c = MCKIBBEN_MATH(cos)(angle);
    const mckibben_real a[2] = {path->origin_x, path->origin_y}, b[2] = {path->insertion_x, path->insertion_y};
    const mckibben_real x = c * b[0] - s * b[1], y = s * b[0] + c * b[1];
    const mckibben_real length = MCKIBBEN_MATH(sqrt)((a[0] - x) * (a[0] - x) + (a[1] - y) * (a[1] - y));
    *arm = path->radius;
    *slope = MCKIBBEN_R(0);
    if (path->radius < MCKIBBEN_R(0) || path->radius > MCKIBBEN_R(0))
        return -path->radius * angle;
    *arm = (a[1] * x - a[0] * y) / length;
    *slope = (*arm * *arm - a[0] * x - a[1] * y) / length;
    return length;
}

/* The nearest angle of the range; its lower end of what is not a number. */
static inline mckibben_real mckibben_joint_nearest(const mckibben_joint *j, mckibben_real angle)
{
    return angle > j->range[1] ? j->range[1] : (angle >= j->range[0] ? angle : j->range[0]);
}

/* Torque of spring and weight, and its -d/d angle. */
static inline mckibben_real mckibben_joint_passive(const mckibben_joint *j, mckibben_real angle, mckibben_real *stiffness)
{
    mckibben_real arm, slope, torque = -j->weight[0] * MCKIBBEN_MATH(cos)(angle + j->weight[1]) - j->torsion[0] - j->torsion[1] * angle;
    const mckibben_real force = j->rope[0] + j->rope[1] * mckibben_path_length(&j->path[2], angle, &arm, &slope);
    *stiffness = j->torsion[1] - j->weight[0] * MCKIBBEN_MATH(sin)(angle + j->weight[1]);
    if (force > MCKIBBEN_R(0)) {
        torque += force * arm;
        *stiffness += j->rope[1] * arm * arm - force * slope;
    }
    return torque;
}

/* Torque; its -d/d angle at constant pressures, and its slope in each pressure in N m/Pa. All but the joint, p and the angle may be 0. */
static inline mckibben_real mckibben_joint_torque(const mckibben_joint *j, const mckibben_real p[], mckibben_real angle, mckibben_real *stiffness,
                                                  mckibben_real per_pressure[], unsigned *status)
{
    unsigned one, all = angle >= j->range[0] && angle <= j->range[1] ? 0u : MCKIBBEN_ANGLE_OUTSIDE;
    mckibben_real sum, torque;
    angle = mckibben_joint_nearest(j, angle);
    torque = mckibben_joint_passive(j, angle, &sum);
    for (int i = 0; i < j->muscles; i++) {
        mckibben_real arm, slope;
        const mckibben_real length = mckibben_path_length(&j->path[i], angle, &arm, &slope);
        const mckibben_real force = mckibben_force(j->muscle[i], p[i], length, &one);
        torque += force * arm;
        all |= one;
        if (stiffness)
            sum += mckibben_stiffness(j->muscle[i], p[i], length, 0) * arm * arm - force * slope;
        if (per_pressure)
            per_pressure[i] = arm * mckibben_force_per_pressure(j->muscle[i], p[i], length, 0);
    }
    if (stiffness)
        *stiffness = sum;
    if (status)
        *status = all;
    return torque;
}

/* Least and largest torque at an angle, with pressures from 0 to the supply. */
static inline void mckibben_joint_limits(const mckibben_joint *j, mckibben_real angle, mckibben_real torque[2])
{
    mckibben_real arm, slope;
    angle = mckibben_joint_nearest(j, angle);
    torque[0] = torque[1] = mckibben_joint_passive(j, angle, &slope);
    for (int i = 0; i < j->muscles; i++) {
        const mckibben_real length = mckibben_path_length(&j->path[i], angle, &arm, &slope);
        const int up = arm > MCKIBBEN_R(0);
        torque[up] += arm * mckibben_force(j->muscle[i], j->muscle[i]->supply, length, 0);
        torque[!up] += arm * mckibben_force(j->muscle[i], MCKIBBEN_R(0), length, 0);
    }
}

/* What friction of the muscles adds to the torque while the joint turns with `rate` in rad/s; smooth at rest over `smoothing` in rad/s. */
static inline mckibben_real mckibben_joint_friction(const mckibben_joint *j, const mckibben_real p[], mckibben_real angle, mckibben_real rate,
                                                    mckibben_real smoothing)
{
    mckibben_real torque = MCKIBBEN_R(0);
    angle = mckibben_joint_nearest(j, angle);
    for (int i = 0; i < j->muscles; i++) {
        mckibben_real arm, slope;
        const mckibben_real length = mckibben_path_length(&j->path[i], angle, &arm, &slope);
        torque += arm * mckibben_friction(j->muscle[i], p[i], length, -arm * rate, arm * smoothing, 0);
    }
    return torque;
}

/* A joint at an angle. */
typedef struct {
    mckibben_real length[2], arm[2], slope[2]; /* of each path, and the slope of the arm */
    mckibben_real least[2], most[2];           /* pulls without pressure and at the supply, N */
    mckibben_real needed, passive;             /* torque that the muscles must give, N m; stiffness of spring and weight, N m/rad */
} mckibben_joint_place;

/* The stiffness, and the pressures p at which the first muscle pulls with `first` and the second does the rest; 0 of a muscle that need not pull (a
 * millionth of its pull at the supply is rounding). `slack` becomes 1 where one does not pull, else 0. */
static inline mckibben_real mckibben_joint_pulled(const mckibben_joint *j, const mckibben_joint_place *at, mckibben_real first, mckibben_real p[2],
                                                  unsigned *slack)
{
    const mckibben_real pull[2] = {first, j->muscles > 1 ? (at->needed - first * at->arm[0]) / at->arm[1] : MCKIBBEN_R(0)};
    mckibben_real stiffness = at->passive;
    *slack = 0u;
    for (int i = 0; i < j->muscles; i++) {
        const mckibben_real force = pull[i] > at->least[i] ? (pull[i] < at->most[i] ? pull[i] : at->most[i]) : at->least[i];
        unsigned one;
        p[i] = pull[i] > MCKIBBEN_R(1e-6) * at->most[i] ? mckibben_pressure(j->muscle[i], pull[i], at->length[i], 0) : MCKIBBEN_R(0);
        stiffness += mckibben_stiffness(j->muscle[i], p[i], at->length[i], &one) * at->arm[i] * at->arm[i] - force * at->slope[i];
        *slack |= one & MCKIBBEN_SLACK;
    }
    return stiffness;
}

static inline mckibben_real mckibben_joint_apart(mckibben_real a, mckibben_real b) { return a < b ? b - a : a - b; }

/* Pressures p, from 0 to the supply, for a torque and a stiffness at an angle; the lowest ones for the torque where `stiffness` is 0, and of those that
 * give the stiffness the lowest. `reached`, which may be 0, becomes the least and the largest stiffness with this torque while both muscles pull; with one
 * of them slack it may have one more value below, with nothing between. With one muscle the stiffness is ignored. Where nothing gives what is wanted, the
 * status has MCKIBBEN_NO_ANSWER, and p the pressures that come near it; of what is not a finite number they are 0. */
static inline void mckibben_joint_pressures(const mckibben_joint *j, mckibben_real angle, mckibben_real torque, mckibben_real stiffness,
                                            mckibben_real p[2], mckibben_real reached[2], unsigned *status)
{
    mckibben_joint_place at;
    mckibben_real ends[2], k[2], low, high, rounding, finite;
    const int sought = j->muscles > 1 && !(stiffness <= MCKIBBEN_R(0) && stiffness >= MCKIBBEN_R(0));
    unsigned slack, found = angle >= j->range[0] && angle <= j->range[1] ? 0u : MCKIBBEN_ANGLE_OUTSIDE;
    /* Of an angle that is not finite nothing is known. */
    at.needed = torque + (angle - angle);
    angle = mckibben_joint_nearest(j, angle);
    at.needed -= mckibben_joint_passive(j, angle, &at.passive);
    for (int i = 0; i < j->muscles; i++) {
        at.length[i] = mckibben_path_length(&j->path[i], angle, &at.arm[i], &at.slope[i]);
        at.least[i] = mckibben_force(j->muscle[i], MCKIBBEN_R(0), at.length[i], 0);
        at.most[i] = mckibben_force(j->muscle[i], j->muscle[i]->supply, at.length[i], 0);
    }
    /* The pulls of the first muscle at which the second can do the rest. */
    ends[0] = ends[1] = at.needed / at.arm[0];
    if (j->muscles > 1) {
        ends[0] = (at.needed - at.least[1] * at.arm[1]) / at.arm[0];
        ends[1] = (at.needed - at.most[1] * at.arm[1]) / at.arm[0];
    }
    low = ends[0] < ends[1] ? ends[0] : ends[1];
    high = ends[0] < ends[1] ? ends[1] : ends[0];
    rounding = MCKIBBEN_R(1e-6) * at.most[0];
    if (!(low <= at.most[0] + rounding && high >= at.least[0] - rounding))
        found |= MCKIBBEN_NO_ANSWER;
    low = low > at.least[0] ? (low < at.most[0] ? low : at.most[0]) : at.least[0];
    high = high < at.most[0] ? (high > low ? high : low) : at.most[0];
    finite = at.needed + (sought ? stiffness : MCKIBBEN_R(0));
    p[0] = p[1] = k[0] = k[1] = MCKIBBEN_R(0);
    if (!(finite - finite <= MCKIBBEN_R(0)))
        found |= MCKIBBEN_NO_ANSWER;
    else
        k[0] = k[1] = mckibben_joint_pulled(j, &at, low, p, &slack);
    if (!(found & MCKIBBEN_NO_ANSWER) && j->muscles > 1 && (sought || reached)) {
        const mckibben_real enough = MCKIBBEN_R(1e-3) * mckibben_joint_apart(stiffness, MCKIBBEN_R(0));
        mckibben_real a = low, b = low, q[2], here, before = MCKIBBEN_R(0), best = low, closest = mckibben_joint_apart(k[0], stiffness);
        int both = 0, any = 0, met = closest <= enough;
        /* Both muscles are taut at the ends. */
        mckibben_real taut = MCKIBBEN_R(1e-5) * (at.most[0] + at.most[1] * mckibben_joint_apart(at.arm[1] / at.arm[0], MCKIBBEN_R(0)));
        taut = taut < MCKIBBEN_R(0.5) * (high - low) ? taut : MCKIBBEN_R(0.5) * (high - low);
        for (int i = 0; i <= MCKIBBEN_PULLS; i++) {
            const mckibben_real pull = low + taut + (high - low - MCKIBBEN_R(2) * taut) * (mckibben_real)i / MCKIBBEN_R(MCKIBBEN_PULLS);
            here = mckibben_joint_pulled(j, &at, pull, q, &slack);
            a = b;
            b = pull;
            if (slack) {
                both = 0;
                continue;
            }
            k[0] = !any || here < k[0] ? here : k[0];
            k[1] = !any || here > k[1] ? here : k[1];
            any = 1;
            if (!met && both && (here - stiffness < MCKIBBEN_R(0)) != (before < MCKIBBEN_R(0))) {
                mckibben_real from = a, to = b, middle = b, there = here;
                for (int n = 0; n < 40; n++) {
                    middle = MCKIBBEN_R(0.5) * (from + to);
                    there = mckibben_joint_pulled(j, &at, middle, q, &slack);
                    if ((there - stiffness < MCKIBBEN_R(0)) == (before < MCKIBBEN_R(0)))
                        from = middle;
                    else
                        to = middle;
                }
                met = mckibben_joint_apart(there, stiffness) <= enough; /* where it jumps, no side has it */
                best = met ? middle : best;
            }
            both = 1;
            before = here - stiffness;
            if (!met && mckibben_joint_apart(here, stiffness) < closest) {
                closest = mckibben_joint_apart(here, stiffness);
                best = pull;
            }
        }
        here = mckibben_joint_apart(mckibben_joint_pulled(j, &at, high, q, &slack), stiffness);
        if (!met && here < closest) {
            closest = here;
            best = high;
        }
        met = met || closest <= enough;
        if (sought) {
            found |= met ? 0u : MCKIBBEN_NO_ANSWER;
            (void)mckibben_joint_pulled(j, &at, best, p, &slack);
        }
    }
    if (reached) {
        reached[0] = k[0];
        reached[1] = k[1];
    }
    if (status)
        *status = found;
}

#ifdef __cplusplus
}
#endif
#endif
