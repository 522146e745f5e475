#pragma once

/// Rows of the tables of bodies (bodies.h). Values.

#include "playhouse/base/row.h"

namespace playhouse::bodies {

using TreeRow = Row<struct Trees>;
using SolidRow = Row<struct Solids>;
using SolidRows = RowsOf<struct Solids>;

}  // namespace playhouse::bodies
