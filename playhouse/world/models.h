#pragma once

/// The table of all models, whatever their kind; the tables of kinds are
/// generated from kinds/*.toml (generated/tables.h). Frames: W world, P parent.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/base/row.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/event.h"
#include "playhouse/world/model_id.h"
#include "playhouse/world/shared_column.h"

namespace playhouse::world {

using ModelRow = Row<struct ModelTable>;

/// A row of the table of a model's kind, whichever that is: of the kind that is asked for.
struct KindRow : Row<struct KindTable> {
  template <typename Table>
  constexpr operator Row<Table>() const {
    return {index};
  }
};

/// A value for each model.
template <typename Value>
using ByModel = ByRow<ModelTable, Value>;

/// A corner of a point, a line or a triangle of a drawing (drawing.h); kinds/model.toml has the record.
struct DrawnCorner {
  float x = 0, y = 0, z = 0;  // in the frame of the model  [m]
  std::uint32_t color = 0;    // 0xRRGGBBAA
  std::uint8_t corners = 0;   // of its shape: 1, 2 or 3, which follow each other
  std::uint8_t layer = 0;     // 0: of graphics2d, 1: of graphics3d
  friend bool operator==(const DrawnCorner&, const DrawnCorner&) = default;
};

/// Calls visit(part) for every part.
template <typename Visit>
void each_part(DrawnCorner& value, const Visit& visit) {
  auto& [x, y, z, color, corners, layer] = value;
  visit(x), visit(y), visit(z), visit(color), visit(corners), visit(layer);
}
template <typename Visit>
void each_part(const DrawnCorner& value, const Visit& visit) {
  const auto& [x, y, z, color, corners, layer] = value;
  visit(x), visit(y), visit(z), visit(color), visit(corners), visit(layer);
}

/// Every model (n rows).
struct Models {
  ByModel<ModelId> id;          // ascending
  ByModel<std::uint32_t> desc;  // row of SceneDesc::models, its prototype; shared by many
  ByModel<ModelId> parent_id;   // none for a root
  ByModel<ModelRow> parent;     // the same as a row
  SharedByRow<ModelTable, geom::Pose> X_PM{
      desc};                 // pose in the parent; roots and robots have their own value
  ByModel<geom::Pose> X_WM;  // pose in the world
  /// Tilt in the parent and in the world; together with X_PM and X_WM
  /// six degrees of freedom. Zero in engines that keep models upright.
  SharedByRow<ModelTable, geom::Tilt> tilt_PM{desc}, tilt_WM{desc};
  /// Velocity of a root in the world, and for how many ticks it has been
  /// at rest (sleeping). Only in engines with dynamics; otherwise zero.
  SharedByRow<ModelTable, geom::SpatialVelocity> V_WM{desc};
  SharedByRow<ModelTable, std::uint32_t> still{desc};
  ByModel<ModelRow> root;  // root of the tree; its own row for a root
  ByModel<scene::ModelKind> kind;
  ByModel<KindRow> part;                  // row in the kind's own table, or none
  ByModel<ModelRow> first_child;          // see World::children()
  ByModel<ModelRow> next_sibling;         // ascending
  ByModel<Mobility> mobility;             // how it moves
  ByModel<std::uint32_t> subscribers;     // open devices, controllers, one for alwayson
  ByModel<std::uint32_t> controllers;     // of the subscribers
  ByModel<std::uint32_t> watchers;        // of the subscribers: passive viewers
  ByModel<std::int32_t> fiducial_return;  // 0: invisible to finders
  ByModel<std::int32_t> flags;            // tokens carried (source, sink)
  SharedByRow<ModelTable, scene::Color> color{desc};
  SharedByRow<ModelTable, std::string> say{
      desc};  // speech bubble; starts as the scene's; own with controllers
  SharedByRow<ModelTable, std::vector<DrawnCorner>> drawing{desc};  // own where somebody has drawn
  std::size_t size() const { return id.size(); }
  RowsOf<ModelTable> rows() const { return id.rows(); }
};

/// Meaning of a drive's command: a velocity [m/s, rad/s], for a car with the
/// steering angle as turn rate [rad]; a goal pose; an acceleration [m/s^2,
/// rad/s^2]; a speed and a heading to keep, in the frame of X_OM [m/s, rad].
enum class ControlMode : std::uint8_t { kVelocity, kPosition, kAcceleration, kHeading };

}  // namespace playhouse::world
