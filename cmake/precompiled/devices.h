/// What sources of modules with simulated devices include as well, for PLAYHOUSE_PRECOMPILE.
#pragma once

#include "playhouse/device/client.h"
#include "playhouse/net/network.h"
#include "playhouse/run/simulation.h"
#include "playhouse/config/text/expand.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "world.h"
