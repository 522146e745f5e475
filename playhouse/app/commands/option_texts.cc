#include "playhouse/app/commands/option_texts.h"

#include <arpa/inet.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "playhouse/app/pictures/sensor_shapes.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/base/split.h"
#include "playhouse/record/selection.h"
#include "playhouse/server/guests/guest_book.h"
#include "playhouse/wire/auth_key.h"

namespace playhouse::app {
namespace {

constexpr double kFarthest = 1e6;  // m from the origin: limit of a view

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// The comma-separated names; nullopt if one is invalid or duplicate.
std::optional<std::set<std::string>> names_in(const std::string& text) {
  std::set<std::string> names;
  for (const std::string_view name : split(text, ',')) {
    const bool good = !name.empty() && name[0] != '-' && std::ranges::all_of(name, [](unsigned char letter) {
      return std::isalnum(letter) || letter == '-' || letter == '_';
    });
    if (!good || !names.emplace(name).second) return std::nullopt;
  }
  return names;
}

/// Three comma-separated numbers.
std::optional<geom::Vec3> three_in(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string_view word : split(text, ',')) {
    const std::optional<double> value = number_in(word);
    if (!value || std::fabs(*value) > kFarthest) return std::nullopt;
    numbers.push_back(*value);
  }
  if (numbers.size() != 3) return std::nullopt;
  return geom::Vec3{numbers[0], numbers[1], numbers[2]};
}

}  // namespace

std::string check_port(const std::string& text) {
  return is_whole<std::uint16_t>(text) ? "" : "invalid port " + in_quotes(text) + ": 0 to 65535 is valid";
}

std::string check_bind(const std::string& text) {
  in6_addr address;
  const bool good = text == "localhost" || inet_pton(AF_INET, text.c_str(), &address) == 1 ||
                    inet_pton(AF_INET6, text.substr(0, text.find('%')).c_str(), &address) == 1;
  return good ? ""
              : "invalid address " + in_quotes(text) + ": an IPv4 or IPv6 address without a port is valid";
}

std::string check_web_host(const std::string& text) {
  const bool good = !text.empty() && std::ranges::all_of(text, [](unsigned char letter) {
    return std::isalnum(letter) || letter == '-' || letter == '.' || letter == '_';
  });
  return good ? "" : "invalid host " + in_quotes(text) + ": a name without http:// and port is valid";
}

std::string check_workers(const std::string& text) {
  return is_whole<unsigned>(text, 1, 1024) ? ""
                                           : "invalid number " + in_quotes(text) + ": 1 to 1024 is valid";
}

std::string check_not_negative(const std::string& text) {
  const std::optional<double> value = number_in(text);
  if (value && *value >= 0) return {};
  return "invalid number " + in_quotes(text) + ": a number from 0 is valid";
}

std::string check_positive(const std::string& text) {
  const std::optional<double> value = number_in(text);
  if (value && *value > 0) return {};
  return "invalid number " + in_quotes(text) + ": a number above 0 is valid";
}

namespace {

std::string check_token_of(const std::string& text, std::size_t most) {
  const bool good = !text.empty() && text.size() <= most;
  return good ? "" : fmt::format("invalid token: 1 to {} letters are valid", most);
}

}  // namespace

std::string check_token(const std::string& text) {
  return check_token_of(text, limits::kTokenBytes);
}

std::string check_key(const std::string& text) {
  return server::is_key(text) ? "" : std::string(server::kInvalidKey);
}

std::string check_folder(const std::string& text) {
  std::error_code error;
  return std::filesystem::is_directory(text, error)
             ? ""
             : "invalid folder " + in_quotes(text) + ": one that exists is valid";
}

std::string check_auth_key(const std::string& text) {
  return check_token_of(text, wire::kAuthKeyBytes);
}

std::string check_selection(const std::string& text) {
  const Result<record::Selection> selection = record::Selection::parse(text);
  return selection ? "" : selection.error().text;
}

std::string check_show(const std::string& text) {
  const Result<SensorShapes> shown = SensorShapes::parse(text);
  return shown ? "" : shown.error().text;
}

std::string check_renderer(const std::string& text) {
  constexpr std::string_view kNames[] = {kChromium, kPlayhouse};
  if (std::ranges::find(kNames, text) != std::end(kNames)) return "";
  return fmt::format("invalid renderer {}: {} and {} are valid{}", in_quotes(text), kChromium, kPlayhouse,
                     did_you_mean(text, kNames));
}

std::string check_engine(const std::string& text) {
  if (std::ranges::find(kEngines, text) != std::end(kEngines)) return "";
  return fmt::format("invalid engine {}: {} are valid{}", in_quotes(text), fmt::join(kEngines, " and "),
                     did_you_mean(text, kEngines));
}

Result<std::optional<std::uint16_t>> parse_web(const std::string& text) {
  if (text == "off") return std::optional<std::uint16_t>();
  if (is_whole<std::uint16_t>(text)) return std::optional(static_cast<std::uint16_t>(std::stoi(text)));
  return Error{"", "invalid value " + in_quotes(text) + ": a port or \"off\" is valid"};
}

Result<net::Endpoint> parse_group(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string port = colon == std::string::npos ? std::to_string(kGroupPort) : text.substr(colon + 1);
  if (is_whole<std::uint16_t>(port, 1)) {
    const auto group =
        net::parse_endpoint(text.substr(0, colon), static_cast<std::uint16_t>(std::stoi(port)));
    if (group && group->is_group()) return *group;
  }
  return Error{"", "invalid group " + in_quotes(text) +
                       ": a multicast address, 224.0.0.0 to 239.255.255.255, is valid, with :PORT or not"};
}

Result<ViewSquare> parse_view(const std::string& text) {
  const std::optional<geom::Vec3> view = three_in(text);
  if (view && view->z > 0) return ViewSquare{view->x, view->y, view->z};
  return Error{"",
               "invalid view " + in_quotes(text) + ": X,Y,RADIUS in metres is valid, with a radius above 0"};
}

Result<geom::Vec3> parse_point(const std::string& text) {
  const std::optional<geom::Vec3> point = three_in(text);
  if (point) return *point;
  return Error{"", "invalid point " + in_quotes(text) + ": X,Y,Z in metres is valid"};
}

Result<LockStepping> parse_lock_step(const std::string& text) {
  if (text.empty()) return LockStepping{};
  if (is_whole<std::uint32_t>(text, 1, limits::kSessions)) return LockStepping{std::stoul(text), {}};
  const bool begins_as_number = std::isdigit(static_cast<unsigned char>(text[0])) != 0;
  if (std::optional<std::set<std::string>> names = names_in(text); names && !begins_as_number)
    return LockStepping{names->size(), std::move(*names)};
  return Error{"", fmt::format("invalid clients {}: a number from 1 to {}, or names of letters and digits "
                               "between commas, are valid",
                               in_quotes(text), limits::kSessions)};
}

}  // namespace playhouse::app
