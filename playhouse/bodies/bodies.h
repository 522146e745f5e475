#pragma once

/// Bodies: the solids of a world as columns. A solid is one closed polygon extruded in z; a
/// block is one solid, every contour of a bitmap is one. Static solids come first; solids of
/// movable trees follow in tree order, so the solids and vertices of a tree are consecutive and
/// can be rebuilt without the static ones. Static parts of a tree, such as the walls around a
/// door, are not among the tree's solids. Frames: W world, M the model that owns the solid.
///
/// In: the models of a world, and the shapes of their descriptions.
/// Out: solids as columns, in their models and in W.
/// Cost: place() visits the vertices of its solids; replace_moving_solids() makes all movable ones anew.

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "playhouse/bodies/rows.h"
#include "playhouse/bodies/seen_by.h"
#include "playhouse/geom/pose.h"
#include "playhouse/world/world.h"

namespace playhouse::bodies {

using geom::Pose;
using geom::Rotation;
using geom::Vec2;

/// A model that is driven by its own kinematics: a robot, an actuator, a custom model.
struct Mover {
  world::ModelRow model;
  world::KindRow part;
  scene::ModelKind kind;
};

/// Trees of models with at least one mover.
struct Trees {
  ByRow<Trees, world::ModelRow> root;       // ascending                                    (t)
  ByRow<Trees, std::uint32_t> first_model;  // models[first_model[t] ..]
  std::vector<world::ModelRow> models;      // parents first
  ByRow<Trees, MoverRow> first_mover;       // movers[first_mover[t] ..], in the order of models
  ByRow<Mover, Mover> movers;
  ByRow<Trees, SolidRow> first_solid;  // solids first_solid[t] .. first_solid[t + 1] - 1
  std::size_t size() const { return root.size(); }
  RowsOf<Trees> rows() const { return RowsOf<Trees>(size()); }
  std::span<const world::ModelRow> models_of(Row<Trees> tree) const {
    return std::span(models).subspan(first_model[tree], first_model[tree + 1] - first_model[tree]);
  }
  std::span<const Mover> movers_of(Row<Trees> tree) const {
    return {movers.from(first_mover[tree]), first_mover[tree + 1] - first_mover[tree]};
  }
  MoverRow row_of(const Mover& mover) const { return {static_cast<std::uint32_t>(&mover - movers.data())}; }
  SolidRows solids_of(Row<Trees> tree) const { return {first_solid[tree], first_solid[tree + 1]}; }
  /// Row of the tree with this root.
  Row<Trees> of_root(world::ModelRow top) const {
    return {static_cast<std::uint32_t>(std::ranges::lower_bound(root, top) - root.begin())};
  }
};

/// A solid in the frame of its model, made once per row of SceneDesc::models, shared by its instances.
struct SolidShape {
  double z_min_M = 0, z_max_M = 0;  // m
  Vec2 center_M;                    // mean of the vertices                                    [m]
  double radius = 0;                // bounding circle about the center                          [m]
  double width = 0;                 // smallest extent                                         [m]
  bool convex = false;
  bool full = false;      // its inside is solid: a block, not a contour of a bitmap
  bool hole = false;      // its inside is free: an inner contour of a bitmap
  Row<SolidShape> body;   // first shape of the same body: contours of one bitmap share it
  std::vector<Vec2> p_M;  // counter-clockwise vertices, the first again at the end  [m]
};

class Shapes {
 public:
  explicit Shapes(const scene::SceneDesc& scene) : scene_(scene) {}
  const ByRow<SolidShape, SolidShape>& of(std::uint32_t desc);

 private:
  const scene::SceneDesc& scene_;
  std::map<std::uint32_t, ByRow<SolidShape, SolidShape>> made_;
};

/// Convex polygons with more corners take the code path of concave ones.
inline constexpr std::size_t kConvexCorners = 32;

/// Eight corners of a convex polygon, padded with its first corner.
struct alignas(64) EightCorners {
  static constexpr std::size_t kCorners = 8;
  float x[kCorners], y[kCorners];  // m from the centre of the solid, along W's axes

  /// Bound on the single-precision error of the signed distance of a corner from a ray's
  /// line, for a ray that passes near a solid of this radius: seven roundings of numbers
  /// up to the radius, 2^-24 each, and what the corner lost to rounding in W. [m]
  static float error(double radius) { return static_cast<float>(0x1p-20 * radius + 1e-8); }
};

struct Solids {
  template <typename Value>
  using BySolid = ByRow<Solids, Value>;

  // Constant: shape and owner.
  BySolid<world::ModelRow> model, root;
  BySolid<TreeRow> tree;             // none: static
  BySolid<double> z_min_M, z_max_M;  // m
  BySolid<Vec2> center_M;            // mean of the vertices                                    [m]
  BySolid<double> radius;            // bounding circle about the center                          [m]
  BySolid<double> width;             // smallest extent                                         [m]
  BySolid<std::uint8_t> convex;      // 1: a convex polygon
  BySolid<std::uint8_t> full;        // 1: its inside is solid, not only its outline
  BySolid<std::uint8_t> hole;        // 1: its inside is free: a hole in the body of a bitmap
  BySolid<SolidRow> body;            // the first solid of the same body
  BySolid<SeenByBits> seen_by;       // visibility mask: what sees it, or is blocked by it
  // Height of its lowest part that another solid of its tree encloses (enclosure.h), kAll if all of it.  [m]
  BySolid<double> enclosed;
  static constexpr double kAll = 1e300;  // above everything: enclosed all over
  BySolid<VertexRow> first_vertex;       // (n + 1)
  // Counter-clockwise vertices, the first of each polygon again at its end.                            [m]
  ByRow<Vertices, Vec2> p_M;
  SolidRow first_moving{0};  // those before it are static

  world::ByModel<Rotation> rotation;  // headings of models in W, written by: turn

  // Placement in W.                           written by: place
  BySolid<Vec2> center;          // in W                                                    [m]
  BySolid<double> z_min, z_max;  // in W                                                    [m]
  ByRow<Vertices, Vec2> p;       // vertices in W, padded by kPad for vector loads              [m]
  static constexpr std::size_t kPad = 32;
  // Corners of polygons with convex_corners(), polygon by polygon.
  ByRow<EightCorners, EightCorners> corners;
  std::vector<CornersRow> first_corners;  // (movable solids: by place_of())

  std::size_t size() const { return model.size(); }
  SolidRows rows() const { return model.rows(); }
  SolidRows fixed_rows() const { return {SolidRow{0}, first_moving}; }
  SolidRows moving_rows() const { return {first_moving, model.next()}; }
  std::size_t moving() const { return moving_rows().size(); }
  /// Place of a movable solid among those.
  std::size_t place_of(SolidRow row) const { return row - first_moving; }
  /// The vertices of a solid, with the first one again at the end.
  VertexRows vertices_of(SolidRow row) const { return {first_vertex[row], first_vertex[row + 1]}; }
  std::uint32_t corners_of(SolidRow row) const { return vertices_of(row).size() - 1; }
  /// The height from which on rays from other trees can hit it.  [m, in W]
  double z_free(SolidRow row) const { return z_min[row] + enclosed[row]; }
  /// Number of corners of a convex polygon; 0 if concave or more than kConvexCorners.
  std::size_t convex_corners(SolidRow row) const {
    const std::size_t count = corners_of(row);
    return convex[row] != 0 && count <= kConvexCorners ? count : 0;
  }
  bool is_obstacle(SolidRow row) const { return (seen_by[row] & bit(SeenBy::kMotion)) != 0; }
  std::span<const Vec2> polygon(SolidRow row) const { return {p.from(first_vertex[row]), corners_of(row)}; }
  std::span<const Vec2> polygon_M(SolidRow row) const {
    return {p_M.from(first_vertex[row]), corners_of(row)};
  }
};

Trees make_trees(const world::World& world);
/// A static model, as far as its solids depend on it.
struct StaticModel {
  world::ModelRow model, root;
  std::uint32_t desc;  // row of SceneDesc::models
  Pose X_WM;
  geom::Tilt tilt_WM;
  bool operator==(const StaticModel&) const = default;
};
std::vector<StaticModel> static_models(const world::World& world);
/// The static solids, placed.
Solids make_fixed_solids(const world::World& world, Shapes& shapes);
/// Replaces the movable solids by those of `trees`, placed; sets trees.first_solid.
void replace_moving_solids(Solids& solids, const world::World& world, Shapes& shapes, Trees& trees);

/// Updates solids.rotation of the models of a tree from their headings in W.
void turn(Solids& solids, const world::Models& models, std::span<const world::ModelRow> tree);
/// Places these solids in W by the poses of their models. Needs turn() for those models.
void place(Solids& solids, const world::Models& models, SolidRows rows);

/// A proposed configuration of one tree, or a substep towards it. Rows count from the tree's first.
struct TreeShape {
  std::span<Pose> moved;         // X_PM of the movers (movers of the tree)
  std::span<Pose> X_WM;          // (models of the tree)
  std::span<Rotation> rotation;  // of X_WM (models of the tree)
  std::span<Vec2> center, p;     // (solids of the tree), (their vertices)
  std::span<double> z;           // of the models of the solids, in W; empty if no height changes
};

}  // namespace playhouse::bodies
