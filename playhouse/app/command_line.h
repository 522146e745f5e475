#pragma once

/// The command line as values. docs/cli.md describes it for people.

#include <span>
#include <string>
#include <variant>

#include "playhouse/app/options.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// Text that the command line asked for: help or the version.
struct Answer {
  std::string text;
};

using CommandLine =
    std::variant<Answer, RunOptions, ReplayOptions, ExportOptions, ServeOptions, RobotOptions, GymOptions,
                 VerifyOptions, DevicesOptions, WatchOptions, ObserveOptions, DriveOptions, CheckOptions,
                 ConvertOptions,
                 PictureOptions, FilmOptions, KindsOptions, BenchOptions>;

/// The words after the program's name. Fails with one line for a person, with the nearest valid word.
Result<CommandLine> parse_command_line(std::span<const char* const> words);

}  // namespace playhouse::app
