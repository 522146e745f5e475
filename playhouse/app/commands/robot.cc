#include <utility>
#include <vector>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/commands/robots_client.h"
#include "playhouse/app/device_service.h"
#include "playhouse/app/tls_files.h"
#include "playhouse/app/whole_file.h"
#include "playhouse/base/fail.h"
#include "playhouse/scene/robot_file.h"

namespace playhouse::app {
namespace {

Result<std::vector<scene::RobotDesc>> read_files(const std::vector<std::string>& files) {
  std::vector<scene::RobotDesc> all;
  for (const std::string& file : files) {
    const Result<std::string> text = read_file(file);
    if (!text) return text.error();
    const Result<std::vector<scene::RobotDesc>> robots = scene::read_robots(*text, file);
    if (!robots) return robots.error();
    all.insert(all.end(), robots->begin(), robots->end());
  }
  return all;
}

}  // namespace

int robot(const RobotOptions& options) {
  const Result<client::Address> server = parse_server(options.server);
  if (!server) return fail(server.error(), kUsage);
  Result<std::vector<scene::RobotDesc>> robots = read_files(options.files);
  if (!robots) return fail_in_file(robots.error(), {});
  const Result<std::shared_ptr<net::TlsTrust>> trust = read_tls_trust(options.tls_ca);
  if (!trust) return fail_in_file(trust.error());
  DeviceService service({.bind = options.bind});
  RobotsClient client(
      serving_program(service, options.port),
      {server->host, server->port, options.bind, options.port, options.wait, options.token, *trust},
      std::move(*robots));
  client.begin();
  return service.run();
}

}  // namespace playhouse::app
