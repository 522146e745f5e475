// What the proxies make of data and answers, and what they send.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <limits>

#include "fake_server.h"

namespace playhouse_c {
namespace {

using ::testing::ElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

/// Opens a proxy of device 0; a failure of the test if that fails.
#define OPEN(NAME, CLIENT) opened(ph_##NAME##_open((CLIENT).get(), 0, PH_ACCESS_ALL, nullptr))
template <typename Proxy>
Proxy *opened(Proxy *proxy) {
  EXPECT_NE(proxy, nullptr);
  return proxy;
}

void read_one(const Client &client) {
  EXPECT_WORKS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error));
}

bool asks_data(const Received &message) {
  return message.header.interface_code == PH_PLAYER_CODE &&
         message.header.subtype == PH_PLAYER_REQ_DATA->subtype;
}

/// Answers each round with `data` and acknowledges everything else, requests with `answer`.
FakeServer::Script rounds(std::function<void(Peer &)> data, Bytes answer = {}) {
  return script([=](Peer &peer, const Received &message) {
    if (message.header.kind == PH_KIND_CMD) return true;
    peer.answer(message, asks_data(message) ? Bytes() : answer);
    if (!asks_data(message)) return true;
    data(peer);
    peer.synch();
    return true;
  });
}

/// The bodies of what was sent to an interface as one kind of message.
std::vector<Bytes> sent(const std::vector<Received> &received, const ph_message_type *message) {
  std::vector<Bytes> bodies;
  for (const Received &each : received) {
    if (each.header.interface_code == message->interface_code && each.header.kind == message->kind &&
        each.header.subtype == message->subtype) {
      bodies.push_back(each.body);
    }
  }
  return bodies;
}

TEST(Proxies, BeforeTheFirstDataThereIsNoValue) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.answer(message, {}, PH_KIND_NACK);
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_state state;
  ph_scan scan;
  ph_image image;
  ph_view view;
  ph_pose pose;
  ph_planning planning;
  const double *numbers = nullptr;
  const float *floats = nullptr;
  const std::uint8_t *bytes = nullptr;
  const ph_marker *markers = nullptr;
  std::size_t count = 0;
  ph_ranger *ranger = OPEN(ranger, client);
  const char *told = ":0 has sent no data yet; next_data() waits for them";
  EXPECT_FAILS(ph_position2d_state(OPEN(position2d, client), &state, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_laser_scan(OPEN(laser, client), &scan, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_laser_intensities(OPEN(laser, client), &bytes, &count, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_sonar_ranges(OPEN(sonar, client), &floats, &count, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_fiducial_markers(OPEN(fiducial, client), &markers, &count, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_ranger_scan(ranger, &scan, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_ranger_ranges(ranger, &numbers, &count, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_ranger_intensities(ranger, &numbers, &count, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_bumper_pressed(OPEN(bumper, client), &bytes, &count, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_camera_image(OPEN(camera, client), &image, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_ptz_view(OPEN(ptz, client), &view, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_localize_pose(OPEN(localize, client), &pose, &error), PH_NO_DATA, told);
  EXPECT_FAILS(ph_planner_state(OPEN(planner, client), &planning, &error), PH_NO_DATA, told);
  EXPECT_EQ(ph_ranger_get_config(ranger)->max_range, 0.0) << "refused";
}

TEST(Proxies, ALaserSpreadsItsBeams) {
  const float ranges[] = {1.0F, 2.0F, 4.0F};
  FakeServer server(rounds([&](Peer &peer) {
    ph_laser_data data{};
    data.min_angle = -0.5F;
    data.max_angle = 0.5F;
    data.max_range = 8.0F;
    data.ranges = ranges;
    data.ranges_count = 3;
    peer.data(PH_LASER_DATA_SCAN, body(ph_laser_data_type, data), 0, 8.5);
  }));
  const Client client = connected(server.address());
  ph_laser *laser = OPEN(laser, client);
  EXPECT_WORKS(ph_laser_next_data(laser, PH_OWN_TIMEOUT, &error));
  ph_scan scan{};
  EXPECT_WORKS(ph_laser_scan(laser, &scan, &error));
  EXPECT_THAT(std::vector<double>(scan.ranges, scan.ranges + scan.count), ElementsAre(1.0, 2.0, 4.0));
  EXPECT_THAT(std::vector<double>(scan.angles, scan.angles + scan.count), ElementsAre(-0.5, 0.0, 0.5));
  EXPECT_EQ(scan.time, 8.5);
  EXPECT_EQ(ph_scan_nearest(&scan, -0.1, 1.0), 2.0);
  EXPECT_EQ(ph_scan_nearest(&scan, 1.0, 2.0), 8.0) << "no beam is there";
  EXPECT_NEAR(ph_scan_point(&scan, 2).y, 4.0 * std::sin(0.5), 1e-12);
}

TEST(Proxies, ARangersElementsPointWhereTheySay) {
  const ph_common_pose3d poses[] = {{0, 0, 0, 0, 0, 1.0}, {0, 0, 0, 0, 0, -1.0}};
  const double ranges[] = {3.0, 5.0};
  int answered = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    ph_ranger_config config{};
    config.max_range = 9.0;
    ph_ranger_geom geom{};
    geom.element_poses = poses;
    geom.element_poses_count = 2;
    const bool of_ranger = message.header.interface_code == PH_RANGER_CODE;
    if (of_ranger && message.header.subtype == PH_RANGER_REQ_GET_CONFIG->subtype) {
      config.max_range += answered++;
      peer.answer(message, body(ph_ranger_config_type, config));
    } else {
      peer.answer(message, of_ranger ? body(ph_ranger_geom_type, geom) : Bytes());
    }
    if (of_ranger) return true;
    peer.data(PH_RANGER_DATA_RANGE, body(ph_ranger_data_range_type, ph_ranger_data_range{ranges, 2}));
    peer.synch();
    return true;
  }));
  const Client client = connected(server.address());
  ph_ranger *ranger = OPEN(ranger, client);
  read_one(client);
  ph_scan scan{};
  EXPECT_WORKS(ph_ranger_scan(ranger, &scan, &error));
  EXPECT_THAT(std::vector<double>(scan.angles, scan.angles + scan.count), ElementsAre(1.0, -1.0));
  EXPECT_EQ(scan.max_range, 9.0);
  const ph_ranger_config wanted = *ph_ranger_get_config(ranger);
  EXPECT_WORKS(ph_ranger_set_config(ranger, &wanted, &error));
  EXPECT_EQ(ph_ranger_get_config(ranger)->max_range, 10.0) << "as the server then says";
}

TEST(Proxies, ACameraTellsItsPixels) {
  std::uint32_t at = 0;
  const std::uint8_t pixels[][6] = {
      {1, 2, 3, 4, 5, 6}, {0x34, 0x12, 0, 0}, {0xFF, 0xD8}, {1, 2, 3, 4, 5}, {0, 0, 0, 0, 0, 1}};
  const std::uint32_t sizes[] = {6, 4, 2, 5, 6};
  FakeServer server(rounds([&](Peer &peer) {
    const bool depth = at == 1;
    const ph_camera_data data = {
        depth ? 1U : 2U,
        depth ? 2U : 1U,
        24,
        static_cast<std::uint32_t>(depth ? PH_CAMERA_FORMAT_MONO16 : PH_CAMERA_FORMAT_RGB888),
        1,
        static_cast<std::uint32_t>(at == 2 ? PH_CAMERA_COMPRESS_JPEG : PH_CAMERA_COMPRESS_RAW),
        pixels[at],
        sizes[at]};
    ++at;
    peer.data(PH_CAMERA_DATA_STATE, body(ph_camera_data_type, data), 0, 2.5);
  }));
  const Client client = connected(server.address());
  ph_camera *eye = OPEN(camera, client);
  const auto next = [&] {
    ph_image image{};
    read_one(client);
    EXPECT_WORKS(ph_camera_image(eye, &image, &error));
    return image;
  };
  std::uint16_t channels[3] = {};
  std::size_t count = 0;
  std::int32_t id = 0;
  ph_image image = next();
  EXPECT_WORKS(ph_image_pixel(&image, 1, 0, channels, &count, &error));
  EXPECT_THAT(channels, ElementsAre(4, 5, 6));
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(image.time, 2.5);
  EXPECT_WORKS(ph_image_model_id(&image, 1, 0, &id, &error));
  EXPECT_EQ(id, 0x040505);
  EXPECT_FAILS(ph_image_pixel(&image, 2, 0, channels, &count, &error), PH_INVALID_VALUE,
               "pixel 2, 0 is outside the 2 x 1 picture");
  image = next();
  EXPECT_WORKS(ph_image_pixel(&image, 0, 0, channels, &count, &error));
  EXPECT_EQ(channels[0], 0x1234);
  EXPECT_EQ(count, 1U);
  EXPECT_FAILS(ph_image_model_id(&image, 0, 0, &id, &error), PH_INVALID_VALUE, "RGB888 alone");
  image = next();
  EXPECT_TRUE(image.is_jpeg);
  EXPECT_FAILS(ph_image_pixel(&image, 0, 0, channels, &count, &error), PH_INVALID_VALUE,
               "raw MONO8, MONO16 and RGB888 alone");
  image = next();
  EXPECT_WORKS(ph_image_pixel(&image, 0, 0, channels, &count, &error));
  EXPECT_FAILS(ph_image_pixel(&image, 1, 0, channels, &count, &error), PH_INVALID_VALUE,
               "fewer bytes than pixels: 5");
  image = next();
  EXPECT_WORKS(ph_image_model_id(&image, 0, 0, &id, &error));
  EXPECT_EQ(id, -1) << "none";
  EXPECT_WORKS(ph_image_model_id(&image, 1, 0, &id, &error));
  EXPECT_EQ(id, 0) << "the first model";
}

TEST(Proxies, ABumperTellsWhichSwitchesArePressedAndWhereTheyAre) {
  const ph_bumper_define front = {{0.25, 0, 0.1, 0, 0, 0.5}, 0.5F, 0.0F};
  FakeServer server(rounds(
      [](Peer &peer) {
        const std::uint8_t states[] = {0, 1, 255};
        peer.data(PH_BUMPER_DATA_STATE, body(ph_bumper_data_type, ph_bumper_data{states, 3}));
      },
      body(ph_bumper_geom_type, ph_bumper_geom{&front, 1})));
  const Client client = connected(server.address());
  ph_bumper *skirt = OPEN(bumper, client);
  read_one(client);
  const std::uint8_t *pressed = nullptr;
  const ph_face *faces = nullptr;
  std::size_t count = 0;
  EXPECT_WORKS(ph_bumper_pressed(skirt, &pressed, &count, &error));
  EXPECT_THAT(std::vector<int>(pressed, pressed + count), ElementsAre(0, 1, 255));
  EXPECT_WORKS(ph_bumper_faces(skirt, &faces, &count, &error));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(faces[0].pose.yaw, 0.5);
  EXPECT_EQ(faces[0].length, 0.5);
}

TEST(Proxies, AnInertialUnitTellsTheNewerOfTwoKindsOfData) {
  const ph_imu_data_calib felt = {0.5F, 0.25F, 9.75F, 0, 0, 1.5F, 0, 0.5F, -0.5F};
  FakeServer server(rounds([&](Peer &peer) {
    peer.data(PH_IMU_DATA_STATE, body(ph_imu_data_state_type, ph_imu_data_state{}), 0, 1.0);
    peer.data(PH_IMU_DATA_EULER, body(ph_imu_data_euler_type, ph_imu_data_euler{felt, {0.1, 0.2, 0.3}}), 0,
              2.0);
    peer.data(PH_IMU_DATA_QUAT, body(ph_imu_data_quat_type, ph_imu_data_quat{felt, 1, 0, 0, 0}), 0, 3.0);
    peer.data(PH_IMU_DATA_FULLSTATE,
              body(ph_imu_data_fullstate_type,
                   ph_imu_data_fullstate{{1, 2, 3, 0, 0, 0.5}, {0.25, 0, 0, 0, 0, 0}, {}}),
              0, 4.0);
  }));
  {
    const Client client = connected(server.address());
    ph_imu *unit = OPEN(imu, client);
    ph_inertia inertia{};
    double attitude[3], quaternion[4];
    ph_pose3d pose{}, velocity{};
    EXPECT_FAILS(ph_imu_inertia(unit, &inertia, &error), PH_NO_DATA, "imu:0 has sent no data yet");
    EXPECT_WORKS(ph_imu_send(unit, PH_IMU_DATA_EULER, &error));
    read_one(client);
    EXPECT_WORKS(ph_imu_inertia(unit, &inertia, &error));
    EXPECT_EQ(inertia.acceleration[2], 9.75);
    EXPECT_EQ(inertia.turn_rate[2], 1.5);
    EXPECT_EQ(inertia.field[2], -0.5);
    EXPECT_WORKS(ph_imu_attitude(unit, attitude, &error));
    EXPECT_THAT(attitude, ElementsAre(0.1, 0.2, 0.3));
    EXPECT_WORKS(ph_imu_quaternion(unit, quaternion, &error));
    EXPECT_EQ(quaternion[0], 1.0);
    EXPECT_WORKS(ph_imu_pose(unit, &pose, &error));
    EXPECT_EQ(pose.x, 1.0);
    EXPECT_WORKS(ph_imu_velocity(unit, &velocity, &error));
    EXPECT_EQ(velocity.x, 0.25);
    EXPECT_WORKS(ph_imu_reset_orientation(unit, false, &error));
    EXPECT_FAILS(ph_imu_reset_attitude(unit, 0, 0, kNan, &error), PH_INVALID_VALUE, "yaw is nan");
  }
  EXPECT_THAT(sent(server.finish(), PH_IMU_REQ_SET_DATATYPE), ElementsAre(Bytes{0, 0, 0, 4}));
  EXPECT_THAT(sent(server.finish(), PH_IMU_REQ_RESET_ORIENTATION), ElementsAre(Bytes{0, 0, 0, 0}));
  EXPECT_THAT(sent(server.finish(), PH_IMU_REQ_RESET_EULER), ElementsAre());
}

TEST(Proxies, DataOfAnotherKindAreNamed) {
  FakeServer server(rounds([](Peer &peer) {
    peer.data(PH_IMU_DATA_STATE, body(ph_imu_data_state_type, ph_imu_data_state{}));
  }));
  const Client client = connected(server.address());
  ph_imu *unit = OPEN(imu, client);
  ph_inertia inertia{};
  read_one(client);
  EXPECT_FAILS(ph_imu_inertia(unit, &inertia, &error), PH_NO_DATA,
               "imu:0 sends imu.data.state, not imu.data.calib; ph_imu_send(unit, PH_IMU_DATA_CALIB) selects it");
  EXPECT_EQ(ph_imu_inertia(unit, &inertia, nullptr), PH_NO_DATA);
}

TEST(Proxies, AReceiverTellsDegreesAndMetresAndACloudPoints) {
  FakeServer server(rounds([](Peer &peer) {
    const ph_gps_data fix = {1,         0, 507747000, -60839000, 220500, 0.5, 1.5, 294000.0,
                             5628000.0, 1, 8,         10,        15,     2.0, 3.0};
    const ph_pointcloud3d_element red = {{1, 2, 3}, {255, 200, 0, 0}};
    peer.data(PH_GPS_DATA_STATE, body(ph_gps_data_type, fix));
    peer.data(PH_POINTCLOUD3D_DATA_STATE, body(ph_pointcloud3d_data_type, ph_pointcloud3d_data{&red, 1}));
  }));
  const Client client = connected(server.address());
  ph_gps *receiver = OPEN(gps, client);
  ph_pointcloud3d *cloud = OPEN(pointcloud3d, client);
  read_one(client);
  ph_fix fix{};
  const ph_cloud_point *points = nullptr;
  std::size_t count = 0;
  EXPECT_WORKS(ph_gps_fix(receiver, &fix, &error));
  EXPECT_NEAR(fix.latitude, 50.7747, 1e-9);
  EXPECT_NEAR(fix.longitude, -6.0839, 1e-9);
  EXPECT_EQ(fix.altitude, 220.5);
  EXPECT_EQ(fix.satellites, 8U);
  EXPECT_EQ(fix.horizontal_error, 2.0);
  EXPECT_WORKS(ph_pointcloud3d_points(cloud, &points, &count, &error));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(points[0].z, 3.0);
  EXPECT_THAT(points[0].color, ElementsAre(200, 0, 0, 255));
}

TEST(Proxies, WhatABaseInSpaceIsTold) {
  FakeServer server(script([](Peer &, const Received &) { return true; }));
  {
    const Client client = connected(server.address());
    ph_position3d *base = OPEN(position3d, client);
    EXPECT_WORKS(ph_position3d_drive(base, 1, 2, 3, 4, &error));
    EXPECT_FAILS(ph_position3d_drive(base, 0, 0, 0, kNan, &error), PH_INVALID_VALUE, "vz is nan");
  }
  EXPECT_THAT(sent(server.finish(), PH_POSITION3D_CMD_SET_VEL),
              ElementsAre(body(ph_position3d_cmd_vel_type, ph_position3d_cmd_vel{{1, 3, 4, 0, 0, 2}, 1}),
                          body(ph_position3d_cmd_vel_type, ph_position3d_cmd_vel{{0, 0, 0, 0, 0, 0}, 1})))
      << "stopped at the end";
}

TEST(Proxies, MessagesAreKeptInOrderAndTheOldestOfTooManyDropped) {
  FakeServer server(rounds([](Peer &peer) {
    for (std::uint32_t i = 0; i < 1030; ++i) {
      const std::uint8_t bytes[] = {static_cast<std::uint8_t>(i >> 8), static_cast<std::uint8_t>(i)};
      peer.data(PH_OPAQUE_DATA_STATE, body(ph_opaque_data_type, ph_opaque_data{bytes, 2}));
    }
    peer.data(PH_SPEECH_RECOGNITION_DATA_STRING,
              body(ph_speech_recognition_data_type, ph_speech_recognition_data{"hello", 5}));
  }));
  {
    const Client client = connected(server.address());
    ph_opaque *radio = OPEN(opaque, client);
    ph_speech_recognition *ears = OPEN(speech_recognition, client);
    const std::uint8_t *bytes = nullptr;
    std::size_t size = 0;
    EXPECT_FALSE(ph_opaque_take_message(radio, &bytes, &size));
    read_one(client);
    int count = 0;
    for (; ph_opaque_take_message(radio, &bytes, &size); ++count) {
      ASSERT_EQ(size, 2U);
      ASSERT_EQ(bytes[0] << 8 | bytes[1], count + 6);
    }
    EXPECT_EQ(count, 1024);
    EXPECT_STREQ(ph_speech_recognition_take_text(ears), "hello");
    EXPECT_EQ(ph_speech_recognition_take_text(ears), nullptr);
    EXPECT_WORKS(ph_opaque_send(radio, "a\0b", 3, &error));
    EXPECT_WORKS(ph_opaque_send_to(radio, "x", "y", 1, &error));
    read_one(client);  // kept messages are released with the device
  }
  EXPECT_THAT(sent(server.finish(), PH_OPAQUE_CMD_DATA),
              ElementsAre(Bytes{0, 0, 0, 3, 0, 0, 0, 3, 'a', 0, 'b', 0}));
  EXPECT_THAT(sent(server.finish(), PH_OPAQUE_REQ_DATA),
              ElementsAre(Bytes{0, 0, 0, 3, 0, 0, 0, 3, 'x', 0, 'y', 0}));
}

TEST(Proxies, LocalizationTellsHypothesesAndTakesAnEstimate) {
  int round = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    const ph_localize_particle one = {{3, 4, 1}, 0.5};
    const bool asks = message.header.interface_code == PH_LOCALIZE_CODE;
    const bool particles = asks && message.header.subtype == PH_LOCALIZE_REQ_GET_PARTICLES->subtype;
    ph_localize_get_particles few{};
    few.particles = &one;
    few.particles_count = 1;
    peer.answer(message, particles ? body(ph_localize_get_particles_type, few) : Bytes());
    if (asks) return true;
    const ph_localize_hypoth hypoths[] = {{{1, 2, 0.5}, {0.25, 0.5, 0.125, 0.1, 0.2, 0.3}, 0.75},
                                          {{}, {}, 0.25}};
    peer.data(PH_LOCALIZE_DATA_HYPOTHS,
              body(ph_localize_data_type, ph_localize_data{0, 1.0, hypoths, round++ == 0 ? 2U : 0U}));
    peer.synch();
    return true;
  }));
  {
    const Client client = connected(server.address());
    ph_localize *place = OPEN(localize, client);
    const ph_hypothesis *hypotheses = nullptr;
    const ph_particle *particles = nullptr;
    std::size_t count = 0;
    ph_pose pose{};
    read_one(client);
    EXPECT_WORKS(ph_localize_hypotheses(place, &hypotheses, &count, &error));
    ASSERT_EQ(count, 2U);
    EXPECT_EQ(hypotheses[0].covariance.xa, 0.3);
    EXPECT_EQ(hypotheses[0].weight, 0.75);
    EXPECT_WORKS(ph_localize_pose(place, &pose, &error));
    EXPECT_EQ(pose.a, 0.5);
    read_one(client);
    EXPECT_FAILS(ph_localize_pose(place, &pose, &error), PH_NO_DATA, "localize:0 has no hypothesis");
    EXPECT_WORKS(
        ph_localize_set_estimate(place, {1, 2, 0.5}, ph_covariance_of_deviations(0.5, 2, 3), &error));
    EXPECT_FAILS(ph_localize_set_estimate(place, {1, kNan, 0.5}, {}, &error), PH_INVALID_VALUE,
                 "localize:0: y is nan");
    EXPECT_FAILS(ph_localize_set_estimate(place, {1, 2, 0.5}, {0, 0, 0, 0, 0, kNan}, &error),
                 PH_INVALID_VALUE, "xa is nan");
    EXPECT_WORKS(ph_localize_particles(place, &particles, &count, &error));
    ASSERT_EQ(count, 1U);
    EXPECT_EQ(particles[0].pose.y, 4.0);
  }
  EXPECT_THAT(
      sent(server.finish(), PH_LOCALIZE_REQ_SET_POSE),
      ElementsAre(body(ph_localize_set_pose_type, ph_localize_set_pose{{1, 2, 0.5}, {0.25, 4, 9, 0, 0, 0}})));
}

TEST(Proxies, APlannerGoesToAGoalAndTellsWhenTheRobotIsThere) {
  int round = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    if (message.header.kind == PH_KIND_CMD) return true;
    const ph_common_pose2d goal = {6, 4, 1.5}, way = {2, 1, 0}, path[] = {way, goal};
    const ph_planner_data told[] = {
        {1, 1, {}, {}, {}, -1, 2},  // of a goal before
        {1, 0, {0.5, 0, 0}, goal, way, 1, 3},
        {1, 1, goal, goal, {}, -1, 3},
    };
    const bool asks = message.header.interface_code == PH_PLANNER_CODE;
    const bool waypoints = asks && message.header.subtype == PH_PLANNER_REQ_GET_WAYPOINTS->subtype;
    peer.answer(message, waypoints
                             ? body(ph_planner_waypoints_req_type, ph_planner_waypoints_req{7.5, path, 2})
                             : Bytes());
    if (asks) return true;
    peer.data(PH_PLANNER_DATA_STATE, body(ph_planner_data_type, told[round++]), 0, 2.5);
    peer.synch();
    return true;
  }));
  {
    const Client client = connected(server.address());
    ph_planner *guide = OPEN(planner, client);
    EXPECT_FALSE(ph_planner_arrived(guide));
    EXPECT_WORKS(ph_planner_go_to(guide, {6, 4, 1.5 + 4 * kPi}, &error));
    read_one(client);
    EXPECT_FALSE(ph_planner_arrived(guide)) << "at another goal";
    read_one(client);
    EXPECT_FALSE(ph_planner_arrived(guide));
    ph_planning state{};
    EXPECT_WORKS(ph_planner_state(guide, &state, &error));
    EXPECT_TRUE(state.valid && !state.done);
    EXPECT_EQ(state.waypoint.x, 2.0);
    EXPECT_EQ(state.index, 1);
    EXPECT_EQ(state.count, 3U);
    EXPECT_EQ(state.time, 2.5);
    read_one(client);
    EXPECT_TRUE(ph_planner_arrived(guide));
    EXPECT_WORKS(ph_planner_stop(guide, &error));
    EXPECT_WORKS(ph_planner_resume(guide, &error));
    ph_path path{};
    EXPECT_WORKS(ph_planner_path(guide, &path, &error));
    ASSERT_EQ(path.count, 2U);
    EXPECT_EQ(path.waypoints[1].x, 6.0);
    EXPECT_EQ(path.length, 7.5);
    EXPECT_WORKS(ph_planner_go_to(guide, {6, 4, 0}, &error));
    EXPECT_FALSE(ph_planner_arrived(guide)) << "another heading";
    EXPECT_FAILS(ph_planner_go_to(guide, {0, kNan, 0}, &error), PH_INVALID_VALUE, "planner:0: y is nan");
  }
  EXPECT_THAT(sent(server.finish(), PH_PLANNER_REQ_ENABLE),
              ElementsAre(Bytes{0, 0, 0, 0}, Bytes{0, 0, 0, 1}));
  EXPECT_EQ(sent(server.finish(), PH_PLANNER_CMD_GOAL).size(), 2U);
}

// --- maps

Bytes compressed(const Bytes &bytes) {
  uLongf size = compressBound(bytes.size());
  Bytes out(size);
  EXPECT_EQ(compress(out.data(), &size, bytes.data(), bytes.size()), Z_OK);
  out.resize(size);
  return out;
}

Bytes tile_body(ph_map_data tile, const Bytes &cells, std::int8_t range) {
  tile.data = reinterpret_cast<const std::int8_t *>(cells.data());
  tile.data_count = static_cast<std::uint32_t>(cells.size());
  tile.data_range = range;
  return body(ph_map_data_type, tile);
}

int value_at(std::size_t column, std::size_t row) {
  return static_cast<int>((column + 3 * row) % 201) - 100;
}

TEST(Maps, OneComesWholeInTiles) {
  constexpr std::uint32_t kWidth = 600, kHeight = 514;
  std::vector<std::vector<std::uint32_t>> tiles;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    if (message.header.subtype == PH_MAP_REQ_GET_INFO->subtype) {
      peer.answer(message, body(ph_map_info_type, ph_map_info{0.5F, kWidth, kHeight, {-1, 2, 0}}));
      return true;
    }
    ph_map_data asked{};
    ph_arena arena = {nullptr};
    EXPECT_EQ(ph_map_data_decode(&asked, message.body.data(), message.body.size(), &arena, nullptr), PH_OK);
    ph_arena_free(&arena);
    tiles.push_back({asked.col, asked.row, asked.width, asked.height});
    Bytes cells;
    for (std::uint32_t i = 0; i < asked.width * asked.height; ++i) {
      cells.push_back(
          static_cast<std::uint8_t>(value_at(asked.col + i % asked.width, asked.row + i / asked.width)));
    }
    peer.answer(message,
                tile_body(asked, asked.row == 0 ? compressed(cells) : cells, 100));  // as without zlib
    return true;
  }));
  {
    const Client client = connected(server.address(), PH_MODE_PUSH);
    ph_map *plan = OPEN(map, client);
    ph_cells map{};
    EXPECT_WORKS(ph_map_cells(plan, &map, &error));
    ASSERT_EQ(map.grid.width, kWidth);
    ASSERT_EQ(map.grid.height, kHeight);
    EXPECT_EQ(map.grid.origin.y, 2.0);
    for (std::size_t row = 0; row < kHeight; ++row) {
      for (std::size_t column = 0; column < kWidth; ++column) {
        const int value = value_at(column, row);
        ASSERT_EQ(map.cells[row * kWidth + column], (value > 50) - (value < -50)) << column << ", " << row;
      }
    }
  }
  server.finish();
  EXPECT_THAT(tiles, ElementsAre(ElementsAre(0, 0, 512, 512), ElementsAre(512, 0, 88, 512),
                                 ElementsAre(0, 512, 512, 2), ElementsAre(512, 512, 88, 2)));
}

TEST(Maps, APointOfTheWorldIsInACellOrBeyondTheMap) {
  const ph_grid grid = {0.5, 4, 2, {10, 20, kPi / 2}};  // columns go along y, rows against x
  ph_cell cell{};
  EXPECT_TRUE(ph_grid_cell_of(&grid, {9.9, 20.1}, &cell));
  EXPECT_EQ(cell.column, 0U);
  EXPECT_TRUE(ph_grid_cell_of(&grid, {9.4, 21.9}, &cell));
  EXPECT_EQ(cell.column, 3U);
  EXPECT_EQ(cell.row, 1U);
  for (const ph_point at :
       {ph_point{10.1, 20.1}, ph_point{9.9, 19.9}, ph_point{9.9, 22.1}, ph_point{8.9, 20.1},
        ph_point{kNan, 20.1}, ph_point{9.9, static_cast<double>(INFINITY)}}) {
    EXPECT_FALSE(ph_grid_cell_of(&grid, at, &cell));
  }
}

TEST(Maps, ThoseThatMakeNoSenseAreAnError) {
  const float inf = INFINITY, nan = NAN;
  const std::vector<ph_map_info> infos = {{0, 2, 2, {}},
                                          {nan, 2, 2, {}},
                                          {0.5F, 2, 2, {static_cast<double>(inf), 0, 0}},
                                          {0.5F, 1 << 14, (1 << 12) + 1, {}},
                                          {0.5F, 2, 2, {}},
                                          {0.5F, 2, 2, {}},
                                          {0.5F, 2, 2, {}},
                                          {0.5F, 0, 1U << 31, {}}};
  const std::vector<Bytes> tiles = {compressed({1, 1, 1}), compressed(Bytes(1 << 20)), {}};
  std::size_t info = 0, tile = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    const bool asks_info = message.header.subtype == PH_MAP_REQ_GET_INFO->subtype;
    peer.answer(message, asks_info ? body(ph_map_info_type, infos[info++])
                                   : tile_body({0, 0, 2, 2, 1, nullptr, 0}, tiles[tile++], 1));
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_map *plan = OPEN(map, client);
  ph_cells map{};
  for (const char *fault :
       {"invalid map", "invalid map", "invalid map", "16384 x 4097 cells are over the limit of 67108864",
        "a tile of 2 x 2 cells is damaged", "a tile of 2 x 2 cells is damaged",
        "a tile of 2 x 2 cells is damaged"}) {
    EXPECT_FAILS(ph_map_cells(plan, &map, &error), PH_WIRE_ERROR, fault);
  }
  EXPECT_WORKS(ph_map_cells(plan, &map, &error));
  EXPECT_EQ(map.grid.width, 0U);
}

// --- the simulation

TEST(Simulations, WhatIsAskedOfTheWorld) {
  int asked = 0;
  FakeServer server(script([&](Peer &peer, const Received &message) {
    ph_simulation_property_req told = {"", 1, "", 1, 0, "no such member", 15};
    if (message.header.subtype == PH_SIMULATION_REQ_GET_POSE2D->subtype) {
      peer.answer(message, {}, PH_KIND_NACK);
      return true;
    }
    if (++asked == 2) told.value = "the run has ended", told.value_count = 18;
    if (asked == 4) told.value = "r0:1", told.value_count = 5;
    if (asked == 5) peer.position(7.0);
    peer.answer(message, asked == 3 ? Bytes() : body(ph_simulation_property_req_type, told),
                asked >= 4 ? PH_KIND_ACK : PH_KIND_NACK);
    return true;
  }));
  {
    const Client client = connected(server.address(), PH_MODE_PUSH);
    ph_simulation *world = OPEN(simulation, client);
    ph_position2d *robot = OPEN(position2d, client);
    ph_pose pose{};
    const char *name = nullptr;
    EXPECT_FAILS(ph_simulation_pose(world, "nosuch", &pose, &error), PH_REQUEST_REFUSED,
                 "simulation.req.get_pose2d of model \"nosuch\" was refused");
    EXPECT_FAILS(ph_simulation_join(world, "me", &error), PH_REQUEST_REFUSED,
                 "join was refused: no such member");
    EXPECT_FAILS(ph_simulation_step(world, 2, INFINITY, &error), PH_RUN_ENDED, "the run has ended");
    EXPECT_FAILS(ph_simulation_restart(world, 7, &error), PH_REQUEST_REFUSED,
                 "reset was refused: the server does not do that");
    EXPECT_WORKS(ph_simulation_spawn(world, "r0", {1, 2, 0}, nullptr, &name, &error));
    EXPECT_STREQ(name, "r0:1");
    EXPECT_WORKS(ph_simulation_step(world, 3, INFINITY, &error));
    ph_state state{};
    EXPECT_WORKS(ph_position2d_state(robot, &state, &error));
    EXPECT_EQ(state.pose.x, 7.0) << "what was pushed during a step is delivered";
  }
  const std::vector<Bytes> requests = sent(server.finish(), PH_SIMULATION_REQ_SET_PROPERTY);
  ASSERT_EQ(requests.size(), 5U);
  const ph_simulation_property_req step = {"", 1, "step", 5, 0, "\2\0\0\0", 4};
  const ph_simulation_property_req seed = {"", 1, "reset", 6, 0, "\7\0\0\0\0\0\0\0", 8};
  EXPECT_EQ(requests[1], body(ph_simulation_property_req_type, step));
  EXPECT_EQ(requests[2], body(ph_simulation_property_req_type, seed));
}

TEST(Simulations, ARestartDropsWhatCameBeforeItsAnswerAndKeepsWhatComesAfter) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    const ph_opaque_data old = {reinterpret_cast<const std::uint8_t *>("old"), 3};
    peer.position(2.0, 2.0);
    peer.data(PH_OPAQUE_DATA_STATE, body(ph_opaque_data_type, old), 0, 2.0);
    peer.answer(message, message.body);
    peer.position(3.0, 0.5);
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_simulation *world = OPEN(simulation, client);
  ph_position2d *robot = OPEN(position2d, client);
  ph_opaque *radio = OPEN(opaque, client);
  const ph_device *device = ph_position2d_device(robot);
  EXPECT_WORKS(ph_simulation_step(world, 1, INFINITY, &error));
  EXPECT_TRUE(ph_device_has_data(device));
  EXPECT_WORKS(ph_simulation_restart(world, 7, &error));
  EXPECT_FALSE(ph_device_has_data(device));
  EXPECT_FALSE(ph_device_fresh(device));
  EXPECT_EQ(ph_device_timestamp(device), 0.0);
  const std::uint8_t *bytes = nullptr;
  std::size_t size = 0;
  EXPECT_FALSE(ph_opaque_take_message(radio, &bytes, &size));
  ph_state state{};
  EXPECT_FAILS(ph_position2d_state(robot, &state, &error), PH_NO_DATA, "has sent no data yet");
  EXPECT_WORKS(ph_position2d_next_data(robot, PH_OWN_TIMEOUT, &error));
  EXPECT_WORKS(ph_position2d_state(robot, &state, &error));
  EXPECT_EQ(state.pose.x, 3.0);
}

TEST(Simulations, ARefusedRestartDropsNothing) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    peer.position(2.0);
    peer.answer(message, {}, PH_KIND_NACK);
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_position2d *robot = OPEN(position2d, client);
  EXPECT_FAILS(ph_simulation_restart(OPEN(simulation, client), 7, &error), PH_REQUEST_REFUSED,
               "reset was refused");
  read_one(client);
  EXPECT_TRUE(ph_device_has_data(ph_position2d_device(robot)));
}

TEST(Simulations, ATimeThatGoesBackDropsWhatOtherDevicesHaveOfALaterOne) {
  FakeServer server(script([](Peer &peer, const Received &message) {
    const ph_position2d_data data{};
    peer.position(1.0, 1.0);
    peer.data(PH_POSITION2D_DATA_STATE, body(ph_position2d_data_type, data), 1, 2.0);
    peer.position(2.0, 0.5);
    peer.answer(message, message.body);
    return true;
  }));
  const Client client = connected(server.address(), PH_MODE_PUSH);
  ph_position2d *back = OPEN(position2d, client);
  ph_position2d *later = opened(ph_position2d_open(client.get(), 1, PH_ACCESS_ALL, nullptr));
  EXPECT_WORKS(ph_simulation_step(OPEN(simulation, client), 1, INFINITY, &error));
  EXPECT_EQ(ph_device_timestamp(ph_position2d_device(back)), 0.5);
  EXPECT_FALSE(ph_device_has_data(ph_position2d_device(later)));
}

}  // namespace
}  // namespace playhouse_c
