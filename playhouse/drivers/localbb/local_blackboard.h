#pragma once

/// The .cfg driver "localbb": a blackboard, named values that clients share. An entry is the value of a key in
/// a group; who subscribes to the key or the group gets each new value.
///
/// In: requests of interface blackboard. Out: answers, and UPDATE to those alone who subscribed. Entries last
/// as long as the program: no part of a run, so a rewind or reset leaves them.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
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
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_local_blackboard(const config::CfgSection& section, Site& site);

extern const DriverDefinition kLocalBlackboardDriver;

class LocalBlackboard final : public device::Driver {
 public:
  explicit LocalBlackboard(Site& site) : site_(site) {}

  void set_device(device::DeviceId device) { device_ = device; }

  std::string_view name() const override { return "localbb"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  /// Any thread. Requests of drivers are carried out on the io thread, in their order.
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const override;

 private:
  using Entry = wire::BlackboardEntry;
  /// Of an entry: its group, and its key.
  using EntryPlace = std::pair<std::string, std::string>;
  /// What is subscribed to: a key of a group, or the whole group.
  using Topic = std::pair<std::string, std::optional<std::string>>;

  // Io thread.
  void carry_out(std::uint8_t subtype, std::span<const std::byte> body, device::Caller* caller,
                 device::Replier replier);
  bool keeps_limits(const EntryPlace& place, const Entry& entry);
  bool set(const EntryPlace& place, Entry entry);
  Entry entry_at(const EntryPlace& place) const;
  bool subscribe(const Topic& topic, device::Caller* caller);
  void unsubscribe(const Topic& topic, std::uint32_t client);
  void leave(std::uint32_t client);
  void publish(const EntryPlace& place) const;
  void publish_group(const std::string& group, std::uint32_t client) const;
  void log_once(std::string_view why);

  Site& site_;
  device::DeviceId device_;
  std::map<EntryPlace, Entry> entries_;
  std::map<Topic, std::set<std::uint32_t>> clients_of_;  // by their serial numbers
  std::map<std::uint32_t, std::set<Topic>> topics_of_;   // the same the other way round
  std::set<std::string, std::less<>> logged_;
};

}  // namespace playhouse::drivers
