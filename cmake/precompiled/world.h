/// What sources of modules above `world` include as well, for PLAYHOUSE_PRECOMPILE.
#pragma once

#include "library.h"
#include "playhouse/world/world.h"
