#pragma once

/// DeviceService: serves devices of drivers
/// without a world. Single-threaded.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/server_host.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/server/server.h"

namespace playhouse::app {

class DeviceService final : private ServerHost {
 public:
  /// `allowed`: files of libraries that plug-ins may come from.
  explicit DeviceService(const std::string& bind, std::span<const std::string> allowed = {});
  ~DeviceService() override;

  /// Opens a port for Player clients (0: any free one).
  Result<std::uint16_t> listen(std::uint16_t port) { return server_->listen(port); }
  /// Makes the drivers of a configuration file, in the site.
  Result<void> make_drivers(const scene::CfgFile& file);
  /// Adds a driver; its devices may be added while it runs.
  void take(std::unique_ptr<device::Driver> driver) { drivers_.push_back(std::move(driver)); }
  /// Makes the site; `port` is the default port of addresses. Call once, before any driver.
  drivers::Site& open_site(std::uint16_t port);

  /// For timers.
  net::IoLoop& loop() { return loop_; }

  /// Runs until a signal or end(). Returns the exit code.
  int run();
  /// Flushes the clients' queues, then run() returns. Any time in run(), or before it.
  void end(int code);

 private:
  server::Server& the_server() override { return *server_; }
  net::Network& the_network() override { return loop_; }
  Result<std::unique_ptr<run::Simulation>> open_world(const std::string& path) override;
  libraries::Libraries libraries() const override { return libraries_; }

  // In order of construction: later members use earlier ones.
  libraries::Libraries libraries_;
  net::IoLoop loop_;
  std::unique_ptr<drivers::Site> site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
  std::unique_ptr<server::Server> server_;
  bool ending_ = false;
  int code_ = 0;
};

/// True if a section of the file simulates a world.
bool has_world(const scene::CfgFile& file);

/// Serves the devices of a configuration file without a world. `opened` is
/// called with the ports once clients can connect. Returns the exit code.
int serve_devices(const scene::CfgFile& file, const Serving& serving, const Running& running,
                  const std::function<void(const std::vector<std::uint16_t>&)>& opened = {});

/// The address for clients to use: `bind`, or for a wildcard
/// the first address of this machine reachable from outside.
std::string shown_host(const std::string& bind);

/// The ports of a configuration file, each once; 0 stands for the default port.
std::set<std::uint16_t> ports_of(const scene::CfgFile& file, std::uint16_t default_port);

/// Error message for a port that cannot be opened.
Error port_error(const Error& error, bool is_default, const std::string& port_option);

}  // namespace playhouse::app
