#pragma once

/// Handshake and packet format of the observer protocol over
/// datagrams. Texts are specified in docs/viewer-protocol.md.
///
///   datagram, at most limits::kDatagramBytes (little-endian; varint and zz as in delta.h; text: varint n,
///                                             n bytes)
///   +--------+---------+---------------------------------------------------------------------+
/// | u8 'P' | u8 kind | payload of the kind                                                 |
///   +--------+---------+---------------------------------------------------------------------+
///   client  1 hello     : u8 format (formats::kObserver), u64 nonce, zeros up to 64 bytes
///   server  2 challenge : u64 nonce, u64 cookie
///   client  3 join      : u8 format, u64 nonce, u64 cookie, varint bytes/s, varint frames/s, text token
///   server  4 welcome   : u64 nonce, u64 session, varint bytes/s, varint frames/s
///   server  5 refusal   : u64 nonce, text why
/// both    6 packet    : u64 session, then the packet below
///   both    7 bye       : u64 session, text why
///
///   packet
///   +------------+------------+------------+--------------+------------------------------+-------+
///   | varint seq | varint ack | u32 before | varint taken | varint n, (varint at, n B)   | state |
///   +------------+------------+------------+--------------+------------------------------+-------+
/// seq: counts this end's packets from 1
/// ack: the highest seq received from the other end, 0: none; before: bit k: ack - 1 - k was received, too
/// taken: bytes of the other end's stream received without a gap
/// n, at: a piece of this end's stream and its offset; n = 0: none, and no offset
///
/// stream: concatenated texts, reliable and in order
///   +-----------+--------------+----------+---------+
///   | u8 packed | varint after | varint n | n bytes |
///   +-----------+--------------+----------+---------+
///   packed: 0 JSON, 1 JSON in a zstd frame
/// after: this end's last packet before the text; rows in packets up to it predate the text
///
/// state, from the server only: empty, or the rest of the datagram
///   +-------------+----------+-------------------------------------------------------+
///   | varint tick | u8 flags | groups: (u8 age, (u8 mask, zz id step, fields)* u8 0)* |
///   +-------------+----------+-------------------------------------------------------+
/// flags: 1 paused; 2 whole: with this packet the client has received a state of every model of the scene
/// that differs from its `start`
/// age: rows of the group are deltas against the same models in packet seq - age, which the client has
/// acknowledged; 0: against their `start` in the text that announced them
/// mask, fields: as in delta.h; id step: the id - that of the previous row in the group (first: from 0)

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "playhouse/base/formats.h"
#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"

namespace playhouse::replicate {

inline constexpr std::size_t kHelloBytes = 64;  // answers are never longer: no amplification
inline constexpr std::uint8_t kStatePaused = 1, kStateWhole = 2;
/// An observer keeps rows of this many packets, so no baseline may be older.
inline constexpr std::uint32_t kOldestBaseline = 200;
/// Packets covered by one acknowledgement.
inline constexpr std::uint32_t kAcknowledged = 33;

struct Hello {
  std::uint8_t format = formats::kObserver;
  std::uint64_t nonce = 0;
};
struct Challenge {
  std::uint64_t nonce = 0, cookie = 0;
};
/// The limits an observer asks for; the welcome states those granted.
struct Terms {
  std::uint32_t bytes_per_second = 0;
  std::uint32_t frames_per_second = 0;
};
struct JoinRequest {
  std::uint8_t format = formats::kObserver;
  std::uint64_t nonce = 0, cookie = 0;
  Terms wanted;
  std::string token;
};
struct Welcome {
  std::uint64_t nonce = 0, session = 0;
  Terms terms;
};
struct Refusal {
  std::uint64_t nonce = 0;
  std::string why;
};
/// The payload belongs to the channel (datagram_channel.h).
struct PacketOf {
  std::uint64_t session = 0;
  std::span<const std::byte> rest;
};
struct Bye {
  std::uint64_t session = 0;
  std::string why;
};

using Datagram = std::variant<Hello, Challenge, JoinRequest, Welcome, Refusal, PacketOf, Bye>;

/// Fails on anything else; a packet's payload refers to `bytes`.
Result<Datagram> parse_datagram(std::span<const std::byte> bytes);

/// A datagram of any kind but packets.
std::vector<std::byte> encode(const Datagram& datagram);

/// Begins a packet: kind and session.
void begin_packet(std::uint64_t session, Packer& pack);

}  // namespace playhouse::replicate
