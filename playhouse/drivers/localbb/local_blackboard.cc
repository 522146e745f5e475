#include "playhouse/drivers/localbb/local_blackboard.h"

#include <fmt/format.h>

#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/blackboard.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

namespace blackboard = wire::blackboard;

std::uint32_t serial_of(const device::Caller* caller) {
  return caller == nullptr ? device::kDrivers : caller->serial();
}

}  // namespace

bool LocalBlackboard::capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const {
  return type == static_cast<std::uint8_t>(wire::MessageType::kReq) &&
         subtype >= blackboard::kReqSubscribeToKey && subtype <= blackboard::kReqGetEntry;
}

void LocalBlackboard::request(const device::Message& message, device::Replier replier) {
  if (message.caller != nullptr)
    return carry_out(message.subtype, message.body, message.caller, std::move(replier));
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
  site_.surroundings().post(
      [this, shared, subtype = message.subtype, body = Bytes(message.body.begin(), message.body.end())] {
        carry_out(subtype, body, nullptr, std::move(*shared));
      });
}

void LocalBlackboard::carry_out(std::uint8_t subtype, std::span<const std::byte> body, device::Caller* caller,
                                device::Replier replier) {
  Result<Entry> entry = wire::decode<Entry>(body);
  if (!entry) return;
  const EntryPlace place{wire::text(entry->group), wire::text(entry->key)};
  if (!keeps_limits(place, *entry)) return;
  const auto& [group, key] = place;
  switch (subtype) {
    case blackboard::kReqSubscribeToKey:
      if (subscribe({group, key}, caller)) replier.ack(wire::encode(entry_at(place)));
      return;
    case blackboard::kReqUnsubscribeFromKey:
      unsubscribe({group, key}, serial_of(caller));
      return replier.ack();
    case blackboard::kReqSetEntry:
      if (!set(place, std::move(*entry))) return;
      replier.ack();
      return publish(place);
    case blackboard::kReqSubscribeToGroup:
      if (!subscribe({group, std::nullopt}, caller)) return;
      replier.ack();
      return publish_group(group, serial_of(caller));
    case blackboard::kReqUnsubscribeFromGroup:
      unsubscribe({group, std::nullopt}, serial_of(caller));
      return replier.ack();
    case blackboard::kReqGetEntry:
      return replier.ack(wire::encode(entry_at(place)));
    default:
      return;
  }
}

bool LocalBlackboard::keeps_limits(const EntryPlace& place, const Entry& entry) {
  const std::size_t names = place.first.size() + place.second.size();
  if (names > limits::kBlackboardNameBytes) {
    log_once(fmt::format("key and group of an entry have {} bytes at most", limits::kBlackboardNameBytes));
    return false;
  }
  if (names + entry.data.size() > limits::kBlackboardEntryBytes) {
    log_once(fmt::format("an entry has {} bytes at most", limits::kBlackboardEntryBytes));
    return false;
  }
  return true;
}

/// False if there is no room.
bool LocalBlackboard::set(const EntryPlace& place, Entry entry) {
  const auto found = entries_.find(place);
  if (found == entries_.end() && entries_.size() >= limits::kBlackboardEntries) {
    log_once(fmt::format("a blackboard has {} entries at most", limits::kBlackboardEntries));
    return false;
  }
  entry.group = wire::c_string(place.first);
  entry.key = wire::c_string(place.second);
  if (entry.timestamp_sec == 0 && entry.timestamp_usec == 0) {
    const auto now = static_cast<std::uint64_t>(std::llround(site_.time() * 1e6));
    entry.timestamp_sec = static_cast<std::uint32_t>(now / 1000000);
    entry.timestamp_usec = static_cast<std::uint32_t>(now % 1000000);
  }
  entries_.insert_or_assign(found, place, std::move(entry));
  return true;
}

/// Without a value if there is none.
LocalBlackboard::Entry LocalBlackboard::entry_at(const EntryPlace& place) const {
  if (const auto found = entries_.find(place); found != entries_.end()) return found->second;
  Entry none;
  none.group = wire::c_string(place.first);
  none.key = wire::c_string(place.second);
  return none;
}

bool LocalBlackboard::subscribe(const Topic& topic, device::Caller* caller) {
  const std::uint32_t client = serial_of(caller);
  std::set<Topic>& topics = topics_of_[client];
  if (!topics.contains(topic) && topics.size() >= limits::kBlackboardSubscriptions) {
    log_once(fmt::format("a client has {} subscriptions at most", limits::kBlackboardSubscriptions));
    return false;
  }
  topics.insert(topic);
  clients_of_[topic].insert(client);
  if (caller != nullptr) caller->when_gone_once(this, [this, client] { leave(client); });
  return true;
}

void LocalBlackboard::unsubscribe(const Topic& topic, std::uint32_t client) {
  const auto clients = clients_of_.find(topic);
  if (clients == clients_of_.end() || clients->second.erase(client) == 0) return;
  if (clients->second.empty()) clients_of_.erase(clients);
  const auto topics = topics_of_.find(client);
  topics->second.erase(topic);
  if (topics->second.empty()) topics_of_.erase(topics);
}

void LocalBlackboard::leave(std::uint32_t client) {
  const auto found = topics_of_.find(client);
  if (found == topics_of_.end()) return;
  const std::set<Topic> topics = found->second;
  for (const Topic& topic : topics) unsubscribe(topic, client);
}

/// An entry, to who subscribed to its key or its group.
void LocalBlackboard::publish(const EntryPlace& place) const {
  std::set<std::uint32_t> clients;
  for (const Topic& topic : {Topic{place.first, place.second}, Topic{place.first, std::nullopt}})
    if (const auto found = clients_of_.find(topic); found != clients_of_.end())
      clients.insert(found->second.begin(), found->second.end());
  if (clients.empty()) return;
  site_.data_flow().publish({{device_,
                              blackboard::kDataUpdate,
                              site_.time(),
                              wire::encode(entries_.at(place)),
                              {clients.begin(), clients.end()}}});
}

void LocalBlackboard::publish_group(const std::string& group, std::uint32_t client) const {
  std::vector<device::Publication> batch;
  const double time = site_.time();
  for (auto at = entries_.lower_bound({group, ""}); at != entries_.end() && at->first.first == group; ++at)
    batch.push_back({device_, blackboard::kDataUpdate, time, wire::encode(at->second), {client}});
  site_.data_flow().publish(std::move(batch));
}

void LocalBlackboard::log_once(std::string_view why) {
  if (logged_.emplace(why).second) log::warn("localbb: {}; answered NACK", why);
}

namespace {

constexpr DeviceText kLocalBlackboardProvides[] = {{"blackboard"}};

}  // namespace

constinit const DriverDefinition kLocalBlackboardDriver{
    .name = "localbb",
    .doc = "A blackboard: values by key and group that clients of the server share.",
    .provides = kLocalBlackboardProvides,
    .make = make_local_blackboard,
};

Result<std::unique_ptr<device::Driver>> make_local_blackboard(const config::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"blackboard"});
  if (!provided) return provided.error();
  auto driver = std::make_unique<LocalBlackboard>(site);
  const Result<device::DeviceId> id = site.add_device(provided->front(), *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_device(*id);
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
