// What simulated devices answer and publish, checked against the world's columns.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "playhouse/base/formats.h"
#include "playhouse/base/version.h"
#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ptz.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/generated/sonar.h"
#include "playhouse/wire/generated/wifi.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using std::numbers::pi;
using wire::MessageType;

constexpr const char* kWorld = R"(
interval_sim 100
resolution 0.02
position( name "r0" pose [1 2 0 90] size [0.44 0.38 0.22] origin [-0.04 0 0 0] fiducial_return 7
  localization "odom" update_interval 200
  ranger( name "scanner" pose [0.1 0 -0.2 0] size [0.156 0.155 0.19]
    sensor( pose [0.05 0 0.1 0] size [0.01 0.02 0.03] range [0.1 8] fov 180 samples 3 ) )
  ranger( name "sonars"
    sensor( pose [0.2 0.1 0 90] range [0 5] fov 15 samples 2 )
    sensor( pose [0.2 -0.1 0 -90] range [0 5] fov 15 ) )
  fiducial( name "finder" range_max 6 fov 90 )
  blobfinder( name "camera" colors_count 2 colors [ "blue" "red" ] image [100 40] )
  bumper( name "skirt" pose [0.1 0 -0.2 0] bcount 2 bpose[0] [0.2 0 0.05 0] bpose[1] [0 0.2 0 90] blength 0.3 blength[1] 0.1 )
  gripper( name "hand" pose [0.3 0 -0.22 0] )
  camera( name "eye" pose [0.1 0 0 0] resolution [2 1] update_interval 100 )
  camera( name "file" resolution [16 8] compression "jpeg" )
  camera( name "depth" resolution [2 1] image "depth" )
  wifi( name "radio" mac "08:00:20:ae:fd:7e" bitrate 54000000 )
)
wifi( name "post" pose [5 0 0 0] essid "lab" ip "192.168.0.9" )
)";

/// One device of kWorld, open, with a driver in front of it.
class Device : public testing::OneDevice {
 protected:
  Device() : OneDevice(kWorld) {}
};

using Position2dDevice = Device;
using RangerDevice = Device;
using LaserDevice = Device;
using SonarDevice = Device;
using FiducialDevice = Device;
using GripperDevice = Device;
using SimulationInterface = Device;

namespace p2d = wire::position2d;

TEST_F(Position2dDevice, opening_subscribes_the_model_and_closing_ends_that) {
  open(p2d::kCode, "r0");
  const world::ModelRow robot = still_.world().find("r0");
  EXPECT_EQ(still_.world().models.subscribers[robot], 1u);
  driver_.stop(kId);
  still_.run(5);
  EXPECT_EQ(still_.world().models.subscribers[robot], 0u);
  EXPECT_TRUE(still_.recorder.published.empty());
}

TEST_F(Position2dDevice, publishes_what_the_robot_believes_at_its_own_interval) {
  open(p2d::kCode, "r0");
  world::Positions& positions = still_.world().positions;
  positions.X_OM[{0}] = {0.5, -0.25, 0, 1};
  positions.velocity[{0}] = {0.3, 0, 0, 0.2};
  positions.stall[{0}] = 1;
  still_.run(5);
  ASSERT_EQ(still_.recorder.published.size(), 2u) << "every 200 ms of 100 ms ticks";
  EXPECT_DOUBLE_EQ(still_.recorder.published[0].timestamp, 0.2);
  EXPECT_EQ(last<p2d::Data>(p2d::kDataState), (p2d::Data{{0.5, -0.25, 1}, {0.3, 0, 0.2}, 1}));
}

TEST_F(Position2dDevice, velocities_goals_and_car_commands_reach_the_robot) {
  open(p2d::kCode, "r0");
  world::Positions& positions = still_.world().positions;
  command(p2d::kCmdVel, p2d::CmdVel{{0.3, 0.1, 0.2}, 1});
  EXPECT_EQ(positions.mode[{0}], world::ControlMode::kVelocity);
  EXPECT_EQ(positions.command[{0}], (geom::Twist{0.3, 0.1, 0, 0.2}));
  command(p2d::kCmdPos, p2d::CmdPos{{4, 5, 1}, {}, 1});
  EXPECT_EQ(positions.mode[{0}], world::ControlMode::kPosition);
  EXPECT_EQ(positions.goal[{0}].xy(), (geom::Vec2{4, 5}));
  command(p2d::kCmdCar, p2d::CmdCar{0.7, 0.1});
  EXPECT_EQ(positions.command[{0}], (geom::Twist{0.7, 0, 0, 0.1}));
  command(p2d::kCmdVelHead, p2d::CmdVelHead{0.4, 1.5});
  EXPECT_EQ(positions.mode[{0}], world::ControlMode::kHeading);
  EXPECT_EQ(positions.command[{0}], (geom::Twist{0.4, 0, 0, 1.5}));
}

TEST_F(Position2dDevice, refuses_commands_that_are_no_numbers) {
  open(p2d::kCode, "r0");
  command(p2d::kCmdVel, p2d::CmdVel{{0.3, 0, 0}, 1});
  for (const double nothing : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const std::vector<std::byte> body = wire::encode(p2d::CmdVel{{nothing, 0, 0}, 1});
    EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), p2d::kCmdVel, body}),
              device::Taken::kNo);
  }
  const std::vector<std::byte> nowhere = wire::encode(p2d::CmdPos{{-1e308, -1e308, 0}, {}, 1});
  EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), p2d::kCmdPos, nowhere}),
            device::Taken::kNo);
  still_.run(1);
  EXPECT_EQ(still_.world().positions.command[{0}].x, 0.3);
}

TEST_F(Position2dDevice,
       a_command_before_the_last_close_stops_with_the_robot_and_one_after_reopening_counts) {
  open(p2d::kCode, "r0");
  const std::vector<std::byte> ahead = wire::encode(p2d::CmdVel{{0.3, 0, 0}, 1});
  const auto cmd = static_cast<std::uint8_t>(MessageType::kCmd);
  driver_.command({kId, cmd, p2d::kCmdVel, ahead});
  driver_.stop(kId);
  still_.run(0);
  EXPECT_EQ(still_.world().positions.command[{0}], geom::Twist{});
  ASSERT_TRUE(driver_.start(kId));
  driver_.command({kId, cmd, p2d::kCmdVel, ahead});
  still_.run(0);
  EXPECT_EQ(still_.world().positions.command[{0}].x, 0.3);
}

TEST_F(Position2dDevice,
       cannot_start_while_the_tick_has_too_much_to_do_but_starts_in_vain_at_the_end_of_the_run) {
  open(p2d::kCode, "r0");
  driver_.stop(kId);
  while (still_.simulation.requests().post([](const world::Journal&) {})) continue;
  ASSERT_FALSE(driver_.start(kId));
  still_.simulation.discard();
  EXPECT_TRUE(driver_.start(kId));
  driver_.stop(kId);
}

TEST_F(Position2dDevice, geometry_is_the_models_origin_and_size_with_width_across) {
  open(p2d::kCode, "r0");
  const auto geom = reply<p2d::Geom>(ask(p2d::kReqGetGeom));
  EXPECT_EQ(geom.pose, (wire::Pose3d{-0.04, 0, 0, 0, 0, 0}));
  EXPECT_EQ(geom.size, (wire::Bbox3d{0.38, 0.44, 0.22}));
}

TEST_F(Position2dDevice, odometry_can_be_set_and_reset) {
  open(p2d::kCode, "r0");
  EXPECT_TRUE(ask_with(p2d::kReqSetOdom, p2d::SetOdomReq{{3, 4, 0.5}}).ack);
  EXPECT_NEAR(still_.world().positions.X_OM[{0}].x, 3, 1e-12);
  EXPECT_NEAR(still_.world().positions.X_OM[{0}].a, 0.5, 1e-12);
  EXPECT_TRUE(ask(p2d::kReqResetOdom).ack);
  EXPECT_NEAR(still_.world().positions.X_OM[{0}].x, 0, 1e-12);
  EXPECT_FALSE(ask_with(p2d::kReqSetOdom, p2d::SetOdomReq{{std::nan(""), 0, 0}}).ack);
  EXPECT_FALSE(ask_with(p2d::kReqSetOdom, p2d::SetOdomReq{{1e308, 0, 0}}).ack);
  EXPECT_FALSE(ask(p2d::kReqSetOdom).ack) << "no payload, no odometry";
}

TEST_F(Position2dDevice, motors_go_off_and_on_and_are_on_again_for_the_next_user) {
  open(p2d::kCode, "r0");
  EXPECT_TRUE(ask_with(p2d::kReqMotorPower, p2d::PowerConfig{0}).ack);
  EXPECT_EQ(still_.world().positions.motor_on[{0}], 0);
  driver_.stop(kId);
  still_.run(0);
  EXPECT_EQ(still_.world().positions.motor_on[{0}], 1);
}

TEST_F(Position2dDevice, refuses_what_it_cannot_do_and_says_what_it_can) {
  open(p2d::kCode, "r0");
  constexpr std::uint8_t kUnknown = 100;
  EXPECT_FALSE(ask_with(kUnknown, p2d::SpeedPidReq{}).ack);
  EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), p2d::kCmdVelHead, {}}),
            device::Taken::kNo);
  EXPECT_TRUE(driver_.capable(kId, static_cast<std::uint8_t>(MessageType::kReq), p2d::kReqGetGeom));
  EXPECT_FALSE(driver_.capable(kId, static_cast<std::uint8_t>(MessageType::kReq), kUnknown));
}

TEST_F(RangerDevice, a_scanner_publishes_all_its_samples) {
  open(wire::ranger::kCode, "r0.scanner");
  measure("r0.scanner", 0, {1, 2, 8}, {1, 0.5f, 0});
  still_.run(1);
  EXPECT_EQ(last<wire::ranger::DataRange>(wire::ranger::kDataRange).ranges, (std::vector<double>{1, 2, 8}));
  EXPECT_EQ(last<wire::ranger::DataIntns>(wire::ranger::kDataIntns).intensities,
            (std::vector<double>{1, 0.5, 0}));
  EXPECT_EQ(still_.recorder.batches, 1);
}

TEST_F(RangerDevice, an_array_publishes_the_nearest_echo_of_each_sensor) {
  open(wire::ranger::kCode, "r0.sonars");
  measure("r0.sonars", 0, {3, 2}, {1, 0.5f});
  measure("r0.sonars", 1, {4}, {1});
  still_.run(1);
  EXPECT_EQ(last<wire::ranger::DataRange>(wire::ranger::kDataRange).ranges, (std::vector<double>{2, 4}));
  EXPECT_EQ(last<wire::ranger::DataIntns>(wire::ranger::kDataIntns).intensities,
            (std::vector<double>{0.5, 1}));
}

TEST_F(RangerDevice, configuration_spaces_the_beams_over_the_whole_field_of_view) {
  open(wire::ranger::kCode, "r0.scanner");
  const auto config = reply<wire::ranger::Config>(ask(wire::ranger::kReqGetConfig));
  EXPECT_NEAR(config.min_angle, -pi / 2, 1e-9);
  EXPECT_NEAR(config.max_angle, pi / 2, 1e-9);
  EXPECT_NEAR(config.angular_res, pi / 2, 1e-9) << "three beams have two gaps";
  EXPECT_DOUBLE_EQ(config.min_range, 0.1);
  EXPECT_DOUBLE_EQ(config.max_range, 8);
  EXPECT_DOUBLE_EQ(config.range_res, 0.02);
  EXPECT_DOUBLE_EQ(config.frequency, 10);
}

TEST_F(RangerDevice, geometry_places_the_device_on_the_robot_and_the_sensors_on_the_device) {
  open(wire::ranger::kCode, "r0.scanner");
  const auto geom = reply<wire::ranger::Geom>(ask(wire::ranger::kReqGetGeom));
  EXPECT_NEAR(geom.pose.px, 0.1, 1e-12);
  EXPECT_NEAR(geom.pose.pz, 0.02, 1e-12) << "on top of a robot 0.22 m high, lowered by 0.2 m";
  EXPECT_EQ(geom.size, (wire::Bbox3d{0.155, 0.156, 0.19}));
  ASSERT_EQ(geom.element_poses.size(), 1u);
  EXPECT_NEAR(geom.element_poses[0].px, 0.05, 1e-12);
  ASSERT_EQ(geom.element_sizes.size(), 1u);
  EXPECT_EQ(geom.element_sizes[0], (wire::Bbox3d{0.02, 0.01, 0.03}));
}

TEST_F(LaserDevice, a_scan_has_its_angles_ranges_and_whole_intensities) {
  open(wire::laser::kCode, "r0.scanner");
  measure("r0.scanner", 0, {1, 2, 8}, {1, 0.5f, 0});
  still_.run(1);
  const auto scan = last<wire::laser::Data>(wire::laser::kDataScan);
  EXPECT_NEAR(scan.min_angle, -pi / 2, 1e-6);
  EXPECT_NEAR(scan.resolution, pi / 2, 1e-6);
  EXPECT_EQ(scan.max_range, 8.0f);
  EXPECT_EQ(scan.ranges, (std::vector<float>{1, 2, 8}));
  EXPECT_EQ(scan.intensity, (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST_F(LaserDevice, geometry_is_that_of_the_scanner_on_the_robot) {
  open(wire::laser::kCode, "r0.scanner");
  const auto geom = reply<wire::laser::Geom>(ask(wire::laser::kReqGetGeom));
  EXPECT_NEAR(geom.pose.px, 0.15, 1e-12);
  EXPECT_NEAR(geom.pose.pz, 0.12, 1e-12);
  EXPECT_NEAR(reply<wire::laser::Config>(ask(wire::laser::kReqGetConfig)).scanning_frequency, 10, 1e-6);
}

TEST(PoseOnRobot, has_the_tilts_of_the_parts_that_carry_it) {
  const scene::SceneDesc scene = run::testing::scene_of(R"(
position( name "r" tilt [0 10] size [0.4 0.4 0.2] stack_children 0
  model( name "mast" pose [0.1 0 0 90] tilt [0 30] size [0.1 0.1 0.1] stack_children 0
    ranger( name "eye" pose [0 0 1 0] origin [0 0 0 0] ) ) )
)");
  world::World world(scene, 1);
  world::tilt_as_described(world);
  const wire::Pose3d X = pose3d(pose_on_robot(world, world.find("r.mast.eye")));
  EXPECT_NEAR(X.px, 0.1, 1e-12);  // leans to the left, where the mast's front is
  EXPECT_NEAR(X.py, std::sin(pi / 6), 1e-12);
  EXPECT_NEAR(X.pz, std::cos(pi / 6), 1e-12);
  EXPECT_NEAR(X.proll, 0, 1e-12);
  EXPECT_NEAR(X.ppitch, pi / 6, 1e-12);
  EXPECT_NEAR(X.pyaw, pi / 2, 1e-12);
}

TEST_F(SonarDevice, publishes_one_range_per_transducer_and_where_they_are) {
  open(wire::sonar::kCode, "r0.sonars");
  measure("r0.sonars", 0, {3, 2}, {1, 1});
  measure("r0.sonars", 1, {4}, {1});
  still_.run(1);
  EXPECT_EQ(last<wire::sonar::Data>(wire::sonar::kDataRanges).ranges, (std::vector<float>{2, 4}));
  const auto geom = reply<wire::sonar::Geom>(ask(wire::sonar::kReqGetGeom));
  ASSERT_EQ(geom.poses.size(), 2u);
  EXPECT_NEAR(geom.poses[1].py, -0.1, 1e-12);
  EXPECT_NEAR(geom.poses[1].pyaw, -pi / 2, 1e-9);
}

TEST_F(Device, a_blob_becomes_a_box_of_pixels_in_its_color) {
  open(wire::blobfinder::kCode, "r0.camera");
  still_.world().blobfinders.blobs[{0}] = {{{1, 0, 0.5f, 0.2f}, 1, 10, 19, 15, 24, 2.5}};
  still_.run(1);
  const auto data = last<wire::blobfinder::Data>(wire::blobfinder::kDataBlobs);
  EXPECT_EQ(data.width, 100u);
  EXPECT_EQ(data.height, 40u);
  ASSERT_EQ(data.blobs.size(), 1u);
  const wire::blobfinder::Blob& blob = data.blobs[0];
  EXPECT_EQ(blob.id, 1u);
  EXPECT_EQ(blob.color, 0xFF0080u);
  EXPECT_EQ(blob.area, 100u);
  EXPECT_EQ(blob.x, 14u);
  EXPECT_EQ(blob.y, 19u);
  EXPECT_EQ(blob.left, 10u);
  EXPECT_EQ(blob.bottom, 24u);
  EXPECT_EQ(blob.range, 2.5f);
}

TEST_F(Device, a_camera_tells_its_pixels_in_rows_of_three_bytes) {
  open(wire::camera::kCode, "r0.eye");
  EXPECT_FALSE(ask(wire::camera::kReqGetImage).ack) << "no image yet";
  still_.world().cameras.pixels[{0}] = {{0x102030}, {0xfffefd}};
  still_.run(1);
  for (const auto& data : {last<wire::camera::Data>(wire::camera::kDataState),
                           reply<wire::camera::Data>(ask(wire::camera::kReqGetImage))}) {
    EXPECT_EQ(data.width, 2u);
    EXPECT_EQ(data.height, 1u);
    EXPECT_EQ(data.bpp, 24u);
    EXPECT_EQ(data.format, static_cast<std::uint32_t>(wire::camera::kFormatRgb888));
    EXPECT_EQ(data.compression, static_cast<std::uint32_t>(wire::camera::kCompressRaw));
    EXPECT_THAT(data.image, ::testing::ElementsAre(0x10, 0x20, 0x30, 0xff, 0xfe, 0xfd));
  }
}

TEST_F(Device, a_camera_of_distances_tells_millimetres_with_the_low_byte_first) {
  open(wire::camera::kCode, "r0.depth");
  still_.world().cameras.pixels[{2}] = {{0x1234}, {0}};
  still_.run(1);
  const auto data = last<wire::camera::Data>(wire::camera::kDataState);
  EXPECT_EQ(data.format, static_cast<std::uint32_t>(wire::camera::kFormatMono16));
  EXPECT_EQ(data.bpp, 16u);
  EXPECT_THAT(data.image, ::testing::ElementsAre(0x34, 0x12, 0, 0));
}

TEST_F(Device, a_camera_sends_jpeg_files_if_its_file_says_so) {
  open(wire::camera::kCode, "r0.file");
  still_.world().cameras.pixels[{1}].assign(16 * 8, {0x2040c0});
  still_.run(1);
  const auto data = last<wire::camera::Data>(wire::camera::kDataState);
  EXPECT_EQ(data.compression, static_cast<std::uint32_t>(wire::camera::kCompressJpeg));
  EXPECT_EQ(data.width, 16u);
  ASSERT_GT(data.image.size(), 100u);
  EXPECT_EQ(data.image[0], 0xff);
  EXPECT_EQ(data.image[1], 0xd8);
  EXPECT_EQ(data.image.back(), 0xd9);
}

TEST_F(Device, a_camera_turns_to_a_place_or_at_a_velocity) {
  open(wire::ptz::kCode, "r0.eye");
  world::Cameras& cameras = still_.world().cameras;
  command(wire::ptz::kCmdState, wire::ptz::Cmd{0.5f, -0.2f, 0, 9, 9});
  EXPECT_FLOAT_EQ(static_cast<float>(cameras.goal_pan[{0}]), 0.5f);
  EXPECT_FLOAT_EQ(static_cast<float>(cameras.goal_tilt[{0}]), -0.2f);
  EXPECT_DOUBLE_EQ(cameras.goal_zoom[{0}], geom::radians(70));
  EXPECT_TRUE(ask(wire::ptz::kReqControlMode, wire::encode(wire::ptz::ReqControlMode{
                                                  static_cast<std::uint32_t>(wire::ptz::kVelocityControl)}))
                  .ack);
  command(wire::ptz::kCmdState, wire::ptz::Cmd{1, 1, 1, -0.25f, 0.125f});
  EXPECT_EQ(cameras.command_pan[{0}], -0.25);
  EXPECT_EQ(cameras.command_tilt[{0}], 0.125);
  EXPECT_FALSE(ask(wire::ptz::kReqControlMode, wire::encode(wire::ptz::ReqControlMode{7})).ack);
  cameras.pan[{0}] = 0.75;
  cameras.pan_speed[{0}] = -0.25;
  still_.run(1);
  const auto data = last<wire::ptz::Data>(wire::ptz::kDataState);
  EXPECT_EQ(data.pan, 0.75f);
  EXPECT_EQ(data.panspeed, -0.25f);
  EXPECT_FLOAT_EQ(data.zoom, static_cast<float>(geom::radians(70)));
  const auto geom = reply<wire::ptz::Geom>(ask(wire::ptz::kReqGeom));
  EXPECT_NEAR(geom.pos.px, 0.1, 1e-9);
}

TEST_F(Device, a_radio_tells_whom_it_hears_by_address) {
  open(wire::wifi::kCode, "r0.radio");
  world::World& world = still_.world();
  world.wifis.links[{0}] = {{world.id(world.find("post")), -61.6, 28}};
  still_.run(1);
  const auto data = last<wire::wifi::Data>(wire::wifi::kDataState);
  EXPECT_EQ(data.qual_type, static_cast<std::uint32_t>(wire::wifi::kQualDbm));
  EXPECT_EQ(data.bitrate, 54000000u);
  ASSERT_EQ(data.links.size(), 1u);
  const wire::wifi::Link& link = data.links[0];
  const auto text = [](const std::vector<std::uint8_t>& bytes) {
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_EQ(text(link.ip), "192.168.0.9");
  EXPECT_EQ(text(link.essid), "lab");
  EXPECT_EQ(text(link.mac).substr(0, 9), "02:00:00:");
  EXPECT_EQ(link.level, -62);
  EXPECT_EQ(link.qual, 28u);
  const auto own = reply<wire::wifi::MacReq>(ask(wire::wifi::kReqMac));
  EXPECT_EQ(text(own.mac), "08:00:20:ae:fd:7e");
}

TEST_F(Device, a_switch_becomes_a_byte_and_its_face_a_place_on_the_robot) {
  open(wire::bumper::kCode, "r0.skirt");
  world::World& world = still_.world();
  world.bumpers.hits[{0}] = {{}, world.id(world.find("r0"))};
  still_.run(1);
  EXPECT_EQ(last<wire::bumper::Data>(wire::bumper::kDataState).bumpers, (std::vector<std::uint8_t>{0, 1}));
  const auto geom = reply<wire::bumper::Geom>(ask(wire::bumper::kReqGetGeom));
  ASSERT_EQ(geom.bumper_def.size(), 2u);
  EXPECT_NEAR(geom.bumper_def[0].pose.px, 0.3, 1e-12);
  EXPECT_NEAR(geom.bumper_def[0].pose.pz, 0.07, 1e-12);
  EXPECT_EQ(geom.bumper_def[0].length, 0.3f);
  EXPECT_EQ(geom.bumper_def[0].radius, 0.0f);
  EXPECT_NEAR(geom.bumper_def[1].pose.py, 0.2, 1e-12);
  EXPECT_NEAR(geom.bumper_def[1].pose.pyaw, pi / 2, 1e-9);
  EXPECT_EQ(geom.bumper_def[1].length, 0.1f);
}

TEST_F(FiducialDevice, a_hit_becomes_a_pose_in_the_finders_frame) {
  open(wire::fiducial::kCode, "r0.finder");
  world::FiducialHit hit;
  hit.id = 5;
  hit.range = 2;
  hit.bearing = pi / 2;
  hit.heading = 0.25;
  still_.world().fiducials.hits[{0}] = {hit};
  still_.run(1);
  const auto data = last<wire::fiducial::Data>(wire::fiducial::kDataScan);
  ASSERT_EQ(data.fiducials.size(), 1u);
  EXPECT_EQ(data.fiducials[0].id, 5);
  EXPECT_NEAR(data.fiducials[0].pose.px, 0, 1e-9);
  EXPECT_NEAR(data.fiducials[0].pose.py, 2, 1e-9);
  EXPECT_NEAR(data.fiducials[0].pose.pyaw, 0.25, 1e-12);
}

TEST_F(FiducialDevice, reads_and_sets_the_id_its_robot_shows_and_tells_its_field_of_view) {
  open(wire::fiducial::kCode, "r0.finder");
  EXPECT_EQ(reply<wire::fiducial::Id>(ask(wire::fiducial::kReqGetId)).id, 7u);
  EXPECT_EQ(reply<wire::fiducial::Id>(ask_with(wire::fiducial::kReqSetId, wire::fiducial::Id{9})).id, 9u);
  EXPECT_EQ(still_.world().models.fiducial_return[still_.world().find("r0")], 9);
  const auto fov = reply<wire::fiducial::Fov>(ask(wire::fiducial::kReqGetFov));
  EXPECT_EQ(fov.max_range, 6.0f);
  EXPECT_NEAR(fov.view_angle, pi / 2, 1e-6);
}

namespace grip = wire::gripper;

TEST_F(GripperDevice, commands_reach_the_paddles_and_the_newest_counts) {
  open(grip::kCode, "r0.hand");
  const std::int32_t& closing = still_.world().grippers.closing[{0}];
  const auto send = [&](std::uint8_t subtype) {
    EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), subtype, {}}),
              device::Taken::kLatest);
  };
  send(grip::kCmdClose);
  EXPECT_EQ(closing, 0) << "not yet";
  still_.run(0);
  EXPECT_EQ(closing, 1);
  send(grip::kCmdClose);
  send(grip::kCmdOpen);
  still_.run(0);
  EXPECT_EQ(closing, -1);
  send(grip::kCmdStop);
  still_.run(0);
  EXPECT_EQ(closing, 0);
}

TEST_F(GripperDevice, publishes_state_and_beams) {
  open(grip::kCode, "r0.hand");
  world::Grippers& grippers = still_.world().grippers;
  const auto data = [&] {
    still_.run(1);
    return last<grip::Data>(grip::kDataState);
  };
  EXPECT_EQ(data(), (grip::Data{grip::kStateOpen, 0, 0}));
  grippers.paddles[{0}] = 0.5;
  EXPECT_EQ(data().state, grip::kStateError) << "it stands between open and closed";
  grippers.closing[{0}] = 1;
  grippers.beams[{0}] = 1;
  EXPECT_EQ(data(), (grip::Data{grip::kStateMoving, 0x04, 0}));
  grippers.close_limit[{0}] = 0.5;
  grippers.beams[{0}] = 2;
  EXPECT_EQ(data(), (grip::Data{grip::kStateClosed, 0x08, 0}));
  grippers.closing[{0}] = -1;
  grippers.beams[{0}] = 3;
  EXPECT_EQ(data(), (grip::Data{grip::kStateMoving, 0x0c, 0}));
}

TEST_F(GripperDevice, geometry_is_its_place_on_the_robot_its_size_and_the_gap) {
  open(grip::kCode, "r0.hand");
  const auto geom = reply<grip::Geom>(ask(grip::kReqGetGeom));
  EXPECT_NEAR(geom.pose.px, 0.3, 1e-9);
  EXPECT_NEAR(geom.pose.pz, 0, 1e-9);
  EXPECT_EQ(geom.outer_size, (wire::Bbox3d{0.3, 0.2, 0.2}));
  EXPECT_NEAR(geom.inner_size.sw, 0.24, 1e-9);
  EXPECT_NEAR(geom.inner_size.sl, 0.132, 1e-9);
  EXPECT_NEAR(geom.inner_size.sh, 0.08, 1e-9);
  EXPECT_EQ(geom.num_beams, 2);
  EXPECT_EQ(geom.capacity, 0);
}

TEST_F(GripperDevice, has_no_store) {
  open(grip::kCode, "r0.hand");
  for (const std::uint8_t subtype : {grip::kCmdStore, grip::kCmdRetrieve})
    EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), subtype, {}}),
              device::Taken::kNo);
}

namespace sim = wire::simulation;

TEST_F(SimulationInterface, tells_and_sets_poses_by_name_in_the_parents_frame) {
  open(sim::kCode, "");
  const std::string name = wire::c_string("r0");
  const auto pose = reply<sim::Pose2dReq>(ask_with(sim::kReqGetPose2d, sim::Pose2dReq{name, {}}));
  EXPECT_EQ(pose.name, name);
  EXPECT_NEAR(pose.pose.px, 1, 1e-12);
  EXPECT_NEAR(pose.pose.pa, pi / 2, 1e-9);
  EXPECT_TRUE(ask_with(sim::kReqSetPose2d, sim::Pose2dReq{name, {-6, -5, 0.5}}).ack);
  EXPECT_EQ(still_.world().models.X_PM[still_.world().find("r0")].xy(), (geom::Vec2{-6, -5}));
  still_.run(3);
  const auto pose3 = reply<sim::Pose3dReq>(ask_with(sim::kReqGetPose3d, sim::Pose3dReq{name, {}, 0}));
  EXPECT_NEAR(pose3.pose.pyaw, 0.5, 1e-12);
  EXPECT_NEAR(pose3.simtime, 300000, 1e-3) << "microseconds";
}

TEST_F(SimulationInterface, tells_and_sets_the_height_of_what_stands_on_its_parent_from_its_top) {
  open(sim::kCode, "");
  const std::string name = wire::c_string("r0.scanner");  // pose [0.1 0 -0.2 0], on a body 0.22 m high
  const auto height = [&] {
    return reply<sim::Pose3dReq>(ask_with(sim::kReqGetPose3d, sim::Pose3dReq{name, {}, 0})).pose.pz;
  };
  EXPECT_NEAR(height(), -0.2, 1e-12);
  EXPECT_TRUE(ask_with(sim::kReqSetPose2d, sim::Pose2dReq{name, {0, 0, 0}}).ack);
  EXPECT_NEAR(height(), -0.2, 1e-12) << "a pose without z keeps the height";
  EXPECT_TRUE(ask_with(sim::kReqSetPose3d, sim::Pose3dReq{name, {0, 0, -0.1, 0, 0, 0}, 0}).ack);
  EXPECT_NEAR(height(), -0.1, 1e-12);
  EXPECT_NEAR(still_.world().models.X_WM[still_.world().find("r0.scanner")].z, 0.12, 1e-12);
}

TEST_F(SimulationInterface, refuses_unknown_models_and_poses_that_are_no_numbers) {
  open(sim::kCode, "");
  EXPECT_FALSE(ask_with(sim::kReqGetPose2d, sim::Pose2dReq{wire::c_string("nosuch"), {}}).ack);
  EXPECT_FALSE(ask_with(sim::kReqSetPose2d, sim::Pose2dReq{wire::c_string("r0"), {std::nan(""), 0, 0}}).ack);
  EXPECT_FALSE(ask_with(sim::kReqSetPose2d, sim::Pose2dReq{wire::c_string("r0"), {1e308, 0, 0}}).ack);
  EXPECT_FALSE(ask(sim::kReqGetPose2d).ack);
}

TEST_F(SimulationInterface, takes_names_as_clients_send_them_and_refuses_monsters) {
  open(sim::kCode, "");
  const auto knows = [&](std::string name) {
    return ask_with(sim::kReqGetPose2d, sim::Pose2dReq{std::move(name), {}}).ack;
  };
  EXPECT_TRUE(knows("r0")) << "without its final NUL";
  EXPECT_TRUE(knows(std::string("r0\0\0junk", 8)));
  EXPECT_FALSE(knows(""));
  EXPECT_FALSE(knows(std::string("\0r0", 3)));
  EXPECT_FALSE(knows(std::string(65536, 'r')));
  EXPECT_FALSE(knows(std::string(65536, '\n')));
}

TEST_F(SimulationInterface, properties_are_colour_time_name_and_model) {
  open(sim::kCode, "");
  const auto get = [&](const char* property) {
    return reply<sim::PropertyReq>(
               ask_with(sim::kReqGetProperty,
                        sim::PropertyReq{wire::c_string("r0"), wire::c_string(property), 0, ""}))
        .value;
  };
  std::string green(16, '\0');
  const float rgba[] = {0, 1, 0, 1};
  std::memcpy(green.data(), rgba, sizeof(rgba));
  EXPECT_TRUE(ask_with(sim::kReqSetProperty,
                       sim::PropertyReq{wire::c_string("r0"), wire::c_string("color"), 0, green})
                  .ack);
  EXPECT_EQ(get("color"), green);
  const std::string black(16, '\0');
  EXPECT_TRUE(ask_with(sim::kReqSetProperty,
                       sim::PropertyReq{wire::c_string("r0"), wire::c_string("_mp_color"), 0, black})
                  .ack)
      << "its name in Stage 3 and in manuals";
  EXPECT_EQ(get("_mp_color"), black);
  still_.run(2);
  std::uint64_t microseconds = 0;
  const std::string time = get("time");
  ASSERT_EQ(time.size(), sizeof(microseconds));
  std::memcpy(&microseconds, time.data(), sizeof(microseconds));
  EXPECT_EQ(microseconds, 200000u);
  EXPECT_EQ(get("name"), wire::c_string("r0"));
  EXPECT_EQ(get("model"), wire::c_string("position"));
  EXPECT_FALSE(ask_with(sim::kReqSetProperty,
                        sim::PropertyReq{wire::c_string("r0"), wire::c_string("color"), 0, "short"})
                   .ack);
  EXPECT_FALSE(
      ask_with(sim::kReqGetProperty, sim::PropertyReq{wire::c_string("r0"), wire::c_string("weight"), 0, ""})
          .ack);
}

TEST_F(SimulationInterface, says_what_it_adds_to_the_protocol_and_which_build_it_is) {
  open(sim::kCode, "");
  const auto get = [&](const char* property) {
    return reply<sim::PropertyReq>(
               ask_with(sim::kReqGetProperty,
                        sim::PropertyReq{wire::c_string(""), wire::c_string(property), 0, ""}))
        .value;
  };
  const auto bytes_of = [](std::uint32_t number) {
    return std::string(reinterpret_cast<const char*>(&number), sizeof number);
  };
  EXPECT_EQ(get("build"), wire::c_string(build()));
  EXPECT_EQ(get("wire_format"), bytes_of(formats::kWireExtensions));
  EXPECT_EQ(get("robot_format"), bytes_of(formats::kRobots));
}

TEST_F(SimulationInterface, lists_models_with_the_devices_that_show_them) {
  open(sim::kCode, "");
  world::World& world = still_.world();
  still_.devices.directory().add(world.id(world.find("r0")), {6665, p2d::kCode, 12});
  still_.devices.directory().add(world.id(world.find("r0.scanner")), {6666, wire::ranger::kCode, 0});
  still_.devices.directory().add(world.id(world.find("r0.scanner")), {6666, wire::laser::kCode, 0});
  const auto list = [&](std::uint32_t first) {
    return reply<sim::PropertyReq>(ask_with(
        sim::kReqGetProperty, sim::PropertyReq{wire::c_string(""), wire::c_string("models"), first, ""}));
  };
  const std::string robot = std::to_string(world.find("r0").index);
  EXPECT_THAT(list(0).value, ::testing::HasSubstr(robot + "\tr0\tposition\t\t6665:position2d:12\n"));
  EXPECT_THAT(list(0).value, ::testing::HasSubstr("\tr0.scanner\tranger\tr0\t6666:ranger:0 6666:laser:0\n"));
  EXPECT_THAT(list(0).value, ::testing::HasSubstr("\tr0.sonars\tranger\tr0\t\n")) << "without a device";
  EXPECT_EQ(list(0).index, 0u) << "complete";
  EXPECT_EQ(wire::text(list(0).prop), "models");
  const std::string all = list(0).value;
  EXPECT_EQ(list(1).value, all.substr(all.find('\n') + 1));
  EXPECT_EQ(list(1000000).value, "");
  EXPECT_FALSE(
      ask_with(sim::kReqGetProperty, sim::PropertyReq{wire::c_string("r0"), wire::c_string("models"), 0, ""})
          .ack);
}

TEST_F(SimulationInterface, reset_puts_everything_back_to_the_start) {
  open(sim::kCode, "");
  const world::ModelRow robot = still_.world().find("r0");
  const geom::Pose start = still_.world().models.X_WM[robot];
  EXPECT_TRUE(
      ask_with(sim::kReqSetPose2d, sim::Pose2dReq{wire::c_string("r0"), wire::Pose2d{-6, -5, 0.5}}).ack);
  still_.run(3);
  EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), sim::kCmdReset, {}}),
            device::Taken::kQueued);
  still_.run(1);
  EXPECT_EQ(still_.world().models.X_WM[robot], start);
  EXPECT_EQ(still_.world().tick(), 4u) << "clients want times that grow";
}

TEST_F(SimulationInterface, save_hands_the_world_to_whoever_saves_it) {
  std::vector<std::uint64_t> saved;
  still_.devices.save_by([&](const world::World& world) { saved.push_back(world.tick()); });
  open(sim::kCode, "");
  still_.run(3);
  const auto save = [this] {
    return driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), sim::kCmdSave, {}});
  };
  EXPECT_EQ(save(), device::Taken::kQueued);
  still_.run(2);
  EXPECT_EQ(saved, std::vector<std::uint64_t>{3});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(save(), device::Taken::kQueued);
  still_.run(2);
  EXPECT_EQ(saved, (std::vector<std::uint64_t>{3, 5})) << "of many before one tick the last";
}

TEST_F(SimulationInterface, save_is_refused_where_nobody_says_into_which_file) {
  open(sim::kCode, "");
  EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), sim::kCmdSave, {}}),
            device::Taken::kNo);
}

TEST_F(SimulationInterface, of_many_resets_before_one_tick_only_the_last_is_carried_out) {
  open(sim::kCode, "");
  const world::ModelRow robot = still_.world().find("r0");
  const geom::Pose start = still_.world().models.X_WM[robot];
  const auto away = wire::encode(sim::Pose2dReq{wire::c_string("r0"), wire::Pose2d{-6, -5, 0.5}});
  for (int i = 0; i < 3; ++i) {
    driver_.request({kId, static_cast<std::uint8_t>(MessageType::kReq), sim::kReqSetPose2d, away},
                    device::Replier(still_.recorder, ++ticket_));
    EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), sim::kCmdReset, {}}),
              device::Taken::kQueued);
  }
  const std::uint64_t before = still_.world().events.end();
  still_.run(0);
  EXPECT_EQ(still_.world().models.X_WM[robot], start);
  EXPECT_EQ(still_.world().events.since(before).size(), 4u) << "three times away, once back";
}

TEST_F(SimulationInterface, pause_pauses_and_resumes) {
  open(sim::kCode, "");
  driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), sim::kCmdPause, {}});
  EXPECT_TRUE(still_.simulation.requests().pace().paused);
  driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), sim::kCmdPause, {}});
  EXPECT_FALSE(still_.simulation.requests().pace().paused);
}

}  // namespace
}  // namespace playhouse::drivers
