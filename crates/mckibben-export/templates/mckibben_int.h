/* Pull of a McKibben muscle in whole numbers of 32 bits, for small microcontrollers: the form of mckibben.h, rounded. C99; no library.
 * @{facts}
 *
 * Units: Pa (gauge), micrometre, millinewton. On AVR the numbers of the muscle stay in flash.
 * Outside of the box the pull is that at its edge. A muscle that would have to push is slack: its pull is 0.
 * Licence: MIT OR Apache-2.0.
 */
#ifndef MCKIBBEN_INT_H
#define MCKIBBEN_INT_H

#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
#define MCKIBBEN_FLASH PROGMEM
#else
#define MCKIBBEN_FLASH
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    int32_t length;          /* at rest, micrometre */
    int32_t knot[4];         /* ends of the parts in the pressure, Pa */
    int32_t edge[10];        /* ends of the parts in the shortening, micrometre */
    int16_t point[7][28];    /* control points: parabolas in the pressure, cubics in the shortening */
    uint16_t factor;         /* of a control point: factor/2^(shift + 2) millinewton */
    uint8_t shift, edges;
} mckibben_int_muscle;

/* Pull, millinewton. */
int32_t mckibben_int_force(const mckibben_int_muscle *m, int32_t pressure, int32_t length);
/* The highest pressure of the box, Pa, at which the muscle pulls with `force` or less; by bisection. */
int32_t mckibben_int_pressure(const mckibben_int_muscle *m, int32_t force, int32_t length);

#ifdef __cplusplus
}
#endif
#endif
