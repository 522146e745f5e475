#pragma once

/// Player clients by WebSocket, on the port of a page: where they connect, and who takes them.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "playhouse/net/websocket.h"

namespace playhouse::web_server {

/// Takes a Player client that has connected to this port of the server.
using ClientCame = std::function<void(std::uint16_t player_port, std::unique_ptr<net::WebSocket>)>;

/// "/player": the default port; "/player/6666": another one. None for other paths.
std::optional<std::uint16_t> player_port_of(std::string_view path, std::uint16_t default_port);

inline constexpr const char* kPlayerPaths =
    "Player clients connect to /player, or to /player/PORT for another port of the server";

}  // namespace playhouse::web_server
