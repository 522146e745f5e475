#pragma once

/// Command line shared by the examples: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]].

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "playhouse_client/client.h"

namespace example {

inline volatile std::sig_atomic_t interrupted = 0;  // the signal that asks the program to end; 0: none

/// Installs handlers for SIGINT, SIGTERM and SIGHUP, so that the program stops the robot before it exits. An
/// ignored SIGHUP (nohup) stays ignored.
inline void catch_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(number, [](int caught) { interrupted = caught; });
    if (number == SIGHUP && before == SIG_IGN) std::signal(number, SIG_IGN);
  }
}

/// Deadline of the program: a duration, or a termination signal.
class Clock {
 public:
  /// `seconds` 0: no time limit.
  explicit Clock(double seconds)
      : seconds_(seconds > 0 ? seconds : std::numeric_limits<double>::infinity()) {}
  bool up() const {
    return interrupted != 0 ||
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() >= seconds_;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double seconds_;
};

using Behaviour = playhouse::Result<void> (*)(playhouse::client::Client&, std::uint16_t index, const Clock&,
                                              const std::vector<int>& more);

/// Parses a non-negative duration (`seconds`) or an integer up to 65535; none if the text is neither.
inline std::optional<double> parse_number(const char* text, bool seconds) {
  char* end = nullptr;
  const double number = std::strtod(text, &end);
  if (end == text || *end != '\0' || !std::isfinite(number) || number < 0) return std::nullopt;
  if (!seconds && (number > 65535 || number != std::floor(number))) return std::nullopt;
  return number;
}

/// Connects and runs `behave`. Exit code: 0 done, 1 error, 2 wrong arguments, 128 + signal number when
/// interrupted (130 for Ctrl-C).
inline int run(int argc, char** argv, Behaviour behave) {
  const std::string address = argc > 1 ? argv[1] : "127.0.0.1:6665";
  std::vector<double> numbers;
  for (int i = 2; i < argc; ++i) {
    const std::optional<double> number = parse_number(argv[i], i == 3);
    if (!number) {
      std::fprintf(stderr, "usage: %s [HOST:PORT [INDEX [SECONDS ...]]]\n", argv[0]);
      return 2;
    }
    numbers.push_back(*number);
  }
  numbers.resize(std::max<std::size_t>(numbers.size(), 2));
  auto client = playhouse::client::Client::connect(address);
  if (!client) {
    std::fprintf(stderr, "%s\n", client.error().line().c_str());
    return 1;
  }
  catch_signals();
  const auto done = behave(*client, static_cast<std::uint16_t>(numbers[0]), Clock(numbers[1]),
                           std::vector<int>(numbers.begin() + 2, numbers.end()));
  if (!done) std::fprintf(stderr, "%s\n", done.error().line().c_str());
  return !done ? 1 : interrupted != 0 ? 128 + interrupted : 0;
}

/// Blocks until the device has new data; false when the time is up.
inline playhouse::Result<bool> next_data(playhouse::client::Client& client, playhouse::client::Device& device,
                                         const Clock& clock) {
  while (!clock.up()) {
    const auto read = client.read();
    if (!read) return read.error();
    if (device.take_fresh()) return true;
  }
  return false;
}

}  // namespace example
