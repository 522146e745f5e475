#pragma once

/// Node: the other side of a Head: repeats its run, and computes a share of each tick. Thread: the caller's.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "playhouse/cluster/step.h"
#include "playhouse/cluster/stream.h"
#include "playhouse/world/engine.h"
#include "playhouse/world/saving/saved_run.h"

namespace playhouse::cluster {

class Node final : private world::Division {
 public:
  /// Makes the engine of a run; it must live until run() has returned.
  using NodeEngineMaker = std::function<Result<world::Engine*>(world::SavedRun)>;

  struct Summary {
    std::uint64_t ticks = 0;
    double from = 0, to = 0;  // simulated time [s]
  };

  /// `patience`: for the head to begin the run. `token`: of the run, if it has one.
  explicit Node(MessageStream stream, std::string token = {}, Seconds patience = kPatience);

  /// Takes part until the run ends. Fails if the head refuses or is gone, or the engine cannot be made.
  Result<Summary> run(const NodeEngineMaker& make);

 private:
  Result<NodeMessage> next(std::optional<Seconds> patience = {});
  Result<bool> join(const NodeEngineMaker& make);
  Result<void> prepare(const Step& step);
  void run(world::DividedWork& work) override;
  Result<void> share(world::DividedWork& work);

  static constexpr Seconds kPatience{60};

  MessageStream stream_;
  std::string token_;
  Seconds patience_;
  world::Engine* engine_ = nullptr;
  world::Share share_;
  std::optional<Hashes> hashes_;  // for the head, at a check
  Result<void> shared_;           // of the present tick
};

}  // namespace playhouse::cluster
