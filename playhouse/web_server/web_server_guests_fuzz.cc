/// Any bytes as a file of guests: reads, with tokens and names that links and models can have, or fails with
/// a place and a text.

#include <cstdint>
#include <cstdlib>

#include "playhouse/web_server/guests.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::web_server;
  const auto guests = parse_guests({reinterpret_cast<const char*>(bytes), size}, "g");
  if (!guests) {
    if (guests.error().text.empty() || guests.error().where.empty()) std::abort();
    return 0;
  }
  std::set<std::string> tokens;
  for (const playhouse::server::Guest& guest : *guests) {
    if (guest.token.find_first_of("#?/ \n\r\t") != std::string::npos || guest.name.size() > 24) std::abort();
    if (!tokens.insert(guest.token).second) std::abort();
  }
  if (tokens.empty()) std::abort();
  return 0;
}
