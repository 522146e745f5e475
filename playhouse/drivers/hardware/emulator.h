#pragma once

/// Emulator: what stands at the far end of a line in place of hardware, and speaks its protocol for devices of this server:
/// any program that drives the hardware drives a simulated robot, or another's. It provides no device. At `port` of its
/// section it makes a pseudo-terminal that other programs open as a serial port, at `tcp_port` it listens, for one at a time.
/// Devices are numbered as they may be used; it opens those that its section requires as soon as they can be opened.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/offered.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/network.h"

namespace playhouse::drivers {

/// Where others find it.
struct EmulatorPlace {
  std::string link = {};       // of a pseudo-terminal; empty: TCP
  std::uint16_t tcp_port = 0;  // of this machine
  net::SerialSettings serial;  // of the hardware
  bool at_any_speed = false;   // as by USB, where a speed means nothing
};

/// Reads `port` and `tcp_port`: one of them is needed.
EmulatorPlace read_emulator_place(SectionFields& fields, const net::SerialSettings& serial);

class Emulator : public device::Driver, private net::SerialEvents, private net::ConnectionEvents {
 public:
  /// Those of the devices that it may use; none: the section requires no such.
  using UsedDevices = std::vector<std::optional<device::Address>>;

  Emulator(std::string name, Site& site, EmulatorPlace place, UsedDevices used);
  ~Emulator() override;

  /// Opens the line. Its devices are opened once all drivers of the file exist.
  Result<void> begin(const config::CfgSection& section);

  // device::Driver

  std::string_view name() const final { return name_; }
  Result<void> start(device::DeviceId) final { return {}; }
  void stop(device::DeviceId) final {}
  device::Taken command(const device::Message&) final { return device::Taken::kNo; }
  void request(const device::Message&, device::Replier) final {}
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const final { return false; }
  void finish() final;
  void retired(device::DeviceId) final;

 protected:
  /// The latest data of a device that may be used. In constructors.
  template <typename T>
  class Latest {
   public:
    Latest(Emulator& emulator, std::size_t device, std::uint8_t subtype)
        : subscription_(emulator.uses(device) ? &emulator.client_.latest(*emulator.numbers_[device], subtype)
                                              : nullptr) {}
    /// The value that came last; T{} before the first one.
    const T& value() {
      if (subscription_ == nullptr) return value_;
      if (const std::optional<device::Publication> news = subscription_->take_latest())
        if (Result<T> read = wire::decode<T>(news->body)) value_ = std::move(*read);
      return value_;
    }

   private:
    device::Subscription* subscription_;  // null: of no device
    T value_{};
  };

  // Io thread.

  /// True if the section names it.
  bool uses(std::size_t device) const { return numbers_[device].has_value(); }
  /// False: the device cannot be commanded yet.
  template <typename T>
  bool command_device(std::size_t device, std::uint8_t subtype, const T& value) {
    return uses(device) &&
           client_.command(*numbers_[device], subtype, wire::encode(value)) != device::Taken::kNo;
  }
  void bare_command(std::size_t device, std::uint8_t subtype) {
    if (uses(device)) static_cast<void>(client_.command(*numbers_[device], subtype, {}));
  }
  template <typename T>
  void ask_device(std::size_t device, std::uint8_t subtype, const T& value) {
    if (uses(device)) client_.ask(*numbers_[device], subtype, wire::encode(value), [](const AnswerBody&) {});
  }
  void send(std::span<const std::byte> bytes);
  [[nodiscard]] std::unique_ptr<net::Timer> after(double seconds, std::function<void()> task);
  /// True if whoever opened the line set it as the hardware needs it; always by TCP.
  bool speaks_as_set() const;
  /// The hardware speaks otherwise from now on, as after a command that changes its speed.
  void speak(const net::SerialSettings& serial);
  const EmulatorPlace& place() const { return place_; }
  /// s, of a steady clock.
  double now() const;

  /// Of bytes of the host, at the right speed.
  virtual void line_received(std::span<const std::byte> bytes) = 0;
  /// Nothing has come for so long that no frame goes on: what is not complete is to be forgotten, but for lines of letters,
  /// which a person may type.
  virtual void line_paused() {}
  /// A host has connected by TCP, or the program ends: what it moves stops, and all is as at the beginning.
  virtual void reset() {}

 private:
  void received(std::span<const std::byte> bytes) override;
  void ended(const std::string& why) override;
  void drained() override {}
  void lost() override {}  // closed() follows
  void closed(const std::string& why) override;
  Result<void> open_line();
  void open_devices();
  void try_later(const std::string& why);

  const std::string name_;
  Site& site_;
  const EmulatorPlace place_;
  net::SerialSettings serial_;  // of the hardware now
  std::vector<device::Address> addresses_;
  std::vector<std::optional<std::size_t>> numbers_;  // of client_, for those that may be used
  device::DeviceClient client_;
  std::string told_;  // why its devices are not open, in the log
  double wait_ = 0;   // s until the next attempt
  std::unique_ptr<net::SerialLine> terminal_;
  std::unique_ptr<net::Listener> listener_;
  std::unique_ptr<net::Connection> host_;
  double heard_ = 0;  // s, the last bytes
  std::unique_ptr<net::Timer> retry_;
  const std::shared_ptr<int> alive_ = std::make_shared<int>(0);  // last member: what is posted ends with it
};

/// The emulator of a section: E, made from its name and options, with those of `uses` that it requires.
template <typename E, typename ReadOptions>
Result<std::unique_ptr<device::Driver>> make_emulator(const config::CfgSection& section, Site& site,
                                                      ReadOptions read_options,
                                                      std::span<const DeviceText> uses) {
  SectionFields fields(section);
  const auto options = read_options(fields);  // by reference: it has its fault
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  const auto used = offered_devices(section, site, "requires", uses);
  if (!used) return used.error();
  auto emulator = std::make_unique<E>(section.name(), site, options, *used);
  if (const Result<void> begun = emulator->begin(section); !begun) return begun.error();
  return std::unique_ptr<device::Driver>(std::move(emulator));
}

}  // namespace playhouse::drivers
