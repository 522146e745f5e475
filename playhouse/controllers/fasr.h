#pragma once

/// fasr and fasr2: foraging robots. They carry flags from a source model to a sink,
/// around static obstacles and sensed ones; when blocked they wander. fasr2 robots
/// have several such tasks and switch between them. See docs/controllers.md.

#include <array>
#include <optional>
#include <string>

#include "playhouse/controllers/steering.h"
#include "playhouse/controllers/ways.h"

namespace playhouse::controllers {

class Fasr final : public BatchOf<Fasr> {
 public:
  /// Meaning of a robot's arguments.
  enum class Arguments : std::uint8_t {
    kEnds,   // source and sink models; default "source" and "sink"
    kTasks,  // prefix of the source's and sink's name of each task: "red" for "red_source",
             // "red_sink"
  };
  Fasr(std::string name, Arguments arguments) : BatchOf(std::move(name)), arguments_(arguments) {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  /// If several robots want the last flag, the lowest id gets it.
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Fasr>;
  static auto memory(auto& self) {
    return std::tuple_cat(Steering::memory(self.steering_),
                          std::tie(self.escaping_, self.speed_, self.turn_, self.choice_));
  }

  /// Source or sink of a task, with the routes to it.
  struct TaskEnd {
    world::ModelId model;
    double reach = 0;     // m, from its origin: range for transferring flags
    world::ModelRow row;  // none: removed
    geom::Vec2 p_W;       // m, goal of the routes
    std::optional<Ways> ways;
  };
  /// A task, for all robots of similar size.
  struct TransportTask {
    TaskEnd source, sink;
    double clearance = 0, height = 0;  // m, of the robots
  };

  /// Transfer of a flag by a robot.
  enum class Exchange : std::uint8_t { kNothing, kTakes, kGives };

  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i);
  void resolve(const world::World& world, std::size_t i) override;
  void prepare(const world::World& world, bool rebuilt) override;
  static void prepare(const world::World& world, bool rebuilt, TransportTask& task);

  /// Names of source and sink for each task of a robot with these arguments.
  std::vector<std::array<std::string, 2>> ends_of(const Post& post) const;
  std::uint32_t task_of(const world::World& world, world::ModelId source, world::ModelId sink,
                        world::ModelRow robot);
  const TransportTask& task(std::size_t i) const {
    return tasks_[choices_[i][choice_[i] % choices_[i].size()]];
  }
  /// Randomly chooses a new task, or the same, for a robot without flags.
  void choose(const world::World& world, std::size_t i);
  /// Goal of a robot with or without a flag; null if it was removed.
  const TaskEnd* goal(std::size_t i, bool loaded) const;
  bool is_there(const world::World& world, std::size_t i, const TaskEnd& end) const;
  /// Follows the route, avoiding sensed obstacles. False if there is no route or it is blocked.
  bool go(world::World& world, std::size_t i, const TaskEnd& end);
  /// Backs off from an obstacle in contact, in a random manner. False if there is none.
  bool escape(world::World& world, std::size_t i);

  Arguments arguments_;
  Steering steering_;
  std::vector<TransportTask> tasks_;

  std::vector<world::ModelRow> model_;
  std::vector<std::vector<std::uint32_t>> choices_;  // rows of tasks_, non-empty
  std::vector<Exchange> exchange_;                   // in this tick

  // Memory.
  std::vector<std::uint32_t> escaping_;  // remaining scans of the manoeuvre
  std::vector<double> speed_, turn_;     // m/s and rad/s of the manoeuvre
  std::vector<std::uint32_t> choice_;    // index of the present task
};

}  // namespace playhouse::controllers
