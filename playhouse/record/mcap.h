#pragma once

/// MCAP: the records of the container format of recordings, and their serialisation. A
/// file is the magic, records, the magic; a record is an opcode, the length of its
/// content, and the content; numbers are little-endian, strings have a 32-bit length
/// prefix. Source: the MCAP specification, version 0 (mcap.dev/spec). Values; any thread.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

struct Message {
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

using Bytes = std::vector<std::byte>;

/// Appends a length-prefixed string.
void put_text(Bytes& out, std::string_view text);
/// Appends raw bytes.
void put_bytes(Bytes& out, std::span<const std::byte> bytes);
/// Appends a record.
void put_record(Bytes& out, Op op, std::span<const std::byte> content);
void put(Bytes& out, const Schema& schema);
void put(Bytes& out, const Channel& channel);
void put(Bytes& out, const Message& message);
/// With its trailing checksum.
void put(Bytes& out, const Attachment& attachment);

/// CRC-32 of zlib, as used by MCAP.
std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t before = 0);

}  // namespace playhouse::record
