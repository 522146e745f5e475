#pragma once

/// World: the state that both engines share, as tables of columns, and the few ways to change it from
/// outside. An engine's step() turns commands and state N into state N+1; between steps everyone reads a
/// const World. Rows are dense and in the order of the models' ids; they are for the tick and hold until the
/// population changes (population.h). Everyone else names models by id. Units, frames, roles and writers of
/// all columns are in columns.h. Thread: the tick thread, between steps. Frames: W world, P parent, M model,
/// B body (M moved by the origin), O odometry.

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
#include "playhouse/world/serials.h"

namespace playhouse::world {

/// What models began to say, for who listens; no state of a run.
struct Utterances {
  struct One {
    ModelId model;
    std::string text;
  };
  std::uint64_t count = 0;      // of all that were kept, ever
  std::vector<One> newest;      // number n, from 0, is in row n % limits::kUtterances
  std::uint32_t listeners = 0;  // while there are none, nothing is kept
};

class World : public Tables {
 public:
  /// The models of the scene's trees, with ids from 0 in that order. The scene must outlive the world.
  World(const scene::SceneDesc& scene, std::uint64_t seed);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const scene::SceneDesc& scene() const { return *scene_; }
  const scene::ModelDesc& desc(ModelRow row) const { return scene_->models[models.desc[row.index]]; }
  /// Where the files have it: its own line if it is a top of the scene's, else that of its prototype's.
  scene::SourceLine where(ModelRow row) const;
  std::uint64_t seed() const { return seed_; }
  std::uint64_t tick() const { return tick_; }
  /// Simulated time, the number nearest to whole microseconds: 6.3, not 6.300000000000001. [s]
  double time() const { return time_of(tick_); }
  double time_of(std::uint64_t tick) const {
    return std::round(static_cast<double>(tick) * scene_->interval * 1e6) / 1e6;
  }

  /// Another number whenever models come, go or become parts of each other.
  std::uint64_t population() const { return population_; }
  /// Another number whenever some model may say something else; who comes and goes is told by population().
  std::uint64_t said() const { return said_; }

  ModelId id(ModelRow row) const { return models.id[row.index]; }
  /// Serial number of a model, for streams of random numbers and whatever else depends on identity by value.
  std::uint32_t serial(ModelId id) const { return serials_.of(id); }
  std::uint32_t serial(ModelRow row) const { return serials_.of(models.id[row.index]); }
  /// None if there is no such model, or no more.
  ModelRow row(ModelId id) const;
  /// Row of a robot's drive; none if there is no such model, no more, or it does not drive.
  PositionRow position(ModelId id) const;
  /// The model's name: the scene's, or, of a model that came during the run, what it was given with the rest
  /// of the scene's behind it ("r7.ranger:0").
  std::string name(ModelRow row) const;
  /// What it would be called had nobody named it: "position:3"; of what came during the run as name() is.
  std::string alias(ModelRow row) const;
  /// Look-up by name or default name; none if there is no such model. The last of equal names wins.
  ModelRow find(std::string_view name) const;
  /// Rows of what is attached to it, ascending; for range-based for.
  class Children;
  Children children(ModelRow row) const;

  /// Hash of what robots do: of every column that a later tick depends on, what controllers sense and
  /// remember, and the tick. What is only measured for people and clients is no part of it: whoever watches
  /// changes nothing. A sum over models, so that neither their order nor who computed them matters.
  std::uint64_t hash() const;
  /// Hash of what all sensors measured, and of who had them measure.
  std::uint64_t sensed_hash() const;
  /// Memory of all columns. [bytes]
  std::size_t bytes() const;

  /// In-process controllers, in the order in which they decide (see controllers::attach).
  std::vector<std::unique_ptr<Decider>> deciders;
  /// Code of custom models, by row of SceneDesc::models (see libraries::attach_custom_kinds); null for
  /// others. Empty: none was loaded, and custom models do nothing.
  std::vector<std::shared_ptr<const CustomCode>> custom_codes;

  ChangeList changes;
  /// The name of the engine, as of --engine; whether it keeps every model upright: there are no tilts then;
  /// and whether its cameras see by the light of the scene: sun, lamps, fog. Written by the engine, as it is
  /// made.
  std::string engine = "stage";
  bool upright = true;
  bool has_light = false;
  std::uint64_t tick_ = 0;  // written by: freeze (the engine) alone
  std::uint64_t said_ = 0;  // written by: set_say, load_state
  Utterances utterances;    // written by: set_say, and who listens

 private:
  friend class Population;

  /// What a top that came during the run was given.
  struct Given {
    std::string name;
    geom::Pose X_WM;  // where it came
  };
  /// The tree that a model came in.
  struct Origin {
    std::uint32_t top = 0, place = 0;      // row of SceneDesc::models, and of the model behind it
    ModelId first;                         // id of the top
    std::uint32_t tree = ModelRow::kNone;  // row of trees_, of the scene's models
  };
  Origin origin(ModelRow row) const;
  /// Row of trees_ of the one that holds the scene's model of this id, or kNone.
  std::uint32_t tree_with(ModelId id) const;
  /// Hash of the columns of one model that `is_in(column)` chooses, with the model's id.
  template <typename Choose>
  std::uint64_t hash_of(std::uint32_t model, const Choose& is_in) const;
  /// Which of the two tokens that models have.
  enum class Token : std::uint8_t { kName, kAlias };
  std::string token(ModelRow row, Token which) const;
  ModelRow find(std::string_view token, Token which) const;
  /// Its id if the scene describes the model of that id so, else that of the first model described so: what
  /// hash() knows of descriptions, however many models share one.
  std::uint32_t like(ModelRow row) const;
  void index_names() const;
  void add_names(std::uint32_t first) const;
  void remove_names(ModelRow row) const;
  std::string_view token_of(const Origin& from, Token which) const;

  const scene::SceneDesc* scene_;
  std::vector<scene::TreeDesc> made_;       // where the scene lists no trees
  std::span<const scene::TreeDesc> trees_;  // of the scene
  std::vector<std::uint32_t> first_id_;     // of each tree, and the first that is no more of the scene
  std::vector<std::uint32_t> first_like_;   // id of the first model of each description of the scene
  std::uint64_t seed_;
  std::uint32_t next_id_ = 0;
  Serials serials_;
  std::size_t corners_ = 0;  // of all bodies
  std::size_t pixels_ = 0;   // of the images of all cameras
  std::uint64_t population_ = 0;
  std::map<ModelId, Given> given_;
  /// Tops by a token, in the order of tokens and then of ids.
  struct Named {
    std::string_view token;
    ModelId id;
    auto operator<=>(const Named&) const = default;
  };
  mutable std::set<Named> by_name_, by_alias_;
  mutable std::vector<std::uint32_t> odd_;  // descriptions of parts whose tokens do not begin with the top's
  mutable bool names_known_ = false;        // the sets hold everyone; made when somebody asks
};

class World::Children {
 public:
  class Iterator {
   public:
    Iterator(const std::vector<std::uint32_t>& next, std::uint32_t row) : next_(&next), row_(row) {}
    std::uint32_t operator*() const { return row_; }
    Iterator& operator++() {
      row_ = (*next_)[row_];
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.row_ == b.row_; }

   private:
    const std::vector<std::uint32_t>* next_;
    std::uint32_t row_;
  };

  Children(const Models& models, std::uint32_t row)
      : next_(models.next_sibling), first_(models.first_child[row]) {}
  Iterator begin() const { return {next_, first_}; }
  Iterator end() const { return {next_, ModelRow::kNone}; }
  bool empty() const { return first_ == ModelRow::kNone; }

 private:
  const std::vector<std::uint32_t>& next_;
  std::uint32_t first_;
};

inline World::Children World::children(ModelRow row) const {
  return {models, row.index};
}

/// Six degrees of freedom in one value: X_PM with tilt_PM, and X_WM with tilt_WM.
geom::SpatialPose pose_in_parent(const Models& models, ModelRow model);
geom::SpatialPose pose_in_world(const Models& models, ModelRow model);

/// Recomputes X_WM and tilt_WM of one model from those of its parent.
void place(Models& models, ModelRow model);
/// Recomputes X_WM and tilt_WM of a model and everything attached to it from X_PM and tilt_PM; what robots
/// with gps believe follows.
void place_tree(World& world, ModelRow model);

/// Resets rest counters after a placement or removal.
inline void wake(Models& models) {
  models.still.clear();
}

/// False for poses of which sums and products may be no numbers any more: not finite, or beyond any scene.
bool is_place(const geom::Pose& X);

// Ways to change the world between ticks. Non-finite numbers and poses that are no place are refused (false),
// nothing changes then.

bool command_velocity(World& world, PositionRow robot, const geom::Twist& velocity);
bool command_position(World& world, PositionRow robot, const geom::Pose& goal_O);
/// Drives at `speed` and turns to `heading_O` meanwhile. [m/s, rad]
bool command_heading(World& world, PositionRow robot, double speed, double heading_O);
/// A car has no acceleration mode: false.
bool command_acceleration(World& world, PositionRow robot, const geom::Twist& acceleration);
/// The robot believes from now on that it is at X_OM.
bool set_odometry(World& world, PositionRow robot, const geom::Pose& X_OM);
/// Puts a model somewhere in its parent's frame, without any collision check; children follow. It stays as
/// tilted as it was.
bool set_pose(World& world, ModelRow model, const geom::Pose& X_PM);
/// The same with a tilt, which an engine that keeps models upright leaves out.
bool set_spatial_pose(World& world, ModelRow model, const geom::SpatialPose& X_PM);
/// Puts every model where the scene has it; robots do and believe what they did at the start. Time goes on,
/// and what controllers remember, colours and subscriptions stay.
void return_to_start(World& world);
void set_fiducial_return(World& world, ModelRow model, std::int32_t id);
void set_color(World& world, ModelRow model, const scene::Color& color);
/// What the model says from now on, as spoken() makes it (speech.h); "" for nothing.
void set_say(World& world, ModelRow model, std::string_view text);
/// Gives the model flags, or takes some, as far as it has them; it carries 0 to 2^31 - 1.
void add_flags(World& world, ModelRow model, std::int64_t flags);
/// An actuator's velocity along its axis, from the next tick on; its speed and its ends limit it. False, and
/// nothing changes, if it is not finite. [m/s or rad/s]
bool command_joint_velocity(World& world, ActuatorRow actuator, double velocity);
/// Where an actuator goes: the nearest position that it can have. False, and nothing changes, if it is not
/// finite. [m or rad]
bool command_joint_position(World& world, ActuatorRow actuator, double position);
/// What a custom model is told: number `which` of its command. False, and nothing changes, if it has no such
/// number or the value is not finite.
bool command_custom(World& world, CustomRow custom, std::uint32_t which, double value);
/// Sensors measure and robots move only while subscribed (or alwayson). Calls are counted.
void subscribe(World& world, ModelRow model);
/// The same for a controller, which stays: from then on what the sensor measures is part of hash().
void subscribe_controller(World& world, ModelRow model);
/// The last unsubscribe of a robot or an actuator stops it: its command and velocity become zero.
void unsubscribe(World& world, ModelRow model);
/// Subscribes for somebody who only looks, at a model that does nothing but measure: it draws nothing from
/// batteries for that, so that whoever watches changes nothing.
void watch(World& world, ModelRow model);
void unwatch(World& world, ModelRow model);
/// Somebody other than watchers has subscribed it.
bool is_used(const World& world, ModelRow model);

}  // namespace playhouse::world
