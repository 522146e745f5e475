#include "playhouse/drivers/simulated/sources.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace playhouse::drivers {
namespace {

/// Sources that encode as one: enough to pay for handing them to another thread. Up to as many stay on the
/// tick thread.
constexpr std::size_t kRange = 64;

}  // namespace

void Sources::emit(const world::World& world, world::Workers& workers, Batch& out) {
  const std::size_t ranges = (all_.size() + kRange - 1) / kRange;
  if (ranges <= 1 || workers.count() == 1) {
    out.reserve(out.size() + all_.size());
    for (const std::shared_ptr<Source>& source : all_) source->emit(world, out);
    return;
  }
  if (parts_.size() < ranges) parts_.resize(ranges);
  workers.run(ranges, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t range = begin; range < end; ++range) emit_range(world, range);
  });
  join(ranges, out);
}

void Sources::emit_range(const world::World& world, std::size_t range) {
  const std::size_t end = std::min(all_.size(), (range + 1) * kRange);
  for (std::size_t i = range * kRange; i < end; ++i) all_[i]->emit(world, parts_[range]);
}

void Sources::join(std::size_t ranges, Batch& out) {
  std::size_t count = out.size();
  for (std::size_t range = 0; range < ranges; ++range) count += parts_[range].size();
  out.reserve(count);
  for (std::size_t range = 0; range < ranges; ++range) {
    std::ranges::move(parts_[range], std::back_inserter(out));
    parts_[range].clear();
  }
}

}  // namespace playhouse::drivers
