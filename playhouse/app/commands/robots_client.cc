#include "playhouse/app/commands/robots_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/device_service.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/formats.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/device/device_table.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/messages.h"

namespace playhouse::app {
namespace {

namespace sim = wire::simulation;

constexpr drivers::RemoteDevice kWorld{sim::kCode, 0};
constexpr double kLookAfter = 2;  // s, poll period
constexpr unsigned kMissed = 2;   // consecutive polls: a busy server also refuses

/// x, y and heading as float64, then texts that end with NUL: name, color, sensors (docs/robot-client.md).
std::string value_of(const scene::RobotDesc& robot) {
  const double place[3] = {robot.X_WR.x, robot.X_WR.y, robot.X_WR.a};
  std::string value(sizeof place, '\0');
  std::memcpy(value.data(), place, sizeof place);
  const auto add = [&value](const std::string& text) { value.append(text).push_back('\0'); };
  add(robot.name);
  add(robot.color);
  for (const scene::RobotDesc::SensorDesc& sensor : robot.sensors) {
    const auto& X = sensor.X_RS;
    add(X ? fmt::format("{} {} {} {}", sensor.type, X->x, X->y, X->a) : sensor.type);
  }
  return value;
}

std::vector<std::byte> property(const std::string& name, const std::string& what, std::string value) {
  sim::PropertyReq request;
  request.name = wire::c_string(name);
  request.prop = wire::c_string(what);
  request.value = std::move(value);
  return wire::encode(request);
}

/// Text of a reply; empty if there is none.
std::string text_of(std::span<const std::byte> body) {
  const Result<sim::PropertyReq> told = wire::decode<sim::PropertyReq>(body);
  return told ? std::string(wire::text(told->value)) : std::string();
}

/// Number of a reply.
std::optional<std::uint32_t> number_of(std::span<const std::byte> body) {
  const Result<sim::PropertyReq> told = wire::decode<sim::PropertyReq>(body);
  std::uint32_t number = 0;
  if (!told || told->value.size() != sizeof number) return std::nullopt;
  std::memcpy(&number, told->value.data(), sizeof number);
  return number;
}

/// Parses "laser:7".
std::optional<drivers::RemoteDevice> parse_device(const std::string& text) {
  const Result<config::DeviceAddress> address = config::parse_device_address(text);
  const wire::InterfaceDef* const interf = address ? wire::find_interface(address->interf) : nullptr;
  if (interf == nullptr) return std::nullopt;
  return drivers::RemoteDevice{interf->code, address->index};
}

/// The port of a device that is not on the connection's: 6666 of "6666:position2d:0".
std::optional<std::uint16_t> other_port(const std::string& device) {
  const Result<config::DeviceAddress> address = config::parse_device_address(device);
  return address ? address->port : std::nullopt;
}

}  // namespace

RobotsClient::RobotsClient(ServingProgram program, RobotsClientOptions options,
                           std::vector<scene::RobotDesc> robots)
    : program_(std::move(program)), options_(std::move(options)), next_port_(options_.port) {
  for (scene::RobotDesc& desc : robots) robots_.push_back({std::move(desc), {}, {}, false, false, 0});
  auto relay = std::make_unique<drivers::Passthrough>(program_.site, options_.host, options_.server_port,
                                                      drivers::Passthrough::AfterLoss::kRetire);
  relay_ = relay.get();
  relay_->remote().set_token(options_.token);
  relay_->remote().set_trust(options_.trust);
  program_.keep(std::move(relay));
  relay_->watch({.connected = [this] { greet(); },
                 .lost =
                     [this](const std::string& why) {
                       fail_with({relay_->remote().name(), why});
                     },
                 .retired = [this](drivers::RemoteDevice device) { retired(device); }});
}

void RobotsClient::begin() {
  relay_->connect();
}

void RobotsClient::fail_with(const Error& error) {
  relay_->remote().disconnect();
  if (!std::exchange(failed_, true)) program_.failed(error);
}

/// A peer may speak the protocol up to its banner, and no further.
void RobotsClient::expect_answer() {
  answer_ = program_.network.after(options_.patience, [this] {
    fail_with({relay_->remote().name(), fmt::format("has not answered for {:g} s", options_.patience)});
  });
}

/// The log names the build at the other end, for reports of bugs.
void RobotsClient::greet() {
  relay_->remote().ask(kWorld, sim::kReqGetProperty, property("", "build", {}),
                       [this](bool ack, std::span<const std::byte> body) {
                         if (ack)
                           log::info("{} is Playhouse {}", relay_->remote().name(), escaped(text_of(body)));
                       });
  expect_answer();
  relay_->remote().ask(
      kWorld, sim::kReqGetProperty, property("", "robot_format", {}),
      [this](bool ack, std::span<const std::byte> body) {
        answer_.reset();
        if (!relay_->remote().is_connected()) return;  // reported already
        const std::optional<std::uint32_t> format = ack ? number_of(body) : std::nullopt;
        if (format == formats::kRobots) return bring_next();
        fail_with({relay_->remote().name(),
                   format
                       ? fmt::format("robots join by format {} there; this program brings them by format {}",
                                     *format, formats::kRobots)
                       : "takes no robots, or is older than Playhouse 0.2"});
      });
}

void RobotsClient::bring_next() {
  if (next_ == robots_.size()) return;
  RemoteRobot& robot = robots_[next_++];
  expect_answer();
  relay_->remote().ask(
      kWorld, sim::kReqSetProperty, property(robot.desc.type, "robot", value_of(robot.desc)),
      [this, &robot](bool ack, std::span<const std::byte> body) {
        answer_.reset();
        if (!relay_->remote().is_connected()) return;  // reported already
        const std::string told = text_of(body);
        if (ack) return came(robot, told);
        fail_with({robot.desc.where, told.empty() ? relay_->remote().name() + " takes no robots" : told});
      });
}

void RobotsClient::came(RemoteRobot& robot, std::string name) {
  robot.name = std::move(name);
  expect_answer();
  relay_->remote().ask(kWorld, sim::kReqGetProperty, property(robot.name, "devices", {}),
                       [this, &robot](bool ack, std::span<const std::byte> body) {
                         answer_.reset();
                         if (!relay_->remote().is_connected()) return;
                         if (ack) return serve(robot, text_of(body));
                         fail_with({robot.desc.where, in_quotes(robot.name) + " left the world again"});
                       });
}

Result<std::uint16_t> RobotsClient::open_port(const RemoteRobot& robot) {
  if (robot.desc.port) {
    const Result<std::uint16_t> port = program_.listen(*robot.desc.port);
    if (!port) return Error{robot.desc.where, port.error().line()};
    return port;
  }
  const Result<std::uint16_t> port = program_.listen(next_port_);
  if (!port) return device_server::port_error(port.error(), true, "--port");
  if (next_port_ != 0) ++next_port_;
  return port;
}

device::Address RobotsClient::address_of(const RemoteRobot& robot, std::uint16_t port,
                                         std::uint16_t interf) const {
  const auto first = robot.desc.first_index.find(std::string(wire::find_interface(interf)->name));
  const auto before = std::ranges::count(robot.devices, interf, &drivers::RemoteDevice::interf);
  const long index = before + (first == robot.desc.first_index.end() ? 0 : first->second);
  return {port, interf, static_cast<std::uint16_t>(index)};
}

/// Port and devices appear in one turn of the loop, so no client can see a port without devices. The robot's
/// first device decides on the server's port: as interfaces count for themselves, no port may have them all.
void RobotsClient::serve(RemoteRobot& robot, const std::string& devices) {
  if (const std::optional<std::uint16_t> other = other_port(devices.substr(0, devices.find(' '))))
    return fail_with({robot.desc.where, fmt::format("{} has devices on port {} of the server: --server {}:{}",
                                                    in_quotes(robot.name), *other, options_.host, *other)});
  const Result<std::uint16_t> port = open_port(robot);
  if (!port) return fail_with(port.error());
  std::istringstream words(devices);
  std::vector<std::string> shown, elsewhere;
  for (std::string word; words >> word;) {
    const std::optional<drivers::RemoteDevice> device = parse_device(word);
    if (!device) continue;
    if (const std::optional<std::uint16_t> other = other_port(word)) {
      elsewhere.push_back(
          fmt::format("{}:{}:{}", *other, wire::find_interface(device->interf)->name, device->index));
      continue;
    }
    const device::Address address = address_of(robot, *port, device->interf);
    if (const Result<void> added = relay_->add(address, *device); !added)
      return fail_with({robot.desc.where, added.error().line()});
    robot.devices.push_back(*device);
    shown.push_back(device::describe_on_port(address));
  }
  if (robot.devices.empty())
    return fail_with({robot.desc.where, relay_->remote().name() + " gives robots that join no devices"});
  robot.joined = true;
  program_.say(fmt::format("Player clients: {}:{} ({}: {})", shown_host(options_.bind), *port,
                           escaped(robot.name), fmt::join(shown, " ")));
  if (!elsewhere.empty())
    warn(Error{robot.desc.where, fmt::format("{} has devices on other ports of the server, left out: {}",
                                             in_quotes(robot.name), fmt::join(elsewhere, " "))}
             .line());
  bring_next();
  if (next_ == robots_.size() && !look_after_) look_after();
}

/// Polls, since robots without open devices are removed without notice.
void RobotsClient::look_after() {
  for (RemoteRobot& robot : robots_) {
    if (robot.gone || !robot.joined) continue;
    relay_->remote().ask(kWorld, sim::kReqGetProperty, property(robot.name, "devices", {}),
                         [this, &robot](bool ack, std::span<const std::byte>) {
                           robot.missed = ack ? 0 : robot.missed + 1;
                           if (robot.missed >= kMissed && relay_->remote().is_connected()) gone(robot);
                         });
  }
  look_after_ = program_.network.after(kLookAfter, [this] { look_after(); });
}

/// A robot's first device is its own.
void RobotsClient::retired(drivers::RemoteDevice device) {
  for (RemoteRobot& robot : robots_)
    if (!robot.devices.empty() && robot.devices.front() == device) gone(robot);
}

void RobotsClient::gone(RemoteRobot& robot) {
  if (std::exchange(robot.gone, true)) return;
  const Error gone{robot.desc.where, in_quotes(robot.name) + " was taken out of the world"};
  const bool was_last = std::ranges::all_of(robots_, [](const RemoteRobot& each) { return each.gone; });
  if (was_last) return fail_with(gone);
  warn(gone.line());
}

RobotsClient::ServingProgram serving_program(DeviceService& service, std::uint16_t port) {
  return {.site = service.open_site(port),
          .network = service.loop(),
          .keep = [&service](std::unique_ptr<device::Driver> driver) { service.take(std::move(driver)); },
          .listen = [&service](std::uint16_t wanted) { return service.listen(wanted); },
          .say = log::say,
          .failed =
              [&service](const Error& error) {
                fail_in_file(error, {});
                service.end(kFailed);
              }};
}

}  // namespace playhouse::app
