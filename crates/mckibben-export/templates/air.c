/* The air in a muscle on a valve, by values x in an order of its host; gauge pressures in Pa.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
 *
 * States: the volume A = V (p/p0)^(1/n) that the air has at the pressure p0 of the atmosphere without heat, and its mass m.
 *   dA/dt = (p/p0)^(1/n)/(n p) (n R sum(G T) + (g - 1) hA (Tw - T)),   dm/dt = sum(G),   T = p V/(m R)
 * This is V dp/dt + n p dV/dt = n R sum(G T) + (g - 1) hA (Tw - T) (P. Beater, Pneumatic Drives, 2007, ch. 5) in a variable that stays as it is
 * while the muscle moves and the valve is closed: the speed of the muscle is not needed. p follows from A = V(p, L) (p/p0)^(1/n).
 */
#define ATMOSPHERE 101325.0
#define GAS 287.05              /* J/(kg K) */
#define HEAT_RATIO 1.4
#define REFERENCE_DENSITY 1.185 /* kg/m3, of ISO 8778, at the temperature: */
#define REFERENCE 293.15
#define LINEAR 0.01

/* Cavity and dead volume. */
static double air_volume(const mckibben_muscle *m, const double x[], double pressure)
{
    const double volume = mckibben_volume(m, pressure, x[LENGTH], 0) + x[DEAD_VOLUME];
    return volume > 1e-9 ? volume : 1e-9;
}

/* What a pressure lacks to that which the air has in its volume; it decreases with the pressure. Both are absolute. */
static double lack(const mckibben_muscle *m, const double x[], double pressure)
{
    const double air = x[AIR] > 1e-12 ? x[AIR] : 1e-12;
    return ATMOSPHERE * pow(air / air_volume(m, x, pressure - ATMOSPHERE), x[POLYTROPIC_EXPONENT]) - pressure;
}

/* The pressure of the air: it lies between any pressure and the one that follows from the volume there; regula falsi (Illinois). */
static double air_pressure(const mckibben_muscle *m, const double x[])
{
    double a = ATMOSPHERE + 0.5 * m->supply, at_a = lack(m, x, a), b = a + at_a, at_b = lack(m, x, b);
    for (int i = 0; i < 60 && fabs(at_b) > 1e-14 * b && fabs(at_a - at_b) > 0.0; i++) {
        const double next = b - at_b * (b - a) / (at_b - at_a), at_next = lack(m, x, next);
        if ((at_next < 0.0) != (at_b < 0.0)) {
            a = b;
            at_a = at_b;
        } else {
            at_a *= 0.5;
        }
        b = next;
        at_b = at_next;
    }
    return b - ATMOSPHERE;
}

/* The states of air at a pressure and at the temperature of the walls. */
static void fill(const mckibben_muscle *m, double x[], double pressure)
{
    const double p = ATMOSPHERE + pressure, volume = air_volume(m, x, pressure);
    x[AIR] = volume * pow(p / ATMOSPHERE, 1.0 / x[POLYTROPIC_EXPONENT]);
    x[AIR_MASS] = p * volume / (GAS * x[TEMPERATURE]);
}

static double air_temperature(const mckibben_muscle *m, const double x[], double pressure)
{
    return (ATMOSPHERE + pressure) * air_volume(m, x, pressure) / (GAS * (x[AIR_MASS] > 1e-12 ? x[AIR_MASS] : 1e-12));
}

/* ISO 6358-1 with a ratio of pressures r and a critical ratio b; a parabola above r = 0.99, where the root has too steep a slope. */
static double flow_shape(double r, double b)
{
    const double edge = (r < 1.0 - LINEAR ? r : 1.0 - LINEAR), part = (edge - b) / (1.0 - b);
    double root, slope, s;
    if (r <= b)
        return 1.0;
    root = sqrt(1.0 - part * part);
    if (r <= 1.0 - LINEAR)
        return root;
    slope = LINEAR * part / ((1.0 - b) * root);
    s = (1.0 - r) / LINEAR;
    return s * (2.0 * root - slope + (slope - root) * s);
}

/* Mass flow into the muscle, and the temperature of where it comes from: of the supply at an opening above 0, of the atmosphere below. */
static double air_flow(const double x[], double pressure, double inside, double *temperature)
{
    const double opening = x[COMMAND] > 1.0 ? 1.0 : (x[COMMAND] < -1.0 ? -1.0 : x[COMMAND]);
    const int fills = opening > 0.0;
    const double p = ATMOSPHERE + pressure, outside = ATMOSPHERE + (fills ? x[SUPPLY_PRESSURE] : 0.0);
    const double conductance = fills ? opening * x[SONIC_CONDUCTANCE] : -opening * x[EXHAUST_CONDUCTANCE];
    const double ratio = fills ? x[CRITICAL_RATIO] : x[EXHAUST_CRITICAL_RATIO];
    const double from = outside >= p ? outside : p, to = outside >= p ? p : outside;
    *temperature = outside >= p ? x[TEMPERATURE] : inside;
    return (outside >= p ? 1.0 : -1.0) * conductance * from * REFERENCE_DENSITY * sqrt(REFERENCE / *temperature) * flow_shape(to / from, ratio);
}

/* dA/dt and dm/dt at the pressure of the air. */
static void air_rates(const mckibben_muscle *m, const double x[], double pressure, double rates[2])
{
    const double n = x[POLYTROPIC_EXPONENT], p = ATMOSPHERE + pressure, inside = air_temperature(m, x, pressure);
    double from;
    rates[1] = air_flow(x, pressure, inside, &from);
    rates[0] = pow(p / ATMOSPHERE, 1.0 / n) / (n * p)
        * (n * GAS * rates[1] * from + (HEAT_RATIO - 1.0) * x[HEAT_CONDUCTANCE] * (x[TEMPERATURE] - inside));
}

/* Largest error of a step of the integration, share of each state. */
#define TOLERANCE 1e-8

/* Integrates both states over a time, with the command and the length held: P. Bogacki and L. Shampine (1989), of order 3 with an error of order 2.
 * 0 where the steps become too small. */
static int air_step(const mckibben_muscle *m, double x[], double duration)
{
    double k[4][2], y[2] = {x[AIR], x[AIR_MASS]}, done = 0.0, h = duration;
    air_rates(m, x, air_pressure(m, x), k[0]);
    for (int tries = 0; done < duration; tries++) {
        static const double share[2] = {0.5, 0.75};
        double worst = 0.0, factor;
        if (tries > 100000)
            return 0;
        h = duration - done > h ? h : duration - done;
        for (int s = 1; s < 4; s++) {
            for (int i = 0; i < 2; i++)
                x[AIR + i] = y[i] + h * (s < 3 ? share[s - 1] * k[s - 1][i] : (2.0 * k[0][i] + 3.0 * k[1][i] + 4.0 * k[2][i]) / 9.0);
            air_rates(m, x, air_pressure(m, x), k[s]);
        }
        for (int i = 0; i < 2; i++) {
            const double error = fabs(h * (-5.0 * k[0][i] + 6.0 * k[1][i] + 8.0 * k[2][i] - 9.0 * k[3][i]) / (72.0 * y[i]));
            worst = error <= worst ? worst : error;
        }
        factor = worst <= 0.0 ? 5.0 : 0.9 * pow(TOLERANCE / worst, 1.0 / 3.0);
        if (worst <= TOLERANCE) {
            done = h < duration - done ? done + h : duration;
            for (int i = 0; i < 2; i++) {
                y[i] = x[AIR + i];
                k[0][i] = k[3][i];
            }
        } else {
            x[AIR] = y[0];
            x[AIR_MASS] = y[1];
        }
        h *= factor > 5.0 ? 5.0 : (factor > 0.2 ? factor : 0.2);
    }
    return 1;
}
