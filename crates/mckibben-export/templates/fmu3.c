/* FMI 3.0, Model Exchange and Co-Simulation, beside FMI 2.0 of fmu2.c, with the same instances.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
 */
#include "fmu2.c"
#include <stdbool.h>
#include <stdint.h>

#define FMI3(type) FMI2_EXPORT type
#define REFERENCES const uint32_t vr[], size_t n

typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;

FMI3(const char *) fmi3GetVersion(void) { return "3.0"; }
FMI3(fmi3Status) fmi3SetDebugLogging(void *c, bool on, size_t n, const char *const names[]) { (void)c; (void)on; (void)n; (void)names; return fmi3OK; }

static void *instantiated(const char *resources, const char *token, void *environment, void (*third)(void *, fmi2Status, const char *, const char *))
{
    const logger log = {0, third, environment};
    return made(resources, token, log);
}
FMI3(void *) fmi3InstantiateModelExchange(const char *name, const char *token, const char *resources, bool visible, bool logging, void *environment, void (*log)(void *, fmi2Status, const char *, const char *)) { (void)name; (void)visible; (void)logging; return instantiated(resources, token, environment, log); }
FMI3(void *) fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, bool visible, bool logging, bool events, bool early, REFERENCES, void *environment, void (*log)(void *, fmi2Status, const char *, const char *), void *update) { (void)name; (void)visible; (void)logging; (void)events; (void)early; (void)vr; (void)n; (void)update; return instantiated(resources, token, environment, log); }
FMI3(void *) fmi3InstantiateScheduledExecution(const char *name, const char *token, const char *resources, bool visible, bool logging, void *environment, void *log, void *update, void *lock, void *unlock) { (void)name; (void)token; (void)resources; (void)visible; (void)logging; (void)environment; (void)log; (void)update; (void)lock; (void)unlock; return 0; }
FMI3(void) fmi3FreeInstance(void *c) { free(c); }
FMI3(fmi3Status) fmi3EnterInitializationMode(void *c, bool tolerant, double tolerance, double start, bool stops, double stop) { return fmi2SetupExperiment(c, tolerant, tolerance, start, stops, stop) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3Reset(void *c) { begin((instance *)c); return fmi3OK; }

FMI3(fmi3Status) fmi3ExitInitializationMode(void *c) { return fmi2ExitInitializationMode(c) == fmi2OK ? fmi3OK : fmi3Error; }

/* Other changes of the mode have nothing to do. */
#define NOTHING(name) FMI3(fmi3Status) name(void *c) { (void)c; return fmi3OK; }
NOTHING(fmi3EnterEventMode)
NOTHING(fmi3Terminate)
NOTHING(fmi3EnterConfigurationMode)
NOTHING(fmi3ExitConfigurationMode)
NOTHING(fmi3EvaluateDiscreteStates)
NOTHING(fmi3EnterContinuousTimeMode)
NOTHING(fmi3EnterStepMode)

FMI3(fmi3Status) fmi3GetFloat64(void *c, REFERENCES, double value[], size_t values) { return values == n && fmi2GetReal(c, vr, n, value) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3SetFloat64(void *c, REFERENCES, const double value[], size_t values) { return values == n && fmi2SetReal(c, vr, n, value) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetInt32(void *c, REFERENCES, int32_t value[], size_t values) { return values == n && fmi2GetInteger(c, vr, n, value) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3SetInt32(void *c, REFERENCES, const int32_t value[], size_t values) { (void)c; (void)vr; (void)value; (void)values; return n ? fmi3Error : fmi3OK; }

/* There are no variables of other types. */
#define NONE(name, type) \
    FMI3(fmi3Status) fmi3Get##name(void *c, REFERENCES, type value[], size_t values) { (void)c; (void)vr; (void)value; (void)values; return n ? fmi3Error : fmi3OK; } \
    FMI3(fmi3Status) fmi3Set##name(void *c, REFERENCES, const type value[], size_t values) { (void)c; (void)vr; (void)value; (void)values; return n ? fmi3Error : fmi3OK; }
typedef const char *text_of;
NONE(Float32, float)
NONE(Int8, int8_t)
NONE(UInt8, uint8_t)
NONE(Int16, int16_t)
NONE(UInt16, uint16_t)
NONE(UInt32, uint32_t)
NONE(Int64, int64_t)
NONE(UInt64, uint64_t)
NONE(Boolean, bool)
NONE(String, text_of)
FMI3(fmi3Status) fmi3GetBinary(void *c, REFERENCES, size_t sizes[], const uint8_t *value[], size_t values) { (void)c; (void)vr; (void)sizes; (void)value; (void)values; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3SetBinary(void *c, REFERENCES, const size_t sizes[], const uint8_t *const value[], size_t values) { (void)c; (void)vr; (void)sizes; (void)value; (void)values; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3GetClock(void *c, REFERENCES, bool value[]) { (void)c; (void)vr; (void)value; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3SetClock(void *c, REFERENCES, const bool value[]) { (void)c; (void)vr; (void)value; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3GetIntervalDecimal(void *c, REFERENCES, double value[], int qualifier[]) { (void)c; (void)vr; (void)value; (void)qualifier; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3GetIntervalFraction(void *c, REFERENCES, uint64_t counter[], uint64_t resolution[], int qualifier[]) { (void)c; (void)vr; (void)counter; (void)resolution; (void)qualifier; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3GetShiftDecimal(void *c, REFERENCES, double value[]) { (void)c; (void)vr; (void)value; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3GetShiftFraction(void *c, REFERENCES, uint64_t counter[], uint64_t resolution[]) { (void)c; (void)vr; (void)counter; (void)resolution; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3SetIntervalDecimal(void *c, REFERENCES, const double value[]) { (void)c; (void)vr; (void)value; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3SetIntervalFraction(void *c, REFERENCES, const uint64_t counter[], const uint64_t resolution[]) { (void)c; (void)vr; (void)counter; (void)resolution; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3SetShiftDecimal(void *c, REFERENCES, const double value[]) { (void)c; (void)vr; (void)value; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3SetShiftFraction(void *c, REFERENCES, const uint64_t counter[], const uint64_t resolution[]) { (void)c; (void)vr; (void)counter; (void)resolution; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3GetNumberOfVariableDependencies(void *c, uint32_t vr, size_t *n) { (void)c; (void)vr; *n = 0; return fmi3Error; }
FMI3(fmi3Status) fmi3GetVariableDependencies(void *c, uint32_t vr, size_t dependent[], uint32_t on[], size_t of[], int kind[], size_t n) { (void)c; (void)vr; (void)dependent; (void)on; (void)of; (void)kind; (void)n; return fmi3Error; }

FMI3(fmi3Status) fmi3GetFMUState(void *c, void **state) { return fmi2GetFMUstate(c, state) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3SetFMUState(void *c, void *state) { return fmi2SetFMUstate(c, state) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3FreeFMUState(void *c, void **state) { return fmi2FreeFMUstate(c, state) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3SerializedFMUStateSize(void *c, void *state, size_t *size) { return fmi2SerializedFMUstateSize(c, state, size) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3SerializeFMUState(void *c, void *state, uint8_t bytes[], size_t size) { return fmi2SerializeFMUstate(c, state, (char *)bytes, size) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3DeserializeFMUState(void *c, const uint8_t bytes[], size_t size, void **state) { return fmi2DeSerializeFMUstate(c, (const char *)bytes, size, state) == fmi2OK ? fmi3OK : fmi3Error; }

FMI3(fmi3Status) fmi3GetDirectionalDerivative(void *c, const uint32_t of[], size_t n, const uint32_t by[], size_t m, const double seed[], size_t seeds, double out[], size_t outs) { return seeds == m && outs == n && fmi2GetDirectionalDerivative(c, of, n, by, m, seed, out) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetAdjointDerivative(void *c, const uint32_t of[], size_t n, const uint32_t by[], size_t m, const double seed[], size_t seeds, double out[], size_t outs)
{
    if (seeds != n || outs != m)
        return fmi3Error;
    for (size_t j = 0; j < m; j++) {
        out[j] = 0.0;
        for (size_t i = 0; i < n; i++) {
            const double one = 1.0;
            double slope;
            if (fmi2GetDirectionalDerivative(c, &of[i], 1, &by[j], 1, &one, &slope) != fmi2OK)
                return fmi3Error;
            out[j] += seed[i] * slope;
        }
    }
    return fmi3OK;
}

/* Model Exchange. */
FMI3(fmi3Status) fmi3UpdateDiscreteStates(void *c, bool *again, bool *stop, bool *nominals, bool *values, bool *timed, double *time) { (void)c; *again = *stop = *nominals = *values = *timed = false; *time = 0.0; return fmi3OK; }
FMI3(fmi3Status) fmi3CompletedIntegratorStep(void *c, bool final, bool *event, bool *stop) { int second[2]; (void)fmi2CompletedIntegratorStep(c, final, &second[0], &second[1]); *event = *stop = false; return fmi3OK; }
FMI3(fmi3Status) fmi3SetTime(void *c, double time) { return fmi2SetTime(c, time) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3SetContinuousStates(void *c, const double x[], size_t n) { return fmi2SetContinuousStates(c, x, n) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetContinuousStates(void *c, double x[], size_t n) { return fmi2GetContinuousStates(c, x, n) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetContinuousStateDerivatives(void *c, double x[], size_t n) { return fmi2GetDerivatives(c, x, n) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetNominalsOfContinuousStates(void *c, double x[], size_t n) { return fmi2GetNominalsOfContinuousStates(c, x, n) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetEventIndicators(void *c, double x[], size_t n) { return fmi2GetEventIndicators(c, x, n) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3GetNumberOfEventIndicators(void *c, size_t *n) { *n = events_of(c); return fmi3OK; }
FMI3(fmi3Status) fmi3GetNumberOfContinuousStates(void *c, size_t *n) { *n = states_of(c); return fmi3OK; }

/* Co-Simulation. */
FMI3(fmi3Status) fmi3GetOutputDerivatives(void *c, REFERENCES, const int32_t order[], double value[], size_t values) { (void)c; (void)vr; (void)order; (void)value; (void)values; return n ? fmi3Error : fmi3OK; }
FMI3(fmi3Status) fmi3DoStep(void *c, double at, double step, bool final, bool *event, bool *stop, bool *early, double *last) { *event = *stop = *early = false; *last = at + step; return fmi2DoStep(c, at, step, final) == fmi2OK ? fmi3OK : fmi3Error; }
FMI3(fmi3Status) fmi3ActivateModelPartition(void *c, uint32_t clock, double time) { (void)c; (void)clock; (void)time; return fmi3Error; }
