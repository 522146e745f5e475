#pragma once

/// Layout: one population of a world as viewers need it: who is part of whom, which sensor belongs to which
/// model, and the quantised state at the moment the layout was made, which is the first baseline of models
/// that a viewer did not know. Made between two ticks whenever the population is another one, then shared
/// read-only by all threads. Rows are those of the world at that moment; viewers name models by id.

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

/// One model as viewers see it.
struct ModelState {
  std::int32_t x = 0, y = 0, z = 0;      // pose in the parent  [mm]
  std::uint16_t a = 0;                   // heading             [1/65536 turn]
  std::uint8_t state = 0;                // state_bits()
  std::uint32_t color = 0;               // 0xRRGGBBAA
  std::uint32_t flags = 0;               // tokens that it carries
  std::uint16_t tilt_x = 0, tilt_y = 0;  // as geom::Tilt  [1/65536 turn]
  friend bool operator==(const ModelState&, const ModelState&) = default;
};

struct SensorLayout {
  std::uint32_t ranger = 0, model = 0;  // rows
  std::uint32_t nth = 0;                // of its model's
  std::uint32_t first_beam = 0, beam_count = 0;
  double range_max = 0;  // m; a beam is sent as range / range_max * 65535
};

inline constexpr std::uint8_t kMovable = 1;   // a person may drag it
inline constexpr std::uint8_t kAlwaysOn = 2;  // measures without subscribers
inline constexpr std::uint8_t kDrives = 4;    // it has wheels

/// The devices that show a model to Player clients, as a person writes them. Asked while the world stands
/// between two ticks.
using DeviceNames = std::function<std::vector<std::string>(world::ModelId)>;

struct Layout {
  /// What is known of models that `before` has, if there is one, is taken over.
  Layout(const world::World& world, const Prototypes& prototypes, const DeviceNames& devices,
         const Layout* before = nullptr);

  std::uint64_t population = 0;                           // World::population()
  std::uint32_t ids_given = 0;                            // all models that ever were have lower ids
  std::vector<world::ModelId> id;                         // per model, ascending
  std::vector<std::uint32_t> parent;                      // per model: row, or world::ModelRow::kNone
  std::vector<std::uint32_t> root;                        // per model
  std::vector<std::uint32_t> prototype;                   // per model, of Prototypes
  std::vector<std::uint8_t> traits;                       // per model: the bits above
  std::vector<std::shared_ptr<const std::string>> words;  // per model: fields of a JSON object
  std::vector<ModelState> start;                          // per model
  std::vector<SensorLayout> sensors;                      // per sensor row
  std::vector<std::vector<std::uint32_t>> viewed;         // per view, the rows of its models

  /// Row of a model; none if it is not there.
  std::optional<std::uint32_t> row(world::ModelId model) const;
  /// Sensor row; none if there is no such model, or it has fewer sensors.
  std::optional<std::uint32_t> sensor(world::ModelId model, std::uint64_t nth) const;
  /// Every model of the tree with this top, itself first.
  std::span<const std::uint32_t> tree(std::uint32_t root_row) const;

 private:
  std::vector<std::uint32_t> tree_start_, tree_rows_;
};

/// Quantised state of one model.
ModelState model_state(const world::World& world, std::uint32_t row);

}  // namespace playhouse::replicate
