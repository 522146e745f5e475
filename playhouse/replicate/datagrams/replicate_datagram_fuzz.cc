// Any bytes are a datagram for either end of a session, or are refused; whatever they are, both ends go on.
// Input: pieces, each a byte for which end and how, two of its length (little-endian), and its bytes.

#include <algorithm>
#include <cstdint>

#include "playhouse/replicate/datagrams/datagram_link.h"

namespace playhouse::replicate {
namespace {

/// A datagram is given as it is, or as the rest of a packet whose session is right.
void give(DatagramLink& link, std::uint8_t how, std::span<const std::byte> bytes) {
  const auto parsed = parse_datagram(bytes);
  PLAYHOUSE_ASSERT(parsed.ok() || !parsed.error().text.empty());
  std::vector<std::byte> packet;
  Packer pack(packet);
  if ((how & 2) != 0) begin_packet(DatagramLink::kSession, pack);
  packet.insert(packet.end(), bytes.begin(), bytes.end());
  if ((how & 1) != 0) {
    link.observer.receive(packet, link.time);
    return;
  }
  const auto datagram = parse_datagram(packet);
  if (!datagram) return;
  if (const auto* of = std::get_if<PacketOf>(&*datagram))
    static_cast<void>(link.viewer.receive(of->rest, link.time));
}

}  // namespace
}  // namespace playhouse::replicate

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::replicate;
  static SmallWorld small(2);
  DatagramLink link(small, {.delay = 0}, 1);
  link.somebody_else_writes = true;
  link.frame();
  link.frame();
  std::span<const std::byte> rest = std::as_bytes(std::span(bytes, size));
  while (rest.size() >= 3) {
    const auto how = std::to_integer<std::uint8_t>(rest[0]);
    const std::size_t length = std::to_integer<std::size_t>(rest[1]) | std::to_integer<std::size_t>(rest[2])
                                                                           << 8;
    rest = rest.subspan(3);
    const auto piece = rest.first(std::min(length, rest.size()));
    give(link, how, piece);
    rest = rest.subspan(piece.size());
    link.frame();
    static_cast<void>(link.observer.world().pose(1));
  }
  return 0;
}
