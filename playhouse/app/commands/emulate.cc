#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <string>
#include <vector>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/discovery/found_servers.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/bridge/all_drivers.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device_server/device_server.h"
#include "playhouse/wire/messages.h"
#include "playhouse_client/client.h"
#include "playhouse_client/robot.h"

namespace playhouse::app {
namespace {

constexpr std::string_view kEmulatorSuffix = "_emulator";
constexpr const char* kSections = "playhouse emulate";  // in place of a file's name, in errors

/// Names of what can be emulated.
std::vector<std::string_view> emulated() {
  std::vector<std::string_view> names;
  for (const drivers::DriverDefinition* driver : drivers::all_drivers().all())
    if (driver->name.ends_with(kEmulatorSuffix))
      names.push_back(driver->name.substr(0, driver->name.size() - kEmulatorSuffix.size()));
  return names;
}

Result<const drivers::DriverDefinition*> find_emulator(const std::string& name) {
  if (const auto* found = drivers::all_drivers().find(name + std::string(kEmulatorSuffix))) return found;
  return Error{in_quotes(name),
               fmt::format("is nothing that can be emulated: {} is valid", fmt::join(emulated(), ", "))};
}

/// The robot's devices that the emulator may use, one for each of its entries: "position2d:0".
std::vector<std::string> devices_for(const drivers::DriverDefinition& emulator, const client::Robot& robot) {
  std::vector<std::string> devices;
  for (const drivers::DeviceText& wanted : emulator.uses) {
    const std::uint16_t interf = wire::find_interface(wanted.interf)->code;
    for (const client::RobotDevice& device : robot.devices()) {
      if (device.address.interf != interf) continue;
      devices.push_back(fmt::format("{}:{}", wanted.interf, device.address.index));
      break;
    }
  }
  return devices;
}

std::string quoted(const std::vector<std::string>& texts, const std::string& prefix = "") {
  std::string list;
  for (const std::string& text : texts)
    list += fmt::format("{}\"{}{}\"", list.empty() ? "" : " ", prefix, text);
  return list;
}

/// The sections of a relay of the devices and of the emulator that uses them.
Result<std::string> sections(const EmulateOptions& options, const client::Address& server,
                             const std::vector<std::string>& devices, const std::string& emulator) {
  const std::string host = server.host.find(':') == std::string::npos ? server.host : "[" + server.host + "]";
  std::string text = fmt::format("driver( name \"passthrough\" provides [{}] requires [{}] {})\n",
                                 quoted(devices), quoted(devices, fmt::format("{}:{}:", host, server.port)),
                                 options.token.empty() ? "" : fmt::format("token \"{}\" ", options.token));
  text += fmt::format("driver( name \"{}\" requires [{}]", emulator, quoted(devices));
  if (!options.port.empty()) text += fmt::format(" port \"{}\"", options.port);
  if (options.tcp_port != 0) text += fmt::format(" tcp_port {}", options.tcp_port);
  for (const std::string& option : options.options) {
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos || option.find_first_of("\"()[]\n") != std::string::npos)
      return Error{"--option " + option, "invalid option: KEY=VALUE is valid, as robot=p3at-sh"};
    const std::string value = option.substr(equals + 1);
    const bool is_number = !value.empty() && value.find_first_not_of("0123456789.-") == std::string::npos;
    text += fmt::format(" {} {}{}{}", option.substr(0, equals), is_number ? "" : "\"", value,
                        is_number ? "" : "\"");
  }
  return text + " )\n";
}

Result<client::Robot> find_robot(client::Client& client, const std::string& name) {
  if (!name.empty()) return client.robot(name);
  const Result<std::vector<client::Robot>> robots = client.robots();
  if (!robots) return robots.error();
  if (robots->empty()) return Error{client.peer(), "this server has no robot"};
  return robots->front();
}

/// The robot, and those of its devices that the emulator may use. The connection is closed again.
struct FoundRobot {
  std::string name;
  std::vector<std::string> devices;
};
Result<FoundRobot> look_for(const EmulateOptions& options, const NamedServer& server,
                            const drivers::DriverDefinition& emulator) {
  if (!options.devices.empty()) return FoundRobot{options.robot, options.devices};
  Result<client::Client> client =
      client::Client::connect(server.address.host, server.address.port, {.token = options.token});
  if (!client) return server.explain(client.error());
  const Result<client::Robot> robot = find_robot(*client, options.robot);
  if (!robot) return robot.error();
  FoundRobot found{robot->name(), devices_for(emulator, *robot)};
  if (!found.devices.empty()) return found;
  return Error{
      in_quotes(found.name),
      fmt::format("has no device for this: playhouse drivers {} lists those that it uses", emulator.name)};
}

/// Relays the devices, and runs the emulator over them.
int run_sections(const std::string& text, std::uint16_t own_port, const std::string& told) {
  config::MemoryFiles none({});
  const Result<config::CfgFile> file = config::load_cfg_text(text, kSections, none, own_port);
  if (!file) return fail(file.error(), kUsage);
  device_server::DeviceServer service({});
  service.open_site(own_port, service.server());
  const Result<void> made = service.make_drivers(drivers::all_drivers(), *file, warn);
  if (!made) return fail(made.error(), kUsage);
  fmt::print("{}\n", told);
  std::fflush(stdout);
  return service.run();
}

}  // namespace

int emulate(const EmulateOptions& options) {
  const Result<const drivers::DriverDefinition*> emulator = find_emulator(options.hardware);
  if (!emulator) return fail(emulator.error(), kUsage);
  const Result<NamedServer> server = reach_server(options.server);
  if (!server) return fail(server.error(), kUsage);
  const Result<FoundRobot> robot = look_for(options, *server, **emulator);
  if (!robot) return fail(robot.error());
  const Result<std::string> text =
      sections(options, server->address, robot->devices, std::string((*emulator)->name));
  if (!text) return fail(text.error(), kUsage);
  const std::string place =
      options.port.empty() ? fmt::format("127.0.0.1:{}", options.tcp_port) : options.port;
  // Other than the server's, or a relay of its devices would stand for itself.
  const std::uint16_t own_port =
      server->address.port == client::kDefaultPort ? client::kDefaultPort + 1 : client::kDefaultPort;
  return run_sections(
      *text, own_port,
      fmt::format("{} at {}: {}{} at {}:{}", options.hardware, place, fmt::join(robot->devices, ", "),
                  robot->name.empty() ? "" : " of " + in_quotes(robot->name), server->address.host,
                  server->address.port));
}

}  // namespace playhouse::app
