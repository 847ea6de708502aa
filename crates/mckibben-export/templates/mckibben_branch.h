/* The inverse on a branch of the hysteresis. It needs mckibben.h and mckibben.c.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
 */
#ifndef MCKIBBEN_BRANCH_H
#define MCKIBBEN_BRANCH_H

#include "mckibben.h"

/* Pressure at which the muscle pulls with `force` at a length while it shortens (branch -1), while it lengthens (1), or in the mean of both (0):
 * 40 halvings. The supply and MCKIBBEN_NO_ANSWER where the supply is too low for it; `status` may be 0. */
static inline mckibben_real mckibben_pressure_on(const mckibben_muscle *m, mckibben_real force, mckibben_real length, int branch, unsigned *status)
{
    unsigned found;
    const mckibben_real mean = mckibben_pressure(m, force, length, &found);
    mckibben_real low = MCKIBBEN_R(0), high = m->supply, middle = high;
    /* Without pressure there is no friction: what has no answer there has none on a branch. */
    if (branch == 0 || ((found & MCKIBBEN_NO_ANSWER) && mean <= MCKIBBEN_R(0))) {
        high = mean;
    } else {
        found |= MCKIBBEN_NO_ANSWER;
        for (int i = 0; i < 41; i++, middle = MCKIBBEN_R(0.5) * (low + high)) {
            const mckibben_real friction = mckibben_friction(m, middle, length, (mckibben_real)branch, MCKIBBEN_R(0), 0);
            if (mckibben_force(m, middle, length, 0) + friction < force) {
                low = middle;
            } else {
                high = middle;
                found &= ~MCKIBBEN_NO_ANSWER;
            }
        }
    }
    if (status)
        *status = found;
    return high;
}

#endif
