#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/record/mcap_reader.h"
#include "playhouse/record/mcap_writer.h"
#include "playhouse/record/testing/memory_source.h"

namespace playhouse::record {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Bytes bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Bytes message(std::uint16_t channel, std::uint64_t time, const std::string& body) {
  Bytes out;
  const Bytes bytes = bytes_of(body);
  put(out, Message{channel, 0, time, time, bytes});
  return out;
}

class Mcap : public testing::Test {
 protected:
  Mcap() {
    writer_ = *McapWriter::create(path_, "test");
    Bytes records;
    put(records, Schema{1, "Word", "ros2msg", "string word"});
    put(records, Channel{7, 1, "/words", "cdr"});
    writer_->add(records);
  }

  Bytes file() const {
    std::ifstream in(path_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return bytes_of(text);
  }

  Result<McapReader::End> read(const Bytes& bytes) {
    said_.clear();
    const MemorySource source(bytes);
    McapReader reader(source);
    return reader.read({.message = [&](const Channel& channel, const Message& heard) -> Result<void> {
                          said_.push_back(channel.topic + " " + text_of(heard.body));
                          return {};
                        },
                        .attachment = [&](const Attachment& heard) -> Result<void> {
                          said_.push_back(heard.name + " = " + text_of(heard.body));
                          return {};
                        }});
  }

  const TestFolder folder_;
  const std::string path_ = folder_ / "test.mcap";
  std::unique_ptr<McapWriter> writer_;
  std::vector<std::string> said_;
};

TEST_F(Mcap, gives_back_what_was_written_in_its_order) {
  ASSERT_TRUE(writer_->attach({5, "world", "text/plain", bytes_of("a world")}).ok());
  writer_->add(message(7, 10, "one"));
  ASSERT_TRUE(writer_->flush().ok());
  writer_->add(message(7, 20, "two"));
  ASSERT_TRUE(writer_->finish().ok());
  const auto end = read(file());
  ASSERT_TRUE(end.ok()) << end.error().line();
  EXPECT_EQ(*end, McapReader::End::kWhole);
  EXPECT_THAT(said_, ElementsAre("world = a world", "/words one", "/words two"));
}

TEST_F(Mcap, that_is_not_finished_reads_up_to_its_last_flush) {
  writer_->add(message(7, 10, "one"));
  ASSERT_TRUE(writer_->flush().ok());
  writer_->add(message(7, 20, "two"));
  const auto end = read(file());
  ASSERT_TRUE(end.ok()) << end.error().line();
  EXPECT_EQ(*end, McapReader::End::kCut);
  EXPECT_THAT(said_, ElementsAre("/words one"));
}

TEST_F(Mcap, cut_anywhere_reads_what_is_whole) {
  writer_->add(message(7, 10, "one"));
  ASSERT_TRUE(writer_->flush().ok());
  writer_->add(message(7, 20, "two"));
  ASSERT_TRUE(writer_->finish().ok());
  const Bytes whole = file();
  std::size_t most = 0;
  for (std::size_t size = kMagic.size(); size < whole.size(); ++size) {
    const auto end = read(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    ASSERT_TRUE(end.ok()) << size << ": " << end.error().line();
    ASSERT_GE(said_.size(), most) << size;
    most = said_.size();
  }
  EXPECT_EQ(most, 2u);
}

TEST_F(Mcap, with_a_changed_byte_in_a_chunk_is_refused) {
  writer_->add(message(7, 10, std::string(200, 'x')));
  ASSERT_TRUE(writer_->flush().ok());
  Bytes bytes = file();
  std::size_t refused = 0;
  const std::size_t chunk =
      kMagic.size() + kRecordHeadBytes + 4 + 4 + 4 + std::string("playhouse " PLAYHOUSE_VERSION).size();
  for (std::size_t at = chunk + 30; at < chunk + 80; ++at) {
    Bytes changed = bytes;
    changed[at] ^= std::byte{0x10};
    const auto end = read(changed);
    if (end.ok()) continue;
    EXPECT_THAT(end.error().text, testing::AnyOf(HasSubstr("is damaged"), HasSubstr("is packed with")));
    ++refused;
  }
  EXPECT_GT(refused, 40u);
}

TEST_F(Mcap, refuses_what_is_none) {
  EXPECT_THAT(read(bytes_of("playhouse saved run 2\n")).error().text, HasSubstr("is no MCAP file"));
  EXPECT_THAT(read({}).error().text, HasSubstr("is no MCAP file"));
}

TEST_F(Mcap, refuses_lengths_that_pass_a_limit_before_it_takes_memory) {
  Bytes bytes = file();
  Bytes content(28);
  content[16 + 5] = std::byte{0xFF};  // unpacked size
  put_text(content, "zstd");
  content.resize(content.size() + 8);
  put_record(bytes, Op::kChunk, content);
  EXPECT_THAT(read(bytes).error().text, HasSubstr("too many"));
}

TEST_F(Mcap, refuses_a_file_whose_chunks_unpack_to_too_much_for_its_size) {
  constexpr std::uint64_t kBytes = 200u << 20;  // of a chunk: fewer than its limit
  Bytes zeros;
  put_record(zeros, Op::kMessage, Bytes(static_cast<std::size_t>(kBytes - kRecordHeadBytes)));
  Bytes packed(ZSTD_compressBound(zeros.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), zeros.data(), zeros.size(), 1));
  Bytes chunk(16);
  Packer(chunk).u64(kBytes);
  Packer(chunk).u32(0);  // no checksum
  put_text(chunk, "zstd");
  Packer(chunk).u64(packed.size());
  chunk.insert(chunk.end(), packed.begin(), packed.end());
  Bytes bytes;
  for (const std::uint8_t byte : kMagic) bytes.push_back(std::byte{byte});
  put_record(bytes, Op::kChannel, Bytes(2 + 2 + 4 + 4 + 4));  // number 0, of no schema
  for (int i = 0; i < 2; ++i) put_record(bytes, Op::kChunk, chunk);
  EXPECT_TRUE(read(bytes));
  for (int i = 0; i < 2; ++i) put_record(bytes, Op::kChunk, chunk);
  EXPECT_LT(bytes.size(), 200'000u);
  EXPECT_THAT(read(bytes).error().text, HasSubstr("unpacks to more than"));
  // As much of a file that is larger.
  put_record(bytes, Op::kFooter, Bytes(300'000));
  EXPECT_TRUE(read(bytes));
}

TEST_F(Mcap, ends_with_the_listener_s_error) {
  writer_->add(message(7, 10, "one"));
  ASSERT_TRUE(writer_->finish().ok());
  const Bytes bytes = file();
  const MemorySource source(bytes);
  McapReader reader(source);
  const auto end = reader.read({.message = [](const Channel&, const Message&) -> Result<void> {
    return Error{{}, "no"};
  }});
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(end.error().text, "no");
}

TEST(McapWriter, writes_over_recordings_and_over_nothing_else) {
  const TestFolder folder;
  const std::string recording = folder / "a.mcap", world = folder / "a.world";
  std::ofstream(world) << "interval_sim 100\n";
  const auto refused = McapWriter::create(world, "");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().line(), world + ": is there already, and no recording: give another name");
  std::ifstream kept(world);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), "interval_sim 100\n");
  for (int k = 0; k < 2; ++k) {
    auto writer = McapWriter::create(recording, "");
    ASSERT_TRUE(writer) << writer.error().line();
    ASSERT_TRUE((*writer)->finish());
  }
  EXPECT_TRUE(McapWriter::create("/dev/null", ""));
}

TEST(McapWriter, tells_of_a_disk_that_is_full) {
  const auto writer = McapWriter::create("/dev/full", "");
  ASSERT_FALSE(writer.ok());
  EXPECT_THAT(writer.error().line(), HasSubstr("/dev/full: cannot be written: No space left on device"));
}

}  // namespace
}  // namespace playhouse::record
