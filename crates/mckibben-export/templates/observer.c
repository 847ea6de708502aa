/* Length and pull of the muscle @{name} from gauge pressure and air flow, without a sensor of length: an extended Kalman filter.
 * cc -O2 @{id}_observer.c mckibben.c -lm -o observer && ./observer < measured.txt
 * Each line of the input: time in s, gauge pressure in Pa, mass flow into the muscle since the line before in kg/s. Each line of the output: time, length
 * in m, pull in N, standard deviation of the length in m.
 * @{facts}
 *
 * States: length, its velocity (its acceleration is noise), mass of air (it integrates the flow). The gas law of the measured pressure p at
 * constant temperature is the measurement: 0 = (p0 + p) (V(p, L) + dead volume)/(R T) - mass, with dV/dL = -dF/dp.
 * The muscle begins at rest without pressure. A flow sensor that is off by a share makes the mass off by it, and the length with it: begin
 * again each time that the muscle is vented.
 */
#ifndef ARDUINO /* a sketch has its own main */
#include "@{id}.h"
#include <math.h>
#include <stdio.h>

typedef mckibben_real real;
#define R(x) MCKIBBEN_R(x)

/* Your hardware. */
static const real DEAD_VOLUME_M3 = R(10e-6), ATMOSPHERE_PA = R(101325), TEMPERATURE_K = R(293.15);
/* Standard deviations of the sensors, and of the velocity, which changes within some time. */
static const real PRESSURE_PA = R(500), FLOW_KG_S = R(5e-6), VELOCITY_M_S = R(0.3), FORGOTTEN_S = R(0.1);
static const real GAS_J_KG_K = R(287.05);

enum { LENGTH, VELOCITY, MASS, STATES };

typedef struct {
    real x[STATES], p[STATES][STATES]; /* estimate and its covariance */
} observer;

/* The mass of air at a pressure and a length. */
static real mass(real pressure, real length)
{
    return (ATMOSPHERE_PA + pressure) * (mckibben_volume(&@{id}, pressure, length, 0) + DEAD_VOLUME_M3) / (GAS_J_KG_K * TEMPERATURE_K);
}

static void start(observer *o, real pressure, real length)
{
    *o = (observer){{length, R(0), mass(pressure, length)}, {{R(0)}}};
    o->p[LENGTH][LENGTH] = R(1e-6) * length * length;
    o->p[MASS][MASS] = R(1e-8) * o->x[MASS] * o->x[MASS];
}

static void step(observer *o, real dt, real pressure, real flow)
{
    /* What follows from the states before: L += v dt, mass += flow dt; the velocity is forgotten. */
    const real keep = R(1) / (R(1) + dt / FORGOTTEN_S), lv = o->p[LENGTH][VELOCITY], vv = o->p[VELOCITY][VELOCITY];
    o->x[LENGTH] += o->x[VELOCITY] * dt;
    o->x[VELOCITY] *= keep;
    o->x[MASS] += flow * dt;
    o->p[LENGTH][LENGTH] += dt * (R(2) * lv + dt * vv);
    o->p[LENGTH][VELOCITY] = o->p[VELOCITY][LENGTH] = keep * (lv + dt * vv);
    o->p[VELOCITY][VELOCITY] = keep * keep * vv + R(2) * dt / FORGOTTEN_S * VELOCITY_M_S * VELOCITY_M_S;
    o->p[LENGTH][MASS] = o->p[MASS][LENGTH] += dt * o->p[VELOCITY][MASS];
    o->p[VELOCITY][MASS] = o->p[MASS][VELOCITY] *= keep;
    o->p[MASS][MASS] += FLOW_KG_S * FLOW_KG_S * dt * dt;
    /* What the pressure adds. */
    const real near = R(2e-3) * @{id}.supply, length = o->x[LENGTH], here = mass(pressure, length);
    const real by_pressure = (mass(pressure + near, length) - here) / near;
    const real by_length = -(ATMOSPHERE_PA + pressure) * mckibben_force_per_pressure(&@{id}, pressure, length, 0) / (GAS_J_KG_K * TEMPERATURE_K);
    real ph[STATES], variance = by_pressure * by_pressure * PRESSURE_PA * PRESSURE_PA;
    for (int i = 0; i < STATES; i++)
        ph[i] = o->p[i][LENGTH] * by_length - o->p[i][MASS];
    variance += by_length * ph[LENGTH] - ph[MASS];
    for (int i = 0; i < STATES; i++) {
        o->x[i] += ph[i] / variance * (o->x[MASS] - here);
        for (int j = 0; j < STATES; j++)
            o->p[i][j] -= ph[i] * ph[j] / variance;
    }
}

int main(void)
{
    observer o;
    double t, before = 0.0, pressure, flow;
    for (int n = 0; scanf("%lf %lf %lf", &t, &pressure, &flow) == 3; n++, before = t) {
        if (n == 0)
            start(&o, R(pressure), @{id}.cord + @{id}.length);
        else
            step(&o, R(t - before), R(pressure), R(flow));
        printf("%.6g %.6g %.6g %.3g\n", t, (double)o.x[LENGTH], (double)mckibben_force(&@{id}, R(pressure), o.x[LENGTH], 0), sqrt((double)o.p[LENGTH][LENGTH]));
    }
    return 0;
}
#endif
