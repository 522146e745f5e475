/// The device server alone, without simulator and page: the program `player` of the preset `core`.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/fail.h"
#include "playhouse/base/version.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device_server/descriptor_limit.h"
#include "playhouse/device_server/device_server.h"
#include "playhouse/device_server/player_program.h"
#include "playhouse/device_server/program.h"
#include "playhouse/drivers/registry.h"
#include "playhouse/server/guests/guest_book.h"

namespace playhouse::device_server {
namespace {

int serve(const PlayerOptions& options, const Opened& opened) {
  std::vector<Error> others;
  const Result<config::CfgFile> file = config::load_cfg(options.file, options.port, &others);
  if (!file) return fail_in_file(file.error(), others);
  for (const std::string& line : file->warnings) warn(line);
  server::ServerOptions serving{.bind = options.bind, .sessions = sessions_that_fit(false)};
  serving.share_memory(options.client_mib);
  DeviceServer service(std::move(serving));
  const Result<std::uint16_t> port = service.listen(*file, options.port, "-p");
  if (!port) return fail(port.error());
  server::admit_guests(service.server(), server::book_of_key(options.key));
  service.open_site(*port, service.server());
  const auto core = drivers::core_drivers();
  const drivers::Registry registry({core.begin(), core.end()}, {});
  if (const Result<void> made = service.make_drivers(registry, *file, warn); !made)
    return fail_in_file(made.error());
  opened(service.ports());
  return service.run();
}

}  // namespace
}  // namespace playhouse::device_server

int main(int argc, char** argv) {
  using namespace playhouse;
  return device_server::run_program([=] {
    const std::span<const char* const> words(argv + (argc > 0),
                                             static_cast<std::size_t>(argc > 0 ? argc - 1 : 0));
    const std::string about = "This is the device server of Playhouse " + std::string(build()) + ".";
    return device_server::player_program(words, about, device_server::serve);
  });
}
