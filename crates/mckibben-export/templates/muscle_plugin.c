/* The muscle @{name} as a plugin of MuJoCo, "mckibben.@{id}": an actuator of a tendon, whose control is the gauge pressure in Pa.
 * M=$(python3 -c "import mujoco, os; print(os.path.dirname(mujoco.__file__))")
 * cc -O2 -shared -fPIC -I$M/include @{id}_plugin.c mckibben.c $M/libmujoco.so* -lm -o @{id}_plugin.so
 * Load it with mujoco.mj_loadPluginLibrary, and then @{id}_plugin.xml.
 * With <config key="sonic_conductance" value="5e-9"/> (m3/(s Pa)) in the actuator the control is the opening of a valve, -1 to 1: above 0 air flows
 * from the supply into the muscle, below 0 into the atmosphere. Other keys: those of `settings`.
 * @{facts}
 */
#include "@{id}.h"
#include "mckibben_memory.h"
#include <math.h>
#include <mujoco/mujoco.h>
#include <stdlib.h>
#include <string.h>

/* The values of mckibben_air.h. Without a valve there is no sonic conductance. */
enum {
    LENGTH, COMMAND, SUPPLY_PRESSURE, SONIC_CONDUCTANCE, CRITICAL_RATIO, EXHAUST_CONDUCTANCE, EXHAUST_CRITICAL_RATIO, TEMPERATURE, DEAD_VOLUME,
    POLYTROPIC_EXPONENT, HEAT_CONDUCTANCE, INITIAL_PRESSURE, AIR, AIR_MASS
};
typedef struct {
    double value[AIR_MASS + 1];
} values;
#include "mckibben_air.h"

/* What <config> sets, from SUPPLY_PRESSURE on. */
static const char *settings[] = {"supply_pressure", "sonic_conductance", "critical_ratio", "exhaust_conductance", "exhaust_critical_ratio", "temperature",
                                 "dead_volume", "polytropic_exponent", "heat_conductance", "initial_pressure"};
#define SETTINGS (int)(sizeof(settings) / sizeof(settings[0]))

/* The state of an actuator: the air and the memory of friction, whose ends are 0 until the first step. */
typedef struct {
    mjtNum air[2], at, largest, ends, w[MCKIBBEN_ENDS], s[MCKIBBEN_ENDS];
} state;

static mckibben_muscle simulated(void)
{
    mckibben_muscle own = @{id};
    own.beyond = 1;
    return own;
}

static int nstate(const mjModel *m, int instance)
{
    (void)m; (void)instance;
    return (int)(sizeof(state) / sizeof(mjtNum));
}

static int init(const mjModel *m, mjData *d, int instance)
{
    values *own = calloc(1, sizeof(*own));
    if (!own)
        return -1;
    own->value[SUPPLY_PRESSURE] = (double)@{id}.supply;
    own->value[CRITICAL_RATIO] = 0.3;
    own->value[TEMPERATURE] = 293.15;
    own->value[POLYTROPIC_EXPONENT] = 1.0;
    for (int i = 0; i < SETTINGS; i++) {
        const char *text = mj_getPluginConfig(m, instance, settings[i]);
        if (text && *text)
            own->value[SUPPLY_PRESSURE + i] = atof(text);
    }
    if (!(own->value[EXHAUST_CONDUCTANCE] > 0.0)) {
        own->value[EXHAUST_CONDUCTANCE] = own->value[SONIC_CONDUCTANCE];
        own->value[EXHAUST_CRITICAL_RATIO] = own->value[CRITICAL_RATIO];
    }
    d->plugin_data[instance] = (uintptr_t)own;
    return 0;
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
    const mckibben_muscle own = simulated();
    const int i = actuator_of(m, instance);
    values now = *(values *)d->plugin_data[instance];
    mckibben_memory memory;
    mckibben_real pressure, length;
    (void)capability;
    if (i < 0)
        return;
    length = (mckibben_real)(now.value[LENGTH] = d->actuator_length[i]);
    read_state((const state *)(d->plugin_state + m->plugin_stateadr[instance]), &own, &memory, now.value);
    pressure = pressure_of(m, d, i, &own, now.value);
    d->actuator_force[i] = -(mjtNum)(mckibben_force(&own, pressure, length, 0) + mckibben_friction_after(&own, &memory, pressure, length, 0));
}

/* At the end of a step. */
static void advance(const mjModel *m, mjData *d, int instance)
{
    const mckibben_muscle own = simulated();
    const int i = actuator_of(m, instance);
    values now = *(values *)d->plugin_data[instance];
    state *s = (state *)(d->plugin_state + m->plugin_stateadr[instance]);
    mckibben_memory memory;
    if (i < 0)
        return;
    now.value[LENGTH] = d->actuator_length[i];
    read_state(s, &own, &memory, now.value);
    mckibben_moved(&own, &memory, pressure_of(m, d, i, &own, now.value), (mckibben_real)now.value[LENGTH], 0);
    if (now.value[SONIC_CONDUCTANCE] > 0.0) {
        now.value[COMMAND] = control(m, d, i);
        if (!air_step(&own, now.value, m->opt.timestep))
            mju_warning("@{id}: the air changes too fast for the step: a smaller sonic conductance or step, or a larger dead volume");
    }
    s->air[0] = now.value[AIR];
    s->air[1] = now.value[AIR_MASS];
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
    plugin.capabilityflags = mjPLUGIN_ACTUATOR;
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
