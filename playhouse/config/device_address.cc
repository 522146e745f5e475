#include "playhouse/config/device_address.h"

#include <algorithm>
#include <charconv>

#include "playhouse/base/in_quotes.h"

namespace playhouse::config {
namespace {

std::optional<std::uint16_t> parse_u16(std::string_view digits) {
  std::uint16_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// Splits off the part after the last colon; everything if there is none.
std::string_view take_last(std::string_view& rest) {
  const std::size_t colon = rest.rfind(':');
  const std::string_view part = colon == std::string_view::npos ? rest : rest.substr(colon + 1);
  rest = colon == std::string_view::npos ? std::string_view{} : rest.substr(0, colon);
  return part;
}

}  // namespace

std::string DeviceAddress::text() const {
  std::string text = interf + ":" + std::to_string(index);
  const std::string port_text = port ? std::to_string(*port) : "";
  if (port || !host.empty() || !key.empty()) text = port_text + ":" + text;
  if (!host.empty() || !key.empty()) text = host + ":" + text;
  return key.empty() ? text : key + ":" + text;
}

Result<DeviceAddress> parse_device_address(std::string_view text) {
  const auto bad = [text](std::string_view why) {
    return Error{{}, "device address " + in_quotes(text) + " " + std::string(why)};
  };
  if (std::count(text.begin(), text.end(), ':') > 4) {
    return bad("has too many parts; write key:host:port:interface:index");
  }
  std::string_view rest = text.substr(0, text.find_last_not_of(" \t") + 1);  // as the original reads numbers
  const std::optional<std::uint16_t> index = parse_u16(take_last(rest));
  const std::string_view interf = take_last(rest);
  if (interf.empty()) return bad("needs an interface and an index, as in \"position2d:0\"");
  if (!index) return bad("needs an index from 0 to 65535 at its end, as in \"position2d:0\"");
  DeviceAddress address{{}, {}, {}, std::string(interf), *index};
  const std::string_view port = take_last(rest);
  if (!port.empty()) {
    address.port = parse_u16(port);
    if (!address.port) return bad("has an invalid port " + in_quotes(port) + ": 0 to 65535 is valid");
  }
  address.host = take_last(rest);
  address.key = rest;
  if (rest.find(':') != std::string_view::npos)
    return bad("has too many parts; write key:host:port:interface:index");
  return address;
}

}  // namespace playhouse::config
