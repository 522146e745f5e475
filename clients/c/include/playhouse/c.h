/** A C client of Playhouse and of any Player 3 server: everything. README.md shows a robot in ten lines. */
#ifndef PLAYHOUSE_C_H
#define PLAYHOUSE_C_H

#include "playhouse/c/aio.h"
#include "playhouse/c/bumper.h"
#include "playhouse/c/camera.h"
#include "playhouse/c/client.h"
#include "playhouse/c/device.h"
#include "playhouse/c/error.h"
#include "playhouse/c/fiducial.h"
#include "playhouse/c/generated/all.h"
#include "playhouse/c/gps.h"
#include "playhouse/c/imu.h"
#include "playhouse/c/laser.h"
#include "playhouse/c/localize.h"
#include "playhouse/c/map.h"
#include "playhouse/c/opaque.h"
#include "playhouse/c/planner.h"
#include "playhouse/c/pointcloud3d.h"
#include "playhouse/c/position2d.h"
#include "playhouse/c/position3d.h"
#include "playhouse/c/ptz.h"
#include "playhouse/c/ranger.h"
#include "playhouse/c/robot.h"
#include "playhouse/c/simulation.h"
#include "playhouse/c/sonar.h"
#include "playhouse/c/speech.h"
#include "playhouse/c/speech_recognition.h"
#include "playhouse/c/value.h"
#include "playhouse/c/values.h"
#include "playhouse/c/wire.h"

#endif /* PLAYHOUSE_C_H */
