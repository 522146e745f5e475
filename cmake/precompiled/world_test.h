/// What tests of modules above `world` include as well, for PLAYHOUSE_PRECOMPILE.
#pragma once

#include "library_test.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"
#include "world.h"
