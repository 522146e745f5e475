#include "playhouse/web_server/player_path.h"

#include <charconv>

namespace playhouse::web_server {
namespace {

constexpr std::string_view kPlayer = "/player";

}  // namespace

std::optional<std::uint16_t> player_port_of(std::string_view path, std::uint16_t default_port) {
  if (path == kPlayer) return default_port;
  if (!path.starts_with(kPlayer) || path[kPlayer.size()] != '/') return std::nullopt;
  const std::string_view text = path.substr(kPlayer.size() + 1);
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(port) : std::nullopt;
}

}  // namespace playhouse::web_server
