#include "playhouse/replicate/datagrams/datagram.h"

#include <algorithm>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"

namespace playhouse::replicate {
namespace {

constexpr std::uint8_t kMagic = 'P';
enum Kind : std::uint8_t { kHello = 1, kChallenge, kJoin, kWelcome, kRefusal, kPacket, kBye };

struct Encoder {
  Packer& pack;

  void begin(Kind kind) {
    pack.u8(kMagic);
    pack.u8(kind);
  }
  void operator()(const Hello& hello) {
    begin(kHello);
    pack.u8(hello.format);
    pack.u64(hello.nonce);
    while (pack.size() < kHelloBytes) pack.u8(0);
  }
  void operator()(const Challenge& challenge) {
    begin(kChallenge);
    pack.u64(challenge.nonce);
    pack.u64(challenge.cookie);
  }
  void operator()(const JoinRequest& join) {
    begin(kJoin);
    pack.u8(join.format);
    pack.u64(join.nonce);
    pack.u64(join.cookie);
    terms(join.wanted);
    pack.text(join.token);
  }
  void operator()(const Welcome& welcome) {
    begin(kWelcome);
    pack.u64(welcome.nonce);
    pack.u64(welcome.session);
    terms(welcome.terms);
  }
  void operator()(const Refusal& refusal) {
    begin(kRefusal);
    pack.u64(refusal.nonce);
    pack.text(refusal.why);
  }
  void operator()(const PacketOf& packet) { begin_packet(packet.session, pack); }
  void operator()(const Bye& bye) {
    begin(kBye);
    pack.u64(bye.session);
    pack.text(bye.why);
  }
  void terms(const Terms& terms) {
    pack.varint(terms.bytes_per_second);
    pack.varint(terms.frames_per_second);
  }
};

std::uint32_t clipped(std::uint64_t value) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(value, 0xFFFFFFFFu));
}

Terms read_terms(Unpacker& in) {
  const std::uint32_t bytes = clipped(in.varint());
  return {bytes, clipped(in.varint())};
}

}  // namespace

Result<Datagram> parse_datagram(std::span<const std::byte> bytes) {
  Unpacker in(bytes);
  const auto whole = [&](Datagram datagram) -> Result<Datagram> {
    if (!in.ok() || !in.at_end()) return Error{"", "a datagram is cut short or too long"};
    return datagram;
  };
  if (bytes.size() > limits::kDatagramBytes || in.u8() != kMagic) return Error{"", "not a datagram of ours"};
  // Fields in wire order: braced initialisers are evaluated left to right.
  switch (in.u8()) {
    case kHello: {
      const Hello hello{in.u8(), in.u64()};
      if (bytes.size() < kHelloBytes) break;  // anti-amplification: the answer must not be longer
      return Datagram(hello);
    }
    case kChallenge:
      return whole(Challenge{in.u64(), in.u64()});
    case kJoin:
      return whole(JoinRequest{in.u8(), in.u64(), in.u64(), read_terms(in), in.text()});
    case kWelcome:
      return whole(Welcome{in.u64(), in.u64(), read_terms(in)});
    case kRefusal:
      return whole(Refusal{in.u64(), in.text()});
    case kPacket: {
      const std::uint64_t session = in.u64();
      if (!in.ok()) break;
      return Datagram(PacketOf{session, bytes.last(in.left())});
    }
    case kBye:
      return whole(Bye{in.u64(), in.text()});
  }
  return Error{"", "not a datagram of ours"};
}

std::vector<std::byte> encode(const Datagram& datagram) {
  std::vector<std::byte> bytes;
  Packer pack(bytes);
  std::visit(Encoder{pack}, datagram);
  return bytes;
}

void begin_packet(std::uint64_t session, Packer& pack) {
  pack.u8(kMagic);
  pack.u8(kPacket);
  pack.u64(session);
}

}  // namespace playhouse::replicate
