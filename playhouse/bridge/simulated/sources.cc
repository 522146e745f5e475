#include "playhouse/bridge/simulated/sources.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace playhouse::drivers {
namespace {

/// Sources per range: enough work to hand to another thread.
constexpr std::size_t kRange = 64;

}  // namespace

void Sources::add(std::shared_ptr<DataSource> source) {
  all_.push_back(std::move(source));
  if (parts_.size() < ranges()) parts_.emplace_back();
}

std::size_t Sources::ranges() const {
  return (all_.size() + kRange - 1) / kRange;
}

void Sources::emit_range(const world::World& world, std::size_t range) {
  const std::size_t end = std::min(all_.size(), (range + 1) * kRange);
  for (std::size_t i = range * kRange; i < end; ++i) all_[i]->emit(world, parts_[range]);
}

void Sources::join(PublicationBatch& out) {
  std::size_t count = out.size();
  for (const PublicationBatch& part : parts_) count += part.size();
  out.reserve(count);
  for (PublicationBatch& part : parts_) {
    std::ranges::move(part, std::back_inserter(out));
    part.clear();
  }
}

}  // namespace playhouse::drivers
