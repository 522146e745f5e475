// Any text from a viewer is a command or a reason.

#include <cstdint>
#include <string_view>

#include "playhouse/replicate/command.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto command = playhouse::replicate::parse_command({reinterpret_cast<const char*>(bytes), size});
  PLAYHOUSE_ASSERT(command.ok() || !command.error().text.empty());
  return 0;
}
