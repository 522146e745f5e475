#include "playhouse/app/device_name.h"

#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/wire/messages.h"
#include "playhouse_client/robot.h"

namespace playhouse::app {

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
    return Error{"", fmt::format("{} is no index; a device is named like {}:0", in_quotes(digits), name)};
  }
  return device;
}

Result<WantedDevice> parse_wanted_device(const std::string& text) {
  const Result<DeviceName> address = parse_device_name(text);
  if (address) return WantedDevice{*address, {}};
  const std::size_t colon = text.find(':');
  const std::string_view word = std::string_view(text).substr(0, colon);
  const bool is_interface = wire::find_interface(word) != nullptr;
  const bool has_index = colon != std::string::npos && colon + 1 < text.size() &&
                         text.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  const bool is_part = word.find('.') != std::string_view::npos;  // r0.ranger:0 is a model name
  if (is_interface || (has_index && !is_part)) return address.error();
  return WantedDevice{{}, text};
}

Result<DeviceName> find_device(client::Client& client, const WantedDevice& wanted,
                               bool (*fits)(std::uint16_t interf)) {
  if (wanted.address) return *wanted.address;
  const Result<client::Robot> robot = client.robot(wanted.model);
  if (!robot) return robot.error();
  for (const client::RobotDevice& device : robot->devices()) {
    if (fits(device.address.interf)) return DeviceName{device.address.interf, device.address.index};
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
