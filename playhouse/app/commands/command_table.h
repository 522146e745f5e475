#pragma once

/// The command table: name, help, options and function of each command. A new
/// command is an entry here, a struct in options.h, and a function in commands.h.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "playhouse/app/commands/command_line.h"

namespace playhouse::app {

struct Command {
  const char *name, *summary;
  const char* examples;  // below its options in --help
  /// Adds the options; the returned function makes the CommandLine after CLI11 has parsed.
  std::function<std::function<CommandLine()>(CLI::App&)> add;
};

std::vector<Command> commands();

}  // namespace playhouse::app
