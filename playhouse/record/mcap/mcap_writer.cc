#include "playhouse/record/mcap/mcap_writer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/packing.h"
#include "playhouse/base/version.h"
#include "playhouse/record/mcap/packed_bytes.h"

namespace playhouse::record {
namespace {

constexpr std::string_view kCompression = "zstd";

/// Of a chunk up to its compression name: times, size, checksum.
constexpr std::size_t kChunkHeadBytes = 28;

}  // namespace

/// Chunk data for the summary.
struct McapWriter::Written {
  std::uint64_t from = 0, to = 0;  // ns
  std::uint64_t offset = 0, bytes = 0;
  std::uint64_t packed = 0, unpacked = 0;
  std::uint64_t index_bytes = 0;
  std::vector<std::pair<std::uint16_t, std::uint64_t>> indices;  // channel, offset of its index
};

Result<std::unique_ptr<McapWriter>> McapWriter::create(const std::string& path, const std::string& profile,
                                                       const UnpackedRoom& room) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return Error{escaped(path), "cannot be written: " + std::generic_category().message(errno)};
  std::unique_ptr<McapWriter> writer(new McapWriter(path, file, room));
  if (const Result<void> emptied = writer->empty(); !emptied) return emptied.error();
  Bytes head, content;
  put_bytes(head, std::as_bytes(std::span(kMagic)));
  put_text(content, profile);
  put_text(content, "playhouse " + std::string(build()));
  put_record(head, Op::kHeader, content);
  if (const Result<void> written = writer->write(head); !written) return written.error();
  return writer;
}

McapWriter::McapWriter(std::string path, int file, const UnpackedRoom& room)
    : path_(std::move(path)), file_(file), room_(room) {}

McapWriter::~McapWriter() {
  close(file_);
}

/// Overwrites older recordings, but no other files: the name may be a mistake.
Result<void> McapWriter::empty() {
  struct stat status;
  if (fstat(file_, &status) != 0) return fault(errno);
  if (!S_ISREG(status.st_mode)) return {};
  std::array<std::uint8_t, kMagic.size()> begin{};
  const ssize_t size = pread(file_, begin.data(), begin.size(), 0);
  if (size < 0) return fault(errno);
  if (!std::equal(begin.begin(), begin.begin() + size, kMagic.begin()))
    return Error{escaped(path_), "is there already, and is not a recording: give another name"};
  if (ftruncate(file_, 0) != 0) return fault(errno);
  return {};
}

Error McapWriter::fault(int code) const {
  return {escaped(path_), "cannot be written: " + std::generic_category().message(code)};
}

Result<void> McapWriter::write(std::span<const std::byte> bytes) {
  if (failed_) return fault(EIO);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int code = count < 0 ? errno : ENOSPC;
      failed_ = true;
      // Truncates the partial record; if that fails, readers stop before it.
      [[maybe_unused]] const int whole = ftruncate(file_, static_cast<off_t>(size_));
      return fault(code);
    }
    done += static_cast<std::size_t>(count);
  }
  size_ += bytes.size();
  return {};
}

void McapWriter::add(std::span<const std::byte> records) {
  for (std::size_t at = 0; at < records.size();) {
    Unpacker head(records.subspan(at));
    const auto op = static_cast<Op>(head.u8());
    const std::uint64_t length = head.u64();
    PLAYHOUSE_ASSERT(head.ok() && length <= head.left());
    const std::span<const std::byte> record = records.subspan(at, kRecordHeadBytes + length);
    if (op == Op::kSchema) {
      put_bytes(schemas_, record);
      ++schema_count_;
    } else if (op == Op::kChannel) {
      put_bytes(channels_, record);
      ++channel_count_;
    } else {
      PLAYHOUSE_ASSERT(op == Op::kMessage);
      const std::uint16_t channel = head.u16();
      head.u32();
      const std::uint64_t time = head.u64();
      chunk_from_ = index_.empty() ? time : std::min(chunk_from_, time);
      chunk_to_ = index_.empty() ? time : std::max(chunk_to_, time);
      index_[channel].push_back({time, chunk_.size() + at});
      from_ = messages_ == 0 ? time : std::min(from_, time);
      to_ = std::max(to_, time);
      ++counts_[channel];
      ++messages_;
    }
    at += record.size();
  }
  put_bytes(chunk_, records);
}

Result<void> McapWriter::flush() {
  if (chunk_.empty()) return {};
  Bytes out, content;
  Packer to(content);
  to.u64(chunk_from_);
  to.u64(chunk_to_);
  to.u64(chunk_.size());
  to.u32(crc32_of(chunk_));
  put_text(content, kCompression);
  const Bytes records = packed(chunk_);
  to.u64(records.size());
  put_bytes(content, records);
  put_record(out, Op::kChunk, content);
  for (const auto& [channel, entries] : index_) {
    Bytes index;
    Packer into(index);
    into.u16(channel);
    into.u32(static_cast<std::uint32_t>(entries.size() * 16));
    for (const MessageIndexEntry& entry : entries) {
      into.u64(entry.time);
      into.u64(entry.offset);
    }
    put_record(out, Op::kMessageIndex, index);
  }
  unpacked_ += chunk_.size();
  if (const std::uint64_t filler = room_.filler(size_ + out.size(), unpacked_); filler > 0)
    put_record(out, Op::kFiller, Bytes(static_cast<std::size_t>(filler)));
  chunk_.clear();
  index_.clear();
  chunk_from_ = chunk_to_ = 0;
  return write(out);
}

Result<void> McapWriter::attach(const Attachment& attachment) {
  if (const Result<void> flushed = flush(); !flushed) return flushed;
  Bytes out;
  put(out, attachment);
  attachments_.push_back({size_, out.size(), attachment.log_time, attachment.body.size(), attachment.name,
                          attachment.media_type});
  return write(out);
}

Result<void> McapWriter::finish() {
  if (const Result<void> flushed = flush(); !flushed) return flushed;
  Bytes out, content;
  Packer(content).u32(0);  // no checksum of all data: chunks have their own
  put_record(out, Op::kDataEnd, content);
  if (const Result<void> written = write(out); !written) return written;
  return write_summary();
}

/// Summary: groups of records of one kind, then their offsets.
/// Without a checksum, since it is written chunk by chunk.
Result<void> McapWriter::write_summary() {
  struct Group {
    Op op;
    std::uint64_t start, length;
  };
  std::vector<Group> groups;
  const std::uint64_t start = size_;
  const auto add = [&](Op op, const Bytes& records) -> Result<void> {
    if (records.empty()) return {};
    groups.push_back({op, size_, records.size()});
    return write(records);
  };
  Result<void> written = add(Op::kSchema, schemas_);
  if (written) written = add(Op::kChannel, channels_);
  if (!written) return written;
  const std::uint64_t chunks_start = size_;
  const Result<std::uint64_t> chunks = write_chunk_indices();
  if (!chunks) return chunks.error();
  if (*chunks > 0) groups.push_back({Op::kChunkIndex, chunks_start, size_ - chunks_start});
  Bytes attachments;
  for (const AttachmentEntry& entry : attachments_) {
    Bytes content;
    Packer to(content);
    for (const std::uint64_t number : {entry.offset, entry.length, entry.time, entry.time, entry.data_size})
      to.u64(number);
    put_text(content, entry.name);
    put_text(content, entry.media_type);
    put_record(attachments, Op::kAttachmentIndex, content);
  }
  written = add(Op::kAttachmentIndex, attachments);
  if (written) written = add(Op::kStatistics, statistics(*chunks));
  if (!written) return written;

  Bytes end;
  const std::uint64_t offsets_start = size_;
  for (const Group& group : groups) {
    Bytes content;
    Packer to(content);
    to.u8(static_cast<std::uint8_t>(group.op));
    to.u64(group.start);
    to.u64(group.length);
    put_record(end, Op::kSummaryOffset, content);
  }
  Bytes content;
  Packer to(content);
  to.u64(start);
  to.u64(offsets_start);
  to.u32(0);
  put_record(end, Op::kFooter, content);
  put_bytes(end, std::as_bytes(std::span(kMagic)));
  return write(end);
}

bool McapWriter::read_at(std::uint64_t offset, std::span<std::byte> out) const {
  while (!out.empty()) {
    const ssize_t count = pread(file_, out.data(), out.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    offset += static_cast<std::uint64_t>(count);
    out = out.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

/// Reads the next chunk header from `offset` on, with its indices,
/// and advances `offset` past them. False: no more chunks.
Result<bool> McapWriter::read_chunk(std::uint64_t& offset, Written& chunk) const {
  bool found = false;
  chunk = {};
  for (;;) {
    std::array<std::byte, kRecordHeadBytes + kChunkHeadBytes> bytes{};
    if (!read_at(offset, std::span(bytes).first(kRecordHeadBytes))) return fault(EIO);
    Unpacker head(bytes);
    const auto op = static_cast<Op>(head.u8());
    const std::uint64_t length = head.u64();
    if (op == Op::kDataEnd || (found && op != Op::kMessageIndex)) return found;
    if (op == Op::kChunk || op == Op::kMessageIndex) {
      const std::size_t rest = op == Op::kChunk ? kChunkHeadBytes : 2;
      if (!read_at(offset + kRecordHeadBytes, std::span(bytes).subspan(kRecordHeadBytes, rest)))
        return fault(EIO);
    }
    if (op == Op::kChunk) {
      found = true;
      chunk.offset = offset;
      chunk.bytes = kRecordHeadBytes + length;
      chunk.from = head.u64();
      chunk.to = head.u64();
      chunk.unpacked = head.u64();
      chunk.packed = length - kChunkHeadBytes - 4 - kCompression.size() - 8;
    } else if (op == Op::kMessageIndex) {
      chunk.indices.emplace_back(head.u16(), offset);
      chunk.index_bytes += kRecordHeadBytes + length;
    }
    offset += kRecordHeadBytes + length;
  }
}

Result<std::uint64_t> McapWriter::write_chunk_indices() {
  std::uint64_t count = 0;
  Written chunk;
  Bytes out;
  for (std::uint64_t offset = kMagic.size();; ++count) {
    const Result<bool> found = read_chunk(offset, chunk);
    if (!found) return found.error();
    if (!*found) break;
    Bytes content;
    Packer to(content);
    for (const std::uint64_t number : {chunk.from, chunk.to, chunk.offset, chunk.bytes}) to.u64(number);
    to.u32(static_cast<std::uint32_t>(chunk.indices.size() * 10));
    for (const auto& [channel, at] : chunk.indices) {
      to.u16(channel);
      to.u64(at);
    }
    to.u64(chunk.index_bytes);
    put_text(content, kCompression);
    to.u64(chunk.packed);
    to.u64(chunk.unpacked);
    out.clear();
    put_record(out, Op::kChunkIndex, content);
    if (const Result<void> written = write(out); !written) return written.error();
  }
  return count;
}

Bytes McapWriter::statistics(std::uint64_t chunks) const {
  Bytes out, content;
  Packer to(content);
  to.u64(messages_);
  to.u16(schema_count_);
  to.u32(channel_count_);
  to.u32(static_cast<std::uint32_t>(attachments_.size()));
  to.u32(0);  // metadata: none
  to.u32(static_cast<std::uint32_t>(chunks));
  to.u64(from_);
  to.u64(to_);
  to.u32(static_cast<std::uint32_t>(counts_.size() * 10));
  for (const auto& [channel, count] : counts_) {
    to.u16(channel);
    to.u64(count);
  }
  put_record(out, Op::kStatistics, content);
  return out;
}

}  // namespace playhouse::record
