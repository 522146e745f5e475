#include "playhouse/record/mcap/mcap.h"

#include <zlib.h>

#include "playhouse/base/packing.h"

namespace playhouse::record {

void put_bytes(Bytes& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void put_text(Bytes& out, std::string_view text) {
  Packer(out).u32(static_cast<std::uint32_t>(text.size()));
  put_bytes(out, std::as_bytes(std::span(text)));
}

void put_record(Bytes& out, Op op, std::span<const std::byte> content) {
  Packer to(out);
  to.u8(static_cast<std::uint8_t>(op));
  to.u64(content.size());
  put_bytes(out, content);
}

void put(Bytes& out, const Schema& schema) {
  Bytes content;
  Packer(content).u16(schema.id);
  put_text(content, schema.name);
  put_text(content, schema.encoding);
  put_text(content, schema.text);
  put_record(out, Op::kSchema, content);
}

void put(Bytes& out, const Channel& channel) {
  Bytes content;
  Packer to(content);
  to.u16(channel.id);
  to.u16(channel.schema);
  put_text(content, channel.topic);
  put_text(content, channel.encoding);
  to.u32(0);  // metadata: none
  put_record(out, Op::kChannel, content);
}

void put(Bytes& out, const MessageRecord& message) {
  Packer to(out);
  to.u8(static_cast<std::uint8_t>(Op::kMessage));
  to.u64(22 + message.body.size());
  to.u16(message.channel);
  to.u32(message.sequence);
  to.u64(message.log_time);
  to.u64(message.publish_time);
  put_bytes(out, message.body);
}

void put(Bytes& out, const Attachment& attachment) {
  Bytes content;
  Packer to(content);
  to.u64(attachment.log_time);
  to.u64(attachment.log_time);
  put_text(content, attachment.name);
  put_text(content, attachment.media_type);
  to.u64(attachment.body.size());
  put_bytes(content, attachment.body);
  to.u32(crc32_of(content));
  put_record(out, Op::kAttachment, content);
}

std::uint32_t crc32_of(std::span<const std::byte> bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace playhouse::record
