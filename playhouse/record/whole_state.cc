#include "playhouse/record/whole_state.h"

#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::record {
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
    if (watchers > others || others > limits::kSubscribers) return Error{{}, "a state in it is damaged"};
    models.subscribers[row] = models.controllers[row] + others;
    models.watchers[row] = watchers;
  }
  return {};
}

}  // namespace playhouse::record
