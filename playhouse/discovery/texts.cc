#include "playhouse/discovery/texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

namespace playhouse::discovery {
namespace {

constexpr std::string_view kRobotKey = "robot";

/// 1 of "robot1". Keys have numbers as each counts once, and texts may come in any order.
std::optional<unsigned> number_of_robot(std::string_view key) {
  unsigned number = 0;
  if (!key.starts_with(kRobotKey)) return std::nullopt;
  const auto [end, error] = std::from_chars(key.data() + kRobotKey.size(), key.data() + key.size(), number);
  return error == std::errc() && end == key.data() + key.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::vector<std::string> texts_of(const ServerTexts& server, std::string_view version) {
  std::vector<std::string> texts{"txtvers=1", fmt::format("version={}", version)};
  if (server.encrypted) texts.emplace_back("tls=1");
  if (server.has_guests) texts.emplace_back("guests=1");
  texts.push_back(fmt::format("robots={}", server.robots.size()));
  std::size_t bytes = 0;
  for (const std::string& text : texts) bytes += text.size() + 1;
  std::size_t named = 0;
  for (const std::string& robot : server.robots) {
    std::string text = fmt::format("{}{}={}", kRobotKey, named, robot);
    if (named == kMostRobots) break;
    if (text.size() > kOneTextBytes || bytes + text.size() + 1 > kAllTextBytes) continue;
    bytes += text.size() + 1;
    ++named;
    texts.push_back(std::move(text));
  }
  return texts;
}

ServerTexts from_texts(std::span<const std::string> texts) {
  ServerTexts server;
  std::map<unsigned, std::string> robots;
  for (const std::string& text : texts.first(std::min(texts.size(), kMostTexts))) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || text.size() > kOneTextBytes) continue;
    const std::string_view key = std::string_view(text).substr(0, equals);
    const std::string value = text.substr(equals + 1);
    if (key == "tls") server.encrypted = value == "1";
    if (key == "guests") server.has_guests = value == "1";
    const std::optional<unsigned> number = number_of_robot(key);
    if (number && !value.empty() && robots.size() < kMostRobots) robots.emplace(*number, value);
  }
  for (auto& [number, robot] : robots) server.robots.push_back(std::move(robot));
  return server;
}

}  // namespace playhouse::discovery
