#pragma once

/// fasr: robots that forage. They take flags from one model and bring them to another, round what stands
/// still and what they see; where nothing is free they wander. See docs/controllers.md.

#include <optional>

#include "playhouse/controllers/steering.h"
#include "playhouse/controllers/ways.h"

namespace playhouse::controllers {

class Fasr final : public BatchOf<Fasr> {
 public:
  Fasr() : BatchOf("fasr") {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  /// Of several robots that want the last flag that of the lowest id gets it.
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Fasr>;
  static auto memory(auto& self) {
    return std::tuple_cat(Steering::memory(self.steering_),
                          std::tie(self.escaping_, self.speed_, self.turn_));
  }

  /// One end of what robots do, and the way there.
  struct End {
    world::ModelId model;
    double reach = 0;     // m, from its origin, in which flags change hands
    world::ModelRow row;  // none: it has gone
    geom::Vec2 p_W;       // m, to where the ways lead
    std::optional<Ways> ways;
  };
  /// Both ends, for all robots of about the same size.
  struct Task {
    End source, sink;
    double clearance = 0, height = 0;  // m, of the robots
  };

  /// What a robot does with a flag.
  enum class Exchange : std::uint8_t { kNothing, kTakes, kGives };

  /// Arguments: the names of the models that flags are taken from and brought to; without them "source" and
  /// "sink".
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i);
  void resolve(const world::World& world, std::size_t i) override;
  void prepare(const world::World& world, bool rebuilt) override;
  static void prepare(const world::World& world, bool rebuilt, Task& task);

  std::uint32_t task_of(const world::World& world, world::ModelId source, world::ModelId sink,
                        world::ModelRow robot);
  /// Where a robot that carries a flag, or none, goes; null where an end has gone.
  const End* goal(std::size_t i, bool loaded) const;
  bool is_there(const world::World& world, std::size_t i, const End& end) const;
  /// Drives along the way there, round what the robot sees. False: there is none, or it is not free.
  bool go(world::World& world, std::size_t i, const End& end);
  /// Gets away, one way or another, from what the robot stands against. False: it stands against nothing.
  bool escape(world::World& world, std::size_t i);

  Steering steering_;
  std::vector<Task> tasks_;

  std::vector<world::ModelRow> model_;
  std::vector<std::uint32_t> task_;  // row of tasks_
  std::vector<Exchange> exchange_;   // in this tick

  // Memory.
  std::vector<std::uint32_t> escaping_;  // scans for which it still gets away
  std::vector<double> speed_, turn_;     // m/s and rad/s, meanwhile
};

}  // namespace playhouse::controllers
