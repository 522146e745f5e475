#pragma once

/// Validators and parsers of option values. A validator returns an error message for
/// CLI11, or an empty text; a parser the value, or an Error with the same message.

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "playhouse/app/commands/options.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// Strict check for an integer in range: CLI11 wraps
/// -1 to the largest number, and truncates overflow.
template <typename Number>
bool is_whole(const std::string& text, Number least = 0, Number most = std::numeric_limits<Number>::max()) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= least && value <= most;
}

template <typename Number, Number least = 0, Number most = std::numeric_limits<Number>::max()>
std::string check_count(const std::string& text) {
  if (is_whole<Number>(text, least, most)) return {};
  return fmt::format("invalid number {}: a whole number from {} to {} is valid", in_quotes(text), least,
                     most);
}

std::string check_port(const std::string& text);
/// An address as accepted by net's listen(), maybe with a zone (fe80::1%eth0).
std::string check_bind(const std::string& text);
/// A host name as in a browser: no IP address (always allowed), no port, no scheme.
std::string check_web_host(const std::string& text);
std::string check_workers(const std::string& text);
std::string check_not_negative(const std::string& text);
std::string check_positive(const std::string& text);
inline constexpr auto check_observer_bytes =
    check_count<std::uint32_t, limits::kObserverBytesLeast, limits::kObserverBytesMost>;
inline constexpr auto check_page_bytes =
    check_count<std::uint32_t, limits::kPageBytesLeast, limits::kPageBytesMost>;
std::string check_token(const std::string& text);
/// The same for the Player protocol.
std::string check_auth_key(const std::string& text);
/// A key for everybody who comes.
std::string check_key(const std::string& text);
/// A folder that exists.
std::string check_folder(const std::string& text);
/// A record::Selection.
std::string check_selection(const std::string& text);
/// SensorShapes.
std::string check_show(const std::string& text);
std::string check_renderer(const std::string& text);
std::string check_engine(const std::string& text);

/// A port, or "off" for none.
Result<std::optional<std::uint16_t>> parse_web(const std::string& text);
/// "GROUP" or "GROUP:PORT".
Result<net::Endpoint> parse_group(const std::string& text);
/// "X,Y,RADIUS".
Result<ViewSquare> parse_view(const std::string& text);
/// "X,Y,Z" in metres.
Result<geom::Vec3> parse_point(const std::string& text);
/// A number of clients, or comma-separated names; "": one client.
Result<LockStepping> parse_lock_step(const std::string& text);

}  // namespace playhouse::app
