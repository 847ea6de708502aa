/* A joint of one or two muscles: torque, stiffness, pressures. It needs mckibben.h and mckibben.c; of the C library sqrt, sin and cos.
 * Made by mckibben @{version}; the same for all joints. Licence: MIT OR Apache-2.0.
 *
 * Units: rad, N m, Pa (gauge), m. Angles are counterclockwise from the neutral angle. The torque is what muscles, spring and weight exert on the
 * surroundings together; p has the pressure of each muscle. A status is the sum of those of the muscles, and of MCKIBBEN_ANGLE_OUTSIDE.
 */
#ifndef MCKIBBEN_JOINT_H
#define MCKIBBEN_JOINT_H

#include "mckibben.h"
#include <math.h>

#ifdef MCKIBBEN_FLOAT
#define MCKIBBEN_MATH(name) name##f
#else
#define MCKIBBEN_MATH(name) name
#endif
#define MCKIBBEN_ANGLE_OUTSIDE 16u /* outside of the range of the joint */
#define MCKIBBEN_PULLS 24          /* pulls among which a stiffness is looked for */

/* A pulley (below zero: wound on the other side), or, where its radius is 0, a straight line between a point of the fixed link and one of the moving link. */
typedef struct {
    mckibben_real radius, origin[2], insertion[2]; /* m; x and y from the axis at the neutral angle */
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
    const mckibben_real s = MCKIBBEN_MATH(sin)(angle), c = MCKIBBEN_MATH(cos)(angle), *a = path->origin, *b = path->insertion;
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
    mckibben_real sum, torque = mckibben_joint_passive(j, angle, &sum);
    unsigned one, all = angle >= j->range[0] && angle <= j->range[1] ? 0u : MCKIBBEN_ANGLE_OUTSIDE;
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
    at.needed = torque - mckibben_joint_passive(j, angle, &at.passive);
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

#endif
