/* The muscle @{name} in whole numbers.
 * @{facts}
 */
#ifndef MCKIBBEN_INT_MUSCLE_@{ID}_H
#define MCKIBBEN_INT_MUSCLE_@{ID}_H

#include "mckibben_int.h"

static const mckibben_int_muscle @{id}_int MCKIBBEN_FLASH = {
    @{length_um},
    @{knots},
    @{edges},
    @{points},
    @{factor}, @{shift}, @{count}
};

#endif
