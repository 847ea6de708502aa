/* cc -O2 @{id}_example.c mckibben.c -lm -o example && ./example
 * Made by mckibben @{version}.
 */
#ifndef ARDUINO /* a sketch has its own main */
#include "@{id}.h"
#include <stdio.h>

int main(void)
{
    unsigned status;
    mckibben_real p[2] = {0}, limits[2], stiffness, per_pressure[2] = {0};
    const mckibben_real angle = MCKIBBEN_R(0.5) * (@{id}.range[0] + @{id}.range[1]);
    mckibben_joint_limits(&@{id}, angle, limits);
    printf("at %.3f rad it gives %.2f to %.2f N m\n", (double)angle, (double)limits[0], (double)limits[1]);
    mckibben_joint_pressures(&@{id}, angle, MCKIBBEN_R(0.5) * (limits[0] + limits[1]), MCKIBBEN_R(0), p, limits, &status);
    const mckibben_real torque = mckibben_joint_torque(&@{id}, p, angle, &stiffness, per_pressure, 0);
    printf("%.0f and %.0f Pa (status %u): %.3f N m, %.2f N m/rad, %.2e N m/Pa of the first\n", (double)p[0], (double)p[1], status, (double)torque,
           (double)stiffness, (double)per_pressure[0]);
    printf("with this torque its stiffness can be %.2f to %.2f N m/rad\n", (double)limits[0], (double)limits[1]);
    return 0;
}
#endif
