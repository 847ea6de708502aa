/* Friction with memory. It needs mckibben.h and mckibben.c.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
 *
 * Elements that stick and slip in parallel, their yields spread evenly from 0 to f2: from rest the share of the friction is a parabola in the way,
 * twice as wide after a turn (Masing). A branch that comes back to the turn before the last one closes a loop, and goes on as if the loop had not
 * been (Madelung). The share depends on the turns that are remembered, not on the speed.
 */
#ifndef MCKIBBEN_MEMORY_H
#define MCKIBBEN_MEMORY_H

#include "mckibben.h"
#include <math.h>

/* The lengths at which the motion turned, with the share of the friction there; of more turns the innermost loop is forgotten. */
#define MCKIBBEN_TURNS 12
typedef struct {
    mckibben_real at[MCKIBBEN_TURNS], share[MCKIBBEN_TURNS];
    int turns;
} mckibben_memory;

/* Begins at a length, with nothing that slides. */
static inline void mckibben_rest(mckibben_memory *memory, mckibben_real length)
{
    for (int i = 0; i < MCKIBBEN_TURNS; i++)
        memory->at[i] = memory->share[i] = MCKIBBEN_R(0);
    memory->at[0] = length;
    memory->turns = 1;
}

/* How many turns are remembered at a length, and the share there: positive where the muscle has become longer. */
static inline int mckibben_share(const mckibben_muscle *m, const mckibben_memory *memory, mckibben_real length, mckibben_real *share)
{
    const mckibben_real yield = m->friction[2] > MCKIBBEN_R(0) ? m->friction[2] : MCKIBBEN_R(1e-6) * m->length;
    int n = memory->turns;
    mckibben_real way, width, sticks;
    for (; n > 1; n--) {
        const mckibben_real leg = memory->at[n - 1] - memory->at[n - 2], closing = n > 2 ? leg : MCKIBBEN_R(2) * leg;
        way = length - memory->at[n - 1];
        if (way * leg < MCKIBBEN_R(0)) {
            if (way * way < closing * closing)
                break;
            n -= n > 2;
        }
    }
    way = length - memory->at[n - 1];
    width = n > 1 ? MCKIBBEN_R(2) : MCKIBBEN_R(1);
    sticks = MCKIBBEN_R(1) - (way < MCKIBBEN_R(0) ? -way : way) / (width * yield);
    sticks = sticks > MCKIBBEN_R(0) ? sticks : MCKIBBEN_R(0);
    *share = memory->share[n - 1] + (way < MCKIBBEN_R(0) ? -width : width) * (MCKIBBEN_R(1) - sticks * sticks);
    return n;
}

/* After each step: the motion went to a length, and may turn there. */
static inline void mckibben_moved(const mckibben_muscle *m, mckibben_memory *memory, mckibben_real length)
{
    mckibben_real share;
    const int n = mckibben_share(m, memory, length, &share);
    if (!(length - length == MCKIBBEN_R(0))) /* not a number */
        return;
    memory->turns = n < MCKIBBEN_TURNS ? n : n - 2;
    memory->at[memory->turns] = length;
    memory->share[memory->turns++] = share;
}

/* What friction adds to the pull at a length to which the motion goes without a turn; with it the muscle never pushes. */
static inline mckibben_real mckibben_friction_after(const mckibben_muscle *m, const mckibben_memory *memory, mckibben_real pressure, mckibben_real length,
                                                    unsigned *status)
{
    mckibben_real share, rest;
    (void)mckibben_share(m, memory, length, &share);
    rest = MCKIBBEN_R(1) - share * share; /* a velocity and a smoothing that make this share */
    return mckibben_friction(m, pressure, length, share, rest > MCKIBBEN_R(0) ? (mckibben_real)sqrt((double)rest) : MCKIBBEN_R(0), status);
}

#endif
