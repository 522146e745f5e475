#include "playhouse/device/properties.h"

#include <utility>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/header.h"

namespace playhouse::device {
namespace {

template <typename Request>
void put_value(Request& request, const auto& value) {
  using Wire = decltype(request.value);
  if constexpr (std::is_same_v<Wire, std::string>) {
    request.value = wire::c_string(value);
  } else {
    request.value = static_cast<Wire>(value);
  }
}

template <typename T, typename Request>
T taken_value(const Request& request) {
  if constexpr (std::is_same_v<T, std::string>) {
    return std::string(wire::text(request.value));
  } else {
    return static_cast<T>(request.value);
  }
}

}  // namespace

void PropertyBag::declare(std::string key, PropertyValue value, PropertyAccess access) {
  const std::scoped_lock lock(mutex_);
  const bool added = properties_.emplace(std::move(key), Property{std::move(value), access}).second;
  PLAYHOUSE_ASSERT(added);
}

std::optional<PropertyValue> PropertyBag::get(const std::string& key) const {
  const std::scoped_lock lock(mutex_);
  const auto found = properties_.find(key);
  return found == properties_.end() ? std::nullopt : std::optional(found->second.value);
}

Result<void> PropertyBag::set(const std::string& key, PropertyValue value) {
  const std::scoped_lock lock(mutex_);
  const auto found = properties_.find(key);
  if (found == properties_.end()) return Error{key, "no such property"};
  if (found->second.value.index() != value.index()) return Error{key, "the property has another type"};
  found->second.value = std::move(value);
  return {};
}

bool PropertyBag::is_property_request(const Message& message) {
  return message.type == static_cast<std::uint8_t>(wire::MessageType::kReq) &&
         message.subtype >= wire::kReqSetBoolprop && message.subtype <= wire::kReqGetIntprop;
}

void PropertyBag::request(const Message& message, Replier replier) {
  switch (message.subtype) {
    case wire::kReqGetIntprop:
      return serve_get<wire::IntpropReq, std::int32_t>(message, replier);
    case wire::kReqSetIntprop:
      return serve_set<wire::IntpropReq, std::int32_t>(message, replier);
    case wire::kReqGetDblprop:
      return serve_get<wire::DblpropReq, double>(message, replier);
    case wire::kReqSetDblprop:
      return serve_set<wire::DblpropReq, double>(message, replier);
    case wire::kReqGetStrprop:
      return serve_get<wire::StrpropReq, std::string>(message, replier);
    case wire::kReqSetStrprop:
      return serve_set<wire::StrpropReq, std::string>(message, replier);
    case wire::kReqGetBoolprop:
      return serve_get<wire::BoolpropReq, bool>(message, replier);
    case wire::kReqSetBoolprop:
      return serve_set<wire::BoolpropReq, bool>(message, replier);
    default:
      return replier.nack();
  }
}

template <typename Request, typename T>
void PropertyBag::serve_get(const Message& message, Replier& replier) const {
  Result<Request> request = wire::decode<Request>(message.body);
  if (!request) return replier.nack();
  const std::optional<PropertyValue> value = get(std::string(wire::text(request->key)));
  if (!value || !std::holds_alternative<T>(*value)) return replier.nack();
  put_value(*request, std::get<T>(*value));
  replier.ack(wire::encode(*request));
}

template <typename Request, typename T>
void PropertyBag::serve_set(const Message& message, Replier& replier) {
  const Result<Request> request = wire::decode<Request>(message.body);
  if (!request) return replier.nack();
  const std::string key(wire::text(request->key));
  if (!change(key, taken_value<T>(*request))) return replier.nack();
  replier.ack();
}

bool PropertyBag::change(const std::string& key, PropertyValue value) {
  const std::scoped_lock lock(mutex_);
  const auto found = properties_.find(key);
  if (found == properties_.end() || found->second.access == PropertyAccess::kReadOnly) return false;
  if (found->second.value.index() != value.index()) return false;
  found->second.value = std::move(value);
  return true;
}

}  // namespace playhouse::device
