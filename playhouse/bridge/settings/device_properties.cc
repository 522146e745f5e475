#include "playhouse/bridge/settings/device_properties.h"

#include <charconv>
#include <utility>

#include "playhouse/scene/generated/write_kinds.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::drivers {
namespace {

/// Of a property that is read by such a request; none if the text is no such value.
template <typename Request>
std::optional<decltype(Request::value)> value_in(std::string_view text) {
  if constexpr (std::is_same_v<Request, wire::StrpropReq>) {
    return wire::c_string(text);
  } else if constexpr (std::is_same_v<Request, wire::BoolpropReq>) {
    if (text != "0" && text != "1") return std::nullopt;
    return static_cast<char>(text == "1");
  } else {
    decltype(Request::value) number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
  }
}

template <typename Request>
SettingValue given_value(const Request& request) {
  if constexpr (std::is_same_v<Request, wire::StrpropReq>)
    return std::string(wire::text(request.value));
  else if constexpr (std::is_same_v<Request, wire::BoolpropReq>)
    return request.value != 0;
  else
    return request.value;
}

/// False if the property has another type.
template <typename Request>
bool put(Request& request, const SettingValue& setting) {
  if constexpr (std::is_same_v<Request, wire::StrpropReq>) {
    const auto* text = std::get_if<std::string>(&setting);
    if (text != nullptr) request.value = wire::c_string(*text);
    return text != nullptr;
  } else if constexpr (std::is_same_v<Request, wire::BoolpropReq>) {
    const auto* flag = std::get_if<bool>(&setting);
    if (flag != nullptr) request.value = static_cast<char>(*flag);
    return flag != nullptr;
  } else {
    const auto* number = std::get_if<decltype(request.value)>(&setting);
    if (number != nullptr) request.value = *number;
    return number != nullptr;
  }
}

/// Of the model, as text.
std::optional<std::string> told(const world::World& world, world::ModelRow model, std::string_view name) {
  if (name == "name") return std::string(world.name(model));
  if (name == "model") return world.desc(model).type;
  return word_of(world, model, name);
}

template <typename Request>
std::optional<Bytes> read(const SimulatedDevice& device, const world::World& world, Request request) {
  const std::string_view name = wire::text(request.key);
  if (const std::optional<SettingValue> setting = device.setting(name)) {
    if (!put(request, *setting)) return std::nullopt;
    return wire::encode(request);
  }
  const world::ModelRow model = world.row(device.model());
  if (!model) return std::nullopt;
  const std::optional<std::string> text = told(world, model, name);
  if (!text) return std::nullopt;
  auto value = value_in<Request>(*text);
  if (!value) return std::nullopt;
  request.value = *std::move(value);
  return wire::encode(request);
}

template <typename Request>
void answer(const std::shared_ptr<SimulatedDevice>& device, const device::Message& message, bool sets,
            device::Replier replier) {
  auto request = wire::decode<Request>(message.body);
  if (!request) return;
  device->answer_by(
      std::move(replier),
      [device, sets, request = *std::move(request)](const world::Journal& journal) -> std::optional<Bytes> {
        if (!sets) return read(*device, journal.world(), request);
        if (!device->set_setting(wire::text(request.key), given_value(request))) return std::nullopt;
        return Bytes();
      });
}

std::string without_quotes(std::string text) {
  if (text.size() < 2 || text.front() != '"' || text.find('"', 1) != text.size() - 1) return text;
  return text.substr(1, text.size() - 2);
}

}  // namespace

bool is_property_request(std::uint8_t type, std::uint8_t subtype) {
  static_assert(wire::kReqGetIntprop == wire::kReqSetBoolprop + 7);
  return type == static_cast<std::uint8_t>(wire::MessageType::kReq) && subtype >= wire::kReqSetBoolprop &&
         subtype <= wire::kReqGetIntprop;
}

void answer_property_request(const std::shared_ptr<SimulatedDevice>& device, const device::Message& message,
                             device::Replier replier) {
  switch (message.subtype) {
    case wire::kReqGetIntprop:
    case wire::kReqSetIntprop:
      return answer<wire::IntpropReq>(device, message, message.subtype == wire::kReqSetIntprop,
                                      std::move(replier));
    case wire::kReqGetDblprop:
    case wire::kReqSetDblprop:
      return answer<wire::DblpropReq>(device, message, message.subtype == wire::kReqSetDblprop,
                                      std::move(replier));
    case wire::kReqGetStrprop:
    case wire::kReqSetStrprop:
      return answer<wire::StrpropReq>(device, message, message.subtype == wire::kReqSetStrprop,
                                      std::move(replier));
    default:
      return answer<wire::BoolpropReq>(device, message, message.subtype == wire::kReqSetBoolprop,
                                       std::move(replier));
  }
}

std::optional<std::string> word_of(const world::World& world, world::ModelRow model, std::string_view word) {
  const scene::ModelDesc& desc = world.desc(model);
  const scene::Kind* kind = scene::find_kind(desc.type);
  const scene::Word* known = kind == nullptr ? nullptr : scene::find_word(*kind, word);
  if (known == nullptr || known->use != scene::Support::kRead) return std::nullopt;
  // As in a saved world file, which leaves out what is as by default.
  scene::PlainDesc unsaid = scene::unsaid(*kind, world.models.root[model] == model);
  unsaid.X_PM.z = desc.stacked;
  unsaid.size.x = unsaid.color.r = -1;  // the kind has their defaults: they are written in any case
  scene::Entity said;
  scene::Words words(world.scene().units, said.words);
  scene::write(desc, unsaid, desc.stacked, words);
  scene::write_kind(desc, world.scene().units, said);
  const std::string start = std::string(word) + " ";
  for (const std::string& each : said.words)
    if (each.starts_with(start)) return without_quotes(each.substr(start.size()));
  return without_quotes(std::string(known->otherwise));
}

}  // namespace playhouse::drivers
