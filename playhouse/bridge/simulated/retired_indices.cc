#include "playhouse/bridge/simulated/retired_indices.h"

#include <algorithm>

#include "playhouse/base/assert.h"

namespace playhouse::drivers {

void RetiredIndices::hold(std::size_t index) {
  const auto [found, is_new] = places_.try_emplace(index);
  if (!is_new && found->second.holders == 0) order_.erase(found->second.number);  // its model came back
  ++found->second.holders;
}

void RetiredIndices::release(std::size_t index, double time) {
  const auto found = places_.find(index);
  PLAYHOUSE_ASSERT(found != places_.end() && found->second.holders > 0);
  if (--found->second.holders > 0) return;
  found->second.number = next_number_++;
  order_.emplace_hint(order_.end(), found->second.number, Retired{index, time});
}

std::optional<std::size_t> RetiredIndices::take(double time) {
  if (order_.empty() || order_.begin()->second.time + kRest > time) return std::nullopt;
  const std::size_t index = order_.begin()->second.index;
  order_.erase(order_.begin());
  places_.erase(index);
  return index;
}

void RetiredIndices::rewind_to(double time) {
  for (auto& [number, retired] : order_) retired.time = std::min(retired.time, time);
}

}  // namespace playhouse::drivers
