/// Uses radio, camera, speech, IMU, drivers on a map and equipment of the real server through this library:
/// robots radio|camera|voice|inertia|course|equipment HOST:PORT, with worlds/radio.world, camera.world,
/// radio.world, outdoor.world, navigate.cfg or clients/python/tests/equipment.world respectively. Prints what
/// fails and exits with 1. Run by test_server.py and test_equipment.py in clients/python/tests.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "must.h"
#include "playhouse_client/robot.h"
#include "playhouse_client/simulation.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

void must_be(bool fact, const std::string& what) {
  if (!fact) fail("it is not true that " + what);
}

void must_refuse(const Result<void>& result, const std::string& what) {
  if (result || result.error().text.find("refused") == std::string::npos)
    fail("the server should have refused " + what);
}

/// Network address of the radio with the best link to this one.
std::string nearest(Client& client) {
  const Wifi air = must(Wifi::open(client, 0));
  while (!air.state()) must(client.read());
  must_be(!air.links().empty(), "a radio hears another one");
  return air.links().front().ip;
}

void use_radios(const std::string& address) {
  Client client = must(Client::connect(address)), other = must(Client::connect(address));
  Opaque radio = must(must(client.robot("r0")).opaque()), receiver = must(must(other.robot("r1")).opaque());
  const std::string to_one("\0to one", 7);
  must(radio.send("to all"));
  must(radio.send_to(nearest(client), to_one));
  must(radio.send_to("", ""));
  std::vector<std::string> heard;
  while (heard.size() < 3) {
    must(other.read());
    for (std::string& message : receiver.take_messages()) heard.push_back(std::move(message));
  }
  must_be(heard == std::vector<std::string>{"to all", to_one, ""}, "messages come whole and in order");
  must_be(radio.take_messages().empty(), "nobody hears itself");
  must_refuse(radio.send_to("10.0.9.9", "x"), "an address that no radio has");
  must_refuse(radio.send_to("", std::string(2305, 'x')), "a message that is too long");
}

Image next_image(Client& client, Camera& camera) {
  while (!camera.image()) must(client.read());
  return *camera.image();
}

void use_cameras(const std::string& address) {
  Client client = must(Client::connect(address));
  const Robot robot = must(client.robot("r0"));
  Camera color = must(robot.camera(0)), depth = must(robot.camera(1));
  Ptz mount = must(robot.ptz());
  const Image colors = next_image(client, color), distances = next_image(client, depth);
  must_be(colors.width == 160 && colors.height == 120 && !colors.is_jpeg, "the picture is 160 x 120 and raw");
  must_be(must(colors.pixel(159, 119)).size() == 3, "a pixel in colors has three values");
  must_be(must(distances.pixel(40, 59)).at(0) > 50, "the floor before the robot is more than 5 cm away");
  must_be(!distances.pixel(80, 0), "there is no pixel beside the picture");
  must_be(must(mount.geometry()).pose.x == 0.12, "the camera is 12 cm before the robot's middle");
  while (!mount.view()) must(client.read());
  const View before = *mount.view();
  must(mount.look(before.pan + 0.25, before.tilt));
  while (std::abs(mount.view()->pan - before.pan - 0.25) > 0.001) must(client.read());
  must(mount.set_velocity_control(true));
  must(mount.turn(-0.5));
  while (mount.view()->pan > before.pan) must(client.read());
  must_be(mount.view()->pan_speed < 0, "it turns to the right");
  must(mount.turn(0));
}

void use_voices(const std::string& address) {
  Client client = must(Client::connect(address)), other = must(Client::connect(address));
  Speech voice = must(must(client.robot("r0")).speech()), own = must(must(other.robot("r1")).speech());
  SpeechRecognition ears = must(must(other.robot("r1")).speech_recognition());
  must(own.say("my own voice"));
  std::vector<std::string> heard;
  for (const std::string words : {"marco", "sch\xc3\xb6n"}) {
    must(voice.say(words));
    while (heard.empty() || heard.back() != words) {
      must(other.read());
      for (std::string& text : ears.take_texts()) heard.push_back(std::move(text));
    }
  }
  must_be(heard.size() == 2 && std::ranges::find(heard, "my own voice") == heard.end(),
          "a robot hears others and not itself");
}

void use_inertia(const std::string& address) {
  Client client = must(Client::connect(address));
  const Robot robot = must(client.robot("r0"));
  Position3d base = must(robot.position3d());
  Imu unit = must(robot.imu());
  Gps receiver = must(robot.gps());
  PointCloud3d lidar = must(robot.pointcloud3d());
  must_be(!unit.inertia() && !unit.attitude(), "there are no data before the first");
  must(unit.send(wire::imu::kDataEuler));
  while (!base.state() || !unit.attitude() || !receiver.fix() || lidar.points().empty()) must(client.read());
  must_be(std::abs(unit.inertia()->acceleration[2] - 9.81) < 1, "it feels gravity");
  must_be(std::abs(unit.attitude()->roll) < 0.2, "it is level");
  must_be(!unit.velocity() && !unit.quaternion(), "of what is not sent there are no data");
  must_be(std::abs(receiver.fix()->latitude - 50.7747) < 0.001 && receiver.fix()->quality > 0,
          "it is in Aachen");
  must_be(lidar.points().front().color[3] == 255, "points are opaque");
  must(base.set_odometry({5, 6, 0, 0, 0, 0}));
  while (std::abs(base.state()->pose.x - 5) > 1) must(client.read());
  must_be(!base.drive(std::numeric_limits<double>::infinity(), 0), "a number that is not finite is an error");
  must(base.drive(0.2, 0));
  while (base.state()->velocity.x < 0.1) must(client.read());
  must(unit.send(wire::imu::kDataFullstate));
  while (!unit.velocity()) must(client.read());
  must(unit.reset_orientation());
  must(base.close());
}

double distance(const Pose& a, const Pose& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

void check_map(Map plan, const Pose& start) {
  const Grid grid = must(plan.grid());
  const auto cells = must(plan.cells());
  must_be(std::abs(grid.cell_size - 0.1) < 1e-6, "cells have sides of 0.1 m");
  must_be(cells.size() == grid.height && cells.front().size() == grid.width, "the map is whole");
  const auto cell = grid.cell_of({start.x, start.y});
  must_be(cell && cells[cell->row][cell->column] == -1, "a robot stands where nothing else is");
  const auto rock = grid.cell_of({-7.9, -7.9});
  must_be(rock && cells[rock->row][rock->column] == 1, "there is rock around the cave");
}

void use_drivers_on_a_map(const std::string& address) {
  Client client = must(Client::connect(address));
  Simulation simulation = must(Simulation::open(client, 0));
  const Pose start = must(simulation.pose("r0")), goal{6, 4, 1.5};
  check_map(must(Map::open(client, 0)), start);
  const Robot robot = must(client.robot("r0"));
  Localize place = must(robot.localize());
  Planner planner = must(robot.planner());
  must(place.set_pose(start, Covariance::of_deviations(0.2, 0.2, 0.1)));
  must(planner.go_to(goal));
  while (!planner.state() || planner.state()->pose.x < start.x + 0.5) must(client.read());
  must(planner.stop());
  const Path path = must(planner.path());
  must_be(distance(path.waypoints.back(), goal) == 0 && path.length > distance(start, goal),
          "a path leads to the goal");
  must_be(planner.state()->valid && !planner.arrived(), "it is on its way");
  must_be(distance(*place.pose(), must(simulation.pose("r0"))) < 0.3, "it knows where it is");
  must_be(must(place.particles()).size() >= 100, "there are particles");
  must_refuse(place.set_pose(start, {.xx = -1}), "an invalid covariance");
  must(planner.resume());
  while (!planner.arrived()) must(client.read());
  must_be(distance(must(simulation.pose("r0")), goal) < 0.6, "it is at the goal");
  must_be(must(planner.why_refused()).empty(), "it was not refused");
  const Result<void> refused = planner.drive_to(client, {999, 0, 0});
  must_be(!refused && refused.error().text == "no path to (999, 0): the goal is off the map", "it says why");
  must_be(must(planner.why_refused()) == refused.error().text, "and again");
}

void use_gripper(Client& client, Gripper hand) {
  Simulation simulation = must(Simulation::open(client, 0));
  must_be(must(hand.geometry()).beam_count == 2, "it has two beams");
  while (!hand.state() || hand.state()->beams == 0) must(client.read());
  must_be(hand.state()->open, "it is open, and the puck is between its fingers");
  must(hand.close_fingers());
  while (!hand.state()->closed) must(client.read());
  must_be(must(simulation.pose("puck")) == Pose{}, "the puck is in the gripper");
  must(hand.open_fingers());
  while (!hand.state()->moving) must(client.read());
  must(hand.stop());
  while (hand.state()->moving) must(client.read());
  must_be(!hand.state()->open && !hand.state()->closed, "it was stopped in between");
}

void use_joint(Client& client, ActArray arm) {
  must_be(must(arm.geometry()).joints.at(0).highest == 2, "it slides by 2 m");
  while (arm.joints().empty()) must(client.read());
  must(arm.move_to(0, 1.5));
  while (std::abs(arm.joints()[0].position - 1.5) > 1e-3) must(client.read());
  must(arm.set_speed(ActArray::kAll, 0.25));
  must(arm.home());
  while (std::abs(arm.joints()[0].position - 0.5) > 1e-3) {
    must(client.read());
    must_be(arm.joints()[0].speed > -0.26, "it goes home slowly");
  }
  must(arm.set_brakes(true));
  while (!arm.joints()[0].braked) must(client.read());
  must(arm.set_motor_power(false));
  while (arm.state()->motors_on) must(client.read());
  must_refuse(arm.set_speed(0, 5), "a speed over the limit");
}

void use_battery(Client& client, Power battery) {
  while (!battery.state()) must(client.read());
  const PowerState state = *battery.state();
  must_be(state.charging == Charging::kNo && !state.volts, "it is not charged, and tells no voltage");
  must_be(state.joules <= 1000 && std::abs(*state.percent - *state.joules / 20) < 1e-3, "it is half full");
  must(battery.set_charging_policy(false, true));
  while (battery.state()->charging != Charging::kImpossible) must(client.read());
}

void use_lamp(Client& client, BlinkenLight lamp) {
  while (!lamp.state()) must(client.read());
  must_be(lamp.state()->on && lamp.state()->color == Rgb{0, 0, 255}, "it is on and blue");
  must(lamp.set_power(false));
  must(lamp.set_color({255, 0, 0}));
  must(lamp.flash(2));
  while (lamp.state()->period != 2) must(client.read());
  must_be(!lamp.state()->on && lamp.state()->color == Rgb{255, 0, 0}, "it is off and red");
  must(lamp.set(true, 0, 1, {0, 255, 0}));
  while (!lamp.state()->on || lamp.state()->period != 0) must(client.read());
}

void use_equipment(const std::string& address) {
  Client client = must(Client::connect(address));
  const Robot robot = must(client.robot("r0"));
  use_gripper(client, must(robot.gripper()));
  use_joint(client, must(robot.actarray()));
  use_battery(client, must(robot.power()));
  use_lamp(client, must(robot.blinkenlight()));
  const Blobfinder eye = must(robot.blobfinder());
  Wifi radio = must(robot.wifi());
  while (eye.blobs().empty() || radio.links().empty()) must(client.read());
  const Blob ball = eye.blobs().front();
  must_be(ball.channel == 1 && ball.color == Rgb{255, 0, 0} && std::abs(ball.range - 3) < 0.1,
          "it sees the ball");
  const Link link = radio.links().front();
  must_be(link.ip == "10.0.0.2" && link.level < 0 && link.noise == -100, "it hears the other radio");
  must_be(must(radio.mac()) == "02:00:00:00:00:01", "it knows its own address");
}

void use_token(const std::string& address) {
  const auto refused = Client::connect(address, {.token = "no-such-token"});
  must_be(!refused && refused.error().text.find("the token is refused") != std::string::npos,
          "a wrong token is refused");
  Client client = must(Client::connect(address, {.token = "driver-token-1"}));
  Position2d robot = must(Position2d::open(client, 0));
  must(robot.drive(0.3, 0));
  while (!robot.state() || robot.state()->velocity.x < 0.2) must(client.read());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string use = argc == 3 ? argv[1] : "";
  if (use == "radio") {
    use_radios(argv[2]);
  } else if (use == "camera") {
    use_cameras(argv[2]);
  } else if (use == "voice") {
    use_voices(argv[2]);
  } else if (use == "inertia") {
    use_inertia(argv[2]);
  } else if (use == "course") {
    use_drivers_on_a_map(argv[2]);
  } else if (use == "equipment") {
    use_equipment(argv[2]);
  } else if (use == "guest") {
    use_token(argv[2]);
  } else {
    fail("usage: robots radio|camera|voice|inertia|course|equipment|guest HOST:PORT");
  }
  return 0;
}
