/* FMI 2.0, Model Exchange and Co-Simulation, around mckibben.c. The muscle has no states: outputs follow from inputs at once. Its numbers are
 * read from resources/muscle.bin, so that one library serves all muscles.
 * @{facts}
 */
#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#define FMI2_EXPORT __declspec(dllexport)
#else
#define FMI2_EXPORT __attribute__((visibility("default")))
#endif
#include "mckibben.c"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

typedef struct {
    void (*logger)(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category, fmi2String message, ...);
    void *(*allocate)(size_t n, size_t size);
    void (*release)(void *memory);
    void (*step_finished)(fmi2ComponentEnvironment environment, fmi2Status status);
    fmi2ComponentEnvironment environment;
} fmi2CallbackFunctions;

/* Value references of Real variables. */
enum { PRESSURE, LENGTH, FACTOR, FORCE, STIFFNESS, VOLUME, FORCE_PER_PRESSURE };

/* What changes: plain numbers. */
typedef struct {
    double value[3], time;
} state;

typedef struct {
    state now;
    mckibben_muscle read, muscle; /* as it was read; with its pull multiplied */
} instance;

/* All coefficients are multiplied, so that pull and volume keep one potential. */
static void set_state(instance *c, const state *s)
{
    c->now = *s;
    c->muscle = c->read;
    for (int i = 0; i < MCKIBBEN_FUNCTIONS; i++) {
        for (int j = 0; j < MCKIBBEN_NODES; j++) {
            c->muscle.a[i][j] *= s->value[FACTOR];
            c->muscle.b[i][j] *= s->value[FACTOR];
        }
    }
}

static void begin(instance *c)
{
    const state s = {{0.0, c->read.length, 1.0}, 0.0};
    set_state(c, &s);
}

static int digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : (c >= 'a' && c <= 'f' ? c - 'a' + 10 : (c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1));
}

#ifdef _WIN32
#define PATH 1024
#else
#define PATH 4096
#endif

/* The path of muscle.bin: the location of the resources is a URI with codes %xx in FMI 2.0, and a path in FMI 3.0. */
static int path_of(const char *location, char path[PATH])
{
    static const char name[] = "/muscle.bin";
    const int uri = strncmp(location, "file:", 5) == 0;
    size_t n = 0;
    if (uri) {
        location += 5;
        if (strncmp(location, "//localhost/", 12) == 0)
            location += 11;
        else if (strncmp(location, "///", 3) == 0)
            location += 2;
#ifdef _WIN32
        if (location[0] == '/' && location[1] && location[2] == ':')
            location++;
#endif
    }
    for (; *location; location++) {
        const int high = uri && *location == '%' ? digit(location[1]) : -1, low = high >= 0 ? digit(location[2]) : -1;
        if (n + sizeof(name) >= PATH)
            return 0;
        path[n++] = low >= 0 ? (char)(16 * high + low) : *location;
        location += low >= 0 ? 2 : 0;
    }
    memcpy(path + n, name, sizeof(name));
    return 1;
}

#ifdef _WIN32
BOOL WINAPI DllMain(HINSTANCE library, DWORD reason, LPVOID reserved) { (void)library; (void)reason; (void)reserved; return TRUE; }
#endif

static FILE *opened(const char *path)
{
#ifdef _WIN32
    WCHAR wide[MAX_PATH];
    return MultiByteToWideChar(CP_UTF8, 0, path, -1, wide, MAX_PATH) > 0 ? _wfopen(wide, L"rb") : 0;
#else
    return fopen(path, "rb");
#endif
}

/* muscle.bin: a mark, the token, and numbers of 64 bits in little-endian order, of which the first is 1. */
typedef struct {
    char mark[8], token[32];
    double one, length, supply, nodes, node[MCKIBBEN_NODES];
    double a[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES], b[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES], v[MCKIBBEN_FUNCTIONS];
} resource;

/* Why the muscle cannot be read; 0 where it is. */
static const char *read_muscle(mckibben_muscle *m, const char *location, const char *token)
{
    char path[PATH];
    resource r;
    FILE *file;
    size_t found;
    if (!location || !path_of(location, path))
        return "the location of the resources is missing or too long";
    file = opened(path);
    if (!file)
        return "resources/muscle.bin of the unit cannot be opened";
    found = fread(&r, sizeof(r), 1, file);
    (void)fclose(file);
    if (found != 1 || memcmp(r.mark, "mckibben", 8) != 0 || !(r.one == 1.0 && r.nodes >= 2.0 && r.nodes <= MCKIBBEN_NODES))
        return "resources/muscle.bin of the unit is damaged: export the muscle again";
    if (!token || strncmp(token, r.token, sizeof(r.token)) != 0)
        return "resources/muscle.bin is of another muscle than modelDescription.xml: export the muscle again";
    memset(m, 0, sizeof(*m));
    m->length = r.length;
    m->supply = r.supply;
    m->nodes = (int)r.nodes;
    memcpy(m->node, r.node, sizeof(r.node));
    memcpy(m->a, r.a, sizeof(r.a));
    memcpy(m->b, r.b, sizeof(r.b));
    memcpy(m->v, r.v, sizeof(r.v));
    return 0;
}

/* An instance, or why there is none. */
static instance *made(const char *location, const char *token, const char **why)
{
    mckibben_muscle read;
    instance *c = 0;
    *why = read_muscle(&read, location, token);
    if (!*why) {
        c = (instance *)malloc(sizeof(*c));
        *why = "memory is short";
    }
    if (c) {
        c->read = read;
        begin(c);
    }
    return c;
}

static int get(const instance *c, fmi2ValueReference vr, double *out)
{
    const double p = c->now.value[PRESSURE], l = c->now.value[LENGTH];
    switch (vr) {
    case PRESSURE: case LENGTH: case FACTOR: *out = c->now.value[vr]; return 1;
    case FORCE: *out = mckibben_force(&c->muscle, p, l, 0); return 1;
    case STIFFNESS: *out = mckibben_stiffness(&c->muscle, p, l); return 1;
    case VOLUME: *out = mckibben_volume(&c->muscle, p, l); return 1;
    case FORCE_PER_PRESSURE: *out = mckibben_force_per_pressure(&c->muscle, p, l); return 1;
    default: return 0;
    }
}

FMI2_EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
FMI2_EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
FMI2_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String names[]) { (void)c; (void)on; (void)n; (void)names; return fmi2OK; }

FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    const char *why;
    instance *c = made(resources, guid, &why);
    (void)type; (void)visible; (void)logging;
    if (!c && callbacks && callbacks->logger)
        callbacks->logger(callbacks->environment, name, fmi2Error, "logStatusError", why);
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
    state s = ((instance *)c)->now;
    for (size_t i = 0; i < n; i++) {
        if (vr[i] > FACTOR || !(value[i] - value[i] == 0.0))
            return fmi2Error;
        s.value[vr[i]] = value[i];
    }
    set_state((instance *)c, &s);
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
        (void)mckibben_force(&of->muscle, of->now.value[PRESSURE], of->now.value[LENGTH], &status);
        value[i] = (fmi2Integer)status;
    }
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Boolean value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2String value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Boolean value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2String value[]) { (void)c; (void)vr; (void)value; return n ? fmi2Error : fmi2OK; }

FMI2_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *saved)
{
    if (!*saved)
        *saved = malloc(sizeof(state));
    if (!*saved)
        return fmi2Error;
    memcpy(*saved, &((instance *)c)->now, sizeof(state));
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate saved) { set_state((instance *)c, (const state *)saved); return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *saved) { (void)c; free(*saved); *saved = 0; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate saved, size_t *size) { (void)c; (void)saved; *size = sizeof(state); return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate saved, fmi2Byte bytes[], size_t size)
{
    (void)c;
    if (size < sizeof(state))
        return fmi2Error;
    memcpy(bytes, saved, sizeof(state));
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *saved)
{
    (void)c;
    if (size != sizeof(state))
        return fmi2Error;
    if (!*saved)
        *saved = malloc(sizeof(state));
    if (!*saved)
        return fmi2Error;
    memcpy(*saved, bytes, sizeof(state));
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
                instance moved = *at;
                state to = at->now;
                const double step = by[j] == PRESSURE ? 1e-5 * at->read.supply : (by[j] == LENGTH ? 1e-6 * at->read.length : 1e-6);
                double up, down;
                if (by[j] > FACTOR)
                    return fmi2Error;
                to.value[by[j]] += step;
                set_state(&moved, &to);
                if (!get(&moved, of[i], &up))
                    return fmi2Error;
                to.value[by[j]] -= 2.0 * step;
                set_state(&moved, &to);
                (void)get(&moved, of[i], &down);
                slope = (up - down) / (2.0 * step);
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
