#pragma once

/// fasr and fasr2: robots that forage. They take flags from one model and bring them to another, round what
/// stands still and what they see; where nothing is free they wander. Those of fasr2 have several such tasks
/// and change between them. See docs/controllers.md.

#include <array>
#include <optional>
#include <string>

#include "playhouse/controllers/steering.h"
#include "playhouse/controllers/ways.h"

namespace playhouse::controllers {

class Fasr final : public BatchOf<Fasr> {
 public:
  /// What the arguments of a robot name.
  enum class Arguments : std::uint8_t {
    kEnds,   // the models that flags are taken from and brought to; without them "source" and "sink"
    kTasks,  // of each task the word with which the names of its ends begin: "red" for "red_source",
             // "red_sink"
  };
  Fasr(std::string name, Arguments arguments) : BatchOf(std::move(name)), arguments_(arguments) {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  /// Of several robots that want the last flag that of the lowest id gets it.
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Fasr>;
  static auto memory(auto& self) {
    return std::tuple_cat(Steering::memory(self.steering_),
                          std::tie(self.escaping_, self.speed_, self.turn_, self.choice_));
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

  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i);
  void resolve(const world::World& world, std::size_t i) override;
  void prepare(const world::World& world, bool rebuilt) override;
  static void prepare(const world::World& world, bool rebuilt, Task& task);

  /// The names of the ends of each task of a robot with these arguments.
  std::vector<std::array<std::string, 2>> ends_of(const Post& post) const;
  std::uint32_t task_of(const world::World& world, world::ModelId source, world::ModelId sink,
                        world::ModelRow robot);
  const Task& task(std::size_t i) const { return tasks_[choices_[i][choice_[i] % choices_[i].size()]]; }
  /// Now and then a robot that carries nothing takes up another task, or the same.
  void choose(const world::World& world, std::size_t i);
  /// Where a robot that carries a flag, or none, goes; null where an end has gone.
  const End* goal(std::size_t i, bool loaded) const;
  bool is_there(const world::World& world, std::size_t i, const End& end) const;
  /// Drives along the way there, round what the robot sees. False: there is none, or it is not free.
  bool go(world::World& world, std::size_t i, const End& end);
  /// Gets away, one way or another, from what the robot stands against. False: it stands against nothing.
  bool escape(world::World& world, std::size_t i);

  Arguments arguments_;
  Steering steering_;
  std::vector<Task> tasks_;

  std::vector<world::ModelRow> model_;
  std::vector<std::vector<std::uint32_t>> choices_;  // rows of tasks_, one at least
  std::vector<Exchange> exchange_;                   // in this tick

  // Memory.
  std::vector<std::uint32_t> escaping_;  // scans for which it still gets away
  std::vector<double> speed_, turn_;     // m/s and rad/s, meanwhile
  std::vector<std::uint32_t> choice_;    // which of its choices it follows
};

}  // namespace playhouse::controllers
