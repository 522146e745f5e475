/// The program: finds out what was asked for and does it.

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/app/command_line.h"
#include "playhouse/app/commands.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/app/player_link.h"
#include "playhouse/app/standard_streams.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

struct Dispatch {
  int operator()(const Answer& answer) const {
    fmt::print("{}", answer.text);
    return kDone;
  }
  int operator()(const RunOptions& options) const { return run(options); }
  int operator()(const ServeOptions& options) const { return serve(options); }
  int operator()(const DevicesOptions& options) const { return devices(options); }
  int operator()(const WatchOptions& options) const { return watch(options); }
  int operator()(const DriveOptions& options) const { return drive(options); }
  int operator()(const CheckOptions& options) const { return check(options); }
  int operator()(const BenchOptions& options) const { return bench(options); }
};

bool called_player(std::string_view program) {
  return program.substr(program.rfind('/') + 1) == "player";
}

/// What was said before an exception that nobody catches may tell why it came.
void flush_before_the_end() {
  static const std::terminate_handler otherwise = std::get_terminate();
  std::set_terminate([] {
    log::flush();
    otherwise();
  });
}

int start(int argc, const char* const* argv) {
  std::signal(SIGPIPE, SIG_IGN);
  end_at_once_on_signals();
  flush_before_the_end();
  const std::span<const char* const> words(argv + (argc > 0),
                                           static_cast<std::size_t>(argc > 0 ? argc - 1 : 0));
  if (argc > 0 && called_player(argv[0])) return player_link(words);
  log::open(1);
  const Result<CommandLine> line = parse_command_line(words);
  if (!line) {
    log::say("playhouse: " + line.error().text);
    return kUsage;
  }
  return std::visit(Dispatch{}, *line);
}

}  // namespace
}  // namespace playhouse::app

int main(int argc, char** argv) {
  using namespace playhouse::app;
  keep_standard_streams();
  int code = kDone;
  try {
    code = start(argc, argv);
  } catch (const std::exception& error) {  // memory, threads, and standard output: nothing else throws
    if (std::ferror(stdout) == 0) {
      playhouse::log::say(std::string("playhouse: ") + error.what());
      return kFailed;
    }
  }
  return finish_output(code);
}
