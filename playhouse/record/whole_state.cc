#include "playhouse/record/whole_state.h"

#include <algorithm>
#include <cstring>

#include "playhouse/base/hash.h"
#include "playhouse/base/packing.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::record {
namespace {

constexpr std::uint8_t kAll = 0, kRuns = 1;

/// Equal bytes between two changes that are merged into one run: a run header is as large.
constexpr std::size_t kGap = 4;

/// Bound on subscribers of a model: far more than sessions and viewers, without overflow of sums.
constexpr std::uint32_t kUsersMost = 1u << 30;

Error damaged() {
  return {{}, "a change in it is damaged"};
}

}  // namespace

Result<void> save_whole(const world::World& world, Bytes& out) {
  const std::size_t start = out.size();
  Packer to(out);
  to.u64(0);
  if (const Result<void> saved = world::save_state(world, out); !saved) return saved;
  const std::uint64_t size = out.size() - start - 8;
  for (int i = 0; i < 8; ++i) out[start + i] = static_cast<std::byte>(size >> (8 * i));
  const world::Models& models = world.models;
  for (std::size_t row = 0; row < models.size(); ++row) {
    to.u32(models.subscribers[row] - models.controllers[row]);
    to.u32(models.watchers[row]);
  }
  return {};
}

Result<void> load_whole(world::World& world, std::span<const std::byte> bytes) {
  Unpacker in(bytes);
  const std::uint64_t size = in.u64();
  if (!in.ok() || size > in.left() || size < 8) return Error{{}, "a state in it is damaged"};
  const std::span<const std::byte> state = bytes.subspan(8, static_cast<std::size_t>(size));
  const Result<void> loaded = world::load_state(world, state, Unpacker(state).u64());
  if (!loaded) return loaded;
  world::Models& models = world.models;
  Unpacker users(bytes.subspan(8 + state.size()));
  if (users.left() != models.size() * 8) return Error{{}, "a state in it is damaged"};
  for (std::size_t row = 0; row < models.size(); ++row) {
    const std::uint32_t others = users.u32(), watchers = users.u32();
    if (watchers > others || others > kUsersMost) return Error{{}, "a state in it is damaged"};
    models.subscribers[row] = models.controllers[row] + others;
    models.watchers[row] = watchers;
  }
  return {};
}

Bytes difference(std::span<const std::byte> before, std::span<const std::byte> after) {
  Bytes out;
  Packer to(out);
  if (before.size() != after.size()) {
    to.u8(kAll);
    put_bytes(out, after);
    return out;
  }
  to.u8(kRuns);
  std::size_t done = 0;
  for (std::size_t at = 0;;) {
    const auto [differs, ignored] = std::mismatch(after.begin() + at, after.end(), before.begin() + at);
    const auto begin = static_cast<std::size_t>(differs - after.begin());
    if (begin == after.size()) return out;
    std::size_t end = begin + 1;
    for (std::size_t i = end; i < after.size() && i < end + kGap; ++i)
      if (after[i] != before[i]) end = i + 1;
    to.varint(begin - done);
    to.varint(end - begin);
    put_bytes(out, after.subspan(begin, end - begin));
    done = at = end;
  }
}

Result<Bytes> patched(std::span<const std::byte> before, std::span<const std::byte> difference) {
  if (difference.empty()) return damaged();
  if (difference[0] == std::byte{kAll}) return Bytes(difference.begin() + 1, difference.end());
  Unpacker in(difference.subspan(1));
  Bytes after(before.begin(), before.end());
  for (std::size_t done = 0; !in.at_end();) {
    const std::uint64_t skip = in.varint(), count = in.varint();
    if (!in.ok() || count > in.left() || skip > after.size() - done || count > after.size() - done - skip)
      return damaged();
    done += static_cast<std::size_t>(skip);
    for (std::uint64_t i = 0; i < count; ++i) after[done++] = static_cast<std::byte>(in.u8());
  }
  return after;
}

std::uint64_t hash_of(std::span<const std::byte> state) {
  Hash hash;
  hash.add(std::uint64_t{state.size()});
  for (std::size_t at = 0; at < state.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, state.data() + at, std::min<std::size_t>(8, state.size() - at));
    hash.add(word);
  }
  return hash.value();
}

}  // namespace playhouse::record
