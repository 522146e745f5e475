#pragma once

/// MCAP: the records of the container format of recordings, and their serialisation. A
/// file is the magic, records, the magic; a record is an opcode, the length of its
/// content, and the content; numbers are little-endian, strings have a 32-bit length
/// prefix. Source: the MCAP specification, version 0 (mcap.dev/spec). Values; any thread.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/packing.h"

namespace playhouse::record {

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHeadBytes = 9;  // opcode and length

enum class Op : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
  kFiller = 0x80,  // zeros; of the opcodes for private use, which readers skip
};

/// Bytes that all chunks of a file may unpack to, by its size, so that a small file does not unpack for
/// minutes. Recordings of worlds where nothing happens unpack to 40 times their size; images of one color
/// and clouds of one point to 30,000 times, so their files get filler: a share of what they unpack to.
struct UnpackedRoom {
  std::uint64_t bytes = std::uint64_t{2} << 30, bytes_each = 1024;

  std::uint64_t most(std::uint64_t file_bytes) const {
    return bytes + bytes_each * std::min<std::uint64_t>(file_bytes, std::uint64_t{1} << 50);
  }
  /// Filler that a file of this size needs: with it, half of the room is enough. A cut file lacks its last
  /// one.
  std::uint64_t filler(std::uint64_t file_bytes, std::uint64_t unpacked) const {
    const std::uint64_t room = most(file_bytes) / 2;
    return unpacked <= room ? 0 : 2 * (unpacked - room) / bytes_each + 1;
  }
};

/// The type definition of a channel's messages.
struct Schema {
  std::uint16_t id = 0;  // from 1
  std::string name;      // "sensor_msgs/msg/LaserScan"
  std::string encoding;  // of the text: "ros2msg"
  std::string text;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  // 0: none
  std::string topic;
  std::string encoding;  // of the messages: "cdr"
};

struct MessageRecord {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;      // ns
  std::uint64_t publish_time = 0;  // ns
  std::span<const std::byte> body;
};

struct Attachment {
  std::uint64_t log_time = 0;  // ns
  std::string name, media_type;
  std::vector<std::byte> body;
};

/// Appends a length-prefixed string.
void put_text(Bytes& out, std::string_view text);
/// Appends raw bytes.
void put_bytes(Bytes& out, std::span<const std::byte> bytes);
/// Appends a record.
void put_record(Bytes& out, Op op, std::span<const std::byte> content);
void put(Bytes& out, const Schema& schema);
void put(Bytes& out, const Channel& channel);
void put(Bytes& out, const MessageRecord& message);
/// With its trailing checksum.
void put(Bytes& out, const Attachment& attachment);

/// CRC-32 of zlib, as used by MCAP.
std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t before = 0);

}  // namespace playhouse::record
