#pragma once

/// The commands of the program: how each is called, what --help says of it, its options, and what executes
/// it. A new one is an entry here, a struct of options.h, and a function of commands.h.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "playhouse/app/command_line.h"

namespace playhouse::app {

struct Command {
  const char *name, *summary;
  const char* examples;  // below its options in --help
  /// Adds the options; what it returns tells, once CLI11 has read the words, what they ask for.
  std::function<std::function<CommandLine()>(CLI::App&)> add;
};

std::vector<Command> commands();

}  // namespace playhouse::app
