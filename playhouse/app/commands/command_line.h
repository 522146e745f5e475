#pragma once

/// Parser of the command line. docs/cli.md documents it.

#include <any>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "playhouse/base/result.h"

namespace playhouse::app {

/// Text requested on the command line: help or the version.
struct HelpText {
  std::string text;
};

/// The parsed command: its options (options.h), or a HelpText, and its function.
class CommandLine {
 public:
  template <typename Options>
  CommandLine(Options options, int (*execute)(const Options&))
      : options_(std::move(options)),
        execute_([execute](const std::any& any) { return execute(std::any_cast<const Options&>(any)); }) {}

  /// Runs the command. Returns the exit code.
  int execute() const { return execute_(options_); }
  /// nullptr if it is another command.
  template <typename Options>
  const Options* get_if() const {
    return std::any_cast<Options>(&options_);
  }

 private:
  std::any options_;
  std::function<int(const std::any&)> execute_;
};

/// Parses the arguments. Fails with a one-line message and the nearest valid word.
Result<CommandLine> parse_command_line(std::span<const char* const> words);

}  // namespace playhouse::app
