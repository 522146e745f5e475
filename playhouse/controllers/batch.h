#pragma once

/// Batch: all robots that run one kind of controller, and the common code of
/// batches to find parts of robots. Made and filled by attach(); follow() adds
/// robots spawned later and drops removed ones. Thread: as world::Decider.

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::controllers {

/// A `ctrl` entry: a model and a controller with arguments.
struct Post {
  world::ModelId model;
  std::string name;  // of the controller
  std::vector<std::string> arguments;
  std::uint32_t order = 0;  // index among the model's ctrl entries
};

/// The `ctrl` entries of a model without duplicates; `repeated`, if given, gets duplicate names.
std::vector<Post> posts_of(const world::World& world, world::ModelRow model,
                           std::vector<std::string>* repeated = nullptr);

class Batch : public world::Decider {
 public:
  explicit Batch(std::string name) : name_(std::move(name)) {}

  std::string_view name() const final { return name_; }
  std::size_t size() const final { return ids_.size(); }
  void follow(world::World& world) final;
  void hash(const world::World& world, Hash& hash) const final;
  Result<void> save(Packer& out) const final;
  bool load(world::World& world, Unpacker& in) final;

  /// Adds the model and subscribes what the controller uses.
  /// Fails (without "file:line") if the model lacks it.
  Result<void> add(world::World& world, const Post& post);

 protected:
  /// Robot i of the batch. [ids, ascending except for robots spawned later]
  world::ModelId id(std::size_t i) const { return ids_[i]; }
  /// Indices of robots in the order of ids, for deliver().
  std::span<const std::uint32_t> by_id();

  /// Appends a robot to all columns, including those derived from rows.
  virtual Result<void> join(world::World& world, const Post& post) = 0;
  /// Removes robot i from all columns.
  virtual void leave(std::size_t i) = 0;
  /// Rows have changed: looks up those of robot i again. It and all its parts exist.
  virtual void resolve(const world::World& world, std::size_t i) = 0;
  /// Called before decide(), with all robots in the batch; `rebuilt`
  /// if static solids may have changed since the last call.
  virtual void prepare(const world::World& world, bool rebuilt) {
    static_cast<void>(world), static_cast<void>(rebuilt);
  }
  /// Memory of robot i.
  virtual void hash_of(std::size_t i, Hash& hash) const = 0;
  virtual Result<void> save_of(std::size_t i, Packer& out) const = 0;
  virtual bool load_of(world::World& world, std::size_t i, Unpacker& in) = 0;

 private:
  void follow_population(world::World& world, std::uint64_t first, bool reload);
  /// Adds a robot spawned at run time: a failure is logged, and it runs without this controller.
  void join_late(world::World& world, const Post& post);

  std::string name_;
  std::vector<world::ModelId> ids_;
  std::vector<std::uint32_t> by_id_;  // indices of ids_; empty: outdated
  std::uint64_t next_event_ = 0;      // next entry of world.events
};

/// A batch with numeric memory: Self::memory(self) is a tuple of references
/// to its columns, from which hash, save, load and removal are derived.
template <typename Self>
class BatchOf : public Batch {
 public:
  using Batch::Batch;

 protected:
  void hash_of(std::size_t i, Hash& hash) const final {
    each_column([&](const auto& column) {
      if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(column[i])>>) {
        hash.add(column[i]);
      } else {
        hash.add(static_cast<std::uint64_t>(column[i]));
      }
    });
  }
  Result<void> save_of(std::size_t i, Packer& out) const final {
    each_column([&](const auto& column) {
      if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(column[i])>>) {
        out.f64(column[i]);
      } else {
        out.u64(static_cast<std::uint64_t>(column[i]));
      }
    });
    return {};
  }
  bool load_of(world::World&, std::size_t i, Unpacker& in) final {
    bool good = true;
    each_column([&](auto& column) {
      using ColumnNumber = std::remove_cvref_t<decltype(column[i])>;
      if constexpr (std::is_floating_point_v<ColumnNumber>) {
        column[i] = in.f64();
        good = good && std::isfinite(column[i]);
      } else {
        const std::uint64_t value = in.u64();
        column[i] = static_cast<ColumnNumber>(value);
        good = good && static_cast<std::uint64_t>(column[i]) == value;
      }
    });
    return good && in.ok();
  }
  void leave(std::size_t i) final {
    each_column([i](auto& column) { column.erase(column.begin() + static_cast<std::ptrdiff_t>(i)); });
    static_cast<Self*>(this)->leave_rest(i);
  }

 private:
  template <typename Visit>
  void each_column(const Visit& visit) const {
    std::apply([&](const auto&... column) { (visit(column), ...); },
               Self::memory(static_cast<const Self&>(*this)));
  }
  template <typename Visit>
  void each_column(const Visit& visit) {
    std::apply([&](auto&... column) { (visit(column), ...); }, Self::memory(static_cast<Self&>(*this)));
  }
};

/// Erases element i of each vector.
template <typename... Columns>
void erase_at(std::size_t i, Columns&... columns) {
  (columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(i)), ...);
}

/// The model's row in positions; none if it does not drive.
world::PositionRow position_of(const world::World& world, world::ModelRow model);

/// Rangers of a robot in depth-first preorder, children in file order.
std::vector<world::RangerRow> rangers_of(const world::World& world, world::ModelRow model);

/// The ranger with the most sensors, the first of several, or none.
world::RangerRow ring_ranger(const world::World& world, world::ModelRow model);

/// Fiducial finders of a robot, in the same order.
std::vector<world::FiducialRow> finders_of(const world::World& world, world::ModelRow model);

/// Bearings of all beams of a ranger in the frame of `robot`, by beam. [rad]
std::vector<float> bearings_of(const world::World& world, world::ModelRow robot, world::RangerRow ranger);

/// Index of a ranger's first beam; its beams are consecutive.
world::BeamRow first_beam(const world::World& world, world::RangerRow ranger);
std::uint32_t beam_count(const world::World& world, world::RangerRow ranger);

inline void drive(world::World& world, world::PositionRow robot, double forward, double turn) {
  world.positions.mode[robot] = world::ControlMode::kVelocity;
  world.positions.command[robot] = {forward, 0, 0, turn};
}

}  // namespace playhouse::controllers
