#include "playhouse/config/device_address.h"

#include <arpa/inet.h>

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

bool is_ipv6(std::string_view host) {
  in6_addr address{};
  const std::string without_zone(host.substr(0, host.find('%')));
  return inet_pton(AF_INET6, without_zone.c_str(), &address) == 1;
}

/// Splits off "[::1]" at the end, without its brackets; none if there is no bracket.
std::optional<std::string_view> take_in_brackets(std::string_view& rest) {
  const std::size_t opening = rest.ends_with(']') ? rest.rfind('[') : std::string_view::npos;
  if (opening == std::string_view::npos) return std::nullopt;
  const std::string_view host = rest.substr(opening + 1, rest.size() - opening - 2);
  rest = rest.substr(0, opening);
  return host;
}

}  // namespace

std::string DeviceAddress::text() const {
  std::string text = interf + ":" + std::to_string(index);
  const std::string port_text = port ? std::to_string(*port) : "";
  if (port || !host.empty() || !key.empty()) text = port_text + ":" + text;
  const bool has_colon = host.find(':') != std::string::npos;
  if (!host.empty() || !key.empty()) text = (has_colon ? "[" + host + "]" : host) + ":" + text;
  return key.empty() ? text : key + ":" + text;
}

Result<DeviceAddress> parse_device_address(std::string_view text) {
  const auto bad = [text](std::string_view why) {
    return Error{{}, "device address " + in_quotes(text) + " " + std::string(why)};
  };
  std::string_view rest = text.substr(0, text.find_last_not_of(" \t") + 1);  // as the original reads numbers
  const std::optional<std::uint16_t> index = parse_u16(take_last(rest));
  const std::string_view interf = take_last(rest), port = take_last(rest);
  const std::optional<std::string_view> bracketed = take_in_brackets(rest);
  const std::string_view host = bracketed ? *bracketed : take_last(rest);
  if (bracketed && !rest.empty() && rest.back() != ':') return bad("needs a colon before its host");
  if (bracketed && !rest.empty()) rest.remove_suffix(1);
  if (rest.find(':') != std::string_view::npos)
    return bad("has too many parts; write key:host:port:interface:index, an IPv6 host in brackets");
  if (interf.empty()) return bad("needs an interface and an index, as in \"position2d:0\"");
  if (!index) return bad("needs an index from 0 to 65535 at its end, as in \"position2d:0\"");
  if (bracketed && !is_ipv6(host))
    return bad("has an invalid host " + in_quotes(host) + ": brackets are for IPv6");
  DeviceAddress address{std::string(rest), std::string(host), {}, std::string(interf), *index};
  if (port.empty()) return address;
  address.port = parse_u16(port);
  if (!address.port) return bad("has an invalid port " + in_quotes(port) + ": 0 to 65535 is valid");
  return address;
}

}  // namespace playhouse::config
