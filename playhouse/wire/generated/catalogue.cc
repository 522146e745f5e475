// Generated from interfaces/ by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/rows.h"

namespace playhouse::wire {

namespace {

constexpr InterfaceDef kInterfaces[43] = {
    {1, "player", player::kRows},
    {2, "power", power::kRows},
    {3, "gripper", gripper::kRows},
    {4, "position2d", position2d::kRows},
    {5, "sonar", sonar::kRows},
    {6, "laser", laser::kRows},
    {7, "blobfinder", blobfinder::kRows},
    {8, "ptz", ptz::kRows},
    {9, "audio", audio::kRows},
    {10, "fiducial", fiducial::kRows},
    {12, "speech", speech::kRows},
    {13, "gps", gps::kRows},
    {14, "bumper", bumper::kRows},
    {20, "dio", dio::kRows},
    {21, "aio", aio::kRows},
    {22, "ir", ir::kRows},
    {23, "wifi", wifi::kRows},
    {25, "localize", localize::kRows},
    {30, "position3d", position3d::kRows},
    {31, "simulation", simulation::kRows},
    {33, "blinkenlight", blinkenlight::kRows},
    {40, "camera", camera::kRows},
    {42, "map", map::kRows},
    {44, "planner", planner::kRows},
    {45, "log", log::kRows},
    {49, "joystick", joystick::kRows},
    {50, "speech_recognition", speech_recognition::kRows},
    {51, "opaque", opaque::kRows},
    {52, "position1d", position1d::kRows},
    {53, "actarray", actarray::kRows},
    {54, "limb", limb::kRows},
    {55, "graphics2d", graphics2d::kRows},
    {56, "rfid", rfid::kRows},
    {57, "wsn", wsn::kRows},
    {58, "graphics3d", graphics3d::kRows},
    {59, "health", health::kRows},
    {60, "imu", imu::kRows},
    {61, "pointcloud3d", pointcloud3d::kRows},
    {62, "ranger", ranger::kRows},
    {63, "vectormap", vectormap::kRows},
    {64, "blackboard", blackboard::kRows},
    {65, "stereo", stereo::kRows},
    {66, "coopobject", coopobject::kRows},
};

}  // namespace

std::span<const InterfaceDef> interfaces() { return kInterfaces; }

std::span<const MessageDef> universal_messages() { return kRows; }

}  // namespace playhouse::wire
