/* The joint @{name}.
 * @{facts}
 */
#ifndef MCKIBBEN_NUMBERS_@{ID}_H
#define MCKIBBEN_NUMBERS_@{ID}_H

#include "mckibben.h"
@{includes}

static const mckibben_joint @{id} = {
    @{count}, {@{addresses}},
    @{paths},
    @{rope}, @{torsion}, @{weight}, @{range}
};

#endif
