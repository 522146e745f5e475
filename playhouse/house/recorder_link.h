#pragma once

/// RecorderLink: passes a run on to its recorder, without one of the changes if it loses one, and knows when there
/// were how many changes.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "playhouse/record/recorder.h"
#include "playhouse/run/follower.h"

namespace playhouse::house {

class RecorderLink final : public run::Follower {
 public:
  RecorderLink(record::Recorder& recorder, std::function<double()> clock, bool loses)
      : recorder_(recorder), clock_(std::move(clock)), loses_(loses) {}
  void happened(const world::World& world, const world::Event& event) override {
    recorder_.happened(world, event);
  }
  void changed(const world::World& world, std::span<const world::Change> changes) override {
    const auto spawns = [](const world::Change& change) {
      return std::holds_alternative<world::changes::SpawnCopy>(change);
    };
    std::vector<world::Change> kept(changes.begin(), changes.end());
    const auto lost = std::ranges::find_if(kept, spawns);
    if (loses_ && lost != kept.end()) {
      kept.erase(lost);
      loses_ = false;
    }
    changes_ += kept.size();
    counts_.push_back({clock_(), changes_});
    recorder_.changed(world, kept);
  }
  void ticked(const world::World& world) override { recorder_.ticked(world); }

  /// The number of changes up to this time [s].
  std::size_t changes_until(double time) const {
    const auto later = std::ranges::upper_bound(counts_, time, {}, &Count::time);
    return later == counts_.begin() ? 0 : std::prev(later)->changes;
  }

 private:
  struct Count {
    double time;  // s
    std::size_t changes;
  };
  record::Recorder& recorder_;
  const std::function<double()> clock_;
  bool loses_;
  std::size_t changes_ = 0;
  std::vector<Count> counts_;
};

}  // namespace playhouse::house
