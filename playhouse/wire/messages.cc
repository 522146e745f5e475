#include "playhouse/wire/messages.h"

#include <algorithm>
#include <utility>

namespace playhouse::wire {

namespace {

constexpr std::uint8_t kFirstUniversal = 247;

const MessageDef* find_row(std::span<const MessageDef> rows, MessageType type, std::uint8_t subtype) {
  const auto key = std::pair(type, subtype);
  const auto found = std::lower_bound(
      rows.begin(), rows.end(), key,
      [](const MessageDef& row, const auto& wanted) { return std::pair(row.type, row.subtype) < wanted; });
  if (found == rows.end() || found->type != type || found->subtype != subtype) return nullptr;
  return &*found;
}

}  // namespace

const MessageDef* find_message(std::uint16_t interf, MessageType type, std::uint8_t subtype) {
  if (type == MessageType::kAck || type == MessageType::kNack) type = MessageType::kReq;
  if (type == MessageType::kReq && subtype >= kFirstUniversal)
    return find_row(universal_messages(), type, subtype);
  const InterfaceDef* interface = find_interface(interf);
  return interface ? find_row(interface->messages, type, subtype) : nullptr;
}

const InterfaceDef* find_interface(std::uint16_t code) {
  const auto all = interfaces();
  const auto found =
      std::lower_bound(all.begin(), all.end(), code,
                       [](const InterfaceDef& def, std::uint16_t wanted) { return def.code < wanted; });
  return found != all.end() && found->code == code ? &*found : nullptr;
}

const InterfaceDef* find_interface(std::string_view name) {
  const auto all = interfaces();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const InterfaceDef& def) { return def.name == name; });
  return found != all.end() ? &*found : nullptr;
}

}  // namespace playhouse::wire
