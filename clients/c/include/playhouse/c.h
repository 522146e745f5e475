/** A C client of Playhouse and of any Player 3 server: everything. README.md shows a robot in ten lines. */
#ifndef PLAYHOUSE_C_H
#define PLAYHOUSE_C_H

#include "playhouse/c/client.h"
#include "playhouse/c/device.h"
#include "playhouse/c/error.h"
#include "playhouse/c/generated/all.h"
#include "playhouse/c/map.h"
#include "playhouse/c/planner.h"
#include "playhouse/c/proxies.h"
#include "playhouse/c/robot.h"
#include "playhouse/c/simulation.h"
#include "playhouse/c/value.h"
#include "playhouse/c/values.h"
#include "playhouse/c/wire.h"

#endif /* PLAYHOUSE_C_H */
