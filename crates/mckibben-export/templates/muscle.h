/* The muscle @{name}.
 * @{facts}
 */
#ifndef MCKIBBEN_NUMBERS_@{ID}_H
#define MCKIBBEN_NUMBERS_@{ID}_H

#include "mckibben.h"

static const mckibben_muscle @{id} = {
    MCKIBBEN_R(@{length}), MCKIBBEN_R(@{cord}), MCKIBBEN_R(@{supply}), MCKIBBEN_R(@{allowed}), MCKIBBEN_R(@{burst}), @{count},
    @{nodes},
    @{a},
    @{b},
    @{v},
    @{friction}, 0
};

#endif
