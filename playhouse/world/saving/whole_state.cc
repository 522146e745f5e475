#include "playhouse/world/saving/whole_state.h"

#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::world {
namespace {

constexpr std::size_t kSizeBytes = 8;

}  // namespace

Result<void> save_whole(const World& world, std::vector<std::byte>& out) {
  const std::size_t start = out.size();
  Packer to(out);
  to.u64(0);
  if (const Result<void> saved = save_state(world, out); !saved) return saved;
  const std::uint64_t size = out.size() - start - kSizeBytes;
  for (std::size_t i = 0; i < kSizeBytes; ++i) out[start + i] = static_cast<std::byte>(size >> (8 * i));
  const Models& models = world.models;
  for (const ModelRow row : models.rows()) {
    to.u32(models.subscribers[row] - models.controllers[row]);
    to.u32(models.watchers[row]);
  }
  for (const CameraRow row : world.cameras.rows()) to.u8(world.cameras.stereo_open[row]);
  return {};
}

std::span<const std::byte> state_of(std::span<const std::byte> whole) {
  Unpacker in(whole);
  const std::uint64_t size = in.u64();
  if (!in.ok() || size > in.left()) return {};
  return whole.subspan(kSizeBytes, static_cast<std::size_t>(size));
}

Result<void> load_whole(World& world, std::span<const std::byte> whole) {
  const std::span<const std::byte> state = state_of(whole);
  if (state.size() < sizeof(std::uint64_t)) return Error{{}, "is damaged: it ends too early"};
  const Result<void> loaded = load_state(world, state, Unpacker(state).u64());
  if (!loaded) return loaded;
  Models& models = world.models;
  Unpacker users(whole.subspan(kSizeBytes + state.size()));
  if (users.left() != models.size() * 8 + world.cameras.size())
    return Error{{}, "is damaged: its models lack subscriptions"};
  for (const ModelRow row : models.rows()) {
    const std::uint32_t others = users.u32(), watchers = users.u32();
    if (watchers > others || others > limits::kSubscribers)
      return Error{{}, "is damaged: a model has more subscriptions than are possible"};
    models.subscribers[row] = models.controllers[row] + others;
    models.watchers[row] = watchers;
  }
  for (const CameraRow row : world.cameras.rows()) world.cameras.stereo_open[row] = users.u8() != 0;
  return {};
}

}  // namespace playhouse::world
