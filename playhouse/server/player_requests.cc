// Requests to the server itself: the meta device player:0.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/server/session.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::server {
namespace {

namespace player = wire::player;

constexpr std::string_view kLostProperty = "lost";  // data messages lost for this client
constexpr std::string_view kGroupProperty =
    "multicast";  // a string: where data go by multicast; an integer: whether this client reads them there

// Access codes before version 3, letters as for files; sent as numbers.
constexpr std::uint8_t kReadLetter = 'r', kWriteLetter = 'w', kAllLetter = 'a', kCloseLetter = 'c';
constexpr std::uint8_t kError = player::kErrorMode;

/// None if the code asks for no access.
std::optional<Access> access_asked(std::uint8_t code) {
  switch (code) {
    case player::kOpenMode:
    case kAllLetter:
      return Access::kAll;
    case kReadLetter:
      return Access::kRead;
    case kWriteLetter:
      return Access::kWrite;
    default:
      return std::nullopt;
  }
}

QueueAction queue_action(std::int32_t code) {
  switch (code) {
    case player::kMsgReplaceRuleReplace:
      return QueueAction::kReplace;
    case player::kMsgReplaceRuleIgnore:
      return QueueAction::kIgnore;
    default:
      return QueueAction::kAccept;
  }
}

}  // namespace

void Session::player_message(const wire::Header& header, MessageBody body) {
  // Even commands get a reply here, for compatibility.
  if (header.type != wire::MessageType::kReq)
    return refuse(header, Fault::kNotForServer, "only requests go there");
  if (header.subtype == player::kReqAuth) return authenticate(header, body);
  const bool is_own = header.subtype == player::kReqDatamode;  // concerns this connection alone
  if (!is_own && !caller_.rights().reads) return refuse(header, Fault::kRights, why_not_admitted());
  switch (header.subtype) {
    case player::kReqDevlist:
      return list_devices(header);
    case player::kReqDriverinfo:
      return tell_driver(header, body);
    case player::kReqDev:
      return open_or_close(header, body);
    case player::kReqData:
      queue_.request_data(make_reply(header, true, {}));
      return mark_due();
    case player::kReqDatamode:
      return set_data_mode(header, body);
    case player::kReqAddReplaceRule:
      return add_replace_rule(header, body);
    case wire::kReqGetIntprop:
      return tell_lost(header, body);
    case wire::kReqGetStrprop:
      return tell_group(header, body);
    case wire::kReqSetIntprop:
      return read_group(header, body);
    default:
      return refuse(header, Fault::kUnknownMessage, "no such request");
  }
}

/// Without access control there is nothing to authenticate for: NACK, as in the original.
void Session::authenticate(const wire::Header& header, MessageBody body) {
  const auto asked = wire::decode<player::DeviceAuthReq>(body);
  if (!asked) return refuse(header, Fault::kUndecodable, asked.error().text);
  if (!board_.admit)
    return refuse(header, Fault::kUnknownMessage, "this run admits everybody, without a token");
  const std::string_view key(reinterpret_cast<const char*>(asked->auth_key.data()), asked->auth_key.size());
  std::string token(wire::text(key));
  const std::optional<device::Rights> rights = board_.admit(token, peer_);
  if (!rights) return refuse(header, Fault::kRights, "not a guest of this run");
  token_ = std::move(token);
  caller_.set_rights(*rights);
  caller_.set_holder(net::holder_of(token_, peer_));
  reply(header, true);
}

void Session::list_devices(const wire::Header& header) {
  const auto [known, first] = board_.device_lists.try_emplace(robot_);
  if (first) {
    player::DeviceDevlist list;
    const std::span<const device::DeviceId> devices = board_.devices.devices_of(robot_);
    for (const device::DeviceId id : devices.first(std::min(devices.size(), limits::kDevices))) {
      const device::Address address = board_.devices[id].address;
      list.devices.push_back({wire::kLocalhost, robot_, address.interf, address.index});
    }
    known->second = wire::encode(list);
  }
  reply(header, true, known->second);
}

void Session::tell_driver(const wire::Header& header, MessageBody body) {
  const auto asked = wire::decode<player::DeviceDriverinfo>(body);
  if (!asked) return refuse(header, Fault::kUndecodable, asked.error().text);
  const device::Address address{robot_, asked->addr.interf, asked->addr.index};
  const device::DeviceId device = board_.devices.find(address);
  if (!device.valid()) {
    return refuse(header, Fault::kUnknownDevice,
                  device::describe(address) + ": " + board_.devices.why_missing(address));
  }
  player::DeviceDriverinfo answer;
  answer.addr = {wire::kLocalhost, robot_, asked->addr.interf, asked->addr.index};
  answer.driver_name = wire::c_string(board_.devices[device].driver->name());
  reply(header, true, wire::encode(answer));
}

void Session::open_or_close(const wire::Header& header, MessageBody body) {
  const auto asked = wire::decode<player::DeviceReq>(body);
  if (!asked) return refuse(header, Fault::kUndecodable, asked.error().text);

  const device::Address address{robot_, asked->addr.interf, asked->addr.index};
  const device::DeviceId device = board_.devices.find(address);
  if (!device.valid()) {
    ++board_.counters.requests_refused;
    log_once(Fault::kUnknownDevice, "open of " + device::describe(address),
             board_.devices.why_missing(address) + "; answered NACK");
    return tell_access(header, address, kError);
  }
  if (asked->access == player::kCloseMode || asked->access == kCloseLetter)
    return tell_access(header, address, close(device) ? asked->access : kError);
  const std::optional<Access> access = access_asked(asked->access);
  if (!access) return tell_access(header, address, kError);
  if (!board_.devices[device].driver->ready(device)) return prepare(header, device, asked->access);
  tell_access(header, address, open(device, *access, asked->access));
}

/// Has its driver get what the device needs; until then the client's next messages to it wait.
void Session::prepare(const wire::Header& header, device::DeviceId device, std::uint8_t code) {
  const device::DeviceTable::ServedDevice& served = board_.devices[device];
  const std::uint32_t number = next_request_++;
  const std::uint64_t ticket = make_ticket(serial_, number);
  opening_[number] = {served.address, code};
  pending_[number] = {header, device};
  pending_bytes_ += header.size;
  queue_.set_awaited(true);
  board_.uses.ask(device, ticket);
  served.driver->prepare(device, [outlet = board_.outlet, ticket](const Result<void>& outcome) {
    const std::string why = outcome ? std::string() : outcome.error().line();
    const auto bytes = std::as_bytes(std::span(why));
    outlet->answer(ticket, outcome.ok(), {bytes.begin(), bytes.end()});
  });
}

void Session::prepared(const wire::Header& header, const Opening& opening, bool ack, MessageBody why) {
  const device::DeviceId device = board_.devices.find(opening.address);
  std::uint8_t access = kError;
  if (ack && device.valid()) {
    access = open(device, *access_asked(opening.code), opening.code);
  } else if (!why.empty()) {
    log_once(
        Fault::kStart, "open of " + device::describe(opening.address),
        "the device cannot start: " + std::string(reinterpret_cast<const char*>(why.data()), why.size()));
  }
  tell_access(header, opening.address, access);
}

/// Answers an open or a close: NACK if there is no such device.
void Session::tell_access(const wire::Header& header, device::Address address, std::uint8_t access) {
  player::DeviceReq answer;
  answer.addr = {wire::kLocalhost, robot_, address.interf, address.index};
  answer.access = access;
  const device::DeviceId device = board_.devices.find(address);
  if (device.valid()) answer.driver_name = wire::c_string(board_.devices[device].driver->name());
  reply(header, device.valid(), wire::encode(answer));
}

// Returns the access code for the reply: the requested one, or that of an error.
std::uint8_t Session::open(device::DeviceId device, Access access, std::uint8_t code) {
  const device::Address address = board_.devices[device].address;
  auto found = open_.find(device);
  if (found == open_.end()) {
    if (open_.size() + queue_.notices_waiting() >= limits::kSubscriptions) {
      log_once(Fault::kLimit, "open of " + device::describe(address),
               fmt::format("{} devices are open, or have retired and the client has not read so: the limit",
                           open_.size() + queue_.notices_waiting()));
      return kError;
    }
    if (const Result<void> started = board_.devices.open(device); !started) {
      log_once(Fault::kStart, "open of " + device::describe(address),
               "the device cannot start: " + started.error().line());
      return kError;
    }
    if (board_.devices[device].users == 1) take_credit(device);
    found = open_.try_emplace(device).first;
    board_.uses.open(device, serial_);
    queue_.replace_device(address.interf, address.index);
  }
  found->second.access = access;
  ++found->second.opens;
  if (access == Access::kWrite) {
    board_.fanout.leave(device, *this);
    queue_.forget(address.interf, address.index);
  } else {
    board_.fanout.join(device, *this);
  }
  return code;
}

// False if this session does not have the device open; without effect on others.
bool Session::close(device::DeviceId device) {
  const auto found = open_.find(device);
  if (found == open_.end()) return false;
  if (--found->second.opens > 0) return true;
  const device::Address address = board_.devices[device].address;
  open_.erase(found);
  board_.fanout.leave(device, *this);
  board_.uses.close(device, serial_);
  queue_.forget(address.interf, address.index);
  board_.devices.close(device);
  if (board_.devices[device].users == 0) take_credit(device);
  return true;
}

/// In PULL mode SYNCH OVERFLOW reports losses; in PUSH mode old clients would take that for an error.
void Session::tell_lost(const wire::Header& header, MessageBody body) {
  auto asked = wire::decode<wire::IntpropReq>(body);
  if (!asked || wire::text(asked->key) != kLostProperty)
    return refuse(header, Fault::kUnknownMessage, "no such property");
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  asked->value = static_cast<std::int32_t>(std::min(kMost, queue_.dropped()));
  reply(header, true, wire::encode(*asked));
}

void Session::tell_group(const wire::Header& header, MessageBody body) {
  auto asked = wire::decode<wire::StrpropReq>(body);
  if (!asked || wire::text(asked->key) != kGroupProperty || board_.group_place.empty())
    return refuse(header, Fault::kUnknownMessage, "no such property");
  asked->value = wire::c_string(board_.group_place);
  reply(header, true, wire::encode(*asked));
}

/// Of all devices that the client has open and opens. What is queued comes by the connection.
void Session::read_group(const wire::Header& header, MessageBody body) {
  const auto asked = wire::decode<wire::IntpropReq>(body);
  if (!asked || wire::text(asked->key) != kGroupProperty)
    return refuse(header, Fault::kUnknownMessage, "no such property");
  if (asked->value != 0 && board_.group_place.empty())
    return refuse(header, Fault::kUnsupported, "this server sends nothing by multicast");
  reads_group_ = asked->value != 0;
  reply(header, true);
}

void Session::set_data_mode(const wire::Header& header, MessageBody body) {
  const auto asked = wire::decode<player::DeviceDatamodeReq>(body);
  if (!asked) return refuse(header, Fault::kUndecodable, asked.error().text);
  if (asked->mode == player::kDatamodePush) queue_.set_mode(DeliveryMode::kPush);
  if (asked->mode == player::kDatamodePull) queue_.set_mode(DeliveryMode::kPull);
  reply(header, true);  // unknown modes are acknowledged too, without effect
}

void Session::add_replace_rule(const wire::Header& header, MessageBody body) {
  const auto asked = wire::decode<player::AddReplaceRuleReq>(body);
  if (!asked) return refuse(header, Fault::kUndecodable, asked.error().text);
  if (!queue_.add_rule(
          {asked->interf, asked->index, asked->type, asked->subtype, queue_action(asked->replace)})) {
    return refuse(header, Fault::kLimit, "too many replace rules");
  }
  reply(header, true);
}

}  // namespace playhouse::server
