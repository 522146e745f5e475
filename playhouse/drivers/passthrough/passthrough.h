#pragma once

/// Passthrough: proxies for devices of another Player server.
/// Commands and requests are forwarded; data, replies and NACKs come
/// back byte for byte. A remote device is open while its proxy is.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/passthrough/remote_server.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"

namespace playhouse::drivers {

class Passthrough final : public device::Driver, private RemoteServer::RemoteServerEvents {
 public:
  /// What happens to the devices when the connection is lost. Until the server was
  /// reached for the first time they stay: it may be started later than this program.
  enum class AfterLoss : std::uint8_t {
    kRetire,   // they retire
    kConnect,  // they stay, closed until reconnected
  };

  /// `site` must outlive it, as must the task queue of its surroundings.
  Passthrough(Site& site, std::string host, std::uint16_t port, AfterLoss after_loss);

  /// Adds a proxy for a device of the server. Io thread, once it runs.
  Result<void> add(device::Address address, RemoteDevice device);
  /// Starts connecting. Io thread, once it runs.
  void connect() { remote_.connect(); }

  /// Callbacks for users of the server other than the devices. Before connect().
  struct Watcher {
    std::function<void()> connected;
    std::function<void(const std::string& why)> lost;
    std::function<void(RemoteDevice)> retired;  // a device of the server has retired, and its proxy
  };
  void watch(Watcher watcher) { watcher_ = std::move(watcher); }
  /// Io thread.
  RemoteServer& remote() { return remote_; }

  std::string_view name() const override { return "passthrough"; }
  /// Fails without a connection, and then tries to make one at once.
  Result<void> start(device::DeviceId id) override;
  void stop(device::DeviceId id) override;
  void forget(device::DeviceId id) override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const override;
  bool asks_for_capabilities() const override { return true; }

 private:
  void connected() override;
  void lost(const std::string& why) override;
  void data(RemoteDevice device, const wire::Header& header, std::span<const std::byte> body) override;
  void caught_up() override;
  void refused(RemoteDevice device) override;
  void gone(RemoteDevice device) override;

  struct Relayed {
    device::Address address;  // of the proxy
    RemoteDevice there;
  };
  std::optional<RemoteDevice> there(device::DeviceId id) const;  // any thread
  /// Sends a request that comes back here if the device leads back to its own proxy, as where
  /// two passthroughs stand for each other: whatever is sent there would go round for ever.
  void look_for_circle(RemoteDevice device);
  void end_circle(RemoteDevice device);
  void connect_later();

  Site& site_;
  const AfterLoss after_loss_;
  const std::uint32_t mark_;  // of own requests of look_for_circle()
  RemoteServer remote_;
  Watcher watcher_;
  std::unique_ptr<net::Timer> retry_;
  double wait_ = 0;  // s until the next attempt (back-off)
  std::string why_lost_ = "is not connected yet";
  std::set<device::DeviceId> wanted_;  // open proxies
  std::map<RemoteDevice, device::DeviceId> here_;
  std::set<RemoteDevice> told_;  // malformed data was logged for these
  std::vector<device::Publication> batch_;

  mutable std::mutex mutex_;  // guards what follows
  std::map<device::DeviceId, Relayed> relayed_;
};

/// From a configuration section: `requires` lists devices of one other server, `provides`
/// as many here, in the same order; `reconnect` 1 keeps them when the connection is lost.
Result<std::unique_ptr<device::Driver>> make_passthrough(const scene::CfgSection& section, Site& site);

/// For devices that drivers of the file require of other servers on this machine
/// (Site::take_remote_devices()): one for each port. They reconnect.
Result<std::vector<std::unique_ptr<device::Driver>>> make_remote_devices(Site& site);

}  // namespace playhouse::drivers
