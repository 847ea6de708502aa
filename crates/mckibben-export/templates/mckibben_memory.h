/* Friction with memory. It needs mckibben.h and mckibben.c.
 * Made by mckibben @{version}; the same for all muscles. Licence: MIT OR Apache-2.0.
 *
 * Elements that stick and slip in parallel, all of one stiffness 2 Fm/f2, their yields spread evenly (Iwan):
 *
 *     friction = integral of s(w) from w = 0 to 1,   |s(w)| <= 2 w Fc,   ds = (2 Fm/f2) dL where an element sticks
 *
 * Fc is half the hysteresis at the pressure of now, Fm the largest so far, f2 the length over which friction builds up. An element slips where its
 * limit is reached, by its way or because Fc falls; its stiffness does not fall. So no closed cycle of length and pressure gives work. Minor loops
 * close, at any speed.
 */
#ifndef MCKIBBEN_MEMORY_H
#define MCKIBBEN_MEMORY_H

#include "mckibben.h"
#include <math.h>

/* s(w) is a chain of straight lines, whose ends are remembered; of more ends that of the least bend is forgotten, and at once where there is none. */
#define MCKIBBEN_ENDS 32
#ifdef MCKIBBEN_FLOAT
#define MCKIBBEN_STRAIGHT MCKIBBEN_R(1e-7)
#else
#define MCKIBBEN_STRAIGHT MCKIBBEN_R(1e-12)
#endif
typedef struct {
    mckibben_real at, largest;                                /* length, m; Fm, N */
    mckibben_real w[MCKIBBEN_ENDS + 1], s[MCKIBBEN_ENDS + 1]; /* by rising w from 0 to 1; N */
    int ends;
} mckibben_memory;

/* Begins at a length, with nothing that slides. */
static inline void mckibben_rest(mckibben_memory *memory, mckibben_real length)
{
    for (int i = 0; i <= MCKIBBEN_ENDS; i++)
        memory->w[i] = memory->s[i] = MCKIBBEN_R(0);
    memory->at = length;
    memory->largest = MCKIBBEN_R(0);
    memory->w[1] = MCKIBBEN_R(1);
    memory->ends = 2;
}

/* Fc at a pressure. */
static inline mckibben_real mckibben_friction_limit(const mckibben_muscle *m, mckibben_real pressure)
{
    mckibben_real q = pressure / m->supply;
    q = q > MCKIBBEN_R(0) ? q : MCKIBBEN_R(0);
    q = q > MCKIBBEN_R(1) && !m->beyond ? MCKIBBEN_R(1) : q;
    return m->friction[0] * (mckibben_real)sqrt((double)q) + m->friction[1] * q;
}

/* Twice by how much the friction changes where an end between two lines is left out. */
static inline mckibben_real mckibben_bend(const mckibben_memory *memory, int i)
{
    const mckibben_real *w = memory->w, *s = memory->s;
    const mckibben_real bend = (w[i] - w[i - 1]) * (s[i + 1] - s[i]) - (w[i + 1] - w[i]) * (s[i] - s[i - 1]);
    return bend < MCKIBBEN_R(0) ? -bend : bend;
}

static inline void mckibben_leave_out(mckibben_memory *memory, int i)
{
    for (memory->ends--; i < memory->ends; i++) {
        memory->w[i] = memory->w[i + 1];
        memory->s[i] = memory->s[i + 1];
    }
}

/* The next end of a line, within the limits -most w and most w. */
static inline void mckibben_line_to(mckibben_memory *memory, mckibben_real w, mckibben_real s, mckibben_real most)
{
    const int before = memory->ends - 1;
    int least = 1;
    s = s > -most * w ? s : -most * w;
    memory->w[memory->ends] = w;
    memory->s[memory->ends++] = s < most * w ? s : most * w;
    if (before > 0 && mckibben_bend(memory, before) <= MCKIBBEN_STRAIGHT * memory->largest)
        mckibben_leave_out(memory, before);
    if (memory->ends <= MCKIBBEN_ENDS)
        return;
    for (int i = 2; i < MCKIBBEN_ENDS; i++)
        least = mckibben_bend(memory, i) < mckibben_bend(memory, least) ? i : least;
    mckibben_leave_out(memory, least);
}

/* After each step: the muscle went to a pressure and a length without a turn on the way, and may turn there. It stays where one is not a number. */
static inline void mckibben_moved(const mckibben_muscle *m, mckibben_memory *memory, mckibben_real pressure, mckibben_real length, unsigned *status)
{
    const mckibben_real yield = m->friction[2] > MCKIBBEN_R(0) ? m->friction[2] : MCKIBBEN_R(1e-6) * m->length;
    const mckibben_real most = MCKIBBEN_R(2) * mckibben_friction_limit(m, pressure), largest = MCKIBBEN_R(0.5) * most;
    mckibben_real stretch;
    mckibben_memory next;
    if (status)
        (void)mckibben_force(m, pressure, length, status);
    if (!(pressure - pressure == MCKIBBEN_R(0) && length - length == MCKIBBEN_R(0)))
        return;
    mckibben_rest(&next, length);
    next.ends = 1;
    next.largest = largest > memory->largest ? largest : memory->largest;
    stretch = MCKIBBEN_R(2) * next.largest / yield * (length - memory->at);
    for (int i = 1; i < memory->ends; i++) {
        const mckibben_real v = memory->w[i - 1], r = memory->s[i - 1] + stretch, w = memory->w[i], s = memory->s[i] + stretch;
        mckibben_real cut[2] = {MCKIBBEN_R(0), MCKIBBEN_R(0)}; /* shares of the line at which it crosses a limit */
        for (int k = 0; k < 2; k++) {
            const mckibben_real limit = k ? -most : most, from = r - limit * v, to = s - limit * w;
            if (from * to < MCKIBBEN_R(0))
                cut[k] = from / (from - to);
        }
        for (int k = 0; k < 2; k++) {
            const mckibben_real share = cut[cut[0] > cut[1] ? 1 - k : k];
            if (share > MCKIBBEN_R(0))
                mckibben_line_to(&next, v + share * (w - v), r + share * (s - r), most);
        }
        mckibben_line_to(&next, w, s, most);
    }
    *memory = next;
}

/* What friction adds to the pull at a pressure and a length to which the muscle goes without a turn: positive where it has become longer; with it
 * the muscle never pushes. */
static inline mckibben_real mckibben_friction_after(const mckibben_muscle *m, const mckibben_memory *memory, mckibben_real pressure, mckibben_real length,
                                                    unsigned *status)
{
    const mckibben_real limit = mckibben_friction_limit(m, pressure);
    mckibben_real friction = MCKIBBEN_R(0), share, rest;
    mckibben_memory next = *memory;
    mckibben_moved(m, &next, pressure, length, 0);
    for (int i = 1; i < next.ends; i++)
        friction += MCKIBBEN_R(0.5) * (next.w[i] - next.w[i - 1]) * (next.s[i] + next.s[i - 1]);
    share = limit > MCKIBBEN_R(0) ? friction / limit : MCKIBBEN_R(0);
    rest = MCKIBBEN_R(1) - share * share; /* a velocity and a smoothing that make this share */
    return mckibben_friction(m, pressure, length, share, rest > MCKIBBEN_R(0) ? (mckibben_real)sqrt((double)rest) : MCKIBBEN_R(0), status);
}

#endif
