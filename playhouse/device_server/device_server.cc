#include "playhouse/device_server/device_server.h"

#include <cstdlib>
#include <utility>

#include "playhouse/device_server/hangup.h"

namespace playhouse::device_server {

DeviceServer::DeviceServer(server::ServerOptions options, libraries::Libraries libraries)
    : libraries_(std::move(libraries)),
      server_(std::make_unique<server::Server>(loop_, std::move(options))) {}

DeviceServer::~DeviceServer() {
  close();
}

void DeviceServer::close() {
  if (site_ != nullptr && !std::exchange(closed_, true)) end_drivers(*site_, drivers_);
}

drivers::Site& DeviceServer::open_site(std::uint16_t port, device::Publisher& publisher) {
  drivers::Host& surroundings = *this;  // private base, not accessible to make_unique
  site_ = std::make_unique<drivers::Site>(surroundings, port);
  site_->data_flow().pass_to(publisher);
  return *site_;
}

Result<std::uint16_t> DeviceServer::listen(std::uint16_t port) {
  Result<std::uint16_t> opened = server_->listen(port);
  if (opened) ports_.push_back(*opened);
  return opened;
}

Result<std::uint16_t> DeviceServer::listen(const config::CfgFile& file, std::uint16_t port,
                                           const std::string& option) {
  return open_ports(ports_of(file, port), port, option,
                    [this](std::uint16_t wanted) { return listen(wanted); });
}

Result<void> DeviceServer::make_drivers(const drivers::Registry& registry, const config::CfgFile& file,
                                        const std::function<void(const std::string&)>& warn) {
  Result<std::vector<std::unique_ptr<device::Driver>>> made = registry.make(file, *site_);
  for (const std::string& warning : site_->warnings()) warn(warning);
  if (!made) return made.error();
  drivers_ = std::move(*made);
  catch_signals();
  return {};
}

void DeviceServer::catch_signals() {
  if (std::exchange(catches_, true)) return;
  on_ending_signals(loop_, [this](int signal) {
    if (ending_) std::_Exit(128 + signal);  // second signal: at once
    end(128 + signal);
  });
}

int DeviceServer::run() {
  catch_signals();
  loop_.run();
  return code_;
}

void DeviceServer::end(int code) {
  if (std::exchange(ending_, true)) return;
  code_ = code;
  loop_.post([this] { server_->finish([this] { loop_.finish(); }); });
}

Result<std::uint16_t> open_ports(const std::set<std::uint16_t>& ports, std::uint16_t default_port,
                                 const std::string& option,
                                 const std::function<Result<std::uint16_t>(std::uint16_t)>& listen) {
  std::uint16_t opened = default_port;
  for (const std::uint16_t port : ports) {
    const Result<std::uint16_t> listening = listen(port == 0 ? default_port : port);
    if (!listening) return port_error(listening.error(), port == 0, option);
    if (port == 0) opened = *listening;
  }
  return opened;
}

std::set<std::uint16_t> ports_of(const config::CfgFile& file, std::uint16_t default_port) {
  std::set<std::uint16_t> ports;
  for (const config::CfgSection& section : file.drivers) {
    for (const config::DeviceAddress& address : section.addresses("provides"))
      ports.insert(address.port.value_or(0));
  }
  if (default_port != 0 && ports.contains(0)) ports.erase(default_port);  // named as well: one port
  return ports;
}

Error port_error(const Error& error, bool is_default, const std::string& port_option) {
  return {error.where, error.text + (is_default ? "; " + port_option + " takes another port"
                                                : "; the configuration file names this port")};
}

}  // namespace playhouse::device_server
