#pragma once

/// RecorderLink: passes a run on to its recorder, without one of the changes if it loses one.

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include "playhouse/record/recorder.h"
#include "playhouse/run/follower.h"

namespace playhouse::house {

class RecorderLink final : public run::Follower {
 public:
  RecorderLink(record::Recorder& recorder, bool loses) : recorder_(recorder), loses_(loses) {}
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
    recorder_.changed(world, kept);
  }
  void ticked(const world::World& world) override { recorder_.ticked(world); }

 private:
  record::Recorder& recorder_;
  bool loses_;
};

}  // namespace playhouse::house
