/* The joint @{name}.
 * @{facts}
 */
#ifndef MCKIBBEN_@{ID}_H
#define MCKIBBEN_@{ID}_H

#include "mckibben_joint.h"
@{includes}

static const mckibben_joint @{id} = {
    @{count}, {@{addresses}},
    @{paths},
    @{rope}, @{torsion}, @{weight}, @{range}
};

#endif
