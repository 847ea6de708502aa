/* FMI 2.0, Model Exchange and Co-Simulation, around mckibben.c: a muscle whose pressure is an input, without states; a muscle on a valve, with
 * the air of air.c as states; or a joint whose pressures and angle are inputs. Which one, and its numbers, are read from resources/muscle.bin, so
 * that one library serves all muscles and joints.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
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

/* Where errors go, in FMI 2.0 or in FMI 3.0. */
typedef struct {
    const fmi2CallbackFunctions *second;
    void (*third)(void *environment, fmi2Status status, const char *category, const char *message);
    void *environment;
} logger;

/* Value references; modelDescription.xml has these names in small letters. First what is set or integrated. */
enum {
    PRESSURE, LENGTH, FORCE_FACTOR, COMMAND, SUPPLY_PRESSURE, SONIC_CONDUCTANCE, CRITICAL_RATIO, EXHAUST_CONDUCTANCE, EXHAUST_CRITICAL_RATIO,
    TEMPERATURE, DEAD_VOLUME, POLYTROPIC_EXPONENT, HEAT_CONDUCTANCE, INITIAL_PRESSURE, FRICTION_FACTOR, CORD, PRESSURE_1, PRESSURE_2, ANGLE, AIR, AIR_MASS,
    FORCE, STIFFNESS, VOLUME, FORCE_PER_PRESSURE, STATUS, TIME, AIR_TEMPERATURE, AIR_RATE, AIR_FLOW, COMMAND_SIGN, COMMAND_LIMIT, TAUT,
    TORQUE, TORQUE_STIFFNESS, TORQUE_PER_PRESSURE_1, TORQUE_PER_PRESSURE_2
};
#define KNOWN FORCE
#define EVENTS 3 /* indicators, from COMMAND_SIGN on */

#include "air.c"

/* What changes: plain numbers. */
typedef struct {
    double value[KNOWN], time, begun;
    mckibben_memory memory[2]; /* of friction, of each muscle */
} state;

/* Of a variable that can be set: value at the start, range, size. Not a number where it cannot be. */
typedef struct {
    double start, low, high, nominal;
} variable;

typedef struct {
    state now;
    int states;                   /* how many: 0, or 2 on a valve */
    variable variables[KNOWN];
    mckibben_muscle read[2], muscle[2]; /* as they were read; with their pull multiplied */
    mckibben_joint joint;         /* of a unit of a muscle without muscles */
    logger log;
} instance;

static void failed(logger to, const char *why)
{
    if (to.third)
        to.third(to.environment, fmi2Error, "logStatusError", why);
    else if (to.second && to.second->logger)
        to.second->logger(to.second->environment, "muscle", fmi2Error, "logStatusError", "%s", why);
}

/* Length of a muscle as it is now. */
static double length_of(const instance *c, int i)
{
    double arm, slope;
    return c->joint.muscles ? mckibben_path_length(&c->joint.path[i], c->now.value[ANGLE], &arm, &slope) : c->now.value[LENGTH];
}

static int muscles_of(const instance *c) { return c->joint.muscles ? c->joint.muscles : 1; }

/* Until the simulation begins, the air follows from the pressure. */
static void set_state(instance *c, const state *s)
{
    c->now = *s;
    for (int n = 0; n < muscles_of(c); n++) {
        mckibben_muscle *m = &c->muscle[n];
        *m = mckibben_scaled(&c->read[n], s->value[FORCE_FACTOR], s->value[FRICTION_FACTOR]);
        c->joint.muscle[n] = m;
        if (!c->joint.muscles)
            m->cord = s->value[CORD];
        if (!(s->begun > 0.0))
            mckibben_rest(&c->now.memory[n], length_of(c, n));
    }
    if (c->states && !(s->begun > 0.0))
        fill(c->muscle, c->now.value, s->value[INITIAL_PRESSURE]);
}

static void begin(instance *c)
{
    state s;
    memset(&s, 0, sizeof(s));
    for (int i = 0; i < KNOWN; i++)
        s.value[i] = c->variables[i].start;
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

/* muscle.bin: a mark, the token, and numbers of 64 bits in little-endian order, of which the first is 3. A joint has its own numbers; of a unit of a
 * muscle they are zeros. */
typedef struct {
    double length, cord, supply, nodes, node[MCKIBBEN_NODES];
    double a[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES], b[MCKIBBEN_FUNCTIONS][MCKIBBEN_NODES], v[MCKIBBEN_FUNCTIONS], friction[7];
} numbers;
typedef struct {
    char mark[8], token[32];
    double three, states, muscles;
    variable variables[KNOWN];
    numbers muscle[2];
    mckibben_path path[3];
    double rope[2], torsion[2], weight[2], range[2];
} resource;

/* The numbers of an instance; why they are none of its, or 0. */
static const char *understood(instance *c, const resource *r, const char *token)
{
    static const char *damaged = "resources/muscle.bin of the unit is damaged: export the muscle again";
    if (memcmp(r->mark, "mckibben", 8) != 0 || !(r->three == 3.0 && r->muscles >= 0.0 && r->muscles <= 2.0))
        return damaged;
    if (!token || strncmp(token, r->token, sizeof(r->token)) != 0)
        return "resources/muscle.bin is of another muscle than modelDescription.xml: export the muscle again";
    c->joint.muscles = (int)r->muscles;
    for (int i = 0; i < muscles_of(c); i++) {
        mckibben_muscle *m = &c->read[i];
        const numbers *from = &r->muscle[i];
        if (!(from->nodes >= 2.0 && from->nodes <= MCKIBBEN_NODES))
            return damaged;
        memcpy(m->friction, from->friction, sizeof(from->friction));
        m->beyond = 1;
        m->length = from->length;
        m->cord = from->cord;
        m->supply = from->supply;
        m->nodes = (int)from->nodes;
        memcpy(m->node, from->node, sizeof(from->node));
        memcpy(m->a, from->a, sizeof(from->a));
        memcpy(m->b, from->b, sizeof(from->b));
        memcpy(m->v, from->v, sizeof(from->v));
    }
    memcpy(c->joint.path, r->path, sizeof(r->path));
    memcpy(c->joint.rope, r->rope, sizeof(r->rope));
    memcpy(c->joint.torsion, r->torsion, sizeof(r->torsion));
    memcpy(c->joint.weight, r->weight, sizeof(r->weight));
    memcpy(c->joint.range, r->range, sizeof(r->range));
    memcpy(c->variables, r->variables, sizeof(r->variables));
    c->states = (int)r->states;
    return 0;
}

/* Why the muscle cannot be read; 0 where it is. */
static const char *read_muscle(instance *c, const char *location, const char *token)
{
    char path[PATH];
    resource *r;
    FILE *file;
    const char *why = "memory is short";
    if (!location || !path_of(location, path))
        return "the location of the resources is missing or too long";
    file = opened(path);
    if (!file)
        return "resources/muscle.bin of the unit cannot be opened";
    r = (resource *)malloc(sizeof(*r));
    if (r) {
        const size_t found = fread(r, sizeof(*r), 1, file);
        why = found == 1 ? understood(c, r, token) : "resources/muscle.bin of the unit is damaged: export the muscle again";
    }
    free(r);
    (void)fclose(file);
    return why;
}

/* An instance; 0 where there is none, with the reason in the log. */
static instance *made(const char *location, const char *token, logger log)
{
    instance *c = (instance *)malloc(sizeof(*c));
    const char *why = c ? read_muscle(c, location, token) : "memory is short";
    if (why) {
        failed(log, why);
        free(c);
        return 0;
    }
    c->log = log;
    begin(c);
    return c;
}

static double pressure_of(const instance *c) { return c->states ? air_pressure(c->muscle, c->now.value) : c->now.value[PRESSURE]; }

/* A joint's torque, with the friction of its muscles; what it does per angle and per pressure; its status. The pressures are values one after the other. */
static double torque_of(const instance *c, double *stiffness, double per_pressure[], unsigned *status)
{
    const double *x = c->now.value, *p = x + PRESSURE_1;
    double torque = mckibben_joint_torque(&c->joint, p, x[ANGLE], stiffness, per_pressure, status);
    for (int i = 0; i < c->joint.muscles; i++) {
        double arm, slope;
        const double length = mckibben_path_length(&c->joint.path[i], x[ANGLE], &arm, &slope);
        torque += arm * mckibben_friction_after(&c->muscle[i], &c->now.memory[i], p[i], length, 0);
    }
    return torque;
}

/* A variable at the pressure in the muscle; 0 where there is none. */
static int get(const instance *c, double p, fmi2ValueReference vr, double *out)
{
    const double *x = c->now.value, l = x[LENGTH], command = x[COMMAND];
    double rates[2], sums[3];
    coefficients k;
    if (vr >= TORQUE ? !c->joint.muscles : vr > FORCE_PER_PRESSURE && vr != TIME && !c->states)
        return 0;
    switch (vr) {
    case PRESSURE: *out = p; return 1;
    case TORQUE: *out = torque_of(c, 0, 0, 0); return 1;
    case TORQUE_STIFFNESS: case TORQUE_PER_PRESSURE_1: case TORQUE_PER_PRESSURE_2:
        (void)torque_of(c, sums, sums + 1, 0);
        *out = sums[vr - TORQUE_STIFFNESS];
        return 1;
    case FORCE: *out = mckibben_force(c->muscle, p, l, 0) + mckibben_friction_after(c->muscle, c->now.memory, p, l, 0); return 1;
    case STIFFNESS: *out = mckibben_stiffness(c->muscle, p, l, 0); return 1;
    case VOLUME: *out = mckibben_volume(c->muscle, p, l, 0); return 1;
    case FORCE_PER_PRESSURE: *out = mckibben_force_per_pressure(c->muscle, p, l, 0); return 1;
    case TIME: *out = c->now.time; return 1;
    case AIR_TEMPERATURE: *out = air_temperature(c->muscle, x, p); return 1;
    case AIR_RATE: case AIR_FLOW:
        air_rates(c->muscle, x, p, rates);
        *out = rates[vr == AIR_FLOW];
        return 1;
    case COMMAND_SIGN: *out = command; return 1;
    case COMMAND_LIMIT: *out = 1.0 - fabs(command); return 1;
    case TAUT: *out = two_sided(c->muscle, p, contraction_of(c->muscle, l), &k, 0); return 1;
    default: *out = vr < KNOWN ? x[vr] : 0.0; return vr < KNOWN;
    }
}

FMI2_EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
FMI2_EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
FMI2_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String names[]) { (void)c; (void)on; (void)n; (void)names; return fmi2OK; }

FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    const logger log = {callbacks, 0, 0};
    (void)name; (void)type; (void)visible; (void)logging;
    return made(resources, guid, log);
}
FMI2_EXPORT void fmi2FreeInstance(fmi2Component c) { free(c); }
FMI2_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerant, fmi2Real tolerance, fmi2Real start, fmi2Boolean stops, fmi2Real stop) { (void)tolerant; (void)tolerance; (void)stops; (void)stop; ((instance *)c)->now.time = start; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) { ((instance *)c)->now.begun = 1.0; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2Terminate(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2Reset(fmi2Component c) { begin((instance *)c); return fmi2OK; }

FMI2_EXPORT fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real value[])
{
    const instance *of = (const instance *)c;
    const double p = pressure_of(of);
    for (size_t i = 0; i < n; i++)
        if (!get(of, p, vr[i], &value[i]))
            return fmi2Error;
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real value[])
{
    instance *of = (instance *)c;
    state s = of->now;
    for (size_t i = 0; i < n; i++) {
        if (vr[i] >= KNOWN || !(value[i] >= of->variables[vr[i]].low && value[i] <= of->variables[vr[i]].high)) {
            failed(of->log, "a value is outside of its range: see min and max of the variable in modelDescription.xml");
            return fmi2Error;
        }
        s.value[vr[i]] = value[i];
    }
    set_state(of, &s);
    return fmi2OK;
}
/* The only integer is the status. */
FMI2_EXPORT fmi2Status fmi2GetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Integer value[])
{
    const instance *of = (const instance *)c;
    unsigned status;
    if (of->joint.muscles)
        (void)torque_of(of, 0, 0, &status);
    else
        (void)mckibben_force(of->muscle, pressure_of(of), of->now.value[LENGTH], &status);
    for (size_t i = 0; i < n; i++) {
        if (vr[i] != STATUS)
            return fmi2Error;
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

/* A slope by central differences; `moved` is another instance. */
static int slope_of(const instance *at, instance *moved, fmi2ValueReference of, fmi2ValueReference by, double *slope)
{
    const double step = 1e-6 * at->variables[by].nominal;
    state to = at->now;
    double up, down;
    *moved = *at;
    to.value[by] += step;
    set_state(moved, &to);
    if (!get(moved, pressure_of(moved), of, &up))
        return 0;
    to.value[by] -= 2.0 * step;
    set_state(moved, &to);
    (void)get(moved, pressure_of(moved), of, &down);
    *slope = (up - down) / (2.0 * step);
    return 1;
}

/* By differences, but of the pull by pressure and length. */
FMI2_EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference of[], size_t n, const fmi2ValueReference by[], size_t m, const fmi2Real direction[], fmi2Real out[])
{
    const instance *at = (const instance *)c;
    instance *moved = (instance *)malloc(sizeof(*moved));
    const double p = pressure_of(at);
    const int analytic = !at->states && !(mckibben_friction_limit(at->muscle, at->muscle->supply, at->muscle->length) > 0.0);
    int known = moved != 0;
    for (size_t i = 0; i < n; i++) {
        out[i] = 0.0;
        for (size_t j = 0; j < m && known; j++) {
            double slope = 0.0;
            if (by[j] >= KNOWN)
                known = 0;
            else if (analytic && of[i] == FORCE && by[j] == LENGTH)
                (void)get(at, p, STIFFNESS, &slope);
            else if (analytic && of[i] == FORCE && by[j] == PRESSURE)
                (void)get(at, p, FORCE_PER_PRESSURE, &slope);
            else
                known = slope_of(at, moved, of[i], by[j], &slope);
            out[i] += slope * direction[j];
        }
    }
    free(moved);
    return known ? fmi2OK : fmi2Error;
}

/* The friction of each muscle follows its pressure and its length. */
static void moved(instance *c)
{
    for (int i = 0; i < muscles_of(c); i++) {
        const double pressure = c->joint.muscles ? c->now.value[PRESSURE_1 + i] : pressure_of(c);
        mckibben_moved(&c->muscle[i], &c->now.memory[i], pressure, length_of(c, i), 0);
    }
}

/* Model Exchange. A kink of the equations is an event: the integrator begins anew, and nothing jumps. */
FMI2_EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) { (void)c; memset(info, 0, sizeof(*info)); return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { (void)c; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean final, fmi2Boolean *event, fmi2Boolean *stop) 
{
    (void)final;
    moved((instance *)c);
    *event = *stop = 0;
    return fmi2OK;
}
FMI2_EXPORT fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time) { ((instance *)c)->now.time = time; return fmi2OK; }
FMI2_EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n)
{
    instance *of = (instance *)c;
    if (n != (size_t)of->states)
        return fmi2Error;
    for (size_t i = 0; i < n; i++)
        of->now.value[AIR + i] = x[i];
    return fmi2OK;
}
/* Variables one after the other. */
static fmi2Status in_order(fmi2Component c, fmi2ValueReference first, double x[], size_t n, size_t wanted)
{
    fmi2Status status = n == wanted ? fmi2OK : fmi2Error;
    for (size_t i = 0; i < n && status == fmi2OK; i++, first++)
        status = fmi2GetReal(c, &first, 1, &x[i]);
    return status;
}
static size_t states_of(fmi2Component c) { return (size_t)((instance *)c)->states; }
static size_t events_of(fmi2Component c) { return states_of(c) ? EVENTS : 0; }
FMI2_EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real x[], size_t n) { return in_order(c, AIR_RATE, x, n, states_of(c)); }
FMI2_EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real x[], size_t n) { return in_order(c, COMMAND_SIGN, x, n, events_of(c)); }
FMI2_EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) { return in_order(c, AIR, x, n, states_of(c)); }
FMI2_EXPORT fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x[], size_t n)
{
    if (n != states_of(c))
        return fmi2Error;
    for (size_t i = 0; i < n; i++)
        x[i] = ((instance *)c)->variables[AIR + i].nominal;
    return fmi2OK;
}

/* Co-Simulation. */
FMI2_EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer order[], const fmi2Real value[]) { (void)c; (void)vr; (void)order; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer order[], fmi2Real value[]) { (void)c; (void)vr; (void)order; (void)value; return n ? fmi2Error : fmi2OK; }
FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real at, fmi2Real step, fmi2Boolean final)
{
    instance *of = (instance *)c;
    (void)final;
    of->now.time = at + step;
    moved(of);
    if (!of->states || air_step(of->muscle, of->now.value, step))
        return fmi2OK;
    failed(of->log, "the air changes too fast for the step: a smaller sonic conductance or step, or a larger dead volume");
    return fmi2Error;
}
FMI2_EXPORT fmi2Status fmi2CancelStep(fmi2Component c) { (void)c; return fmi2Error; }
FMI2_EXPORT fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind s, fmi2Status *value) { (void)c; (void)s; *value = fmi2OK; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *value) { (void)c; (void)s; *value = 0.0; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind s, fmi2Integer *value) { (void)c; (void)s; *value = 0; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *value) { (void)c; (void)s; *value = 0; return fmi2Discard; }
FMI2_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind s, fmi2String *value) { (void)c; (void)s; *value = ""; return fmi2Discard; }
