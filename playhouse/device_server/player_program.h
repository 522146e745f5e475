#pragma once

/// The program `player`: takes the options of Player's own server (-p, -k, -d, -q, -l, -h, file) and two of ours (-b, -m), and says on standard output
/// what its scripts wait for: "Listening on ports: 6665 " and, at the end, "Quitting.".

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/limits.h"

namespace playhouse::device_server {

struct PlayerOptions {
  std::uint16_t port = 6665;
  int level = 1;                                // of the log
  std::string bind = "0.0.0.0";                 // numeric address that it listens at
  std::size_t client_mib = limits::kClientMiB;  // memory for what clients send and do not read
  std::string key;                              // that clients have to give; empty: none
  std::string log_file;
  std::string file;
};

/// Called with the ports once clients can connect.
using Opened = std::function<void(const std::vector<std::uint16_t>& ports)>;
/// Serves the file; returns 0, 1, 2, or 128 and the number of the signal that ended it.
using Serve = std::function<int(const PlayerOptions& options, const Opened& opened)>;

/// `words`: the arguments; `about`: the last line of -h. Returns the exit code of Player's server.
int player_program(std::span<const char* const> words, std::string_view about, const Serve& serve);

}  // namespace playhouse::device_server
