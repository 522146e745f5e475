#include "playhouse/world/population/serials.h"

#include <algorithm>

namespace playhouse::world {

bool Serials::is_in_gap(ModelId id) const {
  return std::ranges::any_of(gaps_,
                             [&](const Gap& gap) { return gap.begin <= id.value && id.value < gap.end; });
}

bool Serials::add(const Gap& gap) {
  if (gap.begin >= gap.end || (!gaps_.empty() && gap.begin <= gaps_.back().end)) return false;
  gaps_.push_back(gap);
  return true;
}

}  // namespace playhouse::world
