/// Uses radio, camera, speech, IMU and drivers on a map of the real server through this library:
/// robots radio|camera|voice|inertia|course HOST:PORT, with worlds/radio.world,
/// camera.world, radio.world, outdoor.world or navigate.cfg respectively. Prints what fails and exits with 1.
/// Run by clients/python/tests/test_server.py.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "must.h"
#include "playhouse/wire/generated/wifi.h"
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
  Device air = must(Device::open(client, wire::wifi::kCode, 0));
  while (!air.take_fresh()) must(client.read());
  const auto data = air.latest<wire::wifi::Data>(wire::wifi::kDataState);
  must_be(data && !data->links.empty(), "a radio hears another one");
  const auto& ip = data->links.front().ip;
  return {ip.begin(), ip.end()};
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
  must_refuse(place.set_pose(start, {.xx = -1}), "a covariance that is none");
  must(planner.resume());
  while (!planner.arrived()) must(client.read());
  must_be(distance(must(simulation.pose("r0")), goal) < 0.6, "it is at the goal");
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
  } else {
    fail("usage: robots radio|camera|voice|inertia|course HOST:PORT");
  }
  return 0;
}
