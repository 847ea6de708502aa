/* FMI 2.0, Model Exchange and Co-Simulation, around mckibben.c. The muscle has no states: outputs follow from inputs at once.
 * @{facts}
 */
#include "mckibben.c"
#include "muscle.h"
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#define FMI2_EXPORT __declspec(dllexport)
#else
#define FMI2_EXPORT __attribute__((visibility("default")))
#endif

typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef int fmi2StatusKind;
typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged, valuesOfContinuousStatesChanged,
        nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

/* Value references of Real variables. */
enum { PRESSURE, LENGTH, FACTOR, FORCE, STIFFNESS, VOLUME, FORCE_PER_PRESSURE };

/* All that an instance has: plain numbers, which are its state. */
typedef struct {
    double value[3], time;
} instance;

static void begin(instance *c)
{
    c->value[PRESSURE] = 0.0;
    c->value[LENGTH] = @{id}.length;
    c->value[FACTOR] = 1.0;
    c->time = 0.0;
}

/* The muscle with its pull multiplied: all coefficients are, so that pull and volume keep one potential. */
static mckibben_muscle scaled(const instance *c)
{
    mckibben_muscle m = @{id};
    for (int i = 0; i < MCKIBBEN_FUNCTIONS; i++) {
        for (int j = 0; j < m.nodes; j++) {
            m.a[i][j] *= c->value[FACTOR];
            m.b[i][j] *= c->value[FACTOR];
        }
    }
    return m;
}

static int get(const instance *c, fmi2ValueReference vr, double *out)
{
    const mckibben_muscle m = scaled(c);
    const double p = c->value[PRESSURE], l = c->value[LENGTH];
    switch (vr) {
    case PRESSURE: case LENGTH: case FACTOR: *out = c->value[vr]; return 1;
    case FORCE: *out = mckibben_force(&m, p, l, 0); return 1;
    case STIFFNESS: *out = mckibben_stiffness(&m, p, l); return 1;
    case VOLUME: *out = mckibben_volume(&m, p, l); return 1;
    case FORCE_PER_PRESSURE: *out = mckibben_force_per_pressure(&m, p, l); return 1;
    default: return 0;
    }
}

FMI2_EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
FMI2_EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
FMI2_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String names[]) { (void)c; (void)on; (void)n; (void)names; return fmi2OK; }

FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, const void *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    instance *c;
    (void)name; (void)type; (void)resources; (void)callbacks; (void)visible; (void)logging;
    if (!guid || strcmp(guid, "@{guid}") != 0)
        return 0;
    c = (instance *)malloc(sizeof(instance));
    if (c)
        begin(c);
    return c;
}
FMI2_EXPORT void fmi2FreeInstance(fmi2Component c) { free(c); }
FMI2_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerant, fmi2Real tolerance, fmi2Real start, fmi2Boolean stops, fmi2Real stop) { (void)c; (void)tolerant; (void)tolerance; (void)start; (void)stops; (void)stop; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2Terminate(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2Reset(fmi2Component c) { begin((instance *)c); return fmi2OK; }

FMI2_EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[])
{
    for (size_t i = 0; i < n; i++)
        if (!get((const instance *)c, vr[i], &value[i]))
            return fmi2Error;
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[])
{
    for (size_t i = 0; i < n; i++) {
        if (vr[i] > FACTOR || !(value[i] - value[i] == 0.0))
            return fmi2Error;
        ((instance *)c)->value[vr[i]] = value[i];
    }
    return fmi2OK;
}
/* The only integer: the status, value reference 0. */
FMI2_EXPORT fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Integer value[])
{
    const instance *of = (const instance *)c;
    for (size_t i = 0; i < n; i++) {
        unsigned status;
        if (vr[i] != 0)
            return fmi2Error;
        (void)mckibben_force(&@{id}, of->value[PRESSURE], of->value[LENGTH], &status);
        value[i] = (fmi2Integer)status;
    }
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Boolean value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2String value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Boolean value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2String value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }

FMI2_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    if (!*state)
        *state = malloc(sizeof(instance));
    if (!*state)
        return fmi2Error;
    memcpy(*state, c, sizeof(instance));
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) { memcpy(c, state, sizeof(instance)); return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) { (void)c; free(*state); *state = 0; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) { (void)c; (void)state; *size = sizeof(instance); return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    (void)c;
    if (size < sizeof(instance))
        return fmi2Error;
    memcpy(bytes, state, sizeof(instance));
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    (void)c;
    if (size != sizeof(instance))
        return fmi2Error;
    if (!*state)
        *state = malloc(sizeof(instance));
    if (!*state)
        return fmi2Error;
    memcpy(*state, bytes, sizeof(instance));
    return fmi2OK;
}

/* Of the pull by pressure and length, and of the volume by length. */
FMI2_EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference of[], size_t n, const fmi2ValueReference by[], size_t m, const fmi2Real direction[], fmi2Real out[])
{
    const instance *at = (const instance *)c;
    for (size_t i = 0; i < n; i++) {
        out[i] = 0.0;
        for (size_t j = 0; j < m; j++) {
            double slope;
            if (of[i] == FORCE && by[j] == LENGTH) {
                (void)get(at, STIFFNESS, &slope);
            } else if (of[i] == FORCE && by[j] == PRESSURE) {
                (void)get(at, FORCE_PER_PRESSURE, &slope);
            } else { /* central differences */
                instance up = *at, down = *at;
                const double step = by[j] == PRESSURE ? 1e-5 * @{id}.supply : (by[j] == LENGTH ? 1e-6 * @{id}.length : 1e-6);
                double a, b;
                if (by[j] > FACTOR)
                    return fmi2Error;
                up.value[by[j]] += step;
                down.value[by[j]] -= step;
                if (!get(&up, of[i], &a) || !get(&down, of[i], &b))
                    return fmi2Error;
                slope = (a - b) / (2.0 * step);
            }
            out[i] += slope * direction[j];
        }
    }
    return fmi2OK;
}

/* Model Exchange. */
FMI2_EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) { (void)c; memset(info, 0, sizeof(*info)); return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean final, fmi2Boolean *event, fmi2Boolean *stop) { (void)c; (void)final; *event = 0; *stop = 0; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time) { (void)c; (void)time; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n) { (void)c; (void)x; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real x[], size_t n) { (void)c; (void)x; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real x[], size_t n) { (void)c; (void)x; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) { (void)c; (void)x; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x[], size_t n) { (void)c; (void)x; return n ? fmi2Error : fmi2OK; }

/* Co-Simulation. */
FMI2_EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer order[], const fmi2Real value[]) { (void)c; (void)vr; (void)order; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer order[], fmi2Real value[]) { (void)c; (void)vr; (void)order; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real at, fmi2Real step, fmi2Boolean final) { (void)c; (void)at; (void)step; (void)final; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2CancelStep(fmi2Component c) { (void)c; return fmi2Error; }
FMI2_EXPORT fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind s, fmi2Status *value) { (void)c; (void)s; *value = fmi2OK; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *value) { (void)c; (void)s; *value = 0.0; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind s, fmi2Integer *value) { (void)c; (void)s; *value = 0; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value) { (void)c; (void)s; *value = 0; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind s, fmi2String *value) { (void)c; (void)s; *value = ""; return fmi2Discard; }
