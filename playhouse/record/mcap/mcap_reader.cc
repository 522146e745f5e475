#include "playhouse/record/mcap/mcap_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"

namespace playhouse::record {
namespace {

class FileSource final : public ByteSource {
 public:
  FileSource(int file, std::uint64_t size) : file_(file), size_(size) {}
  ~FileSource() override { close(file_); }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  std::uint64_t size() const override { return size_; }
  bool read_at(std::uint64_t offset, std::span<std::byte> out) const override {
    while (!out.empty()) {
      const ssize_t count = pread(file_, out.data(), out.size(), static_cast<off_t>(offset));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      offset += static_cast<std::uint64_t>(count);
      out = out.subspan(static_cast<std::size_t>(count));
    }
    return true;
  }

 private:
  const int file_;
  const std::uint64_t size_;
};

/// Fields of a record, see mcap.h; sticky error.
class Fields {
 public:
  explicit Fields(std::span<const std::byte> bytes) : left_(bytes) {}
  std::uint16_t u16() { return Unpacker(bytes(2)).u16(); }
  std::uint32_t u32() { return Unpacker(bytes(4)).u32(); }
  std::uint64_t u64() { return Unpacker(bytes(8)).u64(); }
  std::span<const std::byte> bytes(std::uint64_t size) {
    if (size > left_.size()) {
      ok_ = false;
      return {};
    }
    const auto found = left_.first(static_cast<std::size_t>(size));
    left_ = left_.subspan(found.size());
    return found;
  }
  std::string text() {
    const std::span<const std::byte> found = bytes(u32());
    return {reinterpret_cast<const char*>(found.data()), found.size()};
  }
  std::span<const std::byte> rest() { return bytes(left_.size()); }
  bool ok() const { return ok_; }

 private:
  std::span<const std::byte> left_;
  bool ok_ = true;
};

std::size_t most_bytes(Op op) {
  return op == Op::kChunk ? limits::kReadChunkBytes : limits::kReadRecordBytes;
}

}  // namespace

Result<std::unique_ptr<ByteSource>> open_source(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    const int code = file < 0 ? errno : S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    if (file >= 0) close(file);
    return Error{escaped(path), "cannot be read: " + std::generic_category().message(code)};
  }
  return std::unique_ptr<ByteSource>(
      std::make_unique<FileSource>(file, static_cast<std::uint64_t>(status.st_size)));
}

Error McapReader::damaged(const std::string& what) const {
  return {{}, fmt::format("is damaged: the record at byte {} {}", at_, what)};
}

Result<McapReader::FileEnd> McapReader::read(const McapListener& listener) {
  std::array<std::byte, kMagic.size()> magic{};
  if (source_->size() < magic.size() || !source_->read_at(0, magic) ||
      !std::ranges::equal(magic, std::as_bytes(std::span(kMagic))))
    return Error{{}, "is not an MCAP file"};
  Bytes content;
  for (at_ = magic.size();;) {
    const std::uint64_t left = source_->size() - at_;
    std::array<std::byte, kRecordHeadBytes> bytes{};
    if (left < bytes.size()) return FileEnd::kCut;
    if (!source_->read_at(at_, bytes)) return Error{{}, "cannot be read"};
    Unpacker head(bytes);
    const auto op = static_cast<Op>(head.u8());
    const std::uint64_t length = head.u64();
    if (op == Op::kDataEnd) return FileEnd::kWhole;
    if (length > left - bytes.size()) return FileEnd::kCut;
    const bool skipped = op != Op::kSchema && op != Op::kChannel && op != Op::kMessage && op != Op::kChunk &&
                         op != Op::kAttachment;
    if (!skipped) {
      if (length > most_bytes(op)) return damaged(fmt::format("has {} bytes, which is too many", length));
      content.resize(static_cast<std::size_t>(length));
      if (!source_->read_at(at_ + bytes.size(), content)) return Error{{}, "cannot be read"};
      if (const Result<void> taken = take(op, content, listener); !taken) return taken.error();
    }
    at_ += bytes.size() + length;
  }
}

Result<void> McapReader::take(Op op, std::span<const std::byte> content, const McapListener& listener) {
  switch (op) {
    case Op::kSchema:
      return take_schema(content);
    case Op::kChannel:
      return take_channel(content);
    case Op::kMessage:
      return take_message(content, listener);
    case Op::kChunk:
      return take_chunk(content, listener);
    case Op::kAttachment:
      return take_attachment(content, listener);
    default:
      return {};
  }
}

Result<void> McapReader::take_chunk(std::span<const std::byte> content, const McapListener& listener) {
  Fields in(content);
  in.u64(), in.u64();
  const std::uint64_t size = in.u64();
  const std::uint32_t checksum = in.u32();
  const std::string compression = in.text();
  const std::span<const std::byte> packed = in.bytes(in.u64());
  if (!in.ok()) return damaged("ends too early");
  if (size > limits::kReadChunkBytes) return damaged(fmt::format("unpacks to {} bytes, too many", size));
  unpacked_ += size;
  if (const std::uint64_t most = room_.most(source_->size()); unpacked_ > most)
    return Error{
        {}, fmt::format("unpacks to more than {} bytes, too many for a file of {}", most, source_->size())};
  Bytes unpacked;
  std::span<const std::byte> records = packed;
  if (compression == "zstd") {
    // Sizes in the chunk and in the zstd frame must agree before allocating.
    const unsigned long long stated = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (stated != ZSTD_CONTENTSIZE_UNKNOWN && stated != size) return damaged("does not unpack");
    unpacked.resize(static_cast<std::size_t>(size));
    const std::size_t got = ZSTD_decompress(unpacked.data(), unpacked.size(), packed.data(), packed.size());
    if (ZSTD_isError(got) != 0 || got != size) return damaged("does not unpack");
    records = unpacked;
  } else if (!compression.empty()) {
    return Error{{},
                 "is packed with " + in_quotes(compression) + "; files of zstd, or not packed, can be read"};
  }
  if (records.size() != size || (checksum != 0 && crc32_of(records) != checksum))
    return damaged("has bytes that are not those that were written");
  while (!records.empty()) {
    Unpacker head(records);
    const auto op = static_cast<Op>(head.u8());
    const std::uint64_t length = head.u64();
    if (!head.ok() || length > head.left()) return damaged("has a record that ends too late");
    if (op != Op::kSchema && op != Op::kChannel && op != Op::kMessage)
      return damaged("has a record that does not belong in a chunk");
    const Result<void> taken =
        take(op, records.subspan(kRecordHeadBytes, static_cast<std::size_t>(length)), listener);
    if (!taken) return taken;
    records = records.subspan(kRecordHeadBytes + static_cast<std::size_t>(length));
  }
  return {};
}

Result<void> McapReader::take_schema(std::span<const std::byte> content) {
  Fields in(content);
  Schema schema;
  schema.id = in.u16();
  schema.name = in.text();
  schema.encoding = in.text();
  schema.text = in.text();
  if (!in.ok() || schema.id == 0) return damaged("is a schema that ends too early or has no number");
  schemas_.try_emplace(schema.id, std::move(schema));
  return {};
}

Result<void> McapReader::take_channel(std::span<const std::byte> content) {
  Fields in(content);
  Channel channel;
  channel.id = in.u16();
  channel.schema = in.u16();
  channel.topic = in.text();
  channel.encoding = in.text();
  if (!in.ok()) return damaged("is a channel that ends too early");
  if (channel.schema != 0 && !schemas_.contains(channel.schema))
    return damaged("is a channel of a schema that is not there");
  channels_.try_emplace(channel.id, std::move(channel));
  return {};
}

Result<void> McapReader::take_message(std::span<const std::byte> content, const McapListener& listener) {
  Fields in(content);
  MessageRecord message;
  message.channel = in.u16();
  message.sequence = in.u32();
  message.log_time = in.u64();
  message.publish_time = in.u64();
  if (!in.ok()) return damaged("is a message that ends too early");
  message.body = in.rest();
  const auto channel = channels_.find(message.channel);
  if (channel == channels_.end()) return damaged("is a message of a channel that is not there");
  return listener.message ? listener.message(channel->second, message) : Result<void>();
}

Result<void> McapReader::take_attachment(std::span<const std::byte> content, const McapListener& listener) {
  if (!listener.attachment) return {};
  Fields in(content);
  Attachment attachment;
  attachment.log_time = in.u64();
  in.u64();
  attachment.name = in.text();
  attachment.media_type = in.text();
  const std::span<const std::byte> body = in.bytes(in.u64());
  const std::uint32_t checksum = in.u32();
  if (!in.ok()) return damaged("is an attachment that ends too early");
  if (checksum != 0 && crc32_of(content.first(content.size() - 4)) != checksum)
    return damaged("has bytes that are not those that were written");
  attachment.body.assign(body.begin(), body.end());
  return listener.attachment(attachment);
}

}  // namespace playhouse::record
