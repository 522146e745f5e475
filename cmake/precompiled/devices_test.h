/// What tests of modules with simulated devices include as well, for PLAYHOUSE_PRECOMPILE.
#pragma once

#include "devices.h"
#include "library_test.h"
#include "playhouse/run/testing/still_engine.h"
