/* Pull of a McKibben muscle in whole numbers; see mckibben_int.h.
 * @{facts}
 *
 * Parts between two edges, each a parabola in the pressure and a cubic in the shortening, by control points (de Casteljau): every step lies
 * between two numbers, so that nothing overflows and errors do not grow.
 */
#include "mckibben_int.h"

#ifdef __AVR__
#define WORD(x) ((int16_t)pgm_read_word(&(x)))
#define LONG(x) ((int32_t)pgm_read_dword(&(x)))
#define BYTE(x) pgm_read_byte(&(x))
#else
#define WORD(x) (x)
#define LONG(x) (x)
#define BYTE(x) (x)
#endif
/* One copy of a function is smaller than many. */
#ifdef __GNUC__
#define ONCE static __attribute__((noinline))
#else
#define ONCE static
#endif

/* x t/65536. */
ONCE int32_t part(int32_t x, uint16_t t)
{
    return (int32_t)(int16_t)(x >> 16) * t + (int32_t)((uint32_t)(uint16_t)x * t >> 16);
}

/* The part that x lies in, and where in it, in 65536th; the ends outside. */
ONCE uint8_t locate(int32_t x, const int32_t *edge, uint8_t edges, uint16_t *t)
{
    uint8_t n = 0;
    int32_t width;
    uint16_t at = 0;
    while (n < edges - 2 && x >= LONG(edge[n + 1]))
        n++;
    width = LONG(edge[n + 1]) - LONG(edge[n]);
    x -= LONG(edge[n]);
    if (x < 0)
        x = 0;
    if (x > width)
        x = width;
    for (uint8_t i = 0; i < 16; i++) {
        x += x;
        at = (uint16_t)(at + at);
        if (x >= width) {
            x -= width;
            at++;
        }
    }
    *t = at;
    return n;
}

/* A curve by its control points, which are lost. */
ONCE int32_t curve(int32_t *c, uint8_t degree, uint16_t t)
{
    for (; degree > 0; degree--)
        for (uint8_t j = 0; j < degree; j++)
            c[j] += part(c[j + 1] - c[j], t);
    return c[0];
}

/* Control points of the parabolas in the pressure, at a shortening. */
ONCE void parabolas(const mckibben_int_muscle *m, int32_t shortening, int32_t d[7])
{
    uint16_t t;
    const uint8_t n = locate(shortening, m->edge, BYTE(m->edges), &t);
    const int16_t *p = &m->point[0][3 * n];
    for (uint8_t i = 0; i < 7; i++, p += 28) {
        int32_t c[4];
        for (uint8_t k = 0; k < 4; k++)
            c[k] = (int32_t)WORD(p[k]) * 16384;
        d[i] = curve(c, 3, t);
    }
}

/* Pull, negative where the muscle would have to push. */
ONCE int32_t pull(const mckibben_int_muscle *m, const int32_t d[7], int32_t pressure)
{
    uint16_t t;
    int32_t c[3];
    d += 2 * locate(pressure, m->knot, 4, &t);
    for (uint8_t k = 0; k < 3; k++)
        c[k] = d[k];
    return part(curve(c, 2, t), (uint16_t)WORD(m->factor)) >> BYTE(m->shift);
}

int32_t mckibben_int_force(const mckibben_int_muscle *m, int32_t pressure, int32_t length)
{
    int32_t d[7], force;
    parabolas(m, LONG(m->length) - length, d);
    force = pull(m, d, pressure);
    return force <= 0 ? 0 : force;
}

int32_t mckibben_int_pressure(const mckibben_int_muscle *m, int32_t force, int32_t length)
{
    int32_t d[7], pressure = 0;
    parabolas(m, LONG(m->length) - length, d);
    for (int32_t bit = (int32_t)1 << 22; bit > 0; bit >>= 1)
        if (pressure + bit <= LONG(m->knot[3]) && pull(m, d, pressure + bit) <= force)
            pressure += bit;
    return pressure;
}
