#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/base/version.h"
#include "playhouse/record/csv.h"
#include "playhouse/record/mcap/mcap_reader.h"
#include "playhouse/record/mcap/mcap_writer.h"
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
  put(out, MessageRecord{channel, 0, time, time, bytes});
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

  Result<McapReader::FileEnd> read(const Bytes& bytes, const UnpackedRoom& room = {}) {
    said_.clear();
    const MemorySource source(bytes);
    McapReader reader(source, room);
    return reader.read({.message = [&](const Channel& channel, const MessageRecord& heard) -> Result<void> {
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
  EXPECT_EQ(*end, McapReader::FileEnd::kWhole);
  EXPECT_THAT(said_, ElementsAre("world = a world", "/words one", "/words two"));
}

TEST_F(Mcap, that_is_not_finished_reads_up_to_its_last_flush) {
  writer_->add(message(7, 10, "one"));
  ASSERT_TRUE(writer_->flush().ok());
  writer_->add(message(7, 20, "two"));
  const auto end = read(file());
  ASSERT_TRUE(end.ok()) << end.error().line();
  EXPECT_EQ(*end, McapReader::FileEnd::kCut);
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
      kMagic.size() + kRecordHeadBytes + 4 + 4 + 4 + std::string("playhouse ").size() + build().size();
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
  EXPECT_THAT(read(bytes_of("playhouse saved run 2\n")).error().text, HasSubstr("is not an MCAP file"));
  EXPECT_THAT(read({}).error().text, HasSubstr("is not an MCAP file"));
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
  constexpr UnpackedRoom kRoom{.bytes = 5u << 20, .bytes_each = 16};
  constexpr std::uint64_t kBytes = 2u << 20;  // of a chunk
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
  EXPECT_TRUE(read(bytes, kRoom));
  for (int i = 0; i < 2; ++i) put_record(bytes, Op::kChunk, chunk);
  EXPECT_LT(bytes.size(), 4'000u);
  EXPECT_TRUE(read(bytes));
  EXPECT_THAT(read(bytes, kRoom).error().text, HasSubstr("unpacks to more than"));
  // As much of a file that is larger.
  put_record(bytes, Op::kFooter, Bytes((3u << 20) / 16));
  EXPECT_TRUE(read(bytes, kRoom));
  EXPECT_EQ(UnpackedRoom().most(0), std::uint64_t{2} << 30);
  EXPECT_EQ(UnpackedRoom().most(1u << 20), std::uint64_t{3} << 30);
}

TEST_F(Mcap, of_images_that_pack_to_nothing_is_as_large_as_readers_ask) {
  constexpr UnpackedRoom kRoom{.bytes = 256u << 10, .bytes_each = 64};
  constexpr int kFrames = 60;
  const auto written = [&](const UnpackedRoom& room, std::vector<std::uint64_t>& after_flush) {
    writer_ = *McapWriter::create(path_, "test", room);
    Bytes records;
    put(records, Channel{7, 0, "/image", "cdr"});
    writer_->add(records);
    for (int frame = 0; frame < kFrames; ++frame) {
      writer_->add(message(7, 10 + static_cast<std::uint64_t>(frame), std::string(64u << 10, '\0')));
      EXPECT_TRUE(writer_->flush());
      after_flush.push_back(std::filesystem::file_size(path_));
    }
    EXPECT_TRUE(writer_->attach({5, "world", "text/plain", bytes_of("a world")}));
    EXPECT_TRUE(writer_->finish());
    return file();
  };
  std::vector<std::uint64_t> ends;
  EXPECT_THAT(read(written({}, ends), kRoom).error().text, HasSubstr("unpacks to more than"))
      << "without filler";
  ends.clear();
  const Bytes whole = written(kRoom, ends);
  const auto end = read(whole, kRoom);
  ASSERT_TRUE(end) << end.error().line();
  EXPECT_EQ(*end, McapReader::FileEnd::kWhole);
  EXPECT_EQ(said_.size(), kFrames + 1u);
  // Twice 3.75 MiB, less what is free, by 64; and the summary.
  EXPECT_GT(whole.size(), 118'000u);
  EXPECT_LT(whole.size(), 140'000u);
  // Cut within the last filler or just before it.
  for (std::size_t frame = 0; frame < ends.size(); ++frame) {
    const std::uint64_t before = frame == 0 ? 0 : ends[frame - 1];
    for (const std::uint64_t size : {ends[frame], ends[frame] - 1, (before + ends[frame]) / 2}) {
      const auto cut = read(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), kRoom);
      ASSERT_TRUE(cut) << frame << ": " << cut.error().line();
      EXPECT_GE(said_.size(), frame);
    }
  }
  // The summary has the chunks where they are.
  Unpacker footer(std::span(whole).last(kMagic.size() + 20));
  std::size_t chunks = 0;
  for (std::size_t at = static_cast<std::size_t>(footer.u64()); at < whole.size() - kMagic.size();) {
    Unpacker record(std::span(whole).subspan(at));
    const auto op = static_cast<Op>(record.u8());
    const std::uint64_t length = record.u64();
    at += kRecordHeadBytes + static_cast<std::size_t>(length);
    if (op != Op::kChunkIndex) continue;
    record.u64(), record.u64();
    const std::uint64_t offset = record.u64(), bytes = record.u64();
    ASSERT_LT(offset + bytes, whole.size());
    Unpacker chunk(std::span(whole).subspan(static_cast<std::size_t>(offset)));
    EXPECT_EQ(static_cast<Op>(chunk.u8()), Op::kChunk);
    EXPECT_EQ(chunk.u64() + kRecordHeadBytes, bytes);
    // Its index follows.
    EXPECT_EQ(whole[static_cast<std::size_t>(offset + bytes)], static_cast<std::byte>(Op::kMessageIndex));
    ++chunks;
  }
  EXPECT_EQ(chunks, static_cast<std::size_t>(kFrames));
}

/// A channel with one message of zeros.
Bytes zeros_of(std::uint16_t channel, const std::string& topic, std::size_t size) {
  Bytes records;
  put(records, Channel{channel, 2, topic, "cdr"});
  put_bytes(records, message(channel, 10, std::string("\0\1\0\0", 4) + std::string(size, '\0')));
  return records;
}

TEST_F(Mcap, has_tables_up_to_a_limit_on_their_fields_together) {
  // 4 fields in 4 messages in 4 ...: 1,024 of them by a few lines, and more than 11,000 letters.
  std::string schema;
  for (int level = 0; level < 5; ++level) {
    if (level > 0) schema += fmt::format("===\nMSG: p/L{}\n", level);
    for (const char name : {'a', 'b', 'c', 'd'})
      schema += (level < 4 ? fmt::format("p/L{} ", level + 1) : "uint8 ") + name + "\n";
  }
  constexpr std::uint16_t kChannels = 20;
  Bytes records;
  put(records, Schema{2, "p/L0", "ros2msg", schema});
  for (std::uint16_t k = 0; k < kChannels; ++k)
    put_bytes(records, zeros_of(static_cast<std::uint16_t>(100 + k), fmt::format("/t{}", k), 1024));
  writer_->add(records);
  ASSERT_TRUE(writer_->finish());
  const Bytes bytes = file();
  const MemorySource source(bytes);
  const Result<CsvTables> all = write_csv(source, folder_ / "all");
  ASSERT_TRUE(all) << all.error().line();
  EXPECT_EQ(all->tables, kChannels);
  EXPECT_EQ(all->rows, kChannels);
  EXPECT_THAT(all->left_out, testing::IsEmpty());
  const Result<CsvTables> some = write_csv(source, folder_ / "some", 10'000);
  ASSERT_TRUE(some) << some.error().line();
  EXPECT_GT(some->tables, 5u);
  EXPECT_LT(some->tables, 9u);  // fewer than 10,000 / 1,024: the type, and the letters
  EXPECT_EQ(some->rows, some->tables);
  ASSERT_EQ(some->tables + some->left_out.size(), kChannels);
  EXPECT_EQ(some->left_out.back(), "channel \"/t19\": the recording has too many fields");
  std::ifstream table(folder_ / "some/t0.csv");
  std::string head;
  EXPECT_TRUE(std::getline(table, head));
  EXPECT_TRUE(head.starts_with("time,a.a.a.a.a,a.a.a.a.b,")) << head.substr(0, 50);
}

TEST_F(Mcap, has_tables_of_different_names_whatever_its_topics_are_called) {
  Bytes records;
  put(records, Schema{2, "One", "ros2msg", "uint8 one"});
  const std::pair<std::uint16_t, const char*> channels[] = {{3, "/a/5"}, {4, "/a"}, {5, "/a"}, {6, "/a/5/5"}};
  for (const auto& [channel, topic] : channels) put_bytes(records, zeros_of(channel, topic, 1));
  writer_->add(records);
  ASSERT_TRUE(writer_->finish());
  const Bytes bytes = file();
  const MemorySource source(bytes);
  const Result<CsvTables> written = write_csv(source, folder_ / "tables");
  ASSERT_TRUE(written) << written.error().line();
  EXPECT_EQ(written->tables, 4u);
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "tables")) {
    names.push_back(entry.path().filename());
    std::ifstream in(entry.path());
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "time,one\n1e-08,0\n");
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("a.5.csv", "a.csv", "a.5.5.csv", "a.5.5.6.csv"));
}

TEST_F(Mcap, ends_with_the_listener_s_error) {
  writer_->add(message(7, 10, "one"));
  ASSERT_TRUE(writer_->finish().ok());
  const Bytes bytes = file();
  const MemorySource source(bytes);
  McapReader reader(source);
  const auto end = reader.read({.message = [](const Channel&, const MessageRecord&) -> Result<void> {
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
  EXPECT_EQ(refused.error().line(), world + ": is there already, and is not a recording: give another name");
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
