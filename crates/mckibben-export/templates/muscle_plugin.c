/* The muscle @{name} as a plugin of MuJoCo, "mckibben.@{id}": an actuator of a tendon, whose control is the gauge pressure in Pa.
 * M=$(python3 -c "import mujoco, os; print(os.path.dirname(mujoco.__file__))")
 * cc -O2 -shared -fPIC -I$M/include @{id}_plugin.c mckibben.c $M/libmujoco.so* -lm -o @{id}_plugin.so
 * Load it with mujoco.mj_loadPluginLibrary, and then @{id}_plugin.xml.
 * @{facts}
 */
#include "@{id}.h"
#include <mujoco/mujoco.h>

static int nstate(const mjModel *m, int instance)
{
    (void)m; (void)instance;
    return 0;
}

static int init(const mjModel *m, mjData *d, int instance)
{
    (void)m; (void)d; (void)instance;
    return 0;
}

static void reset(const mjModel *m, mjtNum *state, void *data, int instance)
{
    (void)m; (void)state; (void)data; (void)instance;
}

/* MuJoCo counts a force that makes the tendon longer as positive. */
static void compute(const mjModel *m, mjData *d, int instance, int capability)
{
    mckibben_muscle own = @{id};
    (void)capability;
    own.beyond = 1;
    for (int i = 0; i < m->nu; i++) {
        if (m->actuator_plugin[i] == instance) {
            const mjtNum *range = m->actuator_ctrlrange + 2 * i;
            const mjtNum pressure = m->actuator_ctrllimited[i] ? mju_clip(d->ctrl[i], range[0], range[1]) : d->ctrl[i];
            d->actuator_force[i] = -(mjtNum)mckibben_force(&own, (mckibben_real)pressure, (mckibben_real)d->actuator_length[i], 0);
        }
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
    plugin.nstate = nstate;
    plugin.init = init;
    plugin.reset = reset;
    plugin.compute = compute;
    (void)mjp_registerPlugin(&plugin);
}
