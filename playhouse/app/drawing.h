#pragma once

/// Which renderer a command draws with: the one that was asked for, else Chromium where it is found and
/// draws, else ours. Tells on standard error which it is, and how long it took.

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "playhouse/app/drawn_run.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/app/renderer.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

class Drawing {
 public:
  /// Draws everything with a renderer and returns the exit code, of whose reason it has told. Fails where the
  /// renderer does; it may be called again then, with another one.
  using Draw = std::function<Result<int>(Renderer&)>;

  /// For a command, and what it was given as --renderer.
  Drawing(std::string command, const std::string& wanted);

  /// Why nothing can be drawn as it was asked for.
  Result<void> possible() const;

  /// Returns the exit code.
  int run(DrawnRun& drawn, const Interrupt& interrupt, const Draw& draw);

 private:
  int done(int code, const char* by) const;

  const std::string command_;
  const bool chromium_alone_;
  const std::optional<std::string> chromium_;  // the program, where it is to draw
  const std::string why_ours_;                 // where nobody asked for it
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace playhouse::app
