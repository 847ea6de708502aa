/* The muscle @{name} as a plugin of MuJoCo, "mckibben.@{id}": an actuator of a tendon, whose control is the gauge pressure in Pa.
 * M=$(python3 -c "import mujoco, os; print(os.path.dirname(mujoco.__file__))")
 * cc -O2 -shared -fPIC -I$M/include @{id}_plugin.c mckibben.c $M/libmujoco.so* -lm -o @{id}_plugin.so
 * Load it with mujoco.mj_loadPluginLibrary, and then @{id}.xml. A sensor of the same instance has gauge pressure in Pa, pull in N and contraction.
 * With <config key="sonic_conductance" value="5e-9"/> (m3/(s Pa)) in the instance the control is the opening of a valve, -1 to 1: above 0 air flows
 * from the supply into the muscle, below 0 into the atmosphere. Other keys: those of `settings`, as of the FMU.
 * Made by mckibben @{version}.
 */
#include "@{id}.h"
#include <math.h>
#include <mujoco/mujoco.h>
#include <stdlib.h>
#include <string.h>

/* The values of mckibben_air.h. Without a valve there is no sonic conductance. */
enum {
    LENGTH, COMMAND, SUPPLY_PRESSURE, SONIC_CONDUCTANCE, CRITICAL_RATIO, EXHAUST_CONDUCTANCE, EXHAUST_CRITICAL_RATIO, TEMPERATURE, DEAD_VOLUME,
    POLYTROPIC_EXPONENT, HEAT_CONDUCTANCE, INITIAL_PRESSURE, FORCE_FACTOR, FRICTION_FACTOR, CORD, AIR, AIR_MASS, VALUES
};
#include "mckibben_air.h"

/* What <config> sets, from SUPPLY_PRESSURE on. */
static const char *settings[] = {"supply_pressure", "sonic_conductance", "critical_ratio", "exhaust_conductance", "exhaust_critical_ratio", "temperature",
                                 "dead_volume", "polytropic_exponent", "heat_conductance", "initial_pressure", "force_factor", "friction_factor",
                                 "cord"};
#define SETTINGS (int)(sizeof(settings) / sizeof(settings[0]))

/* The state of an actuator: the air and the memory of friction, whose ends are 0 until the first step. */
typedef struct {
    mjtNum air[2], at, largest, ends, w[MCKIBBEN_ENDS], s[MCKIBBEN_ENDS];
} state;

/* What an instance is. */
typedef struct {
    mckibben_muscle muscle;
    double value[VALUES];
} instance_data;

static int nstate(const mjModel *m, int instance)
{
    (void)m; (void)instance;
    return (int)(sizeof(state) / sizeof(mjtNum));
}

static int init(const mjModel *m, mjData *d, int instance)
{
    instance_data *own = calloc(1, sizeof(*own));
    double *x = own ? own->value : 0;
    if (!own)
        return -1;
    x[SUPPLY_PRESSURE] = (double)@{id}.supply;
    x[CRITICAL_RATIO] = 0.3;
    x[TEMPERATURE] = 293.15;
    x[POLYTROPIC_EXPONENT] = x[FORCE_FACTOR] = x[FRICTION_FACTOR] = 1.0;
    x[CORD] = (double)@{id}.cord;
    for (int i = 0; i < SETTINGS; i++) {
        const char *text = mj_getPluginConfig(m, instance, settings[i]);
        if (text && *text)
            x[SUPPLY_PRESSURE + i] = atof(text);
    }
    if (!(x[EXHAUST_CONDUCTANCE] > 0.0)) {
        x[EXHAUST_CONDUCTANCE] = x[SONIC_CONDUCTANCE];
        x[EXHAUST_CRITICAL_RATIO] = x[CRITICAL_RATIO];
    }
    own->muscle = mckibben_scaled(&@{id}, (mckibben_real)x[FORCE_FACTOR], (mckibben_real)x[FRICTION_FACTOR]);
    own->muscle.cord = (mckibben_real)x[CORD];
    own->muscle.beyond = 1;
    d->plugin_data[instance] = (uintptr_t)own;
    return 0;
}

/* A sensor has pressure, pull and contraction. */
static int nsensordata(const mjModel *m, int instance, int sensor)
{
    (void)m; (void)instance; (void)sensor;
    return 3;
}

static void destroy(mjData *d, int instance)
{
    free((void *)d->plugin_data[instance]);
    d->plugin_data[instance] = 0;
}

static void reset(const mjModel *m, mjtNum *plugin_state, void *data, int instance)
{
    (void)m; (void)data; (void)instance;
    memset(plugin_state, 0, sizeof(state));
}

/* The actuator of an instance; -1 where there is none. */
static int actuator_of(const mjModel *m, int instance)
{
    for (int i = 0; i < m->nu; i++)
        if (m->actuator_plugin[i] == instance)
            return i;
    return -1;
}

/* Memory and air from a state, or as they begin at the length of now. */
static void read_state(const state *s, const mckibben_muscle *own, mckibben_memory *memory, double x[])
{
    mckibben_rest(memory, (mckibben_real)x[LENGTH]);
    if (!(s->ends >= 2 && s->ends <= MCKIBBEN_ENDS)) {
        if (x[SONIC_CONDUCTANCE] > 0.0)
            fill(own, x, x[INITIAL_PRESSURE]);
        return;
    }
    memory->at = (mckibben_real)s->at;
    memory->largest = (mckibben_real)s->largest;
    memory->ends = (int)s->ends;
    for (int i = 0; i < MCKIBBEN_ENDS; i++) {
        memory->w[i] = (mckibben_real)s->w[i];
        memory->s[i] = (mckibben_real)s->s[i];
    }
    x[AIR] = s->air[0];
    x[AIR_MASS] = s->air[1];
}

static mjtNum control(const mjModel *m, const mjData *d, int i)
{
    const mjtNum *range = m->actuator_ctrlrange + 2 * i;
    return m->actuator_ctrllimited[i] ? mju_clip(d->ctrl[i], range[0], range[1]) : d->ctrl[i];
}

/* The pressure in the muscle. */
static mckibben_real pressure_of(const mjModel *m, const mjData *d, int i, const mckibben_muscle *own, const double x[])
{
    return (mckibben_real)(x[SONIC_CONDUCTANCE] > 0.0 ? air_pressure(own, x) : control(m, d, i));
}

/* MuJoCo counts a force that makes the tendon longer as positive. */
static void compute(const mjModel *m, mjData *d, int instance, int capability)
{
    instance_data own = *(const instance_data *)d->plugin_data[instance];
    const int i = actuator_of(m, instance);
    mckibben_memory memory;
    mckibben_real pressure, length, pull;
    if (i < 0)
        return;
    length = (mckibben_real)(own.value[LENGTH] = d->actuator_length[i]);
    read_state((const state *)(d->plugin_state + m->plugin_stateadr[instance]), &own.muscle, &memory, own.value);
    pressure = pressure_of(m, d, i, &own.muscle, own.value);
    pull = mckibben_force(&own.muscle, pressure, length, 0) + mckibben_friction_after(&own.muscle, &memory, pressure, length, 0);
    if (capability == mjPLUGIN_ACTUATOR)
        d->actuator_force[i] = -(mjtNum)pull;
    for (int k = 0; capability == mjPLUGIN_SENSOR && k < m->nsensor; k++) {
        if (m->sensor_type[k] == mjSENS_PLUGIN && m->sensor_plugin[k] == instance) {
            mjtNum *out = d->sensordata + m->sensor_adr[k];
            out[0] = pressure;
            out[1] = pull;
            out[2] = 1.0 - (length - own.muscle.cord) / own.muscle.length;
        }
    }
}

/* At the end of a step. */
static void advance(const mjModel *m, mjData *d, int instance)
{
    instance_data own = *(const instance_data *)d->plugin_data[instance];
    double *x = own.value;
    const int i = actuator_of(m, instance);
    state *s = (state *)(d->plugin_state + m->plugin_stateadr[instance]);
    mckibben_memory memory;
    if (i < 0)
        return;
    x[LENGTH] = d->actuator_length[i];
    read_state(s, &own.muscle, &memory, x);
    mckibben_moved(&own.muscle, &memory, pressure_of(m, d, i, &own.muscle, x), (mckibben_real)x[LENGTH], 0);
    if (x[SONIC_CONDUCTANCE] > 0.0) {
        x[COMMAND] = control(m, d, i);
        if (!air_step(&own.muscle, x, m->opt.timestep))
            mju_warning("@{id}: the air changes too fast for the step: a smaller sonic conductance or step, or a larger dead volume");
    }
    s->air[0] = x[AIR];
    s->air[1] = x[AIR_MASS];
    s->at = memory.at;
    s->largest = memory.largest;
    s->ends = memory.ends;
    for (int k = 0; k < MCKIBBEN_ENDS; k++) {
        s->w[k] = memory.w[k];
        s->s[k] = memory.s[k];
    }
}

#ifdef __GNUC__
__attribute__((constructor)) static void registered(void)
#else
mjPLUGIN_LIB_INIT(@{id})
#endif
{
    mjpPlugin plugin;
    mjp_defaultPlugin(&plugin);
    plugin.name = "mckibben.@{id}";
    plugin.capabilityflags = mjPLUGIN_ACTUATOR | mjPLUGIN_SENSOR;
    plugin.needstage = mjSTAGE_ACC;
    plugin.nsensordata = nsensordata;
    plugin.nattribute = SETTINGS;
    plugin.attributes = settings;
    plugin.nstate = nstate;
    plugin.init = init;
    plugin.destroy = destroy;
    plugin.reset = reset;
    plugin.compute = compute;
    plugin.advance = advance;
    (void)mjp_registerPlugin(&plugin);
}
