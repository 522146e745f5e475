// Generated from interfaces/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The rows of the catalogue, one table per interface, by (type, subtype). For generated/*.cc only.

#include "playhouse/wire/messages.h"

namespace playhouse::wire {

extern const MessageDef kRows[9];
namespace player {
extern const MessageDef kRows[10];
}
namespace power {
extern const MessageDef kRows[2];
}
namespace gripper {
extern const MessageDef kRows[7];
}
namespace position2d {
extern const MessageDef kRows[15];
}
namespace sonar {
extern const MessageDef kRows[4];
}
namespace laser {
extern const MessageDef kRows[9];
}
namespace blobfinder {
extern const MessageDef kRows[4];
}
namespace ptz {
extern const MessageDef kRows[7];
}
namespace audio {
extern const MessageDef kRows[15];
}
namespace fiducial {
extern const MessageDef kRows[6];
}
namespace speech {
extern const MessageDef kRows[1];
}
namespace gps {
extern const MessageDef kRows[1];
}
namespace bumper {
extern const MessageDef kRows[3];
}
namespace dio {
extern const MessageDef kRows[2];
}
namespace aio {
extern const MessageDef kRows[2];
}
namespace ir {
extern const MessageDef kRows[3];
}
namespace wifi {
extern const MessageDef kRows[5];
}
namespace localize {
extern const MessageDef kRows[3];
}
namespace position3d {
extern const MessageDef kRows[13];
}
namespace simulation {
extern const MessageDef kRows[9];
}
namespace blinkenlight {
extern const MessageDef kRows[5];
}
namespace camera {
extern const MessageDef kRows[4];
}
namespace map {
extern const MessageDef kRows[4];
}
namespace planner {
extern const MessageDef kRows[5];
}
namespace log {
extern const MessageDef kRows[5];
}
namespace joystick {
extern const MessageDef kRows[1];
}
namespace speech_recognition {
extern const MessageDef kRows[1];
}
namespace opaque {
extern const MessageDef kRows[3];
}
namespace position1d {
extern const MessageDef kRows[13];
}
namespace actarray {
extern const MessageDef kRows[13];
}
namespace limb {
extern const MessageDef kRows[10];
}
namespace graphics2d {
extern const MessageDef kRows[5];
}
namespace rfid {
extern const MessageDef kRows[5];
}
namespace wsn {
extern const MessageDef kRows[5];
}
namespace graphics3d {
extern const MessageDef kRows[6];
}
namespace health {
extern const MessageDef kRows[1];
}
namespace imu {
extern const MessageDef kRows[8];
}
namespace pointcloud3d {
extern const MessageDef kRows[1];
}
namespace ranger {
extern const MessageDef kRows[10];
}
namespace vectormap {
extern const MessageDef kRows[3];
}
namespace blackboard {
extern const MessageDef kRows[7];
}
namespace stereo {
extern const MessageDef kRows[1];
}
namespace coopobject {
extern const MessageDef kRows[12];
}

}  // namespace playhouse::wire
