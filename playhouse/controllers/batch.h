#pragma once

/// Batch: all robots that run one kind of controller, and what every batch needs to find its robots' parts.
/// attach() makes batches and fills them; robots that come later join, those that go leave (follow()).
/// Thread: as world::Decider.

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

/// One `ctrl` line: who is to run what.
struct Post {
  world::ModelId model;
  std::string name;  // of the controller
  std::vector<std::string> arguments;
  std::uint32_t order = 0;  // 0 for the model's first ctrl, 1 for its second, ...
};

/// What a model's `ctrl` lines say, each name once. `repeated`, if any, gets names given twice.
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

  /// Takes the model and subscribes what the controller uses. Fails (without "file:line") when the model
  /// lacks it.
  Result<void> add(world::World& world, const Post& post);

 protected:
  /// Robot i of the batch. [ids, ascending but for those that joined late]
  world::ModelId id(std::size_t i) const { return ids_[i]; }
  /// Its robots in the order of their ids, for deliver().
  std::span<const std::uint32_t> by_id();

  /// One more robot, at the end of every column, with columns that follow from rows filled in as well.
  virtual Result<void> join(world::World& world, const Post& post) = 0;
  /// Robot i is gone: erases it from every column.
  virtual void leave(std::size_t i) = 0;
  /// Rows moved: finds those of robot i again. It and all its parts are there.
  virtual void resolve(const world::World& world, std::size_t i) = 0;
  /// The world is as it is before decide(), with all robots in the batch; `rebuilt` if what stands still may
  /// not be where it was the last time.
  virtual void prepare(const world::World& world, bool rebuilt) {
    static_cast<void>(world), static_cast<void>(rebuilt);
  }
  /// What robot i remembers.
  virtual void hash_of(std::size_t i, Hash& hash) const = 0;
  virtual Result<void> save_of(std::size_t i, Packer& out) const = 0;
  virtual bool load_of(std::size_t i, Unpacker& in) = 0;

 private:
  void follow_population(world::World& world, std::uint64_t first, bool reload);
  /// A robot that came while the world runs: a failure is logged, and it stays without this controller.
  void join_late(world::World& world, const Post& post);

  std::string name_;
  std::vector<world::ModelId> ids_;
  std::vector<std::uint32_t> by_id_;  // places in ids_; empty: to be made anew
  std::uint64_t next_change_ = 0;     // of world.changes
};

/// A batch whose robots remember numbers: Self::memory(self) is a tuple of references to the columns, of
/// which everything follows that is done with all of them.
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
  bool load_of(std::size_t i, Unpacker& in) final {
    bool good = true;
    each_column([&](auto& column) {
      using Number = std::remove_cvref_t<decltype(column[i])>;
      if constexpr (std::is_floating_point_v<Number>) {
        column[i] = in.f64();
        good = good && std::isfinite(column[i]);
      } else {
        const std::uint64_t value = in.u64();
        column[i] = static_cast<Number>(value);
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

/// Row of the model in the positions, or none if it does not drive.
world::PositionRow position_of(const world::World& world, world::ModelRow model);

/// The rangers of a robot, depth first, children in file order; its own row first if it is one itself.
std::vector<world::RangerRow> rangers_of(const world::World& world, world::ModelRow model);

/// The ranger of a robot with the most sensors, the first of equals, or none: its ring.
world::RangerRow ring_ranger(const world::World& world, world::ModelRow model);

/// Its fiducial finders, in the same order.
std::vector<world::FiducialRow> finders_of(const world::World& world, world::ModelRow model);

/// Bearings of all beams of a ranger in the frame of `robot`, in beam order. [rad]
std::vector<float> bearings_of(const world::World& world, world::ModelRow robot, world::RangerRow ranger);

/// The first beam of a ranger; its beams are one contiguous run.
std::uint32_t first_beam(const world::World& world, world::RangerRow ranger);
std::uint32_t beam_count(const world::World& world, world::RangerRow ranger);

inline void drive(world::World& world, world::PositionRow robot, double forward, double turn) {
  world.positions.mode[robot.index] = world::ControlMode::kVelocity;
  world.positions.command[robot.index] = {forward, 0, 0, turn};
}

}  // namespace playhouse::controllers
