#pragma once

/// Bodies: the solids of a world as columns. A solid is one closed polygon extruded in z; a block is one
/// solid, every contour of a bitmap is one. What stands still comes first; solids of trees that can move
/// follow, in the order of the trees, so that a tree's solids and vertices are consecutive and change
/// without those that stand still. What stands still of a tree, such as walls with a door, is not among the
/// tree's solids. Frames: W world, M the model that owns the solid.

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/stage/observer.h"
#include "playhouse/world/world.h"

namespace playhouse::stage {

using geom::Pose;
using geom::Rotation;
using geom::Vec2;

/// A model that moves by itself.
struct Mover {
  std::uint32_t model, part;  // rows of world::Models and of its kind's table
  scene::ModelKind kind;
};

/// Trees of models that hold some that can move.
struct Trees {
  std::vector<std::uint32_t> root;                 // model row of the top, ascending             (t)
  std::vector<std::uint32_t> first_model, models;  // rows, parents first: models[first_model[t] ..]
  std::vector<std::uint32_t> first_mover;          // movers[first_mover[t] ..], in the order of models
  std::vector<Mover> movers;
  std::vector<std::uint32_t> first_solid;  // solids first_solid[t] .. first_solid[t + 1] - 1
  std::size_t size() const { return root.size(); }
  std::span<const std::uint32_t> models_of(std::uint32_t tree) const {
    return std::span(models).subspan(first_model[tree], first_model[tree + 1] - first_model[tree]);
  }
  /// Row of the tree with this top.
  std::uint32_t of_root(std::uint32_t top) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(root, top) - root.begin());
  }
};

/// What a solid of a model is, whichever model has it: made once for each row of SceneDesc::models.
struct Shape {
  double z_min_M = 0, z_max_M = 0;  // m
  Vec2 center_M;                    // mean of the vertices                                    [m]
  double radius = 0;                // of the circle about the centre that holds the solid     [m]
  double width = 0;                 // smallest extent                                         [m]
  bool convex = false;
  bool full = false;       // what is inside of it is solid: a block, not a line of a bitmap
  bool hole = false;       // what is inside of it is free: an inner contour of a bitmap
  std::uint32_t body = 0;  // the first of the shapes that are one body with it: those of a bitmap
  std::vector<Vec2> p_M;   // counter-clockwise vertices, the first again at the end  [m]
};

class Shapes {
 public:
  explicit Shapes(const scene::SceneDesc& scene) : scene_(scene) {}
  const std::vector<Shape>& of(std::uint32_t desc);

 private:
  const scene::SceneDesc& scene_;
  std::map<std::uint32_t, std::vector<Shape>> made_;
};

/// A convex body of more corners is looked at like one that is not convex.
inline constexpr std::size_t kConvexCorners = 32;

/// Eight corners of a convex polygon, the first one again in place of those that the last eight lack.
struct alignas(64) EightCorners {
  static constexpr std::size_t kCorners = 8;
  float x[kCorners], y[kCorners];  // m from the centre of the solid, along W's axes

  /// More than how far, in single precision, the distance of a corner from the line of a ray is wrong, if
  /// that is near a solid of this radius: seven roundings of numbers up to the radius, 2^-24 of it each, and
  /// what the corner lost in W.  [m]
  static float error(double radius) { return static_cast<float>(0x1p-20 * radius + 1e-8); }
};

struct Solids {
  // What a solid is.
  std::vector<std::uint32_t> model, root;  // rows of world::Models
  std::vector<std::uint32_t> tree;         // row of Trees, or Row::kNone where it stands still
  std::vector<double> z_min_M, z_max_M;    // m
  std::vector<Vec2> center_M;              // mean of the vertices                                    [m]
  std::vector<double> radius;              // of the circle about the centre that holds the solid     [m]
  std::vector<double> width;               // smallest extent                                         [m]
  std::vector<std::uint8_t> convex;        // 1: a convex polygon
  std::vector<std::uint8_t> full;          // 1: what is inside of it is solid, not only its outline
  std::vector<std::uint8_t> hole;          // 1: what is inside of it is free, in the body of a bitmap
  std::vector<std::uint32_t> body;         // row of the first of the solids that are one body with it
  std::vector<Observers> seen_by;          // bits of those who see it, or are stopped by it
  // Of its height, from below, what is within another solid of its tree (enclosure.h): kAll or less.      [m]
  std::vector<double> enclosed;
  static constexpr double kAll = 1e300;     // far above everything
  std::vector<std::uint32_t> first_vertex;  // (n + 1)
  // Counter-clockwise vertices, the first of each polygon again at its end.                            [m]
  // (vertices)
  std::vector<Vec2> p_M;
  std::size_t fixed = 0;  // rows below this stand still

  std::vector<Rotation> rotation;  // headings of models in W, kept by who moves them (models)

  // Where it is.                              written by: place
  std::vector<Vec2> center;          // in W                                                    [m]
  std::vector<double> z_min, z_max;  // in W                                                    [m]
  std::vector<Vec2> p;  // vertices in W, and kSpare more to read past the end           [m] (vertices)
  static constexpr std::size_t kSpare = 32;
  // Of polygons with convex_corners(), one after the other.
  std::vector<EightCorners> corners;
  std::vector<std::uint32_t> first_corners;  // rows of corners                            (solids that move)

  std::size_t size() const { return model.size(); }
  std::size_t moving() const { return size() - fixed; }
  /// The height from which on rays from outside of its tree meet it.  [m, in W]
  double z_free(std::size_t row) const { return z_min[row] + enclosed[row]; }
  /// How many corners a convex polygon has, 0 if it is not convex or has more than kConvexCorners.
  std::size_t convex_corners(std::size_t row) const {
    const std::size_t count = first_vertex[row + 1] - first_vertex[row] - 1;
    return convex[row] != 0 && count <= kConvexCorners ? count : 0;
  }
  bool is_obstacle(std::size_t row) const { return (seen_by[row] & bit(Observer::kMotion)) != 0; }
  std::span<const Vec2> polygon(std::size_t row) const {
    return {p.data() + first_vertex[row], first_vertex[row + 1] - first_vertex[row] - 1};
  }
};

Trees make_trees(const world::World& world);
/// The solids of everything that stands still, in place.
Solids make_fixed_solids(const world::World& world, Shapes& shapes);
/// Replaces the solids of trees by those of `trees`, in place; sets trees.first_solid.
void replace_moving_solids(Solids& solids, const world::World& world, Shapes& shapes, Trees& trees);

/// Turns the models of a tree, in solids.rotation, to where they head.
void turn(Solids& solids, const world::Models& models, std::span<const std::uint32_t> tree);
/// Puts the solids [begin, end) where their models are; those have been turned.
void place(Solids& solids, const world::Models& models, std::size_t begin, std::size_t end);

/// Where one tree would be: a proposal, or a step on the way to it. Rows count from the tree's first.
struct TreeShape {
  std::span<Pose> moved;         // X_PM of those that move by themselves (movers of the tree)
  std::span<Pose> X_WM;          // (models of the tree)
  std::span<Rotation> rotation;  // of X_WM (models of the tree)
  std::span<Vec2> center, p;     // (solids of the tree), (their vertices)
  std::span<double> z;           // of the models of the solids, in W; empty if no height changes
};

}  // namespace playhouse::stage
