/// The program: parses the command line and runs the command.

#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/app/commands/command_line.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/app/run_service.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/device_server/player_program.h"
#include "playhouse/device_server/program.h"
#include "playhouse/drivers/isolated/isolated_main.h"
#include "playhouse/simd/instruction_set.h"

namespace playhouse::app {
namespace {

bool called_player(std::string_view program) {
  return program.substr(program.rfind('/') + 1) == "player";
}

/// PLAYHOUSE_INSTRUCTION_SET, set by tests; results do not depend on it (docs/benchmarks.md).
Result<void> choose_instruction_set() {
  const char* const wanted = std::getenv("PLAYHOUSE_INSTRUCTION_SET");
  if (wanted == nullptr) return {};
  const Result<simd::InstructionSet> set = simd::parse_instruction_set(wanted);
  if (!set) return Error{"PLAYHOUSE_INSTRUCTION_SET", set.error().text};
  simd::choose_instruction_set(*set);
  return {};
}

constexpr std::string_view kUnderThisName =
    "This is playhouse under Player's name; `playhouse --help` shows what else it does.";

int serve_as_player(const device_server::PlayerOptions& options, const device_server::Opened& opened) {
  Service service({.port = options.port,
                   .web = std::nullopt,
                   .bind = options.bind,
                   .port_option = "-p",
                   .key = options.key,
                   .client_mib = options.client_mib},
                  {}, QuitTime::kIgnored);
  return run_service(
      service, [&] { return service.read_cfg(options.file); }, {}, opened);
}

int start(int argc, const char* const* argv) {
  end_at_once_on_signals();
  const std::span<const char* const> words(argv + (argc > 0),
                                           static_cast<std::size_t>(argc > 0 ? argc - 1 : 0));
  log::open(1);
  if (const Result<void> chosen = choose_instruction_set(); !chosen) return fail(chosen.error(), kUsage);
  if (argc > 0 && called_player(argv[0]))
    return device_server::player_program(words, kUnderThisName, serve_as_player);
  const Result<CommandLine> line = parse_command_line(words);
  if (!line) return fail(line.error(), kUsage);
  return line->execute();
}

}  // namespace
}  // namespace playhouse::app

int main(int argc, char** argv) {
  using namespace playhouse::app;
  if (playhouse::drivers::is_isolated_plugin(argc, argv)) return playhouse::drivers::run_isolated_plugin();
  return playhouse::device_server::run_program([=] { return start(argc, argv); });
}
