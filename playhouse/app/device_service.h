#pragma once

/// DeviceService: serves devices of drivers, and their
/// page, without a world. Single-threaded.

#include <atomic>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "playhouse/app/commands/options.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device_server/device_server.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/record/device_recorder.h"
#include "playhouse/record/record_thread.h"
#include "playhouse/server/server.h"
#include "playhouse/web_server/device_page.h"

namespace playhouse::app {

class DeviceService {
 public:
  /// `allowed`: files of libraries that plug-ins may come from.
  explicit DeviceService(Serving serving, std::span<const std::string> allowed = {});
  ~DeviceService();

  /// Opens a port for Player clients (0: any free one).
  Result<std::uint16_t> listen(std::uint16_t port) { return devices_.listen(port); }
  /// Opens the ports of a file, and returns that of addresses without one.
  Result<std::uint16_t> listen(const config::CfgFile& file) {
    return devices_.listen(file, serving_.port, serving_.port_option);
  }
  /// Makes the drivers of a configuration file, in the site.
  Result<void> make_drivers(const config::CfgFile& file);
  /// Adds a driver; its devices may be added while it runs.
  void take(std::unique_ptr<device::Driver> driver) { devices_.take(std::move(driver)); }
  /// Makes the site; `port` is the default port of addresses. Call once, before any driver.
  drivers::Site& open_site(std::uint16_t port) { return devices_.open_site(port, tap_); }

  /// Reads the guest file. Fails if it is invalid or admits nobody.
  Result<void> read_guests();
  /// As that of Service; before listen().
  Result<void> read_tls();
  /// Starts the page of the devices, if enabled; `player_port` is for clients that name none.
  Result<void> open_page(std::uint16_t player_port);
  /// Records the data of all devices from now on, which opens them for reading. Fails if the file is not writable.
  Result<void> record(const std::string& file);
  /// Of ports, page and guests, one line each.
  std::vector<std::string> places() const;

  /// For timers.
  net::IoLoop& loop() { return devices_.loop(); }
  /// For Player clients.
  const std::vector<std::uint16_t>& ports() const { return devices_.ports(); }

  /// Runs until a signal or end(). Returns the exit code.
  int run();
  /// Flushes the clients' queues, then run() returns. Any time in run(), or before it.
  void end(int code) { devices_.end(code); }

 private:
  std::string status_text(const server::Guest& guest) const;
  /// Opens devices that have come since, and those that could not be opened before.
  void open_recorded();
  void end_recording();

  /// Publishes to the recorder, once there is one, which passes on to the server. Any thread.
  class Tap final : public device::Publisher {
   public:
    explicit Tap(server::Server& server) : server_(server) {}
    void record(record::DeviceRecorder& recorder) { recorder_ = &recorder; }
    void publish(std::vector<device::Publication> batch) override { next().publish(std::move(batch)); }
    void forget() override { next().forget(); }

   private:
    device::Publisher& next() {
      record::DeviceRecorder* const recorder = recorder_;
      return recorder != nullptr ? static_cast<device::Publisher&>(*recorder) : server_;
    }
    server::Server& server_;
    std::atomic<record::DeviceRecorder*> recorder_ = nullptr;
  };

  // In order of construction: later members use earlier ones.
  const Serving serving_;
  device_server::DeviceServer devices_;
  Tap tap_{devices_.server()};
  std::string recording_;  // file; empty: none
  std::unique_ptr<record::RecordThread> record_file_;
  std::unique_ptr<record::DeviceRecorder> recorder_;
  std::set<device::DeviceId> recorded_;                    // opened for the recording, or being opened
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);  // for devices that are being opened
  std::unique_ptr<net::Timer> look_;                       // for devices
  server::GuestBook guests_;
  std::unique_ptr<web_server::DevicePage> page_;
  std::uint16_t web_port_ = 0;
};

/// True if a section of the file simulates a world.
bool has_world(const config::CfgFile& file);

/// Serves the devices of a configuration file without a world. `opened` is
/// called with the ports once clients can connect. Returns the exit code.
int serve_devices(const config::CfgFile& file, const Serving& serving, const Running& running,
                  const std::function<void(const std::vector<std::uint16_t>&)>& opened = {});

/// Of the server of Player clients. Logs fewer sessions than usual.
server::ServerOptions server_options(const Serving& serving);

/// The address for clients to use: `bind`, or for a wildcard
/// the first address of this machine reachable from outside.
std::string shown_host(const std::string& bind);

}  // namespace playhouse::app
