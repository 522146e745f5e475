#include "playhouse/house/robot_machine.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/scene/robot_file.h"

namespace playhouse::house {
namespace {

std::vector<scene::RobotDesc> robot_named(const std::string& name, std::uint64_t seed) {
  const double x = static_cast<double>(seed % 9) - 4, y = static_cast<double>(seed / 9 % 9) - 4;
  return *scene::read_robots(fmt::format("type = \"robot\"\nname = \"{}\"\npose = [{}, {}, 0]\n", name, x, y),
                             "house.toml");
}

}  // namespace

RobotMachine::RobotMachine(net::SimulatedNetwork& network, std::uint16_t world_port, std::uint16_t port,
                           const std::string& name, double period, std::uint64_t seed)
    : all_(network),
      network_(network),
      port_(port),
      period_(period),
      seed_(seed),
      site_(*this, port),
      server_(network_) {
  site_.data_flow().pass_to(server_);
  robots_ = std::make_unique<app::RobotsClient>(
      app::RobotsClient::ServingProgram{
          .site = site_,
          .network = network_,
          .keep = [this](auto driver) { drivers_.push_back(std::move(driver)); },
          .listen =
              [this](std::uint16_t wanted) {
                serves_ = true;
                return server_.listen(wanted);
              },
          .say = [](const std::string&) {},
          .failed = [this](const Error&) { over_ = true; }},
      app::RobotsClient::RobotsClientOptions{
          .host = "world", .server_port = world_port, .bind = "127.0.0.1", .port = port},
      robot_named(name, seed));
  robots_->begin();
}

void RobotMachine::act() {
  if (over_) return;
  if (serves_ && !client_ && !finishes_) {
    client_.emplace(all_, port_, Manner::kReads, period_, seed_);
    client_->excuse_until(excused_until_);
  }
  if (client_) client_->act();
}

void RobotMachine::hear() {
  if (client_ && !over_) client_->hear(network_.now());
}

void RobotMachine::excuse_until(double time) {
  excused_until_ = time;
  if (client_) client_->excuse_until(time);
}

void RobotMachine::finish() {
  finishes_ = true;
  if (client_) client_->finish();
}

}  // namespace playhouse::house
