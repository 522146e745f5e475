#include "playhouse/cluster/step.h"

#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"

namespace playhouse::cluster {
namespace {

void put(Packer& to, std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  to.varint(bytes.size());
  out.insert(out.end(), bytes.begin(), bytes.end());
}

std::span<const std::byte> get(Unpacker& in) {
  const std::uint64_t size = in.varint();
  return in.bytes(static_cast<std::size_t>(size));
}

}  // namespace

void encode(const Step& step, std::vector<std::byte>& out) {
  Packer to(out);
  to.varint(step.share.index);
  to.varint(step.share.count);
  to.u8(step.check);
  put(to, step.state, out);
  put(to, step.changes, out);
}

Result<Step> decode_step(std::span<const std::byte> bytes) {
  const Error wrong{"", "sent an invalid step"};
  Unpacker in(bytes);
  Step step;
  step.share.index = static_cast<std::size_t>(in.varint());
  step.share.count = static_cast<std::size_t>(in.varint());
  const std::uint8_t check = in.u8();
  step.check = check == 1;
  step.state = get(in);
  step.changes = get(in);
  if (!in.ok() || !in.at_end() || check > 1 || step.share.count > limits::kClusterNodes + 1 ||
      step.share.index >= step.share.count)
    return wrong;
  return step;
}

}  // namespace playhouse::cluster
