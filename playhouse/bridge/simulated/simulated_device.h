#pragma once

/// SimulatedDevice: one model exposed as one Player device. A subclass per interface defines
/// its messages and their encoding. Constant replies (geometry, configuration) are encoded
/// at construction and sent at once; what needs the world is posted to the tick thread.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/bridge/simulated/sources.h"
#include "playhouse/device/driver.h"
#include "playhouse/run/simulation.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

/// A message type that a device handles.
struct Served {
  wire::MessageType type;
  std::uint8_t subtype;
};

/// The value of a named property of a device.
using SettingValue = std::variant<bool, std::int32_t, double, std::string>;

class SimulatedDevice : public DataSource, public std::enable_shared_from_this<SimulatedDevice> {
 public:
  /// `model` is watched while the device is open, and used from a client's first command on: whoever reads
  /// draws no power and changes nothing. None for a device of the whole world.
  SimulatedDevice(run::Simulation& simulation, world::ModelId model)
      : simulation_(simulation), model_(model) {}
  SimulatedDevice(const SimulatedDevice&) = delete;
  SimulatedDevice& operator=(const SimulatedDevice&) = delete;

  world::ModelId model() const { return model_; }
  /// The robot whose commands must stay in order with open and close; none for sensors.
  virtual world::ModelId robot() const { return {}; }
  void set_id(device::DeviceId id) { id_ = id; }
  /// Tick thread: the device was opened, closed.
  void begin(world::Journal& journal) {
    watch_.watch(journal, simulation_.requests(), model_);
    opened(journal);
  }
  /// Once after each open, at is_first_act().
  void use(world::Journal& journal) { use_.begin(journal, simulation_.requests(), model_); }
  void end(world::Journal& journal) {
    use_.end(journal, simulation_.requests());
    if (watch_.end(journal, simulation_.requests())) closed(journal);
    ended(journal);
  }

  // Any thread. Only messages in served() are passed.
  virtual std::span<const Served> served() const = 0;
  bool serves(std::uint8_t type, std::uint8_t subtype) const {
    return std::ranges::any_of(served(), [=](const Served& each) {
      return static_cast<std::uint8_t>(each.type) == type && each.subtype == subtype;
    });
  }
  virtual device::Taken command(const device::Message& message) {
    return static_cast<void>(message), device::Taken::kNo;
  }
  virtual void request(const device::Message& message, device::Replier replier) = 0;
  /// True if a request uses the model, as a command does.
  virtual bool acts(std::uint8_t request) const { return static_cast<void>(request), false; }
  /// False if commands change nothing of the model but its looks, so that they do not use it.
  virtual bool commands_act() const { return true; }
  /// True once after each open: the first command or acting request.
  bool is_first_act() { return !has_acted_.exchange(true); }
  void forget_acts() { has_acted_ = false; }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    static_cast<void>(world), static_cast<void>(out);
  }
  /// Called on the tick thread after the first open.
  virtual void opened(world::Journal& journal) { static_cast<void>(journal); }
  /// Called on the tick thread after the last close, if the model still exists.
  virtual void closed(world::Journal& journal) { static_cast<void>(journal); }
  /// Called on the tick thread after the last close, even if the model is gone.
  virtual void ended(world::Journal& journal) { static_cast<void>(journal); }

  /// Tick thread: what clients can set by name (settings/settings.h); none, false if there is no such setting, or
  /// not of that type, or not with that value.
  virtual std::optional<SettingValue> setting(std::string_view name) const {
    return static_cast<void>(name), std::nullopt;
  }
  virtual bool set_setting(std::string_view name, const SettingValue& value) {
    return static_cast<void>(name), static_cast<void>(value), false;
  }

  /// Answers a request on the tick thread; returns the body of the ACK, or none for NACK.
  using JournalAnswer = std::function<std::optional<Bytes>(world::Journal&)>;
  void answer_by(device::Replier replier, JournalAnswer answer) const {
    auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
    simulation_.requests().post(
        [shared, answer = std::move(answer)](world::Journal& journal) {
          if (std::optional<Bytes> body = answer(journal)) {
            shared->ack(std::move(*body));
          } else {
            shared->nack();
          }
        },
        robot());
  }

 protected:
  run::Simulation& simulation() const { return simulation_; }

  /// The same for a request that only reads the world.
  using Question = std::function<std::optional<Bytes>(const world::World&)>;
  void ask_world(device::Replier replier, Question question) const {
    answer_by(std::move(replier), [question = std::move(question)](world::Journal& journal) {
      return question(journal.world());
    });
  }

  /// An empty ACK if the change can be, else NACK.
  void change_world(device::Replier replier, world::Change change) const {
    answer_by(std::move(replier), [change = std::move(change)](world::Journal& journal) {
      return journal.apply(change) ? std::optional(Bytes()) : std::nullopt;
    });
  }

  /// Appends one DATA message of this device, stamped with the world's time.
  template <typename T>
  void publish(const world::World& world, std::uint8_t subtype, const T& value,
               std::vector<device::Publication>& out) const {
    out.push_back({id_, subtype, world.time(), wire::encode(value)});
  }

 private:
  run::Simulation& simulation_;
  world::ModelId model_;
  device::DeviceId id_;
  std::atomic<bool> has_acted_ = false;  // since it was opened
  world::Use watch_, use_;
};

}  // namespace playhouse::drivers
