// What moves and lies in space as Player devices: imu, gps, position3d and pointcloud3d, against the world's
// columns.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/gps.h"
#include "playhouse/wire/generated/imu.h"
#include "playhouse/wire/generated/pointcloud3d.h"
#include "playhouse/wire/generated/position3d.h"

namespace playhouse::drivers {
namespace {

namespace imu = wire::imu;
namespace gps = wire::gps;
namespace p3d = wire::position3d;
namespace cloud = wire::pointcloud3d;
using wire::MessageType;

constexpr const char* kWorld = R"(
interval_sim 100
latitude 50
longitude 6
altitude 200
position( name "r" size [0.4 0.5 0.3] update_interval 100
  imu( name "imu" )
  gps( name "gps" noise [3 1] drift [4 0] dop [1.2 2] )
  gps( name "deaf" satellites 3 )
  ranger( name "lidar" sensor( pose [0.1 0 0 90] size [0 0 0.2] samples 3 fov 90 range [0 10] rings 2 ring_fov [0 30] ) )
  ranger( name "flat" sensor( samples 3 ) ) )
)";

class SpatialDevice : public ::testing::Test {
 protected:
  SpatialDevice() : still_(kWorld), driver_(still_.devices, "stage") {}
  world::World& world() { return still_.world(); }
  void open(std::uint16_t interf, const char* model) {
    driver_.add(kId, make_device(still_.devices, interf, world().find(model)));
    ASSERT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  device::Taken command(std::uint8_t subtype, const std::vector<std::byte>& body) {
    const device::Taken taken =
        driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), subtype, body});
    still_.run(0);
    return taken;
  }
  template <typename Payload>
  bool is_granted(std::uint8_t subtype, const Payload& payload) {
    const std::vector<std::byte> body = wire::encode(payload);
    driver_.request({kId, static_cast<std::uint8_t>(MessageType::kReq), subtype, body},
                    device::Replier(still_.recorder, ++ticket_));
    still_.run(0);
    return still_.recorder.answers.at(ticket_).ack;
  }
  /// The one message of the next tick.
  template <typename T>
  T next(std::uint8_t subtype) {
    still_.recorder.published.clear();
    still_.run(1);
    EXPECT_EQ(still_.recorder.published.size(), 1u);
    if (still_.recorder.published.empty()) return {};
    EXPECT_EQ(still_.recorder.published[0].subtype, subtype);
    const Result<T> value = wire::decode<T>(still_.recorder.published[0].body);
    EXPECT_TRUE(value);
    return value ? *value : T{};
  }

  static constexpr device::DeviceId kId{3};
  testing::StillDevices still_;
  SimulatedDriver driver_;
  std::uint64_t ticket_ = 0;
};

TEST_F(SpatialDevice, an_imu_sends_the_data_that_were_asked_for) {
  open(imu::kCode, "r.imu");
  world::Imus& imus = world().imus;
  imus.noted_tick[{0}] = 1;
  imus.reading[{0}] = {{0.1, -0.2, 9.8}, {0.01, 0.02, -0.5}};
  const geom::SpatialPose stands = geom::spatial_pose({1, 2, 0.5}, geom::RollPitchYaw{0.1, -0.2, 1.5});
  imus.X_WE[{0}] = imus.X_WB[{0}] = stands.X;
  imus.tilt_WE[{0}] = imus.tilt_WB[{0}] = stands.tilt;
  imus.v_WE[{0}] = {0, 0.3, 0};
  const auto state = next<imu::DataState>(imu::kDataState);
  EXPECT_EQ(state.pose.py, 2);
  EXPECT_NEAR(state.pose.proll, 0.1, 1e-12);
  EXPECT_NEAR(state.pose.ppitch, -0.2, 1e-12);
  EXPECT_NEAR(state.pose.pyaw, 1.5, 1e-12);

  ASSERT_TRUE(is_granted(imu::kReqSetDatatype, imu::DatatypeConfig{imu::kDataCalib}));
  const auto calib = next<imu::DataCalib>(imu::kDataCalib);
  EXPECT_FLOAT_EQ(calib.accel_y, -0.2f);
  EXPECT_FLOAT_EQ(calib.gyro_z, -0.5f);
  EXPECT_NEAR(std::hypot(calib.magn_x, calib.magn_y, calib.magn_z), 1, 1e-6);

  ASSERT_TRUE(is_granted(imu::kReqSetDatatype, imu::DatatypeConfig{imu::kDataEuler}));
  const auto euler = next<imu::DataEuler>(imu::kDataEuler);
  EXPECT_NEAR(euler.orientation.ppitch, -0.2, 1e-12);
  EXPECT_FLOAT_EQ(euler.calib_data.accel_x, 0.1f);

  ASSERT_TRUE(is_granted(imu::kReqSetDatatype, imu::DatatypeConfig{imu::kDataQuat}));
  const auto quat = next<imu::DataQuat>(imu::kDataQuat);
  const geom::RollPitchYaw turns = [&] {
    const geom::SpatialPose X = geom::spatial_pose({}, geom::Quaternion{quat.q0, quat.q1, quat.q2, quat.q3});
    return geom::roll_pitch_yaw(X.X.a, X.tilt);
  }();
  EXPECT_NEAR(turns.yaw, 1.5, 1e-6);
  EXPECT_NEAR(turns.roll, 0.1, 1e-6);

  ASSERT_TRUE(is_granted(imu::kReqSetDatatype, imu::DatatypeConfig{imu::kDataFullstate}));
  const auto full = next<imu::DataFullstate>(imu::kDataFullstate);
  EXPECT_NEAR(std::hypot(full.vel.px, full.vel.py, full.vel.pz), 0.3, 1e-12);
  EXPECT_EQ(full.acc.pz, 9.8);
  EXPECT_EQ(full.vel.pyaw, -0.5);
  EXPECT_FALSE(is_granted(imu::kReqSetDatatype, imu::DatatypeConfig{0}));
  EXPECT_FALSE(is_granted(imu::kReqSetDatatype, imu::DatatypeConfig{6}));
}

TEST_F(SpatialDevice, the_attitude_of_an_imu_can_be_reset) {
  open(imu::kCode, "r.imu");
  world::Imus& imus = world().imus;
  EXPECT_FALSE(is_granted(imu::kReqResetOrientation, imu::ResetOrientationConfig{0})) << "not measured yet";
  imus.noted_tick[{0}] = 1;
  const geom::SpatialPose stands = geom::spatial_pose({}, geom::RollPitchYaw{0.1, -0.2, 1.5});
  imus.X_WE[{0}] = stands.X;
  imus.tilt_WE[{0}] = stands.tilt;
  const auto expect = [&](double roll, double pitch, double yaw) {
    const auto pose = next<imu::DataState>(imu::kDataState).pose;
    EXPECT_NEAR(pose.proll, roll, 1e-9);
    EXPECT_NEAR(pose.ppitch, pitch, 1e-9);
    EXPECT_NEAR(geom::normalize(pose.pyaw - yaw), 0, 1e-9);
  };
  ASSERT_TRUE(is_granted(imu::kReqResetOrientation, imu::ResetOrientationConfig{1}));
  expect(0, 0, 0);
  ASSERT_TRUE(is_granted(imu::kReqResetEuler, imu::ResetEulerConfig{{0, 0, 0, 0.3, 0.2, -2}}));
  expect(0.3, 0.2, -2);
  ASSERT_TRUE(is_granted(imu::kReqResetOrientation, imu::ResetOrientationConfig{0}));
  const auto pose = next<imu::DataState>(imu::kDataState).pose;
  EXPECT_NEAR(std::fabs(pose.proll) + std::fabs(pose.ppitch), 0.3, 0.1) << "it stands as it does";
  EXPECT_FALSE(is_granted(imu::kReqResetOrientation, imu::ResetOrientationConfig{3}));
  EXPECT_FALSE(is_granted(imu::kReqResetEuler, imu::ResetEulerConfig{{0, 0, 0, std::nan(""), 0, 0}}));
}

TEST_F(SpatialDevice, a_gps_tells_latitude_longitude_and_the_grid_of_utm) {
  open(gps::kCode, "r.gps");
  world().receivers.position[{0}] = {1000, -2000, 30};
  world().receivers.velocity[{0}] = {0.6, -0.8, 5};
  const auto fix = next<gps::Data>(gps::kDataState);
  EXPECT_EQ(fix.quality, 1u);
  EXPECT_EQ(fix.time_usec, 100000u);
  EXPECT_NEAR(fix.latitude, (50 - 2000 / 111229.0) * 1e7, 30);  // 1e-7 deg, 111229 m for a degree at 50 N
  EXPECT_NEAR(fix.longitude, (6 + 1000 / 71696.0) * 1e7, 300);  // 71696 m
  EXPECT_NEAR(fix.altitude, 230 * 1000 + 392, 5) << "the plane leaves the ellipsoid";
  EXPECT_NEAR(fix.speed, 1, 1e-12) << "over ground";
  EXPECT_NEAR(fix.course, geom::kPi - std::atan(0.75), 1e-12) << "south-east";
  EXPECT_EQ(fix.hdop, 12u);
  EXPECT_EQ(fix.vdop, 20u);
  EXPECT_NEAR(fix.err_horz, 5 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(fix.err_vert, 1, 1e-12);
  EXPECT_NEAR(fix.utm_e, 285000, 1000);
  EXPECT_NEAR(fix.utm_n, 5540000, 5000);
}

TEST_F(SpatialDevice, a_gps_that_hears_too_few_satellites_has_no_fix) {
  open(gps::kCode, "r.deaf");
  world().receivers.position[{1}] = {1000, -2000, 30};
  const auto fix = next<gps::Data>(gps::kDataState);
  EXPECT_EQ(fix.quality, 0u);
  EXPECT_EQ(fix.num_sats, 3u);
  EXPECT_EQ(fix.latitude, 0);
}

TEST_F(SpatialDevice, position3d_tells_heights_and_tilts_and_drives) {
  open(p3d::kCode, "r");
  const world::ModelRow robot = world().find("r");
  world().positions.X_OM[{0}] = {0.5, -0.25, 0, 1};
  world().positions.velocity[{0}] = {0.3, 0, 0, 0.2};
  const auto level = next<p3d::Data>(p3d::kDataState);
  EXPECT_EQ(level.pos.px, 0.5);
  EXPECT_EQ(level.pos.pyaw, 1);
  EXPECT_EQ(level.vel.px, 0.3);
  EXPECT_EQ(level.vel.pyaw, 0.2);
  world().upright = false;  // as in an engine whose bodies have mass
  world().models.X_WM[robot].z = 0.7;
  world().models.tilt_WM.set(robot, {0.2, 0});
  world().models.V_WM.set(robot, {{0, 0, -1}, {0, 0, 0}});
  const auto tilted = next<p3d::Data>(p3d::kDataState);
  EXPECT_EQ(tilted.pos.pz, 0.7);
  EXPECT_GT(std::fabs(tilted.pos.proll) + std::fabs(tilted.pos.ppitch), 0.19);
  EXPECT_NEAR(tilted.vel.pz, -std::cos(0.2), 1e-12);

  EXPECT_EQ(command(p3d::kCmdSetVel, wire::encode(p3d::CmdVel{{0.4, 0.1, 0, 0, 0, -0.3}, 1})),
            device::Taken::kLatest);
  EXPECT_EQ(world().positions.command[{0}], (geom::Twist{0.4, 0.1, 0, -0.3}));
  EXPECT_EQ(command(p3d::kCmdSetPos, wire::encode(p3d::CmdPos{{4, 5, 0, 0, 0, 1}, {}, 1})),
            device::Taken::kLatest);
  EXPECT_EQ(world().positions.goal[{0}].xy(), (geom::Vec2{4, 5}));
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  EXPECT_EQ(command(p3d::kCmdSetVel, wire::encode(p3d::CmdVel{{kNothing, 0, 0, 0, 0, 0}, 1})),
            device::Taken::kNo);
  EXPECT_EQ(command(p3d::kCmdSetPos, wire::encode(p3d::CmdPos{{kNothing, 0, 0, 0, 0, 0}, {}, 1})),
            device::Taken::kNo);
  EXPECT_TRUE(is_granted(p3d::kReqMotorPower, p3d::PowerConfig{0}));
  EXPECT_EQ(world().positions.motor_on[{0}], 0);
  EXPECT_TRUE(is_granted(p3d::kReqSetOdom, p3d::SetOdomReq{{7, 8, 0, 0, 0, 0.5}}));
  EXPECT_EQ(world().positions.X_OM[{0}].x, 7);
  EXPECT_FALSE(is_granted(p3d::kReqSetOdom, p3d::SetOdomReq{{kNothing, 8, 0, 0, 0, 0.5}}));
}

TEST_F(SpatialDevice, a_cloud_has_the_points_of_all_rings_that_met_something) {
  open(cloud::kCode, "r.lidar");
  world::Rangers& rangers = world().rangers;
  // The sensor looks along y of the ranger; its beams begin 0.1 m above its foot.
  rangers.ring_ranges[{0}] = {1, 2, 10, 10, 4, 10};
  rangers.ring_intensities[{0}] = {10, 20, 0, 0, 300, 0};
  const auto all = next<cloud::Data>(cloud::kDataState);
  ASSERT_EQ(all.points.size(), 3u);
  EXPECT_NEAR(all.points[0].point.px, 0.1 + std::sqrt(0.5), 1e-9) << "45 degrees to the right of y";
  EXPECT_NEAR(all.points[0].point.py, std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(all.points[0].point.pz, 0.1, 1e-9);
  EXPECT_NEAR(all.points[2].point.px, 0.1, 1e-9);
  EXPECT_NEAR(all.points[2].point.py, 4 * std::cos(geom::radians(30)), 1e-9);
  EXPECT_NEAR(all.points[2].point.pz, 0.1 + 4 * std::sin(geom::radians(30)), 1e-9);
  EXPECT_EQ(all.points[1].color.red, 20);
  EXPECT_EQ(all.points[2].color.red, 255);
  EXPECT_EQ(all.points[2].color.alpha, 255);
}

TEST_F(SpatialDevice, where_no_rings_are_measured_a_cloud_has_the_level_beams) {
  open(cloud::kCode, "r.lidar");
  world::Sensors& sensors = world().sensors;
  sensors.ranges[sensors.first_beam[{0}] + 1] = 3;
  const auto all = next<cloud::Data>(cloud::kDataState);
  ASSERT_EQ(all.points.size(), 1u);
  EXPECT_NEAR(all.points[0].point.py, 3, 1e-9);
  EXPECT_NEAR(all.points[0].point.pz, 0.1, 1e-9);
}

TEST_F(SpatialDevice, only_rangers_with_rings_have_a_cloud) {
  EXPECT_TRUE(fits(world(), world().find("r.lidar"), cloud::kCode));
  EXPECT_FALSE(fits(world(), world().find("r.flat"), cloud::kCode));
}

}  // namespace
}  // namespace playhouse::drivers
