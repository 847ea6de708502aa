/* The inverse on a branch of the hysteresis. It needs mckibben.h and mckibben.c.
 * @{facts}
 */
#ifndef MCKIBBEN_BRANCH_H
#define MCKIBBEN_BRANCH_H

#include "mckibben.h"

/* Pressure at which the muscle pulls with `force` at a length while it shortens (branch -1), while it lengthens (1), or in the mean of both (0):
 * 40 halvings. MCKIBBEN_NO_ANSWER where the supply is too low for it; `status` may be 0. */
static inline mckibben_real mckibben_pressure_on(const mckibben_muscle *m, mckibben_real force, mckibben_real length, int branch, unsigned *status)
{
    unsigned found = MCKIBBEN_OK;
    const mckibben_real mean = mckibben_pressure(m, force, length, &found);
    mckibben_real low = branch < 0 ? mean : mckibben_pressure(m, MCKIBBEN_R(0), length, 0);
    mckibben_real high = branch < 0 ? m->supply : mean;
    int lowered = branch >= 0, i;
    if (branch != 0 && low < high) {
        for (i = 0; i < 40; i++) {
            const mckibben_real middle = MCKIBBEN_R(0.5) * (low + high);
            const mckibben_real friction = mckibben_friction(m, middle, (mckibben_real)branch, MCKIBBEN_R(0));
            if (mckibben_force(m, middle, length, 0) + friction < force) {
                low = middle;
            } else {
                high = middle;
                lowered = 1;
            }
        }
        if (!lowered)
            found |= MCKIBBEN_NO_ANSWER;
    } else {
        high = mean;
    }
    if (status)
        *status = found;
    return high;
}

#endif
