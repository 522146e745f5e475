// Generated from interfaces/056_rfid.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Reads and writes radio tags.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::rfid {

inline constexpr std::uint16_t kCode = 56;

// Subtypes of messages.
/// Tags in range.
inline constexpr std::uint8_t kDataTags = 1;
/// Switches the reader on or off.
inline constexpr std::uint8_t kReqPower = 1;
/// Reads a tag.
inline constexpr std::uint8_t kReqReadtag = 2;
/// Writes a tag.
inline constexpr std::uint8_t kReqWritetag = 3;
/// Locks a tag against writing.
inline constexpr std::uint8_t kReqLocktag = 4;

/// One tag.
struct Tag {
  /// Type of tag.
  std::uint32_t type = 0;
  /// Id of the tag, as bytes.
  std::string guid{};

  friend bool operator==(const Tag&, const Tag&) = default;
};

/// Tags in range.
struct Data {
  std::vector<Tag> tags{};

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Tag& m);
void write(Writer& out, const Tag& m);
void to_json(std::string& out, const Tag& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::rfid
