/* cc -O2 @{id}_example.c mckibben.c -lm -o example && ./example
 * Made by mckibben @{version}.
 */
#ifndef ARDUINO /* a sketch has its own main */
#include "@{id}.h"
#include <stdio.h>

int main(void)
{
    unsigned status;
    const mckibben_real pressure = MCKIBBEN_R(0.5) * @{id}.supply, length = @{id}.cord + MCKIBBEN_R(0.95) * @{id}.length;
    const mckibben_real force = mckibben_force(&@{id}, pressure, length, &status);
    printf("%.0f Pa, %.4f m: %.3f N (status %u), %.1f N/m, %.4e m3\n", (double)pressure, (double)length, (double)force, status,
           (double)mckibben_stiffness(&@{id}, pressure, length, 0), (double)mckibben_volume(&@{id}, pressure, length, 0));
    printf("%.3f N at this length: %.1f Pa\n", (double)force, (double)mckibben_pressure(&@{id}, force, length, &status));
    return 0;
}
#endif
