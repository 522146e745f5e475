#pragma once

/// DeviceServer: serves devices of drivers, without a world. Single-threaded.

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/device_server/server_host.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/drivers/site.h"
#include "playhouse/libraries/libraries.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/server/server.h"

namespace playhouse::device_server {

class DeviceServer final : private ServerHost {
 public:
  /// `libraries`: those that plug-ins may come from.
  explicit DeviceServer(server::ServerOptions options, libraries::Libraries libraries = {});
  ~DeviceServer() override;

  server::Server& server() { return *server_; }
  const server::Server& server() const { return *server_; }
  net::IoLoop& loop() { return loop_; }
  /// For Player clients.
  const std::vector<std::uint16_t>& ports() const { return ports_; }

  /// Opens a port for Player clients (0: any free one).
  Result<std::uint16_t> listen(std::uint16_t port);
  /// Opens the ports of a file, `port` for addresses without one, and returns that; `option` is the name of its option,
  /// for errors.
  Result<std::uint16_t> listen(const config::CfgFile& file, std::uint16_t port, const std::string& option);
  /// Makes the site; `port` is the default port of addresses, and data go to `publisher`. Call once, before any driver.
  drivers::Site& open_site(std::uint16_t port, device::Publisher& publisher);
  /// Makes the drivers of a configuration file, in the site. `warn` gets the site's warnings.
  Result<void> make_drivers(const drivers::Registry& registry, const config::CfgFile& file,
                            const std::function<void(const std::string&)>& warn);
  /// Adds a driver; its devices may be added while it runs.
  void take(std::unique_ptr<device::Driver> driver) { drivers_.push_back(std::move(driver)); }

  /// Runs until a signal or end(). Returns the exit code.
  int run();
  /// Flushes the clients' queues, then run() returns. Any time in run(), or before it.
  void end(int code);
  /// Ends what drivers have begun. Done at the end, too.
  void close();

 private:
  /// The first signal ends run(), the second the program. Once there are drivers, as making them may take long, and by run().
  void catch_signals();
  server::Server& the_server() override { return *server_; }
  net::Network& the_network() override { return loop_; }
  libraries::Libraries libraries() const override { return libraries_; }

  // In order of construction: later members use earlier ones.
  libraries::Libraries libraries_;
  net::IoLoop loop_;
  std::unique_ptr<drivers::Site> site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
  std::unique_ptr<server::Server> server_;
  std::vector<std::uint16_t> ports_;
  bool ending_ = false, closed_ = false, catches_ = false;
  int code_ = 0;
};

/// The ports of a configuration file, each once; 0 stands for the default port.
std::set<std::uint16_t> ports_of(const config::CfgFile& file, std::uint16_t default_port);

/// Opens these by listen(port), 0 as the default one, and returns that as it was opened; `option` is the name of its
/// option, for errors.
Result<std::uint16_t> open_ports(const std::set<std::uint16_t>& ports, std::uint16_t default_port,
                                 const std::string& option,
                                 const std::function<Result<std::uint16_t>(std::uint16_t)>& listen);

/// Error message for a port that cannot be opened.
Error port_error(const Error& error, bool is_default, const std::string& port_option);

}  // namespace playhouse::device_server
