#pragma once

/// World: the state that both engines share, as tables of columns, and the functions that change
/// it from outside. An engine's step() maps commands and state N to state N+1; between steps
/// everyone reads a const World. Rows are dense, in the order of model ids, for use inside a
/// tick, and valid until the population changes (population.h); others refer to models by id.
/// Units, frames, roles and writers of columns: columns.h. Thread: the tick thread, between
/// steps. Frames: W world, P parent, M model, B body (M moved by the origin), O odometry.

#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/world/custom_kind.h"
#include "playhouse/world/decider.h"
#include "playhouse/world/generated/tables.h"
#include "playhouse/world/population/serials.h"

namespace playhouse::world {

/// A ring buffer of texts that models began to say, for listeners; no part of the state.
struct Utterances {
  struct One {
    ModelId model;
    std::string text;
  };
  std::uint64_t count = 0;      // total number of utterances recorded
  std::vector<One> newest;      // utterance n, from 0, is in row n % limits::kUtterances
  std::uint32_t listeners = 0;  // 0: nothing is recorded
};

enum class Role : std::uint8_t;  // of a column, columns.h

class World : public Tables {
 public:
  /// Instantiates the scene's trees, with ids from 0 in order. The scene must outlive the world.
  World(const scene::SceneDesc& scene, std::uint64_t seed);
  World(const scene::SceneDesc&&, std::uint64_t) = delete;
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const scene::SceneDesc& scene() const { return *scene_; }
  const scene::ModelDesc& desc(ModelRow row) const { return scene_->models[models.desc[row]]; }
  /// Its line in the files: its own if it is a root of the scene, else that of its prototype.
  config::SourceLine where(ModelRow row) const;
  std::uint64_t seed() const { return seed_; }
  std::uint64_t tick() const { return tick_; }
  /// Simulated time, rounded to microseconds: 6.3, not 6.300000000000001. [s]
  double time() const { return time_of(tick_); }
  double time_of(std::uint64_t tick) const {
    return std::round(static_cast<double>(tick) * scene_->interval * 1e6) / 1e6;
  }

  /// Version of the population: changes when models are spawned, removed, attached or detached.
  std::uint64_t population() const { return population_; }
  /// Version of texts: changes when some model may say something else; spawn and removal change population().
  std::uint64_t said() const { return said_; }
  /// The same of drawings.
  std::uint64_t drawn() const { return drawn_; }

  ModelId id(ModelRow row) const { return models.id[row]; }
  /// Serial number of a model: for random streams, hashes and whatever else depends on identity by value.
  std::uint32_t serial(ModelId id) const { return serials_.of(id); }
  std::uint32_t serial(ModelRow row) const { return serials_.of(models.id[row]); }
  /// None if the model does not exist or no longer exists.
  ModelRow row(ModelId id) const;
  /// Row of a robot's drive; none if the model does not exist or does not drive.
  PositionRow position(ModelId id) const;
  /// The model's name: from the scene, or, for a model spawned at run time,
  /// the given name with the part's suffix from the scene ("r7.ranger:0").
  std::string name(ModelRow row) const;
  /// Its default name: "position:3"; for models spawned at run time like name().
  std::string alias(ModelRow row) const;
  /// Look-up by name or default name; none if there is no such model. Of duplicates the last one wins.
  ModelRow find(std::string_view name) const;
  /// The smallest number from 2 on for which no model is called "NAME~NUMBER". Tick thread.
  std::uint32_t fresh_number(const std::string& name) const;
  /// Rows of attached models, ascending; for range-based for.
  class Children;
  Children children(ModelRow row) const;

  /// Hash of the simulation: all columns that later ticks depend on, measurements and memory of
  /// controllers, and the tick. Measurements for users and clients are excluded, so that watching
  /// does not change it. A sum over models, independent of their order and of parallelism.
  std::uint64_t hash() const;
  /// Hash of all measurements, and of the subscriptions that caused them.
  std::uint64_t sensed_hash() const;
  /// Memory of all columns. [bytes]
  std::size_t bytes() const;

  /// In-process controllers, in their order of execution (see controllers::attach).
  std::vector<std::unique_ptr<Decider>> deciders;
  /// Code of custom models, by row of SceneDesc::models (see custom_kinds::attach_custom_kinds);
  /// null for others. Empty: none loaded, custom models are inert.
  std::vector<std::shared_ptr<const CustomCode>> custom_codes;

  EventLog events;
  /// Set by the engine at construction: its name as in --engine;
  /// whether it keeps models upright, without tilts; whether its
  /// cameras render the lighting of the scene: sun, lamps, fog.
  std::string engine = "stage";
  bool upright = true;
  bool has_light = false;
  std::uint64_t tick_ = 0;   // written by: freeze (the engine) only
  std::uint64_t said_ = 0;   // written by: set_say, load_state
  std::uint64_t drawn_ = 0;  // written by: draw, clear_drawing, load_state
  Utterances utterances;     // written by: set_say, and listeners

 private:
  friend class Population;

  /// Arguments of a spawn at run time.
  struct Given {
    std::string name;
    geom::Pose X_WM;  // where it was spawned
  };
  /// The tree from which a model was instantiated.
  struct Origin {
    std::uint32_t top = 0, place = 0;      // row of SceneDesc::models, and offset of the model from it
    ModelId first;                         // id of the root
    std::uint32_t tree = ModelRow::kNone;  // row of trees_, for models of the scene
  };
  Origin origin(ModelRow row) const;
  /// Row of trees_ that contains the scene's model of this id, or kNone.
  std::uint32_t tree_with(ModelId id) const;
  /// Hash of those columns of a model for whose role `is_in(role)` holds, with the model's id.
  std::uint64_t hash_of(ModelRow model, bool (*is_in)(Role)) const;
  /// The two names of a model.
  enum class NameOrAlias : std::uint8_t { kName, kAlias };
  std::string token(ModelRow row, NameOrAlias which) const;
  ModelRow find(std::string_view token, NameOrAlias which) const;
  /// Canonical number of a description for hash(), independent of sharing: the model's id if the
  /// scene's model of that id has this description, else the id of the first model that has it.
  std::uint32_t like(ModelRow row) const;
  void index_names() const;
  void add_names(ModelRow first) const;
  void remove_names(ModelRow row) const;
  std::string_view token_of(const Origin& from, NameOrAlias which) const;

  const scene::SceneDesc* scene_;
  std::vector<scene::TreeDesc> made_;       // used if the scene lists no trees
  std::span<const scene::TreeDesc> trees_;  // of the scene
  std::vector<std::uint32_t> first_id_;     // of each tree, then the first id past the scene's
  std::vector<std::uint32_t> first_like_;   // id of the first model of each description
  std::uint64_t seed_;
  std::uint32_t next_id_ = 0;
  Serials serials_;
  std::size_t corners_ = 0;  // of all bodies
  std::size_t pixels_ = 0;   // of the images of all cameras
  std::uint64_t population_ = 0;
  std::map<ModelId, Given> given_;
  /// Roots by token, then by id.
  struct Named {
    std::string_view token;
    ModelId id;
    auto operator<=>(const Named&) const = default;
  };
  mutable std::set<Named> by_name_, by_alias_;
  mutable std::vector<std::uint32_t> odd_;  // descriptions of parts whose tokens lack the root's as a prefix
  mutable bool names_known_ = false;        // the sets are complete; built on first use
  mutable std::map<std::string, std::uint32_t> fresh_from_;  // all numbers of a name below are in use
};

class World::Children {
 public:
  class ChildIterator {
   public:
    ChildIterator(const ByRow<ModelTable, ModelRow>& next, ModelRow row) : next_(&next), row_(row) {}
    ModelRow operator*() const { return row_; }
    ChildIterator& operator++() {
      row_ = (*next_)[row_];
      return *this;
    }
    friend bool operator==(const ChildIterator& a, const ChildIterator& b) { return a.row_ == b.row_; }

   private:
    const ByRow<ModelTable, ModelRow>* next_;
    ModelRow row_;
  };

  Children(const Models& models, ModelRow row)
      : next_(models.next_sibling), first_(models.first_child[row]) {}
  ChildIterator begin() const { return {next_, first_}; }
  ChildIterator end() const { return {next_, ModelRow{}}; }
  bool empty() const { return !first_; }

 private:
  const ByRow<ModelTable, ModelRow>& next_;
  ModelRow first_;
};

inline World::Children World::children(ModelRow row) const {
  return {models, row};
}

inline RowsOf<SensorTable> sensors_of(const Rangers& rangers, RangerRow ranger) {
  const SensorRow first = rangers.first_sensor[ranger];
  return {first, first + rangers.sensor_count[ranger]};
}
inline RowsOf<BeamTable> beams_of(const Sensors& sensors, SensorRow sensor) {
  const BeamRow first = sensors.first_beam[sensor];
  return {first, first + sensors.beam_count[sensor]};
}

/// Six degrees of freedom in one value: X_PM with tilt_PM, or X_WM with tilt_WM.
geom::SpatialPose pose_in_parent(const Models& models, ModelRow model);
geom::SpatialPose pose_in_world(const Models& models, ModelRow model);

/// Recomputes X_WM and tilt_WM of one model from those of its parent.
void place(Models& models, ModelRow model);
/// Recomputes X_WM and tilt_WM of a model and everything attached to
/// it from X_PM and tilt_PM, and the odometry of robots with gps.
void place_tree(World& world, ModelRow model);

/// Wakes all bodies: resets rest counters after a placement or removal.
inline void wake(Models& models) {
  models.still.clear();
}

/// False for invalid poses: not finite, or so far away that arithmetic would overflow.
bool is_place(const geom::Pose& X);

// Changes of the world between ticks. Functions that return bool
// reject non-finite numbers and invalid poses: false, without effect.

bool command_velocity(World& world, PositionRow robot, const geom::Twist& velocity);
bool command_position(World& world, PositionRow robot, const geom::Pose& goal_O);
/// Drives at `speed` while turning to `heading_O`. [m/s, rad]
bool command_heading(World& world, PositionRow robot, double speed, double heading_O);
/// False for a car, which has no acceleration mode.
bool command_acceleration(World& world, PositionRow robot, const geom::Twist& acceleration);
/// Sets the odometry: the robot's estimated pose becomes X_OM.
bool set_odometry(World& world, PositionRow robot, const geom::Pose& X_OM);
/// Teleports a model in its parent's frame, without
/// collision check; attached models follow. Its tilt stays.
bool set_pose(World& world, ModelRow model, const geom::Pose& X_PM);
/// The same with a tilt, ignored by engines that keep models upright.
bool set_spatial_pose(World& world, ModelRow model, const geom::SpatialPose& X_PM);
/// Resets every model to its pose in the scene, and robots' commands and odometry to their
/// initial values. Time continues; memory of controllers, colours and subscriptions stay.
void return_to_start(World& world);
void set_fiducial_return(World& world, ModelRow model, std::int32_t id);
void set_color(World& world, ModelRow model, const scene::Color& color);
/// Sets the text that the model says, sanitised by spoken() (speech.h); "" for nothing.
void set_say(World& world, ModelRow model, std::string_view text);
/// Adds flags to a model, or takes some; the count is clamped to 0 .. 2^31 - 1.
void add_flags(World& world, ModelRow model, std::int64_t flags);
/// Velocity command of an actuator along its axis, from the next tick on, within its
/// limits on speed and position. False, without effect, if not finite. [m/s or rad/s]
bool command_joint_velocity(World& world, ActuatorRow actuator, double velocity);
/// Position command of an actuator, clamped to its range.
/// False, without effect, if not finite. [m or rad]
bool command_joint_position(World& world, ActuatorRow actuator, double position);
/// Sets number `which` of a custom model's command. False, without
/// effect, if there is no such number or the value is not finite.
bool command_custom(World& world, CustomRow custom, std::uint32_t which, double value);
/// Reference-counted: sensors measure and robots move only while subscribed (or alwayson).
void subscribe(World& world, ModelRow model);
/// The same for a controller, permanently: the sensor's measurements become part of hash().
void subscribe_controller(World& world, ModelRow model);
/// The last unsubscribe of a robot or an actuator stops it: command and velocity become zero.
void unsubscribe(World& world, ModelRow model);
/// Subscribes as a passive viewer a model that only measures: draws
/// no battery power, so that watching does not change the run.
void watch(World& world, ModelRow model);
void unwatch(World& world, ModelRow model);
/// True if subscribed by anybody other than watchers.
bool is_used(const World& world, ModelRow model);

}  // namespace playhouse::world
