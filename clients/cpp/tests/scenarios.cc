/// Repeats the programs behind the recorded sessions with this library: scenarios
/// NAME HOST:PORT. clients/python/tests/test_replay.py plays back the recorded answers and compares what the
/// client sends; clients/python/tests/scenarios.py is the Python counterpart.

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <string>

#include "must.h"
#include "playhouse/wire/generated/map.h"
#include "playhouse_client/laser.h"
#include "playhouse_client/position2d.h"
#include "playhouse_client/ranger.h"
#include "playhouse_client/simulation.h"

using namespace playhouse;
using namespace playhouse::client;

namespace {

constexpr double kPi = std::numbers::pi;

template <typename T>
void must_refuse(const Result<T>& result) {
  if (result || result.error().text.find("refused") == std::string::npos)
    fail("the server should have refused");
}

void read_rounds(Client& client, int count) {
  for (int i = 0; i < count; ++i) must(client.read());
}

void print_position(const std::string& address) {
  Client client = must(Client::connect(address));
  Position2d robot = must(Position2d::open(client, 0));
  must(client.set_mode(Mode::kPull));
  must(client.set_replace_rule(Rule::kAccept));
  read_rounds(client, 3);
}

void print_defaults(const std::string& address) {
  Client client = must(Client::connect(address));
  Position2d robot = must(Position2d::open(client, 0));
  read_rounds(client, 2);
}

void check_position(const std::string& address) {
  Client client = must(Client::connect(address));
  Position2d robot = must(Position2d::open(client, 0));
  read_rounds(client, 23);
  must(robot.set_odometry({0.1, -0.2, kPi}));
  read_rounds(client, 10);
  must(robot.set_odometry({0, 0, 0}));
  must(robot.set_motor_power(true));
  must(robot.drive(0.1, 0));
  must(robot.drive(-0.1, 0));
  must(robot.drive(0, 0, 0.1));
  must(robot.drive(0, 0, -0.1));
  must(robot.drive(0, -25 * kPi / 180));
  must(robot.drive(0, 25 * kPi / 180));
  must(robot.drive(0, 45 * kPi / 180, 0.1));
  must(robot.drive(0, -45 * kPi / 180, -0.1));
  must(robot.stop());
  must(robot.set_motor_power(false));
  must(robot.set_odometry({0, 0, 0}));
}

void check_laser(const std::string& address) {
  Client client = must(Client::connect(address));
  Laser laser = must(Laser::open(client, 0));
  read_rounds(client, 20);
  const float quarter = static_cast<float>(kPi / 2);
  must_refuse(laser.set_config({-quarter, quarter, 100, 0, 1, 1, 10}));
}

void check_ranger(const std::string& address) {
  Client client = must(Client::connect(address));
  Ranger ranger = must(Ranger::open(client, 1));
  read_rounds(client, 60);
  must(ranger.device().request<wire::ranger::Geom>(wire::ranger::kReqGetGeom));
  read_rounds(client, 3);
}

void ask_map(const std::string& address) {
  namespace map = wire::map;
  Client client = must(Client::connect(address, {.mode = Mode::kPush}));
  Device device = must(Device::open(client, map::kCode, 0));
  must(device.request<map::Info>(map::kReqGetInfo));
  must(device.request<map::Data>(map::kReqGetData, map::Data{0, 0, 20, 10, 0, {}}));
  must(device.request<map::Data>(map::kReqGetData, map::Data{495, 0, 50, 3, 0, {}}));
  must_refuse(device.request<map::DataVector>(map::kReqGetVector));
}

void ask_simulation(const std::string& address) {
  Client client = must(Client::connect(address, {.mode = Mode::kPush}));
  Simulation simulation = must(Simulation::open(client, 0));
  must(simulation.pose("r0"));
  must(simulation.set_pose("r0", {-6, -6, 0.5}));
  must_refuse(simulation.pose("nosuch"));
  must(simulation.pose3d("r0"));
}

void ask_properties(const std::string& address) {
  Client client = must(Client::connect(address, {.mode = Mode::kPush}));
  Device lights = must(Device::open(client, wire::find_interface("dio")->code, 0));
  Device stream = must(Device::open(client, wire::find_interface("opaque")->code, 1));
  must(lights.get_int("skip_lines"));
  must(lights.set_int("skip_lines", 7));
  must(lights.get_int("skip_lines"));
  must(lights.get_double("max_diff_pixels"));
  must(lights.set_double("max_diff_pixels", 0.25));
  must(lights.get_double("max_diff_pixels"));
  must(lights.get_int("max_diff_pixels"));
  must_refuse(lights.get_int("nope"));
  lights.has_capability(wire::MessageType::kReq, wire::kReqCapabilities);
  must(stream.get_string("ip"));
  must(stream.set_string("ip", "127.0.0.2"));
  must(stream.get_string("ip"));
  must_refuse(stream.get_bool("nobool"));
}

}  // namespace

int main(int argc, char** argv) {
  const std::map<std::string, std::function<void(const std::string&)>> scenarios = {
      {"05_playerprint_position2d", print_position}, {"06_playerprint_defaults", print_defaults},
      {"10_cxxtest_position2d", check_position},     {"11_cxxtest_laser", check_laser},
      {"12_cxxtest_ranger", check_ranger},           {"13_raw_map", ask_map},
      {"14_raw_simulation", ask_simulation},         {"15_raw_properties", ask_properties},
  };
  const auto found = argc == 3 ? scenarios.find(argv[1]) : scenarios.end();
  if (found == scenarios.end()) fail("usage: scenarios NAME HOST:PORT");
  found->second(argv[2]);
  return 0;
}
