#pragma once

/// HardwareDriver: what drivers of hardware at the end of a line have in common. It has those of the devices it offers that
/// the section names, opens the line with the first of them and closes it with the last, has commands and requests come on
/// the io thread, in order, and says in one line what is wrong with the line. Without `reconnect` the devices retire with
/// the line; with it they wait for it. Devices are numbered as they are offered.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/line.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/drivers/site.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {

/// Options of every driver of hardware.
struct HardwareOptions {
  LinePlace place;
  bool reconnects = false;
  double watchdog = 0;  // s; 0: none
};

/// Reads `reconnect`, and `watchdog` of what moves.
HardwareOptions read_hardware_options(SectionFields& fields, LinePlace place, bool moves);

class HardwareDriver : public device::Driver, private LineEvents {
 public:
  HardwareDriver(std::string name, Site& site, HardwareOptions options);
  ~HardwareDriver() override;

  /// Registers those of `offered` that the section names.
  Result<void> register_devices(const config::CfgSection& section, std::span<const DeviceText> offered);

  // device::Driver

  std::string_view name() const final { return name_; }
  Result<void> start(device::DeviceId device) final;
  void stop(device::DeviceId device) final;
  device::Taken command(const device::Message& message) final;
  void request(const device::Message& message, device::Replier replier) final;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const final;
  void barrier(device::Replier replier) final;
  void finish() final;

 protected:
  // In constructors. A command or request that is not registered is refused, and so is a body that is no T.

  template <typename T>
  void on_command(std::size_t device, std::uint8_t subtype, std::function<void(const T&)> take) {
    commands_[{device, subtype}] = [take = std::move(take)](const CommandBody& body) {
      if (const Result<T> value = wire::decode<T>(body)) take(*value);
    };
  }
  /// One without a body.
  void on_bare_command(std::size_t device, std::uint8_t subtype, std::function<void()> take) {
    commands_[{device, subtype}] = [take = std::move(take)](const CommandBody&) { take(); };
  }
  /// Answered by a body; none: NACK.
  template <typename T>
  void on_request(std::size_t device, std::uint8_t subtype, std::function<AnswerBody(const T&)> answer) {
    requests_[{device, subtype}] = [answer = std::move(answer)](const CommandBody& body) -> AnswerBody {
      const Result<T> value = wire::decode<T>(body);
      return value ? answer(*value) : std::nullopt;
    };
  }
  void on_question(std::size_t device, std::uint8_t subtype, std::function<AnswerBody()> answer) {
    requests_[{device, subtype}] = [answer = std::move(answer)](const CommandBody&) { return answer(); };
  }
  /// The answer of a request that was carried out and has nothing to tell.
  static AnswerBody done() { return std::vector<std::byte>(); }

  // Io thread.

  bool is_open(std::size_t device) const { return device < devices_.size() && devices_[device].open > 0; }
  /// To the clients of a device, if it has any.
  template <typename T>
  void publish(std::size_t device, std::uint8_t subtype, const T& value) {
    if (is_open(device)) publish_body(device, subtype, wire::encode(value));
  }
  HardwareLine& line() { return line_; }
  Site& site() { return site_; }
  void send(std::span<const std::byte> bytes) { line_.send(bytes); }
  /// A serial port, which has a speed; a bridge by TCP keeps its own.
  bool is_serial() const { return !options_.place.path.empty(); }
  /// The line has another speed from now on. False: it cannot, and the driver has given up.
  bool set_baud(int baud);
  int baud() const { return baud_; }
  [[nodiscard]] std::unique_ptr<net::Timer> after(double seconds, std::function<void()> task);
  /// Of the network's clock, which begins at no certain time. [s]
  double now() const { return site_.surroundings().network().now(); }
  /// Lines of the log, of this section.
  void inform(const std::string& text) const;
  void warn(const std::string& text) const;
  /// The hardware does not answer as it should: as if the line were lost.
  void give_up(const std::string& why);
  /// The wheels have got a command: they stop if none follows within `watchdog`.
  void feed_watchdog();

  /// True for hardware that has to be spoken to first: until started() requests wait, and of each command the latest.
  virtual bool starts_up() const { return false; }
  /// The start-up is over.
  void started();
  bool has_clients() const { return open_ > 0; }

  /// The line is open: it begins to talk.
  virtual void began() = 0;
  virtual void received(std::span<const std::byte> bytes) = 0;
  /// A device was opened by its first client, or closed by its last; the line may be closed.
  virtual void opened(std::size_t) {}
  virtual void closed(std::size_t) {}
  /// The last device was closed, or the program ends: it sends what stops the hardware. Then the line is closed.
  virtual void ending() = 0;
  /// The line is lost: it starts anew with began(), if at all.
  virtual void forgot() = 0;
  /// Nobody has commanded for `watchdog` seconds.
  virtual void stop_wheels() {}

 private:
  using CommandBody = std::vector<std::byte>;
  using DeviceKey = std::pair<std::size_t, std::uint8_t>;  // device and subtype
  struct OfferedDevice {
    std::optional<device::Address> address;
    device::DeviceId id;
    int open = 0;
  };

  void line_opened() override;
  void line_received(std::span<const std::byte> bytes) override;
  void line_lost(const std::string& why) override;
  void retry();
  void close_line();
  void forget_start();
  void retire_all();
  std::size_t number_of(device::DeviceId device) const;
  std::weak_ptr<device::Replier> keep(device::Replier replier);
  std::shared_ptr<device::Replier> take(const std::weak_ptr<device::Replier>& kept);
  void publish_body(std::size_t device, std::uint8_t subtype, CommandBody body);

  const std::string name_;
  Site& site_;
  const HardwareOptions options_;
  std::vector<OfferedDevice> devices_;
  // Not changed after the constructor.
  std::map<DeviceKey, std::function<void(const CommandBody&)>> commands_;
  std::map<DeviceKey, std::function<AnswerBody(const CommandBody&)>> requests_;

  std::mutex mutex_;                                  // guards asked_
  std::set<std::shared_ptr<device::Replier>> asked_;  // not carried out yet

  int open_ = 0;
  bool is_ready_ = false;  // for commands and requests
  std::map<DeviceKey, CommandBody> waiting_commands_;
  std::vector<std::function<void()>> waiting_requests_;
  std::string told_;  // why the line is lost, in the log
  double wait_ = 0;   // s until the next attempt
  HardwareLine line_;
  int baud_ = 0;  // of the line, while it is open
  std::unique_ptr<net::Timer> retry_, watchdog_;
  const std::shared_ptr<int> alive_ = std::make_shared<int>(0);  // last member: what is posted ends with it
};

/// The driver of a section: D, made from its name and options, with those of `offered` that it names.
template <typename D, typename ReadOptions>
Result<std::unique_ptr<device::Driver>> make_hardware(const config::CfgSection& section, Site& site,
                                                      ReadOptions read_options,
                                                      std::span<const DeviceText> offered) {
  SectionFields fields(section);
  const auto options = read_options(fields);  // by reference: it has its fault
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  auto driver = std::make_unique<D>(section.name(), site, options);
  if (const Result<void> registered = driver->register_devices(section, offered); !registered)
    return registered.error();
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
