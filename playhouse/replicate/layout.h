#pragma once

/// Layout: one population of a world as viewers need it: tree structure, sensors of models, and
/// the quantised state at the time of the layout, which is the first baseline of models new to
/// a viewer. Made between two ticks whenever the population has changed, then shared read-only
/// by all threads. Rows are those of the world at that time; viewers refer to models by id.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/replicate/prototypes.h"
#include "playhouse/world/world.h"

namespace playhouse::replicate {

/// The replicated state of one model.
struct ModelState {
  std::int32_t x = 0, y = 0, z = 0;      // pose in the parent  [mm]
  std::uint16_t a = 0;                   // heading             [1/65536 turn]
  std::uint8_t state = 0;                // state_bits()
  std::uint32_t color = 0;               // 0xRRGGBBAA
  std::uint32_t flags = 0;               // tokens carried
  std::uint16_t tilt_x = 0, tilt_y = 0;  // as geom::Tilt  [1/65536 turn]
  friend bool operator==(const ModelState&, const ModelState&) = default;
};

struct SensorLayout {
  world::RangerRow ranger;
  world::ModelRow model;
  std::uint32_t nth = 0;  // index among its model's sensors
  world::BeamRow first_beam;
  std::uint32_t beam_count = 0;
  double range_max = 0;  // m; a beam is sent as range / range_max * 65535
};

inline constexpr std::uint8_t kMovable = 1;   // a user may drag it
inline constexpr std::uint8_t kAlwaysOn = 2;  // measures without subscribers
inline constexpr std::uint8_t kDrives = 4;    // it has a drive

/// Names of the Player devices that expose a
/// model, for display. Called between two ticks.
using DeviceNames = std::function<std::vector<std::string>(world::ModelId)>;

/// The constant properties of a model, as fields of a JSON object, in this order; the last two may be empty.
struct ModelWords {
  std::string names, devices, fiducial;
};

struct Layout {
  /// Reuses what is known of models that are in `before` too, if given.
  Layout(const world::World& world, const Prototypes& prototypes, const DeviceNames& devices,
         const Layout* before = nullptr);

  std::uint64_t population = 0;       // World::population()
  std::uint32_t ids_given = 0;        // exclusive upper bound on ids assigned so far
  world::ByModel<world::ModelId> id;  // ascending
  world::ByModel<world::ModelRow> parent, root;
  world::ByModel<std::uint32_t> prototype;  // of Prototypes
  world::ByModel<std::uint8_t> traits;      // kMovable, kAlwaysOn, kDrives
  world::ByModel<std::shared_ptr<const ModelWords>> words;
  world::ByModel<ModelState> start;
  ByRow<world::SensorTable, SensorLayout> sensors;
  std::vector<std::vector<world::ModelRow>> viewed;  // per view: the models with that view

  /// Row of a model; none if it does not exist.
  world::ModelRow row(world::ModelId model) const;
  /// Sensor row; none if the model does not exist or has fewer sensors.
  world::SensorRow sensor(world::ModelId model, std::uint64_t nth) const;
  /// All models of the tree with this root, the root first.
  std::span<const world::ModelRow> tree(world::ModelRow root_row) const;

 private:
  world::ByModel<std::uint32_t> tree_start_;  // of tree_rows_, by root, and the end
  std::vector<world::ModelRow> tree_rows_;
};

/// Quantised state of one model.
ModelState model_state(const world::World& world, world::ModelRow row);

}  // namespace playhouse::replicate
