#pragma once

/// Choice of renderer for a command: the requested one, otherwise Chromium if it is found
/// and works, otherwise our own. Reports on standard error which one, and the time taken.

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "playhouse/app/interrupt.h"
#include "playhouse/app/pictures/drawn_run.h"
#include "playhouse/app/pictures/renderer.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

class Drawing {
 public:
  /// Draws everything with a renderer and returns the exit code, after reporting
  /// errors. Fails if the renderer does; it may then be called again with another one.
  using Draw = std::function<Result<int>(WorldRenderer&)>;

  /// `wanted` is the value of --renderer.
  Drawing(std::string command, const std::string& wanted);

  /// Fails if the requested renderer is not available.
  Result<void> possible() const;

  /// Returns the exit code.
  int run(DrawnRun& drawn, const Interrupt& interrupt, const Draw& draw);

 private:
  int done(int code, const char* by) const;

  const std::string command_;
  const bool chromium_alone_;
  const std::optional<std::string> chromium_;  // path of Chromium, if it is to be tried
  const std::string why_ours_;                 // reason for the default, if none was requested
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace playhouse::app
