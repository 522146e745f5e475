// Recorded sessions of the original server and its clients: every message decodes, and encodes to the same
// bytes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "playhouse/base/packing.h"
#include "playhouse/base/testing/reference.h"
#include "playhouse/wire/messages.h"

namespace playhouse::wire {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = reference() / "player/captures";

Bytes read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(in)), {});
  const auto* first = reinterpret_cast<const std::byte*>(content.data());
  return {first, first + content.size()};
}

struct Recorded {
  std::string where;  // "04_raw_errors.c2s message 4"
  Header header;
  std::span<const std::byte> body;
};

/// A stream cut into messages; what is left over at its end is a failure.
std::vector<Recorded> split(const std::string& name, std::span<const std::byte> stream) {
  std::vector<Recorded> out;
  while (stream.size() >= limits::kHeaderBytes) {
    const Header header = decode_header(stream.first<limits::kHeaderBytes>());
    stream = stream.subspan(limits::kHeaderBytes);
    if (header.size > stream.size()) break;
    out.push_back({name + " message " + std::to_string(out.size()), header, stream.first(header.size)});
    stream = stream.subspan(header.size);
  }
  EXPECT_EQ(stream.size(), 0u) << name << " ends inside a message";
  return out;
}

std::vector<Recorded> read_capture(const fs::path& path, Bytes& storage) {
  storage = read_file(path);
  std::span<const std::byte> stream = storage;
  if (path.extension() == ".s2c") stream = stream.subspan(limits::kBannerBytes);
  return split(path.filename().string(), stream);
}

// What was wrong on purpose when the sessions were recorded.
const std::set<std::string> kUnknown = {
    "04_raw_errors.c2s message 4",   // request 99 to player:0, with a body
    "04_raw_errors.c2s message 12",  // request 200 to position2d:0, with a body
};
const std::map<std::string, std::string> kMalformed = {
    {"04_raw_errors.c2s message 13", "8 bytes wanted, 4 left, at byte 8 of 12"},  // half a velocity command
    {"04_raw_errors.c2s message 14", "8 bytes wanted, 4 left, at byte 0 of 4"},   // a sixth of a pose
};

void expect_exact(const Recorded& message) {
  std::array<std::byte, limits::kHeaderBytes> header;
  encode_header(message.header, header);
  EXPECT_TRUE(decode_header(header) == message.header ||
              message.header.timestamp != message.header.timestamp);
  const Header& h = message.header;
  const MessageDef* row = find_message(h.interf, h.type, h.subtype);
  if (!row) {
    EXPECT_TRUE(h.size == 0 || kUnknown.contains(message.where)) << message.where << " has no definition";
    return;
  }
  if (message.body.empty()) return;
  const auto malformed = kMalformed.find(message.where);
  if (malformed != kMalformed.end()) {
    EXPECT_EQ(row->check(message.body), malformed->second) << message.where;
    return;
  }
  EXPECT_EQ(row->check(message.body), "") << message.where << " " << row->name;
  EXPECT_TRUE(std::ranges::equal(row->reencode(message.body), message.body))
      << message.where << " " << row->name;
}

TEST(Captures, every_recorded_message_decodes_and_encodes_to_the_same_bytes) {
  std::size_t streams = 0, messages = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFolder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".c2s" && extension != ".s2c") continue;
    ++streams;
    Bytes storage;
    for (const Recorded& message : read_capture(entry.path(), storage)) {
      expect_exact(message);
      ++messages;
    }
  }
  EXPECT_EQ(streams, 38u);
  EXPECT_GE(messages, 3100u);
}

}  // namespace
}  // namespace playhouse::wire
