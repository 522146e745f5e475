#include "playhouse/app/player_link.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/app/open_house.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

/// Exit code of Player's server for a wrong command line and for help.
constexpr int kPlayerUsage = 255;

constexpr const char* kHelp =
    "Usage: player [options] FILE.cfg\n"
    "  -p PORT    port of devices that name none (6665; 0: any free one, printed)\n"
    "  -d LEVEL   how much to say: 0 errors and warnings, 1 also information, 2 and more everything\n"
    "  -l FILE    append what is said to a file as well\n"
    "  -q         say errors and warnings only\n"
    "  -h         this text\n"
    "This is playhouse under Player's name; `playhouse --help` shows what else it does.";

struct PlayerOptions {
  std::uint16_t port = kPlayerPort;
  int level = 1;
  std::string log_file;
  std::string file;
  bool help = false;
};

template <typename Number>
bool parse_number(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Handles one option that takes a value.
Result<void> set_option(char option, std::string_view value, PlayerOptions& options) {
  if (option == 'l') {
    options.log_file = value;
  } else if (option == 'p' && !parse_number(value, options.port)) {
    return Error{"", fmt::format("-p wants a port, not {}", in_quotes(value))};
  } else if (option == 'd' &&
             (!parse_number(value, options.level) || options.level < 0 || options.level > 9)) {
    return Error{"", fmt::format("-d wants a level from 0 to 9, not {}", in_quotes(value))};
  }
  return {};
}

Result<PlayerOptions> parse(std::span<const char* const> words) {
  PlayerOptions options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (word.size() < 2 || word[0] != '-') {
      if (!options.file.empty())
        return Error{"", fmt::format("one file is wanted; {} is a second", in_quotes(word))};
      options.file = word;
      continue;
    }
    const char option = word[1];
    if (option == 'h' || word == "--help") {
      options.help = true;
    } else if (option == 'q') {
      options.level = 0;
    } else if (option == 'p' || option == 'd' || option == 'l') {
      const bool attached = word.size() > 2;  // -p6665
      if (!attached && i + 1 == words.size()) return Error{"", fmt::format("-{} wants a value", option)};
      const std::string_view value = attached ? word.substr(2) : std::string_view(words[++i]);
      if (const Result<void> set = set_option(option, value, options); !set) return set.error();
    } else if (word == "-s") {
      return Error{"", "-s is not supported: leave running in the background to a service manager, or to &"};
    } else {
      return Error{"", fmt::format("unknown option {}", word)};
    }
  }
  return options;
}

/// Player ends with 255 for files and ports that cannot be used.
int player_code(int code) {
  return code == kFailed || code == kUsage ? kPlayerUsage : code;
}

}  // namespace

int player_link(std::span<const char* const> words) {
  const Result<PlayerOptions> options = parse(words);
  if (!options || options->help || options->file.empty()) {
    log::say(options ? kHelp : "player: " + options.error().text + "\n" + kHelp);
    return kPlayerUsage;
  }
  log::open(options->level);
  if (!options->log_file.empty()) {
    if (const Result<void> opened = log::also_to(options->log_file); !opened) {
      log::error("{}", opened.error().line());
      return kPlayerUsage;
    }
  }
  House house({.port = options->port, .web = std::nullopt, .bind = "0.0.0.0"}, {}, QuitTime::kIgnored);
  const int code = open_house(
      house, [&] { return house.read_cfg(options->file); }, {},
      [&house] {
        fmt::print("Listening on ports: {} \n", fmt::join(house.player_ports(), " "));
        std::fflush(stdout);
      });
  fmt::print("Quitting.\n");
  return player_code(code);
}

}  // namespace playhouse::app
