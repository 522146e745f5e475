#include "playhouse/app/commands/device_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/wire/messages.h"
#include "playhouse_client/robot.h"

namespace playhouse::app {
namespace {

/// A device of the last model of this name, or of its descendants, on whatever port; none if there is none.
std::optional<client::DeviceAddress> find_on_any_port(const std::vector<client::Model>& models,
                                                      const std::string& name,
                                                      bool (*fits)(std::uint16_t interf)) {
  const auto found = std::find_if(models.rbegin(), models.rend(),
                                  [&](const client::Model& model) { return model.name == name; });
  if (found == models.rend()) return std::nullopt;
  std::vector<bool> is_part(models.size());
  for (std::size_t row = models.rend() - found - 1; row < models.size(); ++row) {
    const client::Model& model = models[row];
    is_part[row] = &model == &*found || (model.parent && is_part[*model.parent]);
    if (!is_part[row]) continue;
    for (const client::DeviceAddress& device : model.devices)
      if (fits(device.interf)) return device;
  }
  return std::nullopt;
}

}  // namespace

Result<DeviceName> parse_device_name(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  const wire::InterfaceDef* interf = wire::find_interface(name);
  if (interf == nullptr) {
    std::vector<std::string_view> names;
    for (const wire::InterfaceDef& known : wire::interfaces()) names.push_back(known.name);
    return Error{"", fmt::format("there is no interface {}{}", in_quotes(name), did_you_mean(name, names))};
  }
  DeviceName device{interf->code, 0};
  if (colon == std::string_view::npos) return device;
  const std::string_view digits = text.substr(colon + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), device.index);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    return Error{"",
                 fmt::format("invalid index {}: 0 to 65535 is valid, as in {}:0", in_quotes(digits), name)};
  }
  return device;
}

Result<DeviceArgument> parse_wanted_device(const std::string& text) {
  const Result<DeviceName> address = parse_device_name(text);
  if (address) return DeviceArgument{*address, {}};
  const std::size_t colon = text.find(':');
  const std::string_view word = std::string_view(text).substr(0, colon);
  const bool is_interface = wire::find_interface(word) != nullptr;
  const bool has_index = colon != std::string::npos && colon + 1 < text.size() &&
                         text.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  const bool is_part = word.find('.') != std::string_view::npos;  // r0.ranger:0 is a model name
  if (is_interface || (has_index && !is_part)) return address.error();
  return DeviceArgument{{}, text};
}

Result<DeviceName> find_device(client::Client& client, const DeviceArgument& wanted,
                               bool (*fits)(std::uint16_t interf)) {
  if (wanted.address) return *wanted.address;
  const Result<client::Robot> robot = client.robot(wanted.model);
  if (!robot) return robot.error();
  for (const client::RobotDevice& device : robot->devices()) {
    if (fits(device.address.interf)) return DeviceName{device.address.interf, device.address.index};
  }
  if (const Result<std::vector<client::Model>> models = client.models(); models) {
    if (const auto other = find_on_any_port(*models, wanted.model, fits))
      return Error{client.peer(), fmt::format("model {} has {} on port {} of this server",
                                              in_quotes(wanted.model), other->name(), other->port)};
  }
  return Error{client.peer(), "model " + in_quotes(wanted.model) +
                                  " has no device for this; playhouse devices lists what there is"};
}

Result<client::Address> parse_server(const std::string& text, std::uint16_t port) {
  const bool is_port = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t host_end = text.starts_with('[') ? text.find(']') : 0;
  const bool has_port = is_port || text.find(':', host_end) != std::string::npos;
  Result<client::Address> address = client::parse_address(is_port ? ":" + text : text);
  if (address && !has_port) address->port = port;
  return address;
}

}  // namespace playhouse::app
