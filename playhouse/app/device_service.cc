#include "playhouse/app/device_service.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <utility>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/descriptor_limit.h"
#include "playhouse/app/fail.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

/// The first non-loopback IPv4 address of this machine; none without a network.
std::optional<std::string> address_for_others() {
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return std::nullopt;
  std::optional<std::string> found;
  for (const ifaddrs* each = all; each != nullptr && !found; each = each->ifa_next) {
    constexpr unsigned kUp = IFF_UP | IFF_RUNNING;
    if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET) continue;
    if ((each->ifa_flags & kUp) != kUp || (each->ifa_flags & IFF_LOOPBACK)) continue;
    char text[INET_ADDRSTRLEN];
    const auto& address = reinterpret_cast<const sockaddr_in*>(each->ifa_addr)->sin_addr;
    if (inet_ntop(AF_INET, &address, text, sizeof text) != nullptr) found = text;
  }
  freeifaddrs(all);
  return found;
}

}  // namespace

DeviceService::DeviceService(const std::string& bind, std::span<const std::string> allowed)
    : libraries_{.folders = {}, .allowed = {allowed.begin(), allowed.end()}},
      server_(std::make_unique<server::Server>(
          loop_, server::ServerOptions{.bind = bind, .sessions = sessions_that_fit()})) {}

drivers::Site& DeviceService::open_site(std::uint16_t port) {
  drivers::Host& surroundings = *this;  // private base, not accessible to make_unique
  site_ = std::make_unique<drivers::Site>(surroundings, port);
  site_->data_flow().pass_to(*server_);
  return *site_;
}

DeviceService::~DeviceService() {
  if (site_ != nullptr) end_drivers(*site_, drivers_);
}

Result<void> DeviceService::make_drivers(const scene::CfgFile& file) {
  Result<std::vector<std::unique_ptr<device::Driver>>> made = drivers::make_drivers(file, *site_);
  for (const std::string& warning : site_->warnings()) warn(warning);
  if (!made) return made.error();
  drivers_ = std::move(*made);
  return {};
}

Result<std::unique_ptr<run::Simulation>> DeviceService::open_world(const std::string& path) {
  return Error{escaped(path), "there is no world here"};
}

int DeviceService::run() {
  const auto caught = [this](int signal) {
    if (ending_) std::_Exit(128 + signal);  // second signal: at once
    end(128 + signal);
  };
  if (ends_on_hangup()) {
    loop_.on_signal({SIGINT, SIGTERM, SIGHUP}, caught);
  } else {
    loop_.on_signal({SIGINT, SIGTERM}, caught);
  }
  loop_.run();
  return code_;
}

void DeviceService::end(int code) {
  if (std::exchange(ending_, true)) return;
  code_ = code;
  loop_.post([this] { server_->finish([this] { loop_.finish(); }); });
}

bool has_world(const scene::CfgFile& file) {
  return std::ranges::any_of(file.drivers,
                             [](const scene::CfgSection& section) { return section.name() == "stage"; });
}

int serve_devices(const scene::CfgFile& file, const Serving& serving, const Running& running,
                  const std::function<void(const std::vector<std::uint16_t>&)>& opened) {
  std::vector<std::uint16_t> ports;
  DeviceService service(serving.bind, running.allowed_libraries);
  std::uint16_t default_port = serving.port;
  for (const std::uint16_t wanted : ports_of(file, serving.port)) {
    const Result<std::uint16_t> listening = service.listen(wanted == 0 ? serving.port : wanted);
    if (!listening) return fail(port_error(listening.error(), wanted == 0, serving.port_option));
    if (wanted == 0) default_port = *listening;
    ports.push_back(*listening);
  }
  service.open_site(default_port);
  if (const Result<void> made = service.make_drivers(file); !made) return fail_in_file(made.error(), {});
  for (const std::uint16_t each : ports)
    log::say(fmt::format("Player clients: {}:{}", shown_host(serving.bind), each));
  if (opened) opened(ports);
  return service.run();
}

std::string shown_host(const std::string& bind) {
  if (bind == "localhost") return "127.0.0.1";
  if (bind == "0.0.0.0" || bind == "::") return address_for_others().value_or("127.0.0.1");
  return bind.find(':') == std::string::npos ? bind : "[" + bind + "]";
}

std::set<std::uint16_t> ports_of(const scene::CfgFile& file, std::uint16_t default_port) {
  std::set<std::uint16_t> ports;
  for (const scene::CfgSection& section : file.drivers) {
    for (const scene::DeviceAddress& address : section.addresses("provides"))
      ports.insert(address.port.value_or(0));
  }
  if (default_port != 0 && ports.contains(0)) ports.erase(default_port);  // named as well: one port
  return ports;
}

Error port_error(const Error& error, bool is_default, const std::string& port_option) {
  return {error.where, error.text + (is_default ? "; " + port_option + " takes another port"
                                                : "; the configuration file names this port")};
}

}  // namespace playhouse::app
