#pragma once

/// Serial numbers of models. After a rewind or a reset ids go on from the highest that was ever given, so
/// that an id never names two models. What depends on identity by value (streams of random numbers, hashes,
/// addresses of radios) uses the serial number in place of the id: the id that the model would have in a run
/// that was never taken back. So an episode after a reset is, to the bit, the run of a fresh program.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/model_id.h"

namespace playhouse::world {

class Serials {
 public:
  /// Ids begin .. end-1, which models of other branches of the run have.
  struct Gap {
    std::uint32_t begin, end;
    friend bool operator==(const Gap&, const Gap&) = default;
  };

  /// The number of a model of this branch; kNone of none. Cost: the gaps below it, of which there are none
  /// until models are spawned after a rewind or a reset.
  std::uint32_t of(ModelId id) const {
    std::uint32_t skipped = 0;
    for (const Gap& gap : gaps_) {
      if (id.value < gap.end || !id) break;
      skipped += gap.end - gap.begin;
    }
    return id.value - skipped;
  }
  bool is_in_gap(ModelId id) const;

  /// Ascending and apart.
  std::span<const Gap> gaps() const { return gaps_; }
  /// False, and nothing changes: the gap is empty, or not above the others.
  bool add(const Gap& gap);
  void remove_last() { gaps_.pop_back(); }
  void clear() { gaps_.clear(); }

 private:
  std::vector<Gap> gaps_;
};

}  // namespace playhouse::world
