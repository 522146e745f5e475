#include "playhouse/device_server/player_program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/server/guests/guest_book.h"

namespace playhouse::device_server {
namespace {

/// Exit code of Player's server for a wrong command line, for
/// help, and for an invalid file. A missing file is kFailed.
constexpr int kPlayerUsage = 255;

constexpr const char* kHelp =
    "Usage: player [options] FILE.cfg\n"
    "  -p PORT    port of devices that name none (6665; 0: any free one, printed)\n"
    "  -k KEY     8 to 32 letters, digits, - and _ that a client has to give by AUTH before it may do "
    "anything\n"
    "  -b ADDRESS listen there alone, as 127.0.0.1 (0.0.0.0: every interface)\n"
    "  -m MIB     memory for what clients send and do not read (320)\n"
    "  -d LEVEL   how much to say: 0 errors and warnings, 1 also information, 2 and more everything\n"
    "  -l FILE    append what is said to a file as well\n"
    "  -q         say errors and warnings only\n"
    "  -h         this text\n";

/// Like the original: invalid numbers are 0.
int number(const char* text) {
  return std::atoi(text);
}

/// Parses options like the original: any order, combined
/// letters, the first file counts. None if invalid.
std::optional<PlayerOptions> parse(std::span<const char* const> words) {
  std::string program = "player";
  std::vector<std::string> copies(words.begin(), words.end());
  std::vector<char*> arguments{program.data()};
  for (std::string& copy : copies) arguments.push_back(copy.data());
  arguments.push_back(nullptr);
  PlayerOptions options;
  const int count = static_cast<int>(arguments.size()) - 1;
  // getopt moves files behind options and reports errors itself.
  for (int option = 0; (option = getopt(count, arguments.data(), "p:k:b:m:d:l:qsh")) != -1;) {
    switch (option) {
      case 'p':
        options.port = static_cast<std::uint16_t>(number(optarg));
        break;
      case 'k':
        if (!server::is_key(optarg)) {
          log::say("player: -k: " + std::string(server::kInvalidKey));
          return std::nullopt;
        }
        options.key = optarg;
        break;
      case 'b':
        options.bind = optarg;
        break;
      case 'm':
        options.client_mib = static_cast<std::size_t>(std::max(0, number(optarg)));
        if (options.client_mib < limits::kClientMiBLeast || options.client_mib > limits::kClientMiBMost) {
          log::say(fmt::format("player: -m: invalid memory: {} to {} MiB are valid", limits::kClientMiBLeast,
                               limits::kClientMiBMost));
          return std::nullopt;
        }
        break;
      case 'd':
        options.level = number(optarg);
        break;
      case 'l':
        options.log_file = optarg;
        break;
      case 'q':
        options.level = 0;
        break;
      case 's':
        log::say(
            "player: -s is not supported: leave running in the background to a service manager, or to &");
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }
  if (optind == count) return std::nullopt;
  options.file = arguments[static_cast<std::size_t>(optind)];
  return options;
}

/// Exit code like Player's: 0 for Ctrl-C and SIGTERM, 255 for unusable files and ports.
int player_code(int code) {
  if (code == 128 + SIGINT || code == 128 + SIGTERM) return kDone;
  return code == kFailed || code == kUsage ? kPlayerUsage : code;
}

bool is_there(const std::string& file) {
  return access(file.c_str(), R_OK) == 0;
}

}  // namespace

int player_program(std::span<const char* const> words, std::string_view about, const Serve& serve) {
  const std::optional<PlayerOptions> options = parse(words);
  if (!options) {
    log::say(kHelp + std::string(about));
    return kPlayerUsage;
  }
  log::open(options->level);
  if (!options->log_file.empty()) {
    if (const Result<void> opened = log::also_to(options->log_file); !opened) return fail_at(opened.error());
  }
  if (!is_there(options->file))
    return fail_at({escaped(options->file), std::string("cannot be opened: ") + std::strerror(errno)});
  if (options->key.empty() && options->bind != "localhost" && !net::is_local(options->bind + ":0"))
    log::warn("who reaches this machine may do everything here: -k KEY asks for a key");
  const int code = serve(*options, [](const std::vector<std::uint16_t>& ports) {
    fmt::print("Listening on ports: {} \n", fmt::join(ports, " "));
    std::fflush(stdout);
  });
  fmt::print("Quitting.\n");
  return player_code(code);
}

}  // namespace playhouse::device_server
