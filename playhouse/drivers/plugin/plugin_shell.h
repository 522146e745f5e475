#pragma once

/// PluginShell: the driver around a Plugin, of this process or of one of its own. It has its devices, uses those that
/// the section requires while one of its own is open, and calls the hooks on a PluginThread. Whoever opens a device
/// waits for the plug-in's open() (prepare()), which may fail and be tried again. Once the plug-in has failed, its
/// devices retire.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/isolated/isolated_plugin.h"
#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/drivers/plugin/plugin_messages.h"
#include "playhouse/drivers/plugin/plugin_thread.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// What a plug-in calls, until it is shut: a thread that was left behind calls it as well.
class PluginDoor;

class PluginShell final : public device::Driver {
 public:
  /// `library` keeps the code of `plugin` loaded. No plug-in where no code is to be loaded: its devices are there
  /// and do nothing.
  PluginShell(const config::CfgSection& section, Site& site, std::shared_ptr<void> library,
              std::unique_ptr<Plugin> plugin);
  ~PluginShell() override;

  /// Configures the plug-in and registers its devices. Fails with "file:line".
  Result<void> begin(const config::CfgSection& section);

  // device::Driver

  std::string_view name() const override { return name_; }
  bool ready(device::DeviceId) const override {
    return plugin_ == nullptr || (phase_ == Phase::kOpen && !has_failed_);
  }
  void prepare(device::DeviceId, Prepared heard) override;
  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  void retired(device::DeviceId) override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override;
  void finish() override;

 private:
  friend class PluginDoor;
  /// Data of a device that it uses.
  struct Datum {
    using Take = std::function<void(std::span<const std::byte>, double)>;
    Datum(device::Subscription& subscription, const Take& hook) : latest(subscription), take(hook) {}
    device::Subscription& latest;
    const Take& take;
    std::atomic<bool> is_posted = false;  // a hook for it waits
  };
  /// Of the plug-in, as the io thread knows it. kOpening, kClosing: the hook has not come back.
  enum class Phase : std::uint8_t { kClosed, kOpening, kOpen, kClosing };
  Result<void> configure(const config::CfgSection& section);
  std::size_t number_of(device::DeviceId device) const;
  void open();
  void opened(const Result<void>& outcome);
  void tell(const Result<void>& outcome);
  bool is_in_use() const { return phase_ == Phase::kOpen || phase_ == Phase::kOpening; }
  void close();
  void closed();
  void take_news();
  void look();
  void step();
  void failed(const std::string& why);
  void warn_once(const std::string& line);

  const std::string name_;
  const std::string where_;  // "file:line" of the section
  Site& site_;
  std::vector<PluginDevice> own_, others_;  // of `provides` and `requires`
  const std::shared_ptr<void> library_;     // outlives the plug-in
  const std::shared_ptr<Plugin> plugin_;
  IsolatedPlugin* const isolated_;  // the plug-in, if it is one in a process of its own
  const std::shared_ptr<PluginDoor> door_;
  device::DeviceClient client_;
  std::vector<device::Address> provides_;
  std::vector<device::DeviceId> ids_;
  std::deque<Datum> data_;
  int open_ = 0;                               // own devices; io thread
  std::atomic<Phase> phase_ = Phase::kClosed;  // written by the io thread
  std::vector<Prepared> callers_;              // of prepare(), while it is under way; io thread
  ToldLines told_;
  std::atomic<bool> is_connected_ = false;  // its client, with what it requires
  std::atomic<bool> has_failed_ = false;
  std::atomic<bool> step_waits_ = false;
  std::unique_ptr<net::Timer> look_timer_, step_timer_, unused_timer_;  // io thread
  PluginThread thread_;  // last member: it ends before what hooks use
};

/// The driver of a section, from this library.
Result<std::unique_ptr<device::Driver>> make_plugin(const config::CfgSection& section,
                                                    const config::PluginField& plugin, Site& site);
/// Whether its library can be found.
bool plugin_is_there(const config::PluginField& plugin, Site& site);

}  // namespace playhouse::drivers
