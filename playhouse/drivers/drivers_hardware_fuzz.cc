/// Hardware at the far end of a line that says anything, and a host that does: a driver and the emulator of its hardware, whose
/// lines are joined, so that they get on with each other, while bytes of others come between. Clients open, command and ask.
/// What comes out is what the catalogue of messages says, and each request is answered once. The first byte says which driver.

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/config/cfg.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/net/simulated.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

/// One end of a line, whose bytes go out at an end of another.
class JoinedEnd final : private net::SerialEvents {
 public:
  void open(Result<std::unique_ptr<net::SerialLine>> line, JoinedEnd& other) {
    if (!line) return;
    line_ = std::move(*line);
    other_ = &other;
    line_->start(*this);
  }
  void send(std::span<const std::byte> bytes) {
    if (line_ != nullptr) line_->send(bytes);
  }
  void set(const net::SerialSettings& settings) {
    if (line_ != nullptr) static_cast<void>(line_->set(settings));
  }

 private:
  void received(std::span<const std::byte> bytes) override { other_->send(bytes); }
  void ended(const std::string&) override {}

  std::unique_ptr<net::SerialLine> line_;
  JoinedEnd* other_ = nullptr;
};

/// What the emulator uses.
class Robot final : public device::Driver {
 public:
  std::string_view name() const override { return "robot"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message& message) override {
    return check(message), device::Taken::kLatest;
  }
  void request(const device::Message& message, device::Replier replier) override {
    check(message);
    replier.ack();
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return true; }
  void add(device::DeviceId id, std::uint16_t interf) { interfaces_[id.row] = interf; }

 private:
  void check(const device::Message& message) const {
    const auto* known = wire::find_message(interfaces_.at(message.device.row),
                                           static_cast<MessageType>(message.type), message.subtype);
    PLAYHOUSE_ASSERT(known != nullptr && known->check(message.body).empty());
  }
  std::map<std::uint32_t, std::uint16_t> interfaces_;
};

class Bench final : public Host, public device::Outlet, public device::Publisher {
 public:
  explicit Bench(const DriverDefinition& hardware, const DriverDefinition& emulator) {
    site_.data_flow().pass_to(*this);
    std::string used, provided;
    for (const DeviceText& device : emulator.uses) used += name_of(device, 0, &robot_);
    for (const DeviceText& device : hardware.provides) provided += name_of(device, 1, nullptr);
    build("driver( name \"" + std::string(emulator.name) + "\" port \"/dev/emulated\" requires [" + used +
          "] )\n" + "driver( name \"" + std::string(hardware.name) + "\" port \"/dev/joined\" provides [" +
          provided + "] reconnect 1 )\n");
    host_.open(network_.open_serial("/dev/emulated", {}), far_end_);
  }
  ~Bench() override {
    for (const std::uint32_t row : std::set(open_)) stop(row);
    for (const auto& driver : drivers_) driver->finish();
  }

  void step(FuzzScript& script) {
    const std::uint8_t what = script.byte();
    switch (what % 8) {
      case 0:
        return open_or_close(script.byte());
      case 1:
        return network_.run_for(0.05 * (1 + what / 8));
      case 2:
        return far_end_.send(script.take(script.byte()));
      case 3:
        return host_.send(script.take(script.byte()));
      case 4: {
        const net::SerialSettings settings{.baud = 9600 << what / 64};
        host_.set(settings);
        return far_end_.set(settings);
      }
      case 5:
        return say(script, MessageType::kCmd);
      case 6:
        return say(script, MessageType::kReq);
      default:
        return measure(script);
    }
  }

  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) override {
    devices_.push_back({address.interf, &driver});
    return device::DeviceId{static_cast<std::uint32_t>(devices_.size() - 1)};
  }
  void retire_device(device::DeviceId) override {}
  void post(std::function<void()> task) override { network_.post(std::move(task)); }
  net::Network& network() override { return network_; }
  Result<void> hold(device::DeviceId, device::Driver*) override { return {}; }
  void release(device::DeviceId, device::Driver*) override {}
  bool has_threads() const override { return false; }

  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override {
    const auto asked = asked_.extract(ticket);
    PLAYHOUSE_ASSERT(!asked.empty());
    if (ack) PLAYHOUSE_ASSERT(asked.mapped()->check(body).empty());
  }
  void publish(std::vector<device::Publication> batch) override {
    for (const device::Publication& data : batch) {
      const auto* message =
          wire::find_message(devices_[data.device.row].interf, MessageType::kData, data.subtype);
      PLAYHOUSE_ASSERT(message != nullptr && message->check(data.body).empty());
    }
  }

 private:
  struct FuzzedDevice {
    std::uint16_t interf = 0;
    device::Driver* driver = nullptr;
  };

  /// Its place in a section; registered if `driver` has it.
  std::string name_of(const DeviceText& device, std::uint16_t first, Robot* driver) {
    const std::uint16_t interf = wire::find_interface(device.interf)->code;
    const auto index = static_cast<std::uint16_t>(first + 10 * count_[{interf, first}]++);
    if (driver != nullptr) driver->add(*site_.add_device({6665, interf, index}, *driver), interf);
    const std::string key = device.key.empty() ? "" : std::string(device.key) + ":::";
    return " \"" + key + std::string(device.interf) + ":" + std::to_string(index) + "\"";
  }
  void build(const std::string& text) {
    config::MemoryFiles none({});
    const Result<config::CfgFile> file = config::load_cfg_text(text, "fuzz.cfg", none);
    PLAYHOUSE_ASSERT(file.ok());
    const auto core = core_drivers();
    far_end_.open(network_.open_terminal("/dev/joined", {}), host_);
    auto made = Registry({core.begin(), core.end()}, {}).make(*file, site_);
    PLAYHOUSE_ASSERT(made.ok());
    drivers_ = std::move(*made);
    network_.run();
  }
  bool is_hardware(std::size_t row) const { return devices_[row].driver != &robot_; }
  std::uint32_t row_of(FuzzScript& script) const {
    return static_cast<std::uint32_t>(script.byte() % devices_.size());
  }
  void open_or_close(std::uint8_t which) {
    const auto row = static_cast<std::uint32_t>(which % devices_.size());
    if (!is_hardware(row)) return;
    if (open_.contains(row)) return stop(row);
    if (devices_[row].driver->start({row})) open_.insert(row);
  }
  void stop(std::uint32_t row) {
    open_.erase(row);
    devices_[row].driver->stop({row});
  }
  /// To the hardware; a session lets no other bodies through.
  void say(FuzzScript& script, MessageType type) {
    const std::uint32_t row = row_of(script);
    const std::uint8_t subtype = script.byte();
    const auto body = script.take(script.byte());
    const wire::MessageDef* const message = wire::find_message(devices_[row].interf, type, subtype);
    if (!is_hardware(row) || message == nullptr || !message->check(body).empty()) return;
    const device::Message said{{row}, static_cast<std::uint8_t>(type), subtype, body};
    if (type == MessageType::kCmd) return static_cast<void>(devices_[row].driver->command(said));
    asked_[++tickets_] = message;
    devices_[row].driver->request(said, {*this, tickets_});
  }
  /// Data of the robot.
  void measure(FuzzScript& script) {
    const std::uint32_t row = row_of(script);
    const std::uint8_t subtype = script.byte();
    const auto body = script.take(script.byte());
    const wire::MessageDef* const message =
        wire::find_message(devices_[row].interf, MessageType::kData, subtype);
    if (is_hardware(row) || message == nullptr || !message->check(body).empty()) return;
    site_.data_flow().publish({{{row}, subtype, network_.now(), {body.begin(), body.end()}}});
  }

  net::SimulatedNetwork network_{1};
  JoinedEnd far_end_, host_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> count_;
  std::vector<FuzzedDevice> devices_;  // by the device's row
  std::set<std::uint32_t> open_;
  std::map<std::uint64_t, const wire::MessageDef*> asked_;  // requests that are not answered
  std::uint64_t tickets_ = 0;
  Robot robot_;
  Site site_{*this, 6665};
  std::vector<std::unique_ptr<device::Driver>> drivers_;
};

/// A driver and its emulator.
std::vector<std::pair<const DriverDefinition*, const DriverDefinition*>> emulated() {
  std::vector<std::pair<const DriverDefinition*, const DriverDefinition*>> pairs;
  for (const DriverDefinition* const emulator : core_drivers())
    for (const DriverDefinition* const hardware : core_drivers())
      if (emulator->name == std::string(hardware->name) + "_emulator") pairs.emplace_back(hardware, emulator);
  return pairs;
}

}  // namespace
}  // namespace playhouse::drivers

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::FuzzScript script(std::as_bytes(std::span(data, size)));
  static const auto kPairs = playhouse::drivers::emulated();
  const auto& [hardware, emulator] = kPairs[script.byte() % kPairs.size()];
  playhouse::drivers::Bench bench(*hardware, *emulator);
  for (int step = 0; step < 64 && !script.done(); ++step) bench.step(script);
  return 0;
}
