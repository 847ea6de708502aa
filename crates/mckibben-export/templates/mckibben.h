/* Pull and volume of a McKibben muscle in closed form. C99; no heap; of the C library only sqrt.
 * Made by mckibben @{version}; the same for all muscles.
 *
 * Units: Pa (gauge), m, N, m3. All numbers are float with -DMCKIBBEN_FLOAT, and on an Arm core whose floating-point unit has single precision alone
 * (Cortex-M4F): there double is computed by software. Otherwise, and with -DMCKIBBEN_DOUBLE, they are double.
 * Licence: MIT OR Apache-2.0.
 */
#ifndef MCKIBBEN_H
#define MCKIBBEN_H

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

/* What a status says: a sum of these. */
#define MCKIBBEN_OK 0u
#define MCKIBBEN_SLACK 1u               /* the muscle would have to push: it is slack */
#define MCKIBBEN_PRESSURE_OUTSIDE 2u    /* outside of the box, or not a number: the answer is that of the nearest point of the box */
#define MCKIBBEN_CONTRACTION_OUTSIDE 4u
#define MCKIBBEN_NO_ANSWER 8u           /* nothing in the box gives this pull: the answer is the nearest end of the box */

/* Functions of the pressure, and the largest number of nodes. */
#define MCKIBBEN_FUNCTIONS 5
#define MCKIBBEN_NODES 10

typedef struct {
    mckibben_real length; /* L0, at rest, m */
    mckibben_real cord;   /* m: a rope or rod between the muscle and what it pulls; the `length` of each function is that of both */
    mckibben_real supply; /* upper end of the box, Pa */
    int nodes;            /* how many there are; the first and the last are the ends of the box */
    mckibben_real node[MCKIBBEN_NODES];                  /* contractions 1 - L/L0 */
    mckibben_real a[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES]; /* N; functions of the contraction, at the nodes */
    mckibben_real b[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES]; /* N; their slopes */
    mckibben_real v[MCKIBBEN_FUNCTIONS];                 /* m3 */
    mckibben_real friction[3]; /* N, N and m: half the hysteresis is f0 sqrt(q) + f1 q, and builds up over f2; zeros where the muscle does not state its friction */
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
/* What friction adds to the pull while the length changes by `velocity` in m/s (positive: longer); smooth at rest over `smoothing` in m/s. With it
 * the muscle pulls or is slack: it never pushes. */
mckibben_real mckibben_friction(const mckibben_muscle *m, mckibben_real pressure, mckibben_real length, mckibben_real velocity, mckibben_real smoothing,
                                unsigned *status);


#ifdef __cplusplus
}
#endif
#endif
