#pragma once

/// The command line as values. docs/cli.md describes it for people.

#include <any>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "playhouse/base/result.h"

namespace playhouse::app {

/// Text that the command line asked for: help or the version.
struct Answer {
  std::string text;
};

/// What was asked for: the options of a command (options.h), or an Answer, and what executes it.
class CommandLine {
 public:
  template <typename Options>
  CommandLine(Options options, int (*execute)(const Options&))
      : options_(std::move(options)),
        execute_([execute](const std::any& any) { return execute(std::any_cast<const Options&>(any)); }) {}

  /// Does it. Returns the exit code.
  int execute() const { return execute_(options_); }
  /// nullptr: something else was asked for.
  template <typename Options>
  const Options* get_if() const {
    return std::any_cast<Options>(&options_);
  }

 private:
  std::any options_;
  std::function<int(const std::any&)> execute_;
};

/// The words after the program's name. Fails with one line for a person, with the nearest valid word.
Result<CommandLine> parse_command_line(std::span<const char* const> words);

}  // namespace playhouse::app
