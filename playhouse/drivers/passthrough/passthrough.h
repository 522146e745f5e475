#pragma once

/// Passthrough: proxies for devices of another Player server.
/// Commands and requests are forwarded; data, replies and NACKs come
/// back byte for byte. A remote device is open while its proxy is,
/// and the server is connected while one of its devices is in use.
/// Which server and which device that are is changed by properties of
/// the proxy: "remote_host", "remote_port", "remote_index", "connect",
/// which a section may have as fields, too.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/passthrough/remote_server.h"
#include "playhouse/drivers/site.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::drivers {

class Passthrough final : public device::Driver, private RemoteServer::RemoteServerEvents {
 public:
  /// What happens to the devices when the connection is lost while one of them is open.
  enum class AfterLoss : std::uint8_t {
    kRetire,   // they retire
    kConnect,  // they stay; those that are open here are opened again
  };

  /// `site` must outlive it, as must the task queue of its surroundings.
  Passthrough(Site& site, std::string host, std::uint16_t port, AfterLoss after_loss);

  /// Adds a proxy for a device of the server. Io thread, once it runs.
  Result<void> add(device::Address address, RemoteDevice device);
  /// Connects to nobody until a client sets the property "connect". Before the program runs.
  void start_disconnected() { is_cut_ = true; }
  /// Starts connecting, for a user of the server other than the devices: it stays connected. Io thread, once it
  /// runs.
  void connect();

  /// Callbacks for such a user. Before connect().
  struct Watcher {
    std::function<void()> connected;
    std::function<void(const std::string& why)> lost;
    std::function<void(RemoteDevice)> retired;  // a device of the server has retired, and its proxy
  };
  void watch(Watcher watcher) { watcher_ = std::move(watcher); }
  /// Io thread.
  RemoteServer& remote() { return remote_; }

  /// "passthrough (lab:6665)"
  std::string_view name() const override { return name_; }
  bool ready(device::DeviceId id) const override;
  /// Connects if need be, and opens the device there.
  void prepare(device::DeviceId id, Prepared heard) override;
  Result<void> start(device::DeviceId id) override;
  void stop(device::DeviceId id) override;
  void forget(device::DeviceId id) override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const override;
  bool asks_for_capabilities() const override { return true; }
  void finish() override;

 private:
  /// A device of the server. Io thread.
  struct Proxy {
    /// Whether it leads back to itself, as where two passthroughs stand for each other: whatever is sent there
    /// would go round for ever.
    enum class Way : std::uint8_t { kUnknown, kAsked, kFree, kCircle };
    enum class There : std::uint8_t { kClosed, kAsked, kOpen };

    bool is_open() const { return there == There::kOpen && way == Way::kFree; }
    bool is_idle() const { return !is_wanted && openers.empty(); }

    device::DeviceId here;
    device::Address address;
    Way way = Way::kUnknown;
    There there = There::kClosed;
    bool is_wanted = false;                // open here
    std::vector<Prepared> openers;         // wait for it to be open
    std::unique_ptr<net::Timer> patience;  // of these
    std::unique_ptr<net::Timer> circle;    // it led in a circle a moment ago
    std::string told;                      // why it was not opened last, in the log
  };
  using Proxies = std::map<RemoteDevice, Proxy>;

  void connected() override;
  void lost(const std::string& why) override;
  void data(RemoteDevice device, const wire::Header& header, std::span<const std::byte> body) override;
  void caught_up() override;
  void opened(RemoteDevice device, RemoteServer::RemoteOpening opening) override;
  void gone(RemoteDevice device) override;

  std::optional<RemoteDevice> there(device::DeviceId id) const;  // any thread
  /// True if it is not to connect.
  bool is_over() const { return is_cut_ || (stays_connected_ && !remote_.is_connected()); }
  void when_open(RemoteDevice device, Prepared then);
  void when_reached(RemoteDevice device, Prepared then);
  void when_connected(Prepared then);
  void wait_at(RemoteDevice device, Proxy& proxy);
  void advance(RemoteDevice device, Proxy& proxy);
  void advance_all();
  void look_for_circle(RemoteDevice device, Proxy& proxy);
  void pass_look_on(RemoteDevice device, wire::CapabilitiesReq look, device::Replier replier);
  void meet_circle(RemoteDevice device, Proxy& proxy);
  static void settle(Proxy& proxy);
  static void refuse(Proxy& proxy, const std::string& why);
  std::string why_silent() const;
  std::string why_closed(RemoteDevice device, RemoteServer::RemoteOpening opening) const;
  void close_if_idle(RemoteDevice device, Proxy& proxy);
  void forget_server();
  void retire_all();
  void try_later();
  std::optional<Bytes> answer_property(RemoteDevice device, std::uint8_t subtype, const Bytes& body);
  std::optional<Bytes> answer_host(wire::StrpropReq asked, bool sets);
  std::optional<Bytes> answer_number(RemoteDevice device, wire::IntpropReq asked, bool sets);
  bool move_proxy(RemoteDevice from, std::uint16_t index);
  void move_to(const std::string& host, std::uint16_t port);
  void set_connected(bool connects);
  void disconnect();
  void tidy_later();
  void tidy();

  Site& site_;
  std::string name_;
  const AfterLoss after_loss_;
  const std::uint32_t mark_;  // of own requests of look_for_circle()
  RemoteServer remote_;
  Watcher watcher_;
  bool stays_connected_ = false, is_cut_ = false;  // by connect(); by the property "connect"
  std::unique_ptr<net::Timer> retry_, tidy_;
  double wait_ = 0;  // s until the next attempt (back-off)
  std::string why_lost_;
  Proxies proxies_;
  std::vector<Prepared> callers_;  // wait for the connection
  std::size_t under_way_ = 0;      // requests that are not answered
  std::set<RemoteDevice> told_;    // malformed data was logged for these
  std::vector<device::Publication> batch_;

  mutable std::mutex mutex_;  // guards what follows
  std::map<device::DeviceId, RemoteDevice> relayed_;
};

/// From a configuration section: `requires` lists devices of one other server, `provides`
/// as many here, in the same order; with `reconnect` 0 they retire when the connection is lost.
Result<std::unique_ptr<device::Driver>> make_passthrough(const config::CfgSection& section, Site& site);

extern const DriverDefinition kPassthroughDriver;

/// For devices that drivers of the file require of other servers on this machine
/// (Site::take_remote_devices()): one for each port.
Result<std::vector<std::unique_ptr<device::Driver>>> make_remote_devices(Site& site);

}  // namespace playhouse::drivers
